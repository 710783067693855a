//! Explicit problems: states and transitions one by one, for other programs to write.
//!
//! Each action has at most one successor in a state. A goal is a set of states. Each sensor names
//! the symbol of every (action, resulting state) that occurs.

mod build;
mod read;

use serde::Serialize;

use super::Observers;

/// An `explicit` document.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub struct Explicit {
    /// The names of the states.
    pub states: Vec<String>,
    /// The names of the actions.
    pub actions: Vec<String>,
    /// State, action, resulting state.
    pub transitions: Vec<[String; 3]>,
    /// The state the actor starts in.
    pub initial_state: String,
    /// The candidate goals.
    pub goals: Vec<ExplicitGoal>,
    /// The name of the true one.
    pub true_goal: String,
    /// What the two observers believe and see.
    pub observers: Observers<ExplicitObserver>,
}

/// A candidate goal: to be in one of these states.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub struct ExplicitGoal {
    /// Its name.
    pub name: String,
    /// The states that satisfy it; none is allowed and means that it never survives.
    pub states: Vec<String>,
}

/// An observer of an explicit problem.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub struct ExplicitObserver {
    /// States the actor could be in at first; the initial state alone when left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub initial_belief: Option<Vec<String>>,
    /// Action, resulting state, symbol.
    pub sensor: Vec<[String; 3]>,
}
