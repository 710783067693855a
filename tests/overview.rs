//! What a page is told of large beliefs: counts over all states, held against counting by hand.

use std::fs::read_to_string;

use mo_copp::domain::Document;
use mo_copp::plan::Plan;
use mo_copp::problem::Problem;
use mo_copp::report::{BeliefReport, TraceReport};
use mo_copp::solver::{Options, Outcome, Solver, solve};
use mo_copp::trace::trace;
use serde_json::{Value, json};
use std::ops::ControlFlow;
use std::sync::Arc;

fn problem(path: &str) -> Arc<Problem> {
    let text = read_to_string(path).unwrap();
    Arc::new(Document::parse(&text).unwrap().problem().unwrap())
}

fn solved(problem: &Arc<Problem>) -> Outcome {
    let options = Options::new(Solver::Exact);
    solve(Arc::clone(problem), options, |_| ControlFlow::Continue(())).unwrap()
}

/// The overview and the trace of the best plan, as JSON.
fn both(path: &str, most: usize) -> (Value, Value) {
    let problem = problem(path);
    let plan = solved(&problem).plan.unwrap();
    let overview = TraceReport::overview(&problem, &plan, most).unwrap();
    let full = TraceReport::new(&problem, &trace(&problem, &plan).unwrap());
    (serde_json::to_value(overview).unwrap(), serde_json::to_value(full).unwrap())
}

fn holds(state: &Value, share: &Value) -> bool {
    match share.get("fact") {
        Some(fact) => state.as_array().unwrap().contains(fact),
        None => state[share["part"].as_str().unwrap()] == share["value"],
    }
}

#[test]
fn an_overview_counts_what_the_trace_lists() {
    for name in ["blocks", "logistics", "driverlog", "box-pushing", "recycling-robot"] {
        let (overview, full) = both(&format!("www/problems/{name}.json"), 5);
        assert_eq!(overview["valid"], full["valid"]);
        assert_eq!(overview["goal_difference"], full["goal_difference"]);
        let steps = overview["steps"].as_array().unwrap().iter();
        for (short, long) in steps.zip(full["steps"].as_array().unwrap()) {
            for key in ["action", "state", "symbols", "goals", "goal_difference"] {
                assert_eq!(short[key], long[key], "{name}");
            }
            for role in ["adversarial", "cooperative"] {
                let listed = short["beliefs"][role].as_array().unwrap();
                let states = long["beliefs"][role].as_array().unwrap();
                assert_eq!(listed[..], states[..states.len().min(5)], "{name}");
                let summary = &short["summaries"][role];
                assert_eq!(summary["states"], states.len());
                assert_eq!(summary["left_out"], 0);
                let shares = summary["shares"].as_array().unwrap();
                let mut told = 0;
                for share in shares {
                    let count = states.iter().filter(|state| holds(state, share)).count();
                    assert!(count > 0);
                    assert_eq!(share["states"], count, "{name}: {share}");
                    told += count;
                }
                let said = |state: &Value| {
                    state.as_array().map_or_else(|| state.as_object().unwrap().len(), Vec::len)
                };
                assert_eq!(told, states.iter().map(said).sum::<usize>(), "{name}: none is missing");
            }
        }
        assert_eq!(
            overview["steps"].as_array().unwrap().len(),
            full["steps"].as_array().unwrap().len()
        );
    }
}

#[test]
fn what_is_open_comes_before_what_is_certain() {
    let problem = problem("www/problems/blocks-unseen.json");
    let belief = problem.observers()[0].initial_belief.listed().unwrap();
    let report = BeliefReport::new(&problem, belief);
    assert_eq!(report.states.as_f64(), 501.0);
    let open = report.shares.iter().take_while(|share| share.states.as_f64() < 501.0).count();
    assert!(open > 20);
    assert!(report.shares[open..].iter().all(|share| share.states.as_f64() == 501.0));
    // The hand is empty in all of them: that is all that is certain.
    assert_eq!(report.shares.len() - open, 1);
    // Facts of candidate goals, "a is on b", are the first.
    let first = serde_json::to_value(&report.shares[0]).unwrap();
    assert!(first["fact"].as_str().unwrap().starts_with("(on "), "{first}");
}

#[test]
fn each_goal_is_counted() {
    let problem = problem("www/problems/blocks.json");
    let plan = solved(&problem).plan.unwrap();
    let end = trace(&problem, &plan).unwrap().steps.pop().unwrap();
    for (belief, survivors) in end.beliefs.iter().zip(&end.survivors) {
        let report = BeliefReport::new(&problem, belief);
        for (goal, &count) in report.goals.iter().enumerate() {
            assert_eq!(count.as_f64() > 0.0, survivors.contains(goal));
        }
        assert!(
            report.goals.iter().map(|count| count.as_f64()).sum::<f64>() <= report.states.as_f64()
        );
    }
}

#[test]
fn a_gridworld_keeps_its_beliefs_in_full() {
    for name in ["eight-by-eight", "delivery"] {
        let (mut overview, full) = both(&format!("www/problems/{name}.json"), 1);
        for step in overview["steps"].as_array_mut().unwrap() {
            // All that an overview says beside the trace.
            assert!(step.as_object_mut().unwrap().remove("ruled_out").is_some());
        }
        assert_eq!(overview, full);
    }
}

#[test]
fn names_of_states_have_nothing_in_common() {
    let document = json!({
        "format": "explicit", "states": ["s0", "s1", "s2"], "actions": ["a"],
        "transitions": [["s0", "a", "s1"], ["s1", "a", "s2"]], "initial_state": "s0",
        "goals": [{"name": "G1", "states": ["s1"]}, {"name": "G2", "states": ["s1", "s2"]}],
        "true_goal": "G1",
        "observers": {
            "adversarial": {"initial_belief": ["s0", "s1"],
                            "sensor": [["a", "s1", "x"], ["a", "s2", "x"]]},
            "cooperative": {"sensor": [["a", "s1", "x"], ["a", "s2", "x"]]}
        }
    });
    let problem = Document::parse(&document.to_string()).unwrap().problem().unwrap();
    let plan = Plan::from_names(problem.task(), &["a"]).unwrap();
    let report = TraceReport::overview(&problem, &plan, 1).unwrap();
    let report = serde_json::to_value(report).unwrap();
    let summary = &report["steps"][1]["summaries"]["adversarial"];
    assert_eq!(summary["states"], 2);
    assert_eq!(summary["shares"], json!([]));
    assert_eq!(summary["goals"], json!([1, 2]));
    // One is listed, in the order of the packed states.
    assert_eq!(report["steps"][1]["beliefs"]["adversarial"].as_array().unwrap().len(), 1);
}
