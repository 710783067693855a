//! Algorithm 1 with an end to its patience.
//!
//! The search finds a plan soon or not for very long: where there is none, it has to go through
//! every state with every pair of beliefs. So where it has found none after a few rounds' worth of
//! nodes, [`prospects`](crate::solver::exact::prospects) say what can still become of the beliefs.
//! They find a plan that keeps the bounds, or prove that there is none, in state spaces that are
//! small enough; in others, and where they do not come to an end, the search goes on.

use std::sync::Arc;

use crate::limits::LimitReached;
use crate::problem::Problem;
use crate::solver::Options;
use crate::solver::engine::{Advance, Engine, Finding};
use crate::solver::exact::prospects::{Prospects, Verdict};
use crate::solver::outcome::{Progress, Stats, Status};

/// How many nodes the search may take up from its open list, whether it expands them, puts them off
/// to a later round or drops them; so there are fewer expansions. Few searches that find a plan at
/// all take up more in a small state space, and the tables of prospects cost more than so many.
const TAKEN_UP: u64 = 2_000;

/// A search, and what takes its turn.
pub(in crate::solver) struct Patient<E> {
    problem: Arc<Problem>,
    options: Options,
    search: E,
    stage: Stage,
}

enum Stage {
    /// So many nodes may still be taken up.
    Searching(u64),
    Hoping(Box<Prospects>),
    /// The search alone goes on; prospects took this.
    Alone(Stats),
}

impl<E: Engine> Patient<E> {
    /// The search is for plans of all lengths.
    pub(in crate::solver) fn new(problem: Arc<Problem>, options: &Options, search: E) -> Self {
        let stage = Stage::Searching(TAKEN_UP);
        Self { problem, options: options.clone(), search, stage }
    }

    /// Asks for prospects.
    fn hope(&self) -> Stage {
        match Prospects::new(&self.problem, &self.options, false) {
            Ok(Some(prospects)) => Stage::Hoping(Box::new(prospects)),
            // Short of memory, the search may need less.
            Ok(None) | Err(_) => Stage::Alone(Stats::default()),
        }
    }
}

impl<E: Engine> Engine for Patient<E> {
    fn advance(&mut self, budget: u64) -> Result<Advance, LimitReached> {
        match &mut self.stage {
            Stage::Alone(_) => self.search.advance(budget),
            Stage::Searching(0) => {
                self.stage = self.hope();
                Ok(Advance::Working)
            }
            Stage::Searching(left) => {
                let budget = budget.min(*left);
                *left -= budget;
                self.search.advance(budget)
            }
            Stage::Hoping(prospects) => Ok(Advance::Finished(match prospects.advance(budget) {
                Ok(Verdict::Plan(plan)) => Finding::plan(Status::Solved, plan),
                Ok(Verdict::Infeasible) => Finding::infeasible(),
                Ok(Verdict::Working) => return Ok(Advance::Working),
                Ok(Verdict::Unknown) | Err(_) => {
                    self.stage = Stage::Alone(prospects.stats());
                    return Ok(Advance::Working);
                }
            })),
        }
    }

    fn stop(&mut self, limit: LimitReached) -> Finding {
        self.search.stop(limit)
    }

    fn report(&self, progress: &mut Progress) {
        self.search.report(progress);
    }

    fn stats(&self) -> Stats {
        let mut stats = self.search.stats();
        match &self.stage {
            Stage::Searching(_) => {}
            Stage::Hoping(prospects) => {
                let more = prospects.stats();
                stats.add_work(&more);
                stats.states = stats.states.max(more.states);
                stats.beliefs = stats.beliefs.max(more.beliefs);
            }
            Stage::Alone(more) => stats.add_work(more),
        }
        stats
    }
}
