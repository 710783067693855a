//! Interned sets of states, each in the form that suits it: a list while it is small, a decision diagram where it is large.
//!
//! The form depends on the number of states alone, so that equal sets have equal numbers however they were come by. A
//! list that grows too long is made into a diagram, and a diagram of few states is listed. Diagrams and relations are
//! made when the first set outgrows its list; a problem of small beliefs never pays for them.

use std::sync::Arc;

use fixedbitset::FixedBitSet;
use rustc_hash::FxHashMap;

use super::BeliefId;
use super::diagram::{Diagrams, SetId, SymbolRelations, suits};
use super::subsets::{Subsets, Successor};
use crate::limits::{LimitReached, Limits};
use crate::sensor::Symbol;
use crate::task::{State, StateId, StateSpace, Task};

/// The states of a set.
#[derive(Debug, Clone, Copy)]
pub enum Members<'a> {
    /// In the order of their numbers.
    Listed(&'a [StateId]),
    /// Not one by one.
    Diagram(&'a Diagrams, SetId),
}

impl<'a> Members<'a> {
    /// The states one by one; none of a diagram.
    pub fn listed(self) -> Option<&'a [StateId]> {
        match self {
            Self::Listed(states) => Some(states),
            Self::Diagram(..) => None,
        }
    }
}

/// Sets that are not listed.
#[derive(Debug, Clone)]
struct Unlisted {
    diagrams: Diagrams,
    relations: SymbolRelations,
    /// The diagram of each set that is not listed, and of each list that has grown out of one or into one.
    of_sets: FxHashMap<BeliefId, SetId>,
    numbers: FxHashMap<SetId, BeliefId>,
}

/// The sets of states met so far.
#[derive(Debug, Clone)]
pub struct StateSets {
    lists: Subsets,
    /// The most states of a list.
    most: usize,
    unlisted: Option<Box<Unlisted>>,
    /// Which sets are not listed.
    large: FixedBitSet,
    found: Vec<Successor>,
    /// No set may outgrow its list.
    listed_only: bool,
}

impl StateSets {
    /// No set yet, of the states of a task.
    pub fn new(task: &Task, limits: &Limits) -> Self {
        let most =
            if limits.listed < usize::MAX && suits(task) { limits.listed } else { usize::MAX };
        Self {
            lists: Subsets::default(),
            most: most.max(1),
            unlisted: None,
            large: FixedBitSet::new(),
            found: Vec::new(),
            listed_only: false,
        }
    }

    /// From now on a set that outgrows its list is more than memory allows.
    pub(crate) fn keep_listed(&mut self) {
        self.listed_only = true;
    }

    /// How many sets have been met.
    pub fn len(&self) -> usize {
        self.lists.len()
    }

    /// Bytes in use, counted by contents.
    pub fn bytes(&self) -> u64 {
        let unlisted = self.unlisted.as_ref().map_or(0, |unlisted| unlisted.bytes());
        self.lists.bytes() + unlisted
    }

    /// Whether a set has outgrown its list.
    pub fn has_unlisted(&self) -> bool {
        !self.large.is_empty()
    }

