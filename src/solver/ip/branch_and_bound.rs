//! Solves an integer program with microlp, in slices of branch-and-bound nodes.
//!
//! A search cut into slices by a node limit takes the same nodes as one that is not, so slices
//! change no answer. The relaxation at the root is one piece of work that cannot be cut.

use std::sync::Arc;

use microlp::{
    ComparisonOp, OptimizationDirection, ResumeOptions, SolutionStatus, SolveOptions, SolveOutcome,
};

use super::model::{Comparison, Kind, Model, Variable};
use super::{Encoded, encode};
use crate::limits::{LimitReached, Limits};
use crate::plan::Plan;
use crate::problem::Problem;
use crate::solver::Options;
use crate::solver::engine::{Advance, Engine, Finding};
use crate::solver::ground::thresholds::{FIRST_PLAN_EXPANSIONS, NODES_BETWEEN_CHECKS};
use crate::solver::outcome::{Progress, Stats, Status};
use crate::trace::{check_cost, validate};

/// Bytes that microlp keeps for an open node besides one for each variable and row: the changes of
/// bounds on the way to it and its own fields.
const BYTES_OF_A_NODE: u64 = 512;

/// Slack when a bound on a whole number is rounded down.
const ROUNDING: f64 = 1e-6;

/// A program being solved.
pub(in crate::solver) struct IntegerProgram {
    /// None when the encoding has already shown that there is no plan.
    encoded: Option<Encoded>,
    problem: Arc<Problem>,
    limits: Limits,
    cost_limit: Option<u64>,
    /// Looks for a plan before the program is solved.
    starter: Box<dyn Engine>,
    state: State,
    stats: Stats,
    /// The best plan the program has found.
    best: Option<(f64, Plan)>,
    /// A plan from before the program was solved.
    first: Option<(f64, Plan)>,
    bound: Option<f64>,
}

#[derive(Debug)]
enum State {
    /// Nothing has been tried.
    Begin,
    /// A first plan has been looked for.
    New,
    Working(Box<SolveOutcome>),
    Done,
}

/// The model in microlp's terms; its variables have the same numbers.
fn to_microlp(model: &Model) -> (microlp::Problem, Vec<microlp::Variable>) {
    let mut problem = microlp::Problem::new(OptimizationDirection::Maximize);
    let variables: Vec<microlp::Variable> = model
        .variables()
        .iter()
        .map(|data| match data.kind {
            Kind::Binary => {
                let bounds = (data.lower as i32, data.upper as i32);
                problem.add_integer_var(data.objective, bounds)
            }
            Kind::Continuous => problem.add_var(data.objective, (data.lower, data.upper)),
        })
        .collect();
    for row in model.rows() {
        let terms: Vec<_> = row.terms.iter().map(|&(v, c)| (variables[v.index()], c)).collect();
        let operator = match row.comparison {
            Comparison::AtMost => ComparisonOp::Le,
            Comparison::Equal => ComparisonOp::Eq,
            Comparison::AtLeast => ComparisonOp::Ge,
        };
        problem.add_constraint(terms, operator, row.right);
    }
    (problem, variables)
}

/// Shown without the engine.
impl std::fmt::Debug for IntegerProgram {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("IntegerProgram").field("bound", &self.bound).finish_non_exhaustive()
    }
}

impl IntegerProgram {
    /// `starter` is an engine that may have a plan of the horizon at hand after a few expansions.
    pub(in crate::solver) fn new(
        problem: Arc<Problem>,
        options: &Options,
        horizon: usize,
        starter: Box<dyn Engine>,
    ) -> Result<Self, LimitReached> {
        let encoded = encode(Arc::clone(&problem), options, horizon)?;
        let stats = encoded.as_ref().map_or_else(Stats::default, |encoded| encoded.spaces);
        Ok(Self {
            encoded,
            problem,
            limits: options.limits,
            cost_limit: options.cost_limit,
            starter,
            state: State::Begin,
            stats,
            best: None,
            first: None,
            bound: None,
        })
    }

    /// Looks for a plan to have before the relaxation at the root is solved, which can take long
    /// and cannot be cut. The program is not told, so it finds its own.
    fn first_plan(&mut self) {
        if self.starter.advance(FIRST_PLAN_EXPANSIONS).is_err() {
            return;
        }
        let Some(plan) = self.starter.stop(LimitReached::Cancelled).plan else { return };
        if let Ok(achieved) = validate(&self.problem, &plan) {
            self.first = Some((achieved.counts.difference() as f64, plan));
        }
    }

