//! Walkers: for one candidate goal, walks that show one observer what it sees of the plan.
//!
//! A beam holds the states nearest to the goal in which such walks end, each a member of the observer's belief. What follows
//! on a beam and a symbol is worked out once, so plans that begin alike share their beams.

use rustc_hash::{FxHashMap, FxHashSet};

use super::estimates::GoalEstimates;
use crate::heuristic::UNREACHABLE;
use crate::problem::JointSpace;
use crate::sensor::Symbol;
use crate::task::{Action, StateId};

/// States met after a beam for each that is kept, at most: the nearest are expanded first.
const MET_FOR_EACH_KEPT: usize = 2;

/// A state of a beam: its estimate, the place of the state before it, and the action between.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Place {
    value: u32,
    state: StateId,
    before: u32,
    action: Action,
}

/// The beams of one observer and goal.
#[derive(Debug)]
pub(super) struct Walkers {
    observer: usize,
    goal: usize,
    /// States of a beam, at most.
    width: usize,
    /// Each with the one before; the first is its own.
    beams: Vec<(u32, Box<[Place]>)>,
    steps: FxHashMap<(u32, Symbol), u32>,
    places: usize,
}

impl Walkers {
    /// The first beam, with number 0, is of the states that the observer holds possible at first.
    pub(super) fn new(
        joint: &mut JointSpace,
        estimates: &mut GoalEstimates,
        (observer, goal): (usize, usize),
        width: usize,
    ) -> Self {
        let states = joint.believed_at_first(observer, goal);
        let place = |state: StateId| Place {
            value: estimates.of_state(joint, state, goal),
            state,
            before: 0,
            action: Action::new(0),
        };
        let first = nearest(states.into_iter().map(place).collect(), width);
        let places = first.len();
        Self { observer, goal, width, beams: vec![(0, first)], steps: FxHashMap::default(), places }
    }

    /// Bytes in use, counted by contents.
    pub(super) fn bytes(&self) -> u64 {
        let own = 24 * self.beams.len() + 24 * self.steps.len();
        (own + size_of::<Place>() * self.places) as u64
    }

    /// The goal.
    pub(super) fn goal(&self) -> usize {
        self.goal
    }

    /// How far the goal is from the nearest of the states that the observer holds possible at first.
    pub(super) fn distance(&self) -> u32 {
        self.beams[0].1.first().map_or(UNREACHABLE, |place| place.value)
    }

    /// The beam after a symbol.
    fn follow(
        &mut self,
        joint: &mut JointSpace,
        estimates: &mut GoalEstimates,
        beam: u32,
        symbol: Symbol,
    ) -> u32 {
        if let Some(&known) = self.steps.get(&(beam, symbol)) {
            return known;
        }
        let mut met = FxHashSet::default();
        let mut found = Vec::new();
        for (before, place) in (0..).zip(&self.beams[beam as usize].1) {
            if found.len() >= MET_FOR_EACH_KEPT * self.width {
                break;
            }
            joint.states_mut().expand(place.state);
            for edge in joint.states().edge_range(place.state) {
                let taken = joint.states().all_edges()[edge];
                if joint.symbol(self.observer, edge) == symbol && met.insert(taken.target) {
                    let value = estimates.of_state(joint, taken.target, self.goal);
                    let (state, action) = (taken.target, taken.action);
                    found.push(Place { value, state, before, action });
                }
            }
        }
        let next = nearest(found, self.width);
        let number = self.beams.len() as u32;
        self.places += next.len();
        self.beams.push((beam, next));
        self.steps.insert((beam, symbol), number);
        number
    }

    /// A walk that shows the observer these symbols and ends in the goal: the state it begins in, and its actions.
    pub(super) fn walk(
        &mut self,
        joint: &mut JointSpace,
        estimates: &mut GoalEstimates,
        seen: &[Symbol],
    ) -> Option<(StateId, Vec<Action>)> {
        let mut at = 0;
        for &symbol in seen {
            at = self.follow(joint, estimates, at, symbol);
        }
        let mut place = *self.beams[at as usize].1.first().filter(|place| place.value == 0)?;
        let mut actions = Vec::with_capacity(seen.len());
        while at != 0 {
            actions.push(place.action);
            at = self.beams[at as usize].0;
            place = self.beams[at as usize].1[place.before as usize];
        }
        actions.reverse();
        Some((place.state, actions))
    }
}

/// The nearest of some places from which the goal can be reached, nearest first.
fn nearest(mut found: Vec<Place>, width: usize) -> Box<[Place]> {
    found.retain(|place| place.value != UNREACHABLE);
    found.sort_unstable();
    found.truncate(width);
    found.into_boxed_slice()
}
