//! Cost-bounded exploration: the best plan, every reachable pair or the best of each length among the
//! plans within a cost limit.
//!
//! What a plan achieves depends on the node (state, beliefs) it ends in, and what can still be done there
//! on what is left of the cost limit. So a node is met with *labels*, each with the cost of a way to it,
//! layer by layer of equal length (bicriterion paths: Hansen 1980):
//!
//! - over plans of any length a label is kept where it costs less than every label of its node before it,
//!   none of which is longer. So the first label with some survivor counts ends a shortest plan for them,
//!   and since costs only fall, there are finitely many, whatever actions cost nothing;
//! - where lengths matter a label is kept where it costs less than the others of its node in its layer.
//!
//! A label is left out where its cost and the [least cost](GoalCosts) of the way to the true goal are
//! beyond the limit.

use std::sync::Arc;

use rustc_hash::FxHashMap;

use super::Lengths;
use super::ends::Ends;
use super::pairs::Pairs;
use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::{JointSpace, Node, Problem, SurvivorCounts};
use crate::solver::Options;
use crate::solver::engine::{Advance, Engine, Finding};
use crate::solver::ground::dead_ends::TrueGoalDistances;
use crate::solver::ground::goal_costs::GoalCosts;
use crate::solver::ground::thresholds::VISITS_BETWEEN_CHECKS;
use crate::solver::outcome::{LengthPoint, Progress, ReachablePair, Stats, Status};
use crate::task::{Action, StateId};

/// A way to a node.
#[derive(Debug, Clone, Copy)]
struct Label {
    node: Node,
    cost: u64,
    parent: u32,
    action: Action,
}

/// What is known of the states before the exploration.
#[derive(Debug)]
struct Reach {
    costs: GoalCosts,
    /// Where lengths are bounded.
    distances: Option<TrueGoalDistances>,
}

/// An exploration at work.
#[derive(Debug)]
pub(in crate::solver) struct CostBounded {
    joint: JointSpace,
    ends: Ends,
    /// No plan can be worth more.
    most: i64,
    lengths: Lengths,
    cost_limit: u64,
    pairs_asked: bool,
    reach: Option<Reach>,
    labels: Vec<Label>,
    /// The least cost of each node: of all its labels, or of those of the layer being made.
    cheapest: FxHashMap<Node, u64>,
    /// The labels of the last finished layer, and the next one to expand.
    last: std::ops::Range<usize>,
    next: usize,
    length: usize,
    /// Of the labels that may end a plan.
    pairs: Pairs,
    /// The best label of each finished layer, where the best of each length is asked for.
    best: Vec<Option<(SurvivorCounts, usize)>>,
    expansions: u64,
    found: Vec<(Action, Node)>,
}

impl CostBounded {
    /// For plans of some lengths within the cost limit of the options.
    pub(in crate::solver) fn new(
        problem: Arc<Problem>,
        options: &Options,
        lengths: Lengths,
    ) -> Self {
        let bounds = options.heeded_bounds();
        let joint = JointSpace::listing(problem, options.limits);
        Self {
            most: bounds.most_difference(joint.problem()).unwrap_or_default(),
            ends: Ends::new(bounds),
            joint,
            lengths,
            cost_limit: options.cost_limit.unwrap_or(u64::MAX),
            pairs_asked: options.pairs,
            reach: None,
            labels: Vec::new(),
            cheapest: FxHashMap::default(),
            last: 0..0,
            next: 0,
            length: 0,
            pairs: Pairs::default(),
            best: Vec::new(),
            expansions: 0,
            found: Vec::new(),
        }
    }

    /// Takes note that no plan is worth more.
    pub(in crate::solver) fn bound(&mut self, most: i64) {
        self.most = self.most.min(most);
    }

    /// Looks at the states first, and meets the root.
    fn begin(&mut self) -> Result<Reach, LimitReached> {
        let costs = GoalCosts::new(&mut self.joint)?;
        let distances = match self.lengths {
            Lengths::Any => None,
            Lengths::Exactly(_) | Lengths::UpTo(_) => {
                Some(TrueGoalDistances::new(&mut self.joint)?)
            }
        };
        let reach = Reach { costs, distances };
        let node = self.joint.initial();
        self.meet(&reach, Label { node, cost: 0, parent: 0, action: Action::new(0) }, 0);
        self.finish_layer(0);
        Ok(reach)
    }

    /// The most actions of a plan.
    fn longest(&self) -> Option<usize> {
        match self.lengths {
            Lengths::Any => None,
            Lengths::Exactly(steps) | Lengths::UpTo(steps) => Some(steps),
        }
    }

    /// Meets a node after `steps` actions, at a cost.
    fn meet(&mut self, reach: &Reach, label: Label, steps: usize) {
        let state = label.node.state;
        let left = self.cost_limit - label.cost;
        if reach.costs.least(self.joint.states(), state).is_none_or(|least| least > left) {
            return;
        }
        if let (Some(longest), Some(distances)) = (self.longest(), &reach.distances)
            && distances.distance(state).is_none_or(|distance| distance > longest - steps)
        {
            return;
        }
        if self.cheapest.get(&label.node).is_some_and(|known| *known <= label.cost) {
            return;
        }
        self.cheapest.insert(label.node, label.cost);
        let number = self.labels.len();
        self.labels.push(label);
        if let Lengths::Exactly(horizon) = self.lengths
            && horizon != steps
        {
            return;
        }
        if let Some(counts) = self.ends.counts(&mut self.joint, label.node) {
            self.pairs.extend([(number, counts)]);
        }
    }

