//! The command `mo-copp`, run as a person runs it.
#![cfg(not(target_arch = "wasm32"))]
#![allow(missing_docs, missing_debug_implementations)]
#![allow(clippy::unwrap_used, clippy::missing_panics_doc)]

mod bad_input;
mod benchmarks;
mod encode;
mod exercise;
mod experiment;
mod gallery;
mod generate;
mod import;
mod import_task;
mod interrupt;
mod picture;
mod picture_png;
mod plan;
mod schema;
mod sensor;
mod solve;
mod trace;

use std::io::Write;
use std::process::{Command, Output, Stdio};

/// The example of the design: a head fake in an empty room.
pub const GRID: &str = r#"{"format": "gridworld", "width": 8, "height": 8, "walls": [[3, 3]], "start": [0, 7],
 "goals": [{"name": "G1", "cell": [7, 0]}, {"name": "G2", "cell": [7, 7]}, {"name": "G3", "cell": [0, 0]}],
 "true_goal": "G1", "stay": false,
 "observers": {
   "adversarial": {"initial_belief": [[0, 7]], "sensor": {"north": "vertical", "south": "vertical", "east": "horizontal", "west": "horizontal"}},
   "cooperative": {"initial_belief": [[0, 7]], "sensor": {"north": "north-east", "east": "north-east", "south": "south-west", "west": "south-west"}}}}"#;

/// The explicit example of the design.
pub const EXPLICIT: &str = r#"{"format": "explicit", "states": ["s0", "s1", "s2"], "actions": ["a", "b"],
 "transitions": [["s0", "a", "s1"], ["s0", "b", "s2"]], "initial_state": "s0",
 "goals": [{"name": "G1", "states": ["s1"]}, {"name": "G2", "states": ["s2"]}], "true_goal": "G1",
 "observers": {
   "adversarial": {"initial_belief": ["s0"], "sensor": [["a", "s1", "moved"], ["b", "s2", "moved"]]},
   "cooperative": {"initial_belief": ["s0"], "sensor": [["a", "s1", "a"], ["b", "s2", "b"]]}}}"#;

/// Figure 1 of the paper.
pub const DELIVERY: &str = r#"{"format": "delivery",
 "factories": [{"name": "A", "packages": ["a1", "a2"]}, {"name": "B", "packages": ["b1", "b2"]}],
 "deliver": 2, "true_goal": "a1+a2",
 "observers": {
   "adversarial": {"sensor": {"load": "package", "deliver": "delivery"}},
   "cooperative": {"sensor": {"load": {"A": "barcode A", "B": "barcode B"}, "deliver": "delivery"}}}}"#;

/// What a run of the command printed, and its exit code.
pub struct Ran {
    pub code: i32,
    pub out: String,
    pub err: String,
}

impl Ran {
    /// The one JSON object printed.
    pub fn json(&self) -> serde_json::Value {
        assert_eq!(self.out.trim().lines().count(), 1, "one line: {}", self.out);
        serde_json::from_str(&self.out).unwrap()
    }
}

fn ran(output: Output) -> Ran {
    Ran {
        code: output.status.code().unwrap_or(-1),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// The command with these arguments.
pub fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_mo-copp"));
    command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

/// Runs it with a document on the standard input.
pub fn mo_copp(document: &str, arguments: &[&str]) -> Ran {
    with_input(command(arguments), document)
}

/// Runs a command with a document on the standard input.
pub fn with_input(mut command: Command, document: &str) -> Ran {
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    // A command that refuses its arguments does not read the document.
    let _ = child.stdin.take().unwrap().write_all(document.as_bytes());
    ran(child.wait_with_output().unwrap())
}
