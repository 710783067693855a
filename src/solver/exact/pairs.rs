//! The reachable pairs of survivor counts, each with the first node found for it.

use crate::limits::LimitReached;
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
        finding.pareto = pareto.then(|| self.points(plan));
        finding
    }

    /// What can be said when the work stops before everything has been looked at. `most` is the
    /// difference that no plan can beat.
    pub(super) fn stopped(
        &self,
        pareto: bool,
        most: i64,
        limit: LimitReached,
        plan: impl Fn(usize) -> Plan,
    ) -> Finding {
        let best = self.best().map(|(counts, node)| ParetoPoint { counts, plan: plan(node) });
        let mut finding = stopped(best, most, limit);
        finding.pareto = pareto.then(|| self.points(plan));
        finding
    }

    fn points(&self, plan: impl Fn(usize) -> Plan) -> Vec<ParetoPoint> {
        let point = |&(counts, node): &_| ParetoPoint { counts, plan: plan(node) };
        self.first.iter().map(point).collect()
    }
}

/// What can be said of the best plan known when the work stops. `most` is the difference that no
/// plan can beat.
pub(super) fn stopped(best: Option<ParetoPoint>, most: i64, limit: LimitReached) -> Finding {
    match best {
        Some(ParetoPoint { counts, plan }) if counts.difference() == most => {
            Finding::stopped_at_best(plan, limit)
        }
        best => Finding::stopped(best.map(|best| best.plan), limit),
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
