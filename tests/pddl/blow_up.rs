//! Tasks that would never fit: each meets a limit that is named, after a bounded amount of work.

use mo_copp::pddl::{ExtraInputs, GroundError, ground, read_domain, read_task};

fn numbered(count: usize, piece: &str) -> String {
    (0..count).map(|number| format!(" {piece}{number}")).collect()
}

/// The error of a domain with one action, over so many objects.
fn error(predicates: &str, action: &str, objects: usize, init: &str) -> GroundError {
    let domain = format!("(define (domain d) (:predicates {predicates}) (:action a {action}))");
    let domain = read_domain(&domain).unwrap();
    let task = format!(
        "(define (problem p) (:domain d) (:objects {}) (:init {init}) (:goal (q o0)))",
        numbered(objects, "o")
    );
    let task = read_task(&domain, &task).unwrap();
    ground(&domain, &task, &ExtraInputs::default()).map(|_| ()).unwrap_err()
}

#[test]
fn twelve_parameters_over_a_hundred_objects() {
    let parameters = numbered(12, "?x");
    let action = format!(":parameters ({parameters}) :effect (q ?x0)");
    let found = error("(q ?x)", &action, 100, "");
    assert_eq!(found.to_string(), "grounding limit reached: 1000000 operators");
    // The same where each parameter has a precondition, and where all must differ.
    let all: String = (0..12).map(|number| format!(" (p ?x{number})")).collect();
    let init: String = (0..100).map(|number| format!(" (p o{number})")).collect();
    let typed = format!(":parameters ({parameters}) :precondition (and {all}) :effect (q ?x0)");
    let found = error("(p ?x) (q ?x)", &typed, 100, &init);
    assert_eq!(found.to_string(), "grounding limit reached: 1000000 operators");
    let unequal: String = (1..12).map(|n| format!(" (not (= ?x{n} ?x{}))", n - 1)).collect();
    let differ =
        format!(":parameters ({parameters}) :precondition (and {all} {unequal}) :effect (q ?x0)");
    let found = error("(p ?x) (q ?x)", &differ, 100, &init);
    assert_eq!(found.to_string(), "grounding limit reached: 1000000 operators");
}

#[test]
fn every_parameter_that_is_allowed() {
    let action = format!(":parameters ({}) :effect (q ?x0)", numbered(64, "?x"));
    let found = error("(q ?x)", &action, 1000, "");
    assert_eq!(found.to_string(), "grounding limit reached: 1000000 operators");
}

/// Thirteen blocks of objects that must all differ, two too few of them: nothing is found however
/// long one looks.
#[test]
fn a_search_for_nothing() {
    let count = 13;
    let pairs = (0..count).flat_map(|one| (0..one).map(move |other| (one, other)));
    let unequal: String =
        pairs.map(|(one, other)| format!(" (not (= ?x{one} ?x{other}))")).collect();
    let action = format!(
        ":parameters ({}) :precondition (and {unequal}) :effect (q ?x0)",
        numbered(count, "?x")
    );
    let found = error("(q ?x)", &action, count - 1, "");
    assert!(matches!(found, GroundError::Steps { .. }), "{found}");
}

/// Twelve objects that must all differ, of eleven: the work is bounded, and about a second.
#[test]
fn a_search_for_nothing_ends_soon() {
    let count = 12;
    let pairs = (0..count).flat_map(|one| (0..one).map(move |other| (one, other)));
    let unequal: String =
        pairs.map(|(one, other)| format!(" (not (= ?x{one} ?x{other}))")).collect();
    let action = format!(
        ":parameters ({}) :precondition (and {unequal}) :effect (q ?x0)",
        numbered(count, "?x")
    );
    let found = error("(q ?x)", &action, count - 1, "");
    assert_eq!(
        found.to_string(),
        "grounding limit reached: 100000000 atoms and inequalities tried against preconditions"
    );
}

/// Many literals in many operators.
#[test]
fn literals_in_all() {
    let parameters = numbered(3, "?x");
    let effect: String = (0..900)
        .map(|number| format!(" (p{number} ?x{} ?x{})", number % 3, (number + 1) % 3))
        .collect();
    let predicates: String = (0..900).map(|number| format!(" (p{number} ?x ?y)")).collect();
    let action = format!(":parameters ({parameters}) :effect (and (q ?x0) {effect})");
    let found = error(&format!("(q ?x) {predicates}"), &action, 60, "");
    assert!(matches!(found, GroundError::Literals { .. } | GroundError::Atoms { .. }), "{found}");
}