    /// The states of a set.
    pub fn members(&self, set: BeliefId) -> Members<'_> {
        match &self.unlisted {
            Some(unlisted) if self.large.contains(set.index()) => {
                Members::Diagram(&unlisted.diagrams, unlisted.of_sets[&set])
            }
            _ => Members::Listed(self.lists.members(set)),
        }
    }

    /// The number of the set with these states, in any order, given one when it is new. The symbols of relations are the
    /// labels. Where memory is too short for a diagram the set is listed.
    pub fn intern(
        &mut self,
        states: &StateSpace,
        mut list: Vec<StateId>,
        limits: &Limits,
        relations: impl FnOnce() -> SymbolRelations,
    ) -> BeliefId {
        list.sort_unstable();
        list.dedup();
        if list.len() > self.most {
            let unlisted = unlisted(&mut self.unlisted, states, limits, relations);
            if let Ok(diagram) = unlisted.of_list(states, &list) {
                return unlisted.number(diagram, &mut self.lists, &mut self.large);
            }
        }
        self.lists.intern(list)
    }

    /// The number of a set of another store. It is listed where it has few states; where all sets are to be listed, as many
    /// as the memory holds.
    pub(crate) fn adopt(
        &mut self,
        states: &mut StateSpace,
        diagrams: &Diagrams,
        set: SetId,
        limits: &Limits,
        relations: impl FnOnce() -> SymbolRelations,
    ) -> BeliefId {
        let state = size_of_val(states.task().initial_state().words());
        self.most = self.most.min(limits.bytes as usize / state.max(1));
        let unlisted = unlisted(&mut self.unlisted, states, limits, relations);
        let set = unlisted.diagrams.adopt(diagrams, set);
        if unlisted.diagrams.has_more_than(set, self.most) {
            return unlisted.number(set, &mut self.lists, &mut self.large);
        }
        self.list(states, set)
    }

    /// The number of the list of a diagram's states.
    fn list(&mut self, states: &mut StateSpace, diagram: SetId) -> BeliefId {
        let few = self
            .unlisted
            .as_ref()
            .map_or_else(Vec::new, |unlisted| unlisted.diagrams.first_states(diagram, self.most));
        let number = self.lists.intern(few.iter().map(|state| states.intern(state)).collect());
        if let Some(unlisted) = &mut self.unlisted {
            unlisted.numbers.insert(diagram, number);
            unlisted.of_sets.insert(number, diagram);
        }
        number
    }

    /// The number of the set with one state, which is listed whatever the limit.
    pub fn single(&mut self, state: StateId) -> BeliefId {
        self.lists.intern(vec![state])
    }

    /// Expands the states of a list; nothing to do for a diagram.
    ///
    /// # Errors
    ///
    /// [`LimitReached::Memory`]; the states expanded so far are kept.
    pub fn expand_members(
        &self,
        states: &mut StateSpace,
        set: BeliefId,
        limits: &Limits,
        other_bytes: u64,
    ) -> Result<(), LimitReached> {
        let others = other_bytes + self.unlisted.as_ref().map_or(0, |unlisted| unlisted.bytes());
        self.lists.expand_members(states, set, limits, others)
    }

    /// The set that one label leads to. All members of a list are expanded; `label_of` reads the label of a transition by
    /// its position.
    ///
    /// # Errors
    ///
    /// The memory limit.
    pub fn image(
        &mut self,
        states: &mut StateSpace,
        set: BeliefId,
        label: u32,
        label_of: impl Fn(usize) -> u32,
        limits: &Limits,
        relations: impl FnOnce() -> SymbolRelations,
    ) -> Result<BeliefId, LimitReached> {
        if !self.large.contains(set.index())
            && let Some(next) = self.lists.image(states, set, label, self.most, label_of)
        {
            return Ok(next);
        }
        self.diagram_image(states, set, label, limits, relations)
    }

    /// The labels that occur on transitions out of a set, in order, each with the set it leads to, into `found`.
    ///
    /// # Errors
    ///
    /// The memory limit.
    pub fn images(
        &mut self,
        states: &mut StateSpace,
        set: BeliefId,
        label_of: impl Fn(usize) -> u32,
        limits: &Limits,
        relations: impl Fn() -> SymbolRelations,
        found: &mut Vec<(u32, BeliefId)>,
    ) -> Result<(), LimitReached> {
        found.clear();
        if self.large.contains(set.index()) {
            let labels = unlisted(&mut self.unlisted, states, limits, &relations).relations.len();
            for label in 0..labels as u32 {
                let next = self.diagram_image(states, set, label, limits, &relations)?;
                if self.large.contains(next.index()) || !self.lists.members(next).is_empty() {
                    found.push((label, next));
                }
            }
            return Ok(());
        }
        let mut listed = std::mem::take(&mut self.found);
        self.lists.images(states, set, self.most, label_of, &mut listed);
        for next in &listed {
            let to = match next.set {
                Some(to) => to,
                None => self.diagram_image(states, set, next.label, limits, &relations)?,
            };
            found.push((next.label, to));
        }
        self.found = listed;
        Ok(())
    }

    fn diagram_image(
        &mut self,
        states: &mut StateSpace,
        set: BeliefId,
        label: u32,
        limits: &Limits,
        relations: impl FnOnce() -> SymbolRelations,
    ) -> Result<BeliefId, LimitReached> {
        if self.listed_only {
            return Err(LimitReached::Listed { limit: self.most as u64 });
        }
        let unlisted = unlisted(&mut self.unlisted, states, limits, relations);
        let from = match unlisted.of_sets.get(&set) {
            Some(&known) => known,
            None => {
                let diagram = unlisted.of_list(states, self.lists.members(set))?;
                unlisted.of_sets.insert(set, diagram);
                diagram
            }
        };
        let next = unlisted.relations.update(&mut unlisted.diagrams, from, Symbol(label))?;
        if let Some(&known) = unlisted.numbers.get(&next) {
            return Ok(known);
        }
        if unlisted.diagrams.has_more_than(next, self.most) {
            return Ok(unlisted.number(next, &mut self.lists, &mut self.large));
        }
        Ok(self.list(states, next))
    }

    /// At most so many states of a set, spread over it evenly.
    pub fn some_members(
        &self,
        states: &mut StateSpace,
        set: BeliefId,
        most: usize,
    ) -> Vec<StateId> {
        match self.members(set) {
            Members::Listed(list) => {
                let stride = list.len().div_ceil(most).max(1);
                list.iter().copied().step_by(stride).collect()
            }
            Members::Diagram(diagrams, set) => {
                let spread = diagrams.spread_states(set, most);
                spread.iter().map(|state| states.intern(state)).collect()
            }
        }
    }

    /// A state of a set from which a transition with a label leads to a state.
    pub fn predecessor(
        &self,
        states: &mut StateSpace,
        set: BeliefId,
        label: u32,
        target: StateId,
        label_of: impl Fn(usize) -> u32,
    ) -> Option<StateId> {
        match self.members(set) {
            Members::Listed(list) => list.iter().copied().find(|state| {
                states.edge_range(*state).any(|edge| {
                    states.all_edges()[edge].target == target && label_of(edge) == label
                })
            }),
            Members::Diagram(diagrams, set) => {
                let unlisted = self.unlisted.as_ref()?;
                let target = states.state(target);
                let found =
                    unlisted.relations.predecessor(diagrams, set, Symbol(label), &target)?;
                Some(states.intern(&found))
            }
        }
    }
}

