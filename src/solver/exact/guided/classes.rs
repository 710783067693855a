//! A first look at what can survive at all: parities, diagonals and the like.
//!
//! Put states into classes such that each symbol leads from a class to one class only. In the
//! paper's gridworld the enemy, who sees vertical and horizontal moves, has four of them, by the
//! parities of column and row. Two states that walk alike go through their classes alike, so that a
//! few pairs of classes often rule a goal out before any pair of states is looked at.

use rustc_hash::FxHashMap;

use super::steps::Steps;

/// More pairs of classes than this are not gone through.
const MOST_PAIRS: usize = 10_000;

/// Pairs of classes, numbered as they were met.
pub(super) type Pairs = FxHashMap<(u32, u32), u32>;

/// The classes of all states.
#[derive(Debug)]
pub(super) struct Classes {
    /// The class of a state is the state at the end of this chain.
    above: Vec<u32>,
    /// Where a symbol leads from a class.
    next: FxHashMap<(u32, u32), u32>,
    /// The symbols that lead somewhere from a class.
    symbols: Vec<Vec<u32>>,
}

impl Classes {
    /// The finest classes: nothing is put together without need.
    pub(super) fn new(steps: &Steps) -> Self {
        let states = steps.states() as u32;
        let mut classes = Self {
            above: (0..states).collect(),
            next: FxHashMap::default(),
            symbols: vec![Vec::new(); states as usize],
        };
        for state in 0..states {
            for &group in steps.out.of(state) {
                for step in steps.out.steps(group) {
                    classes.lead(state, group.symbol, step.state);
                }
            }
        }
        classes
    }

    fn find(&mut self, state: u32) -> u32 {
        let mut class = state;
        while self.above[class as usize] != class {
            let above = self.above[self.above[class as usize] as usize];
            self.above[class as usize] = above;
            class = above;
        }
        class
    }

    /// Makes a symbol lead from the class of one state to that of the other.
    fn lead(&mut self, from: u32, symbol: u32, to: u32) {
        let mut open = vec![(from, symbol, to)];
        while let Some((from, symbol, to)) = open.pop() {
            let class = self.find(from);
            let Some(&known) = self.next.get(&(class, symbol)) else {
                self.next.insert((class, symbol), to);
                self.symbols[class as usize].push(symbol);
                continue;
            };
            let (kept, gone) = (self.find(known), self.find(to));
            if kept != gone {
                self.above[gone as usize] = kept;
                for symbol in std::mem::take(&mut self.symbols[gone as usize]) {
                    let led = self.next.get(&(gone, symbol)).copied();
                    open.extend(led.map(|to| (kept, symbol, to)));
                }
            }
        }
    }

    /// The pairs of classes that two states can get to at once that begin in one of these pairs;
    /// none where there are too many.
    pub(super) fn pairs(&mut self, begin: impl Iterator<Item = (u32, u32)>) -> Option<Pairs> {
        let mut open: Vec<(u32, u32)> = Vec::new();
        let mut met = Pairs::default();
        for (state, other) in begin {
            self.meet(state, other, &mut met, &mut open);
        }
        while let Some((class, other)) = open.pop() {
            if met.len() > MOST_PAIRS {
                return None;
            }
            for place in 0..self.symbols[class as usize].len() {
                let symbol = self.symbols[class as usize][place];
                let next = |class| self.next.get(&(class, symbol)).copied();
                if let (Some(state), Some(other)) = (next(class), next(other)) {
                    self.meet(state, other, &mut met, &mut open);
                }
            }
        }
        Some(met)
    }

    /// Puts the classes of two states with those met.
    fn meet(&mut self, state: u32, other: u32, met: &mut Pairs, open: &mut Vec<(u32, u32)>) {
        let pair = (self.find(state), self.find(other));
        let number = met.len() as u32;
        if met.insert(pair, number).is_none() {
            open.push(pair);
        }
    }

    /// Whether a state of one list and one of the other are in one of these pairs.
    pub(super) fn hold(&mut self, pairs: &Pairs, states: &[u32], others: &[u32]) -> bool {
        states.iter().any(|&state| {
            let class = self.find(state);
            others.iter().any(|&other| pairs.contains_key(&(class, self.find(other))))
        })
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::domain::gridworld::GridworldShape;
    use crate::problem::JointSpace;
    use crate::task::StateId;

    #[test]
    fn the_enemy_of_a_gridworld_knows_parities_and_the_friend_diagonals() {
        let grid = GridworldShape::default().generate(1).unwrap().document;
        let mut joint =
            JointSpace::new(Arc::new(grid.problem().unwrap()), crate::limits::Limits::default());
        joint.initial();
        let mut next = 0;
        while next < joint.states().len() {
            joint.states_mut().expand(StateId(next as u32));
            next += 1;
        }
        for (observer, count) in [(0, 4), (1, 15)] {
            let mut classes = Classes::new(&Steps::new(&mut joint, observer));
            let all: std::collections::BTreeSet<u32> =
                (0..64).map(|state| classes.find(state)).collect();
            assert_eq!(all.len(), count);
            // In step with itself a state stays in step with itself.
            let pairs = classes.pairs([(0, 0)].into_iter()).unwrap();
            assert!(pairs.keys().all(|(class, other)| class == other));
            assert!(classes.hold(&pairs, &[5], &[5]));
        }
    }
}
