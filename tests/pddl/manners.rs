//! Small domains in the manner of the STRIPS sets of the planning competitions from 1998 to 2006,
//! in our own words: whatever their writers do is read, and solved.

use std::sync::Arc;

use mo_copp::limits::Limits;
use mo_copp::pddl::{read_domain, read_task};
use mo_copp::solver::{ClassicalRun, Status};

use super::grounded;

/// The baseline's plan; none where there is none.
fn plan(domain: &str, task: &str) -> Option<Vec<String>> {
    let task = Arc::new(grounded(domain, task).task);
    let mut run = ClassicalRun::new(Arc::clone(&task), Limits::default());
    while !run.advance(1000) {}
    let outcome = run.outcome().unwrap();
    let expected = if outcome.plan.is_some() { Status::Solved } else { Status::Infeasible };
    assert_eq!(outcome.status, expected);
    outcome.plan.map(|plan| plan.names(&task))
}

fn solved(domain: &str, task: &str, expected: &[&str]) {
    assert_eq!(plan(domain, task).unwrap(), expected);
}

fn domain_error(text: &str) -> String {
    read_domain(text).map_or_else(|error| error.to_string(), |_| "no error".to_owned())
}

/// As PSR and Trucks come: no parameters, no objects, capitals, an atom FOO that is never used, and
/// a requirement that nothing needs.
#[test]
fn a_domain_grounded_by_its_writers() {
    let domain = "(define (domain grounded-SWITCHES)
(:requirements
:strips
:derived-predicates
)
(:predicates
(FOO)
(CLOSED-S1)
(OPEN-S1)
(FED-L1)
)
(:action CLOSE-S1-0
:parameters ()
:precondition
(and
(OPEN-S1)
)
:effect
(and
(CLOSED-S1)
(FED-L1)
(not (OPEN-S1))
)
)
)";
    let task = "(define (problem grounded-1)
(:domain grounded-SWITCHES)
(:init
(FOO)
(open-s1)
)
(:goal
(and
(Fed-L1)
)
)
)";
    solved(domain, task, &["(close-s1-0)"]);
    solved(domain, &task.replace("(:init", "(:objects)\n(:init"), &["(close-s1-0)"]);
    let derived = domain.replace("(:action", "(:derived (FED-L1) (CLOSED-S1)) (:action");
    assert!(domain_error(&derived).contains("which needs :derived-predicates"));
}

/// As Storage comes: a type declared twice, below two others; one predicate for things of two kinds.
#[test]
fn a_type_below_two_others() {
    let domain = "(define (domain Yard)
(:requirements :typing)
(:types claw surface place spot - object
        shed - place
        inside outside - spot
        spot bale - surface)
(:predicates (free ?s - inside) (in ?x - (either inside bale) ?p - place)
             (at ?c - claw ?s - spot) (lies ?b - bale ?s - spot) (top ?s - surface)
             (beside ?a ?b - spot) (holds ?c - claw ?b - bale))
(:action grip :parameters (?c - claw ?b - bale ?s ?near - spot)
 :precondition (and (at ?c ?near) (beside ?near ?s) (lies ?b ?s) (top ?b))
 :effect (and (holds ?c ?b) (top ?s) (not (lies ?b ?s))))
(:action store :parameters (?c - claw ?b - bale ?s - inside ?near - spot ?p - place)
 :precondition (and (holds ?c ?b) (at ?c ?near) (beside ?near ?s) (free ?s) (in ?s ?p))
 :effect (and (lies ?b ?s) (in ?b ?p) (not (free ?s)) (not (holds ?c ?b)) (not (top ?s)))))";
    let task = "(define (problem one) (:domain Yard)
(:objects c - claw b - bale i - inside o l - outside s - shed)
(:init (at c o) (beside o l) (beside o i) (beside l o) (lies b l) (top b) (free i) (in i s))
(:goal (and (in b s))))";
    solved(domain, task, &["(grip c b l o)", "(store c b i o s)"]);
    let types = &read_domain(domain).unwrap().types;
    let named = |name| types.named(name).unwrap();
    for above in ["object", "surface", "spot"] {
        assert!(types.alone(named(above)).contains(named("inside")), "{above}");
    }
    assert!(!types.alone(named("place")).contains(named("inside")));
    let error = domain_error(
        &domain.replace("spot bale - surface", "spot bale - surface surface - inside"),
    );
    assert!(error.contains("which is below itself"), "{error}");
}

