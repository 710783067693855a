//! Exact search led by what each observer can still believe.
//!
//! All nodes together are far too many on large grids with walls: an observer's beliefs differ on
//! almost every way around them. So aim at one goal difference after the other, from the greatest
//! down, and leave out every node from which a plan cannot be worth it any more, or not soon enough:
//!
//! - for a goal to survive for an enemy, some state it believes must still be led to that goal along
//!   the plan (`twins`),
//! - for a goal to die for a friend, every state it believes must still be freed from it
//!   (`doubts`).
//!
//! Both look at pairs of states only, so they are bounds and no more; `estimates` puts them
//! together, and a `pass` searches. The first value with a plan is the best one, since there is
//! none above; what is left out makes no difference to that. Where a pass takes long, lower values
//! are tried in between, so that there is a good plan early; the passes above then go on until each
//! has found one or come to its end.
//!
//! Where passes over plans of all lengths take long, [`prospects`](super::prospects) have a go, who
//! tell fewer nodes apart. Where the bounds say too little, and they too, the passes go through many nodes more than there are to tell
//! apart; after `MOST_VISITS` the plain engine takes over, and the best plan found is kept.
//!
//! State spaces with too many pairs, and searches for all pairs of survivor counts, are left to
//! [`layers`](super::layers) and [`closure`](super::closure).

mod classes;
pub(super) mod doubts;
mod estimates;
mod ground;
mod pass;
pub(super) mod steps;
pub(super) mod twins;

use std::sync::Arc;

use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::{JointSpace, Problem, SurvivorCounts};
use crate::solver::Options;
use crate::solver::engine::{Advance, Engine, Finding};
use crate::solver::exact::prospects::{Prospects, Verdict};
use crate::solver::live::Live;
use crate::solver::outcome::{Progress, Stats, Status};
use estimates::{Aim, Estimates};
use ground::Ground;
use pass::{Pass, Went};

/// Visits of a pass before lower values have their first turn. Each further turn is twice as long
/// as the one before.
const FIRST_TURN: u64 = 2_000;

/// More visits than small problems need; then the bounds do not help, and going through all nodes is
/// the better way.
const MOST_VISITS: u64 = 500_000;

/// Most problems are solved in fewer visits, and the tables of prospects cost more.
const VISITS_BEFORE_PROSPECTS: u64 = 5_000;

/// When stopped without a plan, the shortest way is followed to the goal as long as no more believed
/// states have been gone through: who stops does not want to wait.
const STATES_ON_STOP: usize = 4_000_000;

/// Exact search at a horizon or over all of them.
pub(in crate::solver) struct Guided {
    problem: Arc<Problem>,
    options: Options,
    horizon: Option<usize>,
    stage: Stage,
}

enum Stage {
    New,
    /// So many tables know what they say of the first node.
    Preparing(Box<Ground>, usize),
    Passes(Box<Passes>),
    /// The passes wait, who may go on where this leads nowhere.
    Prospects(Box<Prospects>, Option<Box<Passes>>),
    /// Too large for tables, or led nowhere; with the best plan found until then.
    Plain(Box<dyn Engine>, Option<(SurvivorCounts, Plan)>),
}

/// The passes, from the greatest value down.
#[derive(Debug)]
struct Passes {
    ground: Ground,
    horizon: Option<usize>,
    /// Those that have not come to an end.
    undecided: Vec<Pass>,
    /// Which of them is at work.
    at_work: usize,
    /// The next value to aim at; none once a plan is found or there is no lower one.
    next_value: Option<i64>,
    /// The best plan of a pass that is done, with what it aimed at.
    solved: Option<(i64, Plan)>,
    /// Whether prospects had their go.
    tried: bool,
}

/// Shown without the engine, whose insides would weigh heavily in the wasm file.
impl std::fmt::Debug for Guided {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Guided").field("horizon", &self.horizon).finish_non_exhaustive()
    }
}

impl Guided {
    pub(in crate::solver) fn new(
        problem: Arc<Problem>,
        options: &Options,
        horizon: Option<usize>,
    ) -> Self {
        Self { problem, options: options.clone(), horizon, stage: Stage::New }
    }

    fn plain(&self, best: Option<(SurvivorCounts, Plan)>) -> Stage {
        let problem = Arc::clone(&self.problem);
        Stage::Plain(super::plain(problem, &self.options, self.horizon), best)
    }

