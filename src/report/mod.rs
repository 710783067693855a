//! What other programs read: the JSON of the command line and the objects of the JavaScript API.

mod advice;
mod belief;
mod classical;
mod elimination;
#[cfg(feature = "full")]
mod exercise;
#[cfg(feature = "full")]
mod import;
mod request;
mod scene;

use fixedbitset::FixedBitSet;
use serde::Serialize;

pub use advice::{AdviceReport, RemedyReport};
pub use belief::{BeliefReport, Feature, Share};
pub use classical::{PlanReport, PlanStats};
pub use elimination::{EliminationReport, MissedReport, NearestReport};
#[cfg(feature = "full")]
pub use exercise::{ExerciseReport, FindingReport, SampleReport, SolutionReport, VerdictReport};
#[cfg(feature = "full")]
pub use import::{ImportReport, read_import_files, read_import_options};
pub use request::{Request, read_request};
pub use scene::{Scene, SceneGoal, SceneObserver, Setting};

use crate::goal_difference::GoalSet;
use crate::plan::{NextAction, Plan, PlanError};
use crate::problem::{Problem, StateLabel, StateNaming};
use crate::solver::{LengthPoint, Outcome, Progress, Solver, Stats, Status};
use crate::task::{Action, State, Task};
use crate::trace::{Passing, ReachableGoals, Trace, TraceStep, pass, trace};

/// A map from the name of each observer to something, in the problem's order.
#[derive(Debug, Clone, PartialEq)]
pub struct ByObserver<T>(Vec<(String, T)>);

impl<T> ByObserver<T> {
    fn new(problem: &Problem, of: impl FnMut(usize) -> T) -> Self {
        let names = problem.observers().iter().map(|observer| observer.name.clone());
        Self(names.zip((0..).map(of)).collect())
    }

    /// What belongs to the observer at this place in the problem.
    pub fn get(&self, observer: usize) -> Option<&T> {
        self.0.get(observer).map(|(_, value)| value)
    }
}

impl<T: Serialize> Serialize for ByObserver<T> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

/// What a solver answers: `solve --json`.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct SolveReport {
    /// `optimal`, `solved`, `feasible`, `infeasible` or `limit`.
    pub status: &'static str,
    /// The solver.
    pub solver: &'static str,
    /// The integer program used.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub encoding: Option<&'static str>,
    /// The number of actions.
    pub horizon: Option<usize>,
    /// The names of the actions.
    pub plan: Option<Vec<String>>,
    /// What the plan costs, where the problem has costs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cost: Option<u64>,
    /// The most that a plan may cost, where that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cost_limit: Option<u64>,
    /// The goals that survive for each observer.
    pub goals: Option<ByObserver<Vec<String>>>,
    /// For each observer the goals of which it is not known whether they survive, where there are any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unsettled: Option<ByObserver<Vec<String>>>,
    /// The goal difference, from −1 to 1; at least this where goals are unsettled.
    pub goal_difference: Option<f64>,
    /// A proved upper bound on the goal difference; not there where none is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bound: Option<f64>,
    /// The bound less the goal difference: 0 where the plan is proved best.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gap: Option<f64>,
    /// Whether the plan is proved to be a shortest one of its goal difference, where that was looked
    /// at.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub length_proved: Option<bool>,
    /// Every reachable pair of survivor counts, sorted, where that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pairs: Option<Vec<PairReport>>,
    /// False where a limit came before all pairs were found; not there otherwise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pairs_complete: Option<bool>,
    /// The Pareto front of the pairs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub front: Option<Vec<FrontReport>>,
    /// The pairs, where they were asked for by their old name.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pareto: Option<Vec<PairReport>>,
    /// The same of these.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pareto_complete: Option<bool>,
    /// The best plan of each length from 0, where that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lengths: Option<Vec<LengthReport>>,
    /// The limit that was met.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit: Option<String>,
    /// Why there is no plan and what would do, where somebody looked for that.
    #[cfg(feature = "full")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub remedy: Option<AdviceReport>,
    /// What the work took.
    pub stats: StatsReport,
}

/// A reachable pair of survivor counts with a plan for it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PairReport {
    /// Goals that survive for the enemy.
    pub adversarial: usize,
    /// Goals that survive for the friend.
    pub cooperative: usize,
    /// The names of the actions.
    pub plan: Vec<String>,
}

