//! `mo-copp trace`

use std::io::Write;

use serde_json::json;

use crate::{DELIVERY, EXPLICIT, GRID, mo_copp};

#[test]
fn json_has_the_fields_of_the_contract() {
    let ran = mo_copp(EXPLICIT, &["trace", "-", "--plan", "a", "--json"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert_eq!(
        ran.json(),
        json!({"valid": true, "goal_difference": 1.0, "steps": [
            {"action": null, "state": "s0", "symbols": {"adversarial": null, "cooperative": null},
             "beliefs": {"adversarial": ["s0"], "cooperative": ["s0"]},
             "goals": {"adversarial": [], "cooperative": []}, "goal_difference": 0.0},
            {"action": "a", "state": "s1", "symbols": {"adversarial": "moved", "cooperative": "a"},
             "beliefs": {"adversarial": ["s1", "s2"], "cooperative": ["s1"]},
             "goals": {"adversarial": ["G1", "G2"], "cooperative": ["G1"]}, "goal_difference": 1.0}]})
    );
}

#[test]
fn grid_states_are_cells_and_others_facts() {
    let ran = mo_copp(GRID, &["trace", "-", "--plan", "north", "--json"]);
    let json = ran.json();
    assert_eq!(json["steps"][1]["state"], json!([0, 6]));
    assert_eq!(json["steps"][1]["beliefs"]["cooperative"], json!([[0, 6], [1, 7]]));
    assert_eq!((ran.code, &json["valid"]), (1, &json!(false)), "it ends off the goal");
    let ran = mo_copp(DELIVERY, &["trace", "-", "--plan", "load a1", "--json"]);
    let facts = &ran.json()["steps"][1]["state"];
    assert!(facts.as_array().unwrap().contains(&json!("a1 in the truck")), "{facts}");
}

#[test]
fn a_plan_file_has_one_action_a_line() {
    let path = std::env::temp_dir().join(format!("mo-copp-plan-{}", std::process::id()));
    let mut file = std::fs::File::create(&path).unwrap();
    writeln!(file, "load a1\r\nload b1\n\ndeliver").unwrap();
    let name = path.to_str().unwrap();
    let ran = mo_copp(DELIVERY, &["trace", "-", "--plan-file", name, "--json"]);
    std::fs::remove_file(&path).unwrap();
    // One package from each factory, seen from the other true goal.
    assert_eq!(ran.json()["goal_difference"], 0.4);
    assert_eq!(ran.json()["valid"], false);
}

#[test]
fn the_text_shows_each_step() {
    let ran = mo_copp(EXPLICIT, &["trace", "-", "--plan", "a"]);
    let expected = "\
start: s0
  adversarial: 1 state (s0); possible goals: none yet
  cooperative: 1 state (s0); possible goals: none yet
step 1: a to s1
  adversarial: is told moved, 2 states (s1, s2); possible goals: G1, G2
  cooperative: is told a, 1 state (s1); possible goals: G1
the plan reaches the true goal G1
goal difference: 1
";
    assert_eq!(ran.out, expected);
}

#[test]
fn a_plan_that_does_not_reach_the_goal_has_a_goal_difference_only_if_it_stopped_there() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/www/problems/eight-by-eight.json");
    let ran = mo_copp("", &["trace", path, "--plan", "north,north,east"]);
    assert_eq!(ran.code, 1);
    assert_eq!(ran.out.matches("possible goals: none yet\n").count(), 8, "{}", ran.out);
    assert!(
        ran.out.ends_with(
            "the plan does not reach the true goal G1\n\
             if it stopped here: 0 goals possible for the enemy, 0 for the friend, goal difference 0\n"
        ),
        "{}",
        ran.out
    );
}

#[test]
fn an_empty_plan_is_the_start() {
    let ran = mo_copp(EXPLICIT, &["trace", "-", "--plan", "", "--json"]);
    assert_eq!(ran.json()["steps"].as_array().unwrap().len(), 1);
}

#[test]
fn operators_of_pddl_are_read_as_other_planners_write_them() {
    let blocks = mo_copp("", &["generate", "blocksworld", "--seed", "1"]).out;
    let expected = mo_copp(&blocks, &["trace", "-", "--plan", "(pick-up a),(stack a e)", "--json"]);
    assert_eq!(expected.json()["steps"][2]["action"], "(stack a e)", "{}", expected.err);
    for plan in ["(PICK-UP A),( stack  a e )", "pick-up a,Stack a E"] {
        let ran = mo_copp(&blocks, &["trace", "-", "--plan", plan, "--json"]);
        assert_eq!((ran.code, ran.out), (expected.code, expected.out.clone()), "{plan}");
    }
    let path = std::env::temp_dir().join(format!("mo-copp-pddl-plan-{}", std::process::id()));
    std::fs::write(&path, "(pick-up a)\r\n\r\n(STACK A E)\r\n; cost = 2 (unit cost)\n").unwrap();
    let file = path.to_str().unwrap();
    let ran = mo_copp(&blocks, &["trace", "-", "--plan-file", file, "--json"]);
    std::fs::remove_file(&path).unwrap();
    assert_eq!((ran.code, ran.out), (expected.code, expected.out), "{}", ran.err);
    let ran = mo_copp(&blocks, &["trace", "-", "--plan", "(pick-up z)", "--json"]);
    assert_eq!(ran.code, 2);
    assert!(ran.err.contains("(pick-up z)"), "{}", ran.err);
}

#[test]
fn every_step_is_said_in_full() {
    let expected = "expected an action of this problem: north, south, east, west\n";
    for (plan, step, found) in [
        ("north,,north", 2, "nothing"),
        ("north,", 2, "nothing"),
        ("north, ,north", 2, "nothing"),
        (",", 1, "nothing"),
        ("(north", 1, "\"(north\""),
    ] {
        let ran = mo_copp(GRID, &["trace", "-", "--plan", plan]);
        let message = format!("mo-copp: the plan fails: step {step}: found {found}, {expected}");
        assert_eq!((ran.code, ran.err), (2, message), "{plan}");
    }
    let blocks = mo_copp("", &["generate", "blocksworld", "--seed", "1"]).out;
    for plan in ["(pick-up a", "pick-up a)", "((pick-up a))", "pick-up a,(stack a e"] {
        let ran = mo_copp(&blocks, &["trace", "-", "--plan", plan]);
        let step = plan.matches(',').count() + 1;
        assert_eq!(ran.code, 2, "{plan}");
        let begin = format!("mo-copp: the plan fails: step {step}: found \"");
        assert!(ran.err.starts_with(&begin), "{}", ran.err);
    }
    let ran = mo_copp(GRID, &["trace", "-", "--plan", " "]);
    assert!(ran.out.starts_with("start: ") && !ran.out.contains("step 1"), "{}", ran.out);
}

#[test]
fn names_may_hold_commas_and_begin_and_end_with_blanks() {
    const NAMES: &str = r#"{"format": "explicit", "states": ["s0", "s1"],
        "actions": ["a", "b", "a,b", " c ", "c", "c,a"],
        "transitions": [["s0", "a", "s0"], ["s0", "b", "s0"], ["s0", "a,b", "s0"], ["s0", " c ", "s0"],
                        ["s0", "c", "s1"], ["s1", "a", "s1"], ["s1", "c,a", "s0"]],
        "initial_state": "s0", "true_goal": "G1",
        "goals": [{"name": "G1", "states": ["s1"]}, {"name": "G2", "states": ["s0"]}],
        "observers": {"adversarial": {"sensor": SENSOR}, "cooperative": {"sensor": SENSOR}}}"#;
    const SENSOR: &str = r#"[["a", "s0", "x"], ["b", "s0", "x"], ["a,b", "s0", "x"], [" c ", "s0", "x"],
        ["c", "s1", "x"], ["a", "s1", "x"], ["c,a", "s0", "x"]]"#;
    let document = NAMES.replace("SENSOR", SENSOR);
    let steps = |arguments: &[&str]| {
        let ran = mo_copp(&document, &[&["trace", "-", "--json"], arguments].concat());
        let json = ran.json();
        let steps = json["steps"].as_array().unwrap_or_else(|| panic!("{}", ran.err)).clone();
        let names = steps[1..].iter().map(|step| step["action"].as_str().unwrap().to_owned());
        names.collect::<Vec<String>>()
    };
    assert_eq!(steps(&["--plan", "a,b"]), ["a,b"]);
    assert_eq!(steps(&["--plan", "b,a"]), ["b", "a"]);
    assert_eq!(steps(&["--plan", "a,b,b, a , c ,c,c,a"]), ["a,b", "b", "a", " c ", "c", "c,a"]);
    let path = std::env::temp_dir().join(format!("mo-copp-names-{}", std::process::id()));
    std::fs::write(&path, "a,b\r\n\n c \n  a \n c \r\nc\n").unwrap();
    let read = steps(&["--plan-file", path.to_str().unwrap()]);
    std::fs::remove_file(&path).unwrap();
    assert_eq!(read, ["a,b", " c ", "a", " c ", "c"]);
}
