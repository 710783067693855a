//! The JSON Schema of problem documents, made from the types that they are read into (natively only).

use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, SchemaGenerator};
use serde_json::{Map, Value, json};

use super::{
    BoxPushing, Delivery, Explicit, Gridworld, Pddl, RecyclingRobot, box_pushing, gridworld,
    recycling_robot,
};

/// The schema, in draft 2020-12: what keys a document of each format has and what may stand there. Whether the parts
/// fit together (a goal in a wall, a name that is none) only reading it tells.
///
/// ```
/// let schema = mo_copp::domain::schema::schema();
/// assert_eq!(schema["oneOf"].as_array().map(Vec::len), Some(6));
/// ```
pub fn schema() -> Value {
    let mut generator = SchemaSettings::draft2020_12().into_generator();
    let moves = symbols(&gridworld::MOVES, &[gridworld::STAY]);
    let pushing = symbols(&box_pushing::ACTIONS, &[]);
    let recycling = symbols(&recycling_robot::ACTIONS, &[]);
    let formats = [
        format::<Gridworld>(&mut generator, "gridworld", Some(moves)),
        format::<BoxPushing>(&mut generator, "box-pushing", Some(pushing)),
        format::<RecyclingRobot>(&mut generator, "recycling-robot", Some(recycling)),
        format::<Delivery>(&mut generator, "delivery", None),
        format::<Explicit>(&mut generator, "explicit", None),
        format::<Pddl>(&mut generator, "pddl", None),
    ];
    let mut schema = json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "mo-copp problem document",
        "oneOf": formats,
        "$defs": generator.take_definitions(true),
    });
    strict(&mut schema);
    schema
}

/// An object with a symbol for each action.
fn symbols(required: &[&str], optional: &[&str]) -> Value {
    let all = required.iter().chain(optional);
    let properties: Map<String, Value> =
        all.map(|action| ((*action).to_owned(), json!({"type": "string"}))).collect();
    json!({"type": "object", "properties": properties, "required": required})
}

/// The schema of a format; `sensor` is that of its observers where their type does not tell the actions.
fn format<T: JsonSchema>(
    generator: &mut SchemaGenerator,
    name: &str,
    sensor: Option<Value>,
) -> Value {
    let mut schema = T::json_schema(generator).to_value();
    schema["properties"]["format"] = json!({"const": name});
    if let Some(required) = schema["required"].as_array_mut() {
        required.insert(0, json!("format"));
    }
    let Some(sensor) = sensor else { return schema };
    // Observers of each of these formats are a type of their own.
    let Some(observers) = definition(&schema["properties"]["observers"]) else { return schema };
    let observer = definition(&generator.definitions()[&observers]["properties"]["adversarial"]);
    if let Some(observer) = observer
        && let Some(found) = generator.definitions_mut().get_mut(&observer)
    {
        found["properties"]["sensor"] = sensor;
    }
    schema
}

/// The name of the definition that a schema refers to.
fn definition(schema: &Value) -> Option<String> {
    schema["$ref"].as_str()?.rsplit('/').next().map(str::to_owned)
}

/// Allows no keys that are not listed and no null in the place of what is left out, as the reader does.
fn strict(schema: &mut Value) {
    match schema {
        Value::Object(entries) => {
            if entries.contains_key("properties") && entries.get("type") == Some(&json!("object")) {
                entries.entry("additionalProperties").or_insert(json!(false));
            }
            if entries.get("default").is_some_and(Value::is_null) {
                entries.remove("default");
            }
            if let Some(Value::Array(types)) = entries.get_mut("type") {
                types.retain(|kind| kind != "null");
                if let [only] = &types[..] {
                    let only = only.clone();
                    entries.insert("type".to_owned(), only);
                }
            }
            if let Some(Value::Array(any)) = entries.get_mut("anyOf") {
                any.retain(|part| part.get("type") != Some(&json!("null")));
            }
            entries.values_mut().for_each(strict);
        }
        Value::Array(items) => items.iter_mut().for_each(strict),
        _ => {}
    }
}
