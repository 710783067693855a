//! Shared ground of the engines: what is known of states and beliefs whatever is searched for.
//!
//! - [`transition_graphs`] are the domain transition graphs of the groups of exclusive facts,
//! - [`endings`] are the states from which a plan can end after exactly so many more actions,
//! - [`dead_ends`] are the states from which the true goal cannot be reached,
//! - [`projections`] say how many steps the way to the true goal has at least,
//! - [`goal_costs`] are the least costs from states to the true goal,
//! - [`stages`] are what the way to a node has used up of a horizon and of a cost limit,
//! - [`shortest_length`] is the length of a shortest plan for the true goal,
//! - [`search_tree`] and [`graph`] are the nodes met, with the transitions between them,
//! - [`final_beliefs`] says whether a plan may end with what is believed,
//! - [`completion`] goes on greedily from where a search is stopped,
//! - [`best_first`] is the loop of the greedy searches,
//! - [`goal_distances`] estimates from them how far each candidate goal is, from states and beliefs,
//! - [`thresholds`] are the numbers that decide what is tried when, of all engines in one place.
//!
//! An engine uses this floor and no other engine.

pub(in crate::solver) mod best_first;
pub(in crate::solver) mod completion;
pub(in crate::solver) mod dead_ends;
pub(in crate::solver) mod endings;
pub(in crate::solver) mod final_beliefs;
pub(in crate::solver) mod goal_costs;
pub(in crate::solver) mod goal_distances;
pub(in crate::solver) mod graph;
pub(in crate::solver) mod projections;
pub(in crate::solver) mod search_tree;
pub(in crate::solver) mod shortest_length;
pub(in crate::solver) mod stages;
pub(in crate::solver) mod thresholds;
pub(in crate::solver) mod transition_graphs;
