//! The optimiser: the best plan, at a horizon or over all lengths, with a proof.
//!
//! What a plan achieves depends on the node it ends in, where the actor may be and what every
//! observer believes, and on nothing else. So the best plan is looked for best first over nodes, and
//! the proof is either that its value meets an upper bound that no plan can pass, or that every node
//! left is worse.
//!
//! - [`space`] is what is searched: nodes and their successors, expanded as they are met,
//! - [`search`] is the one loop, [`order`] the order in which it takes up nodes, [`queue`] its queue,
//! - [`dominance`] leaves out nodes that another one is at least as good as, where that is sound,
//! - [`sampling`] follows samples in place of beliefs that are too large to list,
//! - [`estimates`] say how long a plan through a node must still be,
//! - [`bounds`] are the upper bounds on all plans,
//! - [`schedule`] is what is tried when, by [thresholds](crate::solver::ground::thresholds) that all stand in one place with those of the other engines, and [`stages`] do it.
//!
//! Over all lengths a plan found so need not be short. A second search, by length, then looks for a
//! shortest plan of the value that is proved.

pub mod bounds;
mod dominance;
mod estimates;
mod order;
mod queue;
mod sampling;
mod schedule;
mod search;
mod space;
mod stages;
#[cfg(test)]
mod tests;

use std::sync::Arc;

use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::{JointSpace, Problem, SurvivorCounts};
use crate::solver::engine::{Advance, Engine, Finding};
use crate::solver::ground::thresholds::EXPANSIONS_BETWEEN_CHECKS;
use crate::solver::outcome::{Progress, Stats, Status};
use crate::solver::{Bounds, Options};
use crate::trace::Witness;
use bounds::Most;
use estimates::Estimates;
use schedule::{Schedule, Stage};
use search::{Order, Search, Way};
use space::{Actor, Space};

/// The engine for the best plan.
pub(in crate::solver) struct Optimiser {
    problem: Arc<Problem>,
    options: Options,
    horizon: Option<usize>,
    work: Option<Box<Work>>,
    /// No plan is worth more; none where there is no plan at all.
    bound: Option<i64>,
    best: Option<(SurvivorCounts, Plan)>,
    /// Walks that show what survives on the best plan, where it was found with samples.
    witnesses: Vec<Witness>,
    /// Whether the best plan is known to be a shortest one of its value.
    length_proved: bool,
    /// The best plan is from elsewhere, and whether a bound proves it has not been looked at.
    learned: bool,
    schedule: Schedule,
    /// How many of the questions have been asked.
    asked: usize,
    expansions: u64,
    generated: u64,
}

/// What the searches share, and the one at work.
#[derive(Debug)]
struct Work {
    space: Space,
    estimates: Estimates,
    stage: Stage,
    /// Expansions and believed states gone through when the present stage began.
    begun: (u64, u64),
    /// Whether tables over pairs of states have been tried.
    tried_pairs: bool,
    /// The space with samples, while it is searched, and the search that waits for it.
    sampled: Option<Box<(Space, Estimates, Search)>>,
    /// Whether samples have been tried.
    tried_samples: bool,
}

impl Work {
    fn bytes(&self) -> u64 {
        let sampled = self.sampled.as_deref().map_or(0, |(space, estimates, search)| {
            space.bytes() + estimates.bytes() + search.bytes()
        });
        self.space.bytes() + self.estimates.bytes() + self.stage.search().bytes() + sampled
    }
}

/// Shown without its insides, which would weigh heavily in the wasm file.
impl std::fmt::Debug for Optimiser {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Optimiser").field("horizon", &self.horizon).finish_non_exhaustive()
    }
}

impl Optimiser {
    pub(in crate::solver) fn new(
        problem: Arc<Problem>,
        options: &Options,
        horizon: Option<usize>,
    ) -> Self {
        let bound = options.heeded_bounds().most_difference(&problem);
        Self {
            problem,
            options: options.clone(),
            horizon,
            work: None,
            bound,
            best: None,
            witnesses: Vec::new(),
            length_proved: false,
            learned: false,
            schedule: Schedule::default(),
            asked: 0,
            expansions: 0,
            generated: 0,
        }
    }

    fn begin(&mut self) -> Result<Box<Work>, LimitReached> {
        let bounds: Bounds = self.options.heeded_bounds();
        let mut joint = JointSpace::new(Arc::clone(&self.problem), self.options.limits);
        joint.initial();
        let most = self.bound.unwrap_or_default();
        let estimates = Estimates::new(&mut joint, self.horizon, most)?;
        let space = Space::new(joint, bounds);
        let actor = if estimates.knows_endings() { Actor::State } else { Actor::Word };
        let search =
            Search::new(&space, self.finding_way(actor), 1 - self.problem.goals().len() as i64);
        let stage = Stage::Find(search);
        Ok(Box::new(Work {
            space,
            estimates,
            stage,
            begun: (0, 0),
            tried_pairs: false,
            sampled: None,
            tried_samples: false,
        }))
    }

    /// Whether a plan was found.
    pub(in crate::solver) fn has_plan(&self) -> bool {
        self.best.is_some()
    }

    /// Whether none was found with that much work done: expansions and believed states gone through.
    pub(in crate::solver) fn lacks_plan(&self, after_work: u64) -> bool {
        let spent = |work: &Work| {
            let sampled = work.sampled.as_deref().map_or(0, |(space, ..)| space.touched);
            self.expansions + work.space.touched + sampled
        };
        !self.has_plan() && self.work.as_deref().map_or(0, spent) >= after_work
    }

