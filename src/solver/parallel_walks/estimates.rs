//! Set-additive values of one goal at a time, remembered by state.

use crate::heuristic::{SetAdditive, UNREACHABLE};
use crate::problem::JointSpace;
use crate::task::{Action, StateId};

/// A value that has not been worked out.
const UNKNOWN: u32 = UNREACHABLE - 1;

/// The values of the goals in the states that were asked about.
#[derive(Debug)]
pub(super) struct GoalEstimates {
    heuristic: SetAdditive,
    /// By goal, then by state.
    values: Vec<Vec<u32>>,
    /// How many have been worked out: what the work is measured by.
    pub worked_out: u64,
}

impl GoalEstimates {
    pub(super) fn new(joint: &JointSpace) -> Self {
        let problem = joint.problem();
        Self {
            heuristic: SetAdditive::new(problem.task()),
            values: vec![Vec::new(); problem.goals().len()],
            worked_out: 0,
        }
    }

    /// Bytes in use, counted by contents.
    pub(super) fn bytes(&self) -> u64 {
        4 * self.values.iter().map(Vec::len).sum::<usize>() as u64
    }

    /// How far a goal is from a state; 0 where it holds.
    pub(super) fn of_state(&mut self, joint: &JointSpace, state: StateId, goal: usize) -> u32 {
        let row = &mut self.values[goal];
        if row.len() <= state.index() {
            row.resize(state.index() + 1, UNKNOWN);
        }
        match row[state.index()] {
            UNKNOWN => self.work_out(joint, state, goal),
            known => known,
        }
    }

    /// The same, with the [preferred actions](SetAdditive::preferred) of the state.
    pub(super) fn with_preferred(
        &mut self,
        joint: &JointSpace,
        state: StateId,
        goal: usize,
        actions: &mut Vec<Action>,
    ) -> u32 {
        let value = self.work_out(joint, state, goal);
        let problem = joint.problem();
        self.heuristic.preferred(problem.task(), &problem.goals()[goal].condition, actions);
        value
    }

    fn work_out(&mut self, joint: &JointSpace, state: StateId, goal: usize) -> u32 {
        self.worked_out += 1;
        let problem = joint.problem();
        let condition = problem.goals()[goal].condition.as_slice();
        let mut value = [0];
        let words = joint.states().words(state);
        self.heuristic.evaluate(problem.task(), words, &[condition], &mut value);
        let row = &mut self.values[goal];
        if row.len() <= state.index() {
            row.resize(state.index() + 1, UNKNOWN);
        }
        row[state.index()] = value[0];
        value[0]
    }
}
