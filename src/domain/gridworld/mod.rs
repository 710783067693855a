//! Gridworld: an agent moves between cells.
//!
//! Cells are `[column, row]`, row 0 at the top; north goes up. A move off the grid or into a wall is
//! not applicable. The sensor of each observer gives one symbol a move; where the agent ends in a
//! cell with one of its cameras, the observer sees that very cell instead.

mod build;
mod generate;
mod read;

use serde::Serialize;

pub use generate::GridworldShape;

use super::Observers;

/// Column and row.
pub type Cell = [u32; 2];

/// The longest side of a grid.
pub const MAX_SIDE: u32 = 256;

/// A `gridworld` document.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Gridworld {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Cells that nobody can enter.
    pub walls: Vec<Cell>,
    /// Where the agent starts.
    pub start: Cell,
    /// The candidate goals.
    pub goals: Vec<GridGoal>,
    /// The name of the true one.
    pub true_goal: String,
    /// Whether the agent may also stay where it is.
    pub stay: bool,
    /// What the two observers believe and see.
    pub observers: Observers<GridObserver>,
}

/// A candidate goal: to be in a cell.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct GridGoal {
    /// Its name.
    pub name: String,
    /// The cell.
    pub cell: Cell,
}

/// An observer of a gridworld.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct GridObserver {
    /// Cells the agent could be in at first; the start alone when left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub initial_belief: Option<Vec<Cell>>,
    /// Cells in which the observer sees the agent exactly.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub cameras: Vec<Cell>,
    /// The symbol of each move.
    pub sensor: MoveSymbols,
}

/// The symbol an observer sees for each move.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct MoveSymbols {
    /// For a move up.
    pub north: String,
    /// For a move down.
    pub south: String,
    /// For a move to the right.
    pub east: String,
    /// For a move to the left.
    pub west: String,
    /// For staying, where that is allowed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stay: Option<String>,
}

impl MoveSymbols {
    /// The paper's enemy: it tells vertical from horizontal moves.
    pub fn axis() -> Self {
        Self::of(["vertical", "vertical", "horizontal", "horizontal"])
    }

    /// The paper's friend: it tells moves to the north or east from the others.
    pub fn diagonal() -> Self {
        Self::of(["north-east", "south-west", "north-east", "south-west"])
    }

    fn of([north, south, east, west]: [&str; 4]) -> Self {
        Self {
            north: north.to_owned(),
            south: south.to_owned(),
            east: east.to_owned(),
            west: west.to_owned(),
            stay: None,
        }
    }
}
