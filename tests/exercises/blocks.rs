//! The block `exercise` of a document: what is read, what is refused and with which words.

use mo_copp::domain::Document;
use mo_copp::exercise::{Exercise, Hidden, Lock};
use mo_copp::report::ExerciseReport;
use serde_json::{Value, json};

use super::text;

/// A document with one key of its exercise changed; null takes the key out.
fn changed(name: &str, key: &str, value: Value) -> String {
    let mut document: Value = serde_json::from_str(&text(name)).unwrap();
    let block = document["exercise"].as_object_mut().unwrap();
    match value {
        Value::Null => drop(block.remove(key)),
        value => drop(block.insert(key.to_owned(), value)),
    }
    document.to_string()
}

fn refused(name: &str, key: &str, value: Value) -> String {
    Exercise::parse(&changed(name, key, value)).unwrap_err().to_string()
}

const GOALS: &str = "01-possible-goals";

#[test]
fn errors_name_the_place_what_was_found_and_what_was_expected() {
    assert_eq!(
        refused(GOALS, "kind", json!("riddle")),
        r#"exercise.kind: found "riddle", expected one of possible-goals, belief, walk, best, placement, guess"#
    );
    assert_eq!(
        refused(GOALS, "colour", json!("red")),
        "exercise: found the unknown key \"colour\", expected only kind, title, introduction, hints, attempts, hide, lock, \
         vary, observer, plan"
    );
    assert_eq!(
        refused(GOALS, "observer", json!("friend")),
        r#"exercise.observer: found "friend", expected one of adversarial, cooperative"#
    );
    assert_eq!(
        refused(GOALS, "plan", Value::Null),
        "exercise.plan: found nothing, expected a list of actions"
    );
    assert_eq!(
        refused(GOALS, "plan", json!(["up"])),
        "exercise.plan: found step 1: found \"up\", expected an action of this problem: north, south, east, west, \
         expected a walk of the problem"
    );
    assert_eq!(
        refused(GOALS, "attempts", json!(0)),
        "exercise.attempts: found 0, expected a whole number from 1 to 99"
    );
    assert_eq!(
        refused(GOALS, "hide", json!(["walls"])),
        r#"exercise.hide[0]: found "walls", expected one of beliefs"#
    );
    assert_eq!(
        refused(GOALS, "vary", json!(["plan", "plan"])),
        "exercise.vary[1]: found plan for the second time, expected each name once"
    );
    assert_eq!(
        refused("08-delivery", "vary", json!(["walls"])),
        "exercise.vary[0]: found walls in an exercise of the kind possible-goals, \
         expected something that a delivery document has and the question needs"
    );
    assert_eq!(
        refused("06-camera", "goal", json!("G9")),
        "exercise.goal: found \"G9\", expected the name of a candidate goal: G1, G2, G3, G4"
    );
    assert_eq!(
        refused("06-camera", "place", json!("tower")),
        r#"exercise.place: found "tower", expected one of camera, wall, start"#
    );
    assert_eq!(
        refused("09-walk-difference", "goal_difference", json!(2)),
        "exercise.goal_difference: found 2, expected a number from -1 to 1"
    );
    assert_eq!(
        refused("09-walk-difference", "goal_difference", Value::Null),
        "exercise.goal_difference: found nothing, \
         expected the goal difference that the walk must have, or at_most, its most steps"
    );
    assert_eq!(
        refused("10-walk-both", "at_most", json!(1)),
        "exercise: found no walk answers the question, expected a question with an answer"
    );
    let long = vec!["north"; 101];
    assert_eq!(
        refused(GOALS, "plan", json!(long)),
        "exercise.plan: found 101 actions, expected at most 100"
    );
}

#[test]
fn a_document_without_a_block_is_no_exercise() {
    let plain = r#"{"format": "delivery", "factories": [{"name": "A", "packages": ["a1", "a2"]}], "deliver": 1,
        "true_goal": "a1", "observers": {"adversarial": {"sensor": {"load": "l", "deliver": "d"}},
        "cooperative": {"sensor": {"load": "l", "deliver": "d"}}}}"#;
    assert!(!Exercise::is_in(plain));
    assert_eq!(
        Exercise::parse(plain).unwrap_err().to_string(),
        "exercise: found nothing, expected an exercise, an object with a kind"
    );
    assert!(Exercise::is_in(&text(GOALS)));
}

#[test]
fn the_problem_of_a_document_does_not_depend_on_its_exercise() {
    let whole = text(GOALS);
    let mut bare: Value = serde_json::from_str(&whole).unwrap();
    bare.as_object_mut().unwrap().remove("exercise");
    assert_eq!(Document::parse(&whole).unwrap(), Document::parse(&bare.to_string()).unwrap());
}

