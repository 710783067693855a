//! The least cost from each state to the true goal: what a plan through a state must still pay.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::limits::LimitReached;
use crate::problem::JointSpace;
use crate::task::StateId;

/// The cost of a state from which the true goal cannot be reached.
const NEVER: u64 = u64::MAX;

/// State spaces above this size are not gone through before the search itself.
const MOST_STATES: usize = 200_000;

/// Least costs, by state. None when the state space was too large to go through first.
#[derive(Debug)]
pub(in crate::solver) struct GoalCosts {
    costs: Option<Vec<u64>>,
}

impl GoalCosts {
    /// Back from the states with the true goal, the cheapest first (Dijkstra 1959,
    /// doi:10.1007/BF01386390): n log n in the transitions of the state space, as long as it is not too
    /// large.
    ///
    /// # Errors
    ///
    /// The memory limit.
    pub(in crate::solver) fn new(joint: &mut JointSpace) -> Result<Self, LimitReached> {
        joint.initial();
        let limits = *joint.limits();
        let mut index = 0;
        while index < joint.states().len() {
            if joint.states().len() > MOST_STATES {
                return Ok(Self { costs: None });
            }
            joint.states_mut().expand(StateId(index as u32));
            index += 1;
            if index % 1024 == 0 {
                limits.check_bytes(joint.bytes())?;
            }
        }
        let count = joint.states().len();
        let mut sources: Vec<Vec<(u32, u64)>> = vec![Vec::new(); count];
        for source in 0..count as u32 {
            for edge in joint.states().edges(StateId(source)) {
                let cost = joint.states().task().step_cost(edge.action);
                sources[edge.target.index()].push((source, cost));
            }
        }
        let mut costs = vec![NEVER; count];
        let mut queue = BinaryHeap::new();
        for state in 0..count as u32 {
            if joint.is_goal(StateId(state)) {
                costs[state as usize] = 0;
                queue.push(Reverse((0, state)));
            }
        }
        while let Some(Reverse((cost, state))) = queue.pop() {
            if cost > costs[state as usize] {
                continue;
            }
            for &(source, more) in &sources[state as usize] {
                // A sum that is too large to count is no plan's.
                let Some(sum) = cost.checked_add(more).filter(|sum| *sum != NEVER) else {
                    continue;
                };
                if sum < costs[source as usize] {
                    costs[source as usize] = sum;
                    queue.push(Reverse((sum, source)));
                }
            }
        }
        Ok(Self { costs: Some(costs) })
    }

    /// The least cost from a state to the true goal, none where it cannot be reached; 0 for all states
    /// of a space that was too large.
    pub(in crate::solver) fn least(&self, state: StateId) -> Option<u64> {
        let Some(costs) = &self.costs else { return Some(0) };
        costs.get(state.index()).copied().filter(|cost| *cost != NEVER)
    }

    /// Bytes in use, counted by contents.
    pub(in crate::solver) fn bytes(&self) -> u64 {
        self.costs.as_ref().map_or(0, |costs| 8 * costs.len() as u64)
    }
}
