//! What is read, and what each mistake is answered with.

use mo_copp::pddl::{read_condition, read_domain, read_state, read_task};

use super::{BLOCKS, THREE_BLOCKS};

/// A domain with a bit of everything.
const DOMAIN: &str = "(define (domain Depot)
 (:requirements :STRIPS :typing :equality :negative-preconditions)
 (:types truck crane - machine machine box place - object heavy - box)
 (:constants HQ - place)
 (:predicates (at ?x - (either machine box) ?p - place) (ready ?m - machine)
              (road ?from ?to - place) (labelled ?x))
 (:action drive :parameters (?t - truck ?from ?to - place)
  :precondition (and (at ?t ?from) (road ?from ?to) (not (= ?to HQ)))
  :effect (and (not (at ?t ?from)) (at ?t ?to))))";

const TASK: &str = "(define (problem small) (:domain depot)
 (:objects t - truck a - place b - heavy)
 (:init (at t hq) (at b a) (road HQ a) (not (ready t)))
 (:goal (and (at t a) (not (ready t)) (= t T))))";

fn domain_error(text: &str) -> String {
    read_domain(text).map_or_else(|error| error.to_string(), |_| "no error".to_owned())
}

fn task_error(text: &str) -> String {
    let domain = read_domain(DOMAIN).unwrap();
    read_task(&domain, text).map_or_else(|error| error.to_string(), |_| "no error".to_owned())
}

#[test]
fn a_domain_with_a_bit_of_everything() {
    let domain = read_domain(DOMAIN).unwrap();
    assert_eq!(domain.name, "depot");
    let types = &domain.types;
    let named = |name| types.named(name).unwrap();
    assert!(types.alone(named("machine")).contains(named("truck")));
    assert!(types.alone(named("object")).contains(named("heavy")));
    assert!(!types.alone(named("machine")).contains(named("box")));
    let task = read_task(&domain, TASK).unwrap();
    assert_eq!((task.name.as_str(), task.domain.as_str()), ("small", "depot"));
    let names: Vec<_> = task.objects.ids().map(|id| task.objects.name(id)).collect();
    assert_eq!(names, ["hq", "t", "a", "b"]);
    assert_eq!(task.initial.len(), 3);
    assert_eq!((task.goal.positive.len(), task.goal.negative.len()), (1, 1));
    assert!(!task.goal.is_false);
    let condition = read_condition(&domain, &task, "(and (at t a) (not (= t t)))").unwrap();
    assert!(condition.is_false);
    assert!(read_condition(&domain, &task, "()").unwrap().positive.is_empty());
    assert_eq!(read_state(&domain, &task, "(at b a) (at t hq) (at B A)").unwrap().len(), 2);
}

#[test]
fn what_other_writers_do() {
    // No requirements, types or parts of actions; an equality declared; a length; old sections in
    // any order; names with digits first; nested conjunctions.
    let domain = read_domain(
        "(define (domain 2d) (:action go :parameters (?x) :effect (and (and (p ?x)) (and)))
           (:action rest) (:action wait :parameters () :precondition () :effect ())
           (:predicates (p ?x - object) (= ?x ?y)) (:types thing - object object))",
    )
    .unwrap();
    let task = read_task(
        &domain,
        "(define (problem 1) (:goal (p 0)) (:length (:serial 3)) (:objects 0 1) (:domain other))",
    )
    .unwrap();
    assert!(task.initial.is_empty());
    assert_eq!(task.domain, "other");
    assert!(read_domain(&BLOCKS.to_uppercase()).is_ok());
    let domain = read_domain(BLOCKS).unwrap();
    assert!(read_task(&domain, &THREE_BLOCKS.replace('\n', "\r\n")).is_ok());
}

