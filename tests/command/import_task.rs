//! `mo-copp import` of competition tasks, and benchmarks over them.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::{Ran, mo_copp};

const DOMAIN: &str = "(define (domain van)
 (:predicates (package ?p) (place ?x) (at ?p ?x))
 (:action carry :parameters (?p ?x ?y) :precondition (and (package ?p) (place ?y) (at ?p ?x))
  :effect (and (at ?p ?y) (not (at ?p ?x)))))";

/// A task whose goal has three objects that can change places.
fn task(goal: &str) -> String {
    format!(
        "(define (problem p) (:domain van) (:objects a b c h s t)
 (:init (package a) (package b) (package c) (place h) (place s) (place t) (at a h) (at b h) (at c h))
 (:goal {goal}))"
    )
}

const GOAL: &str = "(and (at a s) (at b t) (at c h))";

/// A folder with tasks, and one with a domain for one of them alone.
fn tasks(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("import-task").join(name);
    let _ = fs::remove_dir_all(&folder);
    for (path, text) in [
        ("general/domain.pddl", DOMAIN.to_owned()),
        ("general/p01.pddl", task(GOAL)),
        ("general/p02.pddl", task("(and (at a s) (at b t))")),
        ("numbered/domain01.pddl", DOMAIN.to_owned()),
        ("numbered/domain02.pddl", "(define (domain other))".to_owned()),
        ("numbered/p01.pddl", task(GOAL)),
        // No domain is beside it.
        ("alone/p01.pddl", task(GOAL)),
    ] {
        let path = folder.join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    folder
}

fn import(args: &[&Path], more: &[&str]) -> Ran {
    let args: Vec<&str> = args.iter().map(|path| path.to_str().unwrap()).collect();
    mo_copp("", &[&["import"], &args[..], more].concat())
}

#[test]
fn a_task_becomes_a_document_that_is_solved() {
    let folder = tasks("document").join("general");
    let (domain, task) = (folder.join("domain.pddl"), folder.join("p01.pddl"));
    let ran = import(&[&domain, &task], &["--candidates", "4", "--seed", "3"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let document: Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!(document["true_goal"], "G1");
    assert_eq!(
        document["goals"][0],
        json!({"name": "G1", "condition": "(and (at a s) (at b t) (at c h))"})
    );
    assert_eq!(document["goals"].as_array().unwrap().len(), 4);
    assert_eq!(document["observers"]["adversarial"]["sensor"], "{name}");
    let solved = mo_copp(&ran.out, &["solve", "-", "--solver", "exact", "--json"]);
    assert_eq!(solved.code, 0, "{}", solved.err);
    // With the domain beside the task, and into a file.
    let out = folder.join("p01.json");
    let options = ["--candidates", "4", "--seed", "3", "--out", out.to_str().unwrap()];
    assert_eq!(import(&[&task], &options).code, 0);
    assert_eq!(fs::read_to_string(&out).unwrap(), ran.out);
    // Five candidate goals of seed 1, unless told otherwise.
    let plain = import(&[&task], &[]);
    assert_eq!(plain.out, import(&[&task], &["--candidates", "5", "--seed", "1"]).out);
    assert_ne!(plain.out, import(&[&task], &["--seed", "2"]).out);
    // The sensors are options as ever.
    let seen =
        import(&[&task], &["--adversarial-sensor", "{arguments}", "--adversarial-group", "p=a,b"]);
    let seen: Value = serde_json::from_str(&seen.out).unwrap();
    assert_eq!(seen["observers"]["adversarial"]["sensor"], "{arguments}");
    assert_eq!(seen["observers"]["adversarial"]["groups"], json!({"p": ["a", "b"]}));
}

#[test]
fn a_folder_of_tasks_gives_a_document_for_each() {
    let folder = tasks("folder").join("general");
    let ran = import(&[&folder], &["--candidates", "2"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert_eq!(ran.out.lines().count(), 2);
    let out = folder.join("documents");
    // One has two goals and no more: the other is written, and the exit code says that one is missing.
    let ran = import(&[&folder], &["--out", out.to_str().unwrap()]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    let missing = "p02.pddl: found 2 different goals with other objects of the goal in their places, expected 5";
    assert!(ran.err.contains(missing), "{}", ran.err);
    let written = fs::read_to_string(out.join("p01.json")).unwrap();
    assert_eq!(written, import(&[&folder.join("p01.pddl")], &[]).out);
    assert!(!out.join("p02.json").exists());
}

#[test]
fn what_does_not_fit_a_task_is_refused() {
    let folder = tasks("refused");
    let general = folder.join("general");
    let wrong = general.join("p03.pddl");
    fs::write(&wrong, task("(at a moon)")).unwrap();
    let missing = general.join("p09.pddl");
    let (domain, task) = (general.join("domain.pddl"), general.join("p01.pddl"));
    let layout = folder.join("layout");
    fs::create_dir_all(&layout).unwrap();
    fs::write(layout.join("hyps.dat"), "").unwrap();
    for (args, more, message) in [
        (
            &[&*domain, &*task][..],
            &["--all"][..],
            "all: found a task, expected a problem with hypotheses",
        ),
        (&[&*task], &["--true-goal", "2"], "true-goal: found a task, expected"),
        (&[&*task], &["--plan-out", "plan"], "plan-out: found a task, expected"),
        (&[&*task], &["--candidates", "1"], "candidates: found 1, expected a whole number from 2"),
        (&[&*layout], &["--seed", "1"], "seed: found a problem with hypotheses, expected a task"),
        (&[&*layout], &["--candidates", "4"], "candidates: found a problem with hypotheses"),
        (&[&*domain], &[], "domain.pddl: found no task with a domain beside it"),
        (&[&*folder.join("alone/p01.pddl")], &[], "found no task with a domain beside it"),
        (&[&*domain, &*missing], &[], "p09.pddl: "),
        (&[&*domain, &*wrong], &[], "p03.pddl:3:15: found the undeclared object \"moon\""),
        (&[&*task, &*task], &[], "p01.pddl:1:9: found \"(problem …)\", expected (domain …)"),
    ] {
        let ran = import(args, more);
        assert_eq!((ran.code, ran.out.as_str()), (2, ""), "{message}");
        assert!(ran.err.contains(message), "{message}: {}", ran.err);
    }
}

/// The lines of a file of records.
fn lines(path: &Path) -> Vec<Value> {
    let text = fs::read_to_string(path).unwrap();
    text.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

#[test]
fn benchmarks_find_tasks_with_a_domain_beside_them() {
    let folder = tasks("benchmarks");
    let out = folder.with_file_name("benchmarks-out");
    let _ = fs::remove_dir_all(&out);
    let run = |more: &[&str]| {
        let begin = ["experiment", "benchmarks", folder.to_str().unwrap()];
        let places =
            ["--out", out.to_str().unwrap(), "--solver", "satisficing", "--solver", "exact"];
        mo_copp("", &[&begin[..], &places, more].concat())
    };
    let ran = run(&["--candidates", "4", "--seed", "3"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert!(
        ran.out.contains("4 candidate goals for each competition task (seed 3)"),
        "{}",
        ran.out
    );
    let records = lines(&out.join("records.jsonl"));
    assert_eq!((&records[0]["candidates"], &records[0]["seed"]), (&json!(4), &json!(3)));
    let found: Vec<(&str, &str)> = records[1..]
        .iter()
        .filter(|record| record["solver"] == "exact")
        .map(|record| (record["problem"].as_str().unwrap(), record["status"].as_str().unwrap()))
        .collect();
    let expected = [
        ("general/p01.pddl", "optimal"),
        ("general/p02.pddl", "refused"),
        ("numbered/p01.pddl", "optimal"),
    ];
    assert_eq!(found, expected);
    // The same as the document that import makes.
    let document =
        import(&[&folder.join("general/p01.pddl")], &["--candidates", "4", "--seed", "3"]);
    let alone = mo_copp(&document.out, &["solve", "-", "--solver", "exact", "--json"]).json();
    let of = |problem: &str| records.iter().rfind(|record| record["problem"] == problem).unwrap();
    for key in ["plan", "goal_difference"] {
        assert_eq!(of("general/p01.pddl")[key], alone[key], "{key}");
        assert_eq!(of("numbered/p01.pddl")[key], alone[key], "{key}");
    }
    // The reader's message has the path below the folder.
    let said = of("general/p02.pddl")["refusal"].as_str().unwrap();
    assert!(said.starts_with("general/p02.pddl: found 2 different goals"), "{said}");
    // Other candidate goals are another run, and so is another domain.
    let other = run(&["--candidates", "4"]);
    assert_eq!(other.code, 2);
    assert!(other.err.contains("found seed 3, expected seed 1;"), "{}", other.err);
    fs::write(folder.join("general/domain.pddl"), DOMAIN.to_owned() + "\n").unwrap();
    let other = run(&["--candidates", "4", "--seed", "3"]);
    assert!(other.err.contains("found problem general/p01.pddl of general"), "{}", other.err);
    let none = run(&["--candidates", "1"]);
    assert!(
        none.err.contains("candidates: found 1, expected a whole number from 2"),
        "{}",
        none.err
    );
}
