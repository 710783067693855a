//! Reads a `gridworld` document.

use super::{Cell, GridGoal, GridObserver, Gridworld, MAX_SIDE, MoveSymbols};
use crate::document::DocumentError;
use crate::document::reader::Reader;
use crate::domain::Observers;

const KEYS: [&str; 9] =
    ["format", "width", "height", "walls", "start", "goals", "true_goal", "stay", "observers"];

impl Gridworld {
    /// Reads keys and types; whether the parts fit together is asked by
    /// [`problem`](Self::problem).
    ///
    /// # Errors
    ///
    /// [`DocumentError`] with the place.
    pub fn read(document: &Reader<'_>) -> Result<Self, DocumentError> {
        let fields = document.fields(&KEYS)?;
        let side = |key| fields.required(key, "a number of cells")?.integer(1..=MAX_SIDE);
        let cells = |reader: Reader<'_>| reader.list(cell);
        Ok(Self {
            width: side("width")?,
            height: side("height")?,
            walls: fields.optional("walls").map(cells).transpose()?.unwrap_or_default(),
            start: cell(&fields.required("start", "a cell")?)?,
            goals: fields.required("goals", "a list of goals")?.list(goal)?,
            true_goal: fields.required("true_goal", "the name of a goal")?.text()?.to_owned(),
            stay: fields.optional("stay").map(|r| r.boolean()).transpose()?.unwrap_or(false),
            observers: Observers::read(&fields, observer)?,
        })
    }
}

fn cell(reader: &Reader<'_>) -> Result<Cell, DocumentError> {
    let expected = || reader.expected("a cell [column, row] of whole numbers from 0");
    let items = reader.items().map_err(|_| expected())?;
    let [column, row] = items.as_slice() else { return Err(expected()) };
    let number = |item: &Reader<'_>| item.integer(0..=u32::MAX).map_err(|_| expected());
    Ok([number(column)?, number(row)?])
}

fn goal(reader: &Reader<'_>) -> Result<GridGoal, DocumentError> {
    let fields = reader.fields(&["name", "cell"])?;
    Ok(GridGoal {
        name: fields.required("name", "the goal's name")?.text()?.to_owned(),
        cell: cell(&fields.required("cell", "a cell")?)?,
    })
}

fn observer(reader: &Reader<'_>) -> Result<GridObserver, DocumentError> {
    let fields = reader.fields(&["initial_belief", "cameras", "sensor"])?;
    let cells = |reader: Reader<'_>| reader.list(cell);
    let moves = fields
        .required("sensor", "an object with a symbol for each move")?
        .fields(&["north", "south", "east", "west", "stay"])?;
    let symbol = |key| Ok(moves.required(key, "the symbol the observer sees")?.text()?.to_owned());
    Ok(GridObserver {
        initial_belief: fields.optional("initial_belief").map(cells).transpose()?,
        cameras: fields.optional("cameras").map(cells).transpose()?.unwrap_or_default(),
        sensor: MoveSymbols {
            north: symbol("north")?,
            south: symbol("south")?,
            east: symbol("east")?,
            west: symbol("west")?,
            stay: match moves.optional("stay") {
                Some(_) => Some(symbol("stay")?),
                None => None,
            },
        },
    })
}