#[test]
fn mistakes_in_a_domain() {
    let replaced = |from: &str, to: &str| {
        assert!(DOMAIN.contains(from), "{from}");
        domain_error(&DOMAIN.replacen(from, to, 1))
    };
    let read = "what docs/pddl.md lists: STRIPS, :adl, :typing, :action-costs";
    let cases = [
        ("(define", "(defin", "line 1, column 2: found \"defin\", expected (define (domain …) …)"),
        (
            "(domain Depot)",
            "(problem Depot)",
            "line 1, column 9: found \"(problem …)\", expected (domain …)",
        ),
        (
            ":equality",
            ":fluents",
            &format!(
                "line 2, column 33: found the unsupported requirement \":fluents\", expected {read}"
            ),
        ),
        (
            ":equality",
            "equality",
            "line 2, column 33: found \"equality\", expected a requirement, as in :strips",
        ),
        (
            "machine box place - object",
            "object - box place - object",
            "line 3, column 32: found \"object\" with a type of its own, expected none",
        ),
        (
            "heavy - box",
            "heavy - box box - heavy",
            "line 3, column 40: found the type \"box\", which is below itself, expected no circle of types",
        ),
        (
            "crane - machine machine box place - object",
            "crane - machine machine - crane box place - object",
            "line 3, column 16: found the type \"crane\", which is below itself, expected no circle of types",
        ),
        (
            "heavy - box)",
            "heavy -)",
            "line 3, column 65: found a dash at the end of a list, expected a type behind it",
        ),
        (
            "HQ - place",
            "HQ - plaice",
            "line 4, column 19: found the undeclared type \"plaice\", expected a type of the domain: object, truck, machine, crane, box, place, heavy",
        ),
        (
            "HQ - place",
            "HQ hq",
            "line 4, column 17: found the object \"hq\" for the second time, expected each object and constant declared once",
        ),
        (
            "HQ - place",
            "?hq",
            "line 4, column 14: found \"?hq\", expected the name of an object of letters, digits, - and _",
        ),
        ("HQ - place", "(HQ)", "line 4, column 14: found \"(HQ)\", expected the name of an object"),
        (
            "HQ - place",
            "- place",
            "line 4, column 14: found \"-\", expected a name before the dash",
        ),
        (
            "(either machine box)",
            "(either)",
            "line 5, column 24: found \"(either)\", expected a type or (either …)",
        ),
        (
            "(labelled ?x)",
            "(labelled x)",
            "line 6, column 50: found \"x\", expected a variable, as in ?x",
        ),
        (
            "(labelled ?x)",
            "(ready ?x)",
            "line 6, column 41: found the predicate \"ready\" for the second time, expected each predicate declared once",
        ),
        (
            "(labelled ?x)",
            "labelled",
            "line 6, column 40: found \"labelled\", expected a predicate, as in (on ?x ?y)",
        ),
        (
            "?from ?to - place)\n  :pre",
            "?from ?from - place)\n  :pre",
            "line 7, column 47: found the parameter \"?from\" for the second time, expected each parameter declared once",
        ),
        (
            ":precondition",
            ":condition",
            "line 8, column 3: found \":condition\", which needs :durative-actions, expected what docs/pddl.md lists: STRIPS, :adl, :typing, :action-costs",
        ),
        (
            ":precondition",
            ":preconditoin",
            "line 8, column 3: found \":preconditoin\", expected :parameters, :precondition or :effect",
        ),
        (
            ":effect",
            ":precondition",
            "line 9, column 3: found \":precondition\" for the second time, expected each part of an action once",
        ),
        (
            "(at ?t ?from) (road",
            "(at ?t) (road",
            "line 8, column 22: found \"(at …)\" with 1 argument, expected 2 arguments for at",
        ),
        (
            "(at ?t ?from) (road",
            "(at ?t ?from ?to) (road",
            "line 8, column 22: found \"(at …)\" with 3 arguments, expected 2 arguments for at",
        ),
        (
            "(at ?t ?from) (road",
            "(at ?from ?from) (road",
            "line 8, column 26: found \"?from\" of the type place, expected either machine, box as argument 1 of at",
        ),
        (
            "(at ?t ?from) (road",
            "(at ?t ?form) (road",
            "line 8, column 29: found the undeclared variable \"?form\", expected a parameter: ?t, ?from, ?to",
        ),
        (
            "(at ?t ?from) (road",
            "(at ?t HQ2) (road",
            "line 8, column 29: found the undeclared object \"HQ2\", expected an object or a constant: hq",
        ),
        (
            "(at ?t ?from) (road",
            "(is ?t ?from) (road",
            "line 8, column 23: found the undeclared predicate \"is\", expected a predicate of the domain: at, ready, road, labelled",
        ),
        (
            "(at ?t ?from) (road",
            "(or (att ?t ?from)) (road",
            "line 8, column 27: found the undeclared predicate \"att\", expected a predicate of the domain: at, ready, road, labelled",
        ),
        (
            "(at ?t ?from) (road",
            "(forall ?x (at ?x ?from)) (road",
            "line 8, column 30: found \"?x\", expected a list of variables, as in (?x - block)",
        ),
        (
            "(at ?t ?from) (road",
            "(exists (?x) (at ?y ?from)) (road",
            "line 8, column 39: found the undeclared variable \"?y\", expected a parameter: ?t, ?from, ?to, ?x",
        ),
        (
            "(at ?t ?from) (road",
            "(imply (ready ?t)) (road",
            "line 8, column 22: found \"(imply …)\", expected (imply …) with two conditions",
        ),
        (
            "(at ?t ?from) (road",
            "(not (and (ready ?x))) (road",
            "line 8, column 39: found the undeclared variable \"?x\", expected a parameter: ?t, ?from, ?to",
        ),
        (
            "(at ?t ?from) (road",
            "(not (not (ready))) (road",
            "line 8, column 32: found \"(ready)\" with no argument, expected 1 argument for ready",
        ),
        (
            "(at ?t ?from) (road",
            "(not) (road",
            "line 8, column 22: found \"(not)\", expected (not …) with one condition",
        ),
        (
            "(at ?t ?from) (road",
            "(= ?t) (road",
            "line 8, column 22: found \"(= …)\" with 1 argument, expected (= …) with two arguments",
        ),
        (
            "(at ?t ?from) (road",
            "(>= (fuel ?t) 1) (road",
            &format!(
                "line 8, column 22: found \"(>= …)\", which needs :numeric-fluents, expected {read}"
            ),
        ),
        (
            "(at ?t ?from) (road",
            "?t (road",
            "line 8, column 22: found \"?t\", expected a literal, as in (on ?x ?y) or (not (on ?x ?y)), or (and …)",
        ),
        (
            "(at ?t ?to)",
            "(when (ready ?t))",
            "line 9, column 36: found \"(when …)\", expected (when CONDITION EFFECT)",
        ),
        (
            "(at ?t ?to)",
            "(increase (total-cost) 1)",
            "line 9, column 47: found the undeclared function \"total-cost\", expected a function of the domain, which has none",
        ),
        (
            "(at ?t ?to)",
            "(= ?t ?to)",
            "line 9, column 36: found \"(= …)\", expected an effect, which cannot make things equal",
        ),
        (
            "(:action",
            "(:functions (cost) - block) (:action",
            "line 7, column 23: found a function of the type \"block\", which needs :object-fluents, expected functions of the type number",
        ),
        (
            "(:action",
            "(:durative-action",
            &format!(
                "line 7, column 2: found \"(:durative-action …)\", which needs :durative-actions, expected {read}"
            ),
        ),
        (
            "(:action",
            "(:derived",
            &format!(
                "line 7, column 2: found \"(:derived …)\", which needs :derived-predicates, expected {read}"
            ),
        ),
        (
            "(:action",
            "(:acton",
            "line 7, column 3: found \":acton\", expected a section: :requirements, :types, :constants, :predicates, :functions or :action",
        ),
        (
            "(:action",
            "(:action) (:action",
            "line 7, column 2: found an action without a name, expected (:action name …)",
        ),
        (
            "(:action",
            "(:action drive) (:action",
            "line 7, column 18: found the action drive for the second time, expected each action declared once, or with the same parameters and cost",
        ),
        (
            "(:constants",
            "(:types) (:constants",
            "line 4, column 3: found \":types\" for the second time, expected each section once",
        ),
        (
            " (:action",
            " action (:action",
            "line 7, column 2: found \"action\", expected a section: :requirements, :types, :constants, :predicates, :functions or :action",
        ),
    ];
    let mut wrong = 0;
    for (from, to, expected) in cases {
        let found = replaced(from, to);
        if found != expected {
            wrong += 1;
            println!("{from} → {to}\n  found    {found}\n  expected {expected}");
        }
    }
    assert_eq!(wrong, 0);
    assert_eq!(
        domain_error(""),
        "line 1, column 1: found the end of the text, expected (define (domain …) …)"
    );
    assert_eq!(
        domain_error("; no more\n"),
        "line 2, column 1: found the end of the text, expected (define (domain …) …)"
    );
    assert_eq!(
        domain_error("(define (domain d)) x"),
        "line 1, column 21: found \"x\", expected the end of the text"
    );
    assert_eq!(
        domain_error("(define)"),
        "line 1, column 1: found \"(define)\", expected (domain …)"
    );
}

