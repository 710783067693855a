//! PDDL documents at the edge of what is read: what never changes, what fits nothing, what is denied.

use mo_copp::domain::Document;
use serde_json::{Value, json};

use super::Change::Put;
use super::pddl::example;
use super::{check, message};

/// A document over this domain, initial state and observer of both roles.
fn document(domain: &str, init: &str, observer: &Value) -> String {
    json!({
        "format": "pddl",
        "domain": format!("(define (domain d) (:requirements :strips :equality) {domain})"),
        "problem": format!("(define (problem p) (:domain d) (:init {init}))"),
        "goals": [{"name": "one", "condition": "(p a)"}, {"name": "two", "condition": "(p b)"}],
        "true_goal": "one",
        "observers": {"adversarial": observer, "cooperative": {"sensor": "{name}"}},
    })
    .to_string()
}

const GO: &str = "(:predicates (p ?x)) (:constants a b) (:action go :effect (p a))";

#[test]
fn atoms_that_no_action_changes_may_be_left_out_of_a_state() {
    for (state, expected) in [
        (json!([]), "no error"),
        (json!(["(p b)"]), "no error"),
        (
            json!(["(not (p b))"]),
            "observers.adversarial.initial_belief: found 1 states without the initial state, expected the initial state among them, as in {}",
        ),
        (
            json!(["(p b)", "(not (p b))"]),
            "observers.adversarial.initial_belief[0][1]: found the negation of an atom that is listed too, expected one of them",
        ),
    ] {
        let text = document(GO, "(p b)", &json!({"initial_belief": [state], "sensor": "{name}"}));
        assert_eq!(message(&text), expected, "{state}");
    }
    // An action that changes the atom by a variable, unless what it needs is never there.
    let init = "(p b) (q a)";
    let paint = |needs: &str| {
        let domain = format!(
            "(:predicates (p ?x) (q ?x)) (:constants a b)
             (:action paint :parameters (?x) :precondition {needs} :effect (not (p ?x)))"
        );
        message(&document(&domain, init, &json!({"initial_belief": [[]], "sensor": "{name}"})))
    };
    assert_eq!(paint("(q ?x)"), "no error");
    assert_eq!(
        paint("(p ?x)"),
        "observers.adversarial.initial_belief: found 1 states without the initial state, expected the initial state among them, as in {}"
    );
}

#[test]
fn a_state_that_another_one_makes_changeable() {
    // Only in the second state can the switch be turned: there the light is not what never changes.
    let domain = "(:predicates (p ?x) (ready)) (:constants a b)
        (:action go :precondition (ready) :effect (not (p b)))
        (:action arm :precondition (p a) :effect (ready))";
    let belief = json!([["(p b)"], ["(ready)"]]);
    let text = document(domain, "(p b)", &json!({"initial_belief": belief, "sensor": "{name}"}));
    let problem = Document::parse(&text).unwrap().problem().unwrap();
    let states = problem.observers()[0].initial_belief.listed().unwrap();
    assert_eq!(states.len(), 2);
    assert_ne!(states[0], states[1]);
}

#[test]
fn results_that_never_change_are_known() {
    for (init, result, expected) in [
        // Always true, never true, made true while it was true anyway.
        ("(p b)", "(p b)", "no error"),
        ("(p a)", "(p a)", "no error"),
        ("", "(not (p b))", "no error"),
        ("", "(p a)", "no error"),
        (
            "",
            "(p b)",
            "observers.adversarial.sensor: found no symbol for (go) in every resulting state, expected rules whose results leave none out, or a last one without a result",
        ),
    ] {
        let sensor = json!([{"operator": "*", "result": result, "symbol": "x"}]);
        let text = document(GO, init, &json!({"sensor": sensor}));
        assert_eq!(message(&text), expected, "{init} {result}");
    }
}

#[test]
fn rules_that_fit_no_operator_and_patterns_with_a_shared_dash() {
    let place = "/observers/adversarial/sensor/0/operator";
    let table = [
        (
            Put(place, "\"(walk hall hall)\""),
            "observers.adversarial.sensor[0].operator: found \"(walk hall hall)\", which fits no operator, expected a rule that some operator fits",
        ),
        (
            Put(place, "\"(take ?y ?y)\""),
            "observers.adversarial.sensor[0].operator: found \"(take ?y ?y)\", which fits no operator, expected a rule that some operator fits",
        ),
        (
            Put(place, "\"(walk ?x ?x - room)\""),
            "observers.adversarial.sensor[0].operator: found \"(walk ?x ?x - room)\", which fits no operator, expected a rule that some operator fits",
        ),
        (
            Put(place, "\"(walk ?x - room ?x - room)\""),
            "observers.adversarial.sensor[0].operator, line 1, column 22: found a type behind \"?x\" for the second time, expected none there",
        ),
        (
            Put("/observers/cooperative/initial_belief/1/add/0", "\"(not (at hall))\""),
            "observers.cooperative.initial_belief[1].add[0], line 1, column 1: found \"(not …)\", expected an atom, as in (on a b)",
        ),
    ];
    check(example(), &table);
    // A word that stands twice under one dash, and operators that no state of this task allows.
    let domain = "(:predicates (p ?x) (never)) (:constants a b)
        (:action go :effect (p a))
        (:action same :parameters (?x ?y) :effect (p ?x))
        (:action fly :parameters (?x) :precondition (never) :effect (never))";
    for rule in ["(same ?x ?x - object)", "(fly a)", "fly"] {
        let sensor = json!([{"operator": rule, "symbol": "x"}, {"operator": "*", "symbol": "y"}]);
        assert_eq!(
            message(&document(domain, "", &json!({"sensor": sensor}))),
            "no error",
            "{rule}"
        );
    }
    let differs = "(:predicates (p ?x)) (:constants a b)
        (:action swap :parameters (?x ?y) :precondition (not (= ?x ?y)) :effect (p ?x))";
    for (rule, fits) in [("(swap a a)", false), ("(swap a b)", true), ("(swap ?x ?x)", false)] {
        let sensor = json!([{"operator": rule, "symbol": "x"}, {"operator": "*", "symbol": "y"}]);
        let found = message(&document(differs, "", &json!({"sensor": sensor})));
        assert_eq!(found == "no error", fits, "{rule}: {found}");
    }
}