    /// Whether beliefs have outgrown their lists and samples in their place have led to no plan.
    pub(in crate::solver) fn lacks_plan_after_samples(&self) -> bool {
        let tried = |work: &Work| work.tried_samples && matches!(work.stage, Stage::Find(_));
        !self.has_plan() && self.work.as_deref().is_some_and(tried)
    }

    /// Gives the memory back. What is proved stays; there is no going on.
    pub(in crate::solver) fn leave_off(&mut self) {
        let Stats { generated, .. } = self.stats();
        (self.generated, self.work) = (generated, None);
    }

    /// Takes a plan from elsewhere for the best one, where it is better than what is known.
    pub(in crate::solver) fn learn(
        &mut self,
        counts: SurvivorCounts,
        plan: Plan,
        witnesses: Vec<Witness>,
    ) {
        let known = self.best.as_ref().map(|(counts, _)| counts.difference());
        if known.is_some_and(|known| known >= counts.difference()) {
            return;
        }
        if let Some(Work {
            stage: Stage::Find(search) | Stage::Sample(search) | Stage::Prove(search, _),
            ..
        }) = self.work.as_deref_mut()
        {
            search.aim = search.aim.max(counts.difference() + 1);
        }
        self.best = Some((counts, plan));
        self.witnesses = witnesses;
        self.learned = true;
    }

    /// Bytes in use, counted by contents.
    pub(in crate::solver) fn bytes(&self) -> u64 {
        self.work.as_deref().map_or(0, Work::bytes)
    }

    /// Whether more than this is in use; looked at as often as the limit is.
    pub(in crate::solver) fn outgrows(&self, bytes: u64) -> bool {
        self.expansions.is_multiple_of(EXPANSIONS_BETWEEN_CHECKS) && self.bytes() > bytes
    }

    /// Lowers the limit of expansions by those of other engines.
    pub(in crate::solver) fn lower_limit(&mut self, expansions: u64) {
        let limit = &mut self.options.limits.expansions;
        *limit = limit.saturating_sub(expansions);
    }

    /// How good plans are looked for.
    fn finding_way(&self, actor: Actor) -> Way {
        Way {
            actor,
            order: Order::Promise,
            horizon: self.horizon.map(|horizon| horizon as u32),
            dominance: self.schedule.dominance,
            shorter_than: u32::MAX,
            alone: None,
        }
    }

    fn check_limits(&self, work: &Work) -> Result<(), LimitReached> {
        let limits = &self.options.limits;
        if self.expansions.is_multiple_of(EXPANSIONS_BETWEEN_CHECKS) {
            limits.check_bytes(work.bytes())?;
        }
        if self.expansions >= limits.expansions {
            return Err(LimitReached::Expansions { limit: limits.expansions });
        }
        Ok(())
    }

    /// Whether no plan is worth more than the best one.
    fn is_proved(&self) -> bool {
        match (&self.best, self.bound) {
            (Some((counts, _)), Some(bound)) => counts.difference() >= bound,
            (_, None) => true,
            (None, Some(_)) => false,
        }
    }

    fn finding(&self) -> Finding {
        match &self.best {
            Some((_, plan)) => Finding {
                length_proved: self.horizon.is_none().then_some(self.length_proved),
                witnesses: self.witnesses.clone(),
                ..Finding::plan(Status::Optimal, plan.clone())
            },
            None => Finding::infeasible(),
        }
    }

    /// Takes note of what a bound says.
    fn heed(&mut self, work: &mut Work, most: Most) {
        match (most, self.bound) {
            (Most::Value(most), Some(known)) => {
                self.bound = Some(known.min(most));
                work.estimates.most = known.min(most);
            }
            (Most::Infeasible, _) => self.bound = None,
            (Most::Unaffordable, _) | (_, None) => {}
        }
    }
}

impl Engine for Optimiser {
    fn advance(&mut self, budget: u64) -> Result<Advance, LimitReached> {
        if self.bound.is_none() {
            return Ok(Advance::Finished(self.finding()));
        }
        let mut work = match self.work.take() {
            Some(work) => work,
            None => self.begin()?,
        };
        let mut done = Ok(false);
        for _ in 0..budget {
            done = self.step(&mut work);
            // Where beliefs are large a single step is long enough between two looks at whether to stop.
            if !matches!(done, Ok(false)) || work.space.joint.has_unlisted() {
                break;
            }
        }
        self.work = Some(work);
        Ok(if done? { Advance::Finished(self.finding()) } else { Advance::Working })
    }

    fn stop(&mut self, limit: LimitReached) -> Finding {
        let plan = self.best.as_ref().map(|(_, plan)| plan.clone());
        match plan {
            Some(plan) if self.is_proved() => Finding {
                length_proved: self.horizon.is_none().then_some(self.length_proved),
                witnesses: self.witnesses.clone(),
                ..Finding::stopped_at_best(plan, limit)
            },
            plan => {
                let witnesses = self.witnesses.clone();
                Finding { witnesses, ..Finding::stopped(plan, limit) }
            }
        }
    }

    fn report(&self, progress: &mut Progress) {
        let most = self.problem.goals().len() as f64 - 1.0;
        progress.bound = self.bound.map(|bound| bound as f64 / most);
        if let Some((counts, plan)) = &self.best {
            progress.goal_difference = Some(self.problem.goal_difference(*counts));
            progress.plan = Some(plan.clone());
            progress.witnesses.clone_from(&self.witnesses);
        }
    }

    fn stats(&self) -> Stats {
        let mut stats =
            Stats { expansions: self.expansions, generated: self.generated, ..Stats::default() };
        if let Some(work) = &self.work {
            stats.generated += work.stage.search().len() as u64;
            work.space.count(&mut stats);
        }
        stats
    }
}
