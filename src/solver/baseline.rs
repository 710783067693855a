//! The baseline: a plan for the true goal alone, with no regard to the observers.
//!
//! Greedy best first over states with the set-additive heuristic on the true goal alone, as in the
//! paper's experiments. With a horizon or a cost limit, states at different [stages](Stages) are different
//! nodes.

use std::sync::Arc;

use super::ground::best_first::{BestFirst, SearchSpace};
use super::ground::stages::{Cheapest, Stages};
use crate::heuristic::{SetAdditive, UNREACHABLE};
use crate::limits::{LimitReached, Limits};
use crate::solver::engine::Engine;
use crate::solver::ground::thresholds::EXPANSIONS_WITHOUT_A_SMALLER_VALUE;
use crate::solver::outcome::Stats;
use crate::task::{Action, StateId, StateSpace, Task};

/// States, and what led to them where that matters.
#[derive(Debug)]
struct States {
    task: Arc<Task>,
    space: StateSpace,
    heuristic: SetAdditive,
    stages: Stages,
    cheapest: Cheapest<StateId>,
    limits: Limits,
}

/// The baseline on a task, for plans of any length or of exactly `horizon` actions, within a cost limit
/// where there is one.
pub(in crate::solver) fn engine(
    task: &Arc<Task>,
    limits: Limits,
    horizon: Option<usize>,
    cost_limit: Option<u64>,
) -> impl Engine + use<> {
    BestFirst::new(States {
        space: StateSpace::new(Arc::clone(task)),
        heuristic: SetAdditive::new(task),
        task: Arc::clone(task),
        stages: Stages::new(task, horizon, cost_limit),
        cheapest: Cheapest::new(),
        limits,
    })
}

impl SearchSpace for States {
    /// The state, and its stage.
    type Key = (StateId, u32);

    fn root(&mut self) -> Self::Key {
        (self.space.intern(self.task.initial_state()), Stages::FIRST)
    }

    fn is_goal(&mut self, (state, stage): Self::Key) -> Result<bool, LimitReached> {
        Ok(self.stages.may_end(stage)
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
        (state, stage): Self::Key,
        found: &mut Vec<(Action, Self::Key)>,
    ) -> Result<(), LimitReached> {
        found.clear();
        if self.stages.is_last(stage) {
            return Ok(());
        }
        self.space.expand(state);
        for edge in self.space.edges(state) {
            let Some(next) = self.stages.after(stage, edge.action) else { continue };
            if self.cheapest.admit(&self.stages, edge.target, next) {
                found.push((edge.action, (edge.target, next)));
            }
        }
        Ok(())
    }

    fn patience(&self) -> Option<u64> {
        Some(EXPANSIONS_WITHOUT_A_SMALLER_VALUE)
    }

    fn limits(&self) -> &Limits {
        &self.limits
    }

    fn bytes(&self) -> u64 {
        self.space.bytes() + self.stages.bytes() + self.cheapest.bytes()
    }

    fn count(&self, stats: &mut Stats) {
        stats.states = self.space.len() as u64;
    }
}
