//! What a question is about: a document with its problem, and what solvers say of it.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::Unfit;
use super::answer::{Answer, Form};
use super::belief_layers::{BeliefLayers, POSSIBLE};
use super::verdict::{Finding, Verdict};
use super::words;
use crate::domain::Document;
use crate::goal_difference;
use crate::limits::Limits;
use crate::plan::{Plan, execute};
use crate::problem::{Problem, Role};
use crate::solver::{Horizon, Options, Outcome, Solver, Status, shortest_plan_length, solve};
use crate::trace::pass;

/// What may be spent on an exercise: enough for problems that a person can survey.
const EXPANSIONS: u64 = 200_000;
/// The same for memory.
const BYTES: u64 = 64 << 20;

/// A document and its problem.
#[derive(Debug, Clone)]
pub(super) struct Subject {
    /// The document.
    pub(super) document: Document,
    /// The problem of the document.
    pub(super) problem: Arc<Problem>,
}

/// A plan with its goal difference.
#[derive(Debug, Clone)]
pub(super) struct Valued {
    /// The goal difference.
    pub(super) value: f64,
    /// The plan.
    pub(super) plan: Plan,
}

/// A walk to the true goal that was carried out.
#[derive(Debug, Clone)]
pub(super) struct Walked {
    /// The walk.
    pub(super) plan: Plan,
    /// The goal difference at its end.
    pub(super) goal_difference: f64,
    /// For each observer whether each goal survives at its end.
    survivors: Vec<Vec<bool>>,
}

impl Subject {
    /// The names of the goals.
    pub(super) fn goal_names(&self) -> impl Iterator<Item = &str> {
        self.problem.goals().iter().map(|goal| goal.name.as_str())
    }

    /// The name of the true goal.
    pub(super) fn true_goal(&self) -> &str {
        &self.problem.goals()[self.problem.true_goal()].name
    }

    /// A goal difference in words.
    pub(super) fn difference(&self, value: f64) -> String {
        goal_difference::written(value, self.problem.goals().len())
    }

    /// The names of the actions.
    pub(super) fn action_names(&self) -> impl Iterator<Item = &str> {
        let task = self.problem.task();
        (0..task.action_count()).map(|index| task.action_name(crate::task::Action::new(index)))
    }

    /// Whether a goal holds in a packed state.
    pub(super) fn in_goal(&self, goal: usize, words: &[u64]) -> bool {
        self.problem.task().satisfies(words, &self.problem.goals()[goal].condition)
    }

    /// Whether a walk ends in the true goal.
    pub(super) fn ends_in_goal(&self, names: &[String]) -> bool {
        let task = self.problem.task();
        let walked = Plan::from_names(task, names)
            .and_then(|plan| execute(task, &plan, |words| self.problem.label(words).to_string()));
        let end = walked.ok().and_then(|(_, states)| states.last().cloned());
        end.is_some_and(|state| task.satisfies(state.words(), task.goal()))
    }

    fn options() -> Options {
        let limits = Limits::default().with_expansions(EXPANSIONS).with_bytes(BYTES);
        Options::new(Solver::Exact).with_limits(limits)
    }

    fn solved(&self, options: Options) -> Result<Outcome, Unfit> {
        let outcome = solve(Arc::clone(&self.problem), options, |_| ControlFlow::Continue(()));
        let outcome = outcome.map_err(|error| Unfit::new(error.to_string()))?;
        match outcome.status {
            Status::Optimal if outcome.limit.is_none() => Ok(outcome),
            Status::Infeasible => Err(Unfit::new("no walk reaches the true goal".to_owned())),
            _ => Err(Unfit::too_large()),
        }
    }

    fn valued(outcome: Outcome) -> Result<Valued, Unfit> {
        match (outcome.goal_difference, outcome.plan) {
            (Some(value), Some(plan)) => Ok(Valued { value, plan }),
            _ => Err(Unfit::too_large()),
        }
    }

    /// The length of a shortest walk to the true goal.
    pub(super) fn shortest(&self) -> Result<usize, Unfit> {
        let found = shortest_plan_length(&self.problem, &Self::options());
        let found = found.map_err(|_| Unfit::too_large())?;
        found.ok_or_else(|| Unfit::new("no walk reaches the true goal".to_owned()))
    }

