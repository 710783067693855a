//! Integer programming: the best plan of exactly T actions.
//!
//! - `model` is a linear program with integer variables, as data,
//! - `paper` writes the paper's equations (3) to (17) into one, with their corrections,
//! - `belief_flow` writes a far smaller one, whose relaxation is nearly integral,
//! - `objective` is what both maximise,
//! - `lp_format` prints a model for any other solver,
//! - `branch_and_bound` solves it with microlp, in slices.

mod belief_flow;
mod branch_and_bound;
mod lp_format;
mod model;
mod objective;
mod paper;

use std::sync::Arc;

use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::{JointSpace, Problem};
use crate::task::Action;

use super::{Bounds, Encoding, Options};
pub(super) use branch_and_bound::IntegerProgram;
use model::{Comparison, Model, Name, Variable};

/// Greater costs are written as parts of the greatest: the errors of a linear program grow with its
/// coefficients, and a plan at the limit would be lost by them.
const LARGE_COST: u64 = 1_000_000;

/// A problem at a horizon as an integer program.
#[derive(Debug)]
pub(super) struct Encoded {
    /// The program. Maximising it maximises `|G_X| − |G_C|`.
    model: Model,
    /// For each step, the actions that can be taken and the variables whose sum says whether one
    /// is.
    choices: Vec<Vec<(Action, Vec<Variable>)>>,
    /// States and beliefs met on the way.
    spaces: super::Stats,
}

impl Encoded {
    /// A row by which the actions cost no more than a limit.
    fn limit_cost(&mut self, problem: &Problem, limit: u64) {
        let task = problem.task();
        let choices = self.choices.iter().flatten();
        let most = choices.clone().map(|(action, _)| task.step_cost(*action)).max();
        let unit = most.filter(|most| *most > LARGE_COST).map_or(1.0, |most| most as f64);
        let mut terms = Vec::new();
        for (action, variables) in choices {
            let cost = task.step_cost(*action) as f64 / unit;
            terms.extend(variables.iter().map(|&variable| (variable, cost)));
        }
        self.model.row(Name::new("cost", []), terms, Comparison::AtMost, limit as f64 / unit);
    }

    /// The plan in a solution of the program.
    pub fn plan(&self, value: impl Fn(Variable) -> f64) -> Plan {
        let sum = |variables: &[Variable]| variables.iter().map(|&v| value(v)).sum::<f64>();
        let taken = |choices: &Vec<(Action, Vec<Variable>)>| {
            choices.iter().find(|(_, variables)| sum(variables) > 0.5).map(|(action, _)| *action)
        };
        Plan { actions: self.choices.iter().filter_map(taken).collect() }
    }
}

/// An integer program in LP format, which other solvers read.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct LpFormat {
    /// The text. Maximising its objective maximises `|G_X| − |G_C|`.
    pub text: String,
    /// False where it is known beforehand that there is no plan; no solver can solve the text then.
    pub may_be_solved: bool,
}

/// Writes a problem at a horizon as an integer program in LP format.
///
/// # Errors
///
/// The memory limit, or the limit on the size of a model.
///
/// ```
/// use std::sync::Arc;
/// use mo_copp::{domain::Delivery, solver::{Options, Solver, lp_format}};
/// let problem = Arc::new(Delivery::figure_1().problem()?);
/// let program = lp_format(problem, &Options::new(Solver::Ip), 3)?;
/// assert!(program.may_be_solved && program.text.contains("Maximize"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn lp_format(
    problem: Arc<Problem>,
    options: &Options,
    horizon: usize,
) -> Result<LpFormat, LimitReached> {
    Ok(match encode(problem, options, horizon)? {
        Some(encoded) => LpFormat { text: lp_format::to_lp(&encoded.model), may_be_solved: true },
        None => {
            let why = format!("there is no such plan of {horizon} actions");
            LpFormat { text: lp_format::infeasible(&why), may_be_solved: false }
        }
    })
}

/// Writes a problem at a horizon as an integer program; none when the actor alone, without anybody
/// watching, has no plan of that length, or none whose final beliefs could keep the bounds.
///
/// # Errors
///
/// The memory limit, or the limit on the size of a model.
pub(super) fn encode(
    problem: Arc<Problem>,
    options: &Options,
    horizon: usize,
) -> Result<Option<Encoded>, LimitReached> {
    let mut joint = JointSpace::listing(problem, options.limits);
    joint.check_lists()?;
    let bounds: Bounds = options.heeded_bounds();
    let mut encoded = match options.encoding {
        Encoding::Paper => paper::encode(&mut joint, &bounds, horizon)?,
        Encoding::BeliefFlow => belief_flow::encode(&mut joint, &bounds, horizon)?,
    };
    if let (Some(encoded), Some(limit)) = (&mut encoded, options.cost_limit) {
        encoded.limit_cost(joint.problem(), limit);
        encoded.model.check(joint.limits())?;
    }
    if let Some(encoded) = &mut encoded {
        let n = joint.problem().goals().len();
        encoded
            .model
            .note("the objective is the survivors for the enemy minus those for the friend;");
        encoded.model.note(format!("divided by {} it is the goal difference", n - 1));
        encoded.spaces.count_spaces(&joint);
        encoded.spaces.variables = encoded.model.variables().len() as u64;
        encoded.spaces.rows = encoded.model.rows().len() as u64;
    }
    Ok(encoded)
}
