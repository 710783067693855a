//! Import of competition tasks: candidate goals by permutation, and what has too few of them.

use std::collections::BTreeSet;

use mo_copp::domain::Document;
use mo_copp::domain::pddl::import::{
    CandidateOptions, ImportFile, ImportOptions, Imported, import_task,
};
use mo_copp::problem::Problem;

/// A truck brings packages to places; without types, as in 1998. No road leads to the island.
const DOMAIN: &str = "(define (domain van) (:requirements :strips)
 (:predicates (package ?x) (place ?x) (road ?x ?y) (van ?x) (at ?x ?y) (in ?x))
 (:action load :parameters (?p ?x) :precondition (and (package ?p) (at ?p ?x) (at van ?x))
  :effect (and (in ?p) (not (at ?p ?x))))
 (:action unload :parameters (?p ?x) :precondition (and (in ?p) (at van ?x))
  :effect (and (at ?p ?x) (not (in ?p))))
 (:action drive :parameters (?x ?y) :precondition (and (at van ?x) (road ?x ?y))
  :effect (and (at van ?y) (not (at van ?x))))
 (:constants van))";
const INITIAL: &str =
    "(van van) (place here) (place there) (place island) (package a) (package b) (package c)
 (road here there) (road there here) (at van here) (at a here) (at b here) (at c there)";

fn task(goal: &str) -> String {
    format!(
        "(define (problem p) (:domain van)\n (:objects a b c here there island)\n (:init {INITIAL})\n (:goal {goal}))"
    )
}

fn import(domain: &str, task: &str, candidates: usize, seed: u64) -> Result<Imported, String> {
    let file = |name: &str, text: &str| ImportFile { name: name.to_owned(), text: text.to_owned() };
    let candidates = CandidateOptions { candidates, seed };
    let (domain, task) = (file("domain.pddl", domain), file("p01.pddl", task));
    import_task(&domain, &task, &ImportOptions::default(), candidates)
        .map_err(|error| error.to_string())
}

fn goals(imported: &Imported) -> Vec<&str> {
    imported.document.goals.iter().map(|goal| goal.condition.as_str()).collect()
}

/// The document is one that is read again, and makes a problem.
fn loads(imported: Imported) -> Problem {
    let document = Document::from(imported.document);
    assert_eq!(Document::parse(&document.to_json()).unwrap(), document);
    document.problem().unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn the_goal_of_the_task_is_the_true_one_and_others_have_its_objects_in_other_places() {
    let text = task("(and (at a there) (at b here) (at c there) (not (in a)))");
    let found = import(DOMAIN, &text, 5, 1).unwrap();
    assert_eq!(goals(&found)[0], "(and (at a there) (at b here) (at c there) (not (in a)))");
    let names: Vec<&str> = found.document.goals.iter().map(|goal| goal.name.as_str()).collect();
    assert_eq!(names, ["G1", "G2", "G3", "G4", "G5"]);
    assert_eq!(found.document.true_goal, "G1");
    // Packages change places with packages and places with places. Goals that hold at the start are not taken.
    let mut all = BTreeSet::new();
    for seed in 0..200 {
        let found = import(DOMAIN, &text, 5, seed).unwrap();
        let distinct: BTreeSet<String> = goals(&found).into_iter().map(str::to_owned).collect();
        assert_eq!(distinct.len(), 5);
        all.extend(distinct);
    }
    let mut expected = BTreeSet::new();
    for (alone, others) in [("a", ["b", "c"]), ("b", ["a", "c"]), ("c", ["a", "b"])] {
        for (there, here) in [("there", "here"), ("here", "there")] {
            // One package is elsewhere than the two others, of which one is not in the van.
            let at =
                |package| format!("(at {package} {})", if package == alone { here } else { there });
            let atoms = ["a", "b", "c"].map(at).join(" ");
            let goal = |other| format!("(and {atoms} (not (in {other})))");
            expected.extend(others.map(goal));
        }
    }
    expected.retain(|goal| !goal.contains("(at a here) (at b here) (at c there)"));
    assert_eq!(expected.len(), 10);
    assert_eq!(all, expected);
    assert_eq!(loads(found).goals().len(), 5);
}

#[test]
fn the_same_seed_gives_the_same_goals_everywhere() {
    let text = task("(and (at a there) (at b here) (at c there))");
    let of = |seed| import(DOMAIN, &text, 4, seed).unwrap();
    assert_eq!(of(7), of(7));
    let expected = [
        "(and (at a there) (at b here) (at c there))",
        "(and (at a there) (at b here) (at c here))",
        "(and (at a there) (at b there) (at c here))",
        "(and (at a here) (at b there) (at c there))",
    ];
    assert_eq!(goals(&of(7)), expected);
}

#[test]
fn goals_that_hold_at_the_start_come_last_and_with_a_note() {
    // Of the six goals, one holds at the start: a and b here, c there.
    let text = task("(and (at a there) (at b here) (at c here))");
    let initial = "(and (at a here) (at b here) (at c there))";
    for seed in 0..50 {
        let five = import(DOMAIN, &text, 5, seed).unwrap();
        assert!(!goals(&five).contains(&initial));
        assert_eq!(five.notes, [""; 0]);
        let six = import(DOMAIN, &text, 6, seed).unwrap();
        assert_eq!(goals(&six)[5], initial);
        assert_eq!(six.notes, ["p01.pddl: the candidate goal G6 holds at the start"]);
    }
    let expected = "p01.pddl: found 6 different goals with other objects of the goal in their places, \
                    expected 7 candidate goals (--candidates)";
    assert_eq!(import(DOMAIN, &text, 7, 1).unwrap_err(), expected);
}

#[test]
fn goals_that_cannot_be_reached_are_left_out() {
    let text = task("(and (at a there) (at van here) (at b island))");
    let error = import(DOMAIN, &text, 2, 1).unwrap_err();
    assert!(error.contains("found no other goal with other objects"), "{error}");
    // With a road there are six ways in which a, the van and b are in three places.
    let text = text.replace("(:init ", "(:init (road here island) (road island here) ");
    assert_eq!(goals(&import(DOMAIN, &text, 6, 1).unwrap()).len(), 6);
}

#[test]
fn objects_of_one_type_change_places() {
    let domain = "(define (domain d) (:requirements :typing) (:types room key)
      (:predicates (in ?k - key ?r - room))
      (:action put :parameters (?k - key ?r - room) :effect (in ?k ?r)))";
    let text = "(define (problem p) (:domain d) (:objects r s - room k l - key) (:goal (and (in k r) (in l s))))";
    let found = import(domain, text, 2, 1).unwrap();
    assert_eq!(goals(&found), ["(and (in k r) (in l s))", "(and (in k s) (in l r))"]);
    assert!(import(domain, text, 3, 1).unwrap_err().contains("found 2 different goals"));
}