    /// The labels from a number on are a layer.
    fn finish_layer(&mut self, begin: usize) {
        self.last = begin..self.labels.len();
        self.next = begin;
        if self.lengths == Lengths::Any {
            return;
        }
        self.cheapest.clear();
        if let Lengths::UpTo(_) = self.lengths {
            let mut best: Option<(SurvivorCounts, usize)> = None;
            for number in self.last.clone() {
                let node = self.labels[number].node;
                let Some(counts) = self.ends.counts(&mut self.joint, node) else { continue };
                if best.is_none_or(|(known, _)| counts.difference() > known.difference()) {
                    best = Some((counts, number));
                }
            }
            self.best.push(best);
        }
    }

    /// Whether no plan is worth more than the best one met, and nothing else is asked.
    fn cannot_be_beaten(&self) -> bool {
        let best = || self.pairs.best().is_some_and(|(counts, _)| counts.difference() == self.most);
        self.lengths == Lengths::Any && !self.pairs_asked && best()
    }

    /// Whether there is nothing left to look at.
    fn is_over(&self) -> bool {
        let all = self.last.is_empty() || self.longest() == Some(self.length);
        all || self.cannot_be_beaten()
    }

    fn bytes(&self) -> u64 {
        let labels = size_of::<Label>() * self.labels.len();
        let cheapest = (size_of::<(Node, u64)>() + 1) * self.cheapest.len();
        let reach = self.reach.as_ref().map_or(0, |reach| reach.costs.bytes());
        self.joint.bytes() + (labels + cheapest) as u64 + reach
    }

    /// Expands the next label; the layer that it ends is finished.
    fn expand(&mut self, reach: &Reach) -> Result<(), LimitReached> {
        let limits = *self.joint.limits();
        if self.expansions >= limits.expansions {
            return Err(LimitReached::Expansions { limit: limits.expansions });
        }
        if self.expansions.is_multiple_of(VISITS_BETWEEN_CHECKS) {
            limits.check_bytes(self.bytes())?;
        }
        let number = self.next;
        let Label { node, cost, .. } = self.labels[number];
        // A cheaper way to the same node may have come later.
        let stale = self.lengths == Lengths::Any
            && self.cheapest.get(&node).is_some_and(|cheapest| *cheapest < cost);
        if !stale {
            let mut found = std::mem::take(&mut self.found);
            let reached = |state: StateId| reach.costs.may_reach(state);
            let expanded = self.joint.expand(node, reached, &mut found);
            self.expansions += 1;
            for &(action, node) in &found {
                let more = self.joint.problem().task().step_cost(action);
                let sum = cost.checked_add(more).filter(|sum| *sum <= self.cost_limit);
                if let Some(cost) = sum {
                    let label = Label { node, cost, parent: number as u32, action };
                    self.meet(reach, label, self.length + 1);
                }
            }
            self.found = found;
            expanded?;
        }
        self.next += 1;
        if self.next == self.last.end {
            self.length += 1;
            self.finish_layer(self.last.end);
        }
        Ok(())
    }

    /// The actions to a label.
    fn plan(&self, mut number: usize) -> Plan {
        let mut actions = Vec::new();
        while number != 0 {
            let label = &self.labels[number];
            actions.push(label.action);
            number = label.parent as usize;
        }
        actions.reverse();
        Plan { actions }
    }

    /// The best of each length whose layer is finished, up to the longest where all is over.
    fn points(&self, over: bool) -> Option<Vec<LengthPoint>> {
        let Lengths::UpTo(longest) = self.lengths else { return None };
        let last = if over { longest + 1 } else { self.best.len() };
        let point = |length: usize| {
            let best = self.best.get(length).copied().flatten();
            let best = best.map(|(counts, label)| ReachablePair { counts, plan: self.plan(label) });
            LengthPoint { length, best }
        };
        Some((0..last).map(point).collect())
    }

    fn finding(&self) -> Finding {
        let mut finding = self.pairs.finding(self.pairs_asked, |label| self.plan(label));
        finding.lengths = self.points(true);
        let any = self.lengths == Lengths::Any && finding.status == Status::Optimal;
        finding.length_proved = (any && !self.pairs_asked).then_some(true);
        finding
    }
}

impl Engine for CostBounded {
    fn advance(&mut self, budget: u64) -> Result<Advance, LimitReached> {
        let reach = match self.reach.take() {
            Some(reach) => reach,
            None => self.begin()?,
        };
        let mut done = Ok(());
        for _ in 0..budget {
            if self.is_over() || done.is_err() {
                break;
            }
            done = self.expand(&reach);
        }
        self.reach = Some(reach);
        done?;
        Ok(if self.is_over() { Advance::Finished(self.finding()) } else { Advance::Working })
    }

    fn stop(&mut self, limit: LimitReached) -> Finding {
        let plan = |label| self.plan(label);
        let mut finding = self.pairs.stopped(self.pairs_asked, self.most, limit, plan);
        finding.lengths = self.points(false);
        finding
    }

    fn report(&self, progress: &mut Progress) {
        let problem = self.joint.problem();
        progress.bound = Some(self.most as f64 / (problem.goals().len() - 1) as f64);
        if let Some((counts, label)) = self.pairs.best() {
            progress.goal_difference = Some(problem.goal_difference(counts));
            progress.plan = Some(self.plan(label));
        }
    }

    fn stats(&self) -> Stats {
        let mut stats = Stats {
            expansions: self.expansions,
            generated: self.labels.len() as u64,
            ..Stats::default()
        };
        stats.count_spaces(&self.joint);
        stats
    }
}
