//! Interned beliefs of one observer, with a remembered update.

use std::sync::Arc;

use fixedbitset::FixedBitSet;

use super::subsets::{Subsets, Successor};
use super::transition_table::TransitionTable;
use crate::limits::{LimitReached, Limits};
use crate::sensor::{Sensor, Symbol};
use crate::task::{StateId, StateSpace};

/// A belief met in a [`BeliefSpace`], by its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BeliefId(pub(crate) u32);

impl BeliefId {
    /// Its number, from 0 in the order of discovery.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// The beliefs of one observer met so far. States are numbered by a [`StateSpace`] that all
/// observers of a problem share and that is handed to each call.
#[derive(Debug, Clone)]
pub struct BeliefSpace {
    sensor: Arc<Sensor>,
    /// The symbol on each edge of the state space, in the same order.
    readings: Vec<Symbol>,
    sets: Subsets,
    transitions: TransitionTable,
    /// Which beliefs have all their updates remembered.
    updated: FixedBitSet,
    successors: Vec<Successor>,
}

impl BeliefSpace {
    /// No belief yet.
    pub fn new(sensor: Arc<Sensor>) -> Self {
        let transitions = TransitionTable::new(sensor.symbol_count());
        Self {
            sensor,
            readings: Vec::new(),
            sets: Subsets::default(),
            transitions,
            updated: FixedBitSet::new(),
            successors: Vec::new(),
        }
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

    /// The states of a belief, in the order of their numbers.
    pub fn members(&self, belief: BeliefId) -> &[StateId] {
        self.sets.members(belief)
    }

    /// The number of the belief with these states, in any order, given one when it is new.
    pub fn intern(&mut self, states: Vec<StateId>) -> BeliefId {
        self.sets.intern(states)
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
        let readings = &self.readings;
        let next = self.sets.image(states, belief, symbol.0, |edge| readings[edge].0);
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
        if self.updated.contains(belief.index()) {
            return Ok(());
        }
        self.expand_members(states, belief, limits)?;
        let mut found = std::mem::take(&mut self.successors);
        let readings = &self.readings;
        self.sets.images(states, belief, |edge| readings[edge].0, &mut found);
        for next in &found {
            self.transitions.set(belief.0, next.label, next.set.0);
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
