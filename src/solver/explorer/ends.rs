//! The nodes that may end a plan, with the survivor counts of each.

use fixedbitset::FixedBitSet;

use super::layers::Layers;
use crate::problem::{JointSpace, Node, SurvivorCounts};
use crate::solver::Bounds;
use crate::solver::ground::final_beliefs::allowed;

/// The nodes met that satisfy the true goal and keep the bounds.
#[derive(Debug)]
pub(super) struct Ends {
    bounds: Bounds,
    /// How many nodes have been looked at.
    noted: usize,
    nodes: Vec<(usize, SurvivorCounts)>,
}

impl Ends {
    pub(super) fn new(bounds: Bounds) -> Self {
        Self { bounds, noted: 0, nodes: Vec::new() }
    }

    /// The survivor counts of a plan that ends in a node; none where no plan may.
    pub(super) fn counts(&self, joint: &mut JointSpace, node: Node) -> Option<SurvivorCounts> {
        if !joint.is_goal(node.state) {
            return None;
        }
        let counts = joint.counts(node.profile);
        allowed(joint, &self.bounds, node.profile, counts).then_some(counts)
    }

    /// Looks at the nodes that are new. Returns those among them that may end a plan.
    pub(super) fn note(
        &mut self,
        joint: &mut JointSpace,
        layers: &Layers,
    ) -> &[(usize, SurvivorCounts)] {
        let known = self.nodes.len();
        for number in self.noted..layers.len() {
            let counts = self.counts(joint, layers.node(number));
            self.nodes.extend(counts.map(|counts| (number, counts)));
        }
        self.noted = layers.len();
        &self.nodes[known..]
    }

    /// All of them, in the order in which they were met.
    pub(super) fn all(&self) -> &[(usize, SurvivorCounts)] {
        &self.nodes
    }

    /// Those of a layer.
    pub(super) fn of<'a>(
        &'a self,
        layer: &'a FixedBitSet,
    ) -> impl Iterator<Item = (usize, SurvivorCounts)> + 'a {
        self.nodes.iter().filter(|(node, _)| layer.contains(*node)).copied()
    }
}

/// The one with the greatest difference, the first met of equals.
pub(super) fn best(
    ends: impl Iterator<Item = (usize, SurvivorCounts)>,
) -> Option<(usize, SurvivorCounts)> {
    ends.max_by_key(|&(node, counts)| (counts.difference(), std::cmp::Reverse(node)))
}
