//! Other horizons, each searched alone.
//!
//! One horizon alone is searched faster than all together where nodes are many, since nothing is
//! looked at that cannot be part of a plan of that length; and most often the next but one has a
//! plan.

use std::sync::Arc;

use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::Problem;
use crate::solver::engine::{Advance, Engine};
use crate::solver::ground::thresholds::HORIZONS_TRIED;
use crate::solver::optimiser::Optimiser;
use crate::solver::{MAX_HORIZON, Options};

/// A search at the horizons next to the one asked for, the nearest first.
pub(super) struct NextHorizons {
    problem: Arc<Problem>,
    options: Options,
    asked: usize,
    /// Horizons to try, the last first.
    tries: Vec<usize>,
    trying: Option<(usize, Box<dyn Engine>)>,
    expansions: u64,
    /// The best plan at the nearest shorter and at the nearest longer horizon that has one.
    pub(super) found: [Option<Plan>; 2],
}

impl NextHorizons {
    /// `shortest` is the length of a shortest plan for the true goal.
    pub(super) fn new(
        problem: Arc<Problem>,
        options: Options,
        asked: usize,
        shortest: usize,
    ) -> Self {
        let longer = (shortest.max(asked + 1)..=MAX_HORIZON).take(HORIZONS_TRIED);
        let shorter = (shortest..asked).rev().take(HORIZONS_TRIED);
        let mut tries: Vec<usize> = Vec::new();
        for horizon in longer.chain(shorter) {
            let by = |horizon: usize| horizon.abs_diff(asked);
            let place = tries.partition_point(|&known| by(known) > by(horizon));
            tries.insert(place, horizon);
        }
        Self { problem, options, asked, tries, trying: None, expansions: 0, found: [None, None] }
    }

    /// The nodes expanded so far.
    pub(super) fn expansions(&self) -> u64 {
        let trying = self.trying.as_ref().map_or(0, |(_, engine)| engine.stats().expansions);
        self.expansions + trying
    }

    /// The horizon being tried.
    pub(super) fn horizon(&self) -> Option<usize> {
        self.trying.as_ref().map(|(horizon, _)| *horizon)
    }

    fn side(&self, horizon: usize) -> usize {
        usize::from(horizon > self.asked)
    }

    /// Works for about `budget` expansions; true when all have been tried.
    ///
    /// # Errors
    ///
    /// A limit.
    pub(super) fn advance(&mut self, budget: u64) -> Result<bool, LimitReached> {
        let Some((horizon, mut engine)) = self.trying.take() else {
            while let Some(horizon) = self.tries.pop() {
                if self.found[self.side(horizon)].is_none() {
                    let mut options = self.options.clone();
                    let left = options.limits.expansions.saturating_sub(self.expansions);
                    options.limits.expansions = left;
                    let problem = Arc::clone(&self.problem);
                    self.trying =
                        Some((horizon, Box::new(Optimiser::new(problem, &options, Some(horizon)))));
                    return Ok(false);
                }
            }
            return Ok(true);
        };
        let (plan, stopped) = match engine.advance(budget) {
            Ok(Advance::Working) => {
                self.trying = Some((horizon, engine));
                return Ok(false);
            }
            Ok(Advance::Finished(finding)) => (finding.plan, Ok(false)),
            Err(limit) => (engine.stop(limit).plan, Err(limit)),
        };
        self.expansions += engine.stats().expansions;
        let side = self.side(horizon);
        self.found[side] = plan;
        stopped
    }
}
