//! From what an engine has found to the answer: every plan is replayed, and what it achieves is worked out anew.

use std::sync::Arc;

use crate::limits::LimitReached;
use crate::plan::{Plan, PlanError};
use crate::problem::Problem;
use crate::trace::{
    Achievement, InvalidPlan, check_cost, validate_quickly, validate_with, validate_within,
};

use super::engine::Finding;
use super::error::SolveError;
use super::outcome::{LengthPoint, Outcome, ReachablePair, Stats, Status};
#[cfg(feature = "full")]
use super::parallel_walks;
use super::{Options, Solver};

/// Replays what was found and puts the answer together.
pub(super) fn conclude(
    problem: &Arc<Problem>,
    options: &Options,
    horizon: Option<usize>,
    finding: &Finding,
    stats: Stats,
) -> Result<Outcome, SolveError> {
    let bounds = options.heeded_bounds();
    let mut outcome = Outcome {
        status: finding.status,
        solver: options.solver,
        encoding: (options.solver == Solver::Ip).then_some(options.encoding),
        horizon,
        plan: None,
        survivors: None,
        unsettled: None,
        goal_difference: None,
        bound: finding.bound,
        length_proved: finding.length_proved,
        // Of a run that was stopped, what is known.
        pairs: options.pairs.then(Vec::new),
        lengths: None,
        cost_limit: options.cost_limit,
        limit: finding.limit,
        stats,
    };
    let replay = |plan| {
        let achieved = achieved(problem, options, finding, plan);
        let achieved: Achievement = achieved.map_err(|error| match error {
            InvalidPlan::Step(PlanError::TooLarge { .. }) => SolveError::TooLargeToReplay,
            error => SolveError::Replay(error.to_string()),
        })?;
        if !bounds.allow(achieved.counts, &achieved.survivors) {
            return Err(SolveError::Replay("it breaks the bounds".to_owned()));
        }
        if horizon.is_some_and(|horizon| horizon != plan.len()) {
            return Err(SolveError::Replay("it has another length than asked for".to_owned()));
        }
        check_cost(problem, plan, options.cost_limit)
            .map_err(|error| SolveError::Replay(error.to_string()))?;
        Ok(achieved)
    };
    if let Some(plan) = &finding.plan {
        let achieved = match replay(plan) {
            // What it achieves is not known then.
            Err(SolveError::TooLargeToReplay) => {
                outcome.status = Status::Limit;
                outcome.length_proved = None;
                let limit_mib = options.limits.bytes >> 20;
                outcome.limit = Some(LimitReached::Memory { limit_mib });
                return Ok(outcome);
            }
            achieved => achieved?,
        };
        if options.pairs && finding.pairs.is_none() {
            let point = ReachablePair { counts: achieved.counts, plan: plan.clone() };
            outcome.pairs = Some(vec![point]);
        }
        outcome.horizon = Some(plan.len());
        outcome.goal_difference = Some(problem.goal_difference(achieved.counts));
        if finding.status == Status::Optimal {
            outcome.bound = outcome.goal_difference;
        }
        if !achieved.is_settled() {
            outcome.unsettled = Some(achieved.unsettled);
        }
        outcome.survivors = Some(achieved.survivors);
        outcome.plan = Some(plan.clone());
    }
    if let Some(points) = &finding.pairs {
        for point in points {
            if replay(&point.plan)?.counts != point.counts {
                return Err(SolveError::Replay("a pair of counts is wrong".to_owned()));
            }
        }
        outcome.pairs = Some(points.clone());
    }
    if let Some(points) = &finding.lengths {
        for LengthPoint { length, best } in points {
            if let Some(best) = best
                && (replay(&best.plan)?.counts != best.counts || best.plan.len() != *length)
            {
                return Err(SolveError::Replay(format!("the best of length {length} is wrong")));
            }
        }
        outcome.lengths = Some(points.clone());
    }
    Ok(outcome)
}

/// What a plan achieves. Beliefs of observers are worked out in full where that takes no longer than details may, or where a
/// proof rests on it; else walks and pairs of values settle what the bounds ask for.
fn achieved(
    problem: &Arc<Problem>,
    options: &Options,
    finding: &Finding,
    plan: &Plan,
) -> Result<Achievement, InvalidPlan> {
    let witnesses = finding.witnesses.clone();
    if witnesses.is_empty() {
        let quick = validate_quickly(problem, plan);
        if !matches!(quick, Err(InvalidPlan::Step(PlanError::TooLarge { .. }))) {
            return quick;
        }
    }
    #[cfg(feature = "full")]
    let witnesses = parallel_walks::beside(problem, plan, witnesses, options.limits);
    if !witnesses.is_empty() {
        let settled = validate_within(problem, plan, &witnesses, options.limits)?;
        let kept = options.heeded_bounds().allow(settled.counts, &settled.survivors);
        if settled.is_settled() || kept && finding.status != Status::Optimal {
            return Ok(settled);
        }
    }
    validate_with(problem, plan, &witnesses)
}
