//! Exact search over the actor's state and the observers' beliefs.
//!
//! What a plan achieves depends on the node (state, beliefs) it ends in and on nothing else, so two
//! plans that meet in a node need not be told apart: going through all nodes is going through all
//! plans.
//!
//! - [`layers`] goes through them step by step, for plans of exactly T actions,
//! - [`closure`] goes through them breadth first until there are no new ones, for plans of all
//!   lengths,
//!
//! Nothing is looked at that cannot reach the true goal any more.
//!
//! Both find every reachable pair of survivor counts, which is more than the Pareto set the paper
//! names and leaves out.

pub mod closure;
pub mod layers;
mod pairs;
