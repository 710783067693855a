//! How soon a goal can survive for an observer who takes one state for another.
//!
//! Walk two states at once, the actor's s and another one s̄, by transitions that look the same to
//! the observer: the twin plant of Jiang, Huang, Chandra and Kumar (2001, "A polynomial algorithm
//! for testing diagnosability of discrete-event systems", doi:10.1109/9.940942). A goal survives a
//! plan exactly when some believed s̄ can be led along it to a state that satisfies the goal. So the
//! least number of steps from (s, s̄) to (true goal, goal), and of these the least over a belief,
//! bounds from below how long a plan must still be for the goal to survive; where there are none,
//! it is lost.

use super::steps::{Step, Steps};
use crate::task::StateId;

/// There is no such plan.
pub(in crate::solver::exact) const NEVER: u32 = u32::MAX;
/// A pair that has not been reached.
const UNKNOWN: u16 = u16::MAX;
/// Beyond so many steps nothing is told apart.
const MOST_STEPS: u32 = UNKNOWN as u32 - 2;

/// The least steps of all pairs, found backwards from the goals as far as is asked for.
#[derive(Debug, Default)]
pub(in crate::solver::exact) struct Twins {
    states: usize,
    /// By pair: the actor's state times the number of states, plus the other state.
    least: Vec<u16>,
    /// The pairs reached, by steps, and the next one to go on from.
    reached: Vec<u32>,
    next: usize,
    /// All pairs with so few steps are known.
    depth: u32,
}

impl Twins {
    /// Knows the pairs of a state that satisfies the true goal and one that satisfies the other.
    pub(in crate::solver::exact) fn new(states: usize, true_goal: &[u32], goal: &[u32]) -> Self {
        let mut twins = Self {
            states,
            least: vec![UNKNOWN; states * states],
            reached: Vec::new(),
            next: 0,
            depth: 0,
        };
        for &state in true_goal {
            for &other in goal {
                let pair = state as usize * states + other as usize;
                twins.least[pair] = 0;
                twins.reached.push(pair as u32);
            }
        }
        twins
    }

    /// Whether every pair that can be reached is known.
    pub(in crate::solver::exact) fn complete(&self) -> bool {
        self.next == self.reached.len()
    }

    /// Makes sure that all pairs with at most so many steps are known.
    pub(in crate::solver::exact) fn extend(&mut self, steps: &Steps, until: u32) {
        let until = until.min(MOST_STEPS);
        while let Some(&pair) = self.reached.get(self.next) {
            let least = self.least[pair as usize];
            if u32::from(least) >= until {
                break;
            }
            self.next += 1;
            let (state, other) = (pair / self.states as u32, pair % self.states as u32);
            // Both in the order of their symbols.
            let mut others = steps.into.of(other);
            for &group in steps.into.of(state) {
                while let Some((first, rest)) = others.split_first()
                    && first.symbol < group.symbol
                {
                    others = rest;
                }
                let Some(&same) = others.first() else { break };
                if same.symbol == group.symbol {
                    self.reach(steps.into.steps(group), steps.into.steps(same), least + 1);
                }
            }
        }
        self.depth = self.depth.max(until);
    }

    /// Gives so many steps to the pairs of these states that have none yet.
    fn reach(&mut self, states: &[Step], others: &[Step], least: u16) {
        for before in states {
            let row = before.state * self.states as u32;
            for other in others {
                let pair = row + other.state;
                let known = &mut self.least[pair as usize];
                if *known == UNKNOWN {
                    *known = least;
                    self.reached.push(pair);
                }
            }
        }
    }

    /// The fewest steps of any believed state, or more than are known.
    pub(in crate::solver::exact) fn least(&self, state: StateId, believed: &[StateId]) -> u32 {
        if self.least.is_empty() {
            return NEVER;
        }
        let row = &self.least[state.index() * self.states..][..self.states];
        let least = believed.iter().map(|other| row[other.index()]).min().unwrap_or(UNKNOWN);
        match least {
            UNKNOWN if self.complete() => NEVER,
            UNKNOWN => self.depth + 1,
            known => u32::from(known),
        }
    }

    /// Whether the two states can be led to the goals at once, as far as is known.
    pub(in crate::solver::exact) fn leads(&self, state: StateId, other: StateId) -> bool {
        self.least[state.index() * self.states + other.index()] != UNKNOWN
    }

    /// The pairs reached so far.
    pub(in crate::solver::exact) fn reached(&self) -> &[u32] {
        &self.reached
    }

    /// Bytes in use, counted by contents.
    pub(in crate::solver::exact) fn bytes(&self) -> u64 {
        2 * self.least.len() as u64 + 4 * self.reached.len() as u64
    }
}
