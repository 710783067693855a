//! The nodes a search has met, each with the action and the node that led to it.

use std::hash::{BuildHasher, BuildHasherDefault, Hash};

use hashbrown::HashTable;
use hashbrown::hash_table::Entry;
use rustc_hash::FxHasher;

use crate::plan::Plan;
use crate::task::Action;

#[derive(Debug, Clone, Copy)]
struct Met<K> {
    key: K,
    parent: u32,
    action: Action,
}

/// Nodes by their positions, in the order in which they were met. The first is the root.
#[derive(Debug, Clone)]
pub(in crate::solver) struct SearchTree<K> {
    nodes: Vec<Met<K>>,
    table: HashTable<u32>,
}

impl<K: Copy + Eq + Hash> SearchTree<K> {
    /// A tree of one node.
    pub(in crate::solver) fn new(root: K) -> Self {
        let mut tree = Self { nodes: Vec::new(), table: HashTable::new() };
        tree.meet(root, 0, Action::new(0));
        tree
    }

    /// The position of a node that has not been met before; none for one that has.
    pub(in crate::solver) fn meet(
        &mut self,
        key: K,
        parent: usize,
        action: Action,
    ) -> Option<usize> {
        let known = self.nodes.len();
        let position = self.number(key, parent, action);
        (position == known).then_some(position)
    }

    /// The position of a node, whether it has been met before or not.
    pub(in crate::solver) fn number(&mut self, key: K, parent: usize, action: Action) -> usize {
        let hash = |key: &K| BuildHasherDefault::<FxHasher>::default().hash_one(key);
        let nodes = &self.nodes;
        let entry = self.table.entry(
            hash(&key),
            |&other| nodes[other as usize].key == key,
            |&other| hash(&nodes[other as usize].key),
        );
        match entry {
            Entry::Occupied(known) => *known.get() as usize,
            Entry::Vacant(vacant) => {
                let position = self.nodes.len();
                vacant.insert(position as u32);
                self.nodes.push(Met { key, parent: parent as u32, action });
                position
            }
        }
    }

    /// How many nodes have been met.
    pub(in crate::solver) fn len(&self) -> usize {
        self.nodes.len()
    }

    /// The node at a position.
    pub(in crate::solver) fn key(&self, position: usize) -> K {
        self.nodes[position].key
    }

    /// The actions from the root to a node.
    pub(in crate::solver) fn plan(&self, mut position: usize) -> Plan {
        let mut actions = Vec::new();
        while position != 0 {
            let met = &self.nodes[position];
            actions.push(met.action);
            position = met.parent as usize;
        }
        actions.reverse();
        Plan { actions }
    }

    /// Bytes in use, counted by contents.
    pub(in crate::solver) fn bytes(&self) -> u64 {
        (size_of::<Met<K>>() * self.nodes.len() + 5 * self.table.len()) as u64
    }
}
