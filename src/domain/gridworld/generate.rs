//! Draws random gridworlds.

use super::{Gridworld, MAX_SIDE};
use crate::domain::Observers;
use crate::domain::generate::{
    Drawn, GenerateError, MAX_TRIES, draw, in_range, random, true_goal_is_reachable,
};
use crate::domain::grid::{Cell, GridGoal, GridObserver};
use crate::problem::MAX_GOALS;

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
    /// Draws a gridworld whose true goal can be reached. The first goal is the true one.
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
        let area = self.check()?;
        let mut random = random(seed);
        for redraws in 0..MAX_TRIES {
            let all: Vec<Cell> =
                (0..area).map(|index| [index % self.width, index / self.width]).collect();
            let mut cells = all.clone();
            let walls = draw(&mut random, &mut cells, self.walls as usize);
            let free = cells.clone();
            let taken = draw(&mut random, &mut cells, 1 + self.goals as usize);
            let (start, goal_cells) = (taken[0], &taken[1..]);
            let mut belief = || {
                let mut others: Vec<Cell> =
                    free.iter().copied().filter(|cell| *cell != start).collect();
                let mut cells = draw(&mut random, &mut others, self.belief as usize - 1);
                cells.push(start);
                cells.sort_unstable_by_key(|[column, row]| (*row, *column));
                Some(cells)
            };
            let sensors = Gridworld::paper_sensors();
            let observers = Observers {
                adversarial: GridObserver::new(belief(), sensors.adversarial),
                cooperative: GridObserver::new(belief(), sensors.cooperative),
            };
            let goal = |(index, cell): (usize, &Cell)| GridGoal {
                name: format!("G{}", index + 1),
                cell: *cell,
            };
            let document = Gridworld {
                width: self.width,
                height: self.height,
                walls,
                start,
                goals: goal_cells.iter().enumerate().map(goal).collect(),
                true_goal: "G1".to_owned(),
                stay: false,
                observers,
            };
            if document.problem().is_ok_and(|problem| true_goal_is_reachable(&problem)) {
                return Ok(Drawn { document, redraws });
            }
        }
        Err(GenerateError::Unsolvable { tries: MAX_TRIES })
    }

    /// The number of cells, once the numbers make sense.
    fn check(self) -> Result<u32, GenerateError> {
        in_range("width", self.width, 1..=MAX_SIDE)?;
        in_range("height", self.height, 1..=MAX_SIDE)?;
        let area = self.width * self.height;
        in_range("cells", area, 3..=MAX_SIDE * MAX_SIDE)?;
        let most_goals = area.saturating_sub(1).min(MAX_GOALS as u32);
        in_range("goals", self.goals, 2..=most_goals)?;
        in_range("walls", self.walls, 0..=area - self.goals - 1)?;
        in_range("belief", self.belief, 1..=area - self.walls)?;
        Ok(area)
    }
}
