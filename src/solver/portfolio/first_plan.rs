//! The means of the portfolio that look for a first plan and prove little: Algorithm 1 for a number of nodes, then parallel
//! walks.

use std::sync::Arc;

use crate::limits::LimitReached;
use crate::problem::Problem;
use crate::solver::engine::{Advance, Engine, Finding};
use crate::solver::outcome::{Progress, Stats};
use crate::solver::parallel_walks::{self, ParallelWalks};
use crate::solver::{Options, algorithm1};

/// The nodes that Algorithm 1 may take from its open list (whether it expands, defers or drops them).
/// Few searches that find a plan at all take more in a small state space, and the tables of the optimiser cost more than
/// as many nodes.
pub(super) const GREEDY_NODES: u64 = 2_000;

/// The values of states that the parallel walks may work out: some seconds.
const WALK_EVALUATIONS: u64 = 400_000;

/// Algorithm 1, then the walks.
pub(super) struct FirstPlan {
    problem: Arc<Problem>,
    options: Options,
    horizon: Option<usize>,
    stage: Stage,
    /// Work of the engine that was left.
    earlier: Stats,
}

/// Which engine is at work.
enum Stage {
    /// Algorithm 1, with the nodes that are left to it; where walks can take over it ends with the first belief that
    /// outgrows its list.
    Greedy(Box<dyn Engine>, u64),
    Walks(Box<ParallelWalks>),
    /// Nothing was found. Algorithm 1 can go on where walks have not taken over: there it would end as before.
    Over(Option<Box<dyn Engine>>),
}

/// Whether parallel walks can take over: they do not mind what a plan costs.
fn suits_walks(problem: &Problem, options: &Options, horizon: Option<usize>) -> bool {
    options.cost_limit.is_none()
        && parallel_walks::suits(problem, &options.heeded_bounds(), horizon)
}

/// What is left to an engine after others.
pub(super) fn left(options: &Options, spent: &Stats) -> Options {
    let mut options = options.clone();
    options.limits.expansions = options.limits.expansions.saturating_sub(spent.expansions);
    options
}

impl FirstPlan {
    /// For plans of any length or of exactly `horizon` actions, with so many nodes for Algorithm 1.
    pub(super) fn new(
        nodes: u64,
        problem: Arc<Problem>,
        options: &Options,
        horizon: Option<usize>,
    ) -> Self {
        let walks = suits_walks(&problem, options, horizon);
        let greedy = algorithm1::engine(Arc::clone(&problem), options, horizon, walks);
        let stage = Stage::Greedy(Box::new(greedy), nodes);
        Self { problem, options: options.clone(), horizon, stage, earlier: Stats::default() }
    }

    /// Whether both have had their share.
    pub(super) fn is_over(&self) -> bool {
        matches!(self.stage, Stage::Over(_))
    }

    /// Algorithm 1, where it can go on; its work does not count here any more then.
    pub(super) fn take_greedy(&mut self) -> Option<Box<dyn Engine>> {
        match &mut self.stage {
            Stage::Over(greedy) => greedy.take(),
            Stage::Greedy(..) | Stage::Walks(_) => None,
        }
    }

    /// Algorithm 1 has had its nodes, or a belief has outgrown its list.
    fn after_greedy(&mut self) {
        let options = left(&self.options, &self.stats());
        let Stage::Greedy(greedy, _) = std::mem::replace(&mut self.stage, Stage::Over(None)) else {
            return;
        };
        self.stage = if suits_walks(&self.problem, &options, self.horizon) {
            self.leave(greedy.as_ref());
            Stage::Walks(Box::new(ParallelWalks::new(&self.problem, &options)))
        } else {
            Stage::Over(Some(greedy))
        };
    }

    fn after_walks(&mut self) {
        if let Stage::Walks(walks) = std::mem::replace(&mut self.stage, Stage::Over(None)) {
            self.leave(walks.as_ref());
        }
    }

    fn leave(&mut self, engine: &dyn Engine) {
        self.earlier.add_engine(&engine.stats());
    }
}

impl Engine for FirstPlan {
    /// Working without work once [both are over](Self::is_over).
    fn advance(&mut self, budget: u64) -> Result<Advance, LimitReached> {
        match &mut self.stage {
            Stage::Over(_) => {}
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
        }
        Ok(Advance::Working)
    }

    fn stop(&mut self, limit: LimitReached) -> Finding {
        match &mut self.stage {
            Stage::Greedy(engine, _) => engine.stop(limit),
            Stage::Walks(walks) => walks.stop(limit),
            Stage::Over(_) => Finding::stopped(None, limit),
        }
    }

    fn report(&self, progress: &mut Progress) {
        if let Stage::Greedy(engine, _) = &self.stage {
            engine.report(progress);
        }
    }

    fn stats(&self) -> Stats {
        let mut stats = self.earlier;
        match &self.stage {
            Stage::Greedy(engine, _) | Stage::Over(Some(engine)) => {
                stats.add_engine(&engine.stats())
            }
            Stage::Walks(walks) => stats.add_engine(&walks.stats()),
            Stage::Over(None) => {}
        }
        stats
    }
}
