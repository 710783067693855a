//! Solves what the golden file asks and compares. Shared by the native tests and those in wasm.

use std::sync::Arc;

use mo_copp::domain::box_pushing::BoxPushingShape;
use mo_copp::domain::delivery::DeliveryShape;
use mo_copp::domain::generate::Domain;
use mo_copp::domain::gridworld::GridworldShape;
use mo_copp::domain::pddl::generate::{BlocksworldShape, DriverlogShape};
use mo_copp::domain::recycling_robot::RecyclingRobotShape;
use mo_copp::domain::{Delivery, Document, Gridworld};
use mo_copp::report::{SolveReport, read_request};
use mo_copp::solver::Run;
use serde_json::{Value, json};

/// The document drawn from a seed.
pub fn draw(format: &str, seed: u64) -> Document {
    let grid: fn(Gridworld) -> Document = Document::Gridworld;
    let delivery: fn(Delivery) -> Document = Document::Delivery;
    let shape = GridworldShape::default();
    match format {
        "gridworld" => grid(shape.generate(seed).unwrap().document),
        "gridworld with walls" => {
            let shape = GridworldShape { walls: 14, goals: 5, ..shape };
            grid(shape.generate(seed).unwrap().document)
        }
        "small gridworld" => {
            let shape = GridworldShape { width: 3, height: 3, goals: 3, walls: 1, belief: 3 };
            grid(shape.generate(seed).unwrap().document)
        }
        "delivery" => delivery(DeliveryShape::default().generate(seed).unwrap().document),
        "small box-pushing" => {
            let shape = BoxPushingShape { width: 3, height: 3, goals: 3, walls: 0, belief: 2 };
            shape.generate(seed).unwrap().document.into()
        }
        "small recycling-robot" => {
            let shape = RecyclingRobotShape {
                width: 2,
                height: 3,
                goals: 3,
                walls: 0,
                belief: 2,
                battery_levels: 3,
            };
            shape.generate(seed).unwrap().document.into()
        }
        "small blocksworld" => BlocksworldShape { blocks: 3, goals: 3, belief: 1 }
            .generate(seed)
            .unwrap()
            .document
            .into(),
        "small driverlog" => {
            let shape = DriverlogShape {
                places: 3,
                drivers: 1,
                trucks: 1,
                packages: 1,
                goals: 4,
                belief: 1,
            };
            shape.generate(seed).unwrap().document.into()
        }
        "blocksworld" | "logistics" | "driverlog" | "box-pushing" | "recycling-robot" => {
            Domain::named(format).unwrap().draw(seed).unwrap().document
        }
        _ => panic!("{format}"),
    }
}

/// Memory in bytes, counted by contents, with which all answers are there: what wasm has. The same natively, so that an
/// answer that needs more is missed there too.
const MEMORY: u64 = 160 << 20;

/// What `solve --json` says, but for what the work took.
pub fn answer(document: &str, options: &Value) -> Value {
    let problem = Arc::new(Document::parse(document).unwrap().problem().unwrap());
    let mut request = read_request(&options.to_string(), &problem).unwrap();
    request.options.limits.bytes = MEMORY;
    let mut run = Run::new(Arc::clone(&problem), request.options).unwrap();
    while !run.advance(100).unwrap() {}
    let report = SolveReport::new(&problem, &run.outcome().unwrap());
    let report = if request.old_names { report.with_old_names() } else { report };
    let mut report = serde_json::to_value(report).unwrap();
    report.as_object_mut().unwrap().remove("stats").unwrap();
    report
}

/// Checks a golden file; returns how many answers it holds.
pub fn check(golden: &str) -> usize {
    let cases: Vec<Value> = serde_json::from_str(golden).unwrap();
    let mut answers = 0;
    for case in &cases {
        let document = &case["document"];
        if let Some(drawn) = case.get("drawn") {
            let (format, seed) = (drawn["format"].as_str(), drawn["seed"].as_u64());
            let drawn = draw(format.unwrap(), seed.unwrap()).to_json();
            assert_eq!(&serde_json::from_str::<Value>(&drawn).unwrap(), document);
        }
        for run in case["runs"].as_array().unwrap() {
            let found = answer(&document.to_string(), &run["options"]);
            assert_eq!(found, run["answer"], "{} {}", case["name"], run["options"]);
            answers += 1;
        }
    }
    answers
}

/// A case of the golden file with the answers of today.
pub fn case(name: &str, drawn: Option<(&str, u64)>, document: &str, options: &[Value]) -> Value {
    let run = |options: &Value| json!({"options": options, "answer": answer(document, options)});
    let runs: Vec<Value> = options.iter().map(run).collect();
    let document: Value = serde_json::from_str(document).unwrap();
    let mut case = json!({"name": name, "document": document, "runs": runs});
    if let Some((format, seed)) = drawn {
        case["drawn"] = json!({"format": format, "seed": seed});
    }
    case
}
