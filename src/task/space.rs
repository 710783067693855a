//! The state space of a task, discovered as it is asked for and never listed in full.
//!
//! States get numbers in the order in which they are met; the successors of a state are computed
//! once. Both are deterministic, so numbers may decide ties.

use std::hash::{BuildHasher, BuildHasherDefault};
use std::sync::Arc;

use hashbrown::HashTable;
use rustc_hash::FxHasher;

use super::Task;
use super::operator::{Action, OperatorId};
use super::state::State;

/// A state met in a [`StateSpace`], by its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct StateId(pub(crate) u32);

impl StateId {
    /// Its number, from 0 in the order of discovery.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A transition: the operator, the action it belongs to, and the resulting state.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Edge {
    /// The operator applied.
    pub operator: OperatorId,
    /// Its action.
    pub action: Action,
    /// The resulting state.
    pub target: StateId,
}

/// Where the edges of a state begin, once it is expanded.
const UNEXPANDED: u32 = u32::MAX;

/// States and transitions met so far.
#[derive(Debug, Clone)]
pub struct StateSpace {
    task: Arc<Task>,
    words: Vec<u64>,
    table: HashTable<u32>,
    rows: Vec<(u32, u32)>,
    edges: Vec<Edge>,
    scratch: Vec<OperatorId>,
    next: Vec<u64>,
}

fn hash(words: &[u64]) -> u64 {
    BuildHasherDefault::<FxHasher>::default().hash_one(words)
}

impl StateSpace {
    /// An empty space over a task.
    pub fn new(task: Arc<Task>) -> Self {
        let next = vec![0; task.layout().words()];
        Self {
            task,
            words: Vec::new(),
            table: HashTable::new(),
            rows: Vec::new(),
            edges: Vec::new(),
            scratch: Vec::new(),
            next,
        }
    }

    /// The task.
    pub fn task(&self) -> &Arc<Task> {
        &self.task
    }

    /// How many states have been met.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// How many transitions have been computed.
    pub fn edge_count(&self) -> usize {
        self.edges.len()
    }

    /// Every transition computed so far, in the order of discovery.
    pub fn all_edges(&self) -> &[Edge] {
        &self.edges
    }

    /// Bytes in use, counted by contents and not by what the allocator holds back.
    pub fn bytes(&self) -> u64 {
        let state = 8 * self.task.layout().words() as u64 + 8 + 8;
        self.rows.len() as u64 * state + self.edges.len() as u64 * size_of::<Edge>() as u64
    }

    /// The packed words of a state.
    pub fn words(&self, id: StateId) -> &[u64] {
        let width = self.task.layout().words();
        &self.words[id.index() * width..][..width]
    }

    /// A state by itself.
    pub fn state(&self, id: StateId) -> State {
        State::from_words(self.words(id).to_vec())
    }

    /// The number of a state, given one when it is new.
    pub fn intern(&mut self, state: &State) -> StateId {
        self.intern_words(state.words())
    }

    /// The number of a state, where it has been met.
    #[cfg(test)]
    pub fn find(&self, state: &State) -> Option<StateId> {
        let words = state.words();
        self.table.find(hash(words), |&id| self.words(StateId(id)) == words).map(|&id| StateId(id))
    }

    /// The state that was met next after one, where there is one. Expanding the states in this
    /// order goes through the space breadth first.
    pub fn after(&self, id: StateId) -> Option<StateId> {
        (id.index() + 1 < self.len()).then_some(StateId(id.0 + 1))
    }

    fn intern_words(&mut self, words: &[u64]) -> StateId {
        let width = words.len();
        let all = &self.words;
        let at = |id: u32| &all[id as usize * width..][..width];
        let entry = self.table.entry(hash(words), |&id| at(id) == words, |&id| hash(at(id)));
        match entry {
            hashbrown::hash_table::Entry::Occupied(known) => StateId(*known.get()),
            hashbrown::hash_table::Entry::Vacant(vacant) => {
                let id = self.rows.len() as u32;
                vacant.insert(id);
                self.words.extend_from_slice(words);
                self.rows.push((UNEXPANDED, 0));
                StateId(id)
            }
        }
    }

    /// Computes the successors of a state where that has not been done.
    pub fn expand(&mut self, id: StateId) {
        if self.rows[id.index()].0 != UNEXPANDED {
            return;
        }
        let task = Arc::clone(&self.task);
        let mut operators = std::mem::take(&mut self.scratch);
        let mut next = std::mem::take(&mut self.next);
        task.applicable(self.words(id), &mut operators);
        let begin = self.edges.len() as u32;
        for &operator in &operators {
            next.copy_from_slice(self.words(id));
            task.apply(operator, &mut next);
            let target = self.intern_words(&next);
            let action = task.operator(operator).action;
            self.edges.push(Edge { operator, action, target });
        }
        self.rows[id.index()] = (begin, operators.len() as u32);
        self.scratch = operators;
        self.next = next;
    }

    /// Where the transitions of a state lie in [`all_edges`](Self::all_edges); nothing before
    /// [`expand`](Self::expand).
    pub fn edge_range(&self, id: StateId) -> std::ops::Range<usize> {
        match self.rows[id.index()] {
            (UNEXPANDED, _) => 0..0,
            (begin, count) => begin as usize..begin as usize + count as usize,
        }
    }

    /// The transitions of an expanded state, by operator.
    pub fn edges(&self, id: StateId) -> &[Edge] {
        &self.edges[self.edge_range(id)]
    }
}

#[cfg(test)]
mod tests {
    use super::super::TaskBuilder;
    use super::*;

    #[test]
    fn a_corridor_of_three_cells() {
        let mut task = TaskBuilder::default();
        let cells: Vec<_> = (0..3).map(|i| task.fact(format!("at {i}"))).collect();
        task.exclusive(cells.clone());
        for i in 0..2 {
            task.operator("right", &[cells[i]], &[cells[i + 1]], &[cells[i]]);
            task.operator("left", &[cells[i + 1]], &[cells[i]], &[cells[i + 1]]);
        }
        let task = Arc::new(task.build(&[cells[1]], &[cells[2]]).unwrap());
        let mut space = StateSpace::new(Arc::clone(&task));
        let start = space.intern(task.initial_state());
        assert!(space.edges(start).is_empty());
        space.expand(start);
        space.expand(start);
        let names: Vec<_> =
            space.edges(start).iter().map(|edge| task.action_name(edge.action)).collect();
        assert_eq!(names, ["left", "right"]);
        assert_eq!((space.len(), space.edge_count()), (3, 2));
        assert_eq!(space.find(task.initial_state()), Some(start));
        assert_eq!(space.find(&task.state(&[cells[0]]).unwrap()), Some(StateId(1)));
    }
}
