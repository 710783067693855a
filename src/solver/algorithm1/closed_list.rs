//! The closed list of Algorithm 1: states with combinations of approximate beliefs.
//!
//! `approx` returns a belief of at most Δ states that contains the true state. Our reading of the
//! paper's "unique Δ-sized combinations": among the Δ-subsets of each belief that contain the true
//! state, in a fixed order, take the first combination over all observers that is not closed yet.
//! Subsets are ordered by the positions of their members in the belief, lexicographically and from
//! the last on to the first, and the last observer's subset changes fastest. Each node begins at a
//! place of its own, as keys do in a hash table: did all begin at the first combination, thousands
//! of nodes of one state would each pass over all that the others have taken.

use rustc_hash::FxHashSet;

use crate::problem::{JointSpace, Node};
use crate::solver::ground::thresholds::STATES_OF_A_SUBSET;
use crate::task::StateId;

/// The closed combinations of a search.
#[derive(Debug)]
pub(super) struct ClosedList {
    /// Δ.
    size: usize,
    closed: FxHashSet<Box<[u32]>>,
    bytes: u64,
}

/// Goes through the Δ-subsets of a belief that contain one state.
#[derive(Debug)]
struct Subsets<'a> {
    members: &'a [StateId],
    /// The position of the state that is always in.
    truth: usize,
    /// Which of the others are in, counted without it.
    chosen: Vec<usize>,
    /// Where it began.
    start: Vec<usize>,
}

impl<'a> Subsets<'a> {
    /// Begins at a place that `seed` chooses; what is left of it chooses for the next observer.
    fn new(members: &'a [StateId], truth: StateId, size: usize, seed: &mut usize) -> Self {
        let truth = members.binary_search(&truth).unwrap_or(members.len());
        let count = (size - 1).min(members.len() - 1);
        let places = members.len() - count;
        let begin = *seed % places;
        *seed /= places;
        let start: Vec<usize> = (begin..begin + count).collect();
        Self { members, truth, chosen: start.clone(), start }
    }

    fn chosen(&self) -> impl Iterator<Item = u32> + '_ {
        self.chosen.iter().map(|&other| self.members[other + usize::from(other >= self.truth)].0)
    }

    /// Moves to the next subset; false when that is where it began.
    fn step(&mut self) -> bool {
        self.advance();
        self.chosen != self.start
    }

    fn advance(&mut self) {
        let count = self.chosen.len();
        let room = self.members.len() - 1 - count;
        let place = (0..count).rev().find(|&place| self.chosen[place] < room + place);
        let Some(place) = place else {
            self.chosen = (0..count).collect();
            return;
        };
        self.chosen[place] += 1;
        for next in place + 1..count {
            self.chosen[next] = self.chosen[next - 1] + 1;
        }
    }
}

impl ClosedList {
    pub(super) fn new() -> Self {
        Self { size: 1, closed: FxHashSet::default(), bytes: 0 }
    }

    /// Δ.
    pub(super) fn size(&self) -> usize {
        self.size
    }

    /// Raises Δ by one.
    pub(super) fn grow(&mut self) {
        self.size += 1;
    }

    /// Bytes in use, counted by contents.
    pub(super) fn bytes(&self) -> u64 {
        self.bytes
    }

    /// Closes the one combination that a node has in the first round, for which its beliefs need not
    /// be known; false when it is closed.
    pub(super) fn close_state(&mut self, state: StateId, observers: usize, stage: u32) -> bool {
        let mut key = vec![0; 2 + observers];
        key[..2].copy_from_slice(&[state.0, stage]);
        let bytes = 4 * key.len() as u64 + 24;
        let new = self.closed.insert(key.into_boxed_slice());
        self.bytes += if new { bytes } else { 0 };
        new
    }

    /// Closes the first combination that is open for a node; false when there is none.
    pub(super) fn close(&mut self, joint: &mut JointSpace, node: Node, stage: u32) -> bool {
        let observers = joint.problem().observers().len();
        // Of beliefs that are not listed some states stand for all.
        let samples: Vec<Option<Vec<StateId>>> = (0..observers)
            .map(|observer| {
                let belief = joint.belief(node.profile, observer);
                if joint.beliefs(observer).members(belief).listed().is_some() {
                    return None;
                }
                let mut sample = joint.some_members(observer, belief, STATES_OF_A_SUBSET);
                sample.push(node.state);
                sample.sort_unstable();
                sample.dedup();
                Some(sample)
            })
            .collect();
        let mut seed = node.profile.index();
        let mut subsets: Vec<Subsets<'_>> = (0..observers)
            .map(|observer| {
                let belief = joint.belief(node.profile, observer);
                let members = match &samples[observer] {
                    Some(sample) => sample,
                    None => joint.beliefs(observer).list(belief),
                };
                Subsets::new(members, node.state, self.size, &mut seed)
            })
            .collect();
        // Nodes differ in their whole beliefs, even where an earlier round has closed the same
        // states as a part of larger ones.
        let whole = subsets.iter().all(|subset| subset.members.len() <= self.size);
        let mut key = Vec::new();
        loop {
            key.clear();
            key.extend([node.state.0, stage]);
            for subset in &subsets {
                // The number of members keeps one observer's from running into the next one's.
                key.push(subset.chosen.len() as u32);
                key.extend(subset.chosen());
            }
            if whole || !self.closed.contains(key.as_slice()) {
                self.bytes += 4 * key.len() as u64 + 24;
                self.closed.insert(key.into_boxed_slice());
                return true;
            }
            // Like an odometer: the last one that does not start again moves.
            let moved = subsets.iter_mut().rev().any(Subsets::step);
            if !moved {
                return false;
            }
        }
    }
}
