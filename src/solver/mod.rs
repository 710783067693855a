//! The solvers.
//!
//! | solver | finds | how sure | after |
//! |---|---|---|---|
//! | [`Exact`](Solver::Exact) | `max GD` over all plans, or those of T actions; every reachable pair `(│G_X│, │G_C│)`; the best of each length | proved best | best first over `(s, B_X, B_C)` under upper bounds; antichains: De Wulf, Doyen, Henzinger and Raskin 2006, <https://doi.org/10.1007/11817963_5> |
//! | [`Ip`](Solver::Ip) | `max Σ g^X − Σ g^C` over plans of T actions | proved best | integer programming: equations (3) to (17) of the paper, or flows over (state, belief) |
//! | [`Search`](Solver::Search) | a plan with `│G_X│ ≥ k` and `│G_C│ ≤ j`, so that `GD ≥ (k − j)/(n − 1)` | the first found, or the proof that there is none | Algorithm 1 of the paper |
//! | [`Satisficing`](Solver::Satisficing) | the same | the same | a sequential portfolio of Algorithm 1 and exact search |
//! | [`Obfuscate`](Solver::Obfuscate), [`Legible`](Solver::Legible) | a plan with `│G_X│ ≥ k`; a plan with `│G_C│ ≤ j` | the same | Algorithm 1 with one bound: the isolated settings that the paper compares with |
//! | [`Baseline`](Solver::Baseline) | a plan for the true goal alone | the first found | greedy best first on the set-additive heuristic: Keyder and Geffner 2008, doi:10.3233/978-1-58603-891-5-588 |
//!
//! All take one type of [`Options`] and give one type of [`Outcome`]. [`solve`] works to the end; a
//! [`Run`] is any solver at work, advanced in slices so that its progress can be shown and it can be
//! stopped with the best plan kept. [`remedy`] says why there is no plan and what would do,
//! [`lp_format`] writes the integer program for other solvers, [`upper_bounds`] what no plan can beat. A
//! [`ClassicalRun`] is the baseline on a task without observers.

mod algorithm1;
mod baseline;
mod classical;
mod conclude;
mod cost_limited;
// What the tests outside of the crate share, once for all tests inside.
#[cfg(test)]
use crate::common;
mod engine;
mod error;
mod explorer;
mod ground;
mod implications;
#[cfg(feature = "full")]
mod ip;
mod optimiser;
mod options;
mod outcome;
mod parallel_walks;
mod portfolio;
pub mod remedy;
mod run;
mod setters;
#[cfg(test)]
mod tests;

pub use classical::{ClassicalOutcome, ClassicalRun};
pub use error::SolveError;
#[cfg(feature = "full")]
pub use ip::{LpFormat, lp_format};
pub use optimiser::bounds::{UpperBound, upper_bounds};
pub use options::{
    Bounds, Encoding, Horizon, MAX_HORIZON, MAX_LENGTHS, Options, OptionsError, Solver, Watched,
};
pub use outcome::{LengthPoint, Outcome, Progress, ReachablePair, Stats, Status};
pub use run::{Run, abandoned, shortest_plan_length, solve};
