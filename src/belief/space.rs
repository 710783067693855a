//! Interned beliefs of one observer, with a remembered update.

use std::sync::Arc;

use fixedbitset::FixedBitSet;

use super::diagram::SymbolRelations;
use super::initial_belief::InitialBelief;
use super::state_sets::{Members, StateSets};
use super::transition_table::TransitionTable;
use crate::limits::{LimitReached, Limits};
use crate::sensor::{Sensor, Symbol};
use crate::task::{Fact, StateId, StateSpace, Task};

/// A belief met in a [`BeliefSpace`], by its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BeliefId(pub(crate) u32);

impl BeliefId {
    /// Its number, from 0 in the order of discovery.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// What is kept of a belief of which only a sample is followed.
pub trait Keep: std::fmt::Debug + Send + Sync {
    /// Leaves out states until few enough are left. The choice depends on the states alone.
    fn keep(&self, states: &StateSpace, found: &mut Vec<StateId>);
}

/// The beliefs of one observer met so far. States are numbered by a [`StateSpace`] that all
/// observers of a problem share and that is handed to each call.
#[derive(Debug, Clone)]
pub struct BeliefSpace {
    sensor: Arc<Sensor>,
    /// The symbol on each edge of the state space, in the same order.
    readings: Vec<Symbol>,
    sets: StateSets,
    transitions: TransitionTable,
    /// Which beliefs have all their updates remembered.
    updated: FixedBitSet,
    successors: Vec<(u32, BeliefId)>,
    /// Where samples are followed in place of beliefs: each state of a sample is in the belief, as in a beam search.
    sampling: Option<Arc<dyn Keep>>,
}

impl BeliefSpace {
    /// No belief yet, of the states of a task; `limits` say how many states of a belief are listed.
    pub fn new(task: &Task, sensor: Arc<Sensor>, limits: &Limits) -> Self {
        let transitions = TransitionTable::new(sensor.symbol_count());
        Self {
            sensor,
            readings: Vec::new(),
            sets: StateSets::new(task, limits),
            transitions,
            updated: FixedBitSet::new(),
            successors: Vec::new(),
            sampling: None,
        }
    }

    /// From now on samples are followed in place of beliefs.
    pub(crate) fn sample(&mut self, keep: Arc<dyn Keep>) {
        self.sampling = Some(keep);
    }

    /// From now on a belief that outgrows its list is more than memory allows.
    pub(crate) fn keep_listed(&mut self) {
        self.sets.keep_listed();
    }

    /// Whether a belief has outgrown its list.
    pub(crate) fn has_unlisted(&self) -> bool {
        self.sets.has_unlisted()
    }

    /// The sensor these beliefs follow.
    pub fn sensor(&self) -> &Sensor {
        &self.sensor
    }

    /// How many beliefs have been met.
    pub fn len(&self) -> usize {
        self.sets.len()
    }

    /// Bytes in use, counted by contents.
    pub fn bytes(&self) -> u64 {
        let readings = size_of::<Symbol>() * self.readings.len();
        readings as u64 + self.sets.bytes() + self.transitions.bytes()
    }

    /// The states of a belief.
    pub fn members(&self, belief: BeliefId) -> Members<'_> {
        self.sets.members(belief)
    }

    /// The states of a belief one by one, in the order of their numbers; none of one that is not listed, which is never so
    /// where `limits` set no bound on lists.
    pub fn list(&self, belief: BeliefId) -> &[StateId] {
        self.sets.members(belief).listed().unwrap_or_default()
    }

    /// At most so many states of a belief, spread over it evenly.
    pub fn some_members(
        &self,
        states: &mut StateSpace,
        belief: BeliefId,
        most: usize,
    ) -> Vec<StateId> {
        self.sets.some_members(states, belief, most)
    }

    /// The number of the belief with these states, in any order, given one when it is new.
    pub fn intern(
        &mut self,
        states: &StateSpace,
        mut list: Vec<StateId>,
        limits: &Limits,
    ) -> BeliefId {
        if let Some(keep) = &self.sampling {
            list.sort_unstable();
            list.dedup();
            keep.keep(states, &mut list);
        }
        let sensor = &self.sensor;
        self.sets.intern(states, list, limits, || SymbolRelations::new(states.task(), sensor))
    }

