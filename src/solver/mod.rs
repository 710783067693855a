//! The solvers.
//!
//! | solver | answers | plan |
//! |---|---|---|
//! | exact | the best goal difference at a horizon, at each up to a longest one, or over all, and every reachable pair of survivor counts | proved best |
//! | [`ip`] | the best goal difference at a horizon, by integer programming in two encodings | proved best |
//! | search | a plan that keeps the bounds k and j, by Algorithm 1 of the paper | the first found |
//! | satisficing | the same, by a portfolio of Algorithm 1 and exact search | the first found |
//! | baseline | a plan for the true goal alone | the first found |
//! | obfuscate, legible | Algorithm 1 with one of the two bounds | the first found |
//!
//! All take one type of [`Options`] and give one type of [`Outcome`]; a [`Run`] is any of them at
//! work, advanced in slices so that its progress can be shown and it can be stopped with the best
//! plan kept. A [`ClassicalRun`] is the baseline on a task that nobody watches.

mod algorithm1;
mod baseline;
mod classical;
// What the tests outside of the crate share, once for all tests inside.
#[cfg(test)]
#[path = "../../tests/common/mod.rs"]
#[allow(dead_code, unused_imports, unreachable_pub, missing_docs, missing_debug_implementations)]
mod common;
mod engine;
mod error;
mod explorer;
mod ground;
#[cfg(feature = "full")]
pub mod ip;
mod optimiser;
mod options;
mod outcome;
mod portfolio;
pub mod remedy;
mod run;

pub use classical::{ClassicalOutcome, ClassicalRun};
pub use error::SolveError;
pub use optimiser::bounds::{UpperBound, upper_bounds};
pub use options::{
    Bounds, Encoding, Horizon, MAX_HORIZON, MAX_LENGTHS, Options, OptionsError, Solver, Watched,
};
pub use outcome::{LengthPoint, Outcome, Progress, ReachablePair, Stats, Status};
pub use run::{Run, abandoned, shortest_plan_length, solve};
