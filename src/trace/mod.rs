//! The trace of a plan: its replay, with everything that the observers make of it.
//!
//! This is the one independent witness for every solver: it works on plain sets of states with the
//! definitions of Section 2 of the paper and shares nothing with the solvers' interned spaces but
//! the task and the sensors themselves. A belief that outgrows a list goes on as a decision diagram
//! ([`TracedBelief`]), so a plan can be replayed where no list of a belief would fit into memory.

mod belief;
mod elimination;
mod nearest;
mod reachable_goals;
mod settle;
#[cfg(test)]
mod tests;
mod validator;
mod witness;

use belief::Budget;

pub use belief::TracedBelief;
pub use elimination::{Elimination, MAX_LISTED, Missed, elimination};
pub use nearest::{Nearest, nearest};
pub use reachable_goals::ReachableGoals;
pub(crate) use settle::open_goals;
pub use settle::validate_within;
pub(crate) use validator::validate_quickly;
pub use validator::{Achievement, InvalidPlan, check_cost, validate, validate_with};
pub use witness::Witness;

use crate::belief::StateCount;
use crate::belief::diagram::suits;
use crate::goal_difference::GoalSet;
use crate::plan::{Plan, PlanError, execute};
use crate::problem::{Observer, Problem};
use crate::sensor::Symbol;
use crate::task::{Action, OperatorId, State, Task};

/// The most believed states that a trace keeps, over all steps and observers; and the most of one
/// step that is only passed.
const MAX_STATES: usize = if cfg!(target_arch = "wasm32") { 500_000 } else { 4_000_000 };

/// What holds after some steps of a plan.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct TraceStep {
    /// The action that led here; none at the start.
    pub action: Option<Action>,
    /// Where the actor is.
    pub state: State,
    /// The symbol each observer saw; none at the start.
    pub symbols: Vec<Option<String>>,
    /// What each observer believes, in order of the packed states.
    pub beliefs: Vec<Vec<State>>,
    /// The goals that survive for each observer.
    pub survivors: Vec<GoalSet>,
}

/// A step as it is passed, before anything of it is kept. The fields are those of [`TraceStep`].
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub struct Passing<'a> {
    /// The action that led here; none at the start.
    pub action: Option<Action>,
    /// Where the actor is.
    pub state: &'a State,
    /// The symbol each observer saw; none at the start.
    pub symbols: &'a [Option<String>],
    /// What each observer believes.
    pub beliefs: &'a [TracedBelief],
    /// The goals that survive for each observer.
    pub survivors: &'a [GoalSet],
}

/// A replay: step 0 is the start.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Trace {
    /// The start and every step.
    pub steps: Vec<TraceStep>,
    /// Whether the true goal holds at the end.
    pub reaches_goal: bool,
}

/// Finds the operators that may be applicable in a state by one fact each requires.
#[derive(Debug)]
struct OperatorsByFact {
    by_fact: Vec<Vec<OperatorId>>,
    always: Vec<OperatorId>,
}

impl OperatorsByFact {
    fn new(task: &Task) -> Self {
        let mut by_fact = vec![Vec::new(); task.fact_count()];
        let mut always = Vec::new();
        for (id, operator) in task.operator_ids() {
            match operator.preconditions.first() {
                Some(fact) => by_fact[fact.index()].push(id),
                None => always.push(id),
            }
        }
        Self { by_fact, always }
    }

    /// Calls `visit` with each applicable operator and the packed state it results in.
    fn successors(&self, task: &Task, state: &State, mut visit: impl FnMut(OperatorId, &[u64])) {
        let facts = task.facts_of(state.words());
        let mut words = vec![0; state.words().len()];
        let near = facts.iter().flat_map(|fact| &self.by_fact[fact.index()]);
        for &id in near.chain(&self.always) {
            if task.satisfies(state.words(), &task.operator(id).preconditions) {
                words.copy_from_slice(state.words());
                task.apply(id, &mut words);
                visit(id, &words);
            }
        }
    }
}

