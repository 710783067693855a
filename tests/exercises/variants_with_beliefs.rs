//! Variants of problems whose states have parts, with initial beliefs: the start and each belief are drawn anew.

use std::collections::BTreeSet;

use mo_copp::exercise::Exercise;
use serde_json::{Value, json};

/// An example of the project.
fn example(name: &str) -> Value {
    let path = format!("{}/examples/{name}.json", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// A problem with a question that varies.
fn asked(mut document: Value, block: Value, vary: &[&str]) -> Exercise {
    document["exercise"] = block;
    document["exercise"]["vary"] = json!(vary);
    Exercise::parse(&document.to_string()).unwrap()
}

fn json_of(exercise: &Exercise, seed: u64) -> Value {
    let variant = exercise.variant(seed).unwrap_or_else(|error| panic!("{error}"));
    assert!(variant.check(variant.solution()).right, "seed {seed}");
    serde_json::from_str(&variant.document().to_json()).unwrap()
}

/// Draws seeds, and holds start and beliefs of each against those of the document: in each belief as many states as before,
/// the start among them, with the parts that all states had in common with the start. Nearly all cells are starts of some
/// seed, and the original is one of them.
fn check(exercise: &Exercise, seeds: u64) {
    let original = json_of(exercise, 0);
    let parts: Vec<&String> = original["start"].as_object().unwrap().keys().collect();
    let (mut starts, mut same) = (BTreeSet::new(), 0);
    for seed in 1..=seeds {
        let drawn = json_of(exercise, seed);
        let start = &drawn["start"];
        same += u64::from(start["robot"] == original["start"]["robot"]);
        for role in ["adversarial", "cooperative"] {
            let states = |document: &Value| {
                document["observers"][role]["initial_belief"].as_array().unwrap().clone()
            };
            let (before, after) = (states(&original), states(&drawn));
            assert_eq!(after.len(), before.len(), "seed {seed}");
            let different: BTreeSet<String> = after.iter().map(Value::to_string).collect();
            assert_eq!(different.len(), before.len(), "seed {seed}");
            assert!(after.contains(start), "seed {seed}");
            for &part in &parts {
                let is_known = before.iter().all(|state| state[part] == original["start"][part]);
                assert!(!is_known || after.iter().all(|state| state[part] == start[part]));
            }
        }
        starts.insert(start["robot"].to_string());
    }
    let cells = original["width"].as_u64().unwrap() * original["height"].as_u64().unwrap();
    assert!(starts.len() as u64 * 2 > cells, "{} starts", starts.len());
    assert!(same * 4 < seeds, "{same} seeds with the start of the document");
}

/// A recycling robot on a small floor that holds the can: a walk at random is likely to drop it.
fn small_robot() -> Value {
    let mut document = example("recycling-robot");
    let state = |robot: [u32; 2]| json!({"robot": robot, "battery": 7, "can": "held"});
    let belief = json!([state([2, 0]), state([0, 2]), state([1, 1])]);
    document["width"] = json!(3);
    document["height"] = json!(3);
    document["charger"] = json!([2, 2]);
    document["battery_levels"] = json!(8);
    document["start"] = state([2, 0]);
    for (goal, cell) in [[0, 1], [2, 1], [1, 2]].into_iter().enumerate() {
        document["goals"][goal]["cell"] = json!(cell);
    }
    for role in ["adversarial", "cooperative"] {
        document["observers"][role]["initial_belief"] = belief.clone();
    }
    document
}

const PUSHES: [&str; 9] = [
    "move-forward",
    "move-forward",
    "turn-left",
    "move-forward",
    "turn-right",
    "move-forward",
    "turn-right",
    "stay",
    "move-forward",
];

#[test]
fn box_pushing_has_variants_of_which_goals_are_possible() {
    let block = json!({"kind": "possible-goals", "observer": "cooperative", "plan": PUSHES});
    check(&asked(example("box-pushing"), block, &["start", "goals", "plan"]), 1000);
}

#[test]
fn box_pushing_has_variants_of_a_belief() {
    let block = json!({"kind": "belief", "observer": "cooperative", "plan": PUSHES[..4]});
    check(&asked(example("box-pushing"), block, &["start", "plan"]), 1000);
}

#[test]
fn box_pushing_has_variants_of_a_walk() {
    let block = json!({"kind": "walk", "at_most": 14});
    check(&asked(example("box-pushing"), block, &["start", "goals"]), 1000);
}

#[test]
fn the_recycling_robot_has_variants_of_which_goals_are_possible() {
    let plan = ["west", "south", "drop"];
    let block = json!({"kind": "possible-goals", "observer": "cooperative", "plan": plan});
    check(&asked(small_robot(), block, &["start", "goals", "plan"]), 1000);
}

#[test]
fn the_recycling_robot_has_variants_of_a_belief() {
    let plan = ["west", "pick-up", "south", "west"];
    let block = json!({"kind": "belief", "observer": "cooperative", "plan": plan});
    check(&asked(example("recycling-robot"), block, &["start", "plan"]), 1000);
}

#[test]
fn the_recycling_robot_has_variants_of_a_walk() {
    let block = json!({"kind": "walk", "at_most": 10});
    check(&asked(example("recycling-robot"), block, &["start", "goals"]), 1000);
}

#[test]
fn walls_that_vary_leave_the_box_where_it_is() {
    let mut document = example("box-pushing");
    document["walls"] = json!([[4, 4], [0, 4]]);
    let exercise = asked(document, json!({"kind": "walk", "at_most": 14}), &["walls", "start"]);
    for seed in 1..=100 {
        let drawn = json_of(&exercise, seed);
        assert!(
            !drawn["walls"].as_array().unwrap().contains(&drawn["start"]["box"]),
            "seed {seed}"
        );
    }
}

#[test]
fn a_start_with_nowhere_to_go_is_refused_with_a_sentence() {
    let cells = [[0, 0], [1, 0], [2, 0]];
    let goals: Vec<Value> = [[0, 0], [2, 0]]
        .iter()
        .map(|cell| json!({"name": format!("G{}", cell[0]), "cell": cell}))
        .collect();
    let sensor = json!({"sensor": {"north": "n", "south": "s", "east": "e", "west": "w"}});
    let document = json!({
        "format": "gridworld", "width": 3, "height": 1, "start": cells[1], "goals": goals, "true_goal": "G0",
        "observers": {"adversarial": sensor, "cooperative": sensor},
        "exercise": {"kind": "possible-goals", "observer": "adversarial", "plan": ["east"], "vary": ["start"]}
    });
    assert_eq!(
        Exercise::parse(&document.to_string()).unwrap_err().to_string(),
        "exercise.vary[0]: found start, where no other cell is free, \
         expected a cell without a wall, a goal, a box, a can or a charger for another start"
    );
}