/// As Gripper, Miconic, Movie and Logistics come: types are predicates, requirements left out.
#[test]
fn untyped_with_predicates_for_types() {
    let domain = "(define (domain ferry-strips)
  (:predicates (car ?x) (port ?x) (at ?c ?p) (ferry-at ?p) (on ?c) (vacant) (rested))
  (:action sail :parameters (?a ?b)
    :precondition (and (port ?a) (port ?b) (ferry-at ?a))
    :effect (and (ferry-at ?b) (not (ferry-at ?a))))
  (:action board :parameters (?c ?p)
    :precondition (and (car ?c) (port ?p) (ferry-at ?p) (at ?c ?p) (vacant))
    :effect (and (on ?c) (not (at ?c ?p)) (not (vacant))))
  (:action land :parameters (?c ?p)
    :precondition (and (car ?c) (port ?p) (ferry-at ?p) (on ?c))
    :effect (and (at ?c ?p) (not (on ?c)) (vacant)))
  (:action rest :effect (rested)))";
    let task = "(define (problem ferry-1) (:domain ferry-strips)
  (:objects a b c1)
  (:init (port a) (port b) (car c1) (at c1 a) (at c1 a) (ferry-at b) (vacant))
  (:goal (AND (at c1 b) (rested)))
  (:length (:serial 4) (:parallel 4)))";
    let mut steps = plan(domain, task).unwrap();
    steps.retain(|step| step != "(rest)");
    assert_eq!(steps, ["(sail b a)", "(board c1 a)", "(sail a b)", "(land c1 b)"]);
    // The same with what may be said and need not be.
    let typed = domain
        .replace(
            "(:predicates",
            "(:requirements :strips) (:types object) (:constants) (:predicates",
        )
        .replace("(?a ?b)", "(?a - object ?b)")
        .replace(":effect (rested)", ":parameters () :precondition () :effect (and (rested))");
    assert_eq!(plan(&typed, &task.replace("a b c1", "a b - object c1")), plan(domain, task));
    // A goal of one literal, and one that is met already.
    solved(domain, &task.replace("(AND (at c1 b) (rested))", "(rested)"), &["(rest)"]);
    solved(domain, &task.replace("(AND (at c1 b) (rested))", "(and)"), &[]);
}

/// As Mystery and TPP come: stocks counted by objects in a row.
#[test]
fn numbers_that_are_objects() {
    let domain = "(define (domain tank) (:requirements :strips :typing :equality)
 (:types level place) (:constants empty - level)
 (:predicates (next ?less ?more - level) (fuel ?l - level) (at ?p - place) (road ?a ?b - place))
 (:action drive :parameters (?a ?b - place ?more ?less - level)
  :precondition (and (at ?a) (road ?a ?b) (fuel ?more) (next ?less ?more) (not (= ?a ?b)))
  :effect (and (at ?b) (not (at ?a)) (fuel ?less) (not (fuel ?more))))
 (:action tow :parameters (?a ?b - place) :precondition (and (fuel empty) (at ?a))
  :effect (and (not (at ?a)) (at ?b))))";
    let task = "(define (problem far) (:domain tank) (:requirements :typing)
 (:objects l1 l2 - level a b c - place)
 (:init (next empty l1) (next l1 l2) (fuel L2) (at a) (road a b) (road b c) (road a a))
 (:goal (at c)))";
    solved(domain, task, &["(drive a b l2 l1)", "(drive b c l1 empty)"]);
    assert_eq!(plan(domain, &task.replace("(fuel L2)", "")), None);
    // Nothing drives in a circle: the two places must differ.
    assert!(!grounded(domain, task).task.operators().iter().any(|operator| {
        grounded(domain, task).task.action_name(operator.action).starts_with("(drive a a")
    }));
}