    /// The best walk of exactly this length.
    pub(super) fn best_of_length(&self, steps: usize) -> Result<Valued, Unfit> {
        Self::valued(self.solved(Self::options().with_horizon(Horizon::Steps(steps)))?)
    }

    /// How many nodes are expanded until the best walk is found, of this length or of any.
    pub(super) fn expansions(&self, steps: Option<usize>) -> u64 {
        let options = match steps {
            Some(steps) => Self::options().with_horizon(Horizon::Steps(steps)),
            None => Self::options(),
        };
        self.solved(options).map_or(EXPANSIONS, |outcome| 1 + outcome.stats.expansions)
    }

    /// A shortest walk of those with the best goal difference.
    pub(super) fn best(&self) -> Result<Valued, Unfit> {
        let outcome = self.solved(Self::options())?;
        if outcome.length_proved == Some(false) {
            return Err(Unfit::too_large());
        }
        Self::valued(outcome)
    }

    /// A shortest walk with a goal difference that will do, of at most so many steps.
    pub(super) fn shortest_with(
        &self,
        will_do: impl Fn(f64) -> bool,
        most: Option<usize>,
    ) -> Result<Option<Valued>, Unfit> {
        let longest = match most {
            Some(most) => most,
            None => {
                let best = self.best()?;
                if !will_do(best.value) {
                    return Ok(None);
                }
                best.plan.len()
            }
        };
        if longest < self.shortest()? {
            return Ok(None);
        }
        let outcome = self.solved(Self::options().with_lengths(longest))?;
        let best = outcome.lengths.unwrap_or_default().into_iter().filter_map(|point| point.best);
        let mut best = best.map(|pair| Valued {
            value: self.problem.goal_difference(pair.counts),
            plan: pair.plan,
        });
        Ok(best.find(|valued| will_do(valued.value)))
    }

    /// A plan as an answer.
    pub(super) fn answer(form: &Form, plan: &Plan) -> Result<Answer, Unfit> {
        let choices = plan.actions.iter().map(|action| action.index() as u32);
        form.answer(choices).ok_or_else(Unfit::too_large)
    }

    /// Carries an answer out that is a walk to the true goal; else the verdict that it is none.
    pub(super) fn walked(&self, answer: &Answer) -> Result<Walked, Verdict> {
        let task = self.problem.task();
        let action = |&choice: &u32| crate::task::Action::new(choice as usize);
        let plan = Plan { actions: answer.choices().iter().map(action).collect() };
        let (mut goal_difference, mut survivors) = (0.0, Vec::new());
        let passed = pass(&self.problem, &plan, |step| {
            let problem = &self.problem;
            goal_difference = problem.goal_difference(problem.survivor_counts(step.survivors));
            let goals = 0..problem.goals().len();
            let of = |set: &goal_difference::GoalSet| {
                goals.clone().map(|goal| set.contains(goal)).collect()
            };
            survivors = step.survivors.iter().map(of).collect();
            Ok(())
        });
        let reaches = passed.map_err(|error| {
            Verdict::wrong([Finding::plain(format!("The walk can't be carried out: {error}."))])
        })?;
        if !reaches {
            let label = |words: &[u64]| self.problem.label(words).to_string();
            let end =
                execute(task, &plan, label).ok().and_then(|(_, states)| states.last().cloned());
            let end =
                end.map_or_else(String::new, |state| self.problem.label(state.words()).to_string());
            let text = words::misses_goal(&self.document, &end, self.true_goal());
            return Err(Verdict::wrong([Finding::plain(text)]));
        }
        Ok(Walked { plan, goal_difference, survivors })
    }

    /// Why a walk has no greater goal difference: a goal that the enemy rules out, and one that the friend does not.
    pub(super) fn shortfall(&self, walked: &Walked) -> Vec<Finding> {
        let mut findings = Vec::new();
        for (number, observer) in self.problem.observers().iter().enumerate() {
            let wanted = observer.role == Role::Adversarial;
            let goal = (0..self.problem.goals().len()).find(|&goal| {
                goal != self.problem.true_goal() && walked.survivors[number][goal] != wanted
            });
            let Some(goal) = goal else { continue };
            if let Ok(mut layers) = BeliefLayers::new(&self.problem, number, &walked.plan) {
                let name = &self.problem.goals()[goal].name;
                findings.push(layers.finding(name, POSSIBLE, |words| self.in_goal(goal, words)));
            }
        }
        findings
    }
}
