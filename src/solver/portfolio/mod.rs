//! Satisficing search: a sequential portfolio for any plan that keeps the bounds.
//!
//! Algorithm 1 finds a plan soon or not for very long: where there is none, it has to go through
//! every state with every pair of beliefs. The portfolio gives it a number of nodes, and ends them where a belief outgrows
//! its list. After that [parallel walks](super::parallel_walks) look for a plan without working beliefs of enemies out
//! ([`first_plan`]). Then the [optimiser](super::optimiser) takes its turn, which ends with the first plan that keeps the
//! bounds or with the proof that there is none; where it goes long without either, the others have another and longer
//! round ([`best_plan`]). Where it meets a limit and gives its memory back, Algorithm 1 begins
//! again with all of it.
//!
//! For the best plan the optimiser begins, and goes on from the first plan that the others give it.
//!
//! Source: Huberman, Lukose and Hogg 1997, "An economics approach to hard computational problems"
//! (doi:10.1126/science.275.5296.51), on portfolios of algorithms.

mod best_plan;
mod first_plan;
#[cfg(test)]
mod tests;

use std::sync::Arc;

use self::first_plan::{FirstPlan, left};
use super::engine::{Advance, Engine, Finding};
use super::explorer::Lengths;
use super::explorer::cost_bounded::CostBounded;
use super::ground::thresholds::{GREEDY_NODES, SHARE_OF_MEMORY};
use super::optimiser::Optimiser;
use super::outcome::{Progress, Stats, Status};
use super::{Options, algorithm1};
use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::Problem;
use crate::trace::Witness;

pub(super) use best_plan::BestPlan;

/// The engines, one at work at a time.
pub(super) struct Portfolio {
    problem: Arc<Problem>,
    options: Options,
    horizon: Option<usize>,
    /// What Algorithm 1 is asked where it goes on alone.
    alone: Options,
    stage: Stage,
    /// Work of engines that were left for good.
    earlier: Stats,
}

/// Which engine is at work.
enum Stage {
    /// Until the optimiser takes them over or they are left.
    First(Option<Box<FirstPlan>>),
    Optimiser(Box<dyn Engine>),
    /// Algorithm 1 without an end, from the beginning: with all of the memory.
    GreedyAlone(Box<dyn Engine>),
}

impl Portfolio {
    /// For plans of any length or of exactly `horizon` actions.
    pub(super) fn new(problem: Arc<Problem>, options: &Options, horizon: Option<usize>) -> Self {
        Self::with_greedy_nodes(GREEDY_NODES, problem, options, horizon)
    }

    fn with_greedy_nodes(
        nodes: u64,
        problem: Arc<Problem>,
        options: &Options,
        horizon: Option<usize>,
    ) -> Self {
        let mut half = options.clone();
        half.limits.bytes /= SHARE_OF_MEMORY;
        let first = FirstPlan::new(nodes, Arc::clone(&problem), &half, horizon);
        let stage = Stage::First(Some(Box::new(first)));
        let (options, alone) = (options.clone(), options.clone());
        Self { problem, options, horizon, alone, stage, earlier: Stats::default() }
    }

    /// Nothing was found: the optimiser, or under a cost limit exhaustive exploration.
    fn after_first(&mut self) {
        let options = left(&self.options, &self.stats());
        let problem = Arc::clone(&self.problem);
        let Stage::First(first) = &mut self.stage else { return };
        let Some(first) = first.take() else { return };
        let engine: Box<dyn Engine> = if options.cost_limit.is_some() {
            let lengths = self.horizon.map_or(Lengths::Any, Lengths::Exactly);
            Box::new(CostBounded::new(problem, &options, lengths))
        } else if first.has_another_round() {
            self.stage = Stage::Optimiser(Box::new(BestPlan::after(first, problem, &options)));
            return;
        } else {
            Box::new(Optimiser::new(problem, &options, self.horizon))
        };
        self.leave(first.as_ref());
        self.stage = Stage::Optimiser(engine);
    }

