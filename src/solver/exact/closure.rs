//! The best plans of all lengths, breadth first.

use std::sync::Arc;

use super::pairs::{Pairs, stopped};
use super::way::shortest_way;
use crate::limits::LimitReached;
use crate::problem::{JointSpace, Node, Problem};
use crate::solver::engine::{Advance, Engine, Finding};
use crate::solver::live::Live;
use crate::solver::outcome::{Progress, Stats};
use crate::solver::tree::SearchTree;
use crate::solver::{Bounds, Options};
use crate::task::Action;

/// How many nodes are expanded between two looks at the memory.
const EXPANSIONS_BETWEEN_CHECKS: usize = 64;

/// Exact search over all horizons. The first plan found for a pair of counts is a shortest one,
/// since nodes are met in the order of their distance.
#[derive(Debug)]
pub(in crate::solver) struct Closure {
    joint: JointSpace,
    bounds: Bounds,
    /// No plan can be worth more.
    most: i64,
    pareto: bool,
    live: Option<Live>,
    tree: SearchTree<Node>,
    next: usize,
    pairs: Pairs,
    found: Vec<(Action, Node)>,
}

impl Closure {
    pub(in crate::solver) fn new(problem: Arc<Problem>, options: &Options) -> Self {
        let mut joint = JointSpace::new(problem, options.limits);
        let tree = SearchTree::new(joint.initial());
        let bounds = options.heeded_bounds();
        Self {
            most: bounds.most_difference(joint.problem()),
            joint,
            tree,
            bounds,
            pareto: options.pareto,
            live: None,
            next: 0,
            pairs: Pairs::default(),
            found: Vec::new(),
        }
    }

    fn check_limits(&self) -> Result<(), LimitReached> {
        let limits = self.joint.limits();
        if self.next.is_multiple_of(EXPANSIONS_BETWEEN_CHECKS) {
            limits.check_bytes(self.joint.bytes() + self.tree.bytes())?;
        }
        if self.next as u64 >= limits.expansions {
            return Err(LimitReached::Expansions { limit: limits.expansions });
        }
        Ok(())
    }

    /// Takes note of a node that may end a plan.
    fn note(&mut self, index: usize) {
        let node = self.tree.key(index);
        if self.joint.is_goal(node.state) {
            self.pairs.offer(&mut self.joint, &self.bounds, node.profile, index);
        }
    }

    fn finding(&self) -> Finding {
        self.pairs.finding(self.pareto, |index| self.tree.plan(index))
    }

    /// Whether no plan is worth more than the best one met.
    fn cannot_be_beaten(&self) -> bool {
        let best = self.pairs.best();
        !self.pareto && best.is_some_and(|(counts, _)| counts.difference() == self.most)
    }

    fn work(&mut self, live: &Live, budget: u64) -> Result<bool, LimitReached> {
        for _ in 0..budget {
            if self.next == self.tree.len() || self.cannot_be_beaten() {
                return Ok(true);
            }
            self.check_limits()?;
            let mut found = std::mem::take(&mut self.found);
            let node = self.tree.key(self.next);
            self.joint.expand(node, |state| live.contains(state), &mut found)?;
            for &(action, node) in &found {
                if let Some(index) = self.tree.meet(node, self.next, action) {
                    self.note(index);
                }
            }
            self.found = found;
            self.next += 1;
        }
        Ok(false)
    }
}

impl Engine for Closure {
    fn advance(&mut self, budget: u64) -> Result<Advance, LimitReached> {
        let live = match self.live.take() {
            Some(live) => live,
            None => {
                let live = Live::new(&mut self.joint)?;
                if !live.contains(self.tree.key(0).state) {
                    return Ok(Advance::Finished(self.finding()));
                }
                self.note(0);
                live
            }
        };
        let done = self.work(&live, budget);
        self.live = Some(live);
        if done? {
            return Ok(Advance::Finished(self.finding()));
        }
        Ok(Advance::Working)
    }

    fn stop(&mut self, limit: LimitReached) -> Finding {
        if self.pairs.best().is_some() {
            return self
                .pairs
                .stopped(self.pareto, self.most, limit, |index| self.tree.plan(index));
        }
        let live = self.live.as_ref();
        let way = live.and_then(|live| shortest_way(&mut self.joint, live, &self.bounds));
        stopped(way, self.most, limit)
    }

    fn report(&self, progress: &mut Progress) {
        progress.bound = Some(1.0);
        if let Some((counts, index)) = self.pairs.best() {
            progress.goal_difference = Some(self.joint.problem().goal_difference(counts));
            progress.plan = Some(self.tree.plan(index));
        }
    }

    fn stats(&self) -> Stats {
        let mut stats = Stats {
            expansions: self.next as u64,
            generated: self.tree.len() as u64,
            ..Stats::default()
        };
        stats.count_spaces(&self.joint);
        stats
    }
}
