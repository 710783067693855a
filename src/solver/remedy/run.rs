//! The search for remedies at work.

use std::sync::Arc;

use super::horizons::Horizons;
use super::{Advice, Change, Reason, Remedy};
use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::{JointSpace, Problem};
use crate::solver::engine::{Advance, Engine};
use crate::solver::exact;
use crate::solver::live::LiveLayers;
use crate::solver::outcome::{Progress, Stats};
use crate::solver::run::SolveError;
use crate::solver::shortest::{Reached, Shortest};
use crate::solver::{Horizon, Options, OptionsError, Solver};
use crate::trace::validate;

/// Expansions after which the search gives up, where the options allow no fewer.
const MOST_EXPANSIONS: u64 = 1_000_000;

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
    stage: Stage,
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
    /// How far is the true goal?
    Shortest(Box<Shortest>),
    /// Is there a plan as asked for, or with this change of k or j?
    Question(Question, Box<dyn Engine>),
    /// Which other horizons would do?
    Horizons(Box<Horizons>),
    Done,
}

/// Shown without the engines, whose insides would weigh heavily in the wasm file.
impl std::fmt::Debug for RemedyRun {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("RemedyRun").field("reason", &self.reason).finish_non_exhaustive()
    }
}

impl RemedyRun {
    /// Checks the options and gets ready. They are those of the run that found no plan, whoever
    /// the solver was; a raised horizon counts as the first one.
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
        options.bounds = options.heeded_bounds();
        options.solver = Solver::Exact;
        options.pareto = false;
        options.limits.expansions = options.limits.expansions.min(MOST_EXPANSIONS);
        let asked = match options.horizon {
            Horizon::Steps(steps) => Some(steps),
            Horizon::Auto | Horizon::Any => None,
        };
        Ok(Self {
            stage: Stage::Shortest(Box::new(Shortest::new(problem.task(), options.limits))),
            problem,
            options,
            asked,
            expansions: 0,
            reason: None,
            shortest: None,
            found: Vec::new(),
            complete: false,
        })
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
            Stage::Question(question, engine) => {
                if let Advance::Finished(finding) = engine.advance(budget)? {
                    let question = *question;
                    self.expansions += engine.stats().expansions;
                    self.answer(question, finding.plan);
                }
            }
            Stage::Horizons(horizons) => {
                if horizons.advance(budget)? {
                    self.finish(true);
                }
            }
            Stage::Done => {}
        }
        Ok(())
    }

    /// What to look at once it is known how far the goal is.
    fn after_shortest(&mut self, shortest: usize) -> Result<Stage, LimitReached> {
        if let Some(asked) = self.asked {
            let problem = Arc::clone(&self.problem);
            let mut joint = JointSpace::new(Arc::clone(&problem), self.options.limits);
            let start = joint.initial().state;
            if asked < shortest || !LiveLayers::new(&mut joint, asked)?.contains(0, start) {
                self.reason = Some(Reason::Length);
                let horizons = Horizons::new(problem, self.rest(), asked, shortest);
                return Ok(Stage::Horizons(Box::new(horizons)));
            }
        }
        Ok(self.ask(None))
    }

    fn ask(&self, question: Question) -> Stage {
        let mut options = self.rest();
        match question {
            Some((Change::AtLeast, value)) => options.bounds.at_least = Some(value),
            Some((Change::AtMost, value)) => options.bounds.at_most = Some(value),
            _ => {}
        }
        let engine = exact::engine(Arc::clone(&self.problem), &options, self.asked);
        Stage::Question(question, engine)
    }

    /// Goes on after the answer to a question: with a smaller k until there is a plan, then with a
    /// greater j until there is one, then with other horizons.
    fn answer(&mut self, question: Question, plan: Option<Plan>) {
        let found = plan.is_some();
        match (question, plan) {
            (None, Some(_)) => {
                self.finish(true);
                return;
            }
            (None, None) => self.reason = Some(Reason::Bounds),
            (Some((change, value)), Some(plan)) => self.found.push((change, value, plan)),
            (Some(_), None) => {}
        }
        let bounds = &self.options.bounds;
        let at_least = match question {
            None => bounds.at_least,
            Some((Change::AtLeast, value)) if !found => Some(value),
            Some(_) => None,
        };
        let at_most = match question {
            Some((Change::AtMost, _)) if found => None,
            Some((Change::AtMost, value)) => Some(value),
            _ => bounds.at_most,
        };
        let most = self.problem.goals().len();
        let next = if let Some(k) = at_least.filter(|k| *k > 1) {
            self.ask(Some((Change::AtLeast, k - 1)))
        } else if let Some(j) = at_most.filter(|j| *j < most) {
            self.ask(Some((Change::AtMost, j + 1)))
        } else if let (Some(asked), Some(shortest)) = (self.asked, self.shortest) {
            let problem = Arc::clone(&self.problem);
            Stage::Horizons(Box::new(Horizons::new(problem, self.rest(), asked, shortest)))
        } else {
            self.finish(true);
            return;
        };
        self.stage = next;
    }

    /// The options with what is left of the expansions allowed.
    fn rest(&self) -> Options {
        let mut options = self.options.clone();
        options.limits.expansions = options.limits.expansions.saturating_sub(self.expansions);
        options
    }

    fn finish(&mut self, complete: bool) {
        self.complete = complete;
        self.expansions = self.done();
        if let Stage::Horizons(horizons) = std::mem::replace(&mut self.stage, Stage::Done) {
            let plans = horizons.found.into_iter();
            self.found.extend(plans.map(|plan| (Change::Horizon, plan.len(), plan)));
        }
    }

    fn done(&self) -> u64 {
        let stage = match &self.stage {
            Stage::Question(_, engine) => engine.stats().expansions,
            Stage::Horizons(horizons) => horizons.expansions(),
            Stage::Shortest(_) | Stage::Done => 0,
        };
        self.expansions + stage
    }

    /// How far the work is.
    pub fn progress(&self) -> Progress {
        Progress {
            solver: Solver::Exact,
            done: self.done(),
            stats: Stats::default(),
            horizon: match &self.stage {
                Stage::Horizons(horizons) => horizons.horizon(),
                _ => self.asked,
            },
            goal_difference: None,
            bound: None,
            plan: None,
        }
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
