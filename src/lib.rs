//! Planning under two kinds of eyes.
//!
//! An agent must reach its goal so that a *friend* watching it understands what it is after while
//! an *enemy* watching it stays in doubt. Each observer has its own sensor and keeps a belief, the
//! set of states the agent could be in; the agent wants many candidate goals to survive in the
//! enemy's belief and few in the friend's.
//!
//! The model is MO-COPP of A. Kulkarni, S. Srivastava and S. Kambhampati, "Signaling Friends and
//! Head-Faking Enemies Simultaneously: Balancing Goal Obfuscation and Goal Legibility" (2020).

/// Tests inside share helpers with those in `tests/`, who know the crate by its name.
#[cfg(test)]
extern crate self as mo_copp;

pub mod belief;
#[cfg(target_arch = "wasm32")]
pub mod bindings;
pub mod document;
pub mod domain;
#[cfg(all(feature = "full", not(target_arch = "wasm32")))]
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
