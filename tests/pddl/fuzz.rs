//! Nothing that anybody writes makes the reader or the grounder panic, hang or go deep.
//!
//! Each test tries some thousands of inputs. `MO_COPP_FUZZ_CASES` is the number for each of the four
//! instead; a million in all take some minutes:
//! `MO_COPP_FUZZ_CASES=250000 cargo test --release --test native pddl::fuzz`

use std::cell::Cell;

use mo_copp::pddl::{
    ExtraInputs, MAX_DEPTH, ground, read_condition, read_domain, read_state, read_task,
};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestRunner};

use super::{BLOCKS, THREE_BLOCKS};
use crate::common::fuzz_cases;

/// Roads with tolls: constants, a hierarchy, either, equality, negation.
const ROADS: &str = "(define (domain roads) (:requirements :typing :equality)
 (:types car lorry - vehicle place) (:constants home - place)
 (:predicates (at ?v - vehicle ?p - place) (road ?x ?y - place) (paid ?v - (either car lorry)) (night))
 (:action drive :parameters (?v - vehicle ?x ?y - place)
  :precondition (and (at ?v ?x) (road ?x ?y) (not (= ?y home)) (paid ?v) (not (night)))
  :effect (and (not (at ?v ?x)) (at ?v ?y) (not (paid ?v)) (night)))
 (:action pay :parameters (?v - (either car lorry)) :precondition (not (paid ?v)) :effect (paid ?v))
 (:action sleep :precondition (night) :effect (not (night))))";

const ROADS_TASK: &str = "(define (problem trip) (:domain roads)
 (:objects c - car l - lorry a b - place)
 (:init (at c home) (at l a) (road home a) (road a b) (road b a) (not (night)))
 (:goal (and (at c b) (not (at l a)) (not (= a b)))))";

const BASES: [(&str, &str); 2] = [(BLOCKS, THREE_BLOCKS), (ROADS, ROADS_TASK)];

fn runner(seed: u64, cases: u32) -> TestRunner {
    let rng_seed = RngSeed::Fixed(seed);
    TestRunner::new(Config { cases, rng_seed, failure_persistence: None, ..Config::default() })
}

/// Reads and grounds; true when there was a task.
fn survives(domain: &str, task: &str) -> bool {
    let Ok(domain) = read_domain(domain) else { return false };
    let Ok(task) = read_task(&domain, task) else { return false };
    let mut more = ExtraInputs::default();
    for text in ["(and)", "(not (at c a))", "(and (on a b) (not (on b a)))"] {
        more.conditions.extend(read_condition(&domain, &task, text));
    }
    for text in ["", "(at c a) (paid c)", "(on a b) (held c)"] {
        more.states.extend(read_state(&domain, &task, text));
    }
    let Ok(grounded) = ground(&domain, &task, &more) else { return true };
    let mut found = Vec::new();
    for state in grounded.states.iter().chain([grounded.task.initial_state()]) {
        grounded.task.applicable(state.words(), &mut found);
    }
    true
}

/// Any text by itself, as every kind of text.
fn survives_alone(text: &str) {
    for (domain, task) in BASES {
        survives(text, task);
        survives(domain, text);
        let domain = read_domain(domain).unwrap();
        let task = read_task(&domain, task).unwrap();
        let _ = read_condition(&domain, &task, text);
        let _ = read_state(&domain, &task, text);
    }
}

#[test]
fn random_bytes_do_no_harm() {
    runner(1, fuzz_cases(5_000))
        .run(&prop::collection::vec(any::<u8>(), 0..200), |bytes| {
            survives_alone(&String::from_utf8_lossy(&bytes));
            Ok(())
        })
        .unwrap();
}

/// Words of PDDL, and names that the texts know.
const WORDS: [&str; 56] = [
    "define",
    "domain",
    "problem",
    ":domain",
    ":requirements",
    ":types",
    ":constants",
    ":objects",
    ":predicates",
    ":action",
    ":parameters",
    ":precondition",
    ":effect",
    ":init",
    ":goal",
    ":strips",
    ":typing",
    ":adl",
    "and",
    "or",
    "not",
    "=",
    "forall",
    "when",
    "either",
    "-",
    "object",
    "?x",
    "?y",
    "?",
    "at",
    "road",
    "paid",
    "on",
    "clear",
    "held",
    "block",
    "car",
    "lorry",
    "place",
    "a",
    "b",
    "c",
    "home",
    "roads",
    "towers",
    "x",
    "0",
    "1e9",
    "ä",
    "\u{0}",
    "\u{feff}",
    ";",
    "\n",
    "(",
    ")",
];