    /// The better one of the plan found by the program and the first plan.
    fn best(&self) -> Option<&(f64, Plan)> {
        match (&self.best, &self.first) {
            (Some(best), Some(first)) if first.0 > best.0 + ROUNDING => Some(first),
            (Some(best), _) => Some(best),
            (None, first) => first.as_ref(),
        }
    }

    /// Takes note of what a slice has brought.
    fn note(&mut self, encoded: &Encoded, outcome: &SolveOutcome) {
        let stats = outcome.stats();
        self.stats.nodes = stats.nodes_solved;
        self.stats.iterations = stats.lp_iterations;
        self.bound = stats.best_bound;
        let Some(solution) = outcome.solution() else { return };
        let objective = solution.objective();
        if self.best.as_ref().is_none_or(|(known, _)| objective > known + ROUNDING) {
            // Variables have the same numbers here and there.
            let values: Vec<f64> = solution.iter().map(|(_, value)| value).collect();
            let plan = encoded.plan(|Variable(index)| values[index as usize]);
            self.best = Some((objective, plan));
        }
    }

    fn slice(&mut self, encoded: &Encoded, budget: u64) -> Result<Advance, LimitReached> {
        let left = self.limits.nodes.saturating_sub(self.stats.nodes);
        let to_check = NODES_BETWEEN_CHECKS - self.stats.nodes % NODES_BETWEEN_CHECKS;
        let nodes = budget.max(1).min(left).min(to_check);
        let solved = match std::mem::replace(&mut self.state, State::Done) {
            State::Begin => {
                self.state = State::New;
                self.first_plan();
                return Ok(Advance::Working);
            }
            State::New => {
                let (problem, _) = to_microlp(&encoded.model);
                let mut options = SolveOptions::default();
                options.node_limit = Some(nodes);
                problem.solve_with(options)
            }
            State::Working(outcome) => {
                let mut options = ResumeOptions::default();
                options.node_limit = Some(nodes);
                outcome.resume_with(options)
            }
            State::Done => return Ok(Advance::Working),
        };
        let outcome = match solved {
            Ok(outcome) => outcome,
            Err(microlp::Error::Infeasible) if self.first.is_none() => {
                return Ok(Advance::Finished(Finding::infeasible()));
            }
            Err(_) => return Err(LimitReached::Numerical),
        };
        self.note(encoded, &outcome);
        // Costs of very different sizes are beyond the tolerance of the linear program.
        let beyond = |plan: &Plan| check_cost(&self.problem, plan, self.cost_limit).is_err();
        if self.best.as_ref().is_some_and(|(_, plan)| beyond(plan)) {
            self.best = None;
            return Err(LimitReached::Numerical);
        }
        let optimal =
            outcome.solution().is_some_and(|found| found.status() == SolutionStatus::Optimal);
        if let (true, Some((objective, plan))) = (optimal, &self.best) {
            // The first plan is a witness: an optimum below it is none.
            if self.first.as_ref().is_some_and(|(first, _)| *first > objective + ROUNDING) {
                return Err(LimitReached::Numerical);
            }
            return Ok(Advance::Finished(Finding::plan(Status::Optimal, plan.clone())));
        }
        self.state = State::Working(Box::new(outcome));
        if self.stats.nodes.is_multiple_of(NODES_BETWEEN_CHECKS) {
            // No more nodes are open than have been solved, but for one.
            let of_a_node = self.stats.variables + self.stats.rows + BYTES_OF_A_NODE;
            self.limits.check_bytes(self.stats.nodes * of_a_node)?;
        }
        if self.stats.nodes >= self.limits.nodes {
            return Err(LimitReached::Nodes { limit: self.limits.nodes });
        }
        Ok(Advance::Working)
    }
}

impl Engine for IntegerProgram {
    fn advance(&mut self, budget: u64) -> Result<Advance, LimitReached> {
        let Some(encoded) = self.encoded.take() else {
            return Ok(Advance::Finished(Finding::infeasible()));
        };
        let advance = self.slice(&encoded, budget);
        self.encoded = Some(encoded);
        advance
    }

    fn stop(&mut self, limit: LimitReached) -> Finding {
        Finding::stopped(self.best().map(|(_, plan)| plan.clone()), limit)
    }

    fn report(&self, progress: &mut Progress) {
        let most = self.problem.goals().len() as f64 - 1.0;
        let whole = |bound: f64| (bound + ROUNDING).floor().min(most) / most;
        progress.bound = Some(self.bound.map_or(1.0, whole));
        if let Some((objective, plan)) = self.best() {
            progress.goal_difference = Some(objective.round() / most);
            progress.plan = Some(plan.clone());
        }
    }

    fn stats(&self) -> Stats {
        self.stats
    }
}
