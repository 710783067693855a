//! Exact search over the actor's state and the observers' beliefs.
//!
//! What a plan achieves depends on the node (state, beliefs) it ends in and on nothing else, so two
//! plans that meet in a node need not be told apart: going through all nodes is going through all
//! plans.
//!
//! - [`layers`] goes through them step by step, for plans of exactly T actions,
//! - [`closure`] goes through them breadth first until there are no new ones, for plans of all
//!   lengths,
//! - [`lengths`] goes through them step by step up to a longest plan, for the best of each length,
//!   on a [`graph`] of nodes that are met once.
//!
//! Nothing is looked at that cannot reach the true goal any more.
//!
//! All find every reachable pair of survivor counts, which is more than the Pareto set the paper
//! names and leaves out.

pub mod closure;
pub mod ends;
pub mod graph;
pub mod layers;
pub mod lengths;
mod pairs;