    /// The optimiser has met a limit: short of memory, Algorithm 1 may need less.
    fn after_optimiser(&mut self) {
        let stage = std::mem::replace(&mut self.stage, Stage::First(None));
        if let Stage::Optimiser(engine) = stage {
            self.leave(engine.as_ref());
        }
        let (problem, alone) = (Arc::clone(&self.problem), left(&self.alone, &self.stats()));
        let greedy = algorithm1::engine(problem, &alone, self.horizon, false);
        self.stage = Stage::GreedyAlone(Box::new(greedy));
    }

    fn leave(&mut self, engine: &dyn Engine) {
        self.earlier.add_engine(&engine.stats());
    }
}

/// One expansion of an engine that looks for the best plan; ends with the first one it meets. One
/// at a time, so that the plan does not depend on slices.
fn first_plan(engine: &mut dyn Engine, progress: &mut Progress) -> Result<Advance, LimitReached> {
    let advance = engine.advance(1)?;
    if let Advance::Finished(Finding { plan: Some(plan), witnesses, .. }) = advance {
        return Ok(solved(plan, witnesses));
    }
    engine.report(progress);
    let witnesses = std::mem::take(&mut progress.witnesses);
    Ok(progress.plan.take().map_or(advance, |plan| solved(plan, witnesses)))
}

fn solved(plan: Plan, witnesses: Vec<Witness>) -> Advance {
    Advance::Finished(Finding { witnesses, ..Finding::plan(Status::Solved, plan) })
}

impl Engine for Portfolio {
    fn advance(&mut self, budget: u64) -> Result<Advance, LimitReached> {
        // By the number that was asked for, of all engines together.
        let limit = self.alone.limits.expansions;
        match &mut self.stage {
            Stage::GreedyAlone(greedy) => {
                return greedy.advance(budget).map_err(|met| match met {
                    LimitReached::Expansions { .. } => LimitReached::Expansions { limit },
                    met => met,
                });
            }
            Stage::First(Some(first)) if !first.is_over() => match first.advance(budget) {
                // Its share was too little; the optimiser has all of the memory.
                Err(LimitReached::Memory { .. }) => {
                    self.earlier.memory_stops += 1;
                    first.leave_greedy();
                }
                answer => return answer,
            },
            Stage::First(_) => self.after_first(),
            Stage::Optimiser(engine) => {
                let mut progress = Progress::new(self.options.solver, self.horizon);
                for _ in 0..budget {
                    match first_plan(engine.as_mut(), &mut progress) {
                        Ok(Advance::Working) => {}
                        Ok(answer) => return Ok(answer),
                        Err(_) if self.stats().expansions >= limit => {
                            return Err(LimitReached::Expansions { limit });
                        }
                        Err(met) => {
                            let memory = matches!(met, LimitReached::Memory { .. });
                            self.earlier.memory_stops += u64::from(memory);
                            self.after_optimiser();
                            break;
                        }
                    }
                }
            }
        }
        Ok(Advance::Working)
    }

    fn stop(&mut self, limit: LimitReached) -> Finding {
        match &mut self.stage {
            Stage::First(Some(first)) => first.stop(limit),
            Stage::GreedyAlone(engine) => engine.stop(limit),
            Stage::First(None) | Stage::Optimiser(_) => Finding::stopped(None, limit),
        }
    }

    fn report(&self, progress: &mut Progress) {
        match &self.stage {
            Stage::First(Some(first)) => first.report(progress),
            Stage::GreedyAlone(engine) => engine.report(progress),
            Stage::First(None) | Stage::Optimiser(_) => {}
        }
    }

    fn stats(&self) -> Stats {
        let mut stats = self.earlier;
        match &self.stage {
            Stage::First(Some(first)) => stats.add_engine(&first.stats()),
            Stage::First(None) => {}
            Stage::Optimiser(engine) | Stage::GreedyAlone(engine) => {
                stats.add_engine(&engine.stats());
            }
        }
        stats
    }
}
