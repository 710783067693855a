//! Exact search that is given a first plan where it finds none: an incumbent.
//!
//! Best first over nodes, the optimiser follows values and can go long without a plan where beliefs are large. Then the
//! [means for a first plan](super::first_plan) have their share, and the optimiser goes on for a better one. As in integer
//! programming a plan from elsewhere changes no proof: it raises what is aimed at. While both are there each has a share
//! of the memory. Where the optimiser needs more, the means give theirs up; where it has had all of it and has no plan, it
//! is the means that have it all, and the bound that is proved stays.
//!
//! Source: Berthold 2006, "Primal heuristics for mixed integer programs" (urn:nbn:de:0297-zib-10293).

use std::sync::Arc;

use super::first_plan::{FirstPlan, left};
use crate::limits::LimitReached;
use crate::problem::Problem;
use crate::solver::Options;
use crate::solver::engine::{Advance, Engine, Finding};
use crate::solver::ground::thresholds::{
    GREEDY_NODES, SHARE_OF_MEMORY, TIMES_AS_MUCH_WORK, WORK_AFTER_MEANS, WORK_WITHOUT_PLAN,
};
use crate::solver::optimiser::Optimiser;
use crate::solver::outcome::{Progress, Stats};
use crate::solver::parallel_walks;
use crate::trace::validate_within;

/// The optimiser and, for a while, the means for a first plan.
pub(in crate::solver) struct BestPlan {
    problem: Arc<Problem>,
    options: Options,
    optimiser: Optimiser,
    /// How much work of the optimiser without a plan brings their next round.
    work: u64,
    /// Nodes of the first turn of Algorithm 1.
    nodes: u64,
    means: Means,
    /// The limit that the optimiser has met.
    met: Option<LimitReached>,
    /// Work of means that have come to their end.
    earlier: Stats,
}

/// The means for a first plan.
enum Means {
    Untried,
    /// They have had a round.
    Waiting(Box<FirstPlan>),
    AtWork(Box<FirstPlan>),
    /// The optimiser has all of the memory: theirs was too little, or its own.
    GaveWay,
    Over,
}

impl BestPlan {
    /// Over plans of all lengths.
    pub(in crate::solver) fn new(problem: Arc<Problem>, options: &Options) -> Self {
        Self::with(WORK_WITHOUT_PLAN, GREEDY_NODES, problem, options)
    }

    /// With `work` of the optimiser before a first plan is looked for and `nodes` for Algorithm 1.
    pub(super) fn with(work: u64, nodes: u64, problem: Arc<Problem>, options: &Options) -> Self {
        Self {
            optimiser: Optimiser::new(Arc::clone(&problem), options, None),
            problem,
            options: options.clone(),
            work,
            nodes,
            means: Means::Untried,
            met: None,
            earlier: Stats::default(),
        }
    }

    /// After the first round of the means for a first plan.
    pub(super) fn after(first: Box<FirstPlan>, problem: Arc<Problem>, options: &Options) -> Self {
        let engine = Self::with(WORK_AFTER_MEANS, GREEDY_NODES, problem, options);
        Self { means: Means::Waiting(first), ..engine }
    }

    /// With another optimiser.
    #[cfg(test)]
    pub(super) fn with_optimiser(self, optimiser: Optimiser) -> Self {
        Self { optimiser, ..self }
    }

    /// Whether the optimiser has all of the memory.
    #[cfg(test)]
    pub(super) fn gave_way(&self) -> bool {
        matches!(self.means, Means::GaveWay)
    }

    /// Whether there is a plan.
    #[cfg(test)]
    pub(super) fn has_plan(&self) -> bool {
        self.optimiser.has_plan()
    }

    /// Whether the next round of the means is due.
    fn is_due(&self) -> bool {
        match self.means {
            Means::Untried => {
                self.optimiser.lacks_plan(self.work) || self.optimiser.lacks_plan_after_samples()
            }
            Means::Waiting(_) => self.optimiser.lacks_plan(self.work),
            Means::AtWork(_) | Means::GaveWay | Means::Over => false,
        }
    }

