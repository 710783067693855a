//! Box Pushing: a robot faces a box and pushes it (Kube and Zhang 1997, "Task modelling in
//! collective robotics", doi:10.1023/A:1008859119831), with one box as in the paper's experiments.
//!
//! The robot stands in a cell and faces one of four directions. `move-forward` takes it one cell
//! on; where the box is in that cell, the box goes one further. Where a wall or the edge of the grid
//! is in the way of either, it changes nothing, and neither does `stay`. `turn-left` and
//! `turn-right` are quarter turns. A goal says in which cell the box must be. Cells, walls and
//! observers are those of [`grid`](super::grid).

mod build;
mod generate;
mod reach;
mod read;

use serde::Serialize;

pub use generate::BoxPushingShape;

use super::Observers;
use super::grid::{Cell, Direction, GridGoal, GridObserver, Symbols};

/// The longest side of a grid: a state has two bits for each cell.
pub const MAX_SIDE: u32 = 32;

/// Goes one cell on, and pushes the box where it is in the way.
const FORWARD: &str = "move-forward";
/// Changes nothing.
const STAY: &str = "stay";
/// A quarter turn.
const LEFT: &str = "turn-left";
/// The other quarter turn.
const RIGHT: &str = "turn-right";

/// The actions, in the order of the paper.
pub(super) const ACTIONS: [&str; 4] = [FORWARD, STAY, LEFT, RIGHT];

/// A `box-pushing` document.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub struct BoxPushing {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Cells that neither robot nor box can enter.
    #[cfg_attr(not(target_arch = "wasm32"), schemars(default))]
    pub walls: Vec<Cell>,
    /// How it begins.
    pub start: BoxState,
    /// The candidate goals: the box is in the cell.
    pub goals: Vec<GridGoal>,
    /// The name of the true one.
    pub true_goal: String,
    /// What the two observers believe and see.
    pub observers: Observers<GridObserver<BoxState>>,
}

/// A state.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub struct BoxState {
    /// Where the robot stands.
    pub robot: Cell,
    /// Where it looks.
    pub facing: Direction,
    /// Where the box is.
    pub r#box: Cell,
}

impl BoxPushing {
    /// The paper's sensors: the enemy tells turns from the rest; the friend tells moves and turns to
    /// the right from the rest.
    pub fn paper_sensors() -> Observers<Symbols> {
        let of = |[forward, stay, left, right]: [&str; 4]| {
            Symbols::new([(FORWARD, forward), (STAY, stay), (LEFT, left), (RIGHT, right)])
        };
        Observers {
            adversarial: of(["move", "move", "turn", "turn"]),
            cooperative: of(["move-right", "leftwards", "leftwards", "move-right"]),
        }
    }
}
