//! The space the actor really plans in: its state together with what every observer believes.
//!
//! A *profile* holds one belief for each observer. Profiles are interned as beliefs are, and the
//! profile that follows from a profile and the symbols of a step is remembered too, so that a
//! transition met before costs one look-up, however many observers there are.

use std::cell::RefCell;
use std::sync::Arc;

use super::combinations::CombinationNumbers;
use super::tuples::Tuples;
use super::{Problem, SurvivorCounts};
use crate::belief::{BeliefId, BeliefSpace, Keep, StateSets, TransitionTable};
use crate::goal_difference::{GoalSet, Survivors};
use crate::limits::{LimitReached, Limits};
use crate::sensor::Symbol;
use crate::task::{Action, StateId, StateSpace};

/// A profile met in a [`JointSpace`], by its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ProfileId(pub(crate) u32);

impl ProfileId {
    /// Its number, from 0 in the order of discovery.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// The actor's state and the observers' profile.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Node {
    /// Where the actor is.
    pub state: StateId,
    /// What the observers believe.
    pub profile: ProfileId,
}

/// States, beliefs and profiles of one problem, as met so far.
#[derive(Debug, Clone)]
pub struct JointSpace {
    problem: Arc<Problem>,
    limits: Limits,
    states: StateSpace,
    beliefs: Vec<BeliefSpace>,
    profiles: Tuples,
    /// The number of the combination of symbols on each edge.
    combinations: Vec<u32>,
    numbers: CombinationNumbers,
    transitions: TransitionTable,
    survivors: Survivors,
    counts: Vec<Option<SurvivorCounts>>,
    initial: Option<Node>,
    scratch: Vec<u32>,
}

impl JointSpace {
    /// The empty space of a problem in which every belief is listed, for which an observer's initial belief has to fit into
    /// the memory.
    pub fn listing(problem: Arc<Problem>, limits: Limits) -> Self {
        Self::new(problem, limits.with_listed(usize::MAX))
    }

    /// Checks that the initial beliefs can be listed.
    ///
    /// # Errors
    ///
    /// [`LimitReached::Memory`] where one has more states than the memory holds.
    pub fn check_lists(&mut self) -> Result<(), LimitReached> {
        let profile = self.initial().profile;
        for (observer, beliefs) in self.beliefs.iter().enumerate() {
            if beliefs.members(self.belief(profile, observer)).listed().is_none() {
                self.limits.check_bytes(u64::MAX)?;
            }
        }
        Ok(())
    }

    /// The empty space of a problem; `limits` say how many states of a belief are listed.
    pub fn new(problem: Arc<Problem>, limits: Limits) -> Self {
        let states = StateSpace::new(Arc::clone(problem.task()));
        let beliefs: Vec<BeliefSpace> = problem
            .observers()
            .iter()
            .map(|observer| BeliefSpace::new(problem.task(), Arc::clone(&observer.sensor), &limits))
            .collect();
        let combinations = beliefs
            .iter()
            .try_fold(1_usize, |product, space| product.checked_mul(space.sensor().symbol_count()))
            .unwrap_or(usize::MAX);
        let symbols = beliefs.iter().map(|space| space.sensor().symbol_count());
        let numbers = CombinationNumbers::new(combinations, symbols);
        let goals = problem.goals().iter().map(|goal| goal.condition.clone()).collect();
        Self {
            limits,
            states,
            profiles: Tuples::new(beliefs.len()),
            combinations: Vec::new(),
            numbers,
            transitions: TransitionTable::new(combinations),
            survivors: Survivors::new(goals, beliefs.len()),
            counts: Vec::new(),
            initial: None,
            scratch: Vec::new(),
            beliefs,
            problem,
        }
    }

    /// Follows samples of one observer's beliefs in place of the beliefs.
    pub(crate) fn sample(&mut self, observer: usize, keep: Arc<dyn Keep>) {
        self.beliefs[observer].sample(keep);
    }

    /// From now on a belief that outgrows its list is more than memory allows.
    pub(crate) fn keep_listed(&mut self) {
        self.beliefs.iter_mut().for_each(BeliefSpace::keep_listed);
    }

    /// Whether a belief has outgrown its list.
    pub(crate) fn has_unlisted(&self) -> bool {
        self.beliefs.iter().any(BeliefSpace::has_unlisted)
    }

    /// The problem.
    pub fn problem(&self) -> &Arc<Problem> {
        &self.problem
    }

    /// The limits in force.
    pub fn limits(&self) -> &Limits {
        &self.limits
    }

    /// The states met so far.
    pub fn states(&self) -> &StateSpace {
        &self.states
    }

    /// The states met so far, to expand more of them.
    pub fn states_mut(&mut self) -> &mut StateSpace {
        &mut self.states
    }

