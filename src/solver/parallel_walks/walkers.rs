//! Walkers: for one candidate goal, walks that show one observer what it sees of the plan.
//!
//! A beam holds the states nearest to the goal in which such walks end, each a member of the observer's belief, and the state
//! of the plan itself, where the goal can still be reached from it: a walk can leave the plan at every step, so beams do not
//! run empty where the nearest states have nothing to do that looks like the plan's next action. What follows on a beam and a
//! transition of the plan is worked out once, so plans that begin alike share their beams.

use rustc_hash::{FxHashMap, FxHashSet};

use super::estimates::GoalEstimates;
use crate::heuristic::UNREACHABLE;
use crate::problem::JointSpace;
use crate::sensor::Symbol;
use crate::solver::ground::thresholds::MET_FOR_EACH_KEPT;
use crate::task::{Action, StateId};

/// A state of a beam: its estimate, the place of the state before it, and the action between.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Place {
    value: u32,
    state: StateId,
    before: u32,
    action: Action,
}

/// States that walks have come to, the nearest first.
#[derive(Debug)]
struct Beam {
    /// The number of the beam before; the first is its own.
    before: u32,
    places: Box<[Place]>,
    /// Which of them is the state of the plan.
    of_plan: Option<u32>,
}

/// The beams of one observer and goal.
#[derive(Debug)]
pub(super) struct Walkers {
    observer: usize,
    goal: usize,
    /// States of a beam, at most.
    width: usize,
    beams: Vec<Beam>,
    /// By beam, symbol and next state of the plan.
    steps: FxHashMap<(u32, Symbol, StateId), u32>,
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
        let mut states = joint.believed_at_first(observer, goal);
        let root = joint.initial().state;
        if !states.contains(&root) {
            states.push(root);
        }
        let place = |state: StateId| Place {
            value: estimates.of_state(joint, state, goal),
            state,
            before: 0,
            action: Action::new(0),
        };
        let places = states.into_iter().map(place).collect();
        let first = Beam::nearest(0, places, width, root);
        let places = first.places.len();
        Self { observer, goal, width, beams: vec![first], steps: FxHashMap::default(), places }
    }

    /// Bytes in use, counted by contents.
    pub(super) fn bytes(&self) -> u64 {
        let own = 32 * self.beams.len() + 24 * self.steps.len();
        (own + size_of::<Place>() * self.places) as u64
    }

    /// The goal.
    pub(super) fn goal(&self) -> usize {
        self.goal
    }

    /// How far the goal is from the nearest of the states that the observer holds possible at first.
    pub(super) fn distance(&self) -> u32 {
        self.beams[0].places.first().map_or(UNREACHABLE, |place| place.value)
    }

    /// The beam after a transition of the plan.
    fn follow(
        &mut self,
        joint: &mut JointSpace,
        estimates: &mut GoalEstimates,
        beam: u32,
        edge: usize,
    ) -> u32 {
        let symbol = joint.symbol(self.observer, edge);
        let of_plan = joint.states().all_edges()[edge];
        if let Some(&known) = self.steps.get(&(beam, symbol, of_plan.target)) {
            return known;
        }
        let mut met = FxHashSet::default();
        let mut found = Vec::new();
        let at = &self.beams[beam as usize];
        if let Some(before) = at.of_plan {
            met.insert(of_plan.target);
            let value = estimates.of_state(joint, of_plan.target, self.goal);
            found.push(Place { value, state: of_plan.target, before, action: of_plan.action });
        }
        for (before, place) in (0..).zip(&at.places) {
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
        let next = Beam::nearest(beam, found, self.width, of_plan.target);
        let number = self.beams.len() as u32;
        self.places += next.places.len();
        self.beams.push(next);
        self.steps.insert((beam, symbol, of_plan.target), number);
        number
    }

    /// A walk that shows the observer the same as a plan with these transitions and ends in the goal: the state it begins in,
    /// and its actions.
    pub(super) fn walk(
        &mut self,
        joint: &mut JointSpace,
        estimates: &mut GoalEstimates,
        plan: &[usize],
    ) -> Option<(StateId, Vec<Action>)> {
        let mut at = 0;
        for &edge in plan {
            at = self.follow(joint, estimates, at, edge);
        }
        let nearest = self.beams[at as usize].places.first();
        let mut place = *nearest.filter(|place| place.value == 0)?;
        let mut actions = Vec::with_capacity(plan.len());
        while at != 0 {
            actions.push(place.action);
            at = self.beams[at as usize].before;
            place = self.beams[at as usize].places[place.before as usize];
        }
        actions.reverse();
        Some((place.state, actions))
    }
}

impl Beam {
    /// The nearest of some places from which the goal can be reached, and that of the plan.
    fn nearest(before: u32, mut found: Vec<Place>, width: usize, of_plan: StateId) -> Self {
        found.retain(|place| place.value != UNREACHABLE);
        found.sort_unstable();
        let is_of_plan = |place: &Place| place.state == of_plan;
        let mut position = found.iter().position(is_of_plan);
        if let Some(behind) = position.filter(|position| *position >= width) {
            found.swap(width, behind);
            position = Some(width);
        }
        found.truncate(width.max(position.map_or(0, |position| position + 1)));
        Self { before, places: found.into_boxed_slice(), of_plan: position.map(|p| p as u32) }
    }
}
