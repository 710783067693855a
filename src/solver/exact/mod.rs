//! Exact search over the actor's state and the observers' beliefs.
//!
//! What a plan achieves depends on the node (state, beliefs) it ends in and on nothing else, so two
//! plans that meet in a node need not be told apart: going through all nodes is going through all
//! plans.
//!
//! - [`prospects`] look for the best plan of any length where that takes long: beliefs are told apart
//!   only by what can still become of them,
//! - [`layers`] goes through them step by step, for plans of exactly T actions,
//! - [`closure`] goes through them breadth first until there are no new ones, for plans of all
//!   lengths,
//! - [`lengths`] goes through them step by step up to a longest plan, for the best of each length,
//!   on a [`layered`] graph of nodes that are met once.
//!
//! Nothing is looked at that cannot reach the true goal any more.
//!
//! All but the first find every reachable pair of survivor counts, which is more than the Pareto set
//! the paper names and leaves out.

pub mod closure;
pub mod ends;
pub mod graph;
pub mod guided;
pub mod layered;
pub mod layers;
pub mod lengths;
mod pairs;
pub mod prospects;
mod way;

use std::sync::Arc;

use super::Options;
use super::engine::Engine;
use crate::problem::Problem;

/// The engine for the best plan at a horizon or of all lengths.
pub(in crate::solver) fn engine(
    problem: Arc<Problem>,
    options: &Options,
    horizon: Option<usize>,
) -> Box<dyn Engine> {
    if options.pareto {
        plain(problem, options, horizon)
    } else {
        Box::new(crate::solver::optimiser::Optimiser::new(problem, options, horizon))
    }
}

/// The engine that goes through all nodes.
fn plain(problem: Arc<Problem>, options: &Options, horizon: Option<usize>) -> Box<dyn Engine> {
    match horizon {
        Some(steps) => Box::new(layers::Layers::new(problem, options, steps)),
        None => Box::new(closure::Closure::new(problem, options)),
    }
}