#[test]
fn mistakes_in_a_task() {
    let replaced = |from: &str, to: &str| {
        assert!(TASK.contains(from), "{from}");
        task_error(&TASK.replacen(from, to, 1))
    };
    let read = "what docs/pddl.md lists: STRIPS, :adl, :typing, :action-costs";
    let cases = [
        (
            "t - truck",
            "t - truck hq - place",
            "line 2, column 22: found the object \"hq\" for the second time, expected each object and constant declared once",
        ),
        (
            "t - truck",
            "t - (truck)",
            "line 2, column 16: found \"(truck)\", expected a type or (either …)",
        ),
        (
            "(at t hq)",
            "(at t b)",
            "line 3, column 15: found \"b\" of the type heavy, expected place as argument 2 of at",
        ),
        (
            "(at t hq)",
            "(at t ?x)",
            "line 3, column 15: found \"?x\", expected an object, no variable",
        ),
        (
            "(at t hq)",
            "(at t)",
            "line 3, column 9: found \"(at …)\" with 1 argument, expected 2 arguments for at",
        ),
        (
            "(at t hq)",
            "(ready)",
            "line 3, column 9: found \"(ready)\" with no argument, expected 1 argument for ready",
        ),
        (
            "(at t hq)",
            "(= (cost t) 3)",
            "line 3, column 9: found \"(= …)\", which needs :action-costs or :numeric-fluents, expected an atom, as in (on a b)",
        ),
        (
            "(at t hq)",
            "(at t hq) (at 5 (at t hq))",
            &format!(
                "line 3, column 19: found \"(at …)\", which needs :timed-initial-literals, expected {read}"
            ),
        ),
        (
            "(at t hq)",
            "(at 5.5 (not (at t hq)))",
            &format!(
                "line 3, column 9: found \"(at …)\", which needs :timed-initial-literals, expected {read}"
            ),
        ),
        (
            "(at t hq)",
            "(at 5 hq)",
            "line 3, column 13: found the undeclared object \"5\", expected an object or a constant: hq, t, a, b",
        ),
        (
            "(at t hq)",
            "(and (at t hq))",
            "line 3, column 10: found the undeclared predicate \"and\", expected a predicate of the domain: at, ready, road, labelled",
        ),
        (
            "(at t hq)",
            "(ready t)",
            "line 3, column 40: found \"(not …)\" beside the atom itself, expected one of them",
        ),
        ("(at t hq)", "at", "line 3, column 9: found \"at\", expected an atom, as in (on a b)"),
        (
            "(:goal",
            "(:goal (at t a)) (:goal",
            "line 4, column 20: found \":goal\" for the second time, expected each section once",
        ),
        (
            "(:goal",
            "(:metric minimize (total-cost)) (:goal",
            "line 4, column 20: found the undeclared function \"total-cost\", expected (total-cost) among the :functions of the domain",
        ),
        (
            "(:goal",
            "(:aim",
            "line 4, column 3: found \":aim\", expected a section: :domain, :requirements, :objects, :init, :goal or :metric",
        ),
        (
            "(and (at t a)",
            "(at t a) (and (at t a)",
            "line 4, column 18: found \"(and …)\", expected one condition in (:goal …)",
        ),
        (
            "(at t a)",
            "(at t c)",
            "line 4, column 20: found the undeclared object \"c\", expected an object or a constant: hq, t, a, b",
        ),
        (
            "(at t a)",
            "(forall (?x) (at t ?y))",
            "line 4, column 33: found the undeclared variable \"?y\", expected a parameter: ?x",
        ),
        (
            "(:domain depot)",
            "",
            "line 4, column 49: found the end of the text, expected (:domain …) in the task",
        ),
        (
            "(problem small)",
            "(domain small)",
            "line 1, column 9: found \"(domain …)\", expected (problem …)",
        ),
    ];
    let mut wrong = 0;
    for (from, to, expected) in cases {
        let found = replaced(from, to);
        if found != expected {
            wrong += 1;
            println!("{from} → {to}\n  found    {found}\n  expected {expected}");
        }
    }
    assert_eq!(wrong, 0);
    let without_goal = TASK.split(" (:goal").next().unwrap().to_owned() + ")";
    assert_eq!(
        task_error(&without_goal),
        "line 4, column 2: found the end of the text, expected (:goal …) in the task"
    );
}