    fn begin_round(&mut self) {
        let mut options = left(&self.options, &self.stats());
        let first = match std::mem::replace(&mut self.means, Means::Over) {
            Means::Waiting(mut first) => {
                first.go_on();
                first
            }
            _ => {
                if self.met.is_none() {
                    let free = options.limits.bytes.saturating_sub(self.optimiser.bytes());
                    options.limits.bytes = free.min(self.share());
                }
                let problem = Arc::clone(&self.problem);
                let mut first = FirstPlan::new(self.nodes, problem, &options, None);
                first.go_on();
                Box::new(first)
            }
        };
        self.means = Means::AtWork(first);
        self.work = self.work.saturating_mul(TIMES_AS_MUCH_WORK);
    }

    /// The means have come to the end of a round, or to their own, perhaps with a plan.
    fn end_round(&mut self, first: Box<FirstPlan>, end: Result<Option<Finding>, LimitReached>) {
        let alone = self.met.is_some();
        if matches!(end, Ok(None)) && first.has_another_round() && !alone {
            self.means = Means::Waiting(first);
            return;
        }
        let too_little = matches!(end, Err(LimitReached::Memory { .. })) && !alone;
        self.means = if too_little { Means::GaveWay } else { Means::Over };
        self.leave(first.as_ref());
        let Ok(Some(Finding { plan: Some(plan), witnesses, .. })) = end else { return };
        let limits = self.options.limits;
        let bounds = self.options.heeded_bounds();
        let witnesses = parallel_walks::beside(&self.problem, &plan, witnesses, limits);
        if let Ok(achieved) = validate_within(&self.problem, &plan, &witnesses, limits)
            && bounds.allow(achieved.counts, &achieved.survivors)
        {
            self.optimiser.learn(achieved.counts, plan, witnesses);
        }
    }

    /// The means are left for good.
    fn leave(&mut self, first: &FirstPlan) {
        let stats = first.stats();
        self.earlier.add_engine(&stats);
        self.optimiser.lower_limit(stats.expansions);
    }

    /// Bytes for the optimiser, and for the means, while both are there.
    fn share(&self) -> u64 {
        self.options.limits.bytes / SHARE_OF_MEMORY
    }

    /// Leaves waiting means whose share the optimiser needs.
    fn make_way(&mut self) {
        let needed =
            matches!(self.means, Means::Waiting(_)) && self.optimiser.outgrows(self.share());
        if needed && let Means::Waiting(first) = std::mem::replace(&mut self.means, Means::GaveWay)
        {
            self.leave(&first);
        }
    }

    fn advance_means(&mut self, mut first: Box<FirstPlan>) -> Advance {
        match first.advance(1) {
            Ok(Advance::Working) if !first.is_over() => self.means = Means::AtWork(first),
            Ok(Advance::Working) => self.end_round(first, Ok(None)),
            Ok(Advance::Finished(finding)) if finding.plan.is_some() => {
                self.end_round(first, Ok(Some(finding)));
            }
            // Proved: there is no plan.
            Ok(answer) => {
                self.earlier.add_engine(&first.stats());
                return answer;
            }
            Err(limit) => self.end_round(first, Err(limit)),
        }
        Advance::Working
    }
}

impl Engine for BestPlan {
    fn advance(&mut self, budget: u64) -> Result<Advance, LimitReached> {
        if matches!(self.means, Means::AtWork(_))
            && let Means::AtWork(first) = std::mem::replace(&mut self.means, Means::Over)
        {
            return Ok(self.advance_means(first));
        }
        if let Some(limit) = self.met {
            return Err(limit);
        }
        for _ in 0..budget {
            self.make_way();
            match self.optimiser.advance(1) {
                Ok(Advance::Working) => {}
                Err(LimitReached::Expansions { .. }) => {
                    let limit = self.options.limits.expansions;
                    return Err(LimitReached::Expansions { limit });
                }
                Err(limit) if !matches!(self.means, Means::Over) && !self.optimiser.has_plan() => {
                    self.met = Some(limit);
                    self.optimiser.leave_off();
                    self.begin_round();
                    break;
                }
                answer => return answer,
            }
            if self.is_due() {
                self.begin_round();
                break;
            }
        }
        Ok(Advance::Working)
    }

    fn stop(&mut self, limit: LimitReached) -> Finding {
        self.optimiser.stop(limit)
    }

    fn report(&self, progress: &mut Progress) {
        self.optimiser.report(progress);
    }

    fn stats(&self) -> Stats {
        let mut stats = self.optimiser.stats();
        stats.add_engine(&self.earlier);
        if let Means::Waiting(first) | Means::AtWork(first) = &self.means {
            stats.add_engine(&first.stats());
        }
        stats
    }
}
