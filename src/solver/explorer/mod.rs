//! Exhaustive questions: every reachable pair of survivor counts, the best of each length, and what
//! there is at other horizons.
//!
//! What a plan achieves depends on the node (state, beliefs) it ends in and on nothing else, so two
//! plans that meet in a node need not be told apart: going through all nodes is going through all
//! plans. The explorer goes through them layer by layer, and expands each once:
//!
//! - [`layers`] are the nodes that plans of each length lead to,
//! - [`ends`] are those among them that may end a plan,
//! - [`pairs`] are the pairs of survivor counts of these,
//! - [`cost_bounded`] asks the same of plans within a cost limit,
//! - [`neighbourhood`] looks at the horizons around one that has no plan.
//!
//! Nothing is looked at that cannot reach the true goal any more. Every reachable pair is more than
//! the Pareto front that the paper names and leaves out.

pub(super) mod cost_bounded;
mod ends;
mod layers;
pub(super) mod neighbourhood;
mod pairs;

use std::sync::Arc;

use fixedbitset::FixedBitSet;

use super::engine::{Advance, Engine, Finding};
use super::ground::completion::{self, complete};
use super::ground::dead_ends::{StatesBySteps, TrueGoalDistances};
use super::outcome::{LengthPoint, Progress, ReachablePair, Stats};
use super::{Bounds, Options};
use crate::limits::LimitReached;
use crate::problem::{JointSpace, Problem};
use crate::solver::ground::thresholds::{COMPLETIONS, STATES_OF_A_COMPLETION};
use crate::task::StateId;
use ends::{Ends, best};
use layers::{Layers, Membership};
use pairs::{Pairs, stopped};

/// The lengths of the plans that are looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Lengths {
    /// All.
    Any,
    /// Exactly this one.
    Exactly(usize),
    /// Each from 0 to this one, and the best of each.
    UpTo(usize),
}

/// The states that may be in a layer.
#[derive(Debug)]
enum Kept {
    /// Those that can still reach the true goal, or reach it soon enough.
    Distances(TrueGoalDistances),
    /// At a horizon, those that can end a plan of exactly its length; and for each step all that can
    /// at that step or a later one.
    Steps(StatesBySteps, Vec<FixedBitSet>),
}

/// An exploration at work.
#[derive(Debug)]
pub(super) struct Explorer {
    joint: JointSpace,
    bounds: Bounds,
    /// No plan can be worth more.
    most: i64,
    lengths: Lengths,
    /// Whether all pairs are asked for.
    pairs_asked: bool,
    kept: Option<Kept>,
    layers: Layers,
    ends: Ends,
    /// Over more than one length, of the nodes met.
    pairs: Pairs,
}

impl Explorer {
    pub(super) fn new(problem: Arc<Problem>, options: &Options, lengths: Lengths) -> Self {
        let mut joint = JointSpace::listing(problem, options.limits);
        let bounds = options.heeded_bounds();
        let membership = match lengths {
            Lengths::Any => Membership::First,
            Lengths::Exactly(_) | Lengths::UpTo(_) => Membership::Every,
        };
        Self {
            layers: Layers::new(&mut joint, membership),
            most: bounds.most_difference(joint.problem()).unwrap_or_default(),
            ends: Ends::new(bounds.clone()),
            joint,
            bounds,
            lengths,
            pairs_asked: options.pairs,
            kept: None,
            pairs: Pairs::default(),
        }
    }

    fn keep(&mut self) -> Result<Kept, LimitReached> {
        let Lengths::Exactly(horizon) = self.lengths else {
            return Ok(Kept::Distances(TrueGoalDistances::new(&mut self.joint)?));
        };
        let steps = StatesBySteps::new(&mut self.joint, horizon)?;
        let mut later = FixedBitSet::new();
        let mut from: Vec<FixedBitSet> = Vec::with_capacity(horizon + 1);
        for step in (0..=horizon).rev() {
            later.grow(steps.at(step).len());
            later.union_with(steps.at(step));
            from.push(later.clone());
        }
        from.reverse();
        let bytes: usize = from.iter().map(|states| states.len() / 8).sum();
        self.joint.limits().check_bytes(self.joint.bytes() + bytes as u64)?;
        Ok(Kept::Steps(steps, from))
    }

