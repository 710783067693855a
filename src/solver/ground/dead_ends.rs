//! Dead ends: states from which the true goal cannot be reached, and how far it is from all others.

use fixedbitset::FixedBitSet;

use crate::limits::LimitReached;
use crate::problem::JointSpace;
use crate::solver::ground::thresholds::{STATES_BETWEEN_CHECKS, STATES_OF_DEAD_ENDS};
use crate::task::StateId;

/// For each step of a horizon, the states that can be there in a plan of exactly that length.
#[derive(Debug)]
pub(in crate::solver) struct StatesBySteps {
    layers: Vec<FixedBitSet>,
}

impl StatesBySteps {
    /// Forward from the initial state, then back from the goal: linear in the horizon times the
    /// transitions.
    pub(in crate::solver) fn new(
        joint: &mut JointSpace,
        horizon: usize,
    ) -> Result<Self, LimitReached> {
        let start = joint.initial().state;
        let limits = *joint.limits();
        let mut first = FixedBitSet::new();
        first.grow_and_insert(start.index());
        let mut layers = vec![first];
        let mut bytes = 0;
        for step in 0..horizon {
            let mut next = FixedBitSet::with_capacity(joint.states().len());
            for index in layers[step].ones() {
                let state = StateId(index as u32);
                joint.states_mut().expand(state);
                for edge in joint.states().edges(state) {
                    next.grow_and_insert(edge.target.index());
                }
            }
            bytes += next.len() as u64 / 8;
            limits.check_bytes(joint.bytes() + bytes)?;
            layers.push(next);
        }
        let ends: Vec<usize> = layers[horizon].ones().collect();
        for index in ends {
            if !joint.is_goal(StateId(index as u32)) {
                layers[horizon].remove(index);
            }
        }
        for step in (0..horizon).rev() {
            let (before, after) = layers.split_at_mut(step + 1);
            let here = &mut before[step];
            let states: Vec<usize> = here.ones().collect();
            for index in states {
                let edges = joint.states().edges(StateId(index as u32));
                if !edges.iter().any(|edge| after[0].contains(edge.target.index())) {
                    here.remove(index);
                }
            }
        }
        Ok(Self { layers })
    }

    /// The states in which a plan of the horizon can be after these steps.
    pub(in crate::solver) fn at(&self, step: usize) -> &FixedBitSet {
        &self.layers[step]
    }

    /// Whether a plan of the horizon can be in this state after these steps.
    pub(in crate::solver) fn contains(&self, step: usize, state: StateId) -> bool {
        self.layers[step].contains(state.index())
    }
}

/// The distances of all states from the true goal.
#[derive(Debug)]
pub(in crate::solver) struct TrueGoalDistances {
    /// The fewest actions from each state to the true goal. None when the state space was too large
    /// to go through first: then none counts as a dead end.
    distances: Option<Vec<u32>>,
}

/// The distance of a state from which the true goal cannot be reached.
const NEVER: u32 = u32::MAX;

impl TrueGoalDistances {
    /// Linear in the transitions of the state space, as long as it is not too large.
    pub(in crate::solver) fn new(joint: &mut JointSpace) -> Result<Self, LimitReached> {
        joint.initial();
        let limits = *joint.limits();
        let mut index = 0;
        while index < joint.states().len() {
            if joint.states().len() > STATES_OF_DEAD_ENDS {
                return Ok(Self { distances: None });
            }
            joint.states_mut().expand(StateId(index as u32));
            index += 1;
            if index.is_multiple_of(STATES_BETWEEN_CHECKS) {
                limits.check_bytes(joint.bytes())?;
            }
        }
        let count = joint.states().len();
        let mut sources: Vec<Vec<u32>> = vec![Vec::new(); count];
        for source in 0..count as u32 {
            for edge in joint.states().edges(StateId(source)) {
                sources[edge.target.index()].push(source);
            }
        }
        let mut distances = vec![NEVER; count];
        let goals = (0..count as u32).filter(|&state| joint.is_goal(StateId(state)));
        let mut queue: Vec<u32> = goals.collect();
        for &goal in &queue {
            distances[goal as usize] = 0;
        }
        let mut next = 0;
        while let Some(&state) = queue.get(next) {
            next += 1;
            for &source in &sources[state as usize] {
                if distances[source as usize] == NEVER {
                    distances[source as usize] = distances[state as usize] + 1;
                    queue.push(source);
                }
            }
        }
        Ok(Self { distances: Some(distances) })
    }

    /// The fewest actions from a state to the true goal, none where it cannot be reached; 0 for all
    /// states of a space that was too large.
    pub(in crate::solver) fn distance(&self, state: StateId) -> Option<usize> {
        let Some(distances) = &self.distances else { return Some(0) };
        let distance = distances.get(state.index()).copied().unwrap_or(NEVER);
        (distance != NEVER).then_some(distance as usize)
    }

    /// Whether the true goal may be reachable from a state.
    pub(in crate::solver) fn reach_from(&self, state: StateId) -> bool {
        self.distance(state).is_some()
    }
}
