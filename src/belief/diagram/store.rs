//! The nodes of decision diagrams, interned, and the set operations on them.

use std::hash::{BuildHasher, BuildHasherDefault};
use std::sync::Arc;

use hashbrown::HashTable;
use rustc_hash::{FxHashMap, FxHasher};

use crate::limits::{LimitReached, Limits};
use crate::task::{Fact, State, Task};

/// A set of states, by the number of its root. Equal sets have equal numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SetId(pub(super) u32);

impl SetId {
    /// The set without states.
    pub const EMPTY: Self = Self(0);
    /// Below the last level: the one way to go on.
    pub(crate) const END: Self = Self(1);

    /// Its number.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// An edge of a node: the value of its group, and the node below.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Branch {
    /// 0 where none of the group's facts holds, else one more than the fact's place in it.
    pub value: u32,
    /// What the groups that follow can be.
    pub below: SetId,
}

/// How many new nodes are made between two looks at the memory.
const NODES_BETWEEN_CHECKS: u32 = 1024;

/// The diagrams of a task's sets of states.
#[derive(Debug, Clone)]
pub struct Diagrams {
    task: Arc<Task>,
    /// The edges of all nodes, one node after another.
    branches: Vec<Branch>,
    ends: Vec<usize>,
    levels: Vec<u32>,
    table: HashTable<u32>,
    unions: FxHashMap<(SetId, SetId), SetId>,
    /// How many states the first sets have, `u64::MAX` for as many or more. A node is numbered after those below it.
    pub(super) counts: Vec<u64>,
    limits: Limits,
    /// The most sets that there may be.
    most: usize,
    since_check: u32,
}

fn hash(level: u32, branches: &[Branch]) -> u64 {
    BuildHasherDefault::<FxHasher>::default().hash_one((level, branches))
}

/// The state with these values, one of each level.
pub(super) fn state(task: &Task, values: &[u32]) -> State {
    let (layout, order) = (task.layout(), task.group_order());
    let value = |group: usize| values[order.place(group)];
    layout.state_of_values(&(0..layout.group_count()).map(value).collect::<Vec<_>>())
}

impl Diagrams {
    /// No set but the empty one.
    pub fn new(task: Arc<Task>, limits: Limits) -> Self {
        Self {
            task,
            branches: Vec::new(),
            // The two sets that have no node: the empty one, and the way past the last level.
            ends: vec![0, 0],
            levels: vec![0, 0],
            table: HashTable::new(),
            unions: FxHashMap::default(),
            counts: vec![0, 1],
            limits,
            most: usize::MAX,
            since_check: 0,
        }
    }

    /// Limits the number of new nodes from here on, about: a limit of time that does not depend on the machine. More
    /// of them are [`LimitReached::Memory`].
    pub(crate) fn allow(&mut self, nodes: usize) {
        self.most = self.len().saturating_add(nodes);
    }

    /// The task whose states the sets hold.
    pub fn task(&self) -> &Arc<Task> {
        &self.task
    }

    /// The group of facts of a node's level.
    pub fn group(&self, set: SetId) -> usize {
        self.task.group_order().group(self.level(set) as usize)
    }

    /// The level of a fact's group.
    pub(super) fn level_of(&self, fact: Fact) -> u32 {
        self.task.group_order().place(self.task.layout().group(fact)) as u32
    }

    /// The state with these values, one of each level.
    pub(super) fn state(&self, values: &[u32]) -> State {
        state(&self.task, values)
    }

    /// How many levels a diagram has.
    pub fn depth(&self) -> u32 {
        self.task.layout().group_count() as u32
    }

    /// Bytes in use, counted by contents.
    pub fn bytes(&self) -> u64 {
        let nodes = size_of::<Branch>() * self.branches.len()
            + 24 * self.ends.len()
            + 8 * self.counts.len();
        (nodes + 24 * self.unions.len()) as u64
    }

    /// Checks the nodes, and what is kept beside them in bytes, against the limit.
    ///
    /// # Errors
    ///
    /// [`LimitReached::Memory`] when they outgrow it.
    pub(super) fn check(&self, others: u64) -> Result<(), LimitReached> {
        if self.len() > self.most {
            return Err(LimitReached::Memory { limit_mib: self.limits.bytes >> 20 });
        }
        self.limits.check_bytes(self.bytes() + others)
    }

    /// The edges of a node, by increasing values.
    pub fn branches(&self, set: SetId) -> &[Branch] {
        let begin = set.index().checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.branches[begin..self.ends[set.index()]]
    }

    /// How many sets there are.
    pub(crate) fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether what is remembered beside the nodes takes more than a part of the memory limit.
    pub(super) fn is_tight(&self, bytes: u64) -> bool {
        bytes + 24 * self.unions.len() as u64 > self.limits.bytes / 3
    }

    /// Forgets the unions that were worked out.
    pub(super) fn forget_unions(&mut self) {
        self.unions = FxHashMap::default();
    }

    /// The level of a node.
    pub fn level(&self, set: SetId) -> u32 {
        self.levels[set.index()]
    }

    /// The node with these edges, given a number when it is new. Edges to the empty set are left out.
    ///
    /// # Errors
    ///
    /// [`LimitReached::Memory`] when the nodes outgrow the limit.
    pub(super) fn node(&mut self, level: u32, branches: &[Branch]) -> Result<SetId, LimitReached> {
        let before = self.len();
        let node = self.intern(level, branches);
        self.since_check += (self.len() - before) as u32;
        if self.since_check >= NODES_BETWEEN_CHECKS {
            self.since_check = 0;
            self.check(0)?;
        }
        Ok(node)
    }

