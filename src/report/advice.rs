//! Why there is no plan, as other programs read it.

use serde::Serialize;

use crate::problem::Problem;
use crate::solver::remedy::{Advice, Change, Reason, Remedy};

/// Why there is no plan, and which change of one option would allow one.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct AdviceReport {
    /// `unreachable`, `length` or `bounds`; null where there is a plan, or it is not known.
    pub reason: Option<&'static str>,
    /// The length of a shortest plan for the true goal, where there is one and it is known.
    pub shortest: Option<usize>,
    /// The remedies, the smallest change first.
    pub remedies: Vec<RemedyReport>,
    /// Whether these are all, and nothing nearer would do.
    pub complete: bool,
}

/// A change that allows a plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct RemedyReport {
    /// `horizon`, `k` or `j`.
    pub change: &'static str,
    /// The new value.
    pub value: usize,
    /// The goal difference of the plan.
    pub goal_difference: f64,
    /// The names of the actions.
    pub plan: Vec<String>,
}

impl AdviceReport {
    /// The report of an advice.
    pub fn new(problem: &Problem, advice: &Advice) -> Self {
        let remedy = |remedy: &Remedy| RemedyReport {
            change: Change::name(remedy.change),
            value: remedy.value,
            goal_difference: remedy.goal_difference,
            plan: remedy.plan.names(problem.task()),
        };
        Self {
            reason: advice.reason.map(Reason::name),
            shortest: advice.shortest,
            remedies: advice.remedies.iter().map(remedy).collect(),
            complete: advice.complete,
        }
    }
}
