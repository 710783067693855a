//! Records: what a run writes down, one JSON object a line.

use serde::{Deserialize, Serialize};

use super::series::{SeriesHeader, SeriesRecord};
use super::{ExperimentError, Figure, InitialBeliefs, Job, Setting, SettingLimits, Shard};
use crate::goal_difference::GoalSet;
use crate::problem::{Problem, Role};
use crate::solver::{Horizon, Options, Outcome, Solver, Stats};

/// The first line of a file of records: what run it belongs to.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Header {
    /// `fig3` or `fig4`.
    pub experiment: String,
    /// The version of this program.
    pub version: String,
    /// The seed of the first problem of each domain.
    pub seed: u64,
    /// How many problems of each domain.
    pub problems: u32,
    /// The domains.
    pub domains: Vec<String>,
    /// What observers believe at first, in Figure 4.
    pub initial_beliefs: InitialBeliefs,
    /// Where solvers stop.
    pub limits: SettingLimits,
    /// The part of the run.
    pub shard: Shard,
}

impl Header {
    /// The header of a part of a run.
    pub fn new(setting: &Setting, shard: Shard) -> Self {
        Self {
            experiment: setting.figure.name().to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            seed: setting.seed,
            problems: setting.problems,
            domains: setting.domains.iter().map(|d| d.domain.name().to_owned()).collect(),
            initial_beliefs: setting.beliefs,
            limits: setting.limits.clone(),
            shard,
        }
    }

    /// The run it belongs to.
    ///
    /// # Errors
    ///
    /// What was found and what was expected, where this program knows no such run.
    pub fn setting(&self) -> Result<Setting, (String, String)> {
        let figure = Figure::named(&self.experiment).ok_or_else(|| {
            let names = Figure::ALL.map(Figure::name).join(" or ");
            (format!("experiment {}", self.experiment), names)
        })?;
        let domains = self.domains.iter().map(|name| {
            figure.domain_named(name).ok_or_else(|| {
                let names = figure.domains().iter().map(|d| d.domain.name());
                (format!("domain {name}"), names.collect::<Vec<_>>().join(", "))
            })
        });
        let setting = Setting {
            figure,
            seed: self.seed,
            problems: self.problems,
            domains: domains.collect::<Result<_, _>>()?,
            beliefs: self.initial_beliefs,
            limits: self.limits.clone(),
        };
        setting.check().map_err(|error| {
            let ExperimentError::Choice { option, found, expected } = error else {
                return (error.to_string(), "a run of this program".to_owned());
            };
            (format!("{option} {found}"), expected)
        })?;
        let ours = Self::new(&setting, self.shard);
        match self.first_difference(&ours) {
            Some((field, found, expected)) => {
                Err((format!("{field} {found}"), format!("{field} {expected}")))
            }
            None => Ok(setting),
        }
    }

    /// The first field in which it differs from another: its name, what is here, what is there.
    fn first_difference(&self, other: &Self) -> Option<(&'static str, String, String)> {
        let (a, b) = (&self.limits, &other.limits);
        let limit = |limit: Option<u64>| limit.map_or("none".to_owned(), |n| n.to_string());
        let fields = [
            ("experiment", self.experiment.clone(), other.experiment.clone()),
            ("version", self.version.clone(), other.version.clone()),
            ("seed", self.seed.to_string(), other.seed.to_string()),
            ("problems", self.problems.to_string(), other.problems.to_string()),
            ("domains", self.domains.join(", "), other.domains.join(", ")),
            (
                "initial beliefs",
                self.initial_beliefs.name().to_owned(),
                other.initial_beliefs.name().to_owned(),
            ),
            ("memory limit", a.memory_mib.to_string(), b.memory_mib.to_string()),
            ("exact expansions", a.exact_expansions.to_string(), b.exact_expansions.to_string()),
            ("search expansions", a.search_expansions.to_string(), b.search_expansions.to_string()),
            ("paper nodes", limit(a.paper_nodes), limit(b.paper_nodes)),
            ("paper nonzeros", a.paper_nonzeros.to_string(), b.paper_nonzeros.to_string()),
            ("time limit", limit(a.seconds), limit(b.seconds)),
            ("shard", self.shard.to_string(), other.shard.to_string()),
        ];
        fields.into_iter().find(|(_, here, there)| here != there)
    }
}

/// What one solver answered on one problem. All but `seconds` is the same in every run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Record {
    /// The domain.
    pub domain: String,
    /// The number of the problem, from 1.
    pub problem: u32,
    /// The seed of its document: `mo-copp generate DOMAIN --seed` prints it.
    pub seed: u64,
    /// How many documents were drawn and thrown away before it.
    pub redraws: u32,
    /// How many candidate goals it has.
    pub candidates: usize,
    /// The solver.
    pub solver: String,
    /// What was asked of it.
    pub options: Asked,
    /// `optimal`, `solved`, `feasible`, `infeasible` or `limit`.
    pub status: String,
    /// The limit that was met, in words.
    pub limit: Option<String>,
    /// The horizon worked at last, where the solver takes one.
    pub horizon: Option<usize>,
    /// The number of actions of the plan.
    pub length: Option<usize>,
    /// Its goal difference.
    pub goal_difference: Option<f64>,
    /// No plan that keeps what was asked has a greater goal difference; where the solver proved such a
    /// bound.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub bound: Option<f64>,
    /// The goals that survive at its end.
    pub goals: Option<Survivors>,
    /// Its actions.
    pub plan: Option<Vec<String>>,
    /// What the work took; the same in every run.
    pub work: Work,
    /// What it took on the clock.
    pub seconds: f64,
}

