//! The floor of a board of cells: where its cells are drawn, and which of them parts of a state are in.

use std::fmt::Write;

use crate::domain::grid::Cell;
use crate::problem::{StateLabel, Value};
use crate::report::{BeliefReport, Feature, Share};

use super::SIDE;
use super::svg::Number;

/// What does not change from step to step.
pub(super) struct Floor<'a> {
    pub width: u32,
    pub height: u32,
    pub walls: &'a [Cell],
    pub charger: Option<Cell>,
    /// Whether columns and rows have their numbers at the edges.
    pub numbers: bool,
}

/// Room for numbers at an edge.
const EDGE: f64 = 24.0;
/// Numbers nearer than this run into each other.
pub(super) const APART: f64 = 22.0;

impl Floor<'_> {
    /// What the numbers take from the board.
    pub(super) fn edge(&self) -> f64 {
        if self.numbers { EDGE } else { 0.0 }
    }

    /// The side of a cell.
    pub(super) fn side(&self) -> f64 {
        (SIDE - self.edge()) / f64::from(self.width.max(self.height).max(1))
    }

    /// The left upper corner of the grid, which stands with its numbers in the middle of the board.
    pub(super) fn origin(&self) -> [f64; 2] {
        let (side, edge) = (self.side(), self.edge());
        [self.width, self.height].map(|cells| edge + (SIDE - edge - side * f64::from(cells)) / 2.0)
    }

    /// The middle of a cell.
    pub(super) fn middle(&self, cell: Cell) -> [f64; 2] {
        let (side, origin) = (self.side(), self.origin());
        [0, 1].map(|axis| origin[axis] + side * (f64::from(cell[axis]) + 0.5))
    }

    /// How large a sign in a cell is: it may be larger than the cell where cells are small.
    pub(super) fn sign(&self) -> f64 {
        self.side() * (f64::from(self.width.max(self.height)) / 14.0).max(1.0)
    }

    pub(super) fn squares(&self, cells: impl IntoIterator<Item = Cell>) -> String {
        let side = self.side();
        let inner = Number(side * 0.94);
        let [left, top] = self.origin();
        let mut path = String::new();
        for [column, row] in cells {
            let x = Number(left + side * f64::from(column) + side * 0.03);
            let y = Number(top + side * f64::from(row) + side * 0.03);
            // Writing to a text cannot fail.
            let _ = write!(path, "M{x} {y}h{inner}v{inner}h-{inner}z");
        }
        path
    }
}

/// A cell that a part of the state may be in, and whether it is in every believed state.
pub(super) struct Spot {
    pub(super) cell: Cell,
    pub(super) certain: bool,
}

/// The cell of a part of a state; a gridworld's state is the agent's cell.
pub(super) fn place(state: &StateLabel, part: &str) -> Option<Cell> {
    match state {
        StateLabel::Cell(column, row) if part == "robot" => Some([*column, *row]),
        StateLabel::Parts(parts) => parts.iter().find_map(|(key, value)| match value {
            Value::Cell(column, row) if *key == part => Some([*column, *row]),
            _ => None,
        }),
        _ => None,
    }
}

pub(super) fn spots(summary: &BeliefReport, wanted: &str) -> Vec<Spot> {
    let spot = |share: &Share| match &share.feature {
        Feature::Part { part, value: Value::Cell(column, row) } if *part == wanted => {
            Some(Spot { cell: [*column, *row], certain: share.states == summary.states })
        }
        _ => None,
    };
    summary.shares.iter().filter_map(spot).collect()
}