/// Walks a plan step by step, holding the present beliefs only.
#[derive(Debug)]
struct Replay<'a> {
    problem: &'a Problem,
    operators: OperatorsByFact,
    path: Vec<OperatorId>,
    states: Vec<State>,
    at: usize,
    beliefs: Vec<TracedBelief>,
    /// The most states of a belief that is listed.
    listed: usize,
    budget: Budget,
    /// By observer: every goal is known to survive in the end, so that its beliefs are left as they were.
    all_alive: Vec<bool>,
}

impl<'a> Replay<'a> {
    fn new(problem: &'a Problem, plan: &Plan) -> Result<Self, PlanError> {
        let task = problem.task();
        let label = |words: &[u64]| problem.label(words).to_string();
        let (path, states) = execute(task, plan, label)?;
        let budget = Budget::full();
        let first = |observer: &Observer| TracedBelief::initial(task, observer, budget.limits);
        let beliefs = problem.observers().iter().map(first).collect();
        let operators = OperatorsByFact::new(task);
        // Where no diagram is affordable, all beliefs are listed.
        let listed = if suits(task) { crate::limits::LISTED_STATES } else { usize::MAX };
        let all_alive = vec![false; problem.observers().len()];
        Ok(Self { problem, operators, path, states, at: 0, beliefs, listed, budget, all_alive })
    }

    /// What an observer sees of the plan.
    fn symbols(&self, observer: &Observer) -> Vec<Symbol> {
        let task = self.problem.task();
        let read = |(&operator, after): (&OperatorId, &State)| {
            observer.sensor.read(task, operator, after.words())
        };
        self.path.iter().zip(&self.states[1..]).map(read).collect()
    }

    /// Leaves the beliefs of the observers out for whom witnesses show that every goal survives in the end.
    fn leave_out_all_alive(&mut self, witnesses: &[Witness]) {
        for (place, observer) in self.problem.observers().iter().enumerate() {
            let seen = self.symbols(observer);
            let mut alive = GoalSet::none(self.problem.goals().len());
            for witness in witnesses.iter().filter(|witness| witness.observer == place) {
                if witness.holds(self.problem, &seen) {
                    alive.insert(witness.goal);
                }
            }
            self.all_alive[place] = alive.len() == self.problem.goals().len();
        }
    }

    fn survivors(&self) -> Vec<GoalSet> {
        let goals = self.problem.goals();
        let of = |(belief, &all): (&TracedBelief, &bool)| {
            let mut set = GoalSet::none(goals.len());
            for (index, goal) in goals.iter().enumerate() {
                let task = self.problem.task();
                if all || belief.satisfies(task, &goal.condition) {
                    set.insert(index);
                }
            }
            set
        };
        self.beliefs.iter().zip(&self.all_alive).map(of).collect()
    }

    /// Whether the beliefs that are listed are more states than are kept.
    fn lists_too_many(&self) -> bool {
        let listed = |belief: &TracedBelief| belief.as_list().map_or(0, <[State]>::len);
        self.beliefs.iter().map(listed).sum::<usize>() > MAX_STATES
    }

    fn reaches_goal(&self) -> bool {
        let task = self.problem.task();
        self.states.last().is_some_and(|state| task.satisfies(state.words(), task.goal()))
    }

    /// Takes the next step and returns the symbols seen; none at the end.
    fn step(&mut self) -> Result<Option<Vec<Option<String>>>, PlanError> {
        let Some(&operator) = self.path.get(self.at) else { return Ok(None) };
        self.at += 1;
        let task = self.problem.task();
        let mut symbols = Vec::new();
        let observers = self.problem.observers().iter().zip(&self.all_alive);
        for ((observer, &all_alive), belief) in observers.zip(&mut self.beliefs) {
            let sensor = &observer.sensor;
            let seen = sensor.read(task, operator, self.states[self.at].words());
            if !all_alive {
                belief
                    .update(task, &self.operators, sensor, seen, self.listed, &mut self.budget)
                    .map_err(|_| PlanError::TooLarge { step: self.at })?;
            }
            symbols.push(Some(sensor.name(seen).to_owned()));
        }
        Ok(Some(symbols))
    }
}