/// What is kept of sets that are not listed, made where it is not there.
fn unlisted<'a>(
    place: &'a mut Option<Box<Unlisted>>,
    states: &StateSpace,
    limits: &Limits,
    relations: impl FnOnce() -> SymbolRelations,
) -> &'a mut Unlisted {
    place.get_or_insert_with(|| {
        Box::new(Unlisted {
            diagrams: Diagrams::new(Arc::clone(states.task()), *limits),
            relations: relations(),
            of_sets: FxHashMap::default(),
            numbers: FxHashMap::default(),
        })
    })
}

impl Unlisted {
    fn of_list(&mut self, states: &StateSpace, list: &[StateId]) -> Result<SetId, LimitReached> {
        let list: Vec<State> = list.iter().map(|&state| states.state(state)).collect();
        self.diagrams.of_states(&list)
    }

    /// The number of a diagram with too many states for a list, given one when it is new.
    fn number(&mut self, diagram: SetId, lists: &mut Subsets, large: &mut FixedBitSet) -> BeliefId {
        *self.numbers.entry(diagram).or_insert_with(|| {
            let set = lists.reserve();
            self.of_sets.insert(set, diagram);
            large.grow_and_insert(set.index());
            set
        })
    }

    fn bytes(&self) -> u64 {
        let numbers = 16 * (self.of_sets.len() + self.numbers.len());
        self.diagrams.bytes() + self.relations.bytes() + numbers as u64
    }
}
