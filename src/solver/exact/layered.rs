//! The nodes that plans of each length lead to.
//!
//! Layers of one search have most of their nodes in common. So a node is met and expanded once, and
//! a layer is a set of numbers: layer t + 1 holds what the transitions out of layer t lead to.

use fixedbitset::FixedBitSet;

use super::graph::Graph;
use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::{JointSpace, Node};
use crate::task::StateId;

/// How many nodes are visited between two looks at the memory.
const VISITS_BETWEEN_CHECKS: u64 = 64;

/// A graph with its layers.
#[derive(Debug)]
pub(in crate::solver) struct LayeredGraph {
    graph: Graph,
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
}

impl LayeredGraph {
    /// The layer of length 0.
    pub(in crate::solver) fn new(joint: &mut JointSpace) -> Self {
        let mut first = FixedBitSet::new();
        first.grow_and_insert(0);
        Self {
            graph: Graph::new(joint.initial()),
            layers: vec![first],
            layer_bytes: 0,
            last: vec![0],
            next: 0,
            following: Vec::new(),
            members: FixedBitSet::new(),
            visits: 0,
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
        self.graph.len()
    }

    /// How many nodes were visited, each once for each layer it is in.
    pub(in crate::solver) fn visits(&self) -> u64 {
        self.visits
    }

    /// The node of a number.
    pub(in crate::solver) fn node(&self, number: usize) -> Node {
        self.graph.node(number)
    }

    /// Whether plans of this length lead to a node.
    pub(in crate::solver) fn contains(&self, length: usize, node: usize) -> bool {
        self.layers[length].contains(node)
    }

    /// Bytes in use, counted by contents, with those that [`Sources`] will take.
    fn bytes(&self) -> u64 {
        let lists = self.last.len() + self.following.len();
        let sources = self.graph.len() + self.graph.transition_count();
        let own = self.layer_bytes + size_of::<u32>() * (lists + sources);
        self.graph.bytes() + own as u64
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
            self.graph.expand(joint, number as usize, live)?;
            self.members.grow(self.graph.len());
            for &(target, _) in self.graph.after(number as usize) {
                let state = self.graph.node(target as usize).state;
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
        Sources { ends, sources }
    }

    /// A shortest plan to a node.
    pub(in crate::solver) fn shortest(&self, node: usize) -> Plan {
        self.graph.first_plan(node)
    }

    /// A plan of this length to a node that is in its layer.
    pub(in crate::solver) fn plan(&self, sources: &Sources, length: usize, node: usize) -> Plan {
        let mut actions = Vec::with_capacity(length);
        let mut node = node as u32;
        for layer in self.layers[..length].iter().rev() {
            let before = sources.of(node).iter().find(|&&source| layer.contains(source as usize));
            // Whatever is in a layer was put there by a node of the one before.
            let Some(&before) = before else { break };
            let mut row = self.graph.after(before as usize).iter();
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
