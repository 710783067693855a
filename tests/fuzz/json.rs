//! Changes of JSON texts.

use serde_json::{Value, json};

use crate::dice::Dice;
use crate::lists;

/// A text with one change: mostly of a value, now and then of a byte.
pub fn changed(dice: &mut Dice, text: &str, other: &str) -> String {
    let parsed = serde_json::from_str::<Value>(text);
    match parsed {
        Ok(mut value) if !dice.percent(5) => {
            let other = serde_json::from_str(other).unwrap_or(Value::Null);
            change(dice, &mut value, &other);
            value.to_string()
        }
        _ => bytes(dice, text),
    }
}

/// A byte left out, doubled or replaced.
pub fn bytes(dice: &mut Dice, text: &str) -> String {
    let mut bytes = text.as_bytes().to_vec();
    if bytes.is_empty() {
        return "{".to_owned();
    }
    let at = dice.below(bytes.len());
    match dice.below(4) {
        0 => drop(bytes.remove(at)),
        1 => bytes.insert(at, bytes[at]),
        2 => bytes[at] = dice.below(256) as u8,
        _ => bytes.truncate(at),
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

fn change(dice: &mut Dice, value: &mut Value, other: &Value) {
    let mut places = Vec::new();
    list(value, String::new(), &mut places);
    let place = &places[dice.below(places.len())];
    // Of the other document, a part under the same key where there is one.
    let key = place.rsplit('/').next().unwrap_or_default().to_owned();
    let mut others = Vec::new();
    list(other, String::new(), &mut others);
    let alike: Vec<_> = others.iter().filter(|one| one.ends_with(&format!("/{key}"))).collect();
    let given = if alike.is_empty() {
        &others[dice.below(others.len())]
    } else {
        alike[dice.below(alike.len())]
    };
    let given = other.pointer(given).cloned().unwrap_or(Value::Null);
    let Some(found) = value.pointer_mut(place) else { return };
    match dice.below(4) {
        0 => *found = given,
        1 => *found = odd(dice),
        _ => within(dice, found, given),
    }
}

/// A change that fits the kind of value.
fn within(dice: &mut Dice, value: &mut Value, given: Value) {
    match value {
        Value::Array(items) => lists::change(dice, items, given),
        Value::Object(entries) => {
            let keys: Vec<_> = entries.keys().cloned().collect();
            if keys.is_empty() {
                entries.insert("name".to_owned(), given);
                return;
            }
            let key = keys[dice.below(keys.len())].clone();
            match dice.below(3) {
                0 => drop(entries.remove(&key)),
                1 => drop(entries.insert(key, given)),
                _ => drop(entries.insert(format!("{key}s"), given)),
            }
        }
        Value::String(text) => {
            *text = match dice.below(3) {
                0 => bytes(dice, text),
                1 if text.contains('(') => {
                    lists::changed_text(dice, text, given.as_str().unwrap_or("(and)"))
                }
                _ => given.as_str().unwrap_or("").to_owned(),
            };
        }
        Value::Number(number) => {
            let now = number.as_i64().unwrap_or(0);
            *value = json!(now.saturating_add(dice.below(5) as i64 - 2));
        }
        Value::Bool(yes) => *yes = !*yes,
        Value::Null => *value = given,
    }
}

fn odd(dice: &mut Dice) -> Value {
    match dice.below(10) {
        0 => Value::Null,
        1 => json!([]),
        2 => json!({}),
        3 => json!(u64::MAX),
        4 => json!(-1),
        5 => json!(1e300),
        6 => json!(""),
        7 => json!("\u{200b}\u{202e}"),
        8 => json!([[0, 0], [0, 0]]),
        _ => json!(dice.below(70)),
    }
}

/// Every place of a value, as JSON Pointer writes it.
fn list(value: &Value, place: String, found: &mut Vec<String>) {
    match value {
        Value::Array(items) => {
            for (index, item) in items.iter().enumerate() {
                list(item, format!("{place}/{index}"), found);
            }
        }
        Value::Object(entries) => {
            for (key, item) in entries {
                list(item, format!("{place}/{}", key.replace('~', "~0").replace('/', "~1")), found);
            }
        }
        _ => {}
    }
    found.push(place);
}
