//! Bad documents, each with the exact message: the place, what was found, what was expected.

mod boxes;
mod delivery;
mod examples;
mod explicit;
mod fuzz;
mod gridworld;
mod import;
mod import_task;
mod json;
mod names;
pub mod pddl;
mod pddl_leniency;
mod places;
mod robots;
mod round_trip;
mod sensor_tables;

pub use delivery::DELIVERY;
pub use explicit::EXPLICIT;
pub use gridworld::GRIDWORLD;

use mo_copp::domain::Document;
use serde_json::Value;

/// The example of a format in the documentation.
pub fn documented(format: &str) -> &'static str {
    let page = include_str!("../../docs/documents.md");
    let examples = page.split("```json\n").skip(1);
    let mut examples = examples.map(|rest| rest.split("```").next().unwrap());
    examples.find(|text| text.contains(&format!("\"format\": \"{format}\""))).unwrap()
}

/// Reads a document and makes its problem.
fn message(text: &str) -> String {
    let made = Document::parse(text).and_then(|document| document.problem());
    made.map_or_else(|error| error.to_string(), |_| "no error".to_owned())
}

/// A change to a valid document.
enum Change {
    /// Puts a value (given as JSON text) at a place, which may be a new key.
    Put(&'static str, &'static str),
    /// Takes a key away.
    Drop(&'static str),
}

use Change::{Drop, Put};

/// Places are JSON pointers.
fn changed(base: &str, change: &Change) -> String {
    let mut document: Value = serde_json::from_str(base).unwrap();
    let (Put(place, _) | Drop(place)) = change;
    let (parent, key) = place.rsplit_once('/').unwrap();
    let parent = document.pointer_mut(parent).unwrap();
    match (change, parent) {
        (Drop(_), Value::Object(entries)) => {
            entries.remove(key).unwrap();
        }
        (Put(_, value), Value::Object(entries)) => {
            entries.insert(key.to_owned(), serde_json::from_str(value).unwrap());
        }
        (Put(_, value), Value::Array(items)) => {
            items[key.parse::<usize>().unwrap()] = serde_json::from_str(value).unwrap();
        }
        _ => panic!("{place}"),
    }
    document.to_string()
}

/// Checks every message, and that the document is fine without the change.
fn check(base: &str, table: &[(Change, &str)]) {
    assert_eq!(message(base), "no error");
    let mut wrong = Vec::new();
    for (change, expected) in table {
        let found = message(&changed(base, change));
        if found != *expected {
            wrong.push(format!("found    {found}\nexpected {expected}"));
        }
    }
    assert!(wrong.is_empty(), "\n{}\n", wrong.join("\n"));
}
