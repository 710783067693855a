//! Plans of every solver on a few documents, the same natively (here) and in wasm
//! (`wasm-tests/main.rs`): `tests/golden/plans.json`.
//!
//! `MO_COPP_GOLDEN=write cargo test --test native golden` writes the file anew from the cases
//! below. Look at the difference before it is committed; without the variable nothing is written.

pub mod replay;

use serde_json::{Value, json};

use crate::documents::{DELIVERY, EXPLICIT, GRIDWORLD, pddl};

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/plans.json");

/// Options of every solver, for plans of this length and of any.
fn options(horizon: usize, paper: bool) -> Vec<Value> {
    let mut options = vec![
        json!({"solver": "exact", "horizon": horizon}),
        json!({"solver": "exact", "horizon": horizon, "pareto": true}),
        json!({"solver": "exact", "horizon": "any"}),
        json!({"solver": "exact", "horizon": "any", "pareto": true, "j": 2}),
        json!({"solver": "ip", "encoding": "belief-flow", "horizon": horizon}),
        json!({"solver": "ip", "encoding": "belief-flow", "horizon": horizon, "k": 2, "j": 2}),
        json!({"solver": "ip", "encoding": "belief-flow"}),
        json!({"solver": "search", "k": 2, "j": 2}),
        json!({"solver": "search", "k": 2, "j": 1}),
        json!({"solver": "search", "horizon": horizon, "k": 2}),
        json!({"solver": "satisficing", "k": 2, "j": 1}),
        json!({"solver": "satisficing", "horizon": horizon, "k": 2}),
        json!({"solver": "baseline"}),
        json!({"solver": "baseline", "horizon": horizon}),
        json!({"solver": "obfuscate", "k": 2}),
        json!({"solver": "legible", "j": 1}),
    ];
    if paper {
        options.extend([
            json!({"solver": "ip", "encoding": "paper", "horizon": horizon}),
            json!({"solver": "ip", "encoding": "paper", "horizon": horizon, "k": 2, "j": 2}),
            json!({"solver": "ip", "encoding": "paper", "horizon": horizon, "horizon_step": 1}),
        ]);
    }
    options
}

/// Roads that cost, and slides that do not.
pub const COSTS: &str = include_str!("costs.json");

/// Options with a cost limit.
fn cost_limits(limits: [u64; 3], horizon: usize) -> Vec<Value> {
    let of = |limit: u64| {
        [
            json!({"solver": "exact", "cost_limit": limit}),
            json!({"solver": "exact", "cost_limit": limit, "pairs": true}),
            json!({"solver": "exact", "cost_limit": limit, "lengths": horizon}),
            json!({"solver": "exact", "cost_limit": limit, "horizon": horizon}),
            json!({"solver": "ip", "cost_limit": limit, "horizon": horizon}),
            json!({"solver": "search", "cost_limit": limit, "k": 2, "j": 2}),
            json!({"solver": "satisficing", "cost_limit": limit, "k": 2, "j": 1}),
            json!({"solver": "baseline", "cost_limit": limit}),
        ]
    };
    limits.into_iter().flat_map(of).collect()
}

/// Walls, stay, cameras and goals in one cell.
const CAMERAS: &str = include_str!("grid.json");

