//! One problem for one solver.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use super::configuration::{HORIZON_STEP, Lengths};
use super::record::{Asked, Record};
use super::series::{Attempt, Ended, met_memory_limit};
use super::{ExperimentError, Job, Setting};
use crate::limits::LimitReached;
use crate::problem::Problem;
use crate::solver::{Horizon, Options, Outcome, SolveError, Status, shortest_plan_length, solve};

impl Attempt<Self> for Setting {
    fn memory_mib(&self) -> u64 {
        self.limits.memory_mib
    }

    fn attempt(
        &self,
        job: &Job,
        bytes: u64,
        stop: &AtomicBool,
    ) -> Result<Ended<Record>, ExperimentError> {
        attempt(self, job, bytes, stop)
    }
}

/// Draws the problem of a job and has it solved, with so many bytes of states, beliefs and nodes.
///
/// # Errors
///
/// The problem cannot be drawn, or the solver breaks down.
fn attempt(
    setting: &Setting,
    job: &Job,
    bytes: u64,
    stop: &AtomicBool,
) -> Result<Ended<Record>, ExperimentError> {
    let domain = job.domain.domain;
    let seed = setting.seed_of(job.problem);
    let drawn = domain
        .draw_with_beliefs(seed, setting.beliefs.most())
        .map_err(|error| ExperimentError::Draw { domain: domain.name(), seed, error })?;
    let problem = drawn.document.problem().map_err(|error| ExperimentError::Document {
        domain: domain.name(),
        seed,
        error,
    })?;
    let problem = Arc::new(problem);
    let mut options = job.configuration.options(setting.figure, &setting.limits);
    options.limits.bytes = options.limits.bytes.min(bytes);
    let asked = Asked::of(setting, job);
    let mut work = Work {
        problem: &problem,
        options,
        stop,
        limit: setting.limits.seconds,
        begin: Instant::now(),
    };
    let solved = match (job.configuration.lengths(), job.first_horizon()) {
        (Lengths::UpTo, Some(most)) => work.up_to(most),
        (_, Some(steps)) => work.at(Horizon::Steps(steps)),
        (_, None) => work.at(Horizon::Any),
    };
    let seconds = work.begin.elapsed().as_secs_f64();
    let outcome = solved.map_err(|error| ExperimentError::Solve {
        domain: domain.name(),
        seed,
        solver: job.configuration.name(),
        error,
    })?;
    if stop.load(Ordering::SeqCst) {
        return Ok(Ended::Stopped);
    }
    if met_memory_limit(&outcome) && bytes < setting.limits.memory_mib << 20 {
        return Ok(Ended::MoreMemory);
    }
    let mut record = Record::new(job, seed, drawn.redraws, &problem, asked, &outcome, seconds);
    if let (Some(LimitReached::Cancelled), Some(limit)) = (outcome.limit, setting.limits.seconds) {
        record.limit = Some(format!("time limit reached: {limit} s"));
    }
    Ok(Ended::Answered(Box::new(record)))
}

/// A solver at work for an attempt.
struct Work<'a> {
    problem: &'a Arc<Problem>,
    options: Options,
    stop: &'a AtomicBool,
    /// Seconds.
    limit: Option<u64>,
    begin: Instant,
}

impl Work<'_> {
    fn at(&mut self, horizon: Horizon) -> Result<Outcome, SolveError> {
        let options = Options { horizon, ..self.options.clone() };
        let (begin, stop) = (self.begin, self.stop);
        let limit = self.limit.map(Duration::from_secs);
        solve(Arc::clone(self.problem), options, |_| {
            let late = limit.is_some_and(|limit| begin.elapsed() >= limit);
            if late || stop.load(Ordering::SeqCst) {
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(())
        })
    }

    /// The best plan of up to `most` actions, a shortest one of them; where there is none, of up to
    /// [`HORIZON_STEP`] more, and so on.
    fn up_to(&mut self, mut most: usize) -> Result<Outcome, SolveError> {
        let expansions = self.options.limits.expansions;
        let shortest = shortest_plan_length(self.problem, &self.options);
        let Ok(Some(mut steps)) = shortest else {
            // The solver finds out the same for itself, and says so.
            return self.at(Horizon::Any);
        };
        while most < steps {
            most += HORIZON_STEP;
        }
        let mut best = self.at(Horizon::Steps(steps))?;
        while best.limit.is_none() && steps < most && best.goal_difference != Some(1.0) {
            steps += 1;
            self.options.limits.expansions = expansions.saturating_sub(best.stats.expansions);
            let mut next = self.at(Horizon::Steps(steps))?;
            next.stats.add_work(&best.stats);
            let (stats, limit) = (next.stats, next.limit);
            if next.goal_difference > best.goal_difference {
                best = next;
            }
            (best.stats, best.limit) = (stats, limit);
        }
        if let Some(LimitReached::Expansions { limit }) = &mut best.limit {
            *limit = expansions;
        }
        if best.limit.is_some() {
            best.status = if best.plan.is_some() { Status::Feasible } else { Status::Limit };
        }
        Ok(best)
    }
}
