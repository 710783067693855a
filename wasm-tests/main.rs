//! Tests in wasm, under Node: the golden plans, error messages, and the JavaScript API.
#![cfg(target_arch = "wasm32")]
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod bindings;
#[path = "../tests/golden/replay.rs"]
#[allow(dead_code, reason = "the file is written natively only")]
mod replay;
#[path = "../tests/exercises/seeds.rs"]
mod seeds;

use std::sync::Arc;

use mo_copp::domain::Document;
use mo_copp::solver::{Options, Run, Solver};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test]
fn plans_are_the_golden_ones() {
    assert!(replay::check(include_str!("../tests/golden/plans.json")) >= 180);
}

#[wasm_bindgen_test]
fn the_seeds_of_each_kind_of_exercise_are_the_golden_ones() {
    let golden: serde_json::Value =
        serde_json::from_str(include_str!("../tests/golden/exercises.json")).unwrap();
    for (kind, text, most) in seeds::EXERCISES {
        let found = format!("{:016x}", seeds::hash(text, most));
        assert_eq!(golden[kind], found, "{kind}");
    }
}

#[wasm_bindgen_test]
fn documents_are_refused_with_the_same_words() {
    let message = |text: &str| {
        let made = Document::parse(text).and_then(|document| document.problem());
        made.unwrap_err().to_string()
    };
    assert_eq!(
        message("{\"a\": 1,\n\"a\": 1}"),
        "line 2, column 3: found the key \"a\" for the second time, expected each key once"
    );
    assert_eq!(
        message(r#"{"format": "gridworld", "width": 4294967304}"#),
        "width: found 4294967304, expected a whole number from 1 to 256"
    );
    assert_eq!(
        message(r#"{"format": "gridworld", "width": 8.0}"#),
        "width: found 8.0, expected a whole number from 1 to 256"
    );
}

/// As natively (`tests/stopping.rs`).
#[wasm_bindgen_test]
fn slices_of_any_size_give_the_same_outcome() {
    for text in
        [include_str!("../examples/gridworld.json"), include_str!("../examples/driverlog.json")]
    {
        let problem = Arc::new(Document::parse(text).unwrap().problem().unwrap());
        for solver in [Solver::Exact, Solver::Satisficing, Solver::Search] {
            let mut options = Options::new(solver);
            options.bounds.at_least = Some(2);
            let outcome = |budget: u64| {
                let mut run = Run::new(Arc::clone(&problem), options.clone()).unwrap();
                while !run.advance(budget).unwrap() {}
                run.outcome().unwrap()
            };
            let whole = outcome(u64::MAX);
            assert!(whole.plan.is_some());
            for budget in [1, 2, 7, 64] {
                assert_eq!(outcome(budget), whole, "{} in slices of {budget}", solver.name());
            }
        }
    }
}
