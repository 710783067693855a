//! How far each candidate goal is from a state, remembered.

use crate::problem::JointSpace;
use crate::task::StateId;

use super::SetAdditive;

/// A state whose values have not been worked out.
const UNKNOWN: u32 = u32::MAX;

/// Values of every candidate goal, for the states that were asked about.
#[derive(Debug, Clone)]
pub struct GoalValues {
    heuristic: SetAdditive,
    goals: usize,
    /// The row of each state.
    rows: Vec<u32>,
    /// Row after row, the value of each goal.
    values: Vec<u32>,
}

impl GoalValues {
    /// No value yet.
    pub fn new(joint: &JointSpace) -> Self {
        let problem = joint.problem();
        Self {
            heuristic: SetAdditive::new(problem.task()),
            goals: problem.goals().len(),
            rows: Vec::new(),
            values: Vec::new(),
        }
    }

    /// Bytes in use, counted by contents.
    pub fn bytes(&self) -> u64 {
        4 * (self.rows.len() + self.values.len()) as u64
    }

    /// The value of each goal in a state.
    pub fn of_state(&mut self, joint: &JointSpace, state: StateId) -> &[u32] {
        if self.rows.len() <= state.index() {
            self.rows.resize(state.index() + 1, UNKNOWN);
        }
        let row = &mut self.rows[state.index()];
        if *row == UNKNOWN {
            *row = (self.values.len() / self.goals) as u32;
            let begin = self.values.len();
            self.values.resize(begin + self.goals, 0);
            let problem = joint.problem();
            let goals: Vec<_> = problem.goals().iter().map(|g| g.condition.as_slice()).collect();
            let words = joint.states().words(state);
            self.heuristic.evaluate(problem.task(), words, &goals, &mut self.values[begin..]);
        }
        &self.values[*row as usize * self.goals..][..self.goals]
    }
}
