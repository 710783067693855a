//! What the generators of the formats with cells share.

use rand::Rng;

use super::{Cell, GridGoal};
use crate::domain::generate::{GenerateError, draw, in_range};
use crate::problem::MAX_GOALS;

/// The size of a random grid.
pub(in crate::domain) struct Size {
    /// Columns.
    pub(in crate::domain) width: u32,
    /// Rows.
    pub(in crate::domain) height: u32,
    /// Walls.
    pub(in crate::domain) walls: u32,
    /// Cells that something stands in from the start, each in one of its own.
    pub(in crate::domain) taken: u32,
}

impl Size {
    /// The number of free cells, once the numbers make sense.
    pub(in crate::domain) fn check(&self, goals: u32, most: u32) -> Result<u32, GenerateError> {
        in_range("width", self.width, 1..=most)?;
        in_range("height", self.height, 1..=most)?;
        let area = self.width * self.height;
        in_range("cells", area, 2 + self.taken..=most * most)?;
        in_range("goals", goals, 2..=(area - self.taken).min(MAX_GOALS as u32))?;
        in_range("walls", self.walls, 0..=area - goals - self.taken)?;
        Ok(area - self.walls)
    }

    /// Draws walls; with them the cells left free.
    pub(in crate::domain) fn draw(&self, random: &mut impl Rng) -> (Vec<Cell>, Vec<Cell>) {
        let (width, area) = (self.width, self.width * self.height);
        let mut cells = (0..area).map(|index| [index % width, index / width]).collect();
        let walls = draw(random, &mut cells, self.walls as usize);
        (walls, cells)
    }
}

/// Goals G1, G2, … in these cells. The first is the true one.
pub(in crate::domain) fn goals_in(cells: &[Cell]) -> Vec<GridGoal> {
    let goal = |(number, &cell)| GridGoal { name: format!("G{number}"), cell };
    (1..).zip(cells).map(goal).collect()
}
