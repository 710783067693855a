//! The search for remedies at work.

mod questions;
#[cfg(test)]
mod tests;

use std::sync::Arc;

use super::next_horizons::NextHorizons;
use super::{Advice, Change, Reason, Remedy};
use crate::limits::{LimitReached, Limits};
use crate::plan::Plan;
use crate::problem::{JointSpace, Problem};
use crate::solver::baseline;
use crate::solver::engine::{Advance, Engine};
use crate::solver::explorer::neighbourhood::Neighbourhood;
use crate::solver::ground::dead_ends::StatesBySteps;
use crate::solver::ground::shortest_length::{Reached, Shortest};
use crate::solver::ground::thresholds::{EXPANSIONS_OF_REMEDIES, EXPLORED, REACH_EXPANSIONS};
use crate::solver::outcome::Progress;
use crate::solver::{Bounds, Horizon, Options, OptionsError, SolveError, Solver};
use crate::trace::validate;

/// Looks for remedies, in slices.
///
/// ```
/// use std::sync::Arc;
/// use mo_copp::{domain::Delivery, solver::{Horizon, Options, Solver}};
/// use mo_copp::solver::remedy::{Change, Reason, RemedyRun};
/// let problem = Arc::new(Delivery::figure_1().problem()?);
/// let mut options = Options::new(Solver::Exact);
/// options.horizon = Horizon::Steps(4);
/// let mut run = RemedyRun::new(problem, options)?;
/// while !run.advance(100)? {}
/// let advice = run.outcome()?;
/// assert_eq!(advice.reason, Some(Reason::Length));
/// assert_eq!((advice.remedies[0].change, advice.remedies[0].value), (Change::Horizon, 3));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct RemedyRun {
    problem: Arc<Problem>,
    /// With the bounds that the solver heeds.
    options: Options,
    asked: Option<usize>,
    /// Whether it is known that there is no plan as asked for.
    proved: bool,
    /// Where the exhaustive exploration that comes first stops.
    explored: Limits,
    stage: Stage,
    /// An exploration that was too large to come first.
    parked: Option<Box<Neighbourhood>>,
    /// Expansions of the stages before.
    expansions: u64,
    reason: Option<Reason>,
    shortest: Option<usize>,
    found: Vec<(Change, usize, Plan)>,
    complete: bool,
}

/// Nothing changed, or one of the bounds.
type Question = Option<(Change, usize)>;

enum Stage {
    /// Can the true goal be reached at all? Asked after a proof, where nothing but the bounds is to blame then.
    Reach(Box<dyn Engine>),
    /// How far is the true goal?
    Shortest(Box<Shortest>),
    /// Everything at once, as far as [`EXPLORED`] goes.
    Explore(Box<Neighbourhood>),
    /// Is there a plan as asked for, or with this change of k or j?
    Question(Question, Box<dyn Engine>),
    /// Which of the next horizons would do?
    NextHorizons(Box<NextHorizons>),
    /// Which other horizon would do?
    ExploreOn(Box<Neighbourhood>),
    Done,
}

/// Shown without the engines, whose insides would weigh heavily in the wasm file.
impl std::fmt::Debug for RemedyRun {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("RemedyRun").field("reason", &self.reason).finish_non_exhaustive()
    }
}

impl RemedyRun {
    /// Checks the options and gets ready. They are those of the run that found no plan, whichever
    /// its solver; a raised horizon counts as the first one.
    ///
    /// # Errors
    ///
    /// [`SolveError::Options`].
    pub fn new(problem: Arc<Problem>, mut options: Options) -> Result<Self, SolveError> {
        options.check(&problem)?;
        if let Some(longest) = options.lengths {
            return Err(SolveError::Options(OptionsError {
                option: "lengths",
                found: longest.to_string(),
                expected: "nothing, since remedies are for one horizon or for all".to_owned(),
            }));
        }
        if let Some(limit) = options.cost_limit {
            return Err(SolveError::Options(OptionsError {
                option: "cost limit",
                found: limit.to_string(),
                expected: "nothing, since remedies are not searched under a cost limit".to_owned(),
            }));
        }
        options.bounds = options.heeded_bounds();
        options.solver = Solver::Exact;
        options.pairs = false;
        options.limits.expansions = options.limits.expansions.min(EXPANSIONS_OF_REMEDIES);
        let asked = match options.horizon {
            Horizon::Steps(steps) => Some(steps),
            Horizon::Auto | Horizon::Any => None,
        };
        let mut run = Self {
            stage: Stage::Shortest(Box::new(Shortest::new(problem.task(), options.limits))),
            problem,
            options,
            asked,
            proved: false,
            explored: EXPLORED,
            parked: None,
            expansions: 0,
            reason: None,
            shortest: None,
            found: Vec::new(),
            complete: false,
        };
        run.proved = run.contradicts(&run.options.bounds);
        if run.proved {
            run.reach();
        }
        Ok(run)
    }

