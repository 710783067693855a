//! Reads a `box-pushing` document.

use super::{ACTIONS, BoxPushing, BoxState, MAX_SIDE};
use crate::document::DocumentError;
use crate::document::json::Json;
use crate::document::reader::Reader;
use crate::domain::Observers;
use crate::domain::grid::{Direction, Sides, cell, goals, observer, sides};

const KEYS: [&str; 8] =
    ["format", "width", "height", "walls", "start", "goals", "true_goal", "observers"];

impl BoxPushing {
    /// Reads keys and types; whether the parts fit together is asked by
    /// [`problem`](Self::problem).
    ///
    /// # Errors
    ///
    /// [`DocumentError`] with the place.
    pub(in crate::domain) fn read(document: &Reader<'_>) -> Result<Self, DocumentError> {
        let fields = document.fields(&KEYS)?;
        let Sides { width, height, walls } = sides(&fields, MAX_SIDE)?;
        Ok(Self {
            width,
            height,
            walls,
            start: state(&fields.required("start", "an object with robot, facing and box")?)?,
            goals: goals(&fields)?,
            true_goal: fields.required("true_goal", "the name of a goal")?.text()?.to_owned(),
            observers: Observers::read(&fields, |r| observer(r, &ACTIONS, &[], state))?,
        })
    }
}

fn state(reader: &Reader<'_>) -> Result<BoxState, DocumentError> {
    const FACING: &str = "north, south, east or west";
    let fields = reader.fields(&["robot", "facing", "box"])?;
    let facing = fields.required("facing", FACING)?;
    let direction = match facing.value() {
        Json::Text(name) => Direction::named(name),
        _ => None,
    };
    Ok(BoxState {
        robot: cell(&fields.required("robot", "a cell")?)?,
        facing: direction.ok_or_else(|| facing.expected(FACING))?,
        r#box: cell(&fields.required("box", "a cell")?)?,
    })
}
