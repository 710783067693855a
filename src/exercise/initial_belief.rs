//! Initial beliefs that are drawn anew: as many states as there were, the start among them.
//!
//! What all states of the old belief had in common with the old start, those of the new one have in common with the new
//! start; the parts in which they differed are drawn.

use serde_json::{Value, json};

use crate::domain::grid::{Cell, Direction};

/// What a drawn state is made of.
pub(super) struct Believable<'a> {
    /// The start of the document before the draw.
    pub(super) start_before: &'a Value,
    /// The start that was drawn.
    pub(super) start: &'a Value,
    /// The cells without a wall.
    pub(super) cells: &'a [Cell],
    /// How many levels a battery has, where there is one.
    pub(super) battery_levels: u64,
}

/// The states that can be in the place of those of an initial belief, by number; the start is none of them.
pub(super) struct Others<'a> {
    start: &'a Value,
    /// The parts that differ among the old states, with the values of each; the key is empty where a state is a cell.
    parts: Vec<(String, Vec<Value>)>,
    /// How many states there were.
    size: usize,
}

impl<'a> Others<'a> {
    /// The states that can be drawn in the place of `believed`.
    pub(super) fn new(believed: &[Value], believable: &Believable<'a>) -> Self {
        let Believable { start_before, start, .. } = *believable;
        let parts = match start {
            Value::Object(start) => start
                .keys()
                .filter(|&key| believed.iter().any(|state| state[key] != start_before[key]))
                .map(|key| (key.clone(), values(key, believed, believable)))
                .collect(),
            _ => vec![(String::new(), values("", believed, believable))],
        };
        let is_new = |&at: &usize| !believed[..at].contains(&believed[at]);
        let size = (0..believed.len()).filter(is_new).count();
        Self { start, parts, size }
    }

    /// How many states there were.
    pub(super) fn size(&self) -> usize {
        self.size
    }

    /// The numbers of all states that are possible.
    pub(super) fn numbers(&self) -> Vec<usize> {
        let count = self.parts.iter().map(|(_, values)| values.len()).product();
        (0..count).filter(|&number| self.is_possible(&self.state(number))).collect()
    }

    /// The state of a number.
    pub(super) fn state(&self, mut number: usize) -> Value {
        let mut state = self.start.clone();
        for (key, values) in &self.parts {
            let value = values[number % values.len()].clone();
            number /= values.len();
            if key.is_empty() {
                return value;
            }
            state[key] = value;
        }
        state
    }

    /// The start is told anyway, and a robot is not where its box is.
    fn is_possible(&self, state: &Value) -> bool {
        state != self.start && (state.get("box").is_none() || state["box"] != state["robot"])
    }
}

/// The values that a part of a state may have. What is not a cell once, as a can that is held, may be so again.
fn values(key: &str, believed: &[Value], believable: &Believable<'_>) -> Vec<Value> {
    match key {
        "facing" => Direction::ALL.iter().map(|direction| json!(direction.name())).collect(),
        "battery" => (0..believable.battery_levels).map(Value::from).collect(),
        _ => {
            let mut values: Vec<Value> = Vec::with_capacity(believable.cells.len() + 1);
            for &[column, row] in believable.cells {
                values.push(Value::Array(vec![column.into(), row.into()]));
            }
            let held = believed.iter().map(|state| &state[key]).find(|value| value.is_string());
            values.extend(held.cloned());
            values
        }
    }
}
