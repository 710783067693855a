//! What is asked of a solver.

use thiserror::Error;

use crate::goal_difference::GoalSet;
use crate::limits::Limits;
use crate::problem::{Problem, SurvivorCounts};

/// The longest horizon that can be asked for.
pub const MAX_HORIZON: usize = crate::plan::MAX_LENGTH;

/// The longest plans of which the best of each length can be asked for: the plans for all lengths
/// up to this one have half a million actions.
pub const MAX_LENGTHS: usize = 1000;

/// Which solver.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Solver {
    /// Best first over the states and the observers' beliefs, under upper bounds on all plans.
    Exact,
    /// Integer programming.
    Ip,
    /// Algorithm 1 of the paper, complete: greedy best first over states and approximate beliefs.
    Search,
    /// Any plan that keeps the bounds, or the proof that there is none: a sequential portfolio of
    /// Algorithm 1 and exact search.
    Satisficing,
    /// Greedy best first for the true goal alone.
    Baseline,
    /// Algorithm 1 with k alone: the friend is not asked about.
    Obfuscate,
    /// Algorithm 1 with j alone: the enemy is not asked about.
    Legible,
}

impl Solver {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::Exact,
        Self::Ip,
        Self::Search,
        Self::Satisficing,
        Self::Baseline,
        Self::Obfuscate,
        Self::Legible,
    ];

    /// The name on the command line and in output.
    pub fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Ip => "ip",
            Self::Search => "search",
            Self::Satisficing => "satisficing",
            Self::Baseline => "baseline",
            Self::Obfuscate => "obfuscate",
            Self::Legible => "legible",
        }
    }

    /// The solver of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|solver| solver.name() == name)
    }
}

/// Which integer program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Encoding {
    /// The paper's equations (3) to (17), corrected: to teach and to check.
    Paper,
    /// Flows over (state, belief): to use.
    #[default]
    BeliefFlow,
}

impl Encoding {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Paper, Self::BeliefFlow];

    /// The name on the command line and in output.
    pub fn name(self) -> &'static str {
        match self {
            Self::Paper => "paper",
            Self::BeliefFlow => "belief-flow",
        }
    }

    /// The encoding of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|encoding| encoding.name() == name)
    }
}

/// How long plans may be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Horizon {
    /// What suits the solver: for the integer program the length of a shortest plan, raised until
    /// there is a plan that keeps the bounds; for all others any length.
    #[default]
    Auto,
    /// Plans of any length.
    Any,
    /// Plans of exactly this many actions.
    Steps(usize),
}

/// A goal in the final belief of an observer, by their positions in the problem.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Watched {
    /// The observer.
    pub observer: usize,
    /// The goal.
    pub goal: usize,
}

/// What a plan must achieve in the final beliefs: the goal constraints of the paper.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
#[non_exhaustive]
pub struct Bounds {
    /// At least this many goals survive for every enemy (k).
    pub at_least: Option<usize>,
    /// At most this many goals survive for every friend (j).
    pub at_most: Option<usize>,
    /// Goals that must survive.
    pub required: Vec<Watched>,
    /// Goals that must not survive.
    pub forbidden: Vec<Watched>,
}

impl Bounds {
    /// Whether final beliefs with these survivors, one set for each observer, are allowed.
    pub fn allow(&self, counts: SurvivorCounts, sets: &[GoalSet]) -> bool {
        self.at_least.is_none_or(|k| counts.adversarial >= k)
            && self.at_most.is_none_or(|j| counts.cooperative <= j)
            && self.required.iter().all(|w| sets[w.observer].contains(w.goal))
            && self.forbidden.iter().all(|w| !sets[w.observer].contains(w.goal))
    }
}

/// Options that do not fit the problem.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{option}: found {found}, expected {expected}")]
#[non_exhaustive]
pub struct OptionsError {
    /// Which option.
    pub option: &'static str,
    /// What was given.
    pub found: String,
    /// What would do.
    pub expected: String,
}

/// What is asked of a solver.
///
/// ```
/// use mo_copp::solver::{Options, Solver};
/// let mut options = Options::new(Solver::Search);
/// options.bounds.at_least = Some(2);
/// options.bounds.at_most = Some(2);
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Options {
    /// The solver.
    pub solver: Solver,
    /// The integer program, for [`Solver::Ip`].
    pub encoding: Encoding,
    /// The length of plans.
    pub horizon: Horizon,
    /// By how much the horizon is raised while it has no plan; 0 for not at all. With
    /// [`Horizon::Auto`] the integer program raises by at least 1.
    pub horizon_step: usize,
    /// How far the horizon is raised.
    pub horizon_limit: usize,
    /// What the plan must achieve.
    pub bounds: Bounds,
    /// Whether every reachable pair of survivor counts is wanted, for [`Solver::Exact`].
    pub pairs: bool,
    /// The longest of the lengths for each of which the best plan is wanted, for
    /// [`Solver::Exact`]: from 0 to this one. The plan asked for has at most so many actions.
    pub lengths: Option<usize>,
    /// The most that a plan may cost; where the task has no costs, the most actions that it may have.
    pub cost_limit: Option<u64>,
    /// Where to stop.
    pub limits: Limits,
}