/// As Pathways comes: what is not there is asked for, and what is chosen stays chosen.
#[test]
fn negation_in_preconditions_and_goals() {
    let domain = "(define (domain menu)
 (:requirements :strips :typing :negative-preconditions)
 (:types dish - object sweet salty - dish)
 (:predicates (served ?d - dish) (chosen ?d - dish) (closed) (full))
 (:action choose :parameters (?d - dish) :precondition (and (not (chosen ?d)) (not (closed)))
  :effect (chosen ?d))
 (:action serve :parameters (?d - dish)
  :precondition (and (chosen ?d) (not (served ?d)) (not (full))) :effect (and (served ?d) (full)))
 (:action wait :effect (not (full)))
 (:action close :effect (closed)))";
    let task = "(define (problem two) (:domain menu) (:objects pie - sweet egg - salty)
 (:init (not (closed)) (full))
 (:goal (and (served pie) (not (served egg)) (not (full)) (closed))))";
    let steps = plan(domain, task).unwrap();
    assert!(!steps.contains(&"(serve egg)".to_owned()));
    assert_eq!(steps.last().map(String::as_str).filter(|&step| step == "(serve pie)"), None);
    assert_eq!(
        plan(
            domain,
            &task.replace("(full))\n", "(full) (closed))\n").replace("(not (closed))", "")
        ),
        None
    );
}

/// Lines ended as on other systems, comments anywhere, names of every kind, dashes without a blank.
#[test]
fn ways_of_writing() {
    let domain = "; a comment (with a parenthesis\r\n(DEFINE (DOMAIN Odd_names) ;; more\r\n\
(:Requirements :STRIPS :Typing)\r\n(:TYPES room_2 -place b@ll)\r\n(:Predicates\r\n\
\t(at-p1@x ?B -B@LL ?r -room_2);at\r\n(2nd ?x - (EITHER b@ll room_2)))\r\n\
(:ACTION Move-it_1 :Parameters (?b -b@ll ?From ?TO - room_2)\r\n\
 :Precondition (AND (AT-P1@X ?B ?from)) :Effect (And (Not (at-p1@x ?b ?from)) (at-p1@x ?b ?to) (2ND ?b))))\r\n";
    let task = "(define (problem p-1.5+x)\r\n(:domain odd_NAMES)\r\n(:objects b1 -b@ll r#1 R&2 - Room_2)\r\n\
(:init (at-p1@x b1 R#1);the end\r\n)\r\n(:goal (and (at-p1@x B1 r&2))))\r\n";
    solved(domain, task, &["(move-it_1 b1 r#1 r&2)"]);
    // As one line, and with a mark before the text.
    let line = |text: &str| {
        let bare: Vec<&str> =
            text.lines().map(|line| line.split(';').next().unwrap_or_default()).collect();
        format!("\u{feff}{}", bare.join(" "))
    };
    solved(&line(domain), &line(task), &["(move-it_1 b1 r#1 r&2)"]);
}

/// Objects of several types, and types that are nothing but a list.
#[test]
fn either_everywhere() {
    let domain = "(define (domain mix) (:requirements :typing)
 (:types cup - object glass - object shelf)
 (:predicates (stands ?x - (either cup glass) ?s - shelf) (hung ?x - cup))
 (:action hang :parameters (?x - (either cup glass) ?s - shelf)
  :precondition (stands ?x ?s) :effect (and (not (stands ?x ?s)) (hung ?x))))";
    let task = "(define (problem p) (:domain mix)
 (:objects a - cup b - glass c - (either glass cup) s - shelf)
 (:init (stands a s) (stands b s) (stands c s)) (:goal (and (hung a) (hung c))))";
    let mut steps = plan(domain, task).unwrap();
    steps.sort_unstable();
    assert_eq!(steps, ["(hang a s)", "(hang c s)"]);
    let domain_read = read_domain(domain).unwrap();
    let error = read_task(&domain_read, &task.replace("(hung c)", "(hung b)")).unwrap_err();
    assert_eq!(
        error.to_string(),
        "line 3, column 76: found \"b\" of the type glass, expected cup as argument 1 of hung"
    );
}

