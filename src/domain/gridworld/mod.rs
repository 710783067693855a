//! Gridworld: an agent moves between cells.
//!
//! A move off the grid or into a wall is not applicable. Cells, walls and observers are those of
//! [`grid`](super::grid).

mod build;
mod generate;
mod read;

use serde::Serialize;

pub use generate::GridworldShape;

use super::Observers;
use super::grid::{Cell, GridGoal, GridObserver, Symbols};

/// The longest side of a grid.
pub const MAX_SIDE: u32 = 256;

/// The moves, which are the four directions.
pub(super) const MOVES: [&str; 4] = ["north", "south", "east", "west"];
/// The action of an agent that stays where it is.
pub(super) const STAY: &str = "stay";

/// A `gridworld` document.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub struct Gridworld {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Cells that nobody can enter.
    #[cfg_attr(not(target_arch = "wasm32"), schemars(default))]
    pub walls: Vec<Cell>,
    /// Where the agent starts.
    pub start: Cell,
    /// The candidate goals.
    pub goals: Vec<GridGoal>,
    /// The name of the true one.
    pub true_goal: String,
    /// Whether the agent may also stay where it is.
    #[cfg_attr(not(target_arch = "wasm32"), schemars(default))]
    pub stay: bool,
    /// What the two observers believe and see.
    pub observers: Observers<GridObserver<Cell>>,
}

impl Gridworld {
    /// The paper's sensors: the enemy tells vertical from horizontal moves, the friend moves to the
    /// north or east from the others.
    pub fn paper_sensors() -> Observers<Symbols> {
        let of = |[north, south, east, west]: [&str; 4]| {
            Symbols::new([("north", north), ("south", south), ("east", east), ("west", west)])
        };
        Observers {
            adversarial: of(["vertical", "vertical", "horizontal", "horizontal"]),
            cooperative: of(["north-east", "south-west", "north-east", "south-west"]),
        }
    }
}
