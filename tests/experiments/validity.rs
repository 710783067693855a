//! Records that cannot be: merging refuses them with the line, what is there and what should be.

use mo_copp::experiment::{Setting, Shard, merge};
use serde_json::{Value, json};

use super::{fig3, folder, work};

/// What merging says of a run in whose record of a solver some fields are others.
fn said(solver: &str, changes: &[(&str, Value)]) -> String {
    let path = folder("validity").join("records.jsonl");
    work(&path, &fig3(1), Shard::WHOLE, 1);
    let text = std::fs::read_to_string(&path).unwrap();
    let mut changed = String::new();
    for line in text.lines() {
        let mut record: Value = serde_json::from_str(line).unwrap();
        if record["solver"] == *solver {
            for (place, value) in changes {
                *record.pointer_mut(place).unwrap() = value.clone();
            }
        }
        changed += &(record.to_string() + "\n");
    }
    std::fs::write(&path, changed).unwrap();
    match merge::<Setting>(std::slice::from_ref(&path)) {
        Ok(_) => "merged".to_owned(),
        Err(error) => error.to_string().replace(&path.display().to_string(), "FILE"),
    }
}

#[test]
fn records_that_cannot_be_are_refused() {
    assert_eq!(said("search", &[]), "merged");
    let all = json!(["G1", "G2", "G3"]);
    let names = |count: usize| (0..count).map(|n| format!("G{n}")).collect::<Vec<_>>();
    for (solver, changes, expected) in [
        (
            "search",
            vec![("/goal_difference", json!(7.5))],
            "the goal difference 1 of the goals that survive, not 7.5e0",
        ),
        ("search", vec![("/goal_difference", json!(0.25))], "the goal difference 1 of"),
        ("search", vec![("/seconds", json!(-1e300))], "seconds from 0 to 1000000000, not -1e300"),
        ("search", vec![("/seconds", json!(1e308))], "seconds from 0 to 1000000000, not 1e308"),
        ("search", vec![("/candidates", json!(1))], "2 to 1024 candidate goals, not 1"),
        ("search", vec![("/candidates", json!(0))], "2 to 1024 candidate goals, not 0"),
        ("search", vec![("/candidates", json!(1025))], "2 to 1024 candidate goals, not 1025"),
        ("search", vec![("/candidates", json!(2))], "each surviving goal once, of 2"),
        (
            "search",
            vec![("/goals/adversarial", json!(["G1", "G1", "G2"]))],
            "each surviving goal once, of 3",
        ),
        (
            "search",
            vec![("/goals/cooperative", json!([])), ("/goal_difference", json!(1.5))],
            "a true goal that survives for both observers",
        ),
        (
            "search",
            vec![("/goals/cooperative", all.clone()), ("/goal_difference", json!(0.0))],
            "surviving goals that keep k and j",
        ),
        (
            "search",
            vec![("/options/k", json!(1))],
            "the options {\"k\":2,\"j\":2,\"expansions\":50000}, not {\"k\":1,\"j\":2,",
        ),
        ("exact", vec![("/options/horizon", json!(99))], "the options {\"horizon\":12}, not"),
        ("exact", vec![("/status", json!("solved"))], "a status that this solver gives, not"),
        ("baseline", vec![("/status", json!("optimal"))], "a status that this solver gives, not"),
        ("exact", vec![("/status", json!("feasible"))], "status feasible with the limit that was"),
        ("search", vec![("/limit", json!("a limit"))], "status solved without a limit"),
        ("search", vec![("/length", json!(0))], "status solved with a plan"),
        (
            "baseline",
            vec![("/candidates", json!(1024)), ("/goals/adversarial", json!(names(1025)))],
            "each surviving goal once, of 1024",
        ),
    ] {
        let found = said(solver, &changes);
        let (place, rest) = found.split_once(", expected ").unwrap_or((&found, ""));
        assert!(place.starts_with("FILE, line "), "{changes:?}: {found}");
        assert!(place.ends_with(&format!(": found gridworld 1 {solver}")), "{found}");
        assert!(rest.starts_with(expected), "{changes:?}: {found}");
    }
}
