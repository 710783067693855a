//! Sensors as tables: a symbol for each operator, beside rules.

use mo_copp::domain::Document;
use mo_copp::plan::Plan;
use mo_copp::trace::trace;
use serde_json::{Value, json};

use super::message;
use super::pddl::example;

/// The example with another sensor for the friend.
fn with(sensor: &Value) -> String {
    let mut document: Value = serde_json::from_str(example()).unwrap();
    document["observers"]["cooperative"]["sensor"] = sensor.clone();
    document.to_string()
}

#[test]
fn operators_in_the_table_have_its_symbol_and_others_that_of_the_rules() {
    let table = json!([["(walk hall office)", "far {name}"], ["(TAKE  Red office)", "red!"]]);
    let rules =
        json!([{"operator": "walk", "symbol": "steps"}, {"operator": "*", "symbol": "{name}"}]);
    for (otherwise, walk) in [(rules, "steps"), (json!("{name} {2}"), "walk hall")] {
        let text = with(&json!({"table": table, "otherwise": otherwise}));
        let document = Document::parse(&text).unwrap();
        assert_eq!(Document::parse(&document.to_json()).unwrap(), document);
        let problem = document.problem().unwrap();
        let plan = ["(walk hall office)", "(take red office)", "(walk office hall)"];
        let plan = Plan::from_names(problem.task(), &plan).unwrap();
        let trace = trace(&problem, &plan).unwrap();
        let symbols: Vec<_> =
            trace.steps[1..].iter().map(|step| step.symbols[1].clone().unwrap()).collect();
        // Symbols of a table are no templates.
        assert_eq!(symbols, ["far {name}", "red!", walk]);
    }
}

#[test]
fn bad_tables() {
    let rest = json!("x");
    for (sensor, expected) in [
        (json!({"table": [], "otherwise": rest}), "no error"),
        (json!({"table": [["(walk hall hall)", "x"]], "otherwise": rest}), "no error"),
        (
            json!({"table": [["(walk hall office)", "x"]]}),
            "observers.cooperative.sensor: found no symbol for (walk hall archive), expected it in the table, or a rule that matches it",
        ),
        (
            json!({"table": [["(walk hall office)", "x"], ["(walk HALL office)", "y"]], "otherwise": rest}),
            "observers.cooperative.sensor.table[1]: found another symbol for (walk HALL office), which had \"x\", expected one symbol for each operator",
        ),
        (
            json!({"table": [["(walk hall ?x)", "x"]], "otherwise": rest}),
            "observers.cooperative.sensor.table[0][0]: found \"(walk hall ?x)\", expected an operator with its objects, as in (stack a b)",
        ),
        (
            json!({"table": [["(walk hall cellar)", "x"]], "otherwise": rest}),
            "observers.cooperative.sensor.table[0][0], line 1, column 12: found the undeclared object \"cellar\", expected an object or a constant: hall, office, archive, red, blue",
        ),
        (
            json!({"table": [["(walk hall office)"]], "otherwise": rest}),
            "observers.cooperative.sensor.table[0]: found [\"(walk hall office)\"], expected an operator and its symbol, as in [\"(stack a b)\", \"a noise\"]",
        ),
        (
            json!({"table": [], "otherwise": {"table": []}}),
            "observers.cooperative.sensor.otherwise: found {\"table\": …}, expected a template of symbols, or a list of rules",
        ),
        (
            json!({"table": [], "otherwise": [{"operator": "run", "symbol": "x"}]}),
            "observers.cooperative.sensor.otherwise[0].operator, line 1, column 1: found the undeclared action \"run\", expected an action of the domain: walk, take, leave",
        ),
        (
            json!({"otherwise": "x"}),
            "observers.cooperative.sensor.table: found nothing, expected a list of operators with their symbols",
        ),
    ] {
        assert_eq!(message(&with(&sensor)), expected, "{sensor}");
    }
}
