//! The best plans of every length up to a longest one, in one go.

use std::sync::Arc;

use super::ends::Ends;
use super::layered::LayeredGraph;
use super::pairs::Pairs;
use crate::limits::LimitReached;
use crate::problem::{JointSpace, Problem};
use crate::solver::engine::{Advance, Engine, Finding};
use crate::solver::live::Live;
use crate::solver::outcome::{LengthPoint, ParetoPoint, Progress, Stats};
use crate::solver::{Bounds, Options};

/// Exact search at every horizon from 0 to a longest one. Nothing is kept in a layer that cannot
/// reach the true goal in the actions that are left.
#[derive(Debug)]
pub(in crate::solver) struct Lengths {
    joint: JointSpace,
    bounds: Bounds,
    pareto: bool,
    longest: usize,
    live: Option<Live>,
    graph: LayeredGraph,
    ends: Ends,
    /// The pairs of all lengths.
    pairs: Pairs,
}

impl Lengths {
    pub(in crate::solver) fn new(problem: Arc<Problem>, options: &Options, longest: usize) -> Self {
        let mut joint = JointSpace::new(problem, options.limits);
        Self {
            graph: LayeredGraph::new(&mut joint),
            joint,
            bounds: options.heeded_bounds(),
            pareto: options.pareto,
            longest,
            live: None,
            ends: Ends::default(),
            pairs: Pairs::default(),
        }
    }

    /// Takes note of the nodes that may end a plan.
    fn note(&mut self) {
        for &(number, _) in self.ends.note(&mut self.joint, &self.bounds, &self.graph) {
            let profile = self.graph.node(number).profile;
            self.pairs.offer(&mut self.joint, &self.bounds, profile, number);
        }
    }

    /// The best of each length whose layer is finished.
    fn points(&self, last: usize) -> Vec<LengthPoint> {
        let sources = self.graph.sources();
        let point = |length| {
            let finished = length <= self.graph.length();
            let best = finished.then(|| self.ends.best(&self.graph, length)).flatten();
            let best = best.map(|(node, counts)| ParetoPoint {
                counts,
                plan: self.graph.plan(&sources, length, node),
            });
            LengthPoint { length, best }
        };
        (0..=last).map(point).collect()
    }

    fn finding(&self) -> Finding {
        let mut finding = self.pairs.finding(self.pareto, |node| self.graph.shortest(node));
        finding.lengths = Some(self.points(self.longest));
        finding
    }
}

impl Engine for Lengths {
    fn advance(&mut self, budget: u64) -> Result<Advance, LimitReached> {
        let live = match self.live.take() {
            Some(live) => live,
            None => Live::new(&mut self.joint)?,
        };
        let mut budget = budget;
        let mut worked = Ok(true);
        loop {
            let left = self.longest - self.graph.length();
            if left == 0 || self.graph.ended() {
                break;
            }
            let fits = |state, within| live.distance(state).is_some_and(|steps| steps <= within);
            worked = self.graph.advance(
                &mut self.joint,
                &mut budget,
                |state| fits(state, self.longest),
                |state| fits(state, left - 1),
            );
            if !matches!(worked, Ok(true)) {
                break;
            }
            self.note();
        }
        self.live = Some(live);
        if worked? {
            self.note();
            return Ok(Advance::Finished(self.finding()));
        }
        Ok(Advance::Working)
    }

    fn stop(&mut self, limit: LimitReached) -> Finding {
        self.note();
        let most = self.bounds.most_difference(self.joint.problem());
        let mut finding =
            self.pairs.stopped(self.pareto, most, limit, |node| self.graph.shortest(node));
        finding.lengths = Some(self.points(self.graph.length()));
        finding
    }

    fn report(&self, progress: &mut Progress) {
        progress.horizon = Some(self.longest.min(self.graph.length() + 1));
        progress.bound = Some(1.0);
        if let Some((counts, node)) = self.pairs.best() {
            progress.goal_difference = Some(self.joint.problem().goal_difference(counts));
            progress.plan = Some(self.graph.shortest(node));
        }
    }

    fn stats(&self) -> Stats {
        let mut stats = Stats {
            expansions: self.graph.visits(),
            generated: self.graph.len() as u64,
            ..Stats::default()
        };
        stats.count_spaces(&self.joint);
        stats
    }
}
