//! Layers: the nodes that plans of each length lead to.
//!
//! Layers of one exploration have most of their nodes in common. So a node is met and expanded once,
//! and a layer is a set of numbers: layer t + 1 holds what the transitions out of layer t lead to.
//! Where lengths do not matter, a node is in the first of its layers alone, transitions are not
//! kept, and the exploration is breadth-first search.

use fixedbitset::FixedBitSet;

use crate::limits::{LimitReached, Limits};
use crate::plan::Plan;
use crate::problem::{JointSpace, Node};
use crate::solver::ground::graph::Graph;
use crate::solver::ground::thresholds::VISITS_BETWEEN_CHECKS;
use crate::task::StateId;

/// In which layers a node is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Membership {
    /// In each to which a plan leads.
    Every,
    /// In the first of these alone.
    First,
}

/// A graph with its layers.
#[derive(Debug)]
pub(super) struct Layers {
    graph: Graph,
    membership: Membership,
    /// The finished layers, from length 0; kept for [`Membership::Every`] alone.
    sets: Vec<FixedBitSet>,
    set_bytes: usize,
    /// The length of the last finished layer.
    length: usize,
    /// Its nodes in the order found, and the next one to visit.
    last: Vec<u32>,
    next: usize,
    /// The layer being made.
    following: Vec<u32>,
    members: FixedBitSet,
    visits: u64,
    expansions: u64,
}

impl Layers {
    /// The layer of length 0.
    pub(super) fn new(joint: &mut JointSpace, membership: Membership) -> Self {
        let mut first = FixedBitSet::new();
        first.grow_and_insert(0);
        Self {
            graph: Graph::new(joint.initial()),
            membership,
            sets: vec![first],
            set_bytes: 0,
            length: 0,
            last: vec![0],
            next: 0,
            following: Vec::new(),
            members: FixedBitSet::new(),
            visits: 0,
            expansions: 0,
        }
    }

    /// The length of the last finished layer.
    pub(super) fn length(&self) -> usize {
        self.length
    }

    /// The nodes of the last finished layer, in the order found.
    pub(super) fn last(&self) -> &[u32] {
        &self.last
    }

    /// Whether no plan goes on from the last finished layer.
    pub(super) fn ended(&self) -> bool {
        self.last.is_empty()
    }

    /// How many nodes have been met.
    pub(super) fn len(&self) -> usize {
        self.graph.len()
    }

    /// How many nodes have been expanded, each once.
    pub(super) fn expansions(&self) -> u64 {
        self.expansions
    }

    /// How many nodes have been visited, each once for each layer it is in.
    pub(super) fn visits(&self) -> u64 {
        self.visits
    }

    /// The node of a number.
    pub(super) fn node(&self, number: usize) -> Node {
        self.graph.node(number)
    }

    /// The nodes to which plans of this length lead.
    pub(super) fn set(&self, length: usize) -> &FixedBitSet {
        &self.sets[length]
    }

    /// Bytes in use, counted by contents, with those that [`Predecessors`] will take.
    fn bytes(&self) -> u64 {
        let lists = self.last.len() + self.following.len();
        let predecessors = match self.membership {
            Membership::Every => self.graph.len() + self.graph.transition_count(),
            Membership::First => 0,
        };
        let own = self.set_bytes + size_of::<u32>() * (lists + predecessors);
        self.graph.bytes() + own as u64
    }

    fn expand(
        &mut self,
        joint: &mut JointSpace,
        number: usize,
        limits: &Limits,
        count: impl Fn(StateId) -> bool,
    ) -> Result<(), LimitReached> {
        if self.expansions >= limits.expansions {
            return Err(LimitReached::Expansions { limit: limits.expansions });
        }
        match self.membership {
            Membership::Every => self.graph.expand(joint, number, count)?,
            Membership::First => {
                let known = self.graph.len() as u32;
                self.graph.meet_successors(joint, number, count)?;
                self.following.extend(known..self.graph.len() as u32);
            }
        }
        self.expansions += 1;
        Ok(())
    }

