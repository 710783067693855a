//! Reads a `recycling-robot` document.

use super::{ACTIONS, Can, HELD, MAX_LEVELS, MAX_SIDE, RecyclingRobot, RobotState};
use crate::document::DocumentError;
use crate::document::json::Json;
use crate::document::reader::Reader;
use crate::domain::Observers;
use crate::domain::grid::{Sides, cell, goals, observer, sides};

const KEYS: [&str; 10] = [
    "format",
    "width",
    "height",
    "walls",
    "charger",
    "battery_levels",
    "start",
    "goals",
    "true_goal",
    "observers",
];

impl RecyclingRobot {
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
            charger: cell(&fields.required("charger", "a cell")?)?,
            battery_levels: fields
                .required("battery_levels", "a number of levels")?
                .integer(1..=MAX_LEVELS)?,
            start: state(&fields.required("start", "an object with robot, battery and can")?)?,
            goals: goals(&fields)?,
            true_goal: fields.required("true_goal", "the name of a goal")?.text()?.to_owned(),
            observers: Observers::read(&fields, |r| observer(r, &ACTIONS, &[], state))?,
        })
    }
}

fn state(reader: &Reader<'_>) -> Result<RobotState, DocumentError> {
    const CAN: &str = "a cell [column, row], or held";
    let fields = reader.fields(&["robot", "battery", "can"])?;
    let can = fields.required("can", CAN)?;
    Ok(RobotState {
        robot: cell(&fields.required("robot", "a cell")?)?,
        battery: fields.required("battery", "a level")?.integer(0..=MAX_LEVELS - 1)?,
        can: match can.value() {
            Json::Text(text) if **text == *HELD => Can::Held,
            Json::Array(_) => Can::At(cell(&can)?),
            _ => return Err(can.expected(CAN)),
        },
    })
}