    /// The number of the initial belief. Where samples are followed they have states in which each of the conditions holds,
    /// if there are any.
    pub(crate) fn initial<'a>(
        &mut self,
        states: &mut StateSpace,
        believed: &InitialBelief,
        conditions: impl Iterator<Item = &'a [Fact]>,
        limits: &Limits,
    ) -> BeliefId {
        let Some((diagrams, set)) = believed.diagram().filter(|_| self.sampling.is_none()) else {
            let some = believed.some_states(conditions);
            let list = some.iter().map(|state| states.intern(state)).collect();
            return self.intern(states, list, limits);
        };
        let sensor = &self.sensor;
        let task = Arc::clone(states.task());
        self.sets.adopt(states, diagrams, set, limits, || SymbolRelations::new(&task, sensor))
    }

    /// The symbol on an edge of the state space, by the edge's position there.
    pub fn reading(&mut self, states: &StateSpace, edge: usize) -> Symbol {
        self.read_new_edges(states);
        self.readings[edge]
    }

    fn read_new_edges(&mut self, states: &StateSpace) {
        let task = states.task();
        for edge in &states.all_edges()[self.readings.len()..] {
            self.readings.push(self.sensor.read(task, edge.operator, states.words(edge.target)));
        }
    }

    /// The belief after a symbol. Empty when nothing the belief holds possible gives that symbol,
    /// which cannot happen on the symbols of a plan.
    ///
    /// Linear in the transitions out of the belief the first time, constant afterwards.
    ///
    /// # Errors
    ///
    /// [`LimitReached::Memory`] when states and beliefs outgrow `limits`; the states expanded so
    /// far are kept, no belief is half made.
    pub fn update(
        &mut self,
        states: &mut StateSpace,
        belief: BeliefId,
        symbol: Symbol,
        limits: &Limits,
    ) -> Result<BeliefId, LimitReached> {
        if let Some(known) = self.transitions.get(belief.0, symbol.0) {
            return Ok(BeliefId(known));
        }
        self.expand_members(states, belief, limits)?;
        if self.sampling.is_some() {
            let mut next = Vec::new();
            for &state in self.list(belief) {
                for edge in states.edge_range(state) {
                    if self.readings[edge] == symbol {
                        next.push(states.all_edges()[edge].target);
                    }
                }
            }
            let next = self.intern(states, next, limits);
            self.transitions.set(belief.0, symbol.0, next.0);
            return Ok(next);
        }
        let (readings, sensor) = (&self.readings, &self.sensor);
        let task = Arc::clone(states.task());
        let next = self.sets.image(
            states,
            belief,
            symbol.0,
            |edge| readings[edge].0,
            limits,
            || SymbolRelations::new(&task, sensor),
        )?;
        self.transitions.set(belief.0, symbol.0, next.0);
        Ok(next)
    }

    /// Works out and remembers the beliefs after every symbol that a belief can give, in one pass.
    ///
    /// # Errors
    ///
    /// As [`update`](Self::update).
    pub fn update_all(
        &mut self,
        states: &mut StateSpace,
        belief: BeliefId,
        limits: &Limits,
    ) -> Result<(), LimitReached> {
        // The updates of a diagram or a sample are worked out one by one, as they are asked for.
        let one_by_one = self.sampling.is_some() || self.members(belief).listed().is_none();
        if one_by_one || self.updated.contains(belief.index()) {
            return Ok(());
        }
        self.expand_members(states, belief, limits)?;
        let mut found = std::mem::take(&mut self.successors);
        let (readings, sensor) = (&self.readings, &self.sensor);
        let task = Arc::clone(states.task());
        self.sets.images(
            states,
            belief,
            |edge| readings[edge].0,
            limits,
            || SymbolRelations::new(&task, sensor),
            &mut found,
        )?;
        for (symbol, next) in &found {
            self.transitions.set(belief.0, *symbol, next.0);
        }
        self.successors = found;
        self.updated.grow_and_insert(belief.index());
        Ok(())
    }

    fn expand_members(
        &mut self,
        states: &mut StateSpace,
        belief: BeliefId,
        limits: &Limits,
    ) -> Result<(), LimitReached> {
        let own = self.bytes() - self.sets.bytes();
        self.sets.expand_members(states, belief, limits, own)?;
        self.read_new_edges(states);
        Ok(())
    }
}
