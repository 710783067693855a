//! The means of the portfolio that look for a first plan and prove little: Algorithm 1 and parallel walks, in turns.

use std::sync::Arc;

use crate::limits::LimitReached;
use crate::problem::Problem;
use crate::solver::engine::{Advance, Engine, Finding};
use crate::solver::ground::thresholds::{GREEDY_GENERATED, LONGER_ROUNDS, WALK_EVALUATIONS};
use crate::solver::outcome::{Progress, Stats};
use crate::solver::parallel_walks::{self, ParallelWalks};
use crate::solver::{Options, algorithm1};

/// Algorithm 1 and the walks.
pub(super) struct FirstPlan {
    problem: Arc<Problem>,
    options: Options,
    /// None where it has come to its end. Where there are walks it ends with the first belief that outgrows its list.
    greedy: Option<Box<dyn Engine>>,
    walks: Option<Box<ParallelWalks>>,
    /// Whether these have come to their end.
    walks_over: bool,
    /// The turns to come, the next one last.
    turns: Vec<Turn>,
    /// The rounds after them, the next one last.
    rounds: Vec<[Turn; 2]>,
    /// Work of engines that were left.
    earlier: Stats,
}

/// Whose turn it is, and how much is left of it.
#[derive(Debug, Clone, Copy)]
enum Turn {
    /// At most `nodes` from the open list, and until this number has been `generated`: each of these has a value worked
    /// out, and there may be many for one that is taken.
    Greedy { nodes: u64, generated: u64 },
    /// Until this number of values has been worked out.
    Walks(u64),
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
    /// For plans of any length or of exactly `horizon` actions, with `nodes` for Algorithm 1 at first.
    pub(super) fn new(
        nodes: u64,
        problem: Arc<Problem>,
        options: &Options,
        horizon: Option<usize>,
    ) -> Self {
        let suits_walks = suits_walks(&problem, options, horizon);
        let mut options = options.clone();
        let (mut turns, mut rounds) =
            (vec![Turn::Greedy { nodes, generated: u64::MAX }], Vec::new());
        if suits_walks {
            // Algorithm 1 and the walks are there at the same time.
            options.limits.bytes /= 2;
            turns = vec![
                Turn::Walks(WALK_EVALUATIONS),
                Turn::Greedy { nodes, generated: GREEDY_GENERATED },
            ];
            let round = |&(generated, walks): &(u64, u64)| {
                let greedy = Turn::Greedy { nodes: u64::MAX, generated };
                [Turn::Walks(walks * WALK_EVALUATIONS), greedy]
            };
            rounds = LONGER_ROUNDS.iter().rev().map(round).collect();
        }
        let greedy = algorithm1::engine(Arc::clone(&problem), &options, horizon, suits_walks);
        Self {
            problem,
            options,
            greedy: Some(Box::new(greedy)),
            walks: None,
            walks_over: false,
            turns,
            rounds,
            earlier: Stats::default(),
        }
    }

    /// Whether both have had their turns.
    pub(super) fn is_over(&self) -> bool {
        self.turns.is_empty()
    }

    /// Whether there is another round.
    pub(super) fn has_another_round(&self) -> bool {
        !self.rounds.is_empty()
    }

    /// Begins the next round, where there is one. Without walks there is none.
    pub(super) fn go_on(&mut self) {
        if let Some(round) = self.rounds.pop() {
            self.turns.splice(0..0, round);
        }
    }

    /// Leaves Algorithm 1 for good in its turn.
    pub(super) fn leave_greedy(&mut self) {
        if let (Some(Turn::Greedy { .. }), Some(greedy)) = (self.turns.last(), self.greedy.take()) {
            self.earlier.add_engine(&greedy.stats());
            self.turns.pop();
        }
    }

