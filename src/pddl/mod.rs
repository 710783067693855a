//! PDDL: a reader and a grounder for STRIPS, ADL and action costs.
//!
//! PDDL ("The planning domain definition language", AIPS-98 Planning Competition Committee, 1998) is how classical
//! planning tasks are written. Read are `:strips`, `:typing` with `either`, `:equality`, `:adl` and
//! `:action-costs`; anything else is refused by its name. Names are in small letters.
//!
//! - [`read_domain`] and [`read_task`] read the two files of a task, [`read_condition`] and
//!   [`read_state`] further conditions and states over its objects, [`Pattern`] patterns over its
//!   operators,
//! - [`ground`](ground()) makes a [`Task`](crate::task::Task) of them that holds what can be reached.
//!
//! Reading goes text → expressions with places (`expression`) → domain, task; every error names line
//! and column. Grounding goes schemas → rules (`rule`) → reachable atoms and instances (`reach`,
//! `join`) → operators (`operators`; with ADL drafts of operators, `draft`, which `split` makes operators of) → facts
//! and the task (`ground`).

mod atom;
mod atom_table;
mod condition;
mod cost;
mod definition;
mod derived;
mod domain;
mod draft;
mod effect;
mod error;
mod exclusive;
mod expression;
mod feature;
mod fit;
mod formula;
mod ground;
mod ground_formula;
mod invariant;
mod join;
mod literals;
mod object;
mod operators;
mod pattern;
mod predicate;
mod reach;
mod rule;
mod schema;
mod split;
mod types;
mod unchanging;

pub use atom::{Atom, LiftedAtom, Term};
pub use condition::{Condition, MAX_CONDITION};
pub use cost::{CostTerm, FunctionValues, Functions, MAX_COST};
pub use definition::{
    TaskDefinition, read_atoms, read_condition, read_literals, read_open_task, read_state,
    read_task,
};
pub use domain::{Domain, read_domain};
pub use effect::ConditionalEffect;
pub use error::PddlError;
pub use expression::MAX_DEPTH;
pub use formula::{Bound, Formula};
pub use ground::{
    ExtraInputs, GroundError, Grounded, MAX_ATOMS, MAX_LITERALS_IN_ALL, MAX_OPERATORS,
    MAX_STATE_BYTES, ground,
};
pub use ground_formula::GroundFormula;
pub use join::MAX_JOIN_STEPS;
pub use literals::{Literals, MAX_LITERALS};
pub use object::{ObjectId, Objects};
pub use pattern::{Group, Pattern};
pub use predicate::{PredicateId, Predicates};
pub use schema::{MAX_PARAMETERS, Parameters, Schema};
pub use types::{MAX_ALTERNATIVES, MAX_TYPES, TypeId, TypeSet, Types};
pub use unchanging::unchanging;
