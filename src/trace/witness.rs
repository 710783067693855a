//! Witnesses: walks that show that goals survive, without the belief that they survive in.

use crate::problem::{Observer, Problem};
use crate::sensor::Symbol;
use crate::task::{Action, State};

/// A walk to a goal from a state that an observer holds possible at first. The observer sees on it what it sees of the plan,
/// so it can't rule the goal out.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Witness {
    /// The position of the observer.
    pub observer: usize,
    /// The position of the goal.
    pub goal: usize,
    /// Where the walk begins.
    pub start: State,
    /// As many actions as the plan has.
    pub actions: Vec<Action>,
}

impl Witness {
    /// Whether the walk can be taken, shows these symbols and ends in its goal. Linear in its length.
    pub(crate) fn holds(&self, problem: &Problem, seen: &[Symbol]) -> bool {
        let (Some(observer), Some(goal)) =
            (problem.observers().get(self.observer), problem.goals().get(self.goal))
        else {
            return false;
        };
        let Observer { sensor, initial_belief, .. } = observer;
        if self.actions.len() != seen.len() || !initial_belief.contains(&self.start) {
            return false;
        }
        let task = problem.task();
        let mut words = self.start.words().to_vec();
        let mut applicable = Vec::new();
        for (&action, &symbol) in self.actions.iter().zip(seen) {
            task.applicable(&words, &mut applicable);
            let Some(&id) = applicable.iter().find(|id| task.operator(**id).action == action)
            else {
                return false;
            };
            task.apply(id, &mut words);
            if sensor.read(task, id, &words) != symbol {
                return false;
            }
        }
        task.satisfies(&words, &goal.condition)
    }
}
