//! `mo-copp plan`: the baseline on plain PDDL.

use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

use serde_json::json;

use super::{Ran, mo_copp};

const DOMAIN: &str = "(define (domain lamps) (:predicates (near ?x) (lit ?x))
  (:action GO :parameters (?a ?b) :precondition (near ?a) :effect (and (near ?b) (not (near ?a))))
  (:action light :parameters (?a) :precondition (near ?a) :effect (lit ?a)))";

const TASK: &str = "(define (problem two) (:domain lamps) (:objects A b)
  (:init (near a)) (:goal (and (lit b) (near b))))";

/// Tests run at the same time: each text gets a folder of its own.
fn file(name: &str, text: &str) -> String {
    static FILES: AtomicUsize = AtomicUsize::new(0);
    let number = FILES.fetch_add(1, Ordering::Relaxed).to_string();
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("plan").join(number);
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join(name);
    std::fs::write(&path, text).unwrap();
    path.to_string_lossy().into_owned()
}

/// Runs it on a task that comes on the standard input.
fn plan(domain: &str, task: &str, more: &[&str]) -> Ran {
    mo_copp(task, &[&["plan", &file("domain.pddl", domain), "-"], more].concat())
}

#[test]
fn one_operator_a_line() {
    let ran = plan(DOMAIN, TASK, &[]);
    assert_eq!((ran.code, ran.out.as_str()), (0, "(go a b)\n(light b)\n"));
    assert!(ran.err.starts_with("mo-copp: solved: 2 actions; "), "{}", ran.err);
    let task = file("task.pddl", TASK);
    assert_eq!(mo_copp(DOMAIN, &["plan", "-", &task]).out, ran.out);
    let nothing = plan(DOMAIN, &TASK.replace("(and (lit b) (near b))", "(near a)"), &[]);
    assert_eq!((nothing.code, nothing.out.as_str()), (0, ""));
}

#[test]
fn one_object() {
    let ran = plan(DOMAIN, TASK, &["--json"]);
    let answer = ran.json();
    assert_eq!((ran.code, &answer["status"]), (0, &json!("solved")));
    assert_eq!(answer["plan"], json!(["(go a b)", "(light b)"]));
    let stats = &answer["stats"];
    assert_eq!((&stats["facts"], &stats["operators"]), (&json!(4), &json!(6)));
    assert!(stats["expansions"].as_u64() >= Some(2) && stats["search_seconds"].is_f64());
    let mut keys: Vec<&String> = answer.as_object().unwrap().keys().collect();
    keys.sort_unstable();
    assert_eq!(keys, ["plan", "stats", "status"]);
}

#[test]
fn no_plan_and_limits() {
    // One match for two lamps: only the search can tell. The other goal is never met.
    let light = ":precondition (near ?a) :effect (lit ?a)";
    let once = ":precondition (and (near ?a) (match)) :effect (and (lit ?a) (not (match)))";
    let domain = DOMAIN.replace(light, once).replace("(lit ?x))", "(lit ?x) (match))");
    for goal in ["(and (lit a) (lit b))", "(= a b)"] {
        let task =
            TASK.replace("(and (lit b) (near b))", goal).replace("(near a)", "(near a) (match)");
        let ran = plan(&domain, &task, &["--json"]);
        let answer = ran.json();
        assert_eq!((ran.code, &answer["status"]), (1, &json!("infeasible")), "{goal}");
        assert_eq!(answer["plan"], json!(null));
    }
    let ran = plan(DOMAIN, TASK, &["--expansion-limit", "0", "--json"]);
    let answer = ran.json();
    assert_eq!((ran.code, &answer["status"], &answer["plan"]), (3, &json!("limit"), &json!(null)));
    assert_eq!(answer["limit"], json!("expansion limit reached: 0"));
    // What would never fit is a limit too, and no error.
    let parameters: Vec<String> = (0..12).map(|number| format!("?x{number}")).collect();
    let parameters = parameters.join(" ");
    let domain = DOMAIN.replace(
        "(?a) :precondition (near ?a) :effect (lit ?a)",
        &format!("({parameters}) :effect (lit ?x0)"),
    );
    let objects: Vec<String> = (0..100).map(|number| format!("o{number}")).collect();
    let objects = objects.join(" ");
    let ran = plan(&domain, &TASK.replace("A b", &format!("a b {objects}")), &[]);
    assert_eq!((ran.code, ran.out.as_str()), (3, ""));
    assert!(ran.err.contains("grounding limit reached: 1000000 operators"), "{}", ran.err);
}

#[test]
fn bad_texts_have_a_file_a_line_and_a_column() {
    let bad = |domain: &str, task: &str| {
        let ran = plan(domain, task, &[]);
        assert_eq!((ran.code, ran.out.as_str()), (2, ""));
        ran.err
    };
    let error = bad(&DOMAIN.replace("(lit ?x)", "(lid ?x)"), TASK);
    assert!(
        error.contains("domain.pddl: line 3, column 68: found the undeclared predicate \"lit\", expected a predicate of the domain: near, lid"),
        "{error}"
    );
    let error = bad(DOMAIN, &TASK.replace("(near a)", "(near c)"));
    assert!(error.contains("-: line 2, column 16: found the undeclared object \"c\""), "{error}");
    let error = bad(&DOMAIN.replace(":effect (lit ?a)", ":effect (assign (near ?a) 3)"), TASK);
    assert!(error.contains("which needs :numeric-fluents"), "{error}");
    let missing = mo_copp(TASK, &["plan", "no-such-file.pddl", "-"]);
    assert_eq!(missing.code, 2);
    assert!(missing.err.contains("no-such-file.pddl"), "{}", missing.err);
    // A task of another domain is planned all the same: tasks in circulation are careless there.
    let other = plan(DOMAIN, &TASK.replace("lamps", "bulbs"), &[]);
    assert_eq!(other.code, 0);
    assert!(other.err.contains("is a task of the domain bulbs"), "{}", other.err);
}
