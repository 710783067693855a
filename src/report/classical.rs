//! What the baseline answers on a task without observers: `plan --json`.

use serde::Serialize;

use crate::solver::{ClassicalOutcome, Status};
use crate::task::Task;

/// What `plan --json` prints.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PlanReport {
    /// `solved`, `infeasible` or `limit`.
    pub status: &'static str,
    /// The operators, each as `(name arguments)`.
    pub plan: Option<Vec<String>>,
    /// What the plan costs, where the task has costs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cost: Option<u64>,
    /// The limit that was met.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit: Option<String>,
    /// What the work took.
    pub stats: PlanStats,
}

/// What the work took.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
#[non_exhaustive]
pub struct PlanStats {
    /// Facts of the ground task.
    pub facts: usize,
    /// Operators of the ground task.
    pub operators: usize,
    /// Nodes expanded.
    pub expansions: u64,
    /// Nodes generated.
    pub generated: u64,
    /// States met.
    pub states: u64,
    /// Wall-clock seconds of reading and grounding.
    pub grounding_seconds: f64,
    /// Wall-clock seconds of the search.
    pub search_seconds: f64,
}

impl PlanReport {
    /// The report on work that a limit ended before there was an outcome.
    pub fn stopped(limit: String, stats: PlanStats) -> Self {
        Self { status: Status::Limit.name(), plan: None, cost: None, limit: Some(limit), stats }
    }

    /// The report on an outcome. The stats hold what the outcome does not know.
    pub fn new(task: &Task, outcome: &ClassicalOutcome, stats: PlanStats) -> Self {
        let plan = outcome.plan.as_ref();
        Self {
            status: outcome.status.name(),
            plan: plan.map(|plan| plan.names(task)),
            cost: plan.and_then(|plan| plan.cost(task)),
            limit: outcome.limit.map(|limit| limit.to_string()),
            stats: PlanStats {
                expansions: outcome.stats.expansions,
                generated: outcome.stats.generated,
                states: outcome.stats.states,
                ..stats
            },
        }
    }
}