    /// The passes have gone on for long: prospects have a go, or in the end the plain engine.
    fn change_means(&mut self) {
        let Stage::Passes(mut passes) = std::mem::replace(&mut self.stage, Stage::New) else {
            return;
        };
        if passes.tried {
            let mut room = STATES_ON_STOP;
            if passes.ground.best.is_none() {
                // Short of memory, there is no plan to show.
                let _ = passes.ground.follow_shortest(self.horizon, &mut room);
            }
            self.stage = self.plain(passes.ground.best.take());
            return;
        }
        passes.tried = true;
        self.stage = match Prospects::new(&self.problem, &self.options, true) {
            Ok(Some(prospects)) => Stage::Prospects(Box::new(prospects), Some(passes)),
            // Short of memory, the passes may need less.
            Ok(None) | Err(_) => Stage::Passes(passes),
        };
    }

    fn give_up_prospects(&mut self) {
        self.stage = match std::mem::replace(&mut self.stage, Stage::New) {
            Stage::Prospects(_, Some(passes)) => Stage::Passes(passes),
            Stage::Prospects(_, None) => self.plain(None),
            other => other,
        };
    }

    fn prepare(&self) -> Result<Stage, LimitReached> {
        let mut joint = JointSpace::new(Arc::clone(&self.problem), self.options.limits);
        let bounds = self.options.heeded_bounds();
        let Some(estimates) = Estimates::new(&mut joint, &bounds)? else {
            let prospects = match self.horizon {
                None => Prospects::new(&self.problem, &self.options, true).ok().flatten(),
                Some(_) => None,
            };
            let prospects = prospects.map(|prospects| Stage::Prospects(Box::new(prospects), None));
            return Ok(prospects.unwrap_or_else(|| self.plain(None)));
        };
        let live = Live::new(&mut joint)?;
        let ground = Ground::new(joint, bounds, live, estimates, self.horizon)?;
        Ok(Stage::Preparing(Box::new(ground), 0))
    }
}

impl Passes {
    fn new(ground: Ground, horizon: Option<usize>) -> Self {
        let most = ground.joint.problem().goals().len() as i64 - 1;
        Self {
            ground,
            horizon,
            undecided: Vec::new(),
            at_work: 0,
            next_value: Some(most),
            solved: None,
            tried: horizon.is_some(),
        }
    }

    /// Lets the next pass have its turn; none when all have come to an end.
    fn next_turn(&mut self) -> Option<()> {
        if let (None, Some(value)) = (&self.solved, self.next_value) {
            let goals = self.ground.joint.problem().goals().len();
            self.next_value = (value > 1 - goals as i64).then_some(value - 1);
            let bounds = &self.ground.bounds;
            let aim = Aim {
                value,
                at_least: bounds.at_least.unwrap_or(1),
                at_most: bounds.at_most.unwrap_or(goals),
            };
            self.undecided.push(Pass::new(aim, self.horizon, FIRST_TURN));
            self.at_work = self.undecided.len() - 1;
        } else {
            let count = self.undecided.len();
            self.at_work = (self.at_work + 1).checked_rem(count)?;
            self.undecided[self.at_work].turn *= 2;
        }
        let resting =
            |(place, pass): (usize, &Pass)| if place == self.at_work { 0 } else { pass.bytes() };
        self.ground.resting = self.undecided.iter().enumerate().map(resting).sum();
        Some(())
    }

    fn advance(&mut self, budget: u64) -> Result<bool, LimitReached> {
        let end = self.ground.visits.saturating_add(budget);
        while self.ground.visits < end {
            let Some(pass) = self.undecided.get_mut(self.at_work) else {
                if self.next_turn().is_none() {
                    return Ok(true);
                }
                continue;
            };
            if pass.had_its_turn() {
                // There is always one: at least this pass again.
                let _ = self.next_turn();
                continue;
            }
            match pass.step(&mut self.ground)? {
                Went::On => {}
                Went::Nowhere => {
                    self.undecided.remove(self.at_work);
                    // The one that comes next is at this place now.
                    self.at_work = self.undecided.len();
                }
                Went::Found(plan) => {
                    self.solved = Some((pass.aim.value, plan));
                    // Lower values do not matter any more.
                    self.undecided.truncate(self.at_work);
                    self.at_work = self.undecided.len();
                }
            }
        }
        Ok(false)
    }
}

impl Passes {
    fn finding(&self) -> Finding {
        match &self.solved {
            Some((_, plan)) => Finding::plan(Status::Optimal, plan.clone()),
            None => Finding::infeasible(),
        }
    }

