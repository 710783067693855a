//! Satisficing search: a sequential portfolio for any plan that keeps the bounds.
//!
//! Algorithm 1 finds a plan soon or not for very long: where there is none, it has to go through
//! every state with every pair of beliefs. The portfolio gives it a number of nodes. After that the
//! [optimiser](super::optimiser) takes its turn, which ends with the first plan that keeps the bounds or
//! with the proof that there is none. Where it meets a limit, Algorithm 1 goes on alone.
//!
//! Source: Huberman, Lukose and Hogg 1997, "An economics approach to hard computational problems"
//! (doi:10.1126/science.275.5296.51), on portfolios of algorithms.

#[cfg(test)]
mod tests;

use std::sync::Arc;

use super::engine::{Advance, Engine, Finding};
use super::optimiser::Optimiser;
use super::outcome::{Progress, Stats, Status};
use super::{Options, algorithm1};
use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::Problem;
use crate::trace::Witness;

/// The nodes that Algorithm 1 may take from its open list (whether it expands, defers or drops them)
/// before the optimiser has its turn. Few searches that find a plan at all take more in a small state
/// space, and the tables of the optimiser cost more than as many nodes.
const GREEDY_NODES: u64 = 2_000;

/// The engines, one at work at a time.
pub(super) struct Portfolio {
    problem: Arc<Problem>,
    options: Options,
    horizon: Option<usize>,
    greedy: Box<dyn Engine>,
    stage: Stage,
}

/// Which engine is at work.
enum Stage {
    /// Algorithm 1, with the nodes that are left to it.
    Greedy(u64),
    Optimiser(Box<dyn Engine>),
    /// Algorithm 1 without an end; the optimiser took this work.
    GreedyAlone(Stats),
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
        let greedy = Box::new(algorithm1::engine(Arc::clone(&problem), options, horizon));
        let stage = Stage::Greedy(nodes);
        Self { problem, options: options.clone(), horizon, greedy, stage }
    }

    /// The optimiser, with the expansions that are left.
    fn optimiser(&self) -> Stage {
        let mut options = self.options.clone();
        let spent = self.greedy.stats().expansions;
        options.limits.expansions = options.limits.expansions.saturating_sub(spent);
        let problem = Arc::clone(&self.problem);
        Stage::Optimiser(Box::new(Optimiser::new(problem, &options, self.horizon)))
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
        match &mut self.stage {
            Stage::GreedyAlone(_) => self.greedy.advance(budget),
            Stage::Greedy(0) => {
                self.stage = self.optimiser();
                Ok(Advance::Working)
            }
            Stage::Greedy(left) => {
                let budget = budget.min(*left);
                *left -= budget;
                self.greedy.advance(budget)
            }
            Stage::Optimiser(engine) => {
                let mut progress = Progress::new(self.options.solver, self.horizon);
                for _ in 0..budget {
                    match first_plan(engine.as_mut(), &mut progress) {
                        Ok(Advance::Working) => {}
                        Ok(answer) => return Ok(answer),
                        // Short of memory, Algorithm 1 may need less.
                        Err(_) => {
                            self.stage = Stage::GreedyAlone(engine.stats());
                            break;
                        }
                    }
                }
                Ok(Advance::Working)
            }
        }
    }

    fn stop(&mut self, limit: LimitReached) -> Finding {
        self.greedy.stop(limit)
    }

    fn report(&self, progress: &mut Progress) {
        self.greedy.report(progress);
    }

    fn stats(&self) -> Stats {
        let mut stats = self.greedy.stats();
        let optimiser = match &self.stage {
            Stage::Greedy(_) => return stats,
            Stage::Optimiser(engine) => engine.stats(),
            Stage::GreedyAlone(optimiser) => *optimiser,
        };
        stats.add_work(&optimiser);
        stats.states = stats.states.max(optimiser.states);
        stats.beliefs = stats.beliefs.max(optimiser.beliefs);
        stats
    }
}
