//! What other programs ask of a solver.

use serde::Deserialize;

use crate::problem::Problem;
use crate::solver::{Encoding, Horizon, Options, OptionsError, Solver, Watched};

/// Options by name, as the JavaScript API and other programs write them.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SolveRequest {
    /// The solver's name.
    pub solver: String,
    /// The integer program's name.
    #[serde(default)]
    pub encoding: Option<String>,
    /// A number of steps, or `any`.
    #[serde(default)]
    pub horizon: Option<HorizonRequest>,
    /// By how much the horizon is raised while it has no plan.
    #[serde(default)]
    pub horizon_step: Option<f64>,
    /// How far it is raised.
    #[serde(default)]
    pub horizon_limit: Option<f64>,
    /// At least this many goals survive for the enemy.
    #[serde(default)]
    pub k: Option<f64>,
    /// At most this many goals survive for the friend.
    #[serde(default)]
    pub j: Option<f64>,
    /// Goals that must survive.
    #[serde(default)]
    pub require: Vec<WatchedRequest>,
    /// Goals that must not survive.
    #[serde(default)]
    pub forbid: Vec<WatchedRequest>,
    /// Whether every reachable pair of survivor counts is wanted.
    #[serde(default)]
    pub pareto: bool,
}

/// A horizon by number or name.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(untagged)]
pub enum HorizonRequest {
    /// A number of steps.
    Steps(f64),
    /// `any`.
    Name(String),
}

/// A goal in the final belief of an observer, by names.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WatchedRequest {
    /// The observer's name.
    pub observer: String,
    /// The goal's name.
    pub goal: String,
}

fn whole(option: &'static str, value: f64) -> Result<usize, OptionsError> {
    if value >= 0.0 && value.fract() == 0.0 && value <= f64::from(u32::MAX) {
        return Ok(value as usize);
    }
    let expected = "a whole number from 0".to_owned();
    Err(OptionsError { option, found: value.to_string(), expected })
}

fn unknown(option: &'static str, found: &str, names: &[&str]) -> OptionsError {
    let expected = format!("one of {}", names.join(", "));
    OptionsError { option, found: format!("{found:?}"), expected }
}

impl WatchedRequest {
    /// The positions of the names.
    ///
    /// # Errors
    ///
    /// An unknown observer or goal.
    pub fn resolve(
        &self,
        option: &'static str,
        problem: &Problem,
    ) -> Result<Watched, OptionsError> {
        let observers: Vec<&str> = problem.observers().iter().map(|o| o.name.as_str()).collect();
        let goals: Vec<&str> = problem.goals().iter().map(|goal| goal.name.as_str()).collect();
        Ok(Watched {
            observer: problem
                .observer_named(&self.observer)
                .ok_or_else(|| unknown(option, &self.observer, &observers))?,
            goal: problem
                .goal_named(&self.goal)
                .ok_or_else(|| unknown(option, &self.goal, &goals))?,
        })
    }
}

impl SolveRequest {
    /// The options meant.
    ///
    /// # Errors
    ///
    /// [`OptionsError`] with the option, what was given and what would do.
    pub fn options(&self, problem: &Problem) -> Result<Options, OptionsError> {
        let solver = Solver::named(&self.solver)
            .ok_or_else(|| unknown("solver", &self.solver, &Solver::ALL.map(Solver::name)))?;
        let mut options = Options::new(solver);
        if let Some(name) = &self.encoding {
            options.encoding = Encoding::named(name)
                .ok_or_else(|| unknown("encoding", name, &Encoding::ALL.map(Encoding::name)))?;
        }
        options.horizon = match &self.horizon {
            None => Horizon::Auto,
            Some(HorizonRequest::Steps(steps)) => Horizon::Steps(whole("horizon", *steps)?),
            Some(HorizonRequest::Name(name)) if name == "any" => Horizon::Any,
            Some(HorizonRequest::Name(name)) => {
                return Err(unknown("horizon", name, &["a number of steps", "any"]));
            }
        };
        if let Some(step) = self.horizon_step {
            options.horizon_step = whole("horizon step", step)?;
        }
        if let Some(limit) = self.horizon_limit {
            options.horizon_limit = whole("horizon limit", limit)?;
        }
        options.bounds.at_least = self.k.map(|k| whole("k", k)).transpose()?;
        options.bounds.at_most = self.j.map(|j| whole("j", j)).transpose()?;
        let resolve = |option, watched: &[WatchedRequest]| -> Result<Vec<Watched>, OptionsError> {
            watched.iter().map(|watched| watched.resolve(option, problem)).collect()
        };
        options.bounds.required = resolve("require", &self.require)?;
        options.bounds.forbidden = resolve("forbid", &self.forbid)?;
        options.pareto = self.pareto;
        options.check(problem)?;
        Ok(options)
    }
}
