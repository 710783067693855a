//! The reachable pairs of survivor counts, each with the first node found for it.

use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::SurvivorCounts;
use crate::solver::engine::Finding;
use crate::solver::outcome::{ReachablePair, Status};

/// Pairs and nodes, by the position of a node in its exploration.
#[derive(Debug, Default)]
pub(super) struct Pairs {
    /// Sorted by pair.
    first: Vec<(SurvivorCounts, usize)>,
}

impl Pairs {
    /// Adds nodes that may end a plan, in the order in which they are preferred.
    pub(super) fn extend(&mut self, ends: impl IntoIterator<Item = (usize, SurvivorCounts)>) {
        for (node, counts) in ends {
            let place = self.first.partition_point(|(known, _)| *known < counts);
            if self.first.get(place).is_none_or(|(known, _)| *known != counts) {
                self.first.insert(place, (counts, node));
            }
        }
    }

    /// The pair with the best difference; of equal ones the one with the first node, since no plan
    /// for another is shorter.
    pub(super) fn best(&self) -> Option<(SurvivorCounts, usize)> {
        let better = |&&(counts, node): &&(SurvivorCounts, usize)| {
            (counts.difference(), std::cmp::Reverse(node))
        };
        self.first.iter().max_by_key(better).copied()
    }

    /// The answer, once everything has been looked at.
    pub(super) fn finding(&self, pairs: bool, plan: impl Fn(usize) -> Plan) -> Finding {
        let mut finding = match self.best() {
            Some((_, node)) => Finding::plan(Status::Optimal, plan(node)),
            None => Finding::infeasible(),
        };
        finding.pairs = pairs.then(|| self.points(plan));
        finding
    }

    /// What can be said when the work stops before everything has been looked at. `most` is the
    /// difference that no plan can beat.
    pub(super) fn stopped(
        &self,
        pairs: bool,
        most: i64,
        limit: LimitReached,
        plan: impl Fn(usize) -> Plan,
    ) -> Finding {
        let best = self.best().map(|(counts, node)| ReachablePair { counts, plan: plan(node) });
        let mut finding = stopped(best, most, limit);
        finding.pairs = pairs.then(|| self.points(plan));
        finding
    }

    fn points(&self, plan: impl Fn(usize) -> Plan) -> Vec<ReachablePair> {
        let point = |&(counts, node): &_| ReachablePair { counts, plan: plan(node) };
        self.first.iter().map(point).collect()
    }
}

/// What can be said of the best plan known when the work stops. `most` is the difference that no
/// plan can beat.
pub(super) fn stopped(best: Option<ReachablePair>, most: i64, limit: LimitReached) -> Finding {
    match best {
        Some(ReachablePair { counts, plan }) if counts.difference() == most => {
            Finding::stopped_at_best(plan, limit)
        }
        best => Finding::stopped(best.map(|best| best.plan), limit),
    }
}
