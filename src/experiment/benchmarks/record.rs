//! Records of benchmarks: what a run writes down, one JSON object a line.

use serde::{Deserialize, Serialize};

use super::{BENCHMARKS, Benchmark, BenchmarkJob, BenchmarkLimits, Benchmarks};
use crate::domain::pddl::import::CandidateOptions;
use crate::experiment::record::{Survivors, Work, rounded};
use crate::experiment::series::{Series, SeriesHeader, SeriesRecord};
use crate::experiment::{ExperimentError, Shard};
use crate::plan::Plan;
use crate::problem::Problem;
use crate::solver::{Outcome, Solver};

/// The first line of a file of records: what run it belongs to.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BenchmarkHeader {
    /// `benchmarks`.
    pub experiment: String,
    /// The version of this program.
    pub version: String,
    /// The solvers.
    pub solvers: Vec<String>,
    /// k; null for half of the goals.
    pub k: Option<usize>,
    /// j; the same.
    pub j: Option<usize>,
    /// The enemy's template of symbols.
    pub adversarial_sensor: String,
    /// The friend's.
    pub cooperative_sensor: String,
    /// How many candidate goals competition tasks have.
    #[serde(default = "candidates")]
    pub candidates: usize,
    /// The seed of those that are not the goal of the task.
    #[serde(default = "seed")]
    pub seed: u64,
    /// Where solvers stop.
    pub limits: BenchmarkLimits,
    /// The part of the run.
    pub shard: Shard,
    /// The problems, by their paths.
    pub problems: Vec<Benchmark>,
}

/// What older records do not say: there were no tasks.
fn candidates() -> usize {
    CandidateOptions::default().candidates
}

fn seed() -> u64 {
    CandidateOptions::default().seed
}

impl BenchmarkHeader {
    /// The header of a part of a run.
    pub fn new(run: &Benchmarks, shard: Shard) -> Self {
        Self {
            experiment: BENCHMARKS.to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            solvers: run.solvers.iter().map(|solver| solver.name().to_owned()).collect(),
            k: run.k,
            j: run.j,
            adversarial_sensor: run.adversarial_sensor.clone(),
            cooperative_sensor: run.cooperative_sensor.clone(),
            candidates: run.tasks.candidates,
            seed: run.tasks.seed,
            limits: run.limits.clone(),
            shard,
            problems: run.problems.clone(),
        }
    }

    /// The run it belongs to; what was found and what was expected, where there is no such run.
    pub(super) fn benchmarks(&self) -> Result<Benchmarks, (String, String)> {
        let solver = |name: &String| {
            Solver::named(name)
                .ok_or_else(|| (format!("solver {name}"), Solver::ALL.map(Solver::name).join(", ")))
        };
        let run = Benchmarks {
            problems: self.problems.clone(),
            solvers: self.solvers.iter().map(solver).collect::<Result<_, _>>()?,
            k: self.k,
            j: self.j,
            adversarial_sensor: self.adversarial_sensor.clone(),
            cooperative_sensor: self.cooperative_sensor.clone(),
            tasks: CandidateOptions { candidates: self.candidates, seed: self.seed },
            limits: self.limits.clone(),
        };
        run.check().map_err(|error| {
            let ExperimentError::Choice { option, found, expected } = error else {
                return (error.to_string(), "a run of this program".to_owned());
            };
            (format!("{option} {found}"), expected)
        })?;
        match self.difference(&run.header(self.shard)) {
            Some((field, found, expected)) => {
                Err((format!("{field} {found}"), format!("{field} {expected}")))
            }
            None => Ok(run),
        }
    }
}

impl SeriesHeader for BenchmarkHeader {
    fn shard(&self) -> Shard {
        self.shard
    }

    fn with_shard(&self, shard: Shard) -> Self {
        Self { shard, ..self.clone() }
    }

    fn difference(&self, other: &Self) -> Option<(&'static str, String, String)> {
        let (a, b) = (&self.limits, &other.limits);
        let number = |number: Option<u64>| number.map_or("none".to_owned(), |n| n.to_string());
        let bound = |bound: Option<usize>| bound.map_or("half".to_owned(), |n| n.to_string());
        let fields = [
            ("experiment", self.experiment.clone(), other.experiment.clone()),
            ("version", self.version.clone(), other.version.clone()),
            ("solvers", self.solvers.join(", "), other.solvers.join(", ")),
            ("k", bound(self.k), bound(other.k)),
            ("j", bound(self.j), bound(other.j)),
            (
                "adversarial sensor",
                self.adversarial_sensor.clone(),
                other.adversarial_sensor.clone(),
            ),
            (
                "cooperative sensor",
                self.cooperative_sensor.clone(),
                other.cooperative_sensor.clone(),
            ),
            ("candidates", self.candidates.to_string(), other.candidates.to_string()),
            ("seed", self.seed.to_string(), other.seed.to_string()),
            ("memory limit", a.memory_mib.to_string(), b.memory_mib.to_string()),
            ("expansions", number(a.expansions), number(b.expansions)),
            ("time limit", number(a.seconds), number(b.seconds)),
            ("shard", self.shard.to_string(), other.shard.to_string()),
        ];
        fields.into_iter().find(|(_, here, there)| here != there).or_else(|| {
            let shown = |benchmark: Option<&Benchmark>| {
                benchmark.map_or("none".to_owned(), |Benchmark { path, domain, digest }| {
                    format!("{path} of {domain} (digest {digest})")
                })
            };
            let most = self.problems.len().max(other.problems.len());
            let pairs = (0..most).map(|n| (self.problems.get(n), other.problems.get(n)));
            let (here, there) = pairs.into_iter().find(|(here, there)| here != there)?;
            Some(("problem", shown(here), shown(there)))
        })
    }
}

