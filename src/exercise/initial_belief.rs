//! Initial beliefs that are drawn anew: as many states as there were, the start among them.
//!
//! What all states of the old belief had in common with the old start, those of the new one have in common with the new
//! start; the parts in which they differed are drawn.

use rand::Rng;
use serde_json::{Value, json};

use super::dice::{below, take};
use crate::domain::grid::{Cell, Direction};

/// States that are listed to draw from, at most; of more, numbers are drawn until enough of them fit.
const MOST_LISTED: usize = 20_000;
/// Numbers drawn for each state that is wanted, at most.
const TRIES: usize = 100;

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

    /// As many states as there were, less the start, all different; none where there are too few.
    pub(super) fn draw(&self, random: &mut impl Rng) -> Option<Vec<Value>> {
        let wanted = self.size.checked_sub(1)?;
        let mut sizes = self.parts.iter().map(|(_, values)| values.len());
        let count = sizes.try_fold(1_usize, usize::checked_mul)?;
        let numbers = if count <= MOST_LISTED {
            let mut numbers: Vec<usize> =
                (0..count).filter(|&number| self.is_possible(&self.state(number))).collect();
            take(random, &mut numbers, wanted)?
        } else {
            // Nearly all are possible, and few of them wanted.
            let mut numbers = Vec::with_capacity(wanted);
            for _ in 0..TRIES * (wanted + 1) {
                if numbers.len() == wanted {
                    break;
                }
                let number = below(random, count)?;
                if !numbers.contains(&number) && self.is_possible(&self.state(number)) {
                    numbers.push(number);
                }
            }
            (numbers.len() == wanted).then_some(numbers)?
        };
        Some(numbers.into_iter().map(|number| self.state(number)).collect())
    }

    /// The state of a number.
    fn state(&self, mut number: usize) -> Value {
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

#[cfg(test)]
mod tests {
    use rand::SeedableRng;
    use rand_pcg::Pcg32;

    use super::*;

    /// A floor of 64 × 64 cells has 67 million poses beside a box: they are drawn without a list of them.
    #[test]
    fn states_of_large_floors_are_drawn() {
        let cells: Vec<Cell> =
            (0..64).flat_map(|row| (0..64).map(move |column| [column, row])).collect();
        let pose = |robot: [i32; 2], crate_at: [i32; 2], facing: &str| json!({"robot": robot, "box": crate_at, "facing": facing});
        let (before, start) = (pose([0, 0], [1, 1], "north"), pose([5, 5], [7, 7], "east"));
        let believed =
            [before.clone(), pose([2, 0], [3, 3], "south"), pose([4, 0], [3, 5], "west")];
        let believable =
            Believable { start_before: &before, start: &start, cells: &cells, battery_levels: 0 };
        let others = Others::new(&believed, &believable);
        let mut random = Pcg32::seed_from_u64(7);
        let mut met = Vec::new();
        for _ in 0..50 {
            let states = others.draw(&mut random).into_iter().flatten().collect::<Vec<_>>();
            assert!(states.len() == 2 && states[0] != states[1], "{states:?}");
            for state in states {
                assert!(state != start && state["box"] != state["robot"], "{state}");
                met.push(state);
            }
        }
        assert!(met.iter().any(|state| state["facing"] != "north"), "{met:?}");
    }
}