fn cases() -> Vec<Value> {
    let mut cases = vec![
        replay::case("the delivery of the paper", None, DELIVERY, &options(3, true)),
        replay::case("the explicit example", None, EXPLICIT, &options(1, true)),
        replay::case("the gridworld example", None, GRIDWORLD, &options(14, false)),
        replay::case("cameras", None, CAMERAS, &options(6, false)),
    ];
    let named = [
        json!({"solver": "exact", "require": [{"observer": "adversarial", "goal": "G2"}]}),
        json!({"solver": "search", "forbid": [{"observer": "cooperative", "goal": "G3"}]}),
        json!({"solver": "exact", "k": 3, "j": 1}),
    ];
    cases.push(replay::case("named goals", None, GRIDWORLD, &named));
    let limits = cost_limits([0, 3, 9], 3);
    cases.push(replay::case("cost limits", None, COSTS, &limits));
    let limits = cost_limits([13, 14, 16], 14);
    cases.push(replay::case("cost limits without costs", None, GRIDWORLD, &limits));
    for (format, seed, horizon, paper) in [
        ("gridworld", 1, 12, false),
        ("gridworld", 2, 14, false),
        ("gridworld", 3, 12, false),
        ("gridworld with walls", 4, 14, false),
        ("small gridworld", 5, 4, true),
        ("small gridworld", 6, 2, true),
        ("delivery", 7, 3, false),
        ("delivery", 8, 3, false),
    ] {
        let document = replay::draw(format, seed).to_json();
        let name = format!("{format} {seed}");
        let options = options(horizon, paper);
        cases.push(replay::case(&name, Some((format, seed)), &document, &options));
    }
    cases.push(replay::case("the example in PDDL", None, pddl::example(), &options(5, true)));
    for (format, seed, horizon) in [("small blocksworld", 1, 6), ("small driverlog", 2, 7)] {
        let document = replay::draw(format, seed).to_json();
        let name = format!("{format} {seed}");
        let options = options(horizon, false);
        cases.push(replay::case(&name, Some((format, seed)), &document, &options));
    }
    for (format, seed, horizon) in [("small box-pushing", 1, 8), ("small recycling-robot", 2, 7)] {
        let document = replay::draw(format, seed).to_json();
        let name = format!("{format} {seed}");
        // Every pair of plans of every length takes more memory than wasm has.
        let mut options = options(horizon, false);
        options.retain(|options| options["horizon"] != "any" || options["pareto"] != true);
        // Algorithm 1 goes through all beliefs there are before it answers that there is no plan.
        options.retain(|options| options["j"] != 1 || options["solver"] == "satisficing");
        cases.push(replay::case(&name, Some((format, seed)), &document, &options));
    }
    // One with a plan that Algorithm 1 alone does not find soon, and one without any.
    let bounded = [json!({"solver": "satisficing", "k": 2, "j": 2}), json!({"solver": "baseline"})];
    for (format, seed) in
        [("box-pushing", 5), ("box-pushing", 10), ("box-pushing", 15), ("recycling-robot", 3)]
    {
        let document = replay::draw(format, seed).to_json();
        let name = format!("{format} {seed}");
        cases.push(replay::case(&name, Some((format, seed)), &document, &bounded));
    }
    let larger = [
        json!({"solver": "search", "k": 3, "j": 3}),
        json!({"solver": "search", "k": 4, "j": 1}),
        json!({"solver": "obfuscate", "k": 3}),
        json!({"solver": "legible", "j": 3}),
        json!({"solver": "baseline"}),
    ];
    for (format, seed) in [("blocksworld", 9), ("logistics", 13), ("driverlog", 10)] {
        let document = replay::draw(format, seed).to_json();
        let name = format!("{format} {seed}");
        cases.push(replay::case(&name, Some((format, seed)), &document, &larger));
    }
    cases
}

/// A line for the document and one for each answer.
fn written(case: &Value) -> String {
    let (name, document, runs) = (&case["name"], &case["document"], case["runs"].as_array());
    let drawn = case.get("drawn").map(|drawn| format!("\"drawn\": {drawn},\n "));
    let runs: Vec<String> = runs.unwrap().iter().map(|run| format!("  {run}")).collect();
    format!(
        "{{\"name\": {name}, {}\"document\": {document},\n \"runs\": [\n{}]}}",
        drawn.unwrap_or_default(),
        runs.join(",\n")
    )
}

#[test]
fn plans_are_the_golden_ones() {
    if std::env::var("MO_COPP_GOLDEN").is_ok_and(|value| value == "write") {
        let cases: Vec<String> = cases().iter().map(written).collect();
        std::fs::write(FILE, format!("[\n{}\n]\n", cases.join(",\n"))).unwrap();
    }
    let golden = std::fs::read_to_string(FILE).unwrap();
    assert!(replay::check(&golden) >= 180);
}

/// The file itself makes sense: every status occurs, and the integer programs and exact search
/// agree wherever they were asked the same.
#[test]
fn golden_answers_agree_with_each_other() {
    let golden: Vec<Value> = serde_json::from_str(&std::fs::read_to_string(FILE).unwrap()).unwrap();
    let mut compared = 0;
    let mut statuses = std::collections::BTreeSet::new();
    for case in &golden {
        let runs = case["runs"].as_array().unwrap();
        for run in runs {
            statuses.insert(run["answer"]["status"].as_str().unwrap());
        }
        let of = |solver: &str| {
            let asked = move |run: &&Value| {
                let options = run["options"].as_object().unwrap();
                let plain = ["k", "j", "require", "forbid", "pareto", "horizon_step"];
                options["solver"] == solver
                    && options.get("horizon").is_some_and(Value::is_number)
                    && !plain.iter().any(|key| options.contains_key(*key))
            };
            runs.iter().filter(asked).collect::<Vec<_>>()
        };
        for exact in of("exact") {
            for program in of("ip") {
                if exact["options"]["cost_limit"] != program["options"]["cost_limit"] {
                    continue;
                }
                assert_eq!(exact["options"]["horizon"], program["options"]["horizon"]);
                for key in ["status", "goal_difference", "horizon"] {
                    assert_eq!(exact["answer"][key], program["answer"][key], "{}", case["name"]);
                }
                compared += 1;
            }
        }
    }
    assert!(compared >= 15, "{compared}");
    assert!(["optimal", "solved", "infeasible"].iter().all(|name| statuses.contains(name)));
}
