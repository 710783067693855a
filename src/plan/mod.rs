//! Plans, and what they do to the actor.
//!
//! A plan `π` is a sequence of actions; a plan of horizon T has exactly T of them. Whether it
//! solves a task is decided by [`execute`], which applies the transition function directly and
//! shares no code with the solvers' state space.

mod execute;
mod next;

pub use execute::{PlanError, execute};
pub use next::{NextAction, next_actions};

use crate::task::{Action, Task};

/// The most actions a plan may have.
pub const MAX_LENGTH: usize = 10_000;

/// A sequence of actions.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Plan {
    /// The actions in order.
    pub actions: Vec<Action>,
}

impl Plan {
    /// The number of actions.
    pub fn len(&self) -> usize {
        self.actions.len()
    }

    /// Whether there is no action at all.
    pub fn is_empty(&self) -> bool {
        self.actions.is_empty()
    }

    /// What the actions cost together; none where the task has no costs.
    pub fn cost(&self, task: &Task) -> Option<u64> {
        let sum = |sum: u64, &action: &Action| sum.saturating_add(task.cost(action));
        task.has_costs().then(|| self.actions.iter().fold(0, sum))
    }

    /// What counts under a cost limit: the cost, however great, or the number of actions where the task has
    /// no costs.
    pub fn cost_or_length(&self, task: &Task) -> u128 {
        self.actions.iter().map(|&action| u128::from(task.step_cost(action))).sum()
    }

    /// The names of the actions.
    pub fn names(&self, task: &Task) -> Vec<String> {
        self.actions.iter().map(|&action| task.action_name(action).to_owned()).collect()
    }

    /// The plan with these action names.
    ///
    /// # Errors
    ///
    /// [`PlanError::UnknownAction`] names the first step that is no action of the task;
    /// [`PlanError::TooLong`] where there are more than [`MAX_LENGTH`].
    ///
    /// ```
    /// use mo_copp::{plan::Plan, task::TaskBuilder};
    /// let mut task = TaskBuilder::default();
    /// let done = task.fact("done");
    /// task.operator("work", &[], &[done], &[]);
    /// let task = task.build(&[], &[done])?;
    /// assert_eq!(Plan::from_names(&task, &["work", "work"])?.len(), 2);
    /// assert!(Plan::from_names(&task, &["sleep"]).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_names(task: &Task, names: &[impl AsRef<str>]) -> Result<Self, PlanError> {
        if names.len() > MAX_LENGTH {
            return Err(PlanError::TooLong { found: names.len() });
        }
        let mut actions = Vec::with_capacity(names.len());
        for (index, name) in names.iter().enumerate() {
            let name = name.as_ref();
            let action = task.action_named(name).ok_or_else(|| PlanError::UnknownAction {
                step: index + 1,
                action: name.to_owned(),
                known: known_actions(task),
            })?;
            actions.push(action);
        }
        Ok(Self { actions })
    }
}

/// The first few action names, for a message.
fn known_actions(task: &Task) -> String {
    const SHOWN: usize = 8;
    let mut names: Vec<&str> =
        (0..task.action_count().min(SHOWN)).map(|i| task.action_name(Action::new(i))).collect();
    if task.action_count() > SHOWN {
        names.push("…");
    }
    names.join(", ")
}
