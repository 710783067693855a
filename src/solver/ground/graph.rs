//! The explored space: nodes met and the transitions between them, each worked out once.

use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::{JointSpace, Node};
use crate::solver::ground::search_tree::SearchTree;
use crate::task::{Action, StateId};

/// A node whose transitions are not known yet.
const UNEXPANDED: u32 = u32::MAX;

/// Nodes by their numbers, in the order in which they were met.
#[derive(Debug)]
pub(in crate::solver) struct Graph {
    /// Each node with the first transition found into it.
    tree: SearchTree<Node>,
    /// Where the transitions of each node begin and end.
    rows: Vec<(u32, u32)>,
    transitions: Vec<(u32, Action)>,
    found: Vec<(Action, Node)>,
}

impl Graph {
    /// The first node alone.
    pub(in crate::solver) fn new(root: Node) -> Self {
        Self {
            tree: SearchTree::new(root),
            rows: vec![(UNEXPANDED, 0)],
            transitions: Vec::new(),
            found: Vec::new(),
        }
    }

    /// How many nodes have been met.
    pub(in crate::solver) fn len(&self) -> usize {
        self.tree.len()
    }

    /// How many transitions are known.
    pub(in crate::solver) fn transition_count(&self) -> usize {
        self.transitions.len()
    }

    /// The node of a number.
    pub(in crate::solver) fn node(&self, number: usize) -> Node {
        self.tree.key(number)
    }

    /// The numbers of the nodes that follow one that is expanded, by operator.
    pub(in crate::solver) fn after(&self, number: usize) -> &[(u32, Action)] {
        match self.rows[number] {
            (UNEXPANDED, _) => &[],
            (begin, end) => &self.transitions[begin as usize..end as usize],
        }
    }

    /// Whether the transitions of a node are known.
    pub(in crate::solver) fn is_expanded(&self, number: usize) -> bool {
        self.rows.get(number).is_some_and(|row| row.0 != UNEXPANDED)
    }

    /// Meets the nodes that follow a node, and keeps of the transitions the first one into each.
    pub(in crate::solver) fn meet_successors(
        &mut self,
        joint: &mut JointSpace,
        number: usize,
        wanted: impl Fn(StateId) -> bool,
    ) -> Result<(), LimitReached> {
        joint.expand(self.tree.key(number), wanted, &mut self.found)?;
        for &(action, node) in &self.found {
            self.tree.meet(node, number, action);
        }
        Ok(())
    }

    /// Works out the transitions of a node where that has not been done, to the states that are
    /// `wanted`.
    pub(in crate::solver) fn expand(
        &mut self,
        joint: &mut JointSpace,
        number: usize,
        wanted: impl Fn(StateId) -> bool,
    ) -> Result<(), LimitReached> {
        if self.rows[number].0 != UNEXPANDED {
            return Ok(());
        }
        joint.expand(self.tree.key(number), wanted, &mut self.found)?;
        let begin = self.transitions.len() as u32;
        for &(action, node) in &self.found {
            let target = self.tree.number(node, number, action);
            self.transitions.push((target as u32, action));
        }
        self.rows.resize(self.tree.len(), (UNEXPANDED, 0));
        self.rows[number] = (begin, self.transitions.len() as u32);
        Ok(())
    }

    /// The actions by which a node was first met.
    pub(in crate::solver) fn first_plan(&self, number: usize) -> Plan {
        self.tree.plan(number)
    }

    /// Bytes in use, counted by contents.
    pub(in crate::solver) fn bytes(&self) -> u64 {
        let transition = size_of::<(u32, Action)>() * self.transitions.len();
        let own = transition + size_of::<(u32, u32)>() * self.rows.len();
        self.tree.bytes() + own as u64
    }
}
