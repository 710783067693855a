//! Interned tuples of numbers.

use std::hash::{BuildHasher, BuildHasherDefault};

use hashbrown::HashTable;
use rustc_hash::FxHasher;

/// Interned tuples of numbers, all of one width.
#[derive(Debug, Clone)]
pub(crate) struct Tuples {
    width: usize,
    items: Vec<u32>,
    table: HashTable<u32>,
    count: u32,
}

impl Tuples {
    /// No tuple of this many numbers yet.
    pub(crate) fn new(width: usize) -> Self {
        Self { width, items: Vec::new(), table: HashTable::new(), count: 0 }
    }

    /// The numbers of a tuple.
    pub(crate) fn get(&self, id: u32) -> &[u32] {
        &self.items[id as usize * self.width..][..self.width]
    }

    /// The number of a tuple, given one when it is new.
    pub(crate) fn intern(&mut self, tuple: &[u32]) -> u32 {
        let hash = |tuple: &[u32]| BuildHasherDefault::<FxHasher>::default().hash_one(tuple);
        let (items, width) = (&self.items, self.width);
        let at = |id: u32| &items[id as usize * width..][..width];
        let entry = self.table.entry(hash(tuple), |&id| at(id) == tuple, |&id| hash(at(id)));
        match entry {
            hashbrown::hash_table::Entry::Occupied(known) => *known.get(),
            hashbrown::hash_table::Entry::Vacant(vacant) => {
                let id = self.count;
                vacant.insert(id);
                self.items.extend_from_slice(tuple);
                self.count += 1;
                id
            }
        }
    }

    /// Bytes in use, counted by contents.
    pub(crate) fn bytes(&self) -> u64 {
        4 * self.items.len() as u64 + 5 * u64::from(self.count)
    }
}
