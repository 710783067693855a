//! What every solver looks like from inside: work that can be done in slices.

use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::trace::Witness;

use super::outcome::{LengthPoint, Progress, ReachablePair, Stats, Status};

/// Where the work stands after a slice.
#[derive(Debug)]
pub(super) enum Advance {
    /// There is more to do.
    Working,
    /// This is the answer.
    Finished(Finding),
}

/// An answer before it is replayed.
#[derive(Debug)]
pub(super) struct Finding {
    pub status: Status,
    pub plan: Option<Plan>,
    /// Walks that show what survives, where beliefs are too large.
    pub witnesses: Vec<Witness>,
    pub pairs: Option<Vec<ReachablePair>>,
    pub lengths: Option<Vec<LengthPoint>>,
    pub limit: Option<LimitReached>,
    /// A proved upper bound on the goal difference, of a run that was stopped.
    pub bound: Option<f64>,
    /// Whether the plan is proved to be a shortest one of its goal difference, where that was looked
    /// at.
    pub length_proved: Option<bool>,
}

impl Finding {
    pub(super) fn infeasible() -> Self {
        Self {
            status: Status::Infeasible,
            plan: None,
            witnesses: Vec::new(),
            pairs: None,
            lengths: None,
            limit: None,
            bound: None,
            length_proved: None,
        }
    }

    pub(super) fn plan(status: Status, plan: Plan) -> Self {
        Self { status, plan: Some(plan), ..Self::infeasible() }
    }

    /// Stopped with the best of all plans, but not with all that was asked for.
    pub(super) fn stopped_at_best(plan: Plan, limit: LimitReached) -> Self {
        Self { limit: Some(limit), ..Self::plan(Status::Optimal, plan) }
    }

    /// Stopped before the proof, with or without a plan.
    pub(super) fn stopped(plan: Option<Plan>, limit: LimitReached) -> Self {
        let status = if plan.is_some() { Status::Feasible } else { Status::Limit };
        Self { status, plan, limit: Some(limit), ..Self::infeasible() }
    }
}

/// A solver at work on one horizon.
pub(super) trait Engine: Send {
    /// Works for about `budget` expansions or nodes. A limit ends the work without an answer.
    fn advance(&mut self, budget: u64) -> Result<Advance, LimitReached>;

    /// What can be said when the work stops here.
    fn stop(&mut self, limit: LimitReached) -> Finding;

    /// Fills in what is known.
    fn report(&self, progress: &mut Progress);

    /// What the work took so far.
    fn stats(&self) -> Stats;
}
