//! What the baseline answers on a task without observers: `plan --json`.

use serde::Serialize;

use crate::solver::ClassicalOutcome;

/// What `plan --json` prints.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlanReport {
    /// `solved`, `infeasible` or `limit`.
    pub status: &'static str,
    /// The operators, each as `(name arguments)`.
    pub plan: Option<Vec<String>>,
    /// The limit that was met.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit: Option<String>,
    /// What the work took.
    pub stats: PlanStats,
}

/// What the work took.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
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
    /// The report on an outcome. The stats hold what the outcome does not know; `names` are those
    /// of the plan.
    pub fn new(outcome: &ClassicalOutcome, names: Option<Vec<String>>, stats: PlanStats) -> Self {
        Self {
            status: outcome.status.name(),
            plan: names,
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