#[test]
fn what_is_no_task_has_its_place() {
    let good = task("(at a there)");
    for (domain, task, candidates, expected) in [
        (DOMAIN, &*good, 1, "candidates: found 1, expected a whole number from 2 to 1024"),
        (DOMAIN, &good, 1025, "candidates: found 1025, expected a whole number from 2 to 1024"),
        ("(define (domain van)\n (:oops))", &good, 2, "domain.pddl:2:3: found \":oops\""),
        (DOMAIN, &task("(at a moon)"), 2, "p01.pddl:5:15: found the undeclared object \"moon\""),
        (
            DOMAIN,
            "(define (problem p) (:domain van))",
            2,
            "p01.pddl:1:35: found the end of the text",
        ),
        (
            DOMAIN,
            &good.replace("(:domain van)", "(:domain bus)"),
            2,
            "p01.pddl: found (:domain bus), expected \"van\", which is the name of the domain in domain.pddl",
        ),
        (
            DOMAIN,
            &task("(or (at a there) (at b there))"),
            2,
            "p01.pddl: found a goal with a disjunction, expected a conjunction of literals",
        ),
        (DOMAIN, &task("(and)"), 2, "p01.pddl: found no other goal"),
    ] {
        let error = import(domain, task, candidates, 1).unwrap_err();
        assert!(error.starts_with(expected), "{error}");
    }
}

/// Every classic task, where they are at hand.
#[test]
fn every_classic_task_is_imported_or_has_too_few_permutations() {
    let (mut imported, mut refused) = (0, 0);
    for (domain, number, domain_file, task_file) in crate::pddl::ipc::tasks("import of IPC tasks") {
        let text = |path: &std::path::Path| std::fs::read_to_string(path).unwrap();
        match import(&text(&domain_file), &text(&task_file), 5, 1) {
            Ok(found) => {
                let goals: BTreeSet<&str> = goals(&found).into_iter().collect();
                assert_eq!(goals.len(), 5, "{domain} {number}");
                let document = Document::from(found.document);
                assert_eq!(Document::parse(&document.to_json()).unwrap(), document);
                imported += 1;
            }
            Err(error) => {
                let few = ["found no other goal", "different goals with other objects"];
                assert!(few.iter().any(|few| error.contains(few)), "{domain} {number}: {error}");
                refused += 1;
            }
        }
    }
    if imported + refused > 0 {
        assert!(imported > 100, "{imported} imported, {refused} refused");
    }
}
