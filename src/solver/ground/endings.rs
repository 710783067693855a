//! Endings: from which states a plan can still end after exactly so many more actions.

use fixedbitset::FixedBitSet;

use super::projections::Projections;
use crate::limits::LimitReached;
use crate::problem::JointSpace;
use crate::solver::ground::thresholds::{PART_OF_MEMORY_FOR_ENDINGS, STATES_BETWEEN_CHECKS};
use crate::task::StateId;

/// For each number of actions left, the states from which the true goal is that far, exactly.
#[derive(Debug)]
pub(in crate::solver) struct Endings {
    layers: Vec<FixedBitSet>,
}

impl Endings {
    /// Forward from the initial state as far as the horizon, without the states from which the goal is
    /// farther than that by [projections](Projections), then back from the goal: linear in the horizon
    /// times the transitions. None where too many states are met.
    pub(in crate::solver) fn new(
        joint: &mut JointSpace,
        horizon: usize,
    ) -> Result<Option<Self>, LimitReached> {
        let start = joint.initial().state;
        let limits = *joint.limits();
        let projections = Projections::new(joint.problem());
        let mut depths: Vec<u32> = vec![0; start.index() + 1];
        let mut layer = vec![start];
        let mut met = FixedBitSet::new();
        met.grow_and_insert(start.index());
        let mut reached = vec![start];
        for step in 1..=horizon {
            let mut next = Vec::new();
            for (number, &state) in layer.iter().enumerate() {
                if number % STATES_BETWEEN_CHECKS == 0
                    && joint.bytes() > limits.bytes / PART_OF_MEMORY_FOR_ENDINGS
                {
                    return Ok(None);
                }
                joint.states_mut().expand(state);
                for edge in joint.states().edges(state) {
                    if edge.target.index() >= met.len() || !met[edge.target.index()] {
                        met.grow_and_insert(edge.target.index());
                        let least = projections.least(joint.states(), edge.target);
                        if least.is_some_and(|least| least <= (horizon - step) as u64) {
                            next.push(edge.target);
                        }
                    }
                }
            }
            if next.is_empty() {
                break;
            }
            depths.resize(joint.states().len(), 0);
            for state in &next {
                depths[state.index()] = step as u32;
            }
            reached.extend(&next);
            layer = next;
        }
        depths.resize(joint.states().len(), 0);
        let count = joint.states().len();
        limits.check_bytes(joint.bytes() + (horizon as u64 + 1) * (count as u64 / 8 + 24))?;
        let mut last = FixedBitSet::with_capacity(count);
        for &state in &reached {
            if joint.is_goal(state) {
                last.insert(state.index());
            }
        }
        let mut layers = vec![last];
        for left in 1..=horizon {
            let mut layer = FixedBitSet::with_capacity(count);
            // A state first met after more steps has no such many left.
            let near = |state: &&StateId| depths[state.index()] as usize + left <= horizon;
            for state in reached.iter().take_while(near) {
                let edges = joint.states().edges(*state);
                if edges.iter().any(|edge| layers[left - 1].contains(edge.target.index())) {
                    layer.insert(state.index());
                }
            }
            layers.push(layer);
        }
        Ok(Some(Self { layers }))
    }

    /// Whether a plan can end with exactly so many more actions from a state.
    pub(in crate::solver) fn contains(&self, state: StateId, left: usize) -> bool {
        self.layers.get(left).is_some_and(|layer| layer.contains(state.index()))
    }

    /// Bytes in use, counted by contents.
    pub(in crate::solver) fn bytes(&self) -> u64 {
        self.layers.iter().map(|layer| layer.len() as u64 / 8 + 24).sum()
    }
}
