//! Ground atoms by numbers.

use std::hash::{BuildHasher, BuildHasherDefault};

use hashbrown::HashTable;
use hashbrown::hash_table::Entry;
use rustc_hash::FxHasher;

use super::atom::Atom;
use super::object::ObjectId;
use super::predicate::PredicateId;

/// Ground atoms, numbered in the order in which they come.
#[derive(Debug, Clone)]
pub(super) struct AtomTable {
    /// The predicate of each atom, and where its objects begin.
    heads: Vec<(PredicateId, u32)>,
    objects: Vec<ObjectId>,
    table: HashTable<u32>,
}

fn hash(predicate: PredicateId, objects: &[ObjectId]) -> u64 {
    BuildHasherDefault::<FxHasher>::default().hash_one((predicate, objects))
}

fn row<'a>(
    heads: &[(PredicateId, u32)],
    objects: &'a [ObjectId],
    atom: u32,
) -> (PredicateId, &'a [ObjectId]) {
    let (predicate, begin) = heads[atom as usize];
    let end = heads.get(atom as usize + 1).map_or(objects.len(), |(_, end)| *end as usize);
    (predicate, &objects[begin as usize..end])
}

impl AtomTable {
    pub(super) fn new() -> Self {
        Self { heads: Vec::new(), objects: Vec::new(), table: HashTable::new() }
    }

    /// How many atoms there are.
    pub(super) fn len(&self) -> usize {
        self.heads.len()
    }

    /// The predicate and the objects of an atom.
    pub(super) fn get(&self, atom: u32) -> (PredicateId, &[ObjectId]) {
        row(&self.heads, &self.objects, atom)
    }

    /// The number of an atom that is there.
    pub(super) fn find(&self, predicate: PredicateId, objects: &[ObjectId]) -> Option<u32> {
        let same = |&atom: &u32| self.get(atom) == (predicate, objects);
        self.table.find(hash(predicate, objects), same).copied()
    }

    /// The number of an atom that is there.
    pub(super) fn find_atom(&self, atom: &Atom) -> Option<u32> {
        self.find(atom.predicate, &atom.objects)
    }

    /// The number of an atom, given one when it is new.
    pub(super) fn intern(&mut self, predicate: PredicateId, objects: &[ObjectId]) -> u32 {
        let (heads, all) = (&self.heads, &self.objects);
        let entry = self.table.entry(
            hash(predicate, objects),
            |&atom| row(heads, all, atom) == (predicate, objects),
            |&atom| {
                let (predicate, objects) = row(heads, all, atom);
                hash(predicate, objects)
            },
        );
        match entry {
            Entry::Occupied(known) => *known.get(),
            Entry::Vacant(vacant) => {
                let atom = self.heads.len() as u32;
                vacant.insert(atom);
                self.heads.push((predicate, self.objects.len() as u32));
                self.objects.extend_from_slice(objects);
                atom
            }
        }
    }
}
