//! Says why there is no plan, and what would do.

use std::fmt::Write;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use mo_copp::goal_difference::written;
use mo_copp::problem::Problem;
use mo_copp::solver::remedy::{Advice, Change, Reason, RemedyRun};
use mo_copp::solver::{Horizon, Options, Outcome, SolveError, Status};

/// As many expansions at least are spent on it, however few the solver took.
const LEAST_EXPANSIONS: u64 = 100_000;
/// Expansions between two looks at whether somebody wants to stop.
const SLICE: u64 = 16;

/// Looks for remedies where it is proved that there is no plan, for about as long as the solver took
/// for the proof.
pub fn advise(
    problem: &Arc<Problem>,
    options: &Options,
    outcome: &Outcome,
    stop: &AtomicBool,
) -> Result<Option<Advice>, SolveError> {
    let unasked = options.lengths.is_some() || options.cost_limit.is_some();
    if outcome.status != Status::Infeasible || unasked {
        return Ok(None);
    }
    let mut options = options.clone();
    let most = outcome.stats.expansions.max(LEAST_EXPANSIONS);
    options.limits.expansions = options.limits.expansions.min(most);
    let mut run = RemedyRun::after_proof(Arc::clone(problem), options)?;
    while !stop.load(Ordering::SeqCst) && !run.advance(SLICE)? {}
    run.outcome().map(Some)
}

/// The advice in words.
pub fn text(problem: &Problem, options: &Options, advice: &Advice) -> String {
    let goal = &problem.goals()[problem.true_goal()].name;
    let shortest = advice.shortest.unwrap_or_default();
    let mut text = String::new();
    // Writing to a text cannot fail.
    let _ = match (advice.reason, options.horizon) {
        (Some(Reason::Unreachable), _) => writeln!(text, "the true goal {goal} cannot be reached"),
        (Some(Reason::Length), Horizon::Steps(steps)) if shortest < steps => writeln!(
            text,
            "{goal} can be reached in {shortest} actions, but not in exactly {steps}"
        ),
        (Some(Reason::Length), _) => {
            writeln!(text, "it takes at least {shortest} actions to reach {goal}")
        }
        (Some(Reason::Bounds), Horizon::Steps(steps)) => {
            writeln!(text, "plans of {steps} actions reach {goal}, but none keeps the bounds")
        }
        (Some(Reason::Bounds), _) => {
            writeln!(text, "plans reach {goal}, but none keeps the bounds")
        }
        _ => writeln!(text, "why there is no plan was not found before the work stopped"),
    };
    for remedy in &advice.remedies {
        let option = match remedy.change {
            Change::Horizon => "--horizon",
            Change::AtLeast => "--k",
            Change::AtMost => "--j",
            other => other.name(),
        };
        let value = remedy.value;
        let difference = written(remedy.goal_difference, problem.goals().len());
        let _ = writeln!(
            text,
            "  with {option} {value} there is a plan (goal difference {difference})"
        );
    }
    if !advice.complete {
        let _ = writeln!(text, "  other changes may do as well: not all were tried");
    } else if advice.remedies.is_empty() && advice.reason == Some(Reason::Bounds) {
        let _ = writeln!(text, "  no change of a single number would help");
    }
    text
}
