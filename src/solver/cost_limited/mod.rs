//! The best plan within a cost limit: without the limit first, then with it.
//!
//! To leave the limit out is a relaxation. So where the best plan of all is within the limit, it is the best
//! of those within, where there is no plan at all there is none within, and what bounds all plans bounds
//! these. The [optimiser](super::optimiser) is asked that first, for some expansions; then
//! [cost-bounded exploration](super::explorer::cost_bounded) goes through the plans within the limit, and ends
//! with one that meets the bound.

#[cfg(test)]
mod tests;

use std::sync::Arc;

use super::Options;
use super::engine::{Advance, Engine, Finding};
use super::explorer::Lengths;
use super::explorer::cost_bounded::CostBounded;
use super::optimiser::Optimiser;
use super::outcome::{Progress, Stats, Status};
use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::Problem;
use crate::solver::ground::thresholds::RELAXED_EXPANSIONS;
use crate::trace::Witness;

/// The engines, one at work at a time.
pub(super) struct CostLimited {
    problem: Arc<Problem>,
    options: Options,
    horizon: Option<usize>,
    stage: Stage,
    /// The best plan within the limit that the optimiser met, with its goal difference.
    kept: Option<(f64, Plan, Vec<Witness>)>,
    /// Whether that is proved to be the best of all, so that the optimiser goes on to a shorter one.
    proved: bool,
    /// No plan has a greater goal difference.
    bound: Option<f64>,
    /// What the optimiser took.
    earlier: Stats,
}

/// Which engine is at work.
enum Stage {
    /// The optimiser without the limit, with the expansions that are left to it.
    Relaxed(Box<Optimiser>, u64),
    Bounded(Box<CostBounded>),
}

impl CostLimited {
    /// For plans of any length or of exactly `horizon` actions.
    pub(super) fn new(problem: Arc<Problem>, options: &Options, horizon: Option<usize>) -> Self {
        Self::with_relaxed_expansions(RELAXED_EXPANSIONS, problem, options, horizon)
    }

    fn with_relaxed_expansions(
        expansions: u64,
        problem: Arc<Problem>,
        options: &Options,
        horizon: Option<usize>,
    ) -> Self {
        let optimiser = Optimiser::new(Arc::clone(&problem), options, horizon);
        Self {
            problem,
            options: options.clone(),
            horizon,
            stage: Stage::Relaxed(Box::new(optimiser), expansions),
            kept: None,
            proved: false,
            bound: None,
            earlier: Stats::default(),
        }
    }

    fn is_within(&self, plan: &Plan) -> bool {
        let cost = plan.cost_or_length(self.problem.task());
        self.options.cost_limit.is_none_or(|limit| cost <= u128::from(limit))
    }

    /// Keeps what the optimiser knows and begins to explore.
    fn explore(&mut self) {
        let Stage::Relaxed(optimiser, _) = &self.stage else { return };
        let mut progress = Progress::new(self.options.solver, self.horizon);
        optimiser.report(&mut progress);
        self.earlier = optimiser.stats();
        self.bound = progress.bound;
        if let (Some(difference), Some(plan)) = (progress.goal_difference, progress.plan)
            && self.is_within(&plan)
        {
            self.kept = Some((difference, plan, progress.witnesses));
        }
        let mut options = self.options.clone();
        let left = options.limits.expansions.saturating_sub(self.earlier.expansions);
        options.limits.expansions = left;
        let lengths = self.horizon.map_or(Lengths::Any, Lengths::Exactly);
        let mut bounded = CostBounded::new(Arc::clone(&self.problem), &options, lengths);
        if let Some(bound) = self.bound {
            let most = bound * (self.problem.goals().len() as f64 - 1.0);
            bounded.bound(most.round() as i64);
        }
        self.stage = Stage::Bounded(Box::new(bounded));
    }