/// What was asked of a solver.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Asked {
    /// The integer program.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub encoding: Option<String>,
    /// The first horizon; none for plans of any length.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub horizon: Option<usize>,
    /// At least N goals are left to the enemy.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub k: Option<usize>,
    /// At most N goals are left to the friend.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub j: Option<usize>,
    /// The limit on expansions.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub expansions: Option<u64>,
    /// The limit on nodes of branch and bound.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub nodes: Option<u64>,
}

impl Asked {
    /// What a run of this setting asks in a job.
    pub(super) fn of(setting: &Setting, job: &Job) -> Self {
        let options = job.configuration.options(setting.figure, &setting.limits);
        Self::new(&options, job.first_horizon())
    }

    fn new(options: &Options, first: Option<usize>) -> Self {
        let limit = |n: u64| (n != u64::MAX).then_some(n);
        Self {
            encoding: (options.solver == Solver::Ip).then(|| options.encoding.name().to_owned()),
            horizon: match options.horizon {
                Horizon::Any => None,
                Horizon::Auto | Horizon::Steps(_) => first,
            },
            k: options.bounds.at_least,
            j: options.bounds.at_most,
            expansions: limit(options.limits.expansions),
            nodes: limit(options.limits.nodes),
        }
    }
}

/// The goals that survive for each observer at the end of a plan.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Survivors {
    /// For the enemy.
    pub adversarial: Vec<String>,
    /// For the friend.
    pub cooperative: Vec<String>,
}

impl Survivors {
    pub(super) fn new(problem: &Problem, sets: &[GoalSet]) -> Self {
        let of = |role: Role| {
            let observers = problem.observers().iter().zip(sets);
            let set = observers.filter(|(o, _)| o.role == role).map(|(_, set)| set).next();
            let names = set.into_iter().flat_map(GoalSet::iter);
            names.map(|goal| problem.goals()[goal].name.clone()).collect()
        };
        Self { adversarial: of(Role::Adversarial), cooperative: of(Role::Cooperative) }
    }
}

/// Counts of work; those that are 0 are left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Work {
    /// Nodes expanded by a search.
    #[serde(skip_serializing_if = "is_zero")]
    pub expansions: u64,
    /// Nodes generated by a search.
    #[serde(skip_serializing_if = "is_zero")]
    pub generated: u64,
    /// States met.
    #[serde(skip_serializing_if = "is_zero")]
    pub states: u64,
    /// Beliefs met.
    #[serde(skip_serializing_if = "is_zero")]
    pub beliefs: u64,
    /// The size of approximate beliefs (Δ) at the end of a search.
    #[serde(skip_serializing_if = "is_zero")]
    pub belief_size: u64,
    /// Branch-and-bound nodes.
    #[serde(skip_serializing_if = "is_zero")]
    pub nodes: u64,
    /// Simplex iterations.
    #[serde(skip_serializing_if = "is_zero")]
    pub iterations: u64,
    /// Variables of the integer program.
    #[serde(skip_serializing_if = "is_zero")]
    pub variables: u64,
    /// Rows of the integer program.
    #[serde(skip_serializing_if = "is_zero")]
    pub rows: u64,
}

// The signature serde asks for.
#[allow(clippy::trivially_copy_pass_by_ref)]
fn is_zero(number: &u64) -> bool {
    *number == 0
}

impl Work {
    pub(super) fn new(stats: &Stats) -> Self {
        Self {
            expansions: stats.expansions,
            generated: stats.generated,
            states: stats.states,
            beliefs: stats.beliefs,
            belief_size: stats.belief_size,
            nodes: stats.nodes,
            iterations: stats.iterations,
            variables: stats.variables,
            rows: stats.rows,
        }
    }
}

/// Seconds as they are written down: to the microsecond.
pub(super) fn rounded(seconds: f64) -> f64 {
    const PER_SECOND: f64 = 1e6;
    (seconds * PER_SECOND).round() / PER_SECOND
}

impl Record {
    /// The record of an answer.
    pub(super) fn new(
        job: &Job,
        seed: u64,
        redraws: u32,
        problem: &Problem,
        asked: Asked,
        outcome: &Outcome,
        seconds: f64,
    ) -> Self {
        Self {
            domain: job.domain.domain.name().to_owned(),
            problem: job.problem,
            seed,
            redraws,
            candidates: problem.goals().len(),
            solver: job.configuration.name().to_owned(),
            options: asked,
            status: outcome.status.name().to_owned(),
            limit: outcome.limit.map(|limit| limit.to_string()),
            horizon: outcome.horizon,
            length: outcome.plan.as_ref().map(crate::plan::Plan::len),
            goal_difference: outcome.goal_difference,
            bound: outcome.bound,
            goals: outcome.survivors.as_ref().map(|sets| Survivors::new(problem, sets)),
            plan: outcome.plan.as_ref().map(|plan| plan.names(problem.task())),
            work: Work::new(&outcome.stats),
            seconds: rounded(seconds),
        }
    }
}

impl SeriesRecord for Record {
    fn job_name(&self) -> String {
        format!("{} {} {}", self.domain, self.problem, self.solver)
    }
}

impl SeriesHeader for Header {
    fn shard(&self) -> Shard {
        self.shard
    }

    fn with_shard(&self, shard: Shard) -> Self {
        Self { shard, ..self.clone() }
    }

    fn difference(&self, other: &Self) -> Option<(&'static str, String, String)> {
        self.first_difference(other)
    }
}
