//! What a plan achieves, settled from both sides.
//!
//! A [walk](Witness) shows that a goal survives, and a [pairwise belief](crate::belief::pairwise) that it is dead. Where these
//! leave a goal open, the belief is worked out, and only within limits.

use super::belief::{Budget, TracedBelief};
use super::validator::{Achievement, InvalidPlan};
use super::witness::Witness;
use super::{OperatorsByFact, Replay};
use crate::belief::diagram::suits;
use crate::belief::pairwise::PairwiseUpdates;
use crate::goal_difference::GoalSet;
use crate::limits::{LISTED_STATES, Limits};
use crate::plan::Plan;
use crate::problem::{Observer, Problem, Role};
use crate::sensor::Symbol;

/// Replays a plan, with [witnesses](Witness) of what survives. A goal that neither these nor the pairs of values that an
/// observer can believe nor its belief within `limits` settle is *unsettled*, and counts as what the actor does not want.
///
/// # Errors
///
/// [`InvalidPlan`] when the plan does not solve the task.
///
/// ```
/// use mo_copp::{domain::Delivery, limits::Limits, plan::Plan, trace::{validate, validate_within}};
/// let problem = Delivery::figure_1().problem()?;
/// let plan = Plan::from_names(problem.task(), &["load a1", "load a2", "deliver"])?;
/// let within = validate_within(&problem, &plan, &[], Limits::default())?;
/// assert_eq!(within, validate(&problem, &plan)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn validate_within(
    problem: &Problem,
    plan: &Plan,
    witnesses: &[Witness],
    limits: Limits,
) -> Result<Achievement, InvalidPlan> {
    let replay = Replay::new(problem, plan)?;
    if !replay.reaches_goal() {
        return Err(InvalidPlan::MissesGoal);
    }
    let goals = problem.goals().len();
    let (mut survivors, mut unsettled) = (Vec::new(), Vec::new());
    for (place, observer) in problem.observers().iter().enumerate() {
        let seen = replay.symbols(observer);
        let mut alive = GoalSet::none(goals);
        // The plan is such a walk itself.
        alive.insert(problem.true_goal());
        for witness in witnesses.iter().filter(|witness| witness.observer == place) {
            if witness.holds(problem, &seen) {
                alive.insert(witness.goal);
            }
        }
        let updates = PairwiseUpdates::new(problem.task(), &observer.sensor);
        let mut open = open_goals(problem, observer, updates.as_ref(), &seen);
        if alive.len() < open.len()
            && let Some(known) = known(problem, &replay.operators, observer, &seen, limits)
        {
            (alive, open) = (known.clone(), known);
        }
        let mut unknown = GoalSet::none(goals);
        open.iter().filter(|goal| !alive.contains(*goal)).for_each(|goal| unknown.insert(goal));
        unsettled.push(unknown);
        survivors.push(if observer.role == Role::Adversarial { alive } else { open });
    }
    let counts = problem.survivor_counts(&survivors);
    Ok(Achievement { survivors, counts, unsettled })
}

/// The goals that the pairs of values which an observer can believe after its symbols do not rule out: all of them where
/// there are too many pairs.
pub(crate) fn open_goals(
    problem: &Problem,
    observer: &Observer,
    updates: Option<&PairwiseUpdates>,
    seen: &[Symbol],
) -> GoalSet {
    let task = problem.task();
    let belief = updates.map(|updates| {
        let first = updates.initial(task, &observer.initial_belief);
        let last = seen.iter().fold(first, |belief, symbol| updates.update(&belief, *symbol));
        (updates, last)
    });
    let mut open = GoalSet::none(problem.goals().len());
    for (goal, candidate) in problem.goals().iter().enumerate() {
        let may = belief.as_ref().is_none_or(|(updates, belief)| {
            updates.may_satisfy(task, belief, &candidate.condition)
        });
        if may {
            open.insert(goal);
        }
    }
    open
}

/// The goals that survive in an observer's belief; none where it takes more than the limits.
fn known(
    problem: &Problem,
    operators: &OperatorsByFact,
    observer: &Observer,
    seen: &[Symbol],
    limits: Limits,
) -> Option<GoalSet> {
    let task = problem.task();
    let diagrams = suits(task);
    let mut budget = Budget::of_details(limits);
    let mut belief = TracedBelief::initial(task, observer, budget.limits);
    for &symbol in seen {
        belief
            .update(task, operators, &observer.sensor, symbol, LISTED_STATES, &mut budget)
            .ok()?;
        if !diagrams && belief.as_list().is_none() {
            return None;
        }
    }
    let mut alive = GoalSet::none(problem.goals().len());
    for (goal, candidate) in problem.goals().iter().enumerate() {
        if belief.satisfies(task, &candidate.condition) {
            alive.insert(goal);
        }
    }
    Some(alive)
}
