//! The bound by observable classes and by blocks that are always believed together.
//!
//! *Classes*: the finest partition of the states that holds the initial belief in one class and is
//! closed under "equal symbols lead to equal classes". By induction an observer's belief lies in one
//! class, that of the actor's state: so for an enemy no goal survives but those met in the class of
//! the final state. Parities and diagonals of a grid are such classes.
//!
//! *Blocks*: the coarsest partition in which two states of a block begin believed together or not at
//! all and are led to from the same blocks by the same symbols, a backward bisimulation (compare
//! Mohajerani, Lafortune and Fabian 2018, arXiv:1802.03321, on abstractions that preserve opacity).
//! By induction a belief holds a block as a whole or not at all: so for a friend every goal survives
//! that is met in the block of the final state.
//!
//! The bound is the greatest difference of the two over the states in which a plan may end. Both
//! partitions take a pass over the transitions, the blocks one for each round of refinement.

use rustc_hash::FxHashMap;

use super::listing::{Listing, Seen};
use super::{Bound, Most};
use crate::goal_difference::GoalSet;
use crate::limits::LimitReached;
use crate::problem::Role;
use crate::solver::ground::thresholds::TRANSITIONS_OF_BLOCKS;
use crate::solver::optimiser::space::Space;
use crate::task::StateId;

/// The bound.
#[derive(Debug)]
pub(in crate::solver::optimiser) struct Classes {
    /// States listed, at most.
    pub most_states: usize,
}

/// Merges of states, closed under equal symbols.
#[derive(Debug)]
struct Partition {
    above: Vec<u32>,
    /// Where a symbol leads from a class, by its representative.
    next: FxHashMap<(u32, u32), u32>,
    symbols: Vec<Vec<u32>>,
}

impl Partition {
    fn find(&mut self, state: u32) -> u32 {
        let mut class = state;
        while self.above[class as usize] != class {
            let above = self.above[self.above[class as usize] as usize];
            self.above[class as usize] = above;
            class = above;
        }
        class
    }

    /// Puts two states into one class, and what that entails.
    fn merge(&mut self, one: u32, other: u32) {
        let mut open = vec![(one, other)];
        while let Some((one, other)) = open.pop() {
            let (kept, gone) = (self.find(one), self.find(other));
            if kept == gone {
                continue;
            }
            self.above[gone as usize] = kept;
            for symbol in std::mem::take(&mut self.symbols[gone as usize]) {
                let Some(led) = self.next.remove(&(gone, symbol)) else { continue };
                if let Some(&known) = self.next.get(&(kept, symbol)) {
                    open.push((known, led));
                } else {
                    self.next.insert((kept, symbol), led);
                    self.symbols[kept as usize].push(symbol);
                }
            }
        }
    }

    /// Makes a symbol lead from the class of one state to that of another.
    fn lead(&mut self, seen: Seen) {
        let class = self.find(seen.from);
        if let Some(&known) = self.next.get(&(class, seen.symbol)) {
            self.merge(known, seen.to);
        } else {
            self.next.insert((class, seen.symbol), seen.to);
            self.symbols[class as usize].push(seen.symbol);
        }
    }
}

/// The observable class of each state, as the number of one of its states.
pub(super) fn observable_classes(states: usize, seen: &[Seen], believed: &[StateId]) -> Vec<u32> {
    let mut partition = Partition {
        above: (0..states as u32).collect(),
        next: FxHashMap::default(),
        symbols: vec![Vec::new(); states],
    };
    for &transition in seen {
        partition.lead(transition);
    }
    for pair in believed.windows(2) {
        partition.merge(pair[0].0, pair[1].0);
    }
    (0..states as u32).map(|state| partition.find(state)).collect()
}