/// A pair of survivor counts on the Pareto front: no other pair is at least as good for both sides.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct FrontReport {
    /// Goals that survive for the enemy.
    pub adversarial: usize,
    /// Goals that survive for the friend.
    pub cooperative: usize,
}

/// The best plan of exactly this many actions; null where no plan of this length keeps the bounds.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct LengthReport {
    /// The number of actions.
    pub length: usize,
    /// Goals that survive for the enemy.
    pub adversarial: Option<usize>,
    /// Goals that survive for the friend.
    pub cooperative: Option<usize>,
    /// The goal difference.
    pub goal_difference: Option<f64>,
    /// The names of the actions.
    pub plan: Option<Vec<String>>,
}

/// What the work took; only what the solver counts is there.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct StatsReport {
    /// Nodes expanded by a search.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub expansions: Option<u64>,
    /// Nodes generated by a search.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub generated: Option<u64>,
    /// States met.
    pub states: u64,
    /// Beliefs met.
    pub beliefs: u64,
    /// Branch-and-bound nodes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub nodes: Option<u64>,
    /// Simplex iterations.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub iterations: Option<u64>,
    /// Variables of the integer program.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub variables: Option<u64>,
    /// Rows of the integer program.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rows: Option<u64>,
    /// The size of approximate beliefs (Δ) at the end of a search.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub belief_size: Option<u64>,
    /// Walks beside plans that were looked for to show that a goal survives for an enemy.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub walks: Option<u64>,
    /// Walks found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub walks_found: Option<u64>,
    /// How often a friend's bounds were settled by pairs of values alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub settled_by_pairs: Option<u64>,
    /// How often a friend's belief had to be worked out for its bounds.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub settled_by_beliefs: Option<u64>,
    /// Wall-clock seconds, where somebody measured them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seconds: Option<f64>,
}

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

/// How far a solver is.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ProgressReport {
    /// The solver.
    pub solver: &'static str,
    /// `expansions` or `nodes`.
    pub unit: &'static str,
    /// How many of them.
    pub done: u64,
    /// The horizon being worked on.
    pub horizon: Option<usize>,
    /// The goal difference of the best plan found.
    pub goal_difference: Option<f64>,
    /// A proved upper bound on it.
    pub bound: Option<f64>,
    /// The distance between the two.
    pub gap: Option<f64>,
    /// The best plan found.
    pub plan: Option<Vec<String>>,
}

fn goal_names(problem: &Problem, set: &GoalSet) -> Vec<String> {
    set.iter().map(|goal| problem.goals()[goal].name.clone()).collect()
}

fn names_where(problem: &Problem, wanted: impl Fn(usize) -> bool) -> Vec<String> {
    let goals = problem.goals().iter().enumerate();
    goals.filter(|&(goal, _)| wanted(goal)).map(|(_, goal)| goal.name.clone()).collect()
}

impl SolveReport {
    /// The report of a solver that was stopped before there was a problem to work on.
    pub fn unread(solver: Solver, limit: impl Into<String>) -> Self {
        Self {
            status: Status::Limit.name(),
            solver: solver.name(),
            encoding: None,
            horizon: None,
            plan: None,
            cost: None,
            cost_limit: None,
            goals: None,
            unsettled: None,
            goal_difference: None,
            bound: None,
            gap: None,
            length_proved: None,
            pairs: None,
            pairs_complete: None,
            front: None,
            pareto: None,
            pareto_complete: None,
            lengths: None,
            limit: Some(limit.into()),
            #[cfg(feature = "full")]
            remedy: None,
            stats: StatsReport::new(solver, &Stats::default()),
        }
    }

