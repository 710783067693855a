//! PDDL documents: a domain and a problem in PDDL, candidate goals, and observers with sensors by
//! rule.
//!
//! - the symbol of an operator comes from the first rule that matches it: a pattern over its lifted
//!   name and arguments, perhaps a condition on the resulting state, and a template of the symbol,
//! - objects of a *group* look alike to an observer: its symbols show the group in their place,
//! - what an observer believes at first is a list of states, or all reachable states with a
//!   condition.

mod belief;
mod build;
mod cover;
pub mod generate;
pub mod import;
mod outline;
mod read;
mod sensor;
mod table;
mod template;
mod text;

use serde::{Serialize, Serializer};

pub use outline::{Outline, OutlineObject, OutlinePredicate};
pub use text::PddlText;

use super::Observers;

/// A `pddl` document.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub struct Pddl {
    /// The domain, in PDDL.
    pub domain: PddlText,
    /// The problem, in PDDL. Its `:goal` may be left out; one that is there must be the true goal.
    pub problem: PddlText,
    /// The candidate goals.
    pub goals: Vec<PddlGoal>,
    /// The name of the true one.
    pub true_goal: String,
    /// What the two observers believe and see.
    pub observers: Observers<PddlObserver>,
}

/// A candidate goal.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub struct PddlGoal {
    /// Its name.
    pub name: String,
    /// A conjunction of ground literals in PDDL.
    pub condition: String,
}

/// An observer of a PDDL task.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub struct PddlObserver {
    /// The states the actor could be in at first; the initial state alone when left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub initial_belief: Option<PddlBelief>,
    /// Objects that look alike, by the name under which the observer sees them.
    #[serde(skip_serializing_if = "Vec::is_empty", serialize_with = "as_object")]
    #[cfg_attr(
        not(target_arch = "wasm32"),
        schemars(default, with = "std::collections::BTreeMap<String, Vec<String>>")
    )]
    pub groups: Vec<(String, Vec<String>)>,
    /// What the observer sees of each operator.
    pub sensor: PddlSensor,
}

/// What an observer believes before the first step.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub enum PddlBelief {
    /// All states that can be reached from the initial one and satisfy a condition.
    Reachable(String),
    /// These states, the initial one among them.
    #[serde(untagged)]
    States(Vec<PddlState>),
}

/// A believed state.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(untagged)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub enum PddlState {
    /// All atoms that hold; those that no action changes may be left out.
    Atoms(Vec<String>),
    /// The initial state, changed.
    Change {
        /// Atoms that hold as well.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        #[cfg_attr(not(target_arch = "wasm32"), schemars(default))]
        add: Vec<String>,
        /// Atoms that do not hold.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        #[cfg_attr(not(target_arch = "wasm32"), schemars(default))]
        delete: Vec<String>,
    },
}

/// How an observer sees operators.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(untagged)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub enum PddlSensor {
    /// One template for all operators.
    Template(String),
    /// The first rule that matches.
    Rules(Vec<PddlRule>),
    /// A symbol for each operator that is listed.
    Table {
        /// Ground operators with their symbols.
        table: Vec<(String, String)>,
        /// What is seen of all others; every operator must be in the table when it is left out.
        #[serde(skip_serializing_if = "Option::is_none")]
        otherwise: Option<Box<PddlSensor>>,
    },
}

/// A rule of a sensor.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub struct PddlRule {
    /// Which operators: `*`, a lifted name, or `(name ARGUMENT…)`.
    pub operator: String,
    /// What must hold in the resulting state.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub result: Option<String>,
    /// The template of the symbol.
    pub symbol: String,
}

impl PddlSensor {
    /// The enemy of the paper: lifted names only.
    pub fn names() -> Self {
        Self::Template("{name}".to_owned())
    }

    /// The friend of the paper: lifted names with the group of the object that acts or is moved,
    /// which is the first argument.
    pub fn names_with_groups() -> Self {
        Self::Template("{name} {1}".to_owned())
    }
}

fn as_object<S: Serializer>(
    groups: &[(String, Vec<String>)],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_map(groups.iter().map(|(name, objects)| (name, objects)))
}
