//! Reads a `gridworld` document.

use super::{Gridworld, MAX_SIDE, MOVES, STAY};
use crate::document::DocumentError;
use crate::document::reader::Reader;
use crate::domain::Observers;
use crate::domain::grid::{Sides, cell, goals, observer, sides};

const KEYS: [&str; 9] =
    ["format", "width", "height", "walls", "start", "goals", "true_goal", "stay", "observers"];

impl Gridworld {
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
            start: cell(&fields.required("start", "a cell")?)?,
            goals: goals(&fields)?,
            true_goal: fields.required("true_goal", "the name of a goal")?.text()?.to_owned(),
            stay: fields.optional("stay").map(|r| r.boolean()).transpose()?.unwrap_or(false),
            observers: Observers::read(&fields, |r| observer(r, &MOVES, &[STAY], cell))?,
        })
    }
}
