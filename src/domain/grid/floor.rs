//! The cells of a grid, once its sizes and walls have been checked.

use super::{Cell, Direction};
use crate::document::DocumentError;
use crate::problem::Value;
use crate::task::{Fact, TaskBuilder};

/// Cells by number, row by row, and which of them are no walls.
#[derive(Debug)]
pub(in crate::domain) struct Floor {
    width: u32,
    height: u32,
    free: Vec<bool>,
}

impl Floor {
    /// Checks sizes and walls.
    pub(in crate::domain) fn new(
        width: u32,
        height: u32,
        walls: &[Cell],
        most: u32,
    ) -> Result<Self, DocumentError> {
        for (key, side) in [("width", width), ("height", height)] {
            if !(1..=most).contains(&side) {
                let expected = format!("a whole number from 1 to {most}");
                return Err(DocumentError::invalid(key, side.to_string(), expected));
            }
        }
        let mut floor = Self { width, height, free: vec![true; width as usize * height as usize] };
        for (index, &wall) in walls.iter().enumerate() {
            floor.check_inside(|| format!("walls[{index}]"), wall)?;
            let wall = floor.index(wall);
            floor.free[wall] = false;
        }
        Ok(floor)
    }

    /// How many cells there are, walls included.
    pub(in crate::domain) fn len(&self) -> usize {
        self.free.len()
    }

    /// The number of a cell inside the grid.
    pub(in crate::domain) fn index(&self, [column, row]: Cell) -> usize {
        row as usize * self.width as usize + column as usize
    }

    /// All cells, walls included, in the order of their numbers.
    pub(in crate::domain) fn all(&self) -> impl Iterator<Item = Cell> + use<> {
        let (width, height) = (self.width, self.height);
        (0..height).flat_map(move |row| (0..width).map(move |column| [column, row]))
    }

    /// The cells that are no walls, in the order of their numbers.
    pub(in crate::domain) fn free(&self) -> impl Iterator<Item = Cell> + '_ {
        self.all().filter(|&cell| self.free[self.index(cell)])
    }

    /// The free cell next to one in a direction.
    pub(in crate::domain) fn step(
        &self,
        [column, row]: Cell,
        direction: Direction,
    ) -> Option<Cell> {
        let (right, down) = direction.offset();
        let cell = [column.checked_add_signed(right)?, row.checked_add_signed(down)?];
        (self.is_inside(cell) && self.free[self.index(cell)]).then_some(cell)
    }

    /// Adds a fact for each cell, walls included: `what` and the cell.
    pub(in crate::domain) fn facts(&self, builder: &mut TaskBuilder, what: &str) -> Vec<Fact> {
        self.all().map(|[column, row]| builder.fact(format!("{what} {column},{row}"))).collect()
    }

    /// Such facts with the cells they mean.
    pub(in crate::domain) fn values(&self, facts: &[Fact]) -> Vec<(Fact, Value)> {
        let cells = self.all().map(|[column, row]| Value::Cell(column, row));
        facts.iter().copied().zip(cells).collect()
    }

    fn is_inside(&self, [column, row]: Cell) -> bool {
        column < self.width && row < self.height
    }

    /// The cell must be inside the grid.
    pub(super) fn check_inside(
        &self,
        path: impl FnOnce() -> String,
        cell: Cell,
    ) -> Result<(), DocumentError> {
        if self.is_inside(cell) {
            return Ok(());
        }
        let [column, row] = cell;
        let expected = format!("a cell inside the {} × {} grid", self.width, self.height);
        Err(DocumentError::invalid(path(), format!("[{column}, {row}]"), expected))
    }

    /// The cell must be inside the grid and no wall.
    pub(in crate::domain) fn check_free(
        &self,
        path: impl Fn() -> String,
        cell: Cell,
    ) -> Result<(), DocumentError> {
        self.check_inside(&path, cell)?;
        if self.free[self.index(cell)] {
            return Ok(());
        }
        let found = format!("[{}, {}], which is a wall", cell[0], cell[1]);
        Err(DocumentError::invalid(path(), found, "a free cell"))
    }
}
