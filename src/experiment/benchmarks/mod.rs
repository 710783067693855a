//! Benchmarks: solvers on other people's problems.
//!
//! - [`Benchmarks`] says what a run is about and lists its [`BenchmarkJob`]s, one for each problem and
//!   solver; [`Benchmark`]s are found below a folder and read by whoever runs them,
//! - [`BenchmarkRun`] does the jobs with a reader of documents; a problem that cannot be read has a
//!   [`BenchmarkRecord`] as any other,
//! - [`BenchmarkSummary`] is what the records come to for each domain and solver, and [`write`](write())
//!   leaves it in a folder.

mod attempt;
mod output;
mod record;
mod summary;
mod validity;

use super::series::{Series, SeriesJob};
use super::{ExperimentError, Shard};
use crate::domain::pddl::import::CandidateOptions;
use crate::problem::MAX_GOALS;
use crate::solver::{Bounds, Solver};

pub use attempt::{BenchmarkRun, time_limit};
pub use output::{records_csv, tables, write};
pub use record::{BenchmarkHeader, BenchmarkRecord, NoOutcome};
pub use summary::{BenchmarkLine, BenchmarkSummary};

/// The name of the experiment on the command line and in records.
pub const BENCHMARKS: &str = "benchmarks";

/// The most problems of a run.
pub const MAX_BENCHMARKS: usize = 100_000;

/// The most memory that can be asked for: a million GiB.
const MAX_MEMORY_MIB: u64 = 1 << 30;

/// A problem below the folder of a run.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Benchmark {
    /// Where it is below the folder, with `/` between the parts.
    pub path: String,
    /// The folder that it belongs to, which tables call its domain.
    pub domain: String,
    /// A digest of what its files hold: a run goes on with the problems that it began with.
    pub digest: String,
}

/// Where the solvers of a run stop.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BenchmarkLimits {
    /// MiB of states, beliefs and nodes of one solver, counted by contents.
    pub memory_mib: u64,
    /// Expansions of one solver.
    pub expansions: Option<u64>,
    /// Seconds of one solver on the clock, looked at between two steps of its work: a record that meets
    /// them says so, and depends on the machine.
    pub seconds: Option<u64>,
}

/// 640 MiB and 20 seconds.
impl Default for BenchmarkLimits {
    fn default() -> Self {
        Self { memory_mib: 640, expansions: None, seconds: Some(20) }
    }
}

/// What a run is about: everything that decides its records.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Benchmarks {
    /// The problems, by their paths.
    pub problems: Vec<Benchmark>,
    /// The solvers, in the order of tables.
    pub solvers: Vec<Solver>,
    /// k; half of the candidate goals of a problem when left out.
    pub k: Option<usize>,
    /// j; the same.
    pub j: Option<usize>,
    /// The enemy's template of symbols in problems that are imported.
    pub adversarial_sensor: String,
    /// The friend's.
    pub cooperative_sensor: String,
    /// The candidate goals of competition tasks.
    pub tasks: CandidateOptions,
    /// Where solvers stop.
    pub limits: BenchmarkLimits,
}

impl Benchmarks {
    /// The solvers of a run unless others are asked for.
    pub const SOLVERS: [Solver; 4] =
        [Solver::Satisficing, Solver::Search, Solver::Exact, Solver::Baseline];

    /// Checks the numbers and lists.
    ///
    /// # Errors
    ///
    /// [`ExperimentError::Choice`] with the option, what it is and what would do.
    pub fn check(&self) -> Result<(), ExperimentError> {
        let choice = |option, found: String, expected: &str| {
            Err(ExperimentError::choice(option, found, expected))
        };
        let problems = self.problems.len();
        if !(1..=MAX_BENCHMARKS).contains(&problems) {
            let expected = format!("1 to {MAX_BENCHMARKS}");
            return choice("problems", problems.to_string(), &expected);
        }
        if !(1..=MAX_MEMORY_MIB).contains(&self.limits.memory_mib) {
            let expected = format!("a number of MiB from 1 to {MAX_MEMORY_MIB}");
            return choice("memory limit", self.limits.memory_mib.to_string(), &expected);
        }
        if self.solvers.is_empty() {
            return choice("solver", "none".to_owned(), "at least one");
        }
        for (index, solver) in self.solvers.iter().enumerate() {
            if self.solvers[..index].contains(solver) {
                let found = format!("{} for the second time", solver.name());
                return choice("solver", found, "each solver once");
            }
        }
        for (index, problem) in self.problems.iter().enumerate() {
            if index > 0 && self.problems[index - 1].path >= problem.path {
                return choice("problems", problem.path.clone(), "each path once, in order");
            }
        }
        if !(2..=MAX_GOALS).contains(&self.tasks.candidates) {
            let expected = format!("a whole number from 2 to {MAX_GOALS}");
            return choice("candidates", self.tasks.candidates.to_string(), &expected);
        }
        for (option, value) in [("k", self.k), ("j", self.j)] {
            if value == Some(0) {
                return choice(option, "0".to_owned(), "a whole number from 1");
            }
        }
        Ok(())
    }

    /// k and j for a problem with N candidate goals: half of them, rounded up, and 2 at least,
    /// unless the run says otherwise.
    pub fn bounds(&self, goals: usize) -> Bounds {
        let half = goals.div_ceil(2).max(2);
        Bounds {
            at_least: Some(self.k.unwrap_or(half)),
            at_most: Some(self.j.unwrap_or(half)),
            ..Bounds::default()
        }
    }

    /// The bounds that a solver is asked to keep: [`Solver::Exact`] and [`Solver::Ip`] are asked for the
    /// best plan of all, as in the experiments of the paper, and the others heed what they know.
    pub fn asked(&self, solver: Solver, goals: usize) -> Bounds {
        match solver {
            Solver::Exact | Solver::Ip => Bounds::default(),
            _ => self.bounds(goals),
        }
    }
}

/// One problem for one solver.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BenchmarkJob {
    /// Its place in the records of a whole run.
    pub place: usize,
    /// The problem.
    pub problem: Benchmark,
    /// The solver.
    pub solver: Solver,
    /// Its place in an order in which the problems of a solver stand together.
    deal: usize,
}

impl SeriesJob for BenchmarkJob {
    fn place(&self) -> usize {
        self.place
    }

    fn deal(&self) -> usize {
        self.deal
    }

    fn name(&self) -> String {
        format!("{} {}", self.problem.path, self.solver.name())
    }
}

impl Series for Benchmarks {
    type Job = BenchmarkJob;
    type Header = BenchmarkHeader;
    type Record = BenchmarkRecord;

    /// Problem by problem, so that the work left can be told from the work done.
    fn jobs(&self) -> Vec<BenchmarkJob> {
        let mut jobs = Vec::new();
        for (number, problem) in self.problems.iter().enumerate() {
            for (column, &solver) in self.solvers.iter().enumerate() {
                let deal = column * self.problems.len() + number;
                jobs.push(BenchmarkJob {
                    place: jobs.len(),
                    problem: problem.clone(),
                    solver,
                    deal,
                });
            }
        }
        jobs
    }

    fn header(&self, shard: Shard) -> BenchmarkHeader {
        BenchmarkHeader::new(self, shard)
    }

    fn of_header(header: &BenchmarkHeader) -> Result<Self, (String, String)> {
        header.benchmarks()
    }

    fn check(&self, record: &BenchmarkRecord, job: &BenchmarkJob) -> Result<(), (String, String)> {
        validity::check(record, self, job).map_err(|expected| (String::new(), expected))
    }
}