    fn advance_greedy(
        &mut self,
        budget: u64,
        (nodes, generated): (u64, u64),
    ) -> Result<Advance, LimitReached> {
        self.turns.pop();
        let Some(greedy) = &mut self.greedy else { return Ok(Advance::Working) };
        for taken in 0..budget {
            let over = generated < u64::MAX && greedy.stats().generated >= generated;
            if over || taken == nodes {
                return Ok(Advance::Working);
            }
            match greedy.advance(1) {
                Ok(Advance::Working) => {}
                Err(LimitReached::Listed { .. }) => {
                    self.earlier.add_engine(&greedy.stats());
                    self.greedy = None;
                    return Ok(Advance::Working);
                }
                answer => {
                    // It can still be asked what it knows.
                    self.turns.push(Turn::Greedy { nodes, generated });
                    return answer;
                }
            }
        }
        self.turns.push(Turn::Greedy { nodes: nodes - budget, generated });
        Ok(Advance::Working)
    }

    fn advance_walks(&mut self, budget: u64, until: u64) -> Result<Advance, LimitReached> {
        if self.walks_over {
            self.turns.pop();
            return Ok(Advance::Working);
        }
        if self.walks.is_none() {
            let options = left(&self.options, &self.stats());
            self.walks = Some(Box::new(ParallelWalks::new(&self.problem, &options)));
        }
        let Some(walks) = &mut self.walks else { return Ok(Advance::Working) };
        for _ in 0..budget {
            match walks.advance(1) {
                Ok(Advance::Working) if walks.evaluations() < until => {}
                Ok(Advance::Working) => {
                    self.turns.pop();
                    break;
                }
                // Their end proves nothing.
                Err(_) => {
                    self.turns.pop();
                    self.walks_over = true;
                    break;
                }
                answer => return answer,
            }
        }
        Ok(Advance::Working)
    }
}

impl Engine for FirstPlan {
    /// Working without work once [both have had their turns](Self::is_over).
    fn advance(&mut self, budget: u64) -> Result<Advance, LimitReached> {
        match self.turns.last() {
            None => Ok(Advance::Working),
            Some(&Turn::Greedy { nodes, generated }) => {
                self.advance_greedy(budget, (nodes, generated))
            }
            Some(&Turn::Walks(until)) => self.advance_walks(budget, until),
        }
    }

    fn stop(&mut self, limit: LimitReached) -> Finding {
        match (self.turns.last(), &mut self.greedy) {
            (Some(Turn::Greedy { .. }), Some(greedy)) => greedy.stop(limit),
            _ => Finding::stopped(None, limit),
        }
    }

    fn report(&self, progress: &mut Progress) {
        if let (Some(Turn::Greedy { .. }), Some(greedy)) = (self.turns.last(), &self.greedy) {
            greedy.report(progress);
        }
    }

    fn stats(&self) -> Stats {
        let mut stats = self.earlier;
        if let Some(greedy) = &self.greedy {
            stats.add_engine(&greedy.stats());
        }
        if let Some(walks) = &self.walks {
            stats.add_engine(&walks.stats());
        }
        stats
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;
    use crate::domain::generate::Domain;
    use crate::solver::Solver;

    #[test]
    fn the_first_turn_of_algorithm_1_ends_with_what_it_has_generated() {
        let problem = Arc::new(Domain::Logistics.draw(1).unwrap().document.problem().unwrap());
        let mut options = Options::new(Solver::Satisficing);
        // Hardly any plan keeps these bounds, and none is found in this turn.
        options.bounds.at_least = Some(5);
        options.bounds.at_most = Some(1);
        let mut first = FirstPlan::new(u64::MAX, problem, &options, None);
        while matches!(first.turns.last(), Some(Turn::Greedy { .. })) {
            assert!(matches!(first.advance(1), Ok(Advance::Working)));
        }
        assert!(matches!(first.turns.as_slice(), [Turn::Walks(WALK_EVALUATIONS)]));
        let generated = first.stats().generated;
        assert!((GREEDY_GENERATED..GREEDY_GENERATED + 1_000).contains(&generated), "{generated}");
    }
}
