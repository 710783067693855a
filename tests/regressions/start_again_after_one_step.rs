//! Exact search at a horizon lost the first situation when one step led back to it.

use mo_copp::domain::Document;
use mo_copp::solver::{Horizon, Options, Solver, Status};

use crate::common::solve;

#[test]
fn staying_at_the_goal_is_a_plan() {
    let text = r#"{"format": "gridworld", "width": 2, "height": 1, "start": [0, 0], "stay": true,
        "goals": [{"name": "G1", "cell": [0, 0]}, {"name": "G2", "cell": [1, 0]}],
        "true_goal": "G1", "observers": {
          "adversarial": {"sensor": {"north": "n", "south": "s", "east": "e", "west": "w", "stay": "x"}},
          "cooperative": {"sensor": {"north": "n", "south": "s", "east": "e", "west": "w", "stay": "x"}}}}"#;
    let problem = std::sync::Arc::new(Document::parse(text).unwrap().problem().unwrap());
    let mut options = Options::new(Solver::Exact);
    options.horizon = Horizon::Steps(1);
    let outcome = solve(&problem, &options);
    assert_eq!(outcome.status, Status::Optimal);
    assert_eq!(outcome.plan.unwrap().names(problem.task()), ["stay"]);
}