    /// No plan is worth more than this.
    fn bound(&self) -> Option<i64> {
        let solved = self.solved.as_ref().map(|(value, _)| *value);
        let begun = self.undecided.iter().map(|pass| pass.aim.value);
        begun.chain(solved.or(self.next_value)).max()
    }
}

impl Engine for Guided {
    fn advance(&mut self, budget: u64) -> Result<Advance, LimitReached> {
        match &mut self.stage {
            Stage::New => self.stage = self.prepare()?,
            Stage::Plain(engine, _) => return engine.advance(budget),
            Stage::Preparing(ground, settled) => {
                if !ground.can_reach_goal(self.horizon) {
                    return Ok(Advance::Finished(Finding::infeasible()));
                }
                if ground.settle(*settled, self.horizon) {
                    *settled += 1;
                } else if let Stage::Preparing(ground, _) =
                    std::mem::replace(&mut self.stage, Stage::New)
                {
                    self.stage = Stage::Passes(Box::new(Passes::new(*ground, self.horizon)));
                }
            }
            Stage::Passes(passes) => {
                let most = if passes.tried { MOST_VISITS } else { VISITS_BEFORE_PROSPECTS };
                let left = most - passes.ground.visits.min(most);
                if passes.advance(budget.min(left))? {
                    return Ok(Advance::Finished(passes.finding()));
                }
                if passes.ground.visits >= most {
                    self.change_means();
                }
            }
            Stage::Prospects(prospects, _) => match prospects.advance(budget) {
                Ok(Verdict::Working) => {}
                Ok(Verdict::Plan(plan)) => {
                    return Ok(Advance::Finished(Finding::plan(Status::Optimal, plan)));
                }
                Ok(Verdict::Infeasible) => return Ok(Advance::Finished(Finding::infeasible())),
                Ok(Verdict::Unknown) | Err(_) => self.give_up_prospects(),
            },
        }
        Ok(Advance::Working)
    }

    fn stop(&mut self, limit: LimitReached) -> Finding {
        let ground = match &mut self.stage {
            Stage::New => return Finding::stopped(None, limit),
            Stage::Plain(engine, best) => {
                let mut finding = engine.stop(limit);
                if finding.plan.is_none()
                    && let Some((_, plan)) = best.take()
                {
                    finding = Finding::stopped(Some(plan), limit);
                }
                return finding;
            }
            Stage::Preparing(ground, _) => ground,
            Stage::Prospects(prospects, None) => {
                return Finding::stopped(prospects.stop(), limit);
            }
            Stage::Passes(passes) | Stage::Prospects(_, Some(passes)) => &mut passes.ground,
        };
        if ground.best.is_none() {
            let mut room = STATES_ON_STOP;
            // Short of memory, there is no plan to show.
            let _ = ground.follow_shortest(self.horizon, &mut room);
        }
        Finding::stopped(ground.best.clone().map(|(_, plan)| plan), limit)
    }

    fn report(&self, progress: &mut Progress) {
        let problem = &self.problem;
        progress.bound = Some(1.0);
        let best = match &self.stage {
            Stage::New | Stage::Prospects(_, None) => None,
            Stage::Plain(engine, best) => {
                engine.report(progress);
                if progress.plan.is_some() {
                    return;
                }
                best.as_ref()
            }
            Stage::Preparing(ground, _) => ground.best.as_ref(),
            Stage::Passes(passes) | Stage::Prospects(_, Some(passes)) => {
                let most = problem.goals().len() as f64 - 1.0;
                progress.bound = passes.bound().map(|value| value as f64 / most);
                passes.ground.best.as_ref()
            }
        };
        if let Some((counts, plan)) = best {
            progress.goal_difference = Some(problem.goal_difference(*counts));
            progress.plan = Some(plan.clone());
        }
    }

    fn stats(&self) -> Stats {
        let ground = match &self.stage {
            Stage::New => return Stats::default(),
            Stage::Plain(engine, _) => return engine.stats(),
            Stage::Preparing(ground, _) => ground,
            Stage::Prospects(prospects, None) => return prospects.stats(),
            Stage::Passes(passes) | Stage::Prospects(_, Some(passes)) => &passes.ground,
        };
        let mut stats = Stats {
            expansions: ground.visits,
            generated: ground.graph.len() as u64,
            ..Stats::default()
        };
        stats.count_spaces(&ground.joint);
        if let Stage::Prospects(prospects, _) = &self.stage {
            let more = prospects.stats();
            stats.add_work(&more);
            stats.beliefs = stats.beliefs.max(more.beliefs);
        }
        stats
    }
}
