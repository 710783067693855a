//! A solver at work: slices, horizons, and the replay of every plan.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::limits::LimitReached;
use crate::problem::Problem;
use crate::trace::validate_with;

use super::conclude::conclude;
use super::engine::{Advance, Engine, Finding};
use super::error::SolveError;
use super::ground::shortest_length::{Reached, Shortest};
use super::optimiser::Optimiser;
use super::outcome::{LengthPoint, Outcome, Progress, Stats, Status};
use super::{Horizon, Options, Solver};
#[cfg(feature = "full")]
use super::{
    algorithm1, baseline,
    cost_limited::CostLimited,
    explorer::{Explorer, Lengths, cost_bounded::CostBounded},
    ip,
    portfolio::{BestPlan, Portfolio},
};

/// How many expansions or nodes [`solve`] does between two reports. Few, since a single one can
/// take long: an expansion where beliefs are large, a node where the integer program is.
fn slice(solver: Solver) -> u64 {
    match solver {
        Solver::Exact => 16,
        Solver::Baseline => 4,
        Solver::Ip | Solver::Search | Solver::Satisficing | Solver::Obfuscate | Solver::Legible => {
            1
        }
    }
}

/// A solver at work.
///
/// ```
/// use std::sync::Arc;
/// use mo_copp::{domain::Delivery, solver::{Options, Run, Solver, Status}};
/// let problem = Arc::new(Delivery::figure_1().problem()?);
/// let mut run = Run::new(problem, Options::new(Solver::Exact))?;
/// while !run.advance(1)? {}
/// let outcome = run.outcome()?;
/// assert_eq!((outcome.status, outcome.goal_difference), (Status::Optimal, Some(1.0)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Run {
    problem: Arc<Problem>,
    options: Options,
    /// The horizon being worked on; none where plans of all lengths are asked for.
    horizon: Option<usize>,
    engine: Option<Box<dyn Engine>>,
    finding: Option<Finding>,
    /// Work done at earlier horizons.
    earlier: Stats,
    last_stats: Stats,
}

/// Shown without the engine, whose insides would weigh heavily in the wasm file.
impl std::fmt::Debug for Run {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Run").field("horizon", &self.horizon).finish_non_exhaustive()
    }
}

impl Run {
    /// Checks the options and gets ready.
    ///
    /// # Errors
    ///
    /// [`SolveError::Options`]; without the feature `full` [`SolveError::NeedsFullCore`] for everything but one best
    /// plan by exact search.
    pub fn new(problem: Arc<Problem>, options: Options) -> Result<Self, SolveError> {
        options.check(&problem)?;
        let one_best = options.solver == Solver::Exact
            && !options.pairs
            && options.lengths.is_none()
            && options.cost_limit.is_none();
        if cfg!(not(feature = "full")) && !one_best {
            return Err(SolveError::NeedsFullCore);
        }
        let mut run = Self {
            problem,
            options,
            horizon: None,
            engine: None,
            finding: None,
            earlier: Stats::default(),
            last_stats: Stats::default(),
        };
        if let Horizon::Steps(steps) = run.options.horizon {
            run.horizon = Some(steps);
        }
        if run.options.heeded_bounds().most_difference(&run.problem).is_none() {
            run.finding = Some(run.nothing());
        } else if run.options.horizon == Horizon::Auto && run.options.solver == Solver::Ip {
            match shortest_plan_length(&run.problem, &run.options) {
                Ok(Some(steps)) => run.horizon = Some(steps),
                Ok(None) => run.finding = Some(Finding::infeasible()),
                Err(limit) => run.finding = Some(Finding::stopped(None, limit)),
            }
            run.options.horizon_step = run.options.horizon_step.max(1);
        }
        Ok(run)
    }

    /// The answer where the bounds contradict each other: there is no plan of any length.
    fn nothing(&self) -> Finding {
        let none = |length| LengthPoint { length, best: None };
        let lengths = self.options.lengths.map(|longest| (0..=longest).map(none).collect());
        Finding { lengths, ..Finding::infeasible() }
    }

    /// The problem.
    pub fn problem(&self) -> &Arc<Problem> {
        &self.problem
    }