#[test]
fn what_is_hidden_follows_from_the_kind_unless_it_is_said() {
    let hidden = |text: &str| Exercise::parse(text).unwrap().hidden();
    assert_eq!(hidden(&text(GOALS)), Hidden::ALL);
    assert_eq!(hidden(&text("12-best")), []);
    assert_eq!(hidden(&changed(GOALS, "hide", json!([]))), []);
    assert_eq!(hidden(&changed("12-best", "hide", json!(["beliefs"]))), [Hidden::Beliefs]);
}

#[test]
fn a_problem_that_is_too_large_is_refused() {
    let mut document: Value = serde_json::from_str(&text("02-belief")).unwrap();
    (document["width"], document["height"]) = (json!(100), json!(100));
    assert_eq!(
        Exercise::parse(&document.to_string()).unwrap_err().to_string(),
        "exercise: found the problem is too large for an exercise, expected a question with an answer"
    );
}

#[test]
fn where_the_true_goal_is_to_be_guessed_the_pddl_does_not_tell_it() {
    let mut document: Value =
        serde_json::from_str(include_str!("../../examples/blocksworld.json")).unwrap();
    let last = document["exercise"].is_null();
    assert!(last);
    document["exercise"] = json!({"kind": "guess", "plan": [], "observer": "adversarial"});
    let problem = document["problem"].clone();
    let lines: Vec<&str> =
        problem.as_array().unwrap().iter().map(|l| l.as_str().unwrap()).collect();
    let joined = lines.join("\n");
    let goal = document["goals"]
        .as_array()
        .unwrap()
        .iter()
        .find(|goal| goal["name"] == document["true_goal"]);
    let condition = goal.unwrap()["condition"].as_str().unwrap().to_owned();
    let end = joined.rfind(')').unwrap();
    document["problem"] = json!(format!("{}(:goal {condition}))", &joined[..end]));
    assert_eq!(
        Exercise::parse(&document.to_string()).unwrap_err().to_string(),
        "problem: found the :goal of the true goal, expected no :goal, where the true goal is to be guessed or varies"
    );
}

#[test]
fn a_lock_is_all_nothing_or_keys_of_the_document() {
    let lock =
        |value: Value| Exercise::parse(&changed(GOALS, "lock", value)).unwrap().lock().clone();
    assert_eq!(lock(Value::Null), Lock::Whole(true));
    assert_eq!(lock(json!(false)), Lock::Whole(false));
    assert_eq!(lock(json!(["walls", "start"])), Lock::Keys(vec!["walls".into(), "start".into()]));
    let refused = |value: Value| refused(GOALS, "lock", value);
    assert_eq!(
        refused(json!("walls")),
        "exercise.lock: found \"walls\", expected true, false or a list of keys of the document"
    );
    let found = refused(json!(["walls", "format"]));
    assert!(found.starts_with("exercise.lock[1]: found \"format\", expected one of "), "{found}");
    assert!(!found.ends_with("exercise") && found.contains("true_goal"), "{found}");
    assert_eq!(
        refused(json!(["walls", "walls"])),
        "exercise.lock[1]: found walls for the second time, expected each name once"
    );
}

/// A guess about a floor with two goals as far from the start, and a camera of the enemy.
fn guess(camera: [u32; 2]) -> String {
    let unseen = serde_json::json!({"north": "unseen", "south": "unseen", "east": "unseen", "west": "unseen"});
    serde_json::json!({
        "format": "gridworld", "width": 5, "height": 2, "start": [2, 1],
        "goals": [{"name": "D", "cell": [0, 0]}, {"name": "G", "cell": [4, 0]}],
        "true_goal": "G",
        "observers": {
            "adversarial": {"cameras": [camera], "sensor": unseen.clone()},
            "cooperative": {"sensor": unseen},
        },
        "exercise": {"kind": "guess", "observer": "adversarial", "plan": ["east", "east", "north"]},
    })
    .to_string()
}

#[test]
fn a_guess_that_its_last_symbol_gives_away_is_trivial() {
    let remarks = |camera| Exercise::parse(&guess(camera)).unwrap().original().remarks().to_vec();
    assert_eq!(remarks([4, 0]), ["the last symbol leaves one goal"]);
    // One step before, the camera tells as much, but not by the last symbol alone.
    assert_eq!(remarks([4, 1]), [""; 0]);
}

#[test]
fn what_is_asked_of_a_guess_does_not_hold_its_true_goal() {
    let exercise = Exercise::parse(&guess([4, 1])).unwrap();
    let variant = exercise.original();
    let asked = ExerciseReport::new(&exercise, variant);
    assert_eq!(serde_json::to_value(&asked.document).unwrap()["true_goal"], "D");
    let solved = asked.with_solution(variant);
    assert_eq!(serde_json::to_value(&solved.document).unwrap()["true_goal"], "G");
    // Of the other kinds it is part of the question.
    let walk = super::exercise("12-best");
    let asked = ExerciseReport::new(&walk, walk.original()).document;
    assert_eq!(&asked, walk.original().document());
}
