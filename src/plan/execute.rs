//! Runs a plan on the task alone.

use thiserror::Error;

use super::Plan;
use crate::task::{Fact, OperatorId, State, Task};

/// Why a plan cannot be carried out.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum PlanError {
    /// A name that is no action of the task.
    #[error("step {step}: found {}, expected an action of this problem: {known}", named(action))]
    UnknownAction {
        /// The step, from 1.
        step: usize,
        /// What was found.
        action: String,
        /// Some of the actions there are.
        known: String,
    },
    /// More actions than a plan may have.
    #[error("the plan: found {found} actions, expected at most {}", super::MAX_LENGTH)]
    TooLong {
        /// How many there are.
        found: usize,
    },
    /// A trace that would take too much memory.
    #[error("trace limit reached at step {step}: {limit} believed states")]
    TooManyStates {
        /// The step, from 1.
        step: usize,
        /// The limit on the believed states of all steps together.
        limit: usize,
    },
    /// Beliefs that take too much memory, though their states are not listed.
    #[error("trace limit reached at step {step}: the beliefs take too much memory")]
    TooLarge {
        /// The step, from 1.
        step: usize,
    },
    /// An action that cannot be carried out where the plan has led.
    #[error("step {step}: found {action}, which is not applicable in {state}: {reason}")]
    NotApplicable {
        /// The step, from 1.
        step: usize,
        /// The action.
        action: String,
        /// The state the plan has led to.
        state: String,
        /// What is missing.
        reason: String,
    },
}

fn named(action: &str) -> String {
    if action.is_empty() { "nothing".to_owned() } else { format!("{action:?}") }
}

/// Applies a plan to the initial state: every operator used and every state passed, the initial
/// one first. Whether the goal holds at the end is for the caller to ask. `label` names a packed
/// state in an error.
///
/// # Errors
///
/// [`PlanError::NotApplicable`] at the first step whose preconditions do not hold.
pub fn execute(
    task: &Task,
    plan: &Plan,
    label: impl Fn(&[u64]) -> String,
) -> Result<(Vec<OperatorId>, Vec<State>), PlanError> {
    let mut state = task.initial_state().clone();
    let mut operators = Vec::with_capacity(plan.len());
    let mut states = vec![state.clone()];
    for (index, &action) in plan.actions.iter().enumerate() {
        let of_action = |(_, op): &(usize, &crate::task::Operator)| op.action == action;
        let applicable = task
            .operators()
            .iter()
            .enumerate()
            .filter(of_action)
            .find(|(_, op)| task.satisfies(state.words(), &op.preconditions));
        let Some((number, _)) = applicable else {
            let names = |facts: &[Fact]| {
                facts.iter().map(|&fact| task.fact_name(fact)).collect::<Vec<_>>().join(", ")
            };
            let mut cases = task.operators().iter().filter(|op| op.action == action);
            let reason = match (cases.next(), cases.next()) {
                (Some(only), None) => {
                    let missing: Vec<Fact> = only
                        .preconditions
                        .iter()
                        .copied()
                        .filter(|&fact| !task.satisfies(state.words(), &[fact]))
                        .collect();
                    format!("it needs {}", names(&missing))
                }
                (Some(_), Some(_)) => "it leads nowhere from there".to_owned(),
                (None, _) => "it leads nowhere from any state".to_owned(),
            };
            return Err(PlanError::NotApplicable {
                step: index + 1,
                action: task.action_name(action).to_owned(),
                state: label(state.words()),
                reason,
            });
        };
        let operator = OperatorId::new(number);
        let mut words = state.words().to_vec();
        task.apply(operator, &mut words);
        state = State::from_words(words);
        operators.push(operator);
        states.push(state.clone());
    }
    Ok((operators, states))
}
