//! The nodes that plans of each length lead to.
//!
//! Layers of one search have most of their nodes in common. So a node is met and expanded once, its
//! transitions are kept, and a layer is a set of numbers: layer t + 1 holds what the transitions
//! out of layer t lead to.

use fixedbitset::FixedBitSet;

use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::{JointSpace, Node};
use crate::solver::tree::SearchTree;
use crate::task::{Action, StateId};

/// How many nodes are visited between two looks at the memory.
const VISITS_BETWEEN_CHECKS: u64 = 64;

/// A node whose transitions are not known yet.
const UNEXPANDED: u32 = u32::MAX;

/// Nodes, transitions and layers.
#[derive(Debug)]
pub(in crate::solver) struct LayeredGraph {
    /// Each node with the first transition found into it.
    tree: SearchTree<Node>,
    /// Where the transitions of each node begin and end.
    rows: Vec<(u32, u32)>,
    transitions: Vec<(u32, Action)>,
    /// The finished layers, from length 0.
    layers: Vec<FixedBitSet>,
    layer_bytes: usize,
    /// The nodes of the last of them in the order found, and the next one to visit.
    last: Vec<u32>,
    next: usize,
    /// The layer being made.
    following: Vec<u32>,
    members: FixedBitSet,
    visits: u64,
    found: Vec<(Action, Node)>,
}

impl LayeredGraph {
    /// The layer of length 0.
    pub(in crate::solver) fn new(joint: &mut JointSpace) -> Self {
        let mut first = FixedBitSet::new();
        first.grow_and_insert(0);
        Self {
            tree: SearchTree::new(joint.initial()),
            rows: vec![(UNEXPANDED, 0)],
            transitions: Vec::new(),
            layers: vec![first],
            layer_bytes: 0,
            last: vec![0],
            next: 0,
            following: Vec::new(),
            members: FixedBitSet::new(),
            visits: 0,
            found: Vec::new(),
        }
    }

    /// The length of the last finished layer.
    pub(in crate::solver) fn length(&self) -> usize {
        self.layers.len() - 1
    }

    /// Whether no plan goes on from the last finished layer.
    pub(in crate::solver) fn ended(&self) -> bool {
        self.last.is_empty()
    }

    /// Whether the last finished layer is the same as one of this length or longer, so that all to
    /// come were there before. Only for layers that were all made with the same `keep`.
    pub(in crate::solver) fn repeats(&self, since: usize) -> bool {
        let mut earlier = self.layers.iter().skip(since).take(self.length().saturating_sub(since));
        let Some(last) = self.layers.last() else { return false };
        earlier.any(|layer| layer.ones().eq(last.ones()))
    }

    /// How many nodes have been met.
    pub(in crate::solver) fn len(&self) -> usize {
        self.tree.len()
    }

    /// How many nodes were visited, each once for each layer it is in.
    pub(in crate::solver) fn visits(&self) -> u64 {
        self.visits
    }

    /// The node of a number.
    pub(in crate::solver) fn node(&self, number: usize) -> Node {
        self.tree.key(number)
    }

    /// Whether plans of this length lead to a node.
    pub(in crate::solver) fn contains(&self, length: usize, node: usize) -> bool {
        self.layers[length].contains(node)
    }

    /// Bytes in use, counted by contents, with those that [`Sources`] will take.
    pub(in crate::solver) fn bytes(&self) -> u64 {
        let transition = size_of::<(u32, Action)>() + size_of::<u32>();
        let node = size_of::<(u32, u32)>() + size_of::<u32>();
        let lists = size_of::<u32>() * (self.last.len() + self.following.len());
        let own =
            transition * self.transitions.len() + node * self.rows.len() + self.layer_bytes + lists;
        self.tree.bytes() + own as u64
    }

    fn check_limits(&self, joint: &JointSpace) -> Result<(), LimitReached> {
        let limits = joint.limits();
        if self.visits.is_multiple_of(VISITS_BETWEEN_CHECKS) {
            limits.check_bytes(joint.bytes() + self.bytes())?;
        }
        if self.visits >= limits.expansions {
            return Err(LimitReached::Expansions { limit: limits.expansions });
        }
        Ok(())
    }

