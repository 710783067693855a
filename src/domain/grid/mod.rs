//! What the formats with cells share: the floor, the ways to go, goals that are cells, and
//! observers with cameras and a symbol for each action.
//!
//! Cells are `[column, row]`, row 0 at the top; north goes up. Walls are cells that nothing can
//! enter. An observer sees one symbol for each action; after a step that ends with the robot in a
//! cell with one of its cameras it sees that very cell instead.

mod direction;
mod floor;
mod generate;
mod read;
mod stage;
mod symbols;

use serde::Serialize;

pub use direction::Direction;
pub(super) use floor::Floor;
pub(super) use generate::{Size, goals_in};
pub(super) use read::{Sides, cell, goals, observer, sides};
pub(super) use stage::{Pose, Stage};
pub use symbols::Symbols;

/// Column and row.
pub type Cell = [u32; 2];

/// A candidate goal: something is in a cell.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub struct GridGoal {
    /// Its name.
    pub name: String,
    /// The cell.
    pub cell: Cell,
}

/// An observer. `S` is how its format writes states.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub struct GridObserver<S> {
    /// The states that are possible at first; the start alone when left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub initial_belief: Option<Vec<S>>,
    /// Cells in which the observer sees the robot exactly.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(not(target_arch = "wasm32"), schemars(default))]
    pub cameras: Vec<Cell>,
    /// The symbol of each action.
    pub sensor: Symbols,
}

impl<S> GridObserver<S> {
    /// An observer without cameras.
    pub fn new(initial_belief: Option<Vec<S>>, sensor: Symbols) -> Self {
        Self { initial_belief, cameras: Vec::new(), sensor }
    }
}
