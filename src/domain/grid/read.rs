//! Reads what the formats with cells share.

use super::{Cell, GridGoal, GridObserver, Symbols};
use crate::document::DocumentError;
use crate::document::reader::{Fields, Reader};

/// The size of a grid and its walls.
pub(in crate::domain) struct Sides {
    /// Columns.
    pub(in crate::domain) width: u32,
    /// Rows.
    pub(in crate::domain) height: u32,
    /// Cells that nothing can enter.
    pub(in crate::domain) walls: Vec<Cell>,
}

/// Reads `width`, `height` and `walls`.
pub(in crate::domain) fn sides(fields: &Fields<'_>, most: u32) -> Result<Sides, DocumentError> {
    let side = |key| fields.required(key, "a number of cells")?.integer(1..=most);
    Ok(Sides { width: side("width")?, height: side("height")?, walls: cells(fields, "walls")? })
}

/// A list of cells that may be left out.
fn cells(fields: &Fields<'_>, key: &str) -> Result<Vec<Cell>, DocumentError> {
    fields.optional(key).map(|list| list.list(cell)).transpose().map(Option::unwrap_or_default)
}

/// Reads a cell.
pub(in crate::domain) fn cell(reader: &Reader<'_>) -> Result<Cell, DocumentError> {
    let expected = || reader.expected("a cell [column, row] of whole numbers from 0");
    let [column, row] = reader.array().ok_or_else(expected)?;
    let number = |item: &Reader<'_>| item.integer(0..=u32::MAX).map_err(|_| expected());
    Ok([number(&column)?, number(&row)?])
}

/// Reads the `goals`.
pub(in crate::domain) fn goals(fields: &Fields<'_>) -> Result<Vec<GridGoal>, DocumentError> {
    fields.required("goals", "a list of goals")?.list(|goal| {
        let fields = goal.fields(&["name", "cell"])?;
        Ok(GridGoal {
            name: fields.required("name", "the goal's name")?.name()?.to_owned(),
            cell: cell(&fields.required("cell", "a cell")?)?,
        })
    })
}

/// Reads an observer with a symbol for each of the `required` actions, and for those of the
/// `optional` ones that are there.
pub(in crate::domain) fn observer<'a, S>(
    reader: &Reader<'a>,
    required: &[&'static str],
    optional: &[&'static str],
    state: impl FnMut(&Reader<'a>) -> Result<S, DocumentError>,
) -> Result<GridObserver<S>, DocumentError> {
    let fields = reader.fields(&["initial_belief", "cameras", "sensor"])?;
    Ok(GridObserver {
        initial_belief: fields.optional("initial_belief").map(|r| r.list(state)).transpose()?,
        cameras: cells(&fields, "cameras")?,
        sensor: Symbols::read(&fields, required, optional)?,
    })
}