/// A random s-expression.
fn expression() -> impl Strategy<Value = String> {
    let word = prop::sample::select(WORDS.to_vec()).prop_map(str::to_owned);
    word.prop_recursive(6, 60, 8, |inner| {
        prop::collection::vec(inner, 0..8).prop_map(|items| format!("({})", items.join(" ")))
    })
}

#[test]
fn random_expressions_do_no_harm() {
    let cases = fuzz_cases(5_000);
    let wrapped = (prop::collection::vec(expression(), 0..5), 0..6_u8);
    runner(2, cases)
        .run(&wrapped, |(items, wrap)| {
            let items = items.join("\n");
            let text = match wrap {
                0 => items,
                1 => format!("(define (domain d) {items})"),
                2 => format!("(define (domain d) (:predicates (p ?x) (q)) (:action a {items}))"),
                3 => format!("(define (problem p) (:domain d) (:goal ()) {items})"),
                4 => format!("(define (problem p) (:domain d) (:init {items}) (:goal {items}))"),
                _ => format!("(define (domain d) (:types {items}) (:constants {items}) (:predicates {items}))"),
            };
            survives_alone(&text);
            Ok(())
        })
        .unwrap();
}

/// The words and parentheses of a text.
fn tokens(text: &str) -> Vec<String> {
    let spaced = text.replace('(', " ( ").replace(')', " ) ");
    let lines = spaced.lines().filter(|line| !line.starts_with(';'));
    lines.flat_map(str::split_whitespace).map(str::to_owned).collect()
}

/// Words of valid texts deleted, doubled, exchanged, replaced.
#[test]
fn texts_with_changed_words_do_no_harm() {
    let cases = fuzz_cases(10_000);
    let index = any::<prop::sample::Index>;
    let edit = (index(), index(), 0..5_u8, prop::sample::select(WORDS.to_vec()), any::<bool>());
    let strategy = (any::<bool>(), prop::collection::vec(edit, 1..4));
    let made = Cell::new(0);
    runner(3, cases)
        .run(&strategy, |(base, edits)| {
            let (domain, task) = BASES[usize::from(base)];
            let mut texts = [tokens(domain), tokens(task)];
            for (place, other, kind, word, which) in edits {
                let text = &mut texts[usize::from(which)];
                let (place, other) = (place.index(text.len()), other.index(text.len()));
                match kind {
                    0 => drop(text.remove(place)),
                    1 => text.insert(place, text[other].clone()),
                    2 => text.swap(place, other),
                    3 => text[place] = text[other].clone(),
                    _ => text[place] = word.to_owned(),
                }
            }
            made.set(made.get() + u32::from(survives(&texts[0].join(" "), &texts[1].join(" "))));
            Ok(())
        })
        .unwrap();
    // One in a hundred is a task still, so that the grounder is tried too.
    assert!(made.get() > cases / 100, "{} tasks", made.get());
}

/// Bytes of valid texts deleted, doubled, replaced, cut off.
#[test]
fn texts_with_changed_bytes_do_no_harm() {
    let cases = fuzz_cases(10_000);
    let edit = (any::<prop::sample::Index>(), 0..4_u8, any::<u8>(), any::<bool>());
    let strategy = (any::<bool>(), prop::collection::vec(edit, 1..4));
    let made = Cell::new(0);
    runner(4, cases)
        .run(&strategy, |(base, edits)| {
            let (domain, task) = BASES[usize::from(base)];
            let mut texts = [domain.as_bytes().to_vec(), task.as_bytes().to_vec()];
            for (place, kind, byte, which) in edits {
                let bytes = &mut texts[usize::from(which)];
                let place = place.index(bytes.len());
                match kind {
                    0 => drop(bytes.remove(place)),
                    1 => bytes.insert(place, bytes[place]),
                    2 => bytes[place] = byte,
                    _ => bytes.truncate(place.max(bytes.len() - 9)),
                }
            }
            let [domain, task] = texts.map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
            made.set(made.get() + u32::from(survives(&domain, &task)));
            Ok(())
        })
        .unwrap();
    // One in a hundred is a task still, so that the grounder is tried too.
    assert!(made.get() > cases / 100, "{} tasks", made.get());
}

#[test]
fn the_bases_are_valid() {
    for (domain, task) in BASES {
        assert!(survives(domain, task));
    }
    assert!(!survives(&"(".repeat(MAX_DEPTH + 1), ""));
}