    /// Begins with the question whether the goal can be reached, where the answer tells the reason.
    fn reach(&mut self) {
        if self.asked.is_none() {
            let mut limits = self.options.limits;
            limits.expansions = limits.expansions.min(REACH_EXPANSIONS);
            let engine = baseline::engine(self.problem.task(), limits, None, None);
            self.stage = Stage::Reach(Box::new(engine));
        }
    }

    /// The same after a run that proved that there is no plan ([`Status::Infeasible`]): whether there
    /// is one is not asked again, and the reason is known as soon as the shortest length is.
    ///
    /// [`Status::Infeasible`]: crate::solver::Status::Infeasible
    ///
    /// # Errors
    ///
    /// [`SolveError::Options`].
    pub fn after_proof(problem: Arc<Problem>, options: Options) -> Result<Self, SolveError> {
        let mut run = Self { proved: true, ..Self::new(problem, options)? };
        run.reach();
        Ok(run)
    }

    /// The problem.
    pub fn problem(&self) -> &Arc<Problem> {
        &self.problem
    }

    /// Works for about `budget` expansions; true when there is an answer.
    ///
    /// # Errors
    ///
    /// [`SolveError`] where the work broke down; a limit is no error.
    pub fn advance(&mut self, budget: u64) -> Result<bool, SolveError> {
        if !matches!(self.stage, Stage::Done) && self.work(budget).is_err() {
            self.finish(false);
        }
        Ok(matches!(self.stage, Stage::Done))
    }

    fn work(&mut self, budget: u64) -> Result<(), LimitReached> {
        match &mut self.stage {
            Stage::Reach(engine) => {
                let answer = engine.advance(budget);
                if matches!(answer, Ok(Advance::Working)) {
                    return Ok(());
                }
                self.expansions += engine.stats().expansions;
                match answer {
                    Ok(Advance::Finished(finding)) if finding.plan.is_none() => {
                        self.reason = Some(Reason::Unreachable);
                        self.finish(true);
                        return Ok(());
                    }
                    Ok(_) => self.reason = Some(Reason::Bounds),
                    // It may be out of reach, or not.
                    Err(_) => {}
                }
                let shortest = Shortest::new(self.problem.task(), self.options.limits);
                self.stage = Stage::Shortest(Box::new(shortest));
            }
            Stage::Shortest(shortest) => {
                let left = self.options.limits.expansions - self.expansions;
                let mut rest = budget.min(left);
                let given = rest;
                let reached = shortest.advance(&mut rest);
                self.expansions += given - rest;
                match reached? {
                    Reached::NotYet if given == left => {
                        let limit = self.options.limits.expansions;
                        return Err(LimitReached::Expansions { limit });
                    }
                    Reached::NotYet => {}
                    Reached::Never => {
                        self.reason = Some(Reason::Unreachable);
                        self.finish(true);
                    }
                    Reached::After(length) => {
                        self.shortest = Some(length);
                        self.stage = self.after_shortest(length)?;
                    }
                }
            }
            Stage::Explore(exploration) => {
                let mut limits = self.options.limits;
                let left = limits.expansions.saturating_sub(self.expansions);
                limits.expansions = self.explored.expansions.min(left);
                limits.bytes = self.explored.bytes.min(limits.bytes);
                match exploration.advance(budget, &limits) {
                    Ok(false) => {}
                    Ok(true) => self.take_all(),
                    Err(_) => self.ask_one_by_one(),
                }
            }
            Stage::Question(question, engine) => {
                if let Advance::Finished(finding) = engine.advance(budget)? {
                    let question = *question;
                    self.expansions += engine.stats().expansions;
                    self.answer(question, finding.plan);
                }
            }
            Stage::NextHorizons(horizons) => {
                if horizons.advance(budget)? {
                    self.leave_next_horizons();
                }
            }
            Stage::ExploreOn(exploration) => {
                let mut limits = self.options.limits;
                limits.expansions = limits.expansions.saturating_sub(self.expansions);
                if exploration.advance(budget, &limits)? {
                    self.take_horizons();
                    self.finish(true);
                }
            }
            Stage::Done => {}
        }
        Ok(())
    }

    /// Whether no plan keeps the bounds, whatever its length.
    fn contradicts(&self, bounds: &Bounds) -> bool {
        bounds.most_difference(&self.problem).is_none()
    }

