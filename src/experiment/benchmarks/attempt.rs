//! One benchmark for one solver.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use super::{BenchmarkJob, BenchmarkRecord, Benchmarks, NoOutcome};
use crate::domain::Document;
use crate::experiment::ExperimentError;
use crate::experiment::series::{Attempt, Ended, met_memory_limit};
use crate::limits::LimitReached;
use crate::problem::Problem;
use crate::solver::{Horizon, Options, SolveError, Solver, solve};

/// The limit on seconds, in words.
pub fn time_limit(seconds: u64) -> String {
    format!("time limit reached: {seconds} s")
}

/// Benchmarks with what reads their problems: a document of a problem's path, or why there is none.
pub struct BenchmarkRun<'a, R> {
    /// What the run is about.
    pub benchmarks: &'a Benchmarks,
    /// Reads a problem.
    pub read: R,
}

impl<R> std::fmt::Debug for BenchmarkRun<'_, R> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("BenchmarkRun").field("benchmarks", self.benchmarks).finish_non_exhaustive()
    }
}

impl<R: Fn(&str) -> Result<Document, String> + Sync> BenchmarkRun<'_, R> {
    fn problem(&self, path: &str) -> Result<Problem, String> {
        (self.read)(path)?.problem().map_err(|error| error.to_string())
    }
}

impl<R: Fn(&str) -> Result<Document, String> + Sync> Attempt<Benchmarks> for BenchmarkRun<'_, R> {
    fn memory_mib(&self) -> u64 {
        self.benchmarks.limits.memory_mib
    }

    fn attempt(
        &self,
        job: &BenchmarkJob,
        bytes: u64,
        stop: &AtomicBool,
    ) -> Result<Ended<BenchmarkRecord>, ExperimentError> {
        let limits = &self.benchmarks.limits;
        let begin = Instant::now();
        let read = self.problem(&job.problem.path);
        let reading = begin.elapsed().as_secs_f64();
        let refused = |why| {
            let record = BenchmarkRecord::without(job, why, (reading, 0.0));
            Ok(Ended::Answered(Box::new(record)))
        };
        let problem = match read {
            Ok(problem) => Arc::new(problem),
            Err(why) => return refused(NoOutcome::Refused(why)),
        };
        let mut options = Options::new(job.solver);
        options.bounds = self.benchmarks.asked(job.solver, problem.goals().len());
        if job.solver != Solver::Ip {
            options.horizon = Horizon::Any;
        }
        options.limits.bytes = bytes;
        options.limits.expansions = limits.expansions.unwrap_or(u64::MAX);
        let begin = Instant::now();
        let longest = limits.seconds.map(Duration::from_secs);
        let solved = solve(Arc::clone(&problem), options, |_| {
            let late = longest.is_some_and(|longest| begin.elapsed() >= longest);
            if late || stop.load(Ordering::SeqCst) {
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(())
        });
        let seconds = begin.elapsed().as_secs_f64();
        if stop.load(Ordering::SeqCst) {
            return Ok(Ended::Stopped);
        }
        let outcome = match solved {
            Ok(outcome) => outcome,
            Err(SolveError::Options(error)) => {
                return refused(NoOutcome::Refused(error.to_string()));
            }
            Err(error) => return refused(NoOutcome::Failed(error.to_string())),
        };
        if met_memory_limit(&outcome) && bytes < limits.memory_mib << 20 {
            return Ok(Ended::MoreMemory);
        }
        let (run, times) = (self.benchmarks, (reading, seconds));
        let mut record = BenchmarkRecord::answered(run, job, &problem, &outcome, times);
        if let (Some(LimitReached::Cancelled), Some(limit)) = (outcome.limit, limits.seconds) {
            record.limit = Some(time_limit(limit));
        }
        Ok(Ended::Answered(Box::new(record)))
    }
}
