//! How far each candidate goal is, from a state and from a belief.
//!
//! The value of a goal in a belief is the least over the belief's states. A belief may hold a
//! hundred thousand of them, so only [`STATES_EVALUATED`] are looked at, evenly spread; the bound
//! changes no proof: a goal that survives already has value 0 whatever the sample says, and a
//! goal is only called unreachable for a belief that was evaluated in full.

use crate::belief::BeliefId;
use crate::problem::JointSpace;
use crate::task::StateId;

use super::{SetAdditive, UNREACHABLE};

/// States of a belief that are evaluated, at most.
pub const STATES_EVALUATED: usize = 64;

/// A value not worked out yet.
const UNKNOWN: u32 = u32::MAX - 1;

/// Values of every candidate goal, remembered by state and by belief.
#[derive(Debug, Clone)]
pub struct GoalValues {
    heuristic: SetAdditive,
    goals: usize,
    /// Row after row, a row of values for each state.
    of_states: Vec<u32>,
    /// The same for each belief of each observer.
    of_beliefs: Vec<Vec<u32>>,
}

impl GoalValues {
    /// No value yet.
    pub fn new(joint: &JointSpace) -> Self {
        let problem = joint.problem();
        Self {
            heuristic: SetAdditive::new(problem.task()),
            goals: problem.goals().len(),
            of_states: Vec::new(),
            of_beliefs: vec![Vec::new(); problem.observers().len()],
        }
    }

    /// Bytes in use, counted by contents.
    pub fn bytes(&self) -> u64 {
        let beliefs: usize = self.of_beliefs.iter().map(Vec::len).sum();
        4 * (self.of_states.len() + beliefs) as u64
    }

    /// The value of each goal in a state.
    pub fn of_state(&mut self, joint: &JointSpace, state: StateId) -> &[u32] {
        let begin = state.index() * self.goals;
        let end = begin + self.goals;
        if self.of_states.len() < end {
            self.of_states.resize(end, UNKNOWN);
        }
        if self.of_states[begin] == UNKNOWN {
            let problem = joint.problem();
            let goals: Vec<_> = problem.goals().iter().map(|g| g.condition.as_slice()).collect();
            let words = joint.states().words(state);
            let values = &mut self.of_states[begin..end];
            self.heuristic.evaluate(problem.task(), words, &goals, values);
        }
        &self.of_states[begin..end]
    }

    /// The value of each goal in a belief of the observer at a position.
    pub fn of_belief(
        &mut self,
        joint: &mut JointSpace,
        observer: usize,
        belief: BeliefId,
    ) -> &[u32] {
        let begin = belief.index() * self.goals;
        let end = begin + self.goals;
        if self.of_beliefs[observer].len() < end {
            self.of_beliefs[observer].resize(end, UNKNOWN);
        }
        if self.of_beliefs[observer][begin] == UNKNOWN {
            let values = self.evaluate_belief(joint, observer, belief);
            self.of_beliefs[observer][begin..end].copy_from_slice(&values);
        }
        &self.of_beliefs[observer][begin..end]
    }

    /// Whether a belief is small enough that its values say which goals are unreachable.
    pub fn is_evaluated_in_full(joint: &JointSpace, observer: usize, belief: BeliefId) -> bool {
        joint.beliefs(observer).members(belief).len() <= STATES_EVALUATED
    }

    fn evaluate_belief(
        &mut self,
        joint: &mut JointSpace,
        observer: usize,
        belief: BeliefId,
    ) -> Vec<u32> {
        let survivors = joint.survivors(observer, belief).clone();
        let mut values = vec![UNREACHABLE; self.goals];
        for goal in survivors.iter() {
            values[goal] = 0;
        }
        if survivors.len() == self.goals {
            return values;
        }
        let members = joint.beliefs(observer).members(belief);
        let evaluated = members.len().min(STATES_EVALUATED);
        for index in 0..evaluated {
            let state = joint.beliefs(observer).members(belief)[index * members.len() / evaluated];
            for (least, &value) in values.iter_mut().zip(self.of_state(joint, state)) {
                *least = value.min(*least);
            }
        }
        values
    }
}