    /// The report of an outcome.
    pub fn new(problem: &Problem, outcome: &Outcome) -> Self {
        let task = problem.task();
        let pairs = outcome.pairs.as_ref().map(|points| {
            let point = |point: &crate::solver::ReachablePair| PairReport {
                adversarial: point.counts.adversarial,
                cooperative: point.counts.cooperative,
                plan: point.plan.names(task),
            };
            points.iter().map(point).collect()
        });
        Self {
            status: outcome.status.name(),
            solver: outcome.solver.name(),
            encoding: outcome.encoding.map(crate::solver::Encoding::name),
            horizon: outcome.horizon,
            plan: outcome.plan.as_ref().map(|plan| plan.names(task)),
            cost: outcome.plan.as_ref().and_then(|plan| plan.cost(task)),
            cost_limit: outcome.cost_limit,
            goals: outcome
                .survivors
                .as_ref()
                .map(|sets| ByObserver::new(problem, |i| goal_names(problem, &sets[i]))),
            unsettled: outcome
                .unsettled
                .as_ref()
                .map(|sets| ByObserver::new(problem, |i| goal_names(problem, &sets[i]))),
            goal_difference: outcome.goal_difference,
            bound: outcome.bound,
            gap: outcome.gap(),
            length_proved: outcome.length_proved,
            pairs_complete: (pairs.is_some() && outcome.limit.is_some()).then_some(false),
            pairs,
            front: outcome.front().map(|pairs| {
                let point = |pair: &&crate::solver::ReachablePair| FrontReport {
                    adversarial: pair.counts.adversarial,
                    cooperative: pair.counts.cooperative,
                };
                pairs.iter().map(point).collect()
            }),
            pareto: None,
            pareto_complete: None,
            lengths: outcome.lengths.as_ref().map(|points| {
                points.iter().map(|point| LengthReport::new(problem, point)).collect()
            }),
            limit: outcome.limit.map(|limit| limit.to_string()),
            #[cfg(feature = "full")]
            remedy: None,
            stats: StatsReport::new(outcome.solver, &outcome.stats),
        }
    }
}

impl SolveReport {
    /// The same with the pairs under the name that they had first, `pareto`, and without the front.
    #[must_use]
    pub fn with_old_names(self) -> Self {
        let (pareto, pareto_complete) = (self.pairs, self.pairs_complete);
        Self { pairs: None, pairs_complete: None, front: None, pareto, pareto_complete, ..self }
    }
}

impl LengthReport {
    fn new(problem: &Problem, point: &LengthPoint) -> Self {
        let best = point.best.as_ref();
        Self {
            length: point.length,
            adversarial: best.map(|best| best.counts.adversarial),
            cooperative: best.map(|best| best.counts.cooperative),
            goal_difference: best.map(|best| problem.goal_difference(best.counts)),
            plan: best.map(|best| best.plan.names(problem.task())),
        }
    }
}

impl StatsReport {
    fn new(solver: Solver, stats: &Stats) -> Self {
        let program = solver == Solver::Ip;
        let search = matches!(
            solver,
            Solver::Search | Solver::Satisficing | Solver::Obfuscate | Solver::Legible
        );
        let shown = |count: u64| (count > 0).then_some(count);
        Self {
            expansions: (!program).then_some(stats.expansions),
            generated: (!program).then_some(stats.generated),
            states: stats.states,
            beliefs: stats.beliefs,
            nodes: program.then_some(stats.nodes),
            iterations: program.then_some(stats.iterations),
            variables: program.then_some(stats.variables),
            rows: program.then_some(stats.rows),
            belief_size: search.then_some(stats.belief_size),
            walks: shown(stats.walks),
            walks_found: shown(stats.walks).map(|_| stats.walks_found),
            settled_by_pairs: shown(stats.settled_by_pairs),
            settled_by_beliefs: shown(stats.settled_by_beliefs),
            seconds: None,
        }
    }
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

    /// The report of a plan for somebody who looks at it: of each belief at most `most` states, and
    /// with them what all its states have in common and which goals are ruled out. A page would not hold a hundred thousand
    /// states for each step, nor could anybody read them. The beliefs of a gridworld and of a
    /// delivery are pictures of all their states, and given in full.
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

impl ProgressReport {
    /// The report of a solver at work.
    pub fn new(problem: &Problem, progress: &Progress) -> Self {
        let program = progress.solver == Solver::Ip;
        Self {
            solver: progress.solver.name(),
            unit: if program { "nodes" } else { "expansions" },
            done: progress.done,
            horizon: progress.horizon,
            goal_difference: progress.goal_difference,
            bound: progress.bound,
            gap: progress.gap(),
            plan: progress.plan.as_ref().map(|plan| plan.names(problem.task())),
        }
    }
}
