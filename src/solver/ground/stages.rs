//! Stages: what the way to a node has used up of a horizon and of a cost limit.
//!
//! At a horizon a state after other numbers of actions is another node, and under a cost limit one that
//! cost something else is: what can still be done there differs. Without either all nodes are of one
//! stage.

use std::collections::hash_map::Entry;
use std::hash::Hash;
use std::sync::Arc;

use rustc_hash::FxHashMap;

use crate::task::{Action, Task};

/// The stages met, by number.
#[derive(Debug)]
pub(in crate::solver) struct Stages {
    task: Arc<Task>,
    horizon: Option<usize>,
    cost_limit: Option<u64>,
    /// Actions and cost; 0 of what does not count.
    met: Vec<(u32, u64)>,
    numbers: FxHashMap<(u32, u64), u32>,
}

impl Stages {
    /// The stage before the first action.
    pub(in crate::solver) const FIRST: u32 = 0;

    pub(in crate::solver) fn new(
        task: &Arc<Task>,
        horizon: Option<usize>,
        cost_limit: Option<u64>,
    ) -> Self {
        let numbers = std::iter::once(((0, 0), Self::FIRST)).collect();
        Self { task: Arc::clone(task), horizon, cost_limit, met: vec![(0, 0)], numbers }
    }

    /// The stage after an action; none beyond the horizon or the cost limit.
    pub(in crate::solver) fn after(&mut self, stage: u32, action: Action) -> Option<u32> {
        let (mut steps, mut cost) = self.met[stage as usize];
        if let Some(horizon) = self.horizon {
            steps += 1;
            if steps as usize > horizon {
                return None;
            }
        }
        if let Some(limit) = self.cost_limit {
            cost = cost.checked_add(self.task.step_cost(action)).filter(|cost| *cost <= limit)?;
        }
        let next = self.met.len() as u32;
        let number = *self.numbers.entry((steps, cost)).or_insert(next);
        if number == next {
            self.met.push((steps, cost));
        }
        Some(number)
    }

    /// Whether the horizon, where there is one, is reached.
    pub(in crate::solver) fn is_last(&self, stage: u32) -> bool {
        self.horizon == Some(self.met[stage as usize].0 as usize)
    }

    /// Whether a plan may end in a stage.
    pub(in crate::solver) fn may_end(&self, stage: u32) -> bool {
        self.horizon.is_none() || self.is_last(stage)
    }

    /// Bytes in use, counted by contents.
    pub(in crate::solver) fn bytes(&self) -> u64 {
        (self.met.len() * (2 * size_of::<(u32, u64)>() + size_of::<u32>() + 1)) as u64
    }
}

/// The cheapest stage in which each node was met: the same node after as many actions that cost no less
/// has nothing to add. Remembers nothing where there is no cost limit.
#[derive(Debug)]
pub(in crate::solver) struct Cheapest<K> {
    known: FxHashMap<(K, u32), u64>,
}

impl<K: Eq + Hash> Cheapest<K> {
    pub(in crate::solver) fn new() -> Self {
        Self { known: FxHashMap::default() }
    }

    /// Meets a node; whether it was never met so cheaply before.
    pub(in crate::solver) fn admit(&mut self, stages: &Stages, node: K, stage: u32) -> bool {
        if stages.cost_limit.is_none() {
            return true;
        }
        let (steps, cost) = stages.met[stage as usize];
        match self.known.entry((node, steps)) {
            Entry::Occupied(known) if *known.get() <= cost => false,
            Entry::Occupied(mut known) => {
                known.insert(cost);
                true
            }
            Entry::Vacant(new) => {
                new.insert(cost);
                true
            }
        }
    }

    /// Bytes in use, counted by contents.
    pub(in crate::solver) fn bytes(&self) -> u64 {
        (self.known.len() * (size_of::<((K, u32), u64)>() + 1)) as u64
    }
}
