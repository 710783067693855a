//! Tests that run natively.
#![cfg(not(target_arch = "wasm32"))]
// Helpers outside of test functions fail a test by panicking, as these do.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod common;

mod beliefs;
mod contradictions;
mod corrections;
mod cost_limit;
mod documents;
mod domains;
mod eliminations;
mod exact;
mod exercises;
mod experiments;
mod golden;
mod highs;
mod integer_programs;
mod lengths;
mod next_actions;
mod observers;
mod overview;
mod pddl;
mod pddl_domains;
mod pictures;
mod regressions;
mod remedy;
mod search;
mod set_additive;
mod stopping;
mod validation;