    /// What to look at once it is known how far the goal is.
    fn after_shortest(&mut self, shortest: usize) -> Result<Stage, LimitReached> {
        if self.proved && self.asked.is_none() {
            self.reason = Some(Reason::Bounds);
        }
        if let Some(asked) = self.asked {
            let mut joint = JointSpace::listing(Arc::clone(&self.problem), self.options.limits);
            let start = joint.initial().state;
            if asked < shortest || !StatesBySteps::new(&mut joint, asked)?.contains(0, start) {
                self.reason = Some(Reason::Length);
            } else if self.proved {
                self.reason = Some(Reason::Bounds);
            }
        }
        let named = Bounds { at_least: None, at_most: None, ..self.options.bounds.clone() };
        if self.contradicts(&named) {
            // Neither another k or j nor another length helps.
            self.complete = true;
            return Ok(Stage::Done);
        }
        let problem = Arc::clone(&self.problem);
        let exploration = Neighbourhood::new(problem, &self.options, self.asked);
        Ok(Stage::Explore(Box::new(exploration)))
    }

    /// The options with what is left of the expansions allowed.
    fn rest(&self) -> Options {
        let mut options = self.options.clone();
        options.limits.expansions = options.limits.expansions.saturating_sub(self.done());
        options
    }

    fn finish(&mut self, complete: bool) {
        self.complete = complete;
        self.collect_next_horizons();
        self.expansions = self.done();
        (self.stage, self.parked) = (Stage::Done, None);
    }

    fn done(&self) -> u64 {
        let stage = match &self.stage {
            Stage::Reach(engine) | Stage::Question(_, engine) => engine.stats().expansions,
            Stage::NextHorizons(horizons) => horizons.expansions(),
            Stage::Explore(exploration) | Stage::ExploreOn(exploration) => exploration.expansions(),
            Stage::Shortest(_) | Stage::Done => 0,
        };
        self.expansions + stage + self.parked.as_ref().map_or(0, |parked| parked.expansions())
    }

    /// How far the work is.
    pub fn progress(&self) -> Progress {
        let horizon = match &self.stage {
            Stage::NextHorizons(horizons) => horizons.horizon(),
            Stage::Explore(exploration) | Stage::ExploreOn(exploration) => exploration.length(),
            _ => self.asked,
        };
        Progress { done: self.done(), ..Progress::new(Solver::Exact, horizon) }
    }

    /// The answer; that of a run stopped before its end keeps the remedies found. Every plan is
    /// replayed before it is given out.
    ///
    /// # Errors
    ///
    /// [`SolveError::Replay`] when a remedy does not do what it says.
    pub fn outcome(&mut self) -> Result<Advice, SolveError> {
        if !matches!(self.stage, Stage::Done) {
            self.finish(false);
        }
        // By how much, and which.
        let mut remedies: Vec<((usize, Change, usize), Remedy)> = Vec::new();
        for (change, value, plan) in &self.found {
            let by = match change {
                Change::Horizon => self.asked,
                Change::AtLeast => self.options.bounds.at_least,
                Change::AtMost => self.options.bounds.at_most,
            };
            let remedy = self.remedy(*change, *value, plan)?;
            // Of two horizons equally far the longer one first.
            let by = (by.unwrap_or_default().abs_diff(*value), *change, usize::MAX - value);
            let place = remedies.partition_point(|(known, _)| *known < by);
            remedies.insert(place, (by, remedy));
        }
        Ok(Advice {
            reason: self.reason,
            shortest: self.shortest,
            remedies: remedies.into_iter().map(|(_, remedy)| remedy).collect(),
            complete: self.complete,
        })
    }

    /// A remedy, once its plan has been replayed under the changed option.
    fn remedy(&self, change: Change, value: usize, plan: &Plan) -> Result<Remedy, SolveError> {
        let (mut bounds, mut horizon) = (self.options.bounds.clone(), self.asked);
        match change {
            Change::Horizon => horizon = Some(value),
            Change::AtLeast => bounds.at_least = Some(value),
            Change::AtMost => bounds.at_most = Some(value),
        }
        let achieved =
            validate(&self.problem, plan).map_err(|error| SolveError::Replay(error.to_string()))?;
        if !bounds.allow(achieved.counts, &achieved.survivors)
            || horizon.is_some_and(|horizon| horizon != plan.len())
        {
            return Err(SolveError::Replay("a remedy does not do".to_owned()));
        }
        let goal_difference = self.problem.goal_difference(achieved.counts);
        Ok(Remedy { change, value, goal_difference, plan: plan.clone() })
    }
}
