//! The least cost from each state to the true goal: what a plan through a state must still pay, or no more
//! than that.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::projections::Projections;
use crate::limits::LimitReached;
use crate::problem::JointSpace;
use crate::solver::ground::thresholds::{STATES_BETWEEN_CHECKS, STATES_OF_DEAD_ENDS};
use crate::task::{StateId, StateSpace};

/// The cost of a state from which the true goal cannot be reached.
const NEVER: u64 = u64::MAX;

/// Least costs of states.
#[derive(Debug)]
pub(in crate::solver) enum GoalCosts {
    /// The true ones, by state.
    Listed(Vec<u64>),
    /// Estimates that are never more, each step at the price of the cheapest action, where the state
    /// space is too large to go through first.
    Projected { steps: Box<Projections>, cheapest: u64 },
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
        Self::listing(joint, STATES_OF_DEAD_ENDS)
    }

    fn listing(joint: &mut JointSpace, most: usize) -> Result<Self, LimitReached> {
        joint.initial();
        let limits = *joint.limits();
        let mut index = 0;
        while index < joint.states().len() {
            if joint.states().len() > most {
                let task = joint.problem().task();
                let prices = task.operators().iter().map(|op| task.step_cost(op.action));
                let cheapest = prices.min().unwrap_or(0);
                let steps = Box::new(Projections::new(joint.problem()));
                return Ok(Self::Projected { steps, cheapest });
            }
            joint.states_mut().expand(StateId(index as u32));
            index += 1;
            if index.is_multiple_of(STATES_BETWEEN_CHECKS) {
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
        Ok(Self::Listed(costs))
    }

    /// No way from a state to the true goal costs less; none where there is none.
    pub(in crate::solver) fn least(&self, states: &StateSpace, state: StateId) -> Option<u64> {
        match self {
            Self::Listed(costs) => listed(costs, state),
            Self::Projected { steps, cheapest } => {
                Some(steps.least(states, state)?.saturating_mul(*cheapest))
            }
        }
    }

    /// Whether a state is worth a look: false where it is known at once that the true goal cannot be
    /// reached.
    pub(in crate::solver) fn may_reach(&self, state: StateId) -> bool {
        match self {
            Self::Listed(costs) => listed(costs, state).is_some(),
            Self::Projected { .. } => true,
        }
    }

    /// Bytes in use, counted by contents.
    pub(in crate::solver) fn bytes(&self) -> u64 {
        match self {
            Self::Listed(costs) => 8 * costs.len() as u64,
            Self::Projected { steps, .. } => steps.bytes(),
        }
    }
}

fn listed(costs: &[u64], state: StateId) -> Option<u64> {
    costs.get(state.index()).copied().filter(|cost| *cost != NEVER)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::panic, clippy::unwrap_used)]

    use std::sync::Arc;

    use super::*;
    use crate::common::Dice;
    use crate::common::random::{self, MEDIUM, PAIR};
    use crate::common::strips::Strips;
    use crate::limits::Limits;

    /// Held against what one step changes: the least cost of a state is no more than that of a successor
    /// and the action together, and 0 at the goal; the estimates are never more.
    #[test]
    fn estimates_are_never_more_than_the_least_cost() {
        let mut dice = Dice::new(721);
        let (mut equal, mut less, mut never) = (0, 0, 0);
        for number in 0..3000 {
            let problem = if number % 2 == 0 {
                Arc::clone(&Strips::random(&mut dice, 6, 8, &PAIR).judge().problem)
            } else {
                let table = random::table(&mut dice, MEDIUM, &PAIR);
                let costs: Vec<u64> =
                    table.actions.iter().map(|_| dice.between(1, 5) as u64).collect();
                table.built_with_costs(0, Some(&costs))
            };
            let mut joint = JointSpace::new(problem, Limits::default());
            let costs = GoalCosts::listing(&mut joint, usize::MAX).unwrap();
            let projected = GoalCosts::listing(&mut joint, 0).unwrap();
            assert!(matches!(projected, GoalCosts::Projected { .. }));
            for index in 0..joint.states().len() {
                let state = StateId(index as u32);
                let least = costs.least(joint.states(), state);
                if joint.is_goal(state) {
                    assert_eq!(least, Some(0));
                } else {
                    let task = joint.states().task();
                    let on = joint.states().edges(state).iter().filter_map(|edge| {
                        let rest = costs.least(joint.states(), edge.target)?;
                        Some(rest + task.step_cost(edge.action))
                    });
                    assert_eq!(least, on.min());
                }
                match (projected.least(joint.states(), state), least) {
                    (estimate, None) => never += usize::from(estimate.is_none()),
                    (Some(estimate), Some(least)) => {
                        assert!(estimate <= least, "{estimate} {least}");
                        *(if estimate == least { &mut equal } else { &mut less }) += 1;
                    }
                    (None, Some(least)) => panic!("out of reach, but {least} away"),
                }
            }
        }
        assert!(equal > 1000 && less > 1000 && never > 1000, "{equal} {less} {never}");
    }
}
