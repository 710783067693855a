//! What can be done after a plan.

use super::{Plan, PlanError, execute};
use crate::task::{Action, State, Task};

/// An action that can be taken, and where it leads.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct NextAction {
    /// The action.
    pub action: Action,
    /// The resulting state.
    pub state: State,
    /// Whether the task's goal holds there.
    pub goal: bool,
}

/// The actions applicable after a plan, in the order in which the task names them. `label` names a
/// packed state in an error.
///
/// Linear in the operators of the task for each step of the plan.
///
/// # Errors
///
/// [`PlanError::NotApplicable`] at the first step of the plan whose preconditions do not hold.
///
/// ```
/// use mo_copp::{domain::Delivery, plan::{Plan, next_actions}};
/// let problem = Delivery::figure_1().problem()?;
/// let task = problem.task();
/// let plan = Plan::from_names(task, &["load a1", "load a2"])?;
/// let next = next_actions(task, &plan, |words| problem.label(words).to_string())?;
/// let names: Vec<&str> = next.iter().map(|next| task.action_name(next.action)).collect();
/// assert_eq!(names, ["deliver"]);
/// assert!(next[0].goal);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn next_actions(
    task: &Task,
    plan: &Plan,
    label: impl Fn(&[u64]) -> String,
) -> Result<Vec<NextAction>, PlanError> {
    let (_, mut states) = execute(task, plan, label)?;
    // There is always the initial state.
    let here = states.pop().unwrap_or_else(|| task.initial_state().clone());
    let mut found: Vec<NextAction> = Vec::new();
    for (id, operator) in task.operator_ids() {
        if task.satisfies(here.words(), &operator.preconditions) {
            let mut words = here.words().to_vec();
            task.apply(id, &mut words);
            let goal = task.satisfies(&words, task.goal());
            let action = operator.action;
            let place = found.partition_point(|known| known.action < action);
            found.insert(place, NextAction { action, state: State::from_words(words), goal });
        }
    }
    Ok(found)
}
