//! Which nodes of a graph may end a plan.

use super::layered::LayeredGraph;
use super::pairs::allowed;
use crate::problem::{JointSpace, SurvivorCounts};
use crate::solver::Bounds;

/// The nodes that satisfy the true goal and keep the bounds, with what they are worth.
#[derive(Debug, Default)]
pub(in crate::solver) struct Ends {
    /// How many nodes have been looked at.
    noted: usize,
    nodes: Vec<(usize, SurvivorCounts)>,
}

impl Ends {
    /// Looks at the nodes that are new. Returns those among them that may end a plan.
    pub(in crate::solver) fn note(
        &mut self,
        joint: &mut JointSpace,
        bounds: &Bounds,
        graph: &LayeredGraph,
    ) -> &[(usize, SurvivorCounts)] {
        let known = self.nodes.len();
        for number in self.noted..graph.len() {
            let node = graph.node(number);
            if joint.is_goal(node.state) {
                let counts = joint.counts(node.profile);
                if allowed(joint, bounds, node.profile, counts) {
                    self.nodes.push((number, counts));
                }
            }
        }
        self.noted = graph.len();
        &self.nodes[known..]
    }

    /// The best one that plans of this length lead to, the first met of equals.
    pub(in crate::solver) fn best(
        &self,
        graph: &LayeredGraph,
        length: usize,
    ) -> Option<(usize, SurvivorCounts)> {
        let here = self.nodes.iter().filter(|(node, _)| graph.contains(length, *node));
        let better = |&&(node, counts): &&(usize, SurvivorCounts)| {
            (counts.difference(), std::cmp::Reverse(node))
        };
        here.max_by_key(better).copied()
    }
}
