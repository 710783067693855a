//! PDDL: a reader and a grounder for STRIPS, ADL and action costs.
//!
//! PDDL ("The planning domain definition language", AIPS-98 Planning Competition Committee, 1998) is how classical
//! planning tasks are written. Read are `:strips`, `:typing` with `either`, `:equality`, `:adl` and
//! `:action-costs`; anything else is refused by its name. Names are in small letters.
//!
//! - [`read_domain`] and [`read_task`] read the two files of a task, [`read_condition`] and
//!   [`read_state`] further conditions and states over its objects, `Pattern` patterns over its
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
mod reachable;
mod rule;
mod schema;
mod split;
mod types;
mod unchanging;

pub use atom::Atom;
pub use condition::Condition;
pub use definition::{TaskDefinition, read_condition, read_state, read_task};
pub use domain::{Domain, read_domain};
pub use error::PddlError;
pub use expression::MAX_DEPTH;
pub use ground::{ExtraInputs, GroundError, Grounded, ground};

pub(crate) use definition::{read_atoms, read_literals, read_open_task};
pub(crate) use formula::Formula;
pub(crate) use object::ObjectId;
pub(crate) use pattern::{Group, Pattern};
pub(crate) use reachable::Reachable;
pub(crate) use schema::Schema;
pub(crate) use types::TypeId;
pub(crate) use unchanging::unchanging;