/// A feature that is not read is refused by its name, wherever it is met first.
#[test]
fn features_of_other_sets() {
    let base = "(define (domain d) (:requirements :strips) (:types t) (:predicates (p ?x - t))
 (:action a :parameters (?x - t) :precondition (p ?x) :effect (not (p ?x))))";
    for (from, to) in [
        (":strips", ":strips :adl"),
        (":strips", ":action-costs"),
        (":strips", ":conditional-effects"),
        (":strips", ":quantified-preconditions"),
        ("(:predicates", "(:functions (total-cost) - number) (:predicates"),
        (":effect (not (p ?x))", ":effect (forall (?y - t) (not (p ?y)))"),
        (":effect (not (p ?x))", ":effect (when (p ?x) (not (p ?x)))"),
        (":precondition (p ?x)", ":precondition (or (p ?x))"),
        (":precondition (p ?x)", ":precondition (exists (?y - t) (p ?y))"),
        (":precondition (p ?x)", ":precondition (imply (p ?x) (p ?x))"),
    ] {
        assert!(base.contains(from), "{from}");
        assert_eq!(domain_error(&base.replacen(from, to, 1)), "no error", "{to}");
    }
    for (from, to, feature) in [
        (":strips", ":fluents", ":fluents"),
        (":strips", ":durative-actions", ":durative-actions"),
        (":strips", ":preferences", ":preferences"),
        (":effect (not (p ?x))", ":effect (and (increase (total-cost) 1))", "total-cost"),
        (":effect (not (p ?x))", ":effect (assign (f ?x) 1)", ":numeric-fluents"),
        (":precondition (p ?x)", ":precondition (preference q (p ?x))", ":preferences"),
        (":precondition (p ?x)", ":precondition (< (f ?x) 1)", ":numeric-fluents"),
        ("(:action a", "(:derived (p ?x) (p ?x)) (:action a", ":derived-predicates"),
        ("(:action a", "(:axiom :vars (?x) :context (p ?x)) (:action a", ":derived-predicates"),
    ] {
        assert!(base.contains(from), "{from}");
        let error = domain_error(&base.replacen(from, to, 1));
        assert!(error.starts_with("line ") && error.contains(feature), "{to}: {error}");
    }
    let domain = read_domain(base).unwrap();
    let task =
        "(define (problem q) (:domain d) (:objects o - t) (:init (p o)) (:goal (not (p o))))";
    assert!(read_task(&domain, task).is_ok());
    for (from, to, feature) in [
        ("(:init (p o))", "(:init (= (total-cost) 0))", ":action-costs"),
        ("(:goal", "(:metric minimize (total-cost)) (:goal", "total-cost"),
        ("(:goal", "(:metric minimize (fuel)) (:goal", ":numeric-fluents"),
        ("(:goal", "(:constraints (and)) (:goal", ":constraints"),
        ("(p o)))", "(preference x (p o))))", ":preferences"),
    ] {
        let error = read_task(&domain, &task.replacen(from, to, 1)).unwrap_err().to_string();
        assert!(error.starts_with("line 1, ") && error.contains(feature), "{to}: {error}");
    }
}

/// As Campus of the goal-recognition literature comes: an action declared for each place, with a cost.
#[test]
fn an_action_declared_for_several_places() {
    let domain = "(define (domain campus) (:requirements :strips :typing :action-costs) (:types place)
(:constants cafe library - place) (:predicates (at ?p - place) (met)) (:functions (total-cost) - number)
(:action move :parameters (?a ?b - place) :precondition (at ?a)
 :effect (and (not (at ?a)) (at ?b) (increase (total-cost) 2)))
(:action MEET :precondition (at cafe) :effect (and (met) (increase (total-cost) 1)))
(:action MEET :parameters () :precondition (at library) :effect (and (met) (increase (total-cost) 1))))";
    let task = "(define (problem p) (:domain campus) (:objects hall - place) (:init (at hall) (= (total-cost) 0))
(:goal (met)) (:metric minimize (total-cost)))";
    let plan = plan(domain, task).unwrap();
    assert_eq!(plan.last().unwrap(), "(meet)");
    let ground = grounded(domain, task).task;
    assert_eq!((ground.operators().len(), ground.action_count()), (9 + 2, 9 + 1));
    let plan = mo_copp::plan::Plan::from_names(&ground, &plan).unwrap();
    assert_eq!(plan.cost(&ground), Some(3));
    // Where two that do the same can apply at once, either is meant.
    let alike = domain.replace("(at library) :effect (and (met)", "(not (met)) :effect (and (met)");
    let found = self::plan(&alike, task).unwrap();
    assert_eq!(found, ["(meet)"]);
    // Where they do different things, it is said.
    let both = domain
        .replace("(at library) :effect (and (met)", "(not (met)) :effect (and (at library) (met)");
    let read = (read_domain(&both).unwrap(), read_domain(domain).unwrap());
    let task = read_task(&read.0, task).unwrap();
    let error =
        mo_copp::pddl::ground(&read.0, &task, &mo_copp::pddl::ExtraInputs::default()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "action (meet): it is declared several times, and more than one may apply in a state"
    );
}