    /// Works out the transitions of a node where that has not been done, to states that `live`
    /// wants.
    fn expand(
        &mut self,
        joint: &mut JointSpace,
        number: usize,
        live: impl Fn(StateId) -> bool,
    ) -> Result<(), LimitReached> {
        if self.rows[number].0 != UNEXPANDED {
            return Ok(());
        }
        joint.expand(self.tree.key(number), live, &mut self.found)?;
        let begin = self.transitions.len() as u32;
        for &(action, node) in &self.found {
            let target = self.tree.number(node, number, action);
            self.transitions.push((target as u32, action));
        }
        self.rows.resize(self.tree.len(), (UNEXPANDED, 0));
        self.rows[number] = (begin, self.transitions.len() as u32);
        Ok(())
    }

    /// Visits nodes of the last layer, as many as `budget` says and takes off it; true when the
    /// next layer is finished. `live` says of which states the transitions count at all, `keep`
    /// which of these states may be in the next layer.
    pub(in crate::solver) fn advance(
        &mut self,
        joint: &mut JointSpace,
        budget: &mut u64,
        live: impl Fn(StateId) -> bool + Copy,
        keep: impl Fn(StateId) -> bool,
    ) -> Result<bool, LimitReached> {
        while let Some(&number) = self.last.get(self.next) {
            if *budget == 0 {
                return Ok(false);
            }
            *budget -= 1;
            self.check_limits(joint)?;
            self.expand(joint, number as usize, live)?;
            self.members.grow(self.tree.len());
            let (begin, end) = self.rows[number as usize];
            for &(target, _) in &self.transitions[begin as usize..end as usize] {
                let state = self.tree.key(target as usize).state;
                if keep(state) && !self.members.put(target as usize) {
                    self.following.push(target);
                }
            }
            self.visits += 1;
            self.next += 1;
        }
        self.layer_bytes += self.members.len() / 8;
        self.layers.push(std::mem::take(&mut self.members));
        self.last.clear();
        std::mem::swap(&mut self.last, &mut self.following);
        self.next = 0;
        Ok(true)
    }

    /// The transitions by the node they lead to. Linear in their number.
    pub(in crate::solver) fn sources(&self) -> Sources {
        let mut ends = vec![0_u32; self.tree.len() + 1];
        for &(target, _) in &self.transitions {
            ends[target as usize + 1] += 1;
        }
        for number in 1..ends.len() {
            ends[number] += ends[number - 1];
        }
        let mut free = ends.clone();
        let mut sources = vec![0; self.transitions.len()];
        for (source, &(begin, end)) in self.rows.iter().enumerate() {
            if begin != UNEXPANDED {
                for &(target, _) in &self.transitions[begin as usize..end as usize] {
                    let place = &mut free[target as usize];
                    sources[*place as usize] = source as u32;
                    *place += 1;
                }
            }
        }
        Sources { ends, sources }
    }

    /// A shortest plan to a node, where the last layer may be unfinished.
    pub(in crate::solver) fn shortest(&self, node: usize) -> Plan {
        self.tree.plan(node)
    }

    /// A plan of this length to a node that is in its layer.
    pub(in crate::solver) fn plan(&self, sources: &Sources, length: usize, node: usize) -> Plan {
        let mut actions = Vec::with_capacity(length);
        let mut node = node as u32;
        for layer in self.layers[..length].iter().rev() {
            let before = sources.of(node).iter().find(|&&source| layer.contains(source as usize));
            // Whatever is in a layer was put there by a node of the one before.
            let Some(&before) = before else { break };
            let (begin, end) = self.rows[before as usize];
            let mut row = self.transitions[begin as usize..end as usize].iter();
            let taken = row.find(|(target, _)| *target == node);
            actions.extend(taken.map(|&(_, action)| action));
            node = before;
        }
        actions.reverse();
        Plan { actions }
    }
}

/// For each node the nodes before it.
#[derive(Debug)]
pub(in crate::solver) struct Sources {
    /// Where those of each node end; the first number stands before all.
    ends: Vec<u32>,
    sources: Vec<u32>,
}

impl Sources {
    fn of(&self, node: u32) -> &[u32] {
        let (begin, end) = (self.ends[node as usize], self.ends[node as usize + 1]);
        &self.sources[begin as usize..end as usize]
    }
}