    /// Takes note of the nodes that may end a plan.
    fn note(&mut self) {
        if !matches!(self.lengths, Lengths::Exactly(_)) {
            self.pairs.extend(self.ends.note(&mut self.joint, &self.layers).iter().copied());
        }
    }

    /// Whether no plan is worth more than the best one met, and nothing else is asked.
    fn cannot_be_beaten(&self) -> bool {
        let best = || self.pairs.best().is_some_and(|(counts, _)| counts.difference() == self.most);
        self.lengths == Lengths::Any && !self.pairs_asked && best()
    }

    /// Visits nodes; true when there is nothing left to look at.
    fn work(&mut self, kept: &Kept, mut budget: u64) -> Result<bool, LimitReached> {
        let limits = *self.joint.limits();
        let (joint, layers) = (&mut self.joint, &mut self.layers);
        match (self.lengths, kept) {
            (Lengths::Exactly(horizon), Kept::Steps(steps, from)) => {
                while layers.length() < horizon {
                    let next = layers.length() + 1;
                    let count = |state: StateId| from[next].contains(state.index());
                    let keep = |state| steps.contains(next, state);
                    if !layers.advance(joint, &mut budget, &limits, count, keep)? {
                        return Ok(false);
                    }
                }
            }
            (Lengths::UpTo(longest), Kept::Distances(distances)) => {
                while layers.length() < longest && !layers.ended() {
                    let left = longest - layers.length() - 1;
                    let fits = |state| distances.distance(state).is_some_and(|steps| steps <= left);
                    if !layers.advance(joint, &mut budget, &limits, fits, fits)? {
                        return Ok(false);
                    }
                }
            }
            (_, Kept::Distances(distances)) => {
                while !self.layers.ended() && !self.cannot_be_beaten() {
                    if budget == 0 {
                        return Ok(false);
                    }
                    budget -= 1;
                    // One at a time, so that the end does not depend on slices.
                    let distances = |state| distances.reach_from(state);
                    self.layers.advance(&mut self.joint, &mut 1, &limits, distances, distances)?;
                    self.note();
                }
            }
            (_, Kept::Steps(..)) => {}
        }
        self.note();
        Ok(true)
    }

    /// The nodes of the last layer that end a plan of the horizon.
    fn last_pairs(&mut self) -> Pairs {
        let mut pairs = Pairs::default();
        for &number in self.layers.last() {
            let node = self.layers.node(number as usize);
            pairs.extend(self.ends.counts(&mut self.joint, node).map(|it| (number as usize, it)));
        }
        pairs
    }

    /// The best of each length whose layer is finished.
    fn points(&self, last: usize) -> Vec<LengthPoint> {
        let before = self.layers.predecessors();
        let point = |length| {
            let finished = length <= self.layers.length();
            let ends = finished.then(|| self.ends.of(self.layers.set(length)));
            let best = ends.and_then(best).map(|(node, counts)| ReachablePair {
                counts,
                plan: self.layers.plan(&before, length, node, |length| length),
            });
            LengthPoint { length, best }
        };
        (0..=last).map(point).collect()
    }

    fn finding(&mut self) -> Finding {
        if let Lengths::Exactly(horizon) = self.lengths {
            let pairs = self.last_pairs();
            let before = self.layers.predecessors();
            let plan = |node| self.layers.plan(&before, horizon, node, |length| length);
            return pairs.finding(self.pairs_asked, plan);
        }
        let mut finding = self.pairs.finding(self.pairs_asked, |node| self.layers.shortest(node));
        if let Lengths::UpTo(longest) = self.lengths {
            finding.lengths = Some(self.points(longest));
        }
        finding
    }

