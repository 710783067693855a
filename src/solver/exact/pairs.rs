//! The reachable pairs of survivor counts, each with the first node found for it.

use crate::plan::Plan;
use crate::problem::{JointSpace, ProfileId, SurvivorCounts};
use crate::solver::Bounds;
use crate::solver::engine::Finding;
use crate::solver::outcome::{ParetoPoint, Status};

/// Pairs and nodes, by the position of a node in its search.
#[derive(Debug, Default)]
pub(super) struct Pairs {
    /// Sorted by pair.
    first: Vec<(SurvivorCounts, usize)>,
}

impl Pairs {
    /// Offers a node that ends a plan; true when it brings a new pair.
    pub(super) fn offer(
        &mut self,
        joint: &mut JointSpace,
        bounds: &Bounds,
        profile: ProfileId,
        node: usize,
    ) -> bool {
        let counts = joint.counts(profile);
        let place = self.first.partition_point(|(known, _)| *known < counts);
        let known = self.first.get(place).is_some_and(|(known, _)| *known == counts);
        if known || !allowed(joint, bounds, profile, counts) {
            return false;
        }
        self.first.insert(place, (counts, node));
        true
    }

    /// The pair with the best difference; of equal ones the one found first, since no plan for
    /// another is shorter.
    pub(super) fn best(&self) -> Option<(SurvivorCounts, usize)> {
        let better = |&&(counts, node): &&(SurvivorCounts, usize)| {
            (counts.difference(), std::cmp::Reverse(node))
        };
        self.first.iter().max_by_key(better).copied()
    }

    /// The answer, once everything has been looked at.
    pub(super) fn finding(&self, pareto: bool, plan: impl Fn(usize) -> Plan) -> Finding {
        let mut finding = match self.best() {
            Some((_, node)) => Finding::plan(Status::Optimal, plan(node)),
            None => Finding::infeasible(),
        };
        let point = |&(counts, node): &_| ParetoPoint { counts, plan: plan(node) };
        finding.pareto = pareto.then(|| self.first.iter().map(point).collect());
        finding
    }
}

/// Whether a profile is allowed in the end. Looks at the sets only where the bounds name goals.
pub(super) fn allowed(
    joint: &mut JointSpace,
    bounds: &Bounds,
    profile: ProfileId,
    counts: SurvivorCounts,
) -> bool {
    if bounds.required.is_empty() && bounds.forbidden.is_empty() {
        return bounds.allow(counts, &[]);
    }
    let sets = joint.survivor_sets(profile);
    bounds.allow(counts, &sets)
}
