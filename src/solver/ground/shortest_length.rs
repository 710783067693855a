//! The length of a shortest plan for the true goal, whatever anybody believes.

use std::sync::Arc;

use crate::limits::{LimitReached, Limits};
use crate::task::{StateId, StateSpace, Task};

/// What is known of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::solver) enum Reached {
    /// Nothing yet.
    NotYet,
    /// No plan reaches the goal.
    Never,
    /// The shortest one has so many actions.
    After(usize),
}

/// Breadth first over the states alone, in slices.
#[derive(Debug)]
pub(in crate::solver) struct Shortest {
    space: StateSpace,
    limits: Limits,
    layer: Vec<StateId>,
    next: usize,
    following: Vec<StateId>,
    length: usize,
}

impl Shortest {
    pub(in crate::solver) fn new(task: &Arc<Task>, limits: Limits) -> Self {
        let mut space = StateSpace::new(Arc::clone(task));
        let layer = vec![space.intern(task.initial_state())];
        Self { space, limits, layer, next: 0, following: Vec::new(), length: 0 }
    }

    /// Expands states, as many as `budget` says and takes off it.
    pub(in crate::solver) fn advance(&mut self, budget: &mut u64) -> Result<Reached, LimitReached> {
        loop {
            let Some(&state) = self.layer.get(self.next) else {
                if self.following.is_empty() {
                    return Ok(Reached::Never);
                }
                self.layer.clear();
                std::mem::swap(&mut self.layer, &mut self.following);
                (self.next, self.length) = (0, self.length + 1);
                continue;
            };
            let task = self.space.task();
            if task.satisfies(self.space.words(state), task.goal()) {
                return Ok(Reached::After(self.length));
            }
            if *budget == 0 {
                return Ok(Reached::NotYet);
            }
            *budget -= 1;
            let known = self.space.len();
            self.space.expand(state);
            let new = known..self.space.len();
            self.following.extend(new.map(|index| StateId(index as u32)));
            self.next += 1;
            self.limits.check_bytes(self.space.bytes())?;
        }
    }
}