    /// One expansion of the optimiser. One at a time, so that the answer does not depend on slices.
    fn relaxed(&mut self) -> Option<Finding> {
        let Stage::Relaxed(optimiser, left) = &mut self.stage else { return None };
        if *left == 0 && !self.proved {
            let mut progress = Progress::new(self.options.solver, self.horizon);
            optimiser.report(&mut progress);
            self.proved = progress.gap() == Some(0.0)
                && progress.plan.as_ref().is_some_and(|plan| self.is_within(plan));
            if !self.proved {
                self.explore();
                return None;
            }
            let plan = progress.plan.unwrap_or_default();
            let difference = progress.goal_difference.unwrap_or_default();
            self.kept = Some((difference, plan, progress.witnesses));
        }
        let Stage::Relaxed(optimiser, left) = &mut self.stage else { return None };
        *left = left.saturating_sub(1);
        match optimiser.advance(1) {
            Ok(Advance::Working) => None,
            Ok(Advance::Finished(finding)) => {
                let within = finding.plan.as_ref().is_none_or(|plan| self.is_within(plan));
                if within && finding.limit.is_none() {
                    return Some(finding);
                }
                self.explore();
                None
            }
            // What met the limit is freed; the limit on expansions is met again at once.
            Err(_) => {
                self.explore();
                None
            }
        }
    }
}

impl Engine for CostLimited {
    fn advance(&mut self, budget: u64) -> Result<Advance, LimitReached> {
        for _ in 0..budget {
            match &mut self.stage {
                Stage::Bounded(engine) => match engine.advance(1) {
                    Ok(Advance::Working) => {}
                    // By the number that was asked for.
                    Err(LimitReached::Expansions { .. }) => {
                        let limit = self.options.limits.expansions;
                        return Err(LimitReached::Expansions { limit });
                    }
                    answer => return answer,
                },
                Stage::Relaxed(..) => {
                    if let Some(finding) = self.relaxed() {
                        return Ok(Advance::Finished(finding));
                    }
                }
            }
        }
        Ok(Advance::Working)
    }

    fn stop(&mut self, limit: LimitReached) -> Finding {
        if let Stage::Relaxed(..) = self.stage {
            self.explore();
        }
        let Stage::Bounded(engine) = &mut self.stage else {
            return Finding::stopped(None, limit);
        };
        let mut progress = Progress::new(self.options.solver, self.horizon);
        engine.report(&mut progress);
        let finding = engine.stop(limit);
        let bound = self.bound.unwrap_or(f64::INFINITY);
        match self.kept.take() {
            // The optimiser had proved it best and looked for a shorter one.
            Some((difference, plan, witnesses)) if difference >= bound => Finding {
                length_proved: self.horizon.is_none().then_some(false),
                witnesses,
                ..Finding::stopped_at_best(plan, limit)
            },
            Some((difference, plan, witnesses))
                if finding.status != Status::Optimal
                    && progress.goal_difference.is_none_or(|found| difference > found) =>
            {
                Finding { witnesses, ..Finding::stopped(Some(plan), limit) }
            }
            _ => finding,
        }
    }

    fn report(&self, progress: &mut Progress) {
        match &self.stage {
            Stage::Relaxed(optimiser, _) => {
                optimiser.report(progress);
                if progress.plan.as_ref().is_some_and(|plan| !self.is_within(plan)) {
                    (progress.plan, progress.goal_difference) = (None, None);
                    progress.witnesses.clear();
                }
            }
            Stage::Bounded(engine) => {
                engine.report(progress);
                if let Some((difference, plan, witnesses)) = &self.kept
                    && progress.goal_difference.is_none_or(|found| *difference > found)
                {
                    progress.goal_difference = Some(*difference);
                    progress.plan = Some(plan.clone());
                    progress.witnesses.clone_from(witnesses);
                }
            }
        }
    }

    fn stats(&self) -> Stats {
        match &self.stage {
            Stage::Relaxed(optimiser, _) => optimiser.stats(),
            Stage::Bounded(engine) => {
                let mut stats = engine.stats();
                stats.add_work(&self.earlier);
                stats.states = stats.states.max(self.earlier.states);
                stats.beliefs = stats.beliefs.max(self.earlier.beliefs);
                stats
            }
        }
    }
}
