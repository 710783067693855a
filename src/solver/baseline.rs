//! The baseline: a plan for the true goal alone, with no regard to the observers.
//!
//! Greedy best first over states with the set-additive heuristic on the true goal alone, as in the
//! paper's experiments. With a horizon, states at different steps are different nodes.

use std::sync::Arc;

use super::ground::best_first::{BestFirst, SearchSpace};
use crate::heuristic::{SetAdditive, UNREACHABLE};
use crate::limits::{LimitReached, Limits};
use crate::solver::engine::Engine;
use crate::solver::outcome::Stats;
use crate::task::{Action, StateId, StateSpace, Task};

/// Expansions without a smaller value after which new nodes take their turns as well. Driverlog
/// with four drivers and eight packages is not solved in millions of expansions without.
const PATIENCE: u64 = 1000;

/// States, and how many actions led to them where that matters.
#[derive(Debug)]
struct States {
    task: Arc<Task>,
    space: StateSpace,
    heuristic: SetAdditive,
    horizon: Option<usize>,
    limits: Limits,
}

/// The baseline on a task, for plans of any length or of exactly `horizon` actions.
pub(in crate::solver) fn engine(
    task: &Arc<Task>,
    limits: Limits,
    horizon: Option<usize>,
) -> impl Engine + use<> {
    BestFirst::new(States {
        space: StateSpace::new(Arc::clone(task)),
        heuristic: SetAdditive::new(task),
        task: Arc::clone(task),
        horizon,
        limits,
    })
}

impl SearchSpace for States {
    /// The state, and the number of actions before it (0 where there is no horizon).
    type Key = (StateId, u32);

    fn root(&mut self) -> Self::Key {
        (self.space.intern(self.task.initial_state()), 0)
    }

    fn is_goal(&mut self, (state, steps): Self::Key) -> Result<bool, LimitReached> {
        Ok(self.horizon.is_none_or(|horizon| horizon == steps as usize)
            && self.task.satisfies(self.space.words(state), self.task.goal()))
    }

    fn value(&mut self, (state, _): Self::Key) -> Option<i64> {
        let mut value = [0];
        let words = self.space.words(state);
        self.heuristic.evaluate(&self.task, words, &[self.task.goal()], &mut value);
        (value[0] != UNREACHABLE).then(|| i64::from(value[0]))
    }

    fn expand(
        &mut self,
        (state, steps): Self::Key,
        found: &mut Vec<(Action, Self::Key)>,
    ) -> Result<(), LimitReached> {
        found.clear();
        let steps = match self.horizon {
            None => 0,
            Some(horizon) if steps as usize == horizon => return Ok(()),
            Some(_) => steps + 1,
        };
        self.space.expand(state);
        found
            .extend(self.space.edges(state).iter().map(|edge| (edge.action, (edge.target, steps))));
        Ok(())
    }

    fn patience(&self) -> Option<u64> {
        Some(PATIENCE)
    }

    fn limits(&self) -> &Limits {
        &self.limits
    }

    fn bytes(&self) -> u64 {
        self.space.bytes()
    }

    fn count(&self, stats: &mut Stats) {
        stats.states = self.space.len() as u64;
    }
}
