//! The nearest shorter and the nearest longer horizon at which a plan keeps the bounds.

use std::sync::Arc;

use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::{JointSpace, Problem};
use crate::solver::engine::{Advance, Engine};
use crate::solver::exact;
use crate::solver::exact::ends::Ends;
use crate::solver::exact::layered::LayeredGraph;
use crate::solver::live::Live;
use crate::solver::{MAX_HORIZON, Options};

/// How many horizons on either side are tried one by one, before all are gone through in one go.
/// One horizon alone is searched faster than many, since nothing is looked at that cannot be part of
/// a plan of that length; and most often the next but one has a plan.
const TRIED_ALONE: usize = 3;

/// A search at horizons around the one asked for.
pub(super) struct Horizons {
    problem: Arc<Problem>,
    options: Options,
    asked: usize,
    /// Whether a shorter one and a longer one are still looked for.
    shorter: bool,
    longer: bool,
    /// Horizons to try alone, the last first.
    tries: Vec<usize>,
    trying: Option<(usize, Box<dyn Engine>)>,
    all: Option<All>,
    expansions: u64,
    /// Plans at other horizons, at most one on either side.
    pub(super) found: Vec<Plan>,
}

/// All horizons from 0 on.
struct All {
    joint: JointSpace,
    live: Live,
    graph: LayeredGraph,
    ends: Ends,
    /// The longest length below the horizon asked for that has a plan.
    below: Option<usize>,
}

impl Horizons {
    /// `shortest` is the length of a shortest plan for the true goal, whatever anybody believes.
    pub(super) fn new(
        problem: Arc<Problem>,
        options: Options,
        asked: usize,
        shortest: usize,
    ) -> Self {
        let from = shortest.max(asked + 1);
        let longer = (from..=MAX_HORIZON).take(TRIED_ALONE);
        let shorter = (shortest..asked).rev().take(TRIED_ALONE);
        let mut tries: Vec<usize> = Vec::new();
        for horizon in longer.chain(shorter) {
            let by = |horizon: usize| horizon.abs_diff(asked);
            let place = tries.partition_point(|&known| by(known) > by(horizon));
            tries.insert(place, horizon);
        }
        Self {
            problem,
            options,
            asked,
            shorter: shortest < asked,
            longer: from <= MAX_HORIZON,
            tries,
            trying: None,
            all: None,
            expansions: 0,
            found: Vec::new(),
        }
    }

    /// The nodes expanded so far.
    pub(super) fn expansions(&self) -> u64 {
        let trying = self.trying.as_ref().map_or(0, |(_, engine)| engine.stats().expansions);
        let all = self.all.as_ref().map_or(0, |all| all.graph.visits());
        self.expansions + trying + all
    }

    /// The horizon being worked on.
    pub(super) fn horizon(&self) -> Option<usize> {
        let all = || self.all.as_ref().map(|all| all.graph.length() + 1);
        self.trying.as_ref().map(|(horizon, _)| *horizon).or_else(all)
    }

    /// Works for about `budget` expansions; true when nothing is left to look for.
    pub(super) fn advance(&mut self, budget: u64) -> Result<bool, LimitReached> {
        if !self.shorter && !self.longer {
            return Ok(true);
        }
        if let Some((horizon, engine)) = self.trying.take() {
            self.attempt(horizon, engine, budget)?;
            return Ok(false);
        }
        if self.all.is_none() {
            while let Some(horizon) = self.tries.pop() {
                if if horizon < self.asked { self.shorter } else { self.longer } {
                    let (problem, options) = (Arc::clone(&self.problem), self.rest());
                    let engine = exact::engine(problem, &options, Some(horizon));
                    self.trying = Some((horizon, engine));
                    return Ok(false);
                }
            }
            self.all = Some(All::new(&self.problem, &self.rest())?);
        }
        self.go_through(budget)
    }

    /// The options with what is left of the expansions allowed.
    fn rest(&self) -> Options {
        let mut options = self.options.clone();
        options.limits.expansions = options.limits.expansions.saturating_sub(self.expansions());
        options
    }

    fn attempt(
        &mut self,
        horizon: usize,
        mut engine: Box<dyn Engine>,
        budget: u64,
    ) -> Result<(), LimitReached> {
        let (plan, stopped) = match engine.advance(budget) {
            Ok(Advance::Working) => {
                self.trying = Some((horizon, engine));
                return Ok(());
            }
            Ok(Advance::Finished(finding)) => (finding.plan, Ok(())),
            Err(limit) => (engine.stop(limit).plan, Err(limit)),
        };
        self.expansions += engine.stats().expansions;
        if let Some(plan) = plan {
            self.settle(plan);
        }
        stopped
    }

    fn settle(&mut self, plan: Plan) {
        if plan.len() < self.asked {
            self.shorter = false;
        } else {
            self.longer = false;
        }
        self.found.push(plan);
    }

    /// All lengths one after the other, until those that are looked for are found or cannot come
    /// any more.
    fn go_through(&mut self, budget: u64) -> Result<bool, LimitReached> {
        let Some(mut all) = self.all.take() else { return Ok(true) };
        let went = self.go_through_all(&mut all, budget);
        self.all = Some(all);
        went
    }

    fn go_through_all(&mut self, all: &mut All, mut budget: u64) -> Result<bool, LimitReached> {
        loop {
            let All { joint, live, graph, .. } = all;
            if !graph.advance(joint, &mut budget, |state| live.contains(state), |_| true)? {
                return Ok(false);
            }
            all.ends.note(&mut all.joint, &self.options.bounds, &all.graph);
            let length = all.graph.length();
            let best = all.ends.best(&all.graph, length);
            if length < self.asked && best.is_some() {
                all.below = Some(length);
            }
            let over = all.graph.ended() || all.graph.repeats(self.asked);
            if self.shorter && (length + 1 >= self.asked || over) {
                self.shorter = false;
                if let Some(below) = all.below {
                    self.found.extend(all.plan(below));
                }
            }
            if self.longer && length > self.asked && best.is_some() {
                self.longer = false;
                self.found.extend(all.plan(length));
            }
            self.longer &= !over && length < MAX_HORIZON;
            if !self.shorter && !self.longer {
                return Ok(true);
            }
        }
    }
}

impl All {
    fn new(problem: &Arc<Problem>, options: &Options) -> Result<Self, LimitReached> {
        let mut joint = JointSpace::new(Arc::clone(problem), options.limits);
        let live = Live::new(&mut joint)?;
        let graph = LayeredGraph::new(&mut joint);
        let mut ends = Ends::default();
        ends.note(&mut joint, &options.bounds, &graph);
        let below = ends.best(&graph, 0).map(|_| 0);
        Ok(Self { joint, live, graph, ends, below })
    }

    /// The best plan of this length.
    fn plan(&self, length: usize) -> Option<Plan> {
        let (node, _) = self.ends.best(&self.graph, length)?;
        Some(self.graph.plan(&self.graph.sources(), length, node))
    }
}
