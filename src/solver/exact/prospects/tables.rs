//! What can become of each believed state while the actor is on its way.

use rustc_hash::FxHashMap;

use super::hope::Hope;
use crate::belief::BeliefId;
use crate::limits::LimitReached;
use crate::problem::JointSpace;
use crate::solver::exact::guided::doubts::Doubts;
use crate::solver::exact::guided::steps::Steps;
use crate::solver::exact::guided::twins::{NEVER, Twins};
use crate::solver::live::Live;
use crate::task::StateId;

/// What a pair of states takes while the tables of one set of goals are made, at most.
const BYTES_OF_A_PAIR: u64 = 16;

/// Tables over pairs of states, each made when it is asked for first.
#[derive(Debug)]
pub(super) struct Tables {
    pub(super) enemy: usize,
    pub(super) friend: usize,
    seen: [Steps; 2],
    /// The states that satisfy each goal.
    by_goal: Vec<Vec<u32>>,
    true_goal: usize,
    twins: FxHashMap<usize, Twins>,
    doubts: FxHashMap<Vec<usize>, Doubts>,
    /// What is left of a belief in a state, and the fewest actions that a plan must still have.
    alive: FxHashMap<(Vec<usize>, StateId, BeliefId), (BeliefId, u32)>,
    dead: FxHashMap<(Vec<usize>, StateId, BeliefId), (BeliefId, u32)>,
}

impl Tables {
    /// For a space whose states are all expanded.
    pub(super) fn new(joint: &mut JointSpace, enemy: usize, friend: usize) -> Self {
        let mut by_goal = vec![Vec::new(); joint.problem().goals().len()];
        for state in 0..joint.states().len() as u32 {
            for goal in joint.goals_of_state(StateId(state)).iter() {
                by_goal[goal].push(state);
            }
        }
        Self {
            enemy,
            friend,
            seen: [Steps::new(joint, enemy), Steps::new(joint, friend)],
            by_goal,
            true_goal: joint.problem().true_goal(),
            twins: FxHashMap::default(),
            doubts: FxHashMap::default(),
            alive: FxHashMap::default(),
            dead: FxHashMap::default(),
        }
    }

    /// How many pairs of transitions a table goes through.
    pub(super) fn work(&self) -> u64 {
        self.seen.iter().map(Steps::same_looking_pairs).max().unwrap_or(0)
    }

    /// Makes the tables that a hope needs.
    pub(super) fn prepare(
        &mut self,
        joint: &JointSpace,
        live: &Live,
        hope: &Hope,
    ) -> Result<(), LimitReached> {
        let states = self.seen[0].states();
        let room = BYTES_OF_A_PAIR * (states * states) as u64;
        let true_states = &self.by_goal[self.true_goal];
        for &goal in &hope.alive {
            if !self.twins.contains_key(&goal) {
                joint.limits().check_bytes(joint.bytes() + self.bytes() + room)?;
                let mut twins = Twins::new(states, true_states, &self.by_goal[goal]);
                twins.extend(&self.seen[0], NEVER);
                self.twins.insert(goal, twins);
            }
        }
        if !hope.dead.is_empty() && !self.doubts.contains_key(&hope.dead) {
            joint.limits().check_bytes(joint.bytes() + self.bytes() + room)?;
            let mut any: Vec<u32> =
                hope.dead.iter().flat_map(|&goal| self.by_goal[goal].iter().copied()).collect();
            any.sort_unstable();
            any.dedup();
            let mut twins = Twins::new(states, true_states, &any);
            twins.extend(&self.seen[1], NEVER);
            let is_in = |states: &[u32], state: u32| states.binary_search(&state).is_ok();
            let doubts = Doubts::new(
                &self.seen[1],
                &twins,
                live,
                |state| is_in(true_states, state),
                |state| is_in(&any, state),
            );
            self.doubts.insert(hope.dead.clone(), doubts);
        }
        Ok(())
    }

    /// What the enemy's belief is worth in a state: the believed states that can still be led to one
    /// of the goals, and the fewest actions until each goal can survive.
    pub(super) fn alive(
        &mut self,
        joint: &mut JointSpace,
        goals: &[usize],
        state: StateId,
        belief: BeliefId,
    ) -> (BeliefId, u32) {
        let key = (goals.to_vec(), state, belief);
        if let Some(&known) = self.alive.get(&key) {
            return known;
        }
        let members = joint.beliefs(self.enemy).members(belief);
        let tables = goals.iter().map(|goal| &self.twins[goal]);
        let least = tables.clone().map(|table| table.least(state, members)).max().unwrap_or(0);
        let leads = |&&other: &&StateId| tables.clone().any(|table| table.leads(state, other));
        let kept = members.iter().filter(leads).copied().collect();
        let value = (joint.intern_belief(self.enemy, kept), least);
        self.alive.insert(key, value);
        value
    }

    /// What the friend's belief comes to in a state: the believed states that can still be led to
    /// one of the goals, and the fewest actions until none is.
    pub(super) fn dead(
        &mut self,
        joint: &mut JointSpace,
        goals: &[usize],
        state: StateId,
        belief: BeliefId,
        distance: u32,
    ) -> (BeliefId, u32) {
        let key = (goals.to_vec(), state, belief);
        if let Some(&known) = self.dead.get(&key) {
            return known;
        }
        let members = joint.beliefs(self.friend).members(belief);
        let table = self.doubts.get(goals);
        let least = table.map_or(distance, |table| table.most(state, members, distance));
        let leads = |&&other: &&StateId| table.is_some_and(|table| table.leads(state, other));
        let kept = members.iter().filter(leads).copied().collect();
        let value = (joint.intern_belief(self.friend, kept), least);
        self.dead.insert(key, value);
        value
    }

    /// Bytes in use, counted by contents.
    pub(super) fn bytes(&self) -> u64 {
        let twins: u64 = self.twins.values().map(Twins::bytes).sum();
        let doubts: u64 = self.doubts.values().map(Doubts::bytes).sum();
        twins + doubts + 64 * (self.alive.len() + self.dead.len()) as u64
    }
}