#[test]
fn a_timed_literal_is_named_where_at_is_no_predicate() {
    let domain = read_domain("(define (domain d) (:predicates (lit)))").unwrap();
    let task = "(define (problem p) (:domain d) (:init (at 5 (lit))) (:goal (lit)))";
    let error = read_task(&domain, task).map(|_| ()).unwrap_err().to_string();
    assert!(error.contains("which needs :timed-initial-literals"), "{error}");
}

#[test]
fn deep_and_large_texts() {
    const SIZE: usize = 32 << 20;
    let deep = "(".repeat(100_000);
    assert!(domain_error(&deep).contains("nested more than 64 deep"));
    let deep = format!("{}{}", "(and ".repeat(100_000), ")".repeat(100_000));
    assert!(domain_error(&deep).contains("nested more than 64 deep"));
    let large = " ".repeat((32 << 20) + 1);
    assert_eq!(
        domain_error(&large),
        "line 1, column 1: found 33,554,433 bytes of text, expected at most 32 MiB (33,554,432 bytes)"
    );
    // As large as it may be, and nothing but symbols, lists, a long name, types, objects.
    let filled = |begin: &str, piece: &str, end: &str| {
        let count = (SIZE - begin.len() - end.len()) / piece.len();
        format!("{begin}{}{end}", piece.repeat(count))
    };
    assert!(domain_error(&filled("", "a ", "")).contains("expected (define"));
    assert!(domain_error(&filled("", "()", "")).contains("expected (define"));
    assert_eq!(domain_error(&filled("(define (domain d) (:types ", "a", "))")), "no error");
    assert!(
        domain_error(&filled("(define (domain d) (:types ", "a ", "))"))
            .contains("more than 4096 names of types")
    );
    assert!(
        domain_error(&filled("(define (domain d) (:predicates ", "(p)", "))"))
            .contains("second time")
    );
    assert!(
        domain_error(&filled(
            "(define (domain d) (:types a) (:constants b - (either ",
            "a ",
            ")))"
        ))
        .contains("more than 256 types")
    );
    let many: String = (0..1100).map(|number| format!(" t{number}")).collect();
    let error = domain_error(&format!("(define (domain d) (:types {many}))"));
    assert!(error.contains("found more than 1024 types, expected at most that"), "{error}");
    let chain: String = (0..1000).map(|number| format!(" t{number} - t{}", number + 1)).collect();
    assert!(read_domain(&format!("(define (domain d) (:types {chain}))")).is_ok());
    let circle = chain + " t1000 - t0";
    let error = domain_error(&format!("(define (domain d) (:types {circle}))"));
    assert!(error.contains("which is below itself"), "{error}");
    let literals = "(p) ".repeat(1001);
    let error = domain_error(&format!(
        "(define (domain d) (:predicates (p)) (:action a :precondition (and {literals})))"
    ));
    assert!(error.contains("found 1001 literals, expected at most 1000 in one action"), "{error}");
    let parameters: String = (0..65).map(|number| format!(" ?x{number}")).collect();
    let error =
        domain_error(&format!("(define (domain d) (:action a :parameters ({parameters})))"));
    assert!(error.contains("found more than 64 parameters, expected at most that"), "{error}");
}
