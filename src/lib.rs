//! Planning watched by a friend and an enemy: mixed-observer controlled observability planning
//! (MO-COPP).
//!
//! An agent must reach its goal so that a *friend* watching it understands what it is after while an
//! *enemy* watching it stays in doubt. The model is that of A. Kulkarni, S. Srivastava and
//! S. Kambhampati, "Signaling Friends and Head-Faking Enemies Simultaneously: Balancing Goal
//! Obfuscation and Goal Legibility" (2020).
//!
//! ```
//! use std::{ops::ControlFlow, sync::Arc};
//! use mo_copp::domain::Delivery;
//! use mo_copp::solver::{Options, Solver, solve};
//!
//! let problem = Arc::new(Delivery::figure_1().problem()?);
//! let options = Options::new(Solver::Exact);
//! let outcome = solve(Arc::clone(&problem), options, |_| ControlFlow::Continue(()))?;
//! let plan = outcome.plan.ok_or("no plan")?;
//! assert_eq!(plan.names(problem.task()), ["load a1", "load a2", "deliver"]);
//! assert_eq!(outcome.goal_difference, Some(1.0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # From the problem to the solvers
//!
//! In reading order; each module begins with the definition or the paper that it implements.
//!
//! 1. **The task** ([`task`]): grounded STRIPS `P = ⟨F, Op, I, G_A⟩` with the transition function
//!    `Γ(s, a) = (s \ delete(a)) ∪ add(a)` where `s ⊨ pre(a)` (Definition 1; Fikes and Nilsson 1971,
//!    doi:10.1016/0004-3702(71)90010-5). [`TaskBuilder`](task::TaskBuilder) makes one in code,
//!    [`pddl`] reads one.
//! 2. **The sensors** ([`sensor`]): `O_i: Op × S → Ω_i`, one symbol for an operator and the state that it
//!    results in.
//! 3. **The problem** ([`problem`]): the task, `n ≥ 2` candidate goals of which one is the true goal,
//!    and [`Observer`](problem::Observer)s, each with a role, a sensor and an initial belief.
//!    [`domain`] has formats of documents for problems, [`document`] says what is wrong with one.
//! 4. **Beliefs and plans** ([`plan`], [`trace`](mod@trace)): after the symbol `o` an observer believes
//!    `B' = { s' : s ∈ B, a ∈ Op, s' = Γ(s, a), O(a, s') = o }`. [`trace`](trace::trace()) carries a
//!    plan out and tells what each observer saw and believes, from the definitions alone.
//! 5. **The objective** ([`goal_difference`]): a goal survives in a belief when a state of it satisfies the
//!    goal, and `GD = (|G_X| − |G_C|) / (n − 1)` on the final beliefs of enemy and friend.
//! 6. **The solvers** ([`solver`]): exact ones, integer programs, the paper's search and what it is
//!    compared with, under [`Options`](solver::Options) and [`limits`], with one
//!    [`Outcome`](solver::Outcome). [`heuristic`] is what the search is guided by.
//! 7. **Exercises** ([`exercise`]): questions about a problem, variants by seed, answers and their codes.
//! 8. **What other programs read** ([`report`]): outcomes and traces as JSON.
//!
//! The folder `examples/` has a program for each of these steps: `solve_grid`, `problem_in_code`,
//! `own_sensor`, `read_pddl`, `trace_plan`, `trade_off` and `compare_solvers`
//! (`cargo run --example trade_off`).
//!
//! # Features
//!
//! `full` (on by default) is PDDL, pictures, exercises and every solver but exact search for one best plan; a browser's
//! first picture does without them.

// The linker leaves out what only the full core reaches.
#![cfg_attr(not(feature = "full"), allow(dead_code, unused_imports))]

/// Tests inside share helpers with those in `tests/`, who know the crate by its name.
#[cfg(test)]
extern crate self as mo_copp;

mod belief;
#[cfg(target_arch = "wasm32")]
pub mod bindings;
pub mod document;
pub mod domain;
#[cfg(feature = "full")]
pub mod exercise;
// The paper's experiments, for the command of this package and its tests: no part of the library
// that stays as it is.
#[cfg(all(feature = "full", not(target_arch = "wasm32")))]
#[doc(hidden)]
pub mod experiment;
pub mod goal_difference;
pub mod heuristic;
pub mod limits;
#[cfg(feature = "full")]
pub mod pddl;
#[cfg(feature = "full")]
pub mod picture;
pub mod plan;
pub mod problem;
pub mod report;
pub mod sensor;
pub mod solver;
pub mod task;
pub mod trace;

/// Runs the examples of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

/// What tests inside share with those in `tests/`.
#[cfg(test)]
#[path = "../tests/common/mod.rs"]
#[allow(dead_code, unused_imports, unreachable_pub, missing_docs, missing_debug_implementations)]
#[allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
mod common;
