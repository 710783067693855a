//! Interned sets of states, and the subset construction over labelled transitions.
//!
//! A transition carries one label: the symbol of one sensor, or the number of a combination of
//! symbols. The sets that words of labels lead to are the states of the determinised automaton
//! (Rabin and Scott 1959, doi:10.1147/rd.32.0114).

use std::hash::{BuildHasher, BuildHasherDefault};

use hashbrown::HashTable;
use rustc_hash::FxHasher;

use super::BeliefId;
use crate::limits::{LimitReached, Limits};
use crate::task::{StateId, StateSpace};

/// How many states are expanded between two looks at the memory.
const STATES_BETWEEN_CHECKS: usize = 256;

/// A list longer than this part of the numbers it may hold is put in order through a bit for each
/// of them, a shorter one by sorting.
const SPARSE: usize = 256;

/// The states that one label leads to from a set.
#[derive(Debug, Clone, Default)]
struct Image {
    label: u32,
    targets: Vec<StateId>,
}

/// A label that occurs on transitions out of a set, with the set it leads to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Successor {
    /// The label.
    pub label: u32,
    /// The set of states the label leads to; none where it has more states than are listed.
    pub set: Option<BeliefId>,
}

/// The sets met so far.
#[derive(Debug, Clone, Default)]
pub struct Subsets {
    members: Vec<StateId>,
    ends: Vec<usize>,
    table: HashTable<u32>,
    stamps: Vec<u32>,
    stamp: u32,
    /// One for each label met in an expansion, taken again in the next.
    images: Vec<Image>,
    /// By label: the place of its image in the present expansion, with the stamp of that expansion.
    slots: Vec<(u32, u32)>,
    expansion: u32,
    bits: Vec<u64>,
}

fn hash(members: &[StateId]) -> u64 {
    BuildHasherDefault::<FxHasher>::default().hash_one(members)
}

fn slice<'a>(members: &'a [StateId], ends: &[usize], id: u32) -> &'a [StateId] {
    let begin = id.checked_sub(1).map_or(0, |before| ends[before as usize]);
    &members[begin..ends[id as usize]]
}

impl Subsets {
    /// How many sets have been met.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Bytes in use, counted by contents.
    pub fn bytes(&self) -> u64 {
        let per_member = size_of::<StateId>() * (self.members.len() + self.stamps.len());
        (per_member + 16 * self.ends.len()) as u64
    }

    /// The states of a set, in the order of their numbers.
    pub fn members(&self, set: BeliefId) -> &[StateId] {
        slice(&self.members, &self.ends, set.0)
    }

    /// The number of the set with these states, in any order, given one when it is new.
    pub fn intern(&mut self, mut states: Vec<StateId>) -> BeliefId {
        states.sort_unstable();
        states.dedup();
        self.intern_sorted(&states)
    }

    fn intern_sorted(&mut self, states: &[StateId]) -> BeliefId {
        let (members, ends) = (&self.members, &self.ends);
        let entry = self.table.entry(
            hash(states),
            |&id| slice(members, ends, id) == states,
            |&id| hash(slice(members, ends, id)),
        );
        match entry {
            hashbrown::hash_table::Entry::Occupied(known) => BeliefId(*known.get()),
            hashbrown::hash_table::Entry::Vacant(vacant) => {
                let id = ends.len() as u32;
                vacant.insert(id);
                self.members.extend_from_slice(states);
                self.ends.push(self.members.len());
                BeliefId(id)
            }
        }
    }

    /// Expands the states of a set.
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
        for (count, &state) in self.members(set).iter().enumerate() {
            if count % STATES_BETWEEN_CHECKS == 0 {
                limits.check_bytes(states.bytes() + self.bytes() + other_bytes)?;
            }
            states.expand(state);
        }
        Ok(())
    }

    /// A number for a set that is not listed.
    pub fn reserve(&mut self) -> BeliefId {
        self.ends.push(self.members.len());
        BeliefId(self.ends.len() as u32 - 1)
    }

    /// The set that one label leads to; none where it has more than `most` states. All members are expanded; `label_of`
    /// reads the label of a transition by its position.
    pub fn image(
        &mut self,
        states: &StateSpace,
        set: BeliefId,
        label: u32,
        most: usize,
        label_of: impl Fn(usize) -> u32,
    ) -> Option<BeliefId> {
        self.stamps.resize(states.len(), 0);
        self.stamp += 1;
        let mut next = Vec::new();
        for &state in slice(&self.members, &self.ends, set.0) {
            for edge in states.edge_range(state) {
                let target = states.all_edges()[edge].target;
                let stamp = &mut self.stamps[target.index()];
                if label_of(edge) == label && *stamp != self.stamp {
                    *stamp = self.stamp;
                    next.push(target);
                }
            }
            if next.len() > most {
                return None;
            }
        }
        Some(self.intern(next))
    }

    /// The sets that all labels lead to, by label, into `found`, those of at most `most` states listed. All members are
    /// expanded.
    ///
    /// Linear in the transitions out of the set, but for putting each image in order.
    pub fn images(
        &mut self,
        states: &StateSpace,
        set: BeliefId,
        most: usize,
        label_of: impl Fn(usize) -> u32,
        found: &mut Vec<Successor>,
    ) {
        found.clear();
        self.expansion += 1;
        let mut images = std::mem::take(&mut self.images);
        let mut count = 0;
        for &state in slice(&self.members, &self.ends, set.0) {
            for edge in states.edge_range(state) {
                let label = label_of(edge);
                if self.slots.len() <= label as usize {
                    self.slots.resize(label as usize + 1, (0, 0));
                }
                let slot = &mut self.slots[label as usize];
                if slot.1 != self.expansion {
                    *slot = (count as u32, self.expansion);
                    if images.len() == count {
                        images.push(Image::default());
                    }
                    let image = &mut images[count];
                    image.label = label;
                    image.targets.clear();
                    count += 1;
                }
                images[slot.0 as usize].targets.push(states.all_edges()[edge].target);
            }
        }
        for image in &mut images[..count] {
            self.put_in_order(&mut image.targets, states.len());
            let set = (image.targets.len() <= most).then(|| self.intern_sorted(&image.targets));
            found.push(Successor { label: image.label, set });
        }
        found.sort_unstable_by_key(|successor| successor.label);
        self.images = images;
    }

    /// Sorts states and leaves out those that come twice.
    fn put_in_order(&mut self, list: &mut Vec<StateId>, states: usize) {
        if list.len() < states / SPARSE {
            list.sort_unstable();
            list.dedup();
            return;
        }
        self.bits.resize(states.div_ceil(64), 0);
        for state in list.iter() {
            self.bits[state.index() / 64] |= 1 << (state.index() % 64);
        }
        list.clear();
        for (place, word) in self.bits.iter_mut().enumerate() {
            while *word != 0 {
                list.push(StateId(place as u32 * 64 + word.trailing_zeros()));
                *word &= *word - 1;
            }
        }
    }
}
