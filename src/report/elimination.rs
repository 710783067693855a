//! Why a goal is not possible for an observer, as other programs read it.

use serde::Serialize;

use crate::problem::{Problem, StateLabel};
use crate::trace::{Elimination, Missed, Nearest};

/// The last states that would have led to a goal, and the symbol that ended them.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EliminationReport {
    /// The step at whose symbol they went.
    pub step: usize,
    /// The symbol.
    pub symbol: String,
    /// Believed states from which one action would have led to the goal, with another symbol.
    pub led: Vec<MissedReport>,
    /// How many such states there are.
    pub led_count: usize,
    /// Believed states in which the goal held.
    pub held: Vec<StateLabel>,
    /// How many such states there are.
    pub held_count: usize,
}

/// A step that would have led to the goal.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MissedReport {
    /// Where it would have begun.
    pub state: StateLabel,
    /// The action.
    pub action: String,
    /// The state it would have led to.
    pub result: StateLabel,
    /// The symbol the observer would have seen.
    pub symbol: String,
}

impl EliminationReport {
    /// The report of an elimination.
    pub fn new(problem: &Problem, elimination: &Elimination) -> Self {
        let missed = |missed: &Missed| MissedReport {
            state: problem.label(missed.state.words()),
            action: problem.task().action_name(missed.action).to_owned(),
            result: problem.label(missed.result.words()),
            symbol: missed.symbol.clone(),
        };
        Self {
            step: elimination.step,
            symbol: elimination.symbol.clone(),
            led: elimination.led.iter().map(missed).collect(),
            led_count: elimination.led_count,
            held: elimination.held.iter().map(|state| problem.label(state.words())).collect(),
            held_count: elimination.held_count,
        }
    }
}

/// How far a goal is from what an observer believes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct NearestReport {
    /// The believed state that is nearest; none where no actions lead to the goal from any of them.
    pub state: Option<StateLabel>,
    /// How many actions lead from it to the goal.
    pub actions: Option<usize>,
}

impl NearestReport {
    /// The report of the nearest state, where there is one.
    pub fn new(problem: &Problem, nearest: Option<&Nearest>) -> Self {
        Self {
            state: nearest.map(|nearest| problem.label(nearest.state.words())),
            actions: nearest.map(|nearest| nearest.actions),
        }
    }
}
