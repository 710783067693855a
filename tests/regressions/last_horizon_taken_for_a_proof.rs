//! An integer program whose horizon could be raised no further said that there is no plan at all.

use std::sync::Arc;

use mo_copp::domain::Document;
use mo_copp::limits::LimitReached;
use mo_copp::solver::{Options, Solver, Status};

use crate::common::solve;

/// `go` leads to G1 at once; two times `round` leads there too, and leaves the enemy, who holds s3
/// possible at first, in doubt: from there it leads to G2.
const ROUND: &str = r#"{"format": "explicit", "states": ["s0", "s1", "s2", "s3", "s4", "s5"],
  "actions": ["go", "round"],
  "transitions": [["s0", "go", "s1"], ["s0", "round", "s2"], ["s2", "round", "s1"],
    ["s3", "round", "s4"], ["s4", "round", "s5"]],
  "initial_state": "s0",
  "goals": [{"name": "G1", "states": ["s1"]}, {"name": "G2", "states": ["s5"]}],
  "true_goal": "G1",
  "observers": {
    "adversarial": {"initial_belief": ["s0", "s3"], "sensor": [["go", "s1", "go"],
      ["round", "s1", "r"], ["round", "s2", "r"], ["round", "s4", "r"], ["round", "s5", "r"]]},
    "cooperative": {"sensor": [["go", "s1", "go"],
      ["round", "s1", "r"], ["round", "s2", "r"], ["round", "s4", "r"], ["round", "s5", "r"]]}}}"#;

#[test]
fn a_longer_plan_is_not_ruled_out() {
    let problem = Arc::new(Document::parse(ROUND).unwrap().problem().unwrap());
    let mut options = Options::new(Solver::Ip);
    options.bounds.at_least = Some(2);
    let outcome = solve(&problem, &options);
    assert_eq!((outcome.status, outcome.horizon), (Status::Optimal, Some(2)));
    options.horizon_limit = 1;
    let outcome = solve(&problem, &options);
    assert_eq!((outcome.status, &outcome.plan), (Status::Limit, &None));
    assert_eq!(outcome.limit, Some(LimitReached::Horizon { limit: 1 }));
}
