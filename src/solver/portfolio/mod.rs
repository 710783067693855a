//! Satisficing search: a sequential portfolio for any plan that keeps the bounds.
//!
//! Algorithm 1 finds a plan soon or not for very long: where there is none, it has to go through
//! every state with every pair of beliefs. The portfolio gives it a number of nodes, and ends them where a belief outgrows
//! its list. After that [parallel walks](super::parallel_walks) look for a plan without working beliefs of enemies out. Then
//! the [optimiser](super::optimiser) takes its turn, which ends with the first plan that keeps the bounds or
//! with the proof that there is none. Where it meets a limit, Algorithm 1 goes on alone.
//!
//! Source: Huberman, Lukose and Hogg 1997, "An economics approach to hard computational problems"
//! (doi:10.1126/science.275.5296.51), on portfolios of algorithms.

#[cfg(test)]
mod tests;

use std::sync::Arc;

use super::engine::{Advance, Engine, Finding};
use super::explorer::Lengths;
use super::explorer::cost_bounded::CostBounded;
use super::optimiser::Optimiser;
use super::outcome::{Progress, Stats, Status};
use super::parallel_walks::{self, ParallelWalks};
use super::{Options, algorithm1};
use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::Problem;
use crate::trace::Witness;

/// The nodes that Algorithm 1 may take from its open list (whether it expands, defers or drops them)
/// before the optimiser has its turn. Few searches that find a plan at all take more in a small state
/// space, and the tables of the optimiser cost more than as many nodes.
const GREEDY_NODES: u64 = 2_000;

/// The values of states that the parallel walks may work out before the optimiser has its turn: some seconds.
const WALK_EVALUATIONS: u64 = 400_000;

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
    /// Algorithm 1, with the nodes that are left to it; where walks can take over it ends with the first belief that
    /// outgrows its list.
    Greedy(Box<dyn Engine>, u64),
    Walks(Box<ParallelWalks>),
    /// The optimiser, and Algorithm 1 where it can go on.
    Optimiser(Box<dyn Engine>, Option<Box<dyn Engine>>),
    /// Algorithm 1 without an end.
    GreedyAlone(Box<dyn Engine>),
}

