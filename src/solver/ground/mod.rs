//! Shared ground of the engines: what is known of states and beliefs whatever is searched for.
//!
//! - [`transition_graphs`] are the domain transition graphs of the groups of exclusive facts,
//! - [`endings`] are the states from which a plan can end after exactly so many more actions,
//! - [`goal_distances`] estimates from them how far each candidate goal is, from states and beliefs.
//!
//! An engine uses this floor and no other engine.

pub(in crate::solver) mod endings;
pub(in crate::solver) mod goal_distances;
pub(in crate::solver) mod transition_graphs;