    /// Plans of the horizon that go on greedily from nodes of the last layer, one for each pair.
    fn completions(&mut self, horizon: usize) -> Vec<ReachablePair> {
        let Some(Kept::Steps(steps, _)) = &self.kept else { return Vec::new() };
        let mut points: Vec<ReachablePair> = Vec::new();
        let mut room = STATES_OF_A_COMPLETION;
        let before = self.layers.predecessors();
        let (last, length) = (self.layers.last(), self.layers.length());
        let stride = last.len().div_ceil(COMPLETIONS).max(1);
        for &number in last.iter().step_by(stride) {
            let number = number as usize;
            let begin = self.layers.plan(&before, length, number, |length| length);
            let from = (self.layers.node(number), begin);
            let leads = |left, state| steps.contains(horizon - left, state);
            let left = horizon - length;
            let completed = complete(&mut self.joint, &self.bounds, from, left, leads, &mut room);
            let Ok(completed) = completed else { break };
            if let Some(point) = completed
                && points.iter().all(|known| known.counts != point.counts)
            {
                points.push(point);
            }
        }
        points
    }
}

impl Engine for Explorer {
    fn advance(&mut self, budget: u64) -> Result<Advance, LimitReached> {
        let kept = match self.kept.take() {
            Some(kept) => kept,
            None => {
                let kept = self.keep()?;
                let root = self.layers.node(0).state;
                let possible = match &kept {
                    Kept::Distances(distances) => distances.reach_from(root),
                    Kept::Steps(steps, _) => steps.contains(0, root),
                };
                if !possible {
                    let mut finding = Finding::infeasible();
                    finding.pairs = self.pairs_asked.then(Vec::new);
                    if let Lengths::UpTo(longest) = self.lengths {
                        finding.lengths = Some(self.points(longest));
                    }
                    return Ok(Advance::Finished(finding));
                }
                self.note();
                kept
            }
        };
        let done = self.work(&kept, budget);
        self.kept = Some(kept);
        if done? {
            return Ok(Advance::Finished(self.finding()));
        }
        Ok(Advance::Working)
    }

    fn stop(&mut self, limit: LimitReached) -> Finding {
        if let Lengths::Exactly(horizon) = self.lengths {
            let mut points = self.completions(horizon);
            // Of equal ones the first.
            let best = points.iter().rev().max_by_key(|point| point.counts.difference());
            let mut finding = stopped(best.cloned(), self.most, limit);
            points.sort_unstable_by_key(|point| point.counts);
            finding.pairs = self.pairs_asked.then_some(points);
            return finding;
        }
        self.note();
        let mut finding = match self.pairs.best() {
            None if self.lengths == Lengths::Any => {
                let shortest = match &self.kept {
                    Some(Kept::Distances(distances)) => {
                        completion::shortest(&mut self.joint, distances, &self.bounds)
                    }
                    _ => None,
                };
                stopped(shortest, self.most, limit)
            }
            _ => self
                .pairs
                .stopped(self.pairs_asked, self.most, limit, |node| self.layers.shortest(node)),
        };
        if let Lengths::UpTo(_) = self.lengths {
            finding.lengths = Some(self.points(self.layers.length()));
        }
        finding
    }

    fn report(&self, progress: &mut Progress) {
        let problem = self.joint.problem();
        progress.bound = Some(self.most as f64 / (problem.goals().len() - 1) as f64);
        if let Lengths::UpTo(longest) = self.lengths {
            progress.horizon = Some(longest.min(self.layers.length() + 1));
        }
        if let Some((counts, node)) = self.pairs.best() {
            progress.goal_difference = Some(problem.goal_difference(counts));
            progress.plan = Some(self.layers.shortest(node));
        }
    }

    fn stats(&self) -> Stats {
        let mut stats = Stats {
            expansions: self.layers.expansions(),
            generated: self.layers.len() as u64,
            ..Stats::default()
        };
        stats.count_spaces(&self.joint);
        stats
    }
}