    /// The beliefs of the observer at a position.
    pub fn beliefs(&self, observer: usize) -> &BeliefSpace {
        &self.beliefs[observer]
    }

    /// Bytes in use, counted by contents.
    pub fn bytes(&self) -> u64 {
        let own =
            4 * self.combinations.len() + size_of::<Option<SurvivorCounts>>() * self.counts.len();
        let beliefs: u64 = self.beliefs.iter().map(BeliefSpace::bytes).sum();
        self.states.bytes()
            + beliefs
            + own as u64
            + self.profiles.bytes()
            + self.transitions.bytes()
    }

    /// The initial state with the initial beliefs.
    pub fn initial(&mut self) -> Node {
        if let Some(known) = self.initial {
            return known;
        }
        let problem = Arc::clone(&self.problem);
        let state = self.states.intern(problem.task().initial_state());
        let mut profile = Vec::with_capacity(self.beliefs.len());
        for (observer, beliefs) in problem.observers().iter().zip(&mut self.beliefs) {
            let goals = problem.goals().iter().map(|goal| &*goal.condition);
            let believed = &observer.initial_belief;
            profile.push(beliefs.initial(&mut self.states, believed, goals, &self.limits).0);
        }
        let initial = Node { state, profile: ProfileId(self.profiles.intern(&profile)) };
        self.initial = Some(initial);
        initial
    }

    /// The states that an observer holds possible at first: all of them where they are listed, else some, and states in which
    /// a goal holds among them.
    pub(crate) fn believed_at_first(&mut self, observer: usize, goal: usize) -> Vec<StateId> {
        let problem = Arc::clone(&self.problem);
        let believed = &problem.observers()[observer].initial_belief;
        let condition = &*problem.goals()[goal].condition;
        let some = believed.some_states([condition].into_iter());
        let mut list: Vec<StateId> = some.iter().map(|state| self.states.intern(state)).collect();
        list.sort_unstable();
        list.dedup();
        list
    }

    /// The profile with these beliefs, one for each observer.
    pub fn profile(&mut self, beliefs: impl IntoIterator<Item = BeliefId>) -> ProfileId {
        self.scratch.clear();
        self.scratch.extend(beliefs.into_iter().map(|belief| belief.0));
        ProfileId(self.profiles.intern(&self.scratch))
    }

    /// The number of the belief of one observer with these states, all met before.
    pub(crate) fn intern_belief(&mut self, observer: usize, states: Vec<StateId>) -> BeliefId {
        self.beliefs[observer].intern(&self.states, states, &self.limits)
    }

    /// At most so many states of a belief, spread over it evenly.
    pub(crate) fn some_members(
        &mut self,
        observer: usize,
        belief: BeliefId,
        most: usize,
    ) -> Vec<StateId> {
        self.beliefs[observer].some_members(&mut self.states, belief, most)
    }

    /// The belief of one observer in a profile.
    pub fn belief(&self, profile: ProfileId, observer: usize) -> BeliefId {
        BeliefId(self.profiles.get(profile.0)[observer])
    }

    /// The symbol one observer sees on an edge, by the edge's position in the state space.
    pub fn symbol(&mut self, observer: usize, edge: usize) -> Symbol {
        self.beliefs[observer].reading(&self.states, edge)
    }

    /// The belief of one observer after a symbol.
    ///
    /// # Errors
    ///
    /// The memory limit.
    pub fn update(
        &mut self,
        observer: usize,
        belief: BeliefId,
        symbol: Symbol,
    ) -> Result<BeliefId, LimitReached> {
        self.beliefs[observer].update(&mut self.states, belief, symbol, &self.limits)
    }

    /// Numbers the combinations of symbols on edges that are new.
    fn combine_new_edges(&mut self) {
        for edge in self.combinations.len()..self.states.edge_count() {
            self.scratch.clear();
            for beliefs in &mut self.beliefs {
                self.scratch.push(beliefs.reading(&self.states, edge).0);
            }
            let number = self.numbers.number(&self.scratch);
            self.combinations.push(number);
        }
    }

    /// The profile that follows on the symbols of a combination.
    fn follow(&mut self, profile: ProfileId, combination: u32) -> Result<ProfileId, LimitReached> {
        if let Some(known) = self.transitions.get(profile.0, combination) {
            return Ok(ProfileId(known));
        }
        let mut next = Vec::with_capacity(self.beliefs.len());
        for (observer, beliefs) in self.beliefs.iter_mut().enumerate() {
            let belief = BeliefId(self.profiles.get(profile.0)[observer]);
            let symbol = self.numbers.symbol(combination, observer);
            next.push(beliefs.update(&mut self.states, belief, symbol, &self.limits)?.0);
        }
        let next = self.profiles.intern(&next);
        self.transitions.set(profile.0, combination, next);
        Ok(ProfileId(next))
    }