    fn start(&self) -> Result<Box<dyn Engine>, LimitReached> {
        let (problem, options) = (Arc::clone(&self.problem), &self.options);
        #[cfg(feature = "full")]
        if let Some(longest) = options.lengths {
            return Ok(explore(problem, options, Lengths::UpTo(longest)));
        }
        #[cfg(feature = "full")]
        if options.pairs {
            let lengths = self.horizon.map_or(Lengths::Any, Lengths::Exactly);
            return Ok(explore(problem, options, lengths));
        }
        Ok(match (options.solver, self.horizon) {
            #[cfg(feature = "full")]
            (Solver::Exact, horizon) if options.cost_limit.is_some() => {
                Box::new(CostLimited::new(problem, options, horizon))
            }
            #[cfg(feature = "full")]
            (Solver::Exact, None) => Box::new(BestPlan::new(problem, options)),
            (Solver::Exact, horizon) => Box::new(Optimiser::new(problem, options, horizon)),
            // `new` has refused them.
            #[cfg(not(feature = "full"))]
            _ => return Err(LimitReached::Cancelled),
            #[cfg(feature = "full")]
            (Solver::Ip, horizon) => {
                let horizon = horizon.unwrap_or(0);
                let lengths = Lengths::Exactly(horizon);
                let starter = explore(Arc::clone(&problem), options, lengths);
                Box::new(ip::IntegerProgram::new(problem, options, horizon, starter)?)
            }
            #[cfg(feature = "full")]
            (Solver::Baseline, horizon) => {
                let limit = options.cost_limit;
                Box::new(baseline::engine(problem.task(), options.limits, horizon, limit))
            }
            #[cfg(feature = "full")]
            (Solver::Search | Solver::Obfuscate | Solver::Legible, horizon) => {
                Box::new(algorithm1::engine(problem, options, horizon, false))
            }
            #[cfg(feature = "full")]
            (Solver::Satisficing, horizon) => Box::new(Portfolio::new(problem, options, horizon)),
        })
    }

    /// Works for about `budget` expansions or nodes; true when there is an answer.
    ///
    /// # Errors
    ///
    /// [`SolveError`] where the work broke down; a limit is no error.
    pub fn advance(&mut self, budget: u64) -> Result<bool, SolveError> {
        if self.finding.is_some() {
            return Ok(true);
        }
        let mut engine = match self.engine.take() {
            Some(engine) => engine,
            None => match self.start() {
                Ok(engine) => engine,
                Err(limit) => {
                    self.halt(limit, None);
                    return Ok(true);
                }
            },
        };
        match engine.advance(budget) {
            Ok(Advance::Working) => {
                self.engine = Some(engine);
                Ok(false)
            }
            Ok(Advance::Finished(finding)) => {
                self.last_stats = engine.stats();
                let next = self.horizon.map(|horizon| horizon + self.options.horizon_step);
                let limit = self.options.horizon_limit;
                let raise = finding.status == Status::Infeasible && self.options.horizon_step > 0;
                match next {
                    Some(next) if raise && next <= limit => {
                        self.horizon = Some(next);
                        self.earlier.add_work(&self.last_stats);
                        self.last_stats = Stats::default();
                        Ok(false)
                    }
                    Some(_) if raise => {
                        let limit = LimitReached::Horizon { limit: limit as u64 };
                        self.finding = Some(Finding::stopped(None, limit));
                        Ok(true)
                    }
                    _ => {
                        self.finding = Some(finding);
                        Ok(true)
                    }
                }
            }
            Err(limit) => {
                self.halt(limit, Some(engine));
                Ok(true)
            }
        }
    }

    /// Makes an answer of what there is when a limit is met.
    fn halt(&mut self, limit: LimitReached, engine: Option<Box<dyn Engine>>) {
        self.finding = Some(match engine {
            Some(mut engine) => {
                let finding = self.stop(engine.as_mut(), limit);
                self.last_stats = engine.stats();
                finding
            }
            None => Finding::stopped(None, limit),
        });
    }

    /// What an engine answers when it is stopped, with the bound it has proved.
    fn stop(&self, engine: &mut dyn Engine, limit: LimitReached) -> Finding {
        let mut progress = Progress::new(self.options.solver, self.horizon);
        engine.report(&mut progress);
        let mut finding = engine.stop(limit);
        finding.bound = finding.bound.or(progress.bound);
        finding
    }

    /// What is known so far.
    pub fn progress(&self) -> Progress {
        let mut progress = Progress::new(self.options.solver, self.horizon);
        if let Some(engine) = &self.engine {
            engine.report(&mut progress);
        } else if let Some(finding) = &self.finding {
            progress.plan.clone_from(&finding.plan);
            let counts = finding
                .plan
                .as_ref()
                .and_then(|plan| validate_with(&self.problem, plan, &finding.witnesses).ok());
            progress.goal_difference =
                counts.map(|achieved| self.problem.goal_difference(achieved.counts));
        }
        let stats = self.stats();
        progress.done = stats.expansions + stats.nodes;
        progress.stats = stats;
        progress
    }

