//! Nothing that anybody writes makes the program panic.
//!
//! `MO_COPP_FUZZ_CASES` is the number of inputs for each of the five tests instead of some thousands; a
//! million in all: `MO_COPP_FUZZ_CASES=200000 cargo test --release --test native documents::fuzz`

use std::sync::Arc;

use mo_copp::domain::Document;
use mo_copp::solver::{Horizon, Options, Run, Solver};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestRunner};
use serde_json::{Value, json};

use super::delivery::DELIVERY;
use super::explicit::EXPLICIT;
use super::gridworld::GRIDWORLD;
use super::pddl;
use crate::common::fuzz_cases;

pub fn runner(seed: u64, cases: u32) -> TestRunner {
    let rng_seed = RngSeed::Fixed(seed);
    TestRunner::new(Config { cases, rng_seed, failure_persistence: None, ..Config::default() })
}

/// Reads, makes the problem and works a little on it; true when it was a document.
fn survives(text: &str) -> bool {
    let Ok(document) = Document::parse(text) else { return false };
    assert_eq!(Document::parse(&document.to_json()).as_ref(), Ok(&document));
    let Ok(problem) = document.problem() else { return false };
    let problem = Arc::new(problem);
    for solver in Solver::ALL {
        let mut options = Options::new(solver);
        options.limits.expansions = 50;
        options.limits.nonzeros = 5000;
        if solver == Solver::Ip {
            options.horizon = Horizon::Steps(2);
        }
        let mut run = Run::new(Arc::clone(&problem), options).unwrap();
        for _ in 0..20 {
            if run.advance(10).unwrap() {
                break;
            }
        }
        run.outcome().unwrap();
    }
    true
}

pub fn base() -> impl Strategy<Value = &'static str> {
    prop::sample::select(vec![GRIDWORLD, EXPLICIT, DELIVERY, pddl::example()])
}

#[test]
fn random_bytes() {
    runner(1, fuzz_cases(5_000))
        .run(&prop::collection::vec(any::<u8>(), 0..200), |bytes| {
            survives(&String::from_utf8_lossy(&bytes));
            Ok(())
        })
        .unwrap();
}

#[test]
fn random_pieces_of_documents() {
    let piece = prop::sample::select(vec![
        "{",
        "}",
        "[",
        "]",
        ",",
        ":",
        "\"format\"",
        "\"gridworld\"",
        "\"explicit\"",
        "\"pddl\"",
        "\"goals\"",
        "1",
        "-1",
        "1e400",
        "null",
        "true",
        "\"\\u0000\"",
        "\"observers\"",
        " ",
        "\n",
    ]);
    runner(2, fuzz_cases(5_000))
        .run(&prop::collection::vec(piece, 0..40), |pieces| {
            survives(&pieces.concat());
            Ok(())
        })
        .unwrap();
}

/// Bytes of a valid document deleted, doubled or replaced.
#[test]
fn documents_with_changed_bytes() {
    let edit = (any::<prop::sample::Index>(), 0..4_u8, any::<u8>());
    let strategy = (base(), prop::collection::vec(edit, 1..4));
    runner(3, fuzz_cases(15_000))
        .run(&strategy, |(base, edits)| {
            let mut bytes = base.as_bytes().to_vec();
            for (place, kind, byte) in edits {
                let place = place.index(bytes.len());
                match kind {
                    0 => drop(bytes.remove(place)),
                    1 => bytes.insert(place, bytes[place]),
                    2 => bytes[place] = byte,
                    _ => bytes.truncate(place.max(9)),
                }
            }
            survives(&String::from_utf8_lossy(&bytes));
            Ok(())
        })
        .unwrap();
}

/// Every place of a document: arrays and objects too.
fn places(value: &Value, path: &str, found: &mut Vec<String>) {
    found.push(path.to_owned());
    match value {
        Value::Array(items) => {
            for (index, item) in items.iter().enumerate() {
                places(item, &format!("{path}/{index}"), found);
            }
        }
        Value::Object(entries) => {
            for (key, item) in entries {
                places(item, &format!("{path}/{key}"), found);
            }
        }
        _ => {}
    }
}

