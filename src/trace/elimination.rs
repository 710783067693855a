//! Why a candidate goal is not possible for an observer: the last states that would have led to it,
//! and the symbol that ended them.

use rustc_hash::FxHashSet;

use super::{MAX_STATES, OperatorsByFact};
use crate::plan::{Plan, PlanError, execute};
use crate::problem::Problem;
use crate::task::{Action, OperatorId, State};

/// The most states that an elimination lists.
pub const MAX_LISTED: usize = 100;

/// What an observer saw at a step, and what it rules out by that: one goal, seen from the states
/// that were believed before.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Elimination {
    /// The step at whose symbol the states went.
    pub step: usize,
    /// The symbol that the observer saw there.
    pub symbol: String,
    /// Of the states believed before: those from which an action leads to the goal, each with the
    /// first such action. All of them give another symbol. At most [`MAX_LISTED`], in order of the
    /// packed states.
    pub led: Vec<Missed>,
    /// How many such states there are.
    pub led_count: usize,
    /// Of the states believed before: those in which the goal held. No action with the symbol seen
    /// leads from any believed state to one like them. At most [`MAX_LISTED`], in order.
    pub held: Vec<State>,
    /// How many such states there are.
    pub held_count: usize,
}

/// A step that would have led to the goal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Missed {
    /// Where it would have begun.
    pub state: State,
    /// The action.
    pub action: Action,
    /// The state it would have led to.
    pub result: State,
    /// The symbol the observer would have seen.
    pub symbol: String,
}

/// The last step up to `step` at which an observer believed a state that is in the goal or one
/// action away from it, and saw a symbol after which the goal is not possible. None where the goal
/// is possible after `step`, and where no believed state was ever so near. `observer` and `goal` are
/// positions in the problem.
///
/// Linear in the sum of all transitions out of the observer's beliefs on the way.
///
/// # Errors
///
/// [`PlanError`] when a step cannot be carried out, or a belief is too many states.
///
/// ```
/// use mo_copp::{domain::Delivery, plan::Plan, trace::elimination};
/// let problem = Delivery::figure_1().problem()?;
/// let plan = Plan::from_names(problem.task(), &["load a1", "load a2", "deliver"])?;
/// let friend = problem.observer_named("cooperative").unwrap_or_default();
/// let goal = problem.goal_named("b1+b2").unwrap_or_default();
/// let ended = elimination(&problem, &plan, friend, goal, 3)?;
/// // After two packages from A no believed state is one delivery away from two of B.
/// assert!(ended.is_none());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn elimination(
    problem: &Problem,
    plan: &Plan,
    observer: usize,
    goal: usize,
    step: usize,
) -> Result<Option<Elimination>, PlanError> {
    let task = problem.task();
    let label = |words: &[u64]| problem.label(words).to_string();
    let (path, states) = execute(task, plan, label)?;
    let operators = OperatorsByFact::new(task);
    let condition = &problem.goals()[goal].condition;
    let observer = &problem.observers()[observer];
    let sensor = &observer.sensor;
    let holds = |words: &[u64]| task.satisfies(words, condition);
    let Some(believed) = observer.initial_belief.listed() else {
        return Err(PlanError::TooManyStates { step: 0, limit: MAX_STATES });
    };
    let mut belief = believed.to_vec();
    belief.sort_unstable();
    belief.dedup();
    let mut last = None;
    for (index, &operator) in path.iter().enumerate().take(step) {
        let seen = sensor.read(task, operator, states[index + 1].words());
        let mut next: FxHashSet<Box<[u64]>> = FxHashSet::default();
        let (mut led, mut led_count) = (Vec::new(), 0);
        for state in &belief {
            let mut first: Option<(OperatorId, Box<[u64]>)> = None;
            operators.successors(task, state, |id, target| {
                let symbol = sensor.read(task, id, target);
                if symbol == seen && !next.contains(target) {
                    next.insert(target.into());
                }
                if symbol != seen
                    && first.as_ref().is_none_or(|&(known, _)| id < known)
                    && holds(target)
                {
                    first = Some((id, target.into()));
                }
            });
            let Some((id, result)) = first else { continue };
            led_count += 1;
            if led.len() < MAX_LISTED {
                let symbol = sensor.name(sensor.read(task, id, &result)).to_owned();
                let (action, result) = (task.operator(id).action, State::from_words(result.into()));
                led.push(Missed { state: state.clone(), action, result, symbol });
            }
        }
        if next.len() > MAX_STATES {
            return Err(PlanError::TooManyStates { step: index + 1, limit: MAX_STATES });
        }
        if next.iter().any(|words| holds(words)) {
            last = None;
        } else {
            let held: Vec<&State> = belief.iter().filter(|state| holds(state.words())).collect();
            if led_count + held.len() > 0 {
                last = Some(Elimination {
                    step: index + 1,
                    symbol: sensor.name(seen).to_owned(),
                    led,
                    led_count,
                    held_count: held.len(),
                    held: held.into_iter().take(MAX_LISTED).cloned().collect(),
                });
            }
        }
        belief = next.into_iter().map(|words| State::from_words(words.into_vec())).collect();
        belief.sort_unstable();
    }
    Ok(last)
}
