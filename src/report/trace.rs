//! Replayed plans, step by step: `trace --json`.

use fixedbitset::FixedBitSet;
use serde::Serialize;

use super::belief::BeliefReport;
use super::by_observer::{ByObserver, goal_names, names_where};
use crate::goal_difference::GoalSet;
use crate::plan::{NextAction, Plan, PlanError};
use crate::problem::{Problem, StateLabel, StateNaming};
use crate::task::{Action, State, Task};
use crate::trace::{Passing, ReachableGoals, Trace, TraceStep, pass, trace};

/// A replayed plan: `trace --json`.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct TraceReport {
    /// Whether the plan ends in the true goal, within the cost limit where there is one.
    pub valid: bool,
    /// What the plan costs, where the problem has costs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cost: Option<u64>,
    /// The start and every step.
    pub steps: Vec<StepReport>,
    /// The goal difference at the end.
    pub goal_difference: f64,
}

/// What holds after a step.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct StepReport {
    /// The action; none at the start.
    pub action: Option<String>,
    /// The actor's state.
    pub state: StateLabel,
    /// The symbol each observer saw; none at the start.
    pub symbols: ByObserver<Option<String>>,
    /// What each observer believes.
    pub beliefs: ByObserver<Vec<StateLabel>>,
    /// What the beliefs have in common, where they are not given in full.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub summaries: Option<ByObserver<BeliefReport>>,
    /// The goals that survive for each observer.
    pub goals: ByObserver<Vec<String>>,
    /// In an overview, the goals that are ruled out for each observer: those that no continuation
    /// makes possible again (see [`ReachableGoals`]), and at the end of a plan for the true goal
    /// all that are not possible.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ruled_out: Option<ByObserver<Vec<String>>>,
    /// The goal difference, were the plan to end here.
    pub goal_difference: f64,
}

/// An action that can be taken after a plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct NextReport {
    /// The name of the action.
    pub action: String,
    /// The resulting state.
    pub state: StateLabel,
    /// Whether the true goal holds there.
    pub goal: bool,
}

/// The plan that was replayed.
fn trace_plan(trace: &Trace) -> Plan {
    Plan { actions: trace.steps.iter().filter_map(|step| step.action).collect() }
}

impl TraceReport {
    /// The report of a trace.
    pub fn new(problem: &Problem, trace: &Trace) -> Self {
        let step = |step: &TraceStep| {
            let labels = |belief: &Vec<State>| -> Vec<StateLabel> {
                belief.iter().map(|state| problem.label(state.words())).collect()
            };
            let beliefs = ByObserver::new(problem, |i| labels(&step.beliefs[i]));
            let TraceStep { action, state, symbols, survivors, .. } = step;
            StepReport::new(problem, *action, state, symbols, survivors, beliefs)
        };
        Self {
            valid: trace.reaches_goal,
            cost: trace_plan(trace).cost(problem.task()),
            steps: trace.steps.iter().map(step).collect(),
            goal_difference: trace.goal_difference(problem),
        }
    }

    /// The report of a plan for display: of each belief at most `most` states, and with them what all its states have in common
    /// and which goals are ruled out. A hundred thousand states for each step are too many for a page and for its reader. The
    /// beliefs of a gridworld and of a delivery are pictures of all their states, and given in full.
    ///
    /// Linear in the replay, and in the groups of facts and the goals' conditions of all states
    /// that are passed.
    ///
    /// # Errors
    ///
    /// [`PlanError`] when a step cannot be carried out or holds too many states.
    pub fn overview(problem: &Problem, plan: &Plan, most: usize) -> Result<Self, PlanError> {
        let mut reachable = ReachableGoals::new(problem);
        let mut ruled_out = |facts: &dyn Fn(usize) -> FixedBitSet| {
            Some(ByObserver::new(problem, |i| {
                let open = reachable.from_facts(facts(i));
                names_where(problem, |goal| !open.contains(goal))
            }))
        };
        if matches!(problem.naming(), StateNaming::Cells { .. } | StateNaming::Facts) {
            let trace = trace(problem, plan)?;
            let mut report = Self::new(problem, &trace);
            for (step, kept) in report.steps.iter_mut().zip(&trace.steps) {
                let facts = |i: usize| facts_of(problem.task(), &kept.beliefs[i]);
                step.ruled_out = ruled_out(&facts);
            }
            return Ok(report.ended(problem));
        }
        let mut steps = Vec::with_capacity(plan.len() + 1);
        let valid = pass(problem, plan, |step| {
            let summary = |i: usize| BeliefReport::of(problem, &step.beliefs[i]);
            let labels = |i: usize| -> Vec<StateLabel> {
                let states = step.beliefs[i].some_states(most);
                states.iter().map(|state| problem.label(state.words())).collect()
            };
            let Passing { action, state, symbols, survivors, .. } = step;
            let beliefs = ByObserver::new(problem, labels);
            steps.push(StepReport {
                summaries: Some(ByObserver::new(problem, summary)),
                ruled_out: ruled_out(&|i| step.beliefs[i].facts(problem.task())),
                ..StepReport::new(problem, action, state, symbols, survivors, beliefs)
            });
            Ok(())
        })?;
        let goal_difference = steps.last().map_or(0.0, |step: &StepReport| step.goal_difference);
        Ok(Self { valid, cost: plan.cost(problem.task()), steps, goal_difference }.ended(problem))
    }

    /// At the end of a plan for the true goal nothing more comes: what is not possible there is
    /// ruled out.
    fn ended(mut self, problem: &Problem) -> Self {
        if let Some(end) = self.steps.last_mut().filter(|_| self.valid) {
            let possible = &end.goals.0;
            let name = |goal: usize| &problem.goals()[goal].name;
            end.ruled_out = Some(ByObserver::new(problem, |i| {
                names_where(problem, |goal| !possible[i].1.contains(name(goal)))
            }));
        }
        self
    }
}

impl StepReport {
    /// The report of a step with these beliefs.
    fn new(
        problem: &Problem,
        action: Option<Action>,
        state: &State,
        symbols: &[Option<String>],
        survivors: &[GoalSet],
        beliefs: ByObserver<Vec<StateLabel>>,
    ) -> Self {
        Self {
            action: action.map(|action| problem.task().action_name(action).to_owned()),
            state: problem.label(state.words()),
            symbols: ByObserver::new(problem, |i| symbols[i].clone()),
            beliefs,
            summaries: None,
            goals: ByObserver::new(problem, |i| goal_names(problem, &survivors[i])),
            ruled_out: None,
            goal_difference: problem.goal_difference(problem.survivor_counts(survivors)),
        }
    }
}

/// The facts that hold in some of the states.
fn facts_of(task: &Task, states: &[State]) -> FixedBitSet {
    let mut facts = FixedBitSet::with_capacity(task.fact_count());
    for fact in states.iter().flat_map(|state| task.facts_of(state.words())) {
        facts.insert(fact.index());
    }
    facts
}

impl NextReport {
    /// The report of an action that can be taken.
    pub fn new(problem: &Problem, next: &NextAction) -> Self {
        Self {
            action: problem.task().action_name(next.action).to_owned(),
            state: problem.label(next.state.words()),
            goal: next.goal,
        }
    }
}