    fn intern(&mut self, level: u32, branches: &[Branch]) -> SetId {
        if branches.is_empty() {
            return SetId::EMPTY;
        }
        debug_assert!(branches.is_sorted_by(|a, b| a.value < b.value));
        debug_assert!(branches.iter().all(|branch| branch.below != SetId::EMPTY));
        let (all, ends, levels) = (&self.branches, &self.ends, &self.levels);
        let of = |id: u32| {
            let begin = ends[id as usize - 1];
            (levels[id as usize], &all[begin..ends[id as usize]])
        };
        let entry = self.table.entry(
            hash(level, branches),
            |&id| of(id) == (level, branches),
            |&id| {
                let (level, branches) = of(id);
                hash(level, branches)
            },
        );
        match entry {
            hashbrown::hash_table::Entry::Occupied(known) => SetId(*known.get()),
            hashbrown::hash_table::Entry::Vacant(vacant) => {
                let id = ends.len() as u32;
                vacant.insert(id);
                self.branches.extend_from_slice(branches);
                self.ends.push(self.branches.len());
                self.levels.push(level);
                SetId(id)
            }
        }
    }

    /// The same set alone, in a store of its own.
    pub fn alone(&self, set: SetId) -> (Self, SetId) {
        let mut other = Self::new(Arc::clone(&self.task), self.limits);
        let set = other.adopt(self, set);
        (other, set)
    }

    /// A set of another store for states of the same task, whatever the limit. Linear in its nodes.
    pub fn adopt(&mut self, other: &Self, set: SetId) -> SetId {
        let mut copies =
            FxHashMap::from_iter([(SetId::EMPTY, SetId::EMPTY), (SetId::END, SetId::END)]);
        other.copy_to(self, set, &mut copies)
    }

    fn copy_to(&self, other: &mut Self, set: SetId, copies: &mut FxHashMap<SetId, SetId>) -> SetId {
        if let Some(&known) = copies.get(&set) {
            return known;
        }
        let mut branches = Vec::with_capacity(self.branches(set).len());
        for &Branch { value, below } in self.branches(set) {
            branches.push(Branch { value, below: self.copy_to(other, below, copies) });
        }
        let copy = other.intern(self.level(set), &branches);
        copies.insert(set, copy);
        copy
    }

    /// The set of one state.
    ///
    /// # Errors
    ///
    /// [`LimitReached::Memory`] when the nodes outgrow the limit.
    pub fn single(&mut self, state: &State) -> Result<SetId, LimitReached> {
        let task = Arc::clone(&self.task);
        let mut below = SetId::END;
        for level in (0..self.depth()).rev() {
            let group = task.group_order().group(level as usize);
            let value = task.layout().group_value(state.words(), group) as u32;
            below = self.node(level, &[Branch { value, below }])?;
        }
        Ok(below)
    }

    /// The set of some states. As many unions as states, joined in pairs.
    ///
    /// # Errors
    ///
    /// [`LimitReached::Memory`] when the nodes outgrow the limit.
    pub fn of_states(&mut self, states: &[State]) -> Result<SetId, LimitReached> {
        match states {
            [] => Ok(SetId::EMPTY),
            [state] => self.single(state),
            states => {
                let (one, other) = states.split_at(states.len() / 2);
                let (one, other) = (self.of_states(one)?, self.of_states(other)?);
                self.union(one, other)
            }
        }
    }

    /// The states of either set. At most the product of both numbers of nodes.
    ///
    /// # Errors
    ///
    /// [`LimitReached::Memory`] when the nodes outgrow the limit.
    pub fn union(&mut self, one: SetId, other: SetId) -> Result<SetId, LimitReached> {
        if one == other || other == SetId::EMPTY {
            return Ok(one);
        }
        if one == SetId::EMPTY {
            return Ok(other);
        }
        let key = (one.min(other), one.max(other));
        if let Some(&known) = self.unions.get(&key) {
            return Ok(known);
        }
        let mut joined = Vec::new();
        let (mut left, mut right) = (0, 0);
        loop {
            let a = self.branches(one).get(left).copied();
            let b = self.branches(other).get(right).copied();
            let branch = match (a, b) {
                (None, None) => break,
                (Some(a), Some(b)) if a.value == b.value => {
                    (left, right) = (left + 1, right + 1);
                    Branch { value: a.value, below: self.union(a.below, b.below)? }
                }
                (Some(a), b) if b.is_none_or(|b| a.value < b.value) => {
                    left += 1;
                    a
                }
                (_, Some(b)) => {
                    right += 1;
                    b
                }
                (Some(a), None) => {
                    left += 1;
                    a
                }
            };
            joined.push(branch);
        }
        let set = self.node(self.level(one), &joined)?;
        self.unions.insert(key, set);
        Ok(set)
    }

    /// Whether a state is in the set. Linear in the levels.
    pub fn contains(&self, set: SetId, state: &State) -> bool {
        let mut at = set;
        while at != SetId::END {
            let wanted = self.task.layout().group_value(state.words(), self.group(at)) as u32;
            let Some(branch) = self.branches(at).iter().find(|branch| branch.value == wanted)
            else {
                return false;
            };
            at = branch.below;
        }
        true
    }
}