/// The block of each state; none where refinement takes too many rounds.
fn believed_blocks(states: usize, seen: &[Seen], believed: &[StateId]) -> Option<Vec<u32>> {
    let mut blocks = vec![0_u32; states];
    for state in believed {
        blocks[state.index()] = 1;
    }
    let mut into: Vec<Vec<(u32, u32)>> = vec![Vec::new(); states];
    for transition in seen {
        into[transition.to as usize].push((transition.symbol, transition.from));
    }
    let mut count = 0;
    for _ in 0..TRANSITIONS_OF_BLOCKS / seen.len().max(1) {
        let mut numbers: FxHashMap<(u32, Vec<(u32, u32)>), u32> = FxHashMap::default();
        let mut next = Vec::with_capacity(states);
        for (state, sources) in into.iter().enumerate() {
            let led = sources.iter().map(|&(symbol, from)| (symbol, blocks[from as usize]));
            let mut signature: Vec<(u32, u32)> = led.collect();
            signature.sort_unstable();
            signature.dedup();
            let number = numbers.len() as u32;
            next.push(*numbers.entry((blocks[state], signature)).or_insert(number));
        }
        blocks = next;
        if numbers.len() == count {
            return Some(blocks);
        }
        count = numbers.len();
    }
    None
}

/// The goals met in each part of a partition, by the part of a state.
fn goals_of_parts(listing: &Listing, parts: &[u32]) -> Vec<GoalSet> {
    let count = parts.iter().max().map_or(0, |most| *most as usize + 1);
    let mut sets = vec![GoalSet::none(listing.by_goal.len()); count];
    for (goal, states) in listing.by_goal.iter().enumerate() {
        for &state in states {
            sets[parts[state as usize] as usize].insert(goal);
        }
    }
    sets
}

impl Bound for Classes {
    fn name(&self) -> &'static str {
        "observable classes"
    }

    fn most(&mut self, space: &mut Space) -> Result<Most, LimitReached> {
        let problem = std::sync::Arc::clone(space.problem());
        let Some(listing) = Listing::new(&mut space.joint, self.most_states)? else {
            return Ok(Most::Unaffordable);
        };
        let root = space.joint.initial();
        let true_goal = problem.true_goal();
        // By observer: the part of each state, and the goals met there.
        let mut parts: Vec<Option<(Vec<u32>, Vec<GoalSet>)>> = Vec::new();
        for (observer, watched) in problem.observers().iter().enumerate() {
            let seen = listing.seen_by(&mut space.joint, observer);
            let belief = space.joint.belief(root.profile, observer);
            let Some(believed) = space.joint.beliefs(observer).members(belief).listed() else {
                return Ok(Most::Unaffordable);
            };
            let part = match watched.role {
                Role::Adversarial => Some(observable_classes(listing.states, &seen, believed)),
                Role::Cooperative => believed_blocks(listing.states, &seen, believed),
            };
            parts.push(part.map(|part| {
                let goals = goals_of_parts(&listing, &part);
                (part, goals)
            }));
        }
        let mut most: Option<i64> = None;
        for &state in &listing.by_goal[true_goal] {
            if !listing.reached[state as usize] {
                continue;
            }
            let (mut enemies, mut friends) = (problem.goals().len(), 1);
            let mut allowed = true;
            for (observer, watched) in problem.observers().iter().enumerate() {
                let Some((part, goals)) = &parts[observer] else { continue };
                let met = &goals[part[state as usize] as usize];
                let named = |list: &'_ [crate::solver::Watched]| -> Vec<usize> {
                    list.iter().filter(|w| w.observer == observer).map(|w| w.goal).collect()
                };
                let (required, mut forbidden) =
                    (named(&space.bounds.required), named(&space.bounds.forbidden));
                forbidden.sort_unstable();
                forbidden.dedup();
                match watched.role {
                    Role::Adversarial => {
                        allowed &= required.iter().all(|goal| met.contains(*goal));
                        let lost = forbidden.iter().filter(|goal| met.contains(**goal)).count();
                        enemies = enemies.min(met.len() - lost);
                    }
                    Role::Cooperative => {
                        allowed &= !forbidden.iter().any(|goal| met.contains(*goal));
                        let mut left = met.clone();
                        for goal in required {
                            left.insert(goal);
                        }
                        friends = friends.max(left.len());
                    }
                }
            }
            allowed &= space.bounds.at_least.is_none_or(|k| enemies >= k)
                && space.bounds.at_most.is_none_or(|j| friends <= j);
            if allowed {
                let value = enemies as i64 - friends as i64;
                most = Some(most.map_or(value, |known| known.max(value)));
            }
        }
        Ok(most.map_or(Most::Infeasible, Most::Value))
    }
}
