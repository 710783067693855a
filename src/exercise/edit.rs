//! Edits of a document by its JSON: walls, cameras, starts and goals, whatever its format.

use serde_json::{Value, json};

use crate::document::DocumentError;
use crate::domain::Document;
use crate::domain::grid::Cell;

/// A document that is being changed. [`finish`](Draft::finish) reads it again, so that an edit that does not fit is
/// refused with the same words as a document that holds it.
#[derive(Debug, Clone)]
pub(super) struct Draft(Value);

/// That a box lies in a cell at first.
pub(super) const BOX: &str = "box begins there";

/// A cell as JSON.
fn cell_in(value: &Value) -> Option<Cell> {
    let number = |index: usize| u32::try_from(value.get(index)?.as_u64()?).ok();
    Some([number(0)?, number(1)?])
}

impl Draft {
    /// A copy of a document.
    pub(super) fn new(document: &Document) -> Self {
        // Only texts, numbers and lists: writing them cannot fail.
        Self(serde_json::to_value(document).unwrap_or_default())
    }

    /// The name of the format.
    pub(super) fn format(&self) -> &str {
        self.0["format"].as_str().unwrap_or_default()
    }

    /// The columns and rows, where the format has cells.
    pub(super) fn size(&self) -> Option<[u32; 2]> {
        let side = |key: &str| u32::try_from(self.0.get(key)?.as_u64()?).ok();
        Some([side("width")?, side("height")?])
    }

    /// The cell of the robot or the agent at first.
    pub(super) fn start(&self) -> Option<Cell> {
        let start = self.0.get("start")?;
        cell_in(start).or_else(|| cell_in(start.get("robot")?))
    }

    /// Moves the robot or the agent.
    pub(super) fn set_start(&mut self, cell: Cell) {
        match &mut self.0["start"] {
            Value::Object(pose) => pose["robot"] = json!(cell),
            start => *start = json!(cell),
        }
    }

    /// The walls.
    pub(super) fn walls(&self) -> Vec<Cell> {
        let walls = self.0.get("walls").and_then(Value::as_array);
        walls.map(|walls| walls.iter().filter_map(cell_in).collect()).unwrap_or_default()
    }

    /// Replaces the walls.
    pub(super) fn set_walls(&mut self, walls: &[Cell]) {
        self.0["walls"] = json!(walls);
    }

    /// The cells of the goals, where the format has such.
    pub(super) fn goals(&self) -> Vec<Cell> {
        let goals = self.0.get("goals").and_then(Value::as_array);
        let cell = |goal: &Value| goal.get("cell").and_then(cell_in);
        goals.map(|goals| goals.iter().filter_map(cell).collect()).unwrap_or_default()
    }

    /// Moves the goals.
    pub(super) fn set_goals(&mut self, cells: &[Cell]) {
        let goals = self.0.get_mut("goals").and_then(Value::as_array_mut).into_iter().flatten();
        for (goal, cell) in goals.zip(cells) {
            goal["cell"] = json!(cell);
        }
    }

    /// Makes another candidate goal the true one.
    pub(super) fn set_true_goal(&mut self, name: &str) {
        self.0["true_goal"] = json!(name);
    }

    /// How it begins: a cell, or an object with the parts of a state.
    pub(super) fn start_state(&self) -> &Value {
        &self.0["start"]
    }

    /// What lies on the floor at first, beside the robot, each with its cell: a box, a can, a charger.
    fn lying(&self) -> impl Iterator<Item = (&'static str, Cell)> {
        let start = &self.0["start"];
        let lying = [
            (BOX, start.get("box")),
            ("can begins there", start.get("can")),
            ("charger is there", self.0.get("charger")),
        ];
        lying.into_iter().filter_map(|(what, cell)| Some((what, cell_in(cell?)?)))
    }

    /// The cells in which something lies at first.
    pub(super) fn taken(&self) -> Vec<Cell> {
        self.lying().map(|(_, cell)| cell).collect()
    }

    /// What lies in a cell at first, in words.
    pub(super) fn lying_at(&self, cell: Cell) -> Option<&'static str> {
        self.lying().find(|&(_, place)| place == cell).map(|(what, _)| what)
    }

    /// How many levels a battery has; none where there is no battery.
    pub(super) fn battery_levels(&self) -> u64 {
        self.0.get("battery_levels").and_then(Value::as_u64).unwrap_or_default()
    }

    /// The states that an observer believes at first, where it is told any.
    pub(super) fn belief(&self, observer: &str) -> Option<&[Value]> {
        Some(self.0["observers"][observer].get("initial_belief")?.as_array()?)
    }

    /// Replaces the states that an observer believes at first. They are in order: no place is the start's.
    pub(super) fn set_belief(&mut self, observer: &str, believed: impl Iterator<Item = Value>) {
        // They are few, and a sort of its own is 8 kB of the core.
        let mut states: Vec<Value> = Vec::new();
        let key = |state: &Value| (cell_in(state), state.to_string());
        for state in believed {
            let place = states.iter().position(|other| key(other) > key(&state));
            states.insert(place.unwrap_or(states.len()), state);
        }
        self.0["observers"][observer]["initial_belief"] = Value::Array(states);
    }

    /// The cells that an observer's cameras watch.
    pub(super) fn cameras(&self, observer: &str) -> Vec<Cell> {
        let cameras = self.0["observers"][observer].get("cameras").and_then(Value::as_array);
        cameras.map(|cells| cells.iter().filter_map(cell_in).collect()).unwrap_or_default()
    }

    /// Gives an observer one more camera.
    pub(super) fn add_camera(&mut self, observer: &str, cell: Cell) {
        match &mut self.0["observers"][observer]["cameras"] {
            Value::Array(cameras) => cameras.push(json!(cell)),
            none => *none = json!([cell]),
        }
    }

    /// The changed document.
    pub(super) fn finish(&self) -> Result<Document, DocumentError> {
        Document::parse(&self.0.to_string())
    }
}
