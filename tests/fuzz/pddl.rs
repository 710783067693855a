//! PDDL: a domain and a task in one text, whose lists are moved, doubled, left out and taken from other domains.

use mo_copp::pddl::{ExtraInputs, ground, read_condition, read_domain, read_state, read_task};
use serde_json::Value;

use crate::dice::Dice;
use crate::{Target, json, lists, repository_documents, shape};

pub struct Pddl;

/// Where the task begins.
const TASK: &str = "(define (problem";

/// PDDL in a document: one text, or a list of its lines.
fn text(value: &Value) -> String {
    match value {
        Value::Array(lines) => lines.iter().map(text).collect::<Vec<_>>().join("\n"),
        other => other.as_str().unwrap_or_default().to_owned(),
    }
}

impl Target for Pddl {
    fn name(&self) -> &'static str {
        "pddl"
    }

    fn seeds(&self) -> Vec<String> {
        let documents = repository_documents();
        let parsed = documents.iter().map(|text| serde_json::from_str::<Value>(text).unwrap());
        let found: Vec<_> = parsed
            .filter(|document| document["format"] == "pddl")
            .map(|document| {
                format!("{}\n{}", text(&document["domain"]), text(&document["problem"]))
            })
            .collect();
        assert!(found.len() >= 3, "the repository has PDDL");
        found
    }

    fn changed(&self, dice: &mut Dice, input: &str, other: &str) -> String {
        if dice.percent(10) {
            return json::bytes(dice, input);
        }
        lists::changed_text(dice, input, other)
    }

    fn behaviour(&self, input: &str) -> String {
        let (domain, task) = input.split_at(input.find(TASK).unwrap_or(input.len()));
        let domain = match read_domain(domain) {
            Ok(domain) => domain,
            Err(error) => return shape(&error.to_string()),
        };
        let task = match read_task(&domain, task) {
            Ok(task) => task,
            Err(error) => return shape(&error.to_string()),
        };
        let mut more = ExtraInputs::default();
        for condition in ["(and)", "(not (at a b))"] {
            more.conditions.extend(read_condition(&domain, &task, condition));
        }
        more.states.extend(read_state(&domain, &task, ""));
        let grounded = match ground(&domain, &task, &more) {
            Ok(grounded) => grounded,
            Err(error) => return shape(&error.to_string()),
        };
        let task = &grounded.task;
        let mut found = Vec::new();
        for state in grounded.states.iter().chain([task.initial_state()]) {
            task.applicable(state.words(), &mut found);
        }
        let magnitude = |number: usize| number.checked_ilog2().map_or(0, |log| log + 1);
        format!(
            "{} facts, {} operators, {} applicable, {} in the goal",
            magnitude(task.fact_count()),
            magnitude(task.operators().len()),
            magnitude(found.len()),
            task.goal().len()
        )
    }
}