/// Values of a valid document replaced by others that fit or do not.
#[test]
fn documents_with_changed_values() {
    let other = prop_oneof![
        (-3_i64..12).prop_map(|number| json!(number)),
        prop::sample::select(vec![
            "s0",
            "s1",
            "s2",
            "a",
            "b",
            "G1",
            "G2",
            "a1",
            "b2",
            "a1+b2",
            "A",
            "",
            "red",
            "hall",
            "(at hall)",
            "(not (has red))",
            "(take ?x ?y)",
            "*",
            "{name} {2}",
            "{?x}"
        ])
        .prop_map(|text| json!(text)),
        ((0..9_u8), (0..9_u8)).prop_map(|(column, row)| json!([column, row])),
        prop::sample::select(vec![
            json!(null),
            json!(true),
            json!([]),
            json!({}),
            json!(1e300),
            json!(256),
            json!(u64::MAX),
            json!([[0, 7], [1, 1]]),
            json!(["s0", "s1"]),
            json!(["s0", "a", "s1"]),
            json!([["(at hall)", "(has red)"], {}]),
            json!([{"operator": "*", "symbol": "{arguments}"}]),
            json!({"reachable": "(and)"}),
        ]),
    ];
    let strategy = (base(), prop::collection::vec((any::<prop::sample::Index>(), other), 1..3));
    let made = std::cell::Cell::new(0);
    runner(4, fuzz_cases(25_000))
        .run(&strategy, |(base, edits)| {
            let mut document: Value = serde_json::from_str(base).unwrap();
            for (place, other) in edits {
                let mut all = Vec::new();
                places(&document, "", &mut all);
                let place = &all[place.index(all.len())];
                *document.pointer_mut(place).unwrap() = other;
            }
            made.set(made.get() + usize::from(survives(&document.to_string())));
            Ok(())
        })
        .unwrap();
    assert!(made.get() > fuzz_cases(25_000) as usize / 100, "{}", made.get());
}

/// The texts inside of a PDDL document put together of pieces that belong there.
#[test]
fn pddl_documents_with_changed_texts() {
    let piece = prop::sample::select(vec![
        "(",
        ")",
        " ",
        "and",
        "not",
        "=",
        "at",
        "in",
        "has",
        "door",
        "hall",
        "red",
        "blue",
        "office",
        "?x",
        "?y",
        "?to",
        "- room",
        "- envelope",
        "- (either room letter)",
        "walk",
        "take",
        "leave",
        "*",
        "{",
        "}",
        "{name}",
        "{1}",
        "{2}",
        "{?x}",
        "{arguments}",
        "(at hall)",
        "(in red office)",
        "(walk ?x ?y)",
        "(take ?x ?y)",
        "(at ?x)",
        "\n",
        ";",
        ":goal",
        "é",
    ]);
    let text = prop::collection::vec(piece, 1..8).prop_map(|pieces| pieces.concat());
    let spaced = prop::collection::vec(text, 1..4).prop_map(|texts| texts.join(" "));
    let places = [
        "/domain/3",
        "/domain/7",
        "/domain/8",
        "/problem/2",
        "/problem/3",
        "/goals/0/condition",
        "/goals/2/condition",
        "/observers/adversarial/initial_belief/reachable",
        "/observers/adversarial/sensor/0/operator",
        "/observers/adversarial/sensor/0/result",
        "/observers/adversarial/sensor/2/operator",
        "/observers/adversarial/sensor/2/symbol",
        "/observers/cooperative/initial_belief/1/add/0",
        "/observers/cooperative/initial_belief/1/delete/0",
        "/observers/cooperative/sensor",
    ];
    let strategy = (prop::sample::select(places.to_vec()), spaced);
    let made = std::cell::Cell::new(0);
    runner(5, fuzz_cases(25_000))
        .run(&strategy, |(place, text)| {
            let mut document: Value = serde_json::from_str(pddl::example()).unwrap();
            *document.pointer_mut(place).unwrap() = json!(text);
            made.set(made.get() + usize::from(survives(&document.to_string())));
            Ok(())
        })
        .unwrap();
    assert!(made.get() > fuzz_cases(25_000) as usize / 100, "{}", made.get());
}
