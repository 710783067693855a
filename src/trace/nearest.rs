//! How far a candidate goal is from what an observer believes: the believed state from which the fewest actions lead there.

use std::collections::VecDeque;

use rustc_hash::FxHashSet;

use super::{MAX_STATES, OperatorsByFact, trace};
use crate::plan::{Plan, PlanError};
use crate::problem::Problem;
use crate::task::State;

/// A believed state, and how many actions lead from it to the goal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Nearest {
    /// The state: of several that are as near, the first in the order of packed states.
    pub state: State,
    /// How many actions; 0 where the goal holds there.
    pub actions: usize,
}

/// The believed state that is nearest to a goal after a step of a plan; none where no actions lead there from any of
/// them. `observer` and `goal` are positions in the problem.
///
/// Breadth first from all believed states at once: linear in the states that are nearer than the goal, and in the
/// transitions out of them.
///
/// # Errors
///
/// [`PlanError`] when a step cannot be carried out, or more states are met than are kept.
///
/// ```
/// use mo_copp::{domain::Delivery, plan::Plan, trace::nearest};
/// let problem = Delivery::figure_1().problem()?;
/// let plan = Plan::from_names(problem.task(), &["load a1"])?;
/// let friend = problem.observer_named("cooperative").unwrap_or_default();
/// let goal = problem.goal_named("a1+b1").unwrap_or_default();
/// // The other package and the delivery.
/// let nearest = nearest(&problem, &plan, friend, goal, 1)?;
/// assert_eq!(nearest.map(|nearest| nearest.actions), Some(2));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn nearest(
    problem: &Problem,
    plan: &Plan,
    observer: usize,
    goal: usize,
    step: usize,
) -> Result<Option<Nearest>, PlanError> {
    let task = problem.task();
    let condition = &problem.goals()[goal].condition;
    let mut traced = trace(problem, plan)?;
    let step = step.min(traced.steps.len() - 1);
    let belief = std::mem::take(&mut traced.steps[step].beliefs[observer]);
    let operators = OperatorsByFact::new(task);
    let mut met: FxHashSet<Box<[u64]>> = FxHashSet::default();
    let mut open: VecDeque<(State, usize, usize)> = VecDeque::new();
    for (origin, state) in belief.iter().enumerate() {
        if met.insert(state.words().into()) {
            open.push_back((state.clone(), origin, 0));
        }
    }
    while let Some((state, origin, actions)) = open.pop_front() {
        if task.satisfies(state.words(), condition) {
            return Ok(Some(Nearest { state: belief[origin].clone(), actions }));
        }
        operators.successors(task, &state, |_, target| {
            if !met.contains(target) {
                met.insert(target.into());
                open.push_back((State::from_words(target.to_vec()), origin, actions + 1));
            }
        });
        if met.len() > MAX_STATES {
            return Err(PlanError::TooManyStates { step, limit: MAX_STATES });
        }
    }
    Ok(None)
}