    fn stats(&self) -> Stats {
        let mut stats = self.engine.as_ref().map_or(self.last_stats, |engine| engine.stats());
        stats.add_work(&self.earlier);
        stats
    }

    /// The answer; that of a run stopped before its end keeps the best plan found. Every plan is
    /// replayed before it is given out.
    ///
    /// # Errors
    ///
    /// [`SolveError::Replay`] when a plan does not do what its solver says.
    pub fn outcome(&mut self) -> Result<Outcome, SolveError> {
        let finding = match (self.finding.take(), self.engine.take()) {
            (Some(finding), engine) => {
                self.engine = engine;
                finding
            }
            (None, Some(mut engine)) => {
                let finding = self.stop(engine.as_mut(), LimitReached::Cancelled);
                self.engine = Some(engine);
                finding
            }
            (None, None) => Finding::stopped(None, LimitReached::Cancelled),
        };
        let stats = self.stats();
        let outcome = conclude(&self.problem, &self.options, self.horizon, &finding, stats)?;
        self.finding = Some(finding);
        Ok(outcome)
    }
}

/// Exhaustive exploration, within the cost limit where there is one.
#[cfg(feature = "full")]
fn explore(problem: Arc<Problem>, options: &Options, lengths: Lengths) -> Box<dyn Engine> {
    if options.cost_limit.is_some() {
        return Box::new(CostBounded::new(problem, options, lengths));
    }
    Box::new(Explorer::new(problem, options, lengths))
}

/// The outcome of a run that had to be left behind, from the last it was heard of.
///
/// # Errors
///
/// [`SolveError::Replay`] when its plan does not do what its solver says.
pub fn abandoned(
    problem: &Arc<Problem>,
    options: &Options,
    progress: Option<&Progress>,
) -> Result<Outcome, SolveError> {
    let plan = progress.and_then(|progress| progress.plan.clone());
    let asked = match options.horizon {
        Horizon::Steps(steps) => Some(steps),
        Horizon::Auto | Horizon::Any => None,
    };
    let reached = progress.filter(|_| options.lengths.is_none());
    let horizon = reached.map_or(asked, |progress| progress.horizon);
    let stats = progress.map_or_else(Stats::default, |progress| progress.stats);
    let mut finding = Finding::stopped(plan, LimitReached::Cancelled);
    finding.bound = progress.and_then(|progress| progress.bound);
    finding.witnesses = progress.map(|progress| progress.witnesses.clone()).unwrap_or_default();
    conclude(problem, options, horizon, &finding, stats)
}

/// Solves a problem. `progress` is told now and then how far the work is, and may break it off;
/// the best plan is kept then.
///
/// # Errors
///
/// [`SolveError`]; limits and infeasible problems are outcomes, not errors.
///
/// ```
/// use std::{ops::ControlFlow, sync::Arc};
/// use mo_copp::{domain::Delivery, solver::{solve, Options, Solver}};
/// let problem = Arc::new(Delivery::figure_1().problem()?);
/// let outcome = solve(problem, Options::new(Solver::Ip), |_| ControlFlow::Continue(()))?;
/// assert_eq!(outcome.goal_difference, Some(1.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn solve(
    problem: Arc<Problem>,
    options: Options,
    mut progress: impl FnMut(&Run) -> ControlFlow<()>,
) -> Result<Outcome, SolveError> {
    let slice = slice(options.solver);
    let mut run = Run::new(problem, options)?;
    while !run.advance(slice)? {
        if progress(&run).is_break() {
            break;
        }
    }
    run.outcome()
}

/// The length of a shortest plan for the true goal, whatever anybody believes; none where there is
/// no plan at all.
///
/// # Errors
///
/// The memory limit.
///
/// ```
/// use mo_copp::{domain::Delivery, solver::{shortest_plan_length, Options, Solver}};
/// let problem = Delivery::figure_1().problem()?;
/// assert_eq!(shortest_plan_length(&problem, &Options::new(Solver::Exact)), Ok(Some(3)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn shortest_plan_length(
    problem: &Problem,
    options: &Options,
) -> Result<Option<usize>, LimitReached> {
    let mut shortest = Shortest::new(problem.task(), options.limits);
    let mut budget = u64::MAX;
    match shortest.advance(&mut budget)? {
        Reached::After(length) => Ok(Some(length)),
        Reached::NotYet | Reached::Never => Ok(None),
    }
}