/// Whether parallel walks can take over: they do not mind what a plan costs.
fn suits_walks(problem: &Problem, options: &Options, horizon: Option<usize>) -> bool {
    options.cost_limit.is_none()
        && parallel_walks::suits(problem, &options.heeded_bounds(), horizon)
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
        let walks = suits_walks(&problem, options, horizon);
        let greedy = algorithm1::engine(Arc::clone(&problem), options, horizon, walks);
        let stage = Stage::Greedy(Box::new(greedy), nodes);
        let (options, alone) = (options.clone(), options.clone());
        Self { problem, options, horizon, alone, stage, earlier: Stats::default() }
    }

    /// The options with the expansions that are left.
    fn left(&self) -> Options {
        let mut options = self.options.clone();
        let spent = self.stats().expansions;
        options.limits.expansions = options.limits.expansions.saturating_sub(spent);
        options
    }

    /// Algorithm 1 has had its nodes, or a belief has outgrown its list. Where walks take over it is left for good: it would
    /// end there again.
    fn after_greedy(&mut self) {
        let options = self.left();
        let walks = suits_walks(&self.problem, &options, self.horizon);
        let next = if walks {
            Stage::Walks(Box::new(ParallelWalks::new(&self.problem, &options)))
        } else {
            self.optimiser(&options)
        };
        let Stage::Greedy(greedy, _) = std::mem::replace(&mut self.stage, next) else { return };
        match &mut self.stage {
            Stage::Optimiser(_, kept) => *kept = Some(greedy),
            _ => self.leave(greedy.as_ref()),
        }
    }

    /// The walks have had their share.
    fn after_walks(&mut self) {
        let options = self.left();
        let next = self.optimiser(&options);
        if let Stage::Walks(walks) = std::mem::replace(&mut self.stage, next) {
            self.leave(walks.as_ref());
        }
    }

    /// The optimiser, or under a cost limit exhaustive exploration.
    fn optimiser(&self, options: &Options) -> Stage {
        let problem = Arc::clone(&self.problem);
        if options.cost_limit.is_some() {
            let lengths = self.horizon.map_or(Lengths::Any, Lengths::Exactly);
            return Stage::Optimiser(Box::new(CostBounded::new(problem, options, lengths)), None);
        }
        Stage::Optimiser(Box::new(Optimiser::new(problem, options, self.horizon)), None)
    }

    /// The optimiser has met a limit: short of memory, Algorithm 1 may need less.
    fn after_optimiser(&mut self) {
        let (problem, horizon) = (Arc::clone(&self.problem), self.horizon);
        let fresh = Box::new(algorithm1::engine(problem, &self.alone, horizon, false));
        let next = Stage::GreedyAlone(fresh);
        let Stage::Optimiser(engine, greedy) = std::mem::replace(&mut self.stage, next) else {
            return;
        };
        self.leave(engine.as_ref());
        if let Some(greedy) = greedy {
            self.stage = Stage::GreedyAlone(greedy);
        }
    }

    fn leave(&mut self, engine: &dyn Engine) {
        let stats = engine.stats();
        self.earlier.add_work(&stats);
        self.earlier.states = self.earlier.states.max(stats.states);
        self.earlier.beliefs = self.earlier.beliefs.max(stats.beliefs);
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
            Stage::GreedyAlone(greedy) => return greedy.advance(budget),
            Stage::Greedy(_, 0) => self.after_greedy(),
            Stage::Greedy(greedy, left) => {
                let budget = budget.min(*left);
                *left -= budget;
                match greedy.advance(budget) {
                    Err(LimitReached::Listed { .. }) => self.after_greedy(),
                    answer => return answer,
                }
            }
            Stage::Walks(walks) => {
                for _ in 0..budget {
                    match walks.advance(1) {
                        Ok(Advance::Working) if walks.evaluations() < WALK_EVALUATIONS => {}
                        Ok(Advance::Working) | Err(_) => {
                            self.after_walks();
                            break;
                        }
                        answer => return answer,
                    }
                }
            }
            Stage::Optimiser(engine, _) => {
                let mut progress = Progress::new(self.options.solver, self.horizon);
                for _ in 0..budget {
                    match first_plan(engine.as_mut(), &mut progress) {
                        Ok(Advance::Working) => {}
                        Ok(answer) => return Ok(answer),
                        Err(_) => {
                            let limit = self.alone.limits.expansions;
                            if self.stats().expansions >= limit {
                                return Err(LimitReached::Expansions { limit });
                            }
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
            Stage::Greedy(engine, _) | Stage::GreedyAlone(engine) => engine.stop(limit),
            Stage::Walks(walks) => walks.stop(limit),
            Stage::Optimiser(..) => Finding::stopped(None, limit),
        }
    }

    fn report(&self, progress: &mut Progress) {
        if let Stage::Greedy(engine, _) | Stage::GreedyAlone(engine) = &self.stage {
            engine.report(progress);
        }
    }

    fn stats(&self) -> Stats {
        let mut stats = self.earlier;
        let mut add = |other: Stats| {
            stats.add_work(&other);
            stats.states = stats.states.max(other.states);
            stats.beliefs = stats.beliefs.max(other.beliefs);
            stats.belief_size = stats.belief_size.max(other.belief_size);
        };
        match &self.stage {
            Stage::Greedy(engine, _) | Stage::GreedyAlone(engine) => add(engine.stats()),
            Stage::Walks(walks) => add(walks.stats()),
            Stage::Optimiser(engine, greedy) => {
                add(engine.stats());
                if let Some(greedy) = greedy {
                    add(greedy.stats());
                }
            }
        }
        stats
    }
}
