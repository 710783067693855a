//! The JSON Schema of documents with exercises: that of documents, and the block beside each format.

use serde_json::{Map, Value, json};

use super::answer::MAX_ANSWER;
use super::block::{Hidden, Vary};
use super::kind::{KINDS, Kind};
use crate::domain::EXERCISE;

/// Adds the block `exercise` to each format of the schema of problem documents.
///
/// ```
/// use mo_copp::{domain, exercise};
/// let schema = exercise::schema::with_exercises(domain::schema::schema());
/// assert_eq!(schema["$defs"]["Exercise"]["oneOf"].as_array().map(Vec::len), Some(6));
/// ```
pub fn with_exercises(mut schema: Value) -> Value {
    for format in schema["oneOf"].as_array_mut().into_iter().flatten() {
        format["properties"][EXERCISE] = json!({"$ref": "#/$defs/Exercise"});
    }
    let kinds: Vec<Value> = KINDS.iter().map(|kind| of_kind(kind)).collect();
    schema["$defs"]["Exercise"] = json!({"oneOf": kinds});
    schema
}

fn of_kind(kind: &str) -> Value {
    let text = json!({"type": "string", "minLength": 1});
    let names =
        |names: Vec<&str>| json!({"type": "array", "items": {"enum": names}, "uniqueItems": true});
    let mut properties = Map::from_iter([
        ("kind".to_owned(), json!({"const": kind})),
        ("title".to_owned(), text.clone()),
        ("introduction".to_owned(), text.clone()),
        ("hints".to_owned(), json!({"type": "array", "items": text, "maxItems": 20})),
        ("attempts".to_owned(), json!({"type": "integer", "minimum": 1, "maximum": 99})),
        ("hide".to_owned(), names(Hidden::ALL.map(Hidden::name).to_vec())),
        (
            "lock".to_owned(),
            json!({"oneOf": [{"type": "boolean"}, {"type": "array", "items": {"type": "string"}, "uniqueItems": true}]}),
        ),
        ("vary".to_owned(), names(Vary::ALL.map(Vary::name).to_vec())),
    ]);
    let keys = Kind::keys(kind);
    for &key in keys {
        properties.insert(key.to_owned(), of_key(key));
    }
    let mut schema =
        json!({"type": "object", "properties": properties, "additionalProperties": false});
    schema["required"] = match kind {
        "walk" | "best" => json!(["kind"]),
        _ => json!([&["kind"][..], keys].concat()),
    };
    if kind == "walk" {
        schema["anyOf"] = keys.iter().map(|key| json!({"required": [key]})).collect();
    }
    schema
}

fn of_key(key: &str) -> Value {
    match key {
        "observer" => json!({"enum": ["adversarial", "cooperative"]}),
        "plan" => {
            json!({"type": "array", "items": {"type": "string", "minLength": 1}, "maxItems": 100})
        }
        "place" => json!({"enum": ["camera", "wall", "start"]}),
        "goal_difference" => json!({"type": "number", "minimum": -1, "maximum": 1}),
        "at_most" => json!({"type": "integer", "minimum": 1, "maximum": MAX_ANSWER}),
        "shortest" | "possible" => json!({"type": "boolean"}),
        _ => json!({"type": "string", "minLength": 1}),
    }
}
