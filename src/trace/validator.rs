//! The validator: whether a plan solves a problem, and what it achieves.

use thiserror::Error;

use super::Replay;
use super::belief::Budget;
use super::witness::Witness;
use crate::goal_difference::GoalSet;
use crate::plan::{Plan, PlanError};
use crate::problem::{Problem, SurvivorCounts};

/// What a plan achieves.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Achievement {
    /// The goals that survive for each observer at the end.
    pub survivors: Vec<GoalSet>,
    /// How many survive for each side.
    pub counts: SurvivorCounts,
    /// By observer the goals of which it is not known whether they survive, where a limit came before that: they are among
    /// the survivors of a friend and not among those of an enemy.
    pub unsettled: Vec<GoalSet>,
}

impl Achievement {
    /// Whether it is known of every goal and observer.
    pub(crate) fn is_settled(&self) -> bool {
        self.unsettled.iter().all(GoalSet::is_empty)
    }
}

/// Why a plan is no solution.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum InvalidPlan {
    /// A step cannot be carried out.
    #[error(transparent)]
    Step(#[from] PlanError),
    /// The true goal does not hold at the end.
    #[error("the plan ends in a state without the true goal")]
    MissesGoal,
    /// It costs more than it may.
    #[error("the plan costs {cost}, more than the limit of {limit}")]
    TooExpensive {
        /// Its cost, or its number of actions where the task has no costs.
        cost: u128,
        /// The limit.
        limit: u64,
    },
}

/// Replays a plan, keeping nothing but what it achieves.
///
/// # Errors
///
/// [`InvalidPlan`] when the plan does not solve the task.
pub fn validate(problem: &Problem, plan: &Plan) -> Result<Achievement, InvalidPlan> {
    validate_with(problem, plan, &[])
}

/// Checks what a plan costs (the number of its actions where the task has no costs) against a limit.
///
/// # Errors
///
/// [`InvalidPlan::TooExpensive`] when it is more.
///
/// ```
/// use mo_copp::{domain::Delivery, plan::Plan, trace::check_cost};
/// let problem = Delivery::figure_1().problem()?;
/// let plan = Plan::from_names(problem.task(), &["load a1", "load a2", "deliver"])?;
/// assert!(check_cost(&problem, &plan, Some(3)).is_ok() && check_cost(&problem, &plan, None).is_ok());
/// let error = check_cost(&problem, &plan, Some(2)).unwrap_err();
/// assert_eq!(error.to_string(), "the plan costs 3, more than the limit of 2");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn check_cost(problem: &Problem, plan: &Plan, limit: Option<u64>) -> Result<(), InvalidPlan> {
    let cost = plan.cost_or_length(problem.task());
    match limit {
        Some(limit) if cost > u128::from(limit) => Err(InvalidPlan::TooExpensive { cost, limit }),
        _ => Ok(()),
    }
}

/// The same with [witnesses](Witness). Where they show that every goal survives for an observer, nothing more has to be known
/// of its beliefs; witnesses that do not hold show nothing.
///
/// # Errors
///
/// [`InvalidPlan`] when the plan does not solve the task.
pub fn validate_with(
    problem: &Problem,
    plan: &Plan,
    witnesses: &[Witness],
) -> Result<Achievement, InvalidPlan> {
    replayed(Replay::new(problem, plan)?, witnesses)
}

/// The same as [`validate`], where it takes no longer than details may.
///
/// # Errors
///
/// [`InvalidPlan`] when the plan does not solve the task, [`PlanError::TooLarge`] when it takes longer.
pub(crate) fn validate_quickly(problem: &Problem, plan: &Plan) -> Result<Achievement, InvalidPlan> {
    let mut replay = Replay::new(problem, plan)?;
    replay.budget = Budget::of_details(replay.budget.limits);
    replayed(replay, &[])
}

fn replayed(mut replay: Replay<'_>, witnesses: &[Witness]) -> Result<Achievement, InvalidPlan> {
    if !replay.reaches_goal() {
        return Err(InvalidPlan::MissesGoal);
    }
    replay.leave_out_all_alive(witnesses);
    while replay.step()?.is_some() {
        if replay.lists_too_many() {
            return Err(PlanError::TooLarge { step: replay.at }.into());
        }
    }
    let problem = replay.problem;
    let survivors = replay.survivors();
    let counts = problem.survivor_counts(&survivors);
    let unsettled = vec![GoalSet::none(problem.goals().len()); survivors.len()];
    Ok(Achievement { survivors, counts, unsettled })
}