    /// Writes the actions and nodes that follow a node into `found`, by operator, for the resulting
    /// states that `keep` wants.
    ///
    /// # Errors
    ///
    /// The memory limit.
    pub fn expand(
        &mut self,
        node: Node,
        keep: impl Fn(StateId) -> bool,
        found: &mut Vec<(Action, Node)>,
    ) -> Result<(), LimitReached> {
        found.clear();
        self.states.expand(node.state);
        self.combine_new_edges();
        for edge in self.states.edge_range(node.state) {
            let taken = self.states.all_edges()[edge];
            if keep(taken.target) {
                let profile = self.follow(node.profile, self.combinations[edge])?;
                found.push((taken.action, Node { state: taken.target, profile }));
            }
        }
        Ok(())
    }

    /// Works out the beliefs after every symbol for all observers of a profile, each in one pass.
    ///
    /// # Errors
    ///
    /// The memory limit.
    pub(crate) fn update_all(&mut self, profile: ProfileId) -> Result<(), LimitReached> {
        for (observer, beliefs) in self.beliefs.iter_mut().enumerate() {
            let belief = BeliefId(self.profiles.get(profile.0)[observer]);
            beliefs.update_all(&mut self.states, belief, &self.limits)?;
        }
        self.combine_new_edges();
        Ok(())
    }

    /// The profile after the symbols of a transition, by its position.
    ///
    /// # Errors
    ///
    /// The memory limit.
    pub(crate) fn profile_after(
        &mut self,
        profile: ProfileId,
        edge: usize,
    ) -> Result<ProfileId, LimitReached> {
        self.combine_new_edges();
        self.follow(profile, self.combinations[edge])
    }

    /// The profile after the symbols of a combination.
    ///
    /// # Errors
    ///
    /// The memory limit.
    pub(crate) fn profile_after_combination(
        &mut self,
        profile: ProfileId,
        combination: u32,
    ) -> Result<ProfileId, LimitReached> {
        self.follow(profile, combination)
    }

    /// The combinations of symbols that occur on transitions out of a set of states, with the sets they lead to. The states
    /// of a list are expanded before.
    ///
    /// # Errors
    ///
    /// The memory limit.
    pub(crate) fn word_images(
        &mut self,
        words: &mut StateSets,
        set: BeliefId,
        found: &mut Vec<(u32, BeliefId)>,
    ) -> Result<(), LimitReached> {
        self.combine_new_edges();
        let Self { problem, limits, states, combinations, numbers, .. } = self;
        let numbers = RefCell::new(numbers);
        let relations = || numbers.borrow_mut().relations(problem);
        words.images(states, set, |edge| combinations[edge], limits, relations, found)
    }

    /// A state of a set from which a transition with a combination of symbols leads to a state, and its action.
    pub(crate) fn word_predecessor(
        &mut self,
        words: &StateSets,
        set: BeliefId,
        combination: u32,
        target: StateId,
    ) -> Option<(StateId, Action)> {
        self.combine_new_edges();
        let combinations = &self.combinations;
        let label = |edge: usize| combinations[edge];
        let state = words.predecessor(&mut self.states, set, combination, target, label)?;
        self.states.expand(state);
        self.combine_new_edges();
        let fits = |edge: &usize| {
            self.combinations[*edge] == combination
                && self.states.all_edges()[*edge].target == target
        };
        let edge = self.states.edge_range(state).find(fits)?;
        Some((state, self.states.all_edges()[edge].action))
    }

    /// Whether the true goal holds in a state.
    pub fn is_goal(&mut self, state: StateId) -> bool {
        let goal = self.problem.true_goal();
        self.survivors.of_state(&self.states, state).contains(goal)
    }

    /// The goals a state satisfies.
    pub fn goals_of_state(&mut self, state: StateId) -> &GoalSet {
        self.survivors.of_state(&self.states, state)
    }

    /// The goals that survive in a belief of one observer.
    pub fn survivors(&mut self, observer: usize, belief: BeliefId) -> &GoalSet {
        self.survivors.of_belief(&self.states, observer, &self.beliefs[observer], belief)
    }

    /// The goals that survive for each observer in a profile.
    pub fn survivor_sets(&mut self, profile: ProfileId) -> Vec<GoalSet> {
        let observers = 0..self.beliefs.len();
        observers.map(|i| self.survivors(i, self.belief(profile, i)).clone()).collect()
    }

    /// How many goals survive for each side in a profile. Remembered.
    pub fn counts(&mut self, profile: ProfileId) -> SurvivorCounts {
        if let Some(Some(counts)) = self.counts.get(profile.index()) {
            return *counts;
        }
        let sets = self.survivor_sets(profile);
        let counts = self.problem.survivor_counts(&sets);
        let needed = self.counts.len().max(profile.index() + 1);
        self.counts.resize(needed, None);
        self.counts[profile.index()] = Some(counts);
        counts
    }
}
