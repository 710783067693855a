//! Exact search that is given a first plan where it finds none: an incumbent.
//!
//! Best first over nodes, the optimiser follows values and can go long without a plan where beliefs are large. Then the
//! [means for a first plan](super::first_plan) have their share, and the optimiser goes on for a better one. As in integer
//! programming a plan from elsewhere changes no proof: it raises what is aimed at. Where the optimiser runs out of memory
//! before they had theirs, they have it all, and the bound that is proved stays.
//!
//! Source: Berthold 2006, "Primal heuristics for mixed integer programs" (urn:nbn:de:0297-zib-10293).

use std::sync::Arc;

use super::first_plan::{FirstPlan, GREEDY_NODES, left};
use crate::limits::LimitReached;
use crate::problem::Problem;
use crate::solver::Options;
use crate::solver::engine::{Advance, Engine, Finding};
use crate::solver::optimiser::Optimiser;
use crate::solver::outcome::{Progress, Stats};
use crate::solver::parallel_walks;
use crate::trace::validate_within;

/// Believed states gone through and nodes expanded by the optimiser without a plan, after which one is looked for elsewhere:
/// about half a second.
const WORK_WITHOUT_PLAN: u64 = 3_000_000;

/// Of the memory limit the part that looking for a first plan may take beside the optimiser: one of so many.
const SHARE_OF_MEMORY: u64 = 4;

/// The optimiser and, for a while, the means for a first plan.
pub(in crate::solver) struct BestPlan {
    problem: Arc<Problem>,
    options: Options,
    optimiser: Optimiser,
    work: u64,
    nodes: u64,
    first: Option<Box<FirstPlan>>,
    /// How far they have been tried.
    tried: Tried,
    /// The limit that the optimiser has met.
    met: Option<LimitReached>,
    /// Their work.
    earlier: Stats,
}

/// How far the means for a first plan have been tried.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Tried {
    No,
    /// With the memory that the optimiser left, which was too little.
    WithTooLittle,
    Yes,
}

impl BestPlan {
    /// Over plans of all lengths.
    pub(in crate::solver) fn new(problem: Arc<Problem>, options: &Options) -> Self {
        Self::with(WORK_WITHOUT_PLAN, GREEDY_NODES, problem, options, options)
    }

    /// With so much work of the optimiser before a first plan is looked for, so many nodes of Algorithm 1 and options of the
    /// optimiser's own.
    pub(super) fn with(
        work: u64,
        nodes: u64,
        problem: Arc<Problem>,
        options: &Options,
        of_optimiser: &Options,
    ) -> Self {
        Self {
            optimiser: Optimiser::new(Arc::clone(&problem), of_optimiser, None),
            problem,
            options: options.clone(),
            work,
            nodes,
            first: None,
            tried: Tried::No,
            met: None,
            earlier: Stats::default(),
        }
    }

    /// Whether there is a plan.
    #[cfg(test)]
    pub(super) fn has_plan(&self) -> bool {
        self.optimiser.has_plan()
    }

    /// Whether a first plan was looked for and there is one.
    #[cfg(test)]
    pub(super) fn learns(&self) -> bool {
        self.tried != Tried::No && self.has_plan()
    }

    fn begin_first(&mut self) {
        self.tried = Tried::Yes;
        let mut options = left(&self.options, &self.stats());
        if self.met.is_none() {
            options.limits.bytes /= SHARE_OF_MEMORY;
        }
        let problem = Arc::clone(&self.problem);
        self.first = Some(Box::new(FirstPlan::new(self.nodes, problem, &options, None)));
    }

    /// The means have come to an end, perhaps with a plan.
    fn end_first(&mut self, finding: Option<Finding>) {
        let Some(first) = self.first.take() else { return };
        let stats = first.stats();
        self.earlier.add_engine(&stats);
        self.optimiser.lower_limit(stats.expansions);
        let Some(Finding { plan: Some(plan), witnesses, .. }) = finding else { return };
        let limits = self.options.limits;
        let bounds = self.options.heeded_bounds();
        let witnesses = match witnesses.is_empty() {
            true => parallel_walks::beside(&self.problem, &plan, limits),
            false => witnesses,
        };
        if let Ok(achieved) = validate_within(&self.problem, &plan, &witnesses, limits)
            && bounds.allow(achieved.counts, &achieved.survivors)
        {
            self.optimiser.learn(achieved.counts, plan, witnesses);
        }
    }
}

impl Engine for BestPlan {
    fn advance(&mut self, budget: u64) -> Result<Advance, LimitReached> {
        if let Some(first) = &mut self.first {
            match first.advance(1) {
                Ok(Advance::Working) if !first.is_over() => {}
                Ok(Advance::Working) => self.end_first(None),
                Ok(Advance::Finished(finding)) if finding.plan.is_some() => {
                    self.end_first(Some(finding));
                }
                // Proved: there is no plan.
                Ok(answer) => return Ok(answer),
                Err(limit) => {
                    if matches!(limit, LimitReached::Memory { .. }) {
                        self.tried = Tried::WithTooLittle;
                    }
                    self.end_first(None);
                }
            }
            return Ok(Advance::Working);
        }
        if let Some(limit) = self.met {
            return Err(limit);
        }
        for _ in 0..budget {
            match self.optimiser.advance(1) {
                Ok(Advance::Working) => {}
                Err(LimitReached::Expansions { .. }) => {
                    let limit = self.options.limits.expansions;
                    return Err(LimitReached::Expansions { limit });
                }
                Err(limit) if self.tried != Tried::Yes && !self.optimiser.has_plan() => {
                    self.met = Some(limit);
                    self.optimiser.leave_off();
                    self.begin_first();
                    break;
                }
                answer => return answer,
            }
            if self.tried == Tried::No && self.optimiser.lacks_plan(self.work) {
                self.begin_first();
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
        if let Some(first) = &self.first {
            stats.add_engine(&first.stats());
        }
        stats
    }
}
