//! Tests in wasm, under Node: the golden plans, error messages, and the JavaScript API.
#![cfg(target_arch = "wasm32")]
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

mod bindings;
#[path = "../tests/golden/replay.rs"]
#[allow(dead_code, reason = "the file is written natively only")]
mod replay;
#[path = "../tests/exercises/seeds.rs"]
mod seeds;

use mo_copp::domain::Document;
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