/// What every observer sees of a plan that solves the problem.
///
/// # Errors
///
/// [`InvalidPlan`] when it does not.
#[cfg(test)]
pub(crate) fn symbols(problem: &Problem, plan: &Plan) -> Result<Vec<Vec<Symbol>>, InvalidPlan> {
    let replay = Replay::new(problem, plan)?;
    if !replay.reaches_goal() {
        return Err(InvalidPlan::MissesGoal);
    }
    Ok(problem.observers().iter().map(|observer| replay.symbols(observer)).collect())
}

/// Replays a plan and keeps every step.
///
/// Linear in the sum of all transitions out of all beliefs on the way.
///
/// # Errors
///
/// [`PlanError`] when a step cannot be carried out, or the beliefs of all steps together are too
/// many states to keep. A plan that ends elsewhere than in the true
/// goal is no error: see [`Trace::reaches_goal`].
///
/// ```
/// use mo_copp::{domain::Delivery, plan::Plan, trace::trace};
/// let problem = Delivery::figure_1().problem()?;
/// let plan = Plan::from_names(problem.task(), &["load a1", "load a2", "deliver"])?;
/// let trace = trace(&problem, &plan)?;
/// assert!(trace.reaches_goal);
/// assert_eq!(trace.goal_difference(&problem), 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn trace(problem: &Problem, plan: &Plan) -> Result<Trace, PlanError> {
    let mut steps = Vec::with_capacity(plan.len() + 1);
    let mut kept = 0;
    let reaches_goal = pass(problem, plan, |step| {
        for belief in step.beliefs {
            kept += match belief.count() {
                StateCount::Exact(count) => usize::try_from(count).unwrap_or(usize::MAX),
                StateCount::About(_) => usize::MAX,
            }
            .min(2 * MAX_STATES);
            if kept > MAX_STATES {
                return Err(PlanError::TooManyStates { step: steps.len(), limit: MAX_STATES });
            }
        }
        steps.push(TraceStep {
            action: step.action,
            state: step.state.clone(),
            symbols: step.symbols.to_vec(),
            beliefs: step.beliefs.iter().map(|belief| belief.some_states(MAX_STATES)).collect(),
            survivors: step.survivors.to_vec(),
        });
        Ok(())
    })?;
    Ok(Trace { steps, reaches_goal })
}

/// Replays a plan and hands each step to `visit`, the start first, keeping the present beliefs
/// alone. Returns whether the plan ends in the true goal.
///
/// Linear in the sum of all transitions out of all beliefs on the way, as [`trace`]; memory is that
/// of the largest beliefs.
///
/// # Errors
///
/// [`PlanError`] when a step cannot be carried out, the beliefs of one step are too many states, or
/// `visit` says so.
///
/// ```
/// use mo_copp::{domain::Delivery, plan::Plan, trace::pass};
/// let problem = Delivery::figure_1().problem()?;
/// let plan = Plan::from_names(problem.task(), &["load a1", "load a2", "deliver"])?;
/// let mut most = 0;
/// pass(&problem, &plan, |step| {
///     most = most.max(step.survivors[0].iter().count());
///     Ok(())
/// })?;
/// assert_eq!(most, 6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn pass(
    problem: &Problem,
    plan: &Plan,
    mut visit: impl FnMut(Passing<'_>) -> Result<(), PlanError>,
) -> Result<bool, PlanError> {
    let mut replay = Replay::new(problem, plan)?;
    let mut seen = Some(vec![None; problem.observers().len()]);
    while let Some(symbols) = seen {
        if replay.lists_too_many() {
            return Err(PlanError::TooManyStates { step: replay.at, limit: MAX_STATES });
        }
        visit(Passing {
            action: replay.at.checked_sub(1).map(|index| plan.actions[index]),
            state: &replay.states[replay.at],
            symbols: &symbols,
            beliefs: &replay.beliefs,
            survivors: &replay.survivors(),
        })?;
        seen = replay.step()?;
    }
    Ok(replay.reaches_goal())
}

impl Trace {
    /// The goal difference at the end.
    pub fn goal_difference(&self, problem: &Problem) -> f64 {
        let sets = self.steps.last().map(|step| step.survivors.as_slice()).unwrap_or_default();
        problem.goal_difference(problem.survivor_counts(sets))
    }
}