/// Why a solver has no outcome.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NoOutcome {
    /// The problem cannot be read, or the options do not fit it.
    Refused(String),
    /// The solver broke down.
    Failed(String),
    /// It was ended from outside, by this limit.
    Ended(String),
}

/// What one solver answered on one problem. All but the seconds is the same in every run, unless the
/// clock stopped it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BenchmarkRecord {
    /// Where the problem is below the folder of the run.
    pub problem: String,
    /// The folder that it belongs to.
    pub domain: String,
    /// The solver.
    pub solver: String,
    /// How many candidate goals the problem has; null where it cannot be read, or its solver was ended
    /// from outside.
    pub candidates: Option<usize>,
    /// k, as tables count plans that keep it.
    pub k: Option<usize>,
    /// j, the same.
    pub j: Option<usize>,
    /// `optimal`, `solved`, `feasible`, `infeasible`, `limit`, `refused` or `failed`.
    pub status: String,
    /// The limit that was met, in words.
    pub limit: Option<String>,
    /// Why the problem was refused, or how the solver failed.
    pub refusal: Option<String>,
    /// The number of actions of the plan.
    pub length: Option<usize>,
    /// What it costs, where the problem has costs.
    pub cost: Option<u64>,
    /// Its goal difference.
    pub goal_difference: Option<f64>,
    /// Whether it leaves the enemy k goals at least and the friend j at most.
    pub within_bounds: Option<bool>,
    /// No plan that keeps what was asked of the solver has a greater goal difference; where the solver
    /// proved such a bound.
    pub bound: Option<f64>,
    /// The bound less the goal difference.
    pub gap: Option<f64>,
    /// The goals that survive at its end.
    pub goals: Option<Survivors>,
    /// Its actions.
    pub plan: Option<Vec<String>>,
    /// What the work took.
    pub work: Work,
    /// What reading and grounding took on the clock.
    pub reading_seconds: f64,
    /// What solving took on the clock.
    pub seconds: f64,
}

impl SeriesRecord for BenchmarkRecord {
    fn job_name(&self) -> String {
        format!("{} {}", self.problem, self.solver)
    }
}

impl BenchmarkRecord {
    /// The record of a job without an outcome, with the seconds of reading and of solving.
    pub fn without(job: &BenchmarkJob, why: NoOutcome, (reading, solving): (f64, f64)) -> Self {
        let (status, refusal, limit) = match why {
            NoOutcome::Refused(why) => ("refused", Some(why), None),
            NoOutcome::Failed(why) => ("failed", Some(why), None),
            NoOutcome::Ended(limit) => ("limit", None, Some(limit)),
        };
        Self {
            problem: job.problem.path.clone(),
            domain: job.problem.domain.clone(),
            solver: job.solver.name().to_owned(),
            candidates: None,
            k: None,
            j: None,
            status: status.to_owned(),
            limit,
            refusal,
            length: None,
            cost: None,
            goal_difference: None,
            within_bounds: None,
            bound: None,
            gap: None,
            goals: None,
            plan: None,
            work: Work::default(),
            reading_seconds: rounded(reading),
            seconds: rounded(solving),
        }
    }

    /// The record of an answer.
    pub(super) fn answered(
        run: &Benchmarks,
        job: &BenchmarkJob,
        problem: &Problem,
        outcome: &Outcome,
        times: (f64, f64),
    ) -> Self {
        let bounds = run.bounds(problem.goals().len());
        let allowed = |sets: &Vec<_>| bounds.allow(problem.survivor_counts(sets), sets);
        Self {
            candidates: Some(problem.goals().len()),
            k: bounds.at_least,
            j: bounds.at_most,
            status: outcome.status.name().to_owned(),
            limit: outcome.limit.map(|limit| limit.to_string()),
            refusal: None,
            length: outcome.plan.as_ref().map(Plan::len),
            cost: outcome.plan.as_ref().and_then(|plan| plan.cost(problem.task())),
            goal_difference: outcome.goal_difference,
            within_bounds: outcome.survivors.as_ref().map(allowed),
            bound: outcome.bound,
            gap: outcome.gap(),
            goals: outcome.survivors.as_ref().map(|sets| Survivors::new(problem, sets)),
            plan: outcome.plan.as_ref().map(|plan| plan.names(problem.task())),
            work: Work::new(&outcome.stats),
            ..Self::without(job, NoOutcome::Failed(String::new()), times)
        }
    }

    /// Whether there is an answer: a plan, or the proof that there is none.
    pub fn is_answered(&self) -> bool {
        self.plan.is_some() || self.status == "infeasible"
    }
}
