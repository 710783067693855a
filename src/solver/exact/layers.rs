//! The best plans of exactly T actions, step by step.

use std::sync::Arc;

use super::pairs::{Pairs, allowed, stopped};
use crate::limits::LimitReached;
use crate::problem::{JointSpace, Node, Problem};
use crate::solver::engine::{Advance, Engine, Finding};
use crate::solver::live::LiveLayers;
use crate::solver::outcome::{ParetoPoint, Progress, Stats};
use crate::solver::tree::SearchTree;
use crate::solver::{Bounds, Options};
use crate::task::Action;

/// How many nodes are expanded between two looks at the memory.
const EXPANSIONS_BETWEEN_CHECKS: u64 = 64;

/// When stopped early, this many nodes are followed to the goal at most,
const FINISHED_ON_STOP: usize = 256;
/// and no more once so many believed states have been gone through: who stops does not want to
/// wait.
const STATES_ON_STOP: usize = 4_000_000;

/// Exact search at a horizon.
#[derive(Debug)]
pub(in crate::solver) struct Layers {
    joint: JointSpace,
    bounds: Bounds,
    pareto: bool,
    horizon: usize,
    live: Option<LiveLayers>,
    /// Nodes of all layers one after the other; a node met in two layers is there twice.
    tree: SearchTree<Node>,
    /// Where the present layer begins and ends, and the next node of it to expand.
    layer: std::ops::Range<usize>,
    next: usize,
    step: usize,
    expansions: u64,
    found: Vec<(Action, Node)>,
}

impl Layers {
    pub(in crate::solver) fn new(problem: Arc<Problem>, options: &Options, horizon: usize) -> Self {
        let mut joint = JointSpace::new(problem, options.limits);
        let mut tree = SearchTree::new(joint.initial());
        // The next layer may hold the first node again, as every layer may those before it.
        tree.forget();
        Self {
            joint,
            tree,
            bounds: options.heeded_bounds(),
            pareto: options.pareto,
            horizon,
            live: None,
            layer: 0..1,
            next: 0,
            step: 0,
            expansions: 0,
            found: Vec::new(),
        }
    }

    fn check_limits(&self) -> Result<(), LimitReached> {
        let limits = self.joint.limits();
        if self.expansions.is_multiple_of(EXPANSIONS_BETWEEN_CHECKS) {
            limits.check_bytes(self.joint.bytes() + self.tree.bytes())?;
        }
        if self.expansions >= limits.expansions {
            return Err(LimitReached::Expansions { limit: limits.expansions });
        }
        Ok(())
    }

    fn expand(&mut self, live: &LiveLayers, index: usize) -> Result<(), LimitReached> {
        let node = self.tree.key(index);
        let keep = |state| live.contains(self.step + 1, state);
        self.joint.expand(node, keep, &mut self.found)?;
        self.expansions += 1;
        for &(action, node) in &self.found {
            self.tree.meet(node, index, action);
        }
        Ok(())
    }

    fn finish(&mut self) -> Finding {
        let mut pairs = Pairs::default();
        for index in self.layer.clone() {
            let profile = self.tree.key(index).profile;
            pairs.offer(&mut self.joint, &self.bounds, profile, index);
        }
        pairs.finding(self.pareto, |index| self.tree.plan(index))
    }

    /// Follows a node to the goal along the first live transitions, as long as `room` for believed
    /// states lasts.
    fn follow(
        &mut self,
        index: usize,
        room: &mut usize,
    ) -> Result<Option<ParetoPoint>, LimitReached> {
        let Some(live) = &self.live else { return Ok(None) };
        let mut plan = self.tree.plan(index);
        let mut node = self.tree.key(index);
        for step in plan.len()..self.horizon {
            self.joint.states_mut().expand(node.state);
            let mut edges = self.joint.states().edges(node.state).iter();
            let first = edges.find(|edge| live.contains(step + 1, edge.target));
            let Some(target) = first.map(|edge| edge.target) else { return Ok(None) };
            for observer in 0..self.joint.problem().observers().len() {
                let belief = self.joint.belief(node.profile, observer);
                *room = room.saturating_sub(self.joint.beliefs(observer).members(belief).len());
            }
            if *room == 0 {
                return Ok(None);
            }
            self.joint.expand(node, |state| state == target, &mut self.found)?;
            let Some(&(action, next)) = self.found.first() else { return Ok(None) };
            plan.actions.push(action);
            node = next;
        }
        let counts = self.joint.counts(node.profile);
        let fits = allowed(&mut self.joint, &self.bounds, node.profile, counts);
        Ok(fits.then_some(ParetoPoint { counts, plan }))
    }
}

impl Engine for Layers {
    fn advance(&mut self, budget: u64) -> Result<Advance, LimitReached> {
        let live = match self.live.take() {
            Some(live) => live,
            None => {
                let live = LiveLayers::new(&mut self.joint, self.horizon)?;
                if !live.contains(0, self.tree.key(0).state) {
                    self.layer = 0..0;
                    return Ok(Advance::Finished(self.finish()));
                }
                live
            }
        };
        let mut worked = Ok(());
        for _ in 0..budget {
            if self.next == self.layer.end && self.step < self.horizon {
                self.layer = self.layer.end..self.tree.len();
                self.step += 1;
                self.tree.forget();
            }
            if self.step == self.horizon {
                break;
            }
            worked = self.check_limits().and_then(|()| self.expand(&live, self.next));
            if worked.is_err() {
                break;
            }
            self.next += 1;
        }
        self.live = Some(live);
        worked?;
        if self.step == self.horizon {
            return Ok(Advance::Finished(self.finish()));
        }
        Ok(Advance::Working)
    }

    fn stop(&mut self, limit: LimitReached) -> Finding {
        let mut points: Vec<ParetoPoint> = Vec::new();
        let mut room = STATES_ON_STOP;
        let stride = self.layer.len().div_ceil(FINISHED_ON_STOP).max(1);
        for index in self.layer.clone().step_by(stride) {
            let Ok(followed) = self.follow(index, &mut room) else { break };
            if let Some(point) = followed
                && points.iter().all(|known| known.counts != point.counts)
            {
                points.push(point);
            }
        }
        // Of equal ones the first.
        let best = points.iter().rev().max_by_key(|point| point.counts.difference());
        let most = self.bounds.most_difference(self.joint.problem());
        let mut finding = stopped(best.cloned(), most, limit);
        points.sort_unstable_by_key(|point| point.counts);
        finding.pareto = self.pareto.then_some(points);
        finding
    }

    fn report(&self, progress: &mut Progress) {
        progress.bound = Some(1.0);
    }

    fn stats(&self) -> Stats {
        let mut stats = Stats {
            expansions: self.expansions,
            generated: self.tree.len() as u64,
            ..Stats::default()
        };
        stats.count_spaces(&self.joint);
        stats
    }
}
