//! How soon an observer can be freed of a doubt.
//!
//! A goal dies for an observer when no believed state can be led along the plan to it any more. Ask
//! for less: that each believed s̄ alone cannot. Whatever is seen, s̄ may go on in several ways, and
//! each must fail, if need be along a plan of its own: a least fixed point over pairs of states.
//! It asks for less than a plan must do, so the most steps over a belief bound from below how long a
//! plan must still be for the goal to die.

use super::steps::{Step, Steps};
use super::twins::{NEVER, Twins};
use crate::solver::live::Live;
use crate::task::StateId;

/// A pair that has no steps yet.
const UNKNOWN: u16 = u16::MAX;
/// Beyond so many steps nothing is told apart.
const MOST_STEPS: usize = UNKNOWN as usize - 1;

/// The least steps after which the plan may end with the goal dead.
#[derive(Debug)]
pub(in crate::solver::exact) struct Doubts {
    states: usize,
    /// By pair, counted from 1: the place of its steps. 0 for pairs of which the other state cannot
    /// be led to the goal anyhow.
    places: Vec<u32>,
    steps: Vec<u16>,
}

/// The pairs that may get their steps, by steps.
#[derive(Debug, Default)]
struct Queue(Vec<Vec<u32>>);

impl Queue {
    fn push(&mut self, steps: usize, place: usize) {
        let steps = steps.min(MOST_STEPS);
        if self.0.len() <= steps {
            self.0.resize_with(steps + 1, Vec::new);
        }
        self.0[steps].push(place as u32);
    }
}

impl Doubts {
    /// Works out all pairs. `twins` is complete and for the same goal; `is_goal` is about the true
    /// goal, `is_other` about the goal that should die.
    pub(in crate::solver::exact) fn new(
        seen: &Steps,
        twins: &Twins,
        live: &Live,
        is_goal: impl Fn(u32) -> bool,
        is_other: impl Fn(u32) -> bool,
    ) -> Self {
        let states = seen.states();
        let distance = |state: u32| live.distance(StateId(state));
        let split = |pair: u32| (pair / states as u32, pair % states as u32);
        let pair_of = |state: u32, other: u32| state as usize * states + other as usize;
        let pairs = twins.reached();
        let mut places = vec![0; states * states];
        for (place, &pair) in pairs.iter().enumerate() {
            places[pair as usize] = place as u32 + 1;
        }
        // For each pair and each transition out of the actor's state: how many ways the other state
        // has to go along that have not failed yet.
        let mut begins = Vec::with_capacity(pairs.len());
        let mut left: Vec<u32> = Vec::new();
        let mut queue = Queue::default();
        for (place, &pair) in pairs.iter().enumerate() {
            let (state, other) = split(pair);
            if is_goal(state) && !is_other(other) {
                queue.push(0, place);
            }
            begins.push(left.len());
            let begin = left.len();
            for &group in seen.out.of(state) {
                let along = seen.out.with_symbol(other, group.symbol);
                for step in seen.out.steps(group) {
                    let open = |o: &&Step| places[pair_of(step.state, o.state)] != 0;
                    let open = along.iter().filter(open).count();
                    left.resize(left.len().max(begin + step.place as usize + 1), 0);
                    left[begin + step.place as usize] = open as u32;
                    if open == 0
                        && let Some(rest) = distance(step.state)
                    {
                        queue.push(rest + 1, place);
                    }
                }
            }
        }
        let mut steps = vec![UNKNOWN; pairs.len()];
        let mut now = 0;
        while now < queue.0.len() {
            // Those that come at the same number of steps are added to the end meanwhile.
            let mut next = 0;
            while let Some(&place) = queue.0[now].get(next) {
                next += 1;
                if steps[place as usize] != UNKNOWN {
                    continue;
                }
                steps[place as usize] = now as u16;
                let (state, other) = split(pairs[place as usize]);
                let Some(rest) = distance(state) else { continue };
                for &group in seen.into.of(state) {
                    let others = seen.into.with_symbol(other, group.symbol);
                    for before in seen.into.steps(group) {
                        for other in others {
                            // What leads to a pair that can be reached can be reached.
                            let before_pair = places[pair_of(before.state, other.state)] as usize;
                            let Some(place) = before_pair.checked_sub(1) else { continue };
                            let open = &mut left[begins[place] + before.place as usize];
                            *open -= 1;
                            if *open == 0 {
                                queue.push(now.max(rest) + 1, place);
                            }
                        }
                    }
                }
            }
            now += 1;
        }
        Self { states, places, steps }
    }

    /// The most steps of any believed state. `distance` is that of the actor's state to the true
    /// goal.
    pub(in crate::solver::exact) fn most(
        &self,
        state: StateId,
        believed: &[StateId],
        distance: u32,
    ) -> u32 {
        let row = &self.places[state.index() * self.states..][..self.states];
        let mut most = distance;
        for other in believed {
            if let Some(place) = row[other.index()].checked_sub(1) {
                match self.steps[place as usize] {
                    UNKNOWN => return NEVER,
                    steps => most = most.max(u32::from(steps)),
                }
            }
        }
        most
    }

    /// Whether the other state can be led to the goal while the actor goes to the true one.
    pub(in crate::solver::exact) fn leads(&self, state: StateId, other: StateId) -> bool {
        self.places[state.index() * self.states + other.index()] != 0
    }

    /// Bytes in use, counted by contents.
    pub(in crate::solver::exact) fn bytes(&self) -> u64 {
        4 * self.places.len() as u64 + 2 * self.steps.len() as u64
    }
}
