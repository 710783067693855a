//! Draws random gridworlds.

use super::{Gridworld, MAX_SIDE};
use crate::domain::Observers;
use crate::domain::generate::{
    Drawn, GenerateError, draw, draw_belief, in_range, random, true_goal_is_reachable,
    until_solvable,
};
use crate::domain::grid::{Cell, GridObserver, Size, goals_in};

/// The size of a random gridworld. The default is the paper's: 8 × 8 with three goals and its two
/// sensors; the paper does not say how initial beliefs are drawn, so each observer starts with 11
/// random cells, the start among them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GridworldShape {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Candidate goals.
    pub goals: u32,
    /// Walls.
    pub walls: u32,
    /// Cells in each initial belief.
    pub belief: u32,
}

impl Default for GridworldShape {
    fn default() -> Self {
        Self { width: 8, height: 8, goals: 3, walls: 0, belief: 11 }
    }
}

impl GridworldShape {
    /// Draws a gridworld whose true goal can be reached, in an even number of moves. The first goal
    /// is the true one.
    ///
    /// Even, because the paper tries horizon 12 and raises it by 2: an agent that cannot stay where
    /// it is reaches a cell in even numbers of moves only, or in odd ones only.
    ///
    /// # Errors
    ///
    /// The numbers make no sense together, or there are so many walls that no draw is solvable.
    ///
    /// ```
    /// use mo_copp::domain::gridworld::GridworldShape;
    /// let shape = GridworldShape::default();
    /// assert_eq!(shape.generate(1)?, shape.generate(1)?);
    /// # Ok::<(), mo_copp::domain::generate::GenerateError>(())
    /// ```
    pub fn generate(self, seed: u64) -> Result<Drawn<Gridworld>, GenerateError> {
        let Self { width, height, walls, .. } = self;
        let size = Size { width, height, walls, taken: 1 };
        let free = size.check(self.goals, MAX_SIDE)?;
        in_range("belief", self.belief, 1..=free)?;
        let mut random = random(seed);
        until_solvable(|| {
            let (walls, mut cells) = size.draw(&mut random);
            let free = cells.clone();
            let taken = draw(&mut random, &mut cells, 1 + self.goals as usize);
            let (start, goal_cells) = (taken[0], &taken[1..]);
            // By row, then by column.
            let across = |[column, row]: Cell| [row, column];
            let rows: Vec<[u32; 2]> = free.iter().copied().map(across).collect();
            let mut belief = || {
                let cells = draw_belief(&mut random, across(start), &rows, self.belief);
                Some(cells.into_iter().map(across).collect())
            };
            let sensors = Gridworld::paper_sensors();
            let observers = Observers {
                adversarial: GridObserver::new(belief(), sensors.adversarial),
                cooperative: GridObserver::new(belief(), sensors.cooperative),
            };
            let document = Gridworld {
                width,
                height,
                walls,
                start,
                goals: goals_in(goal_cells),
                true_goal: "G1".to_owned(),
                stay: false,
                observers,
            };
            // Neighbours differ in colour, as on a chess board.
            let colour = |[column, row]: Cell| (column + row) % 2;
            let solvable = colour(start) == colour(goal_cells[0])
                && true_goal_is_reachable(&document.problem().ok()?);
            solvable.then_some(document)
        })
    }
}
