//! Interned beliefs of one observer, with a remembered update.

use std::hash::{BuildHasher, BuildHasherDefault};
use std::sync::Arc;

use hashbrown::HashTable;
use rustc_hash::FxHasher;

use super::memo::Memo;
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

/// How many states are expanded between two looks at the memory.
const STATES_BETWEEN_CHECKS: usize = 256;

/// The beliefs of one observer met so far. States are numbered by a [`StateSpace`] that all
/// observers of a problem share and that is handed to each call.
#[derive(Debug, Clone)]
pub struct BeliefSpace {
    sensor: Arc<Sensor>,
    /// The symbol on each edge of the state space, in the same order.
    readings: Vec<Symbol>,
    members: Vec<StateId>,
    ends: Vec<usize>,
    table: HashTable<u32>,
    memo: Memo,
    stamps: Vec<u32>,
    stamp: u32,
}

fn hash(members: &[StateId]) -> u64 {
    BuildHasherDefault::<FxHasher>::default().hash_one(members)
}

fn slice<'a>(members: &'a [StateId], ends: &[usize], id: u32) -> &'a [StateId] {
    let begin = id.checked_sub(1).map_or(0, |before| ends[before as usize]);
    &members[begin..ends[id as usize]]
}

impl BeliefSpace {
    /// No belief yet.
    pub fn new(sensor: Arc<Sensor>) -> Self {
        let memo = Memo::new(sensor.symbol_count());
        Self {
            sensor,
            readings: Vec::new(),
            members: Vec::new(),
            ends: Vec::new(),
            table: HashTable::new(),
            memo,
            stamps: Vec::new(),
            stamp: 0,
        }
    }

    /// The sensor these beliefs follow.
    pub fn sensor(&self) -> &Sensor {
        &self.sensor
    }

    /// How many beliefs have been met.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether no belief has been met.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// Bytes in use, counted by contents.
    pub fn bytes(&self) -> u64 {
        let per_edge = size_of::<Symbol>() * self.readings.len();
        let per_member = size_of::<StateId>() * (self.members.len() + self.stamps.len());
        (per_edge + per_member + 16 * self.ends.len()) as u64 + self.memo.bytes()
    }

    /// The states of a belief, in the order of their numbers.
    pub fn members(&self, belief: BeliefId) -> &[StateId] {
        slice(&self.members, &self.ends, belief.0)
    }

    /// The number of the belief with these states, in any order, given one when it is new.
    pub fn intern(&mut self, mut states: Vec<StateId>) -> BeliefId {
        states.sort_unstable();
        states.dedup();
        let (members, ends) = (&self.members, &self.ends);
        let entry = self.table.entry(
            hash(&states),
            |&id| slice(members, ends, id) == states,
            |&id| hash(slice(members, ends, id)),
        );
        match entry {
            hashbrown::hash_table::Entry::Occupied(known) => BeliefId(*known.get()),
            hashbrown::hash_table::Entry::Vacant(vacant) => {
                let id = ends.len() as u32;
                vacant.insert(id);
                self.members.extend_from_slice(&states);
                self.ends.push(self.members.len());
                BeliefId(id)
            }
        }
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
        if let Some(known) = self.memo.get(belief.0, symbol.0) {
            return Ok(BeliefId(known));
        }
        let members = self.members(belief).to_vec();
        for (count, &state) in members.iter().enumerate() {
            if count % STATES_BETWEEN_CHECKS == 0 {
                limits.check_bytes(states.bytes() + self.bytes())?;
            }
            states.expand(state);
        }
        self.read_new_edges(states);
        self.stamps.resize(states.len(), 0);
        self.stamp += 1;
        let mut next = Vec::new();
        for &state in &members {
            let range = states.edge_range(state);
            for (edge, &reading) in states.edges(state).iter().zip(&self.readings[range]) {
                let stamp = &mut self.stamps[edge.target.index()];
                if reading == symbol && *stamp != self.stamp {
                    *stamp = self.stamp;
                    next.push(edge.target);
                }
            }
        }
        let next = self.intern(next);
        self.memo.set(belief.0, symbol.0, next.0);
        Ok(next)
    }
}