    /// Visits nodes of the last layer, as many as `budget` says and takes off it; true when the
    /// next layer is finished. `count` says of which states the transitions count in this layer or
    /// a later one, `keep` which of these states may be in the next layer.
    ///
    /// # Errors
    ///
    /// The limits on expansions and memory.
    pub(super) fn advance(
        &mut self,
        joint: &mut JointSpace,
        budget: &mut u64,
        limits: &Limits,
        count: impl Fn(StateId) -> bool + Copy,
        keep: impl Fn(StateId) -> bool,
    ) -> Result<bool, LimitReached> {
        while let Some(&number) = self.last.get(self.next) {
            if *budget == 0 {
                return Ok(false);
            }
            *budget -= 1;
            if self.visits.is_multiple_of(VISITS_BETWEEN_CHECKS) {
                limits.check_bytes(joint.bytes() + self.bytes())?;
            }
            if !self.graph.is_expanded(number as usize) {
                self.expand(joint, number as usize, limits, count)?;
            }
            if self.membership == Membership::Every {
                self.members.grow(self.graph.len());
                for &(target, _) in self.graph.after(number as usize) {
                    let state = self.graph.node(target as usize).state;
                    if keep(state) && !self.members.put(target as usize) {
                        self.following.push(target);
                    }
                }
            }
            self.visits += 1;
            self.next += 1;
        }
        if self.membership == Membership::Every {
            self.set_bytes += self.members.len() / 8;
            self.sets.push(std::mem::take(&mut self.members));
        }
        self.last.clear();
        std::mem::swap(&mut self.last, &mut self.following);
        (self.next, self.length) = (0, self.length + 1);
        Ok(true)
    }

    /// The transitions by the node they lead to. Linear in their number.
    pub(super) fn predecessors(&self) -> Predecessors {
        let mut ends = vec![0_u32; self.graph.len() + 1];
        let all =
            || (0..self.graph.len()).flat_map(|n| self.graph.after(n).iter().map(move |t| (n, t)));
        for (_, &(target, _)) in all() {
            ends[target as usize + 1] += 1;
        }
        for number in 1..ends.len() {
            ends[number] += ends[number - 1];
        }
        let mut free = ends.clone();
        let mut sources = vec![0; self.graph.transition_count()];
        for (source, &(target, _)) in all() {
            let place = &mut free[target as usize];
            sources[*place as usize] = source as u32;
            *place += 1;
        }
        Predecessors { ends, sources }
    }

    /// A shortest plan to a node.
    pub(super) fn shortest(&self, node: usize) -> Plan {
        self.graph.first_plan(node)
    }

    /// A plan of this length to a node that is in its layer; `place` says which of the finished
    /// layers has the nodes of a length.
    pub(super) fn plan(
        &self,
        before: &Predecessors,
        length: usize,
        node: usize,
        place: impl Fn(usize) -> usize,
    ) -> Plan {
        let mut actions = Vec::with_capacity(length);
        let mut node = node as u32;
        for layer in (0..length).rev().map(|length| &self.sets[place(length)]) {
            let source = before.of(node).iter().find(|&&source| layer.contains(source as usize));
            // Whatever is in a layer was put there by a node of the one before.
            let Some(&source) = source else { break };
            let mut row = self.graph.after(source as usize).iter();
            let taken = row.find(|(target, _)| *target == node);
            actions.extend(taken.map(|&(_, action)| action));
            node = source;
        }
        actions.reverse();
        Plan { actions }
    }
}

/// For each node the nodes before it.
#[derive(Debug)]
pub(super) struct Predecessors {
    /// Where those of each node end; the first number stands before all.
    ends: Vec<u32>,
    sources: Vec<u32>,
}

impl Predecessors {
    fn of(&self, node: u32) -> &[u32] {
        let (begin, end) = (self.ends[node as usize], self.ends[node as usize + 1]);
        &self.sources[begin as usize..end as usize]
    }
}