impl OptionsError {
    /// An option that does not fit.
    pub fn new(
        option: &'static str,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) -> Self {
        Self { option, found: found.into(), expected: expected.into() }
    }
}

impl Options {
    /// The defaults of a solver: any length, no bounds.
    pub fn new(solver: Solver) -> Self {
        Self {
            solver,
            encoding: Encoding::default(),
            horizon: Horizon::Auto,
            horizon_step: 0,
            horizon_limit: 100,
            bounds: Bounds::default(),
            pairs: false,
            lengths: None,
            cost_limit: None,
            limits: Limits::default(),
        }
    }

    /// Checks the options against a problem.
    ///
    /// # Errors
    ///
    /// [`OptionsError`] with the option, what was given and what would do.
    pub fn check(&self, problem: &Problem) -> Result<(), OptionsError> {
        let goals = problem.goals().len();
        for (option, value) in [("k", self.bounds.at_least), ("j", self.bounds.at_most)] {
            if value.is_some_and(|value| !(1..=goals).contains(&value)) {
                return Err(OptionsError {
                    option,
                    found: value.unwrap_or_default().to_string(),
                    expected: format!("a whole number from 1 to {goals}, the number of goals"),
                });
            }
        }
        let observers = problem.observers().len();
        let lists = [("require", &self.bounds.required), ("forbid", &self.bounds.forbidden)];
        for (option, list) in lists {
            for watched in list {
                let positions =
                    [("an observer", watched.observer, observers), ("a goal", watched.goal, goals)];
                for (kind, found, count) in positions {
                    if found >= count {
                        let expected = format!("the position of {kind}, 0 to {}", count - 1);
                        return Err(OptionsError { option, found: found.to_string(), expected });
                    }
                }
            }
        }
        let too_long = |steps: usize| steps > MAX_HORIZON;
        let horizon = match self.horizon {
            Horizon::Steps(steps) => steps,
            Horizon::Auto | Horizon::Any => 0,
        };
        for (option, steps) in [
            ("horizon", horizon),
            ("horizon step", self.horizon_step),
            ("horizon limit", self.horizon_limit),
        ] {
            if too_long(steps) {
                let expected = format!("a whole number from 0 to {MAX_HORIZON}");
                return Err(OptionsError { option, found: steps.to_string(), expected });
            }
        }
        if self.solver == Solver::Ip && self.horizon == Horizon::Any {
            return Err(OptionsError {
                option: "horizon",
                found: "any".to_owned(),
                expected: "a number of steps for the integer program; the exact solver takes any"
                    .to_owned(),
            });
        }
        if self.pairs && self.solver != Solver::Exact {
            return Err(OptionsError {
                option: "pairs",
                found: format!("the solver {}", self.solver.name()),
                expected: "the solver exact".to_owned(),
            });
        }
        self.check_lengths()
    }

    fn check_lengths(&self) -> Result<(), OptionsError> {
        let Some(longest) = self.lengths else { return Ok(()) };
        let (found, expected) = match self.horizon {
            _ if longest > MAX_LENGTHS => {
                (longest.to_string(), format!("a whole number from 0 to {MAX_LENGTHS}"))
            }
            _ if self.solver != Solver::Exact => {
                (format!("the solver {}", self.solver.name()), "the solver exact".to_owned())
            }
            Horizon::Steps(steps) => (
                format!("a horizon of {steps}"),
                format!("no horizon, since all from 0 to {longest} are tried"),
            ),
            Horizon::Auto | Horizon::Any => return Ok(()),
        };
        Err(OptionsError { option: "lengths", found, expected })
    }

    /// The bounds that a solver heeds: obfuscation knows no j, legibility no k, the baseline
    /// neither.
    pub fn heeded_bounds(&self) -> Bounds {
        let mut bounds = self.bounds.clone();
        match self.solver {
            Solver::Exact | Solver::Ip | Solver::Search | Solver::Satisficing => {}
            Solver::Obfuscate => bounds.at_most = None,
            Solver::Legible => bounds.at_least = None,
            Solver::Baseline => bounds = Bounds::default(),
        }
        bounds
    }
}
