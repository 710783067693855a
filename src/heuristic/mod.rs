//! Heuristics: estimates of how far a goal is.
//!
//! - [`SetAdditive`] is the set-additive heuristic of a state,
//! - `goal_values` remembers it for every candidate goal and every state asked about;
//!   what a belief is worth follows from its states in the solvers.

mod goal_values;
mod set_additive;
mod supporter_sets;

pub(crate) use goal_values::GoalValues;
pub use set_additive::SetAdditive;

/// The value of a goal that cannot be reached even when deletes are ignored.
pub const UNREACHABLE: u32 = u32::MAX;
