//! Draws random box pushing.

use super::reach::box_cells;
use super::{BoxPushing, BoxState, MAX_SIDE};
use crate::domain::Observers;
use crate::domain::generate::{
    Drawn, GenerateError, draw, draw_belief, in_range, random, until_solvable,
};
use crate::domain::grid::{Cell, Direction, Floor, GridObserver, Size, goals_in};

/// The size of random box pushing. The default is the paper's: 5 × 5 with one box, three goals in
/// the topmost row and its two sensors; the paper does not say how initial beliefs are drawn, so
/// the observers see where robot and box stand, and do not know where the robot looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BoxPushingShape {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Candidate goals, cells of the topmost row.
    pub goals: u32,
    /// Walls.
    pub walls: u32,
    /// States in each initial belief: ways the robot could look.
    pub belief: u32,
}

impl Default for BoxPushingShape {
    fn default() -> Self {
        Self { width: 5, height: 5, goals: 3, walls: 0, belief: 4 }
    }
}

impl BoxPushingShape {
    /// Draws box pushing in which every candidate goal can be reached: one that cannot would be no
    /// candidate. The first goal is the true one. The box begins below the topmost row.
    ///
    /// # Errors
    ///
    /// The numbers make no sense together, or there are so many walls that no draw is solvable.
    ///
    /// ```
    /// use mo_copp::domain::box_pushing::BoxPushingShape;
    /// let shape = BoxPushingShape::default();
    /// assert_eq!(shape.generate(1)?, shape.generate(1)?);
    /// # Ok::<(), mo_copp::domain::generate::GenerateError>(())
    /// ```
    pub fn generate(self, seed: u64) -> Result<Drawn<BoxPushing>, GenerateError> {
        let Self { width, height, walls, .. } = self;
        let size = Size { width, height, walls, taken: 2 };
        size.check(self.goals, MAX_SIDE)?;
        in_range("height", height, 3..=MAX_SIDE)?;
        in_range("goals", self.goals, 2..=width)?;
        in_range("belief", self.belief, 1..=4)?;
        let mut random = random(seed);
        until_solvable(|| {
            let (walls, mut cells) = size.draw(&mut random);
            let (mut top, mut below): (Vec<Cell>, Vec<Cell>) =
                cells.iter().partition(|[_, row]| *row == 0);
            let goals = goals_in(&draw(&mut random, &mut top, self.goals as usize));
            if goals.len() < self.goals as usize || below.is_empty() {
                return None;
            }
            // Any cell for the robot but the box's.
            let place = draw(&mut random, &mut below, 1)[0];
            cells.retain(|&cell| cell != place);
            let robot = draw(&mut random, &mut cells, 1)[0];
            let looking = |facing| BoxState { robot, facing, r#box: place };
            let start = looking(draw(&mut random, &mut Direction::ALL.to_vec(), 1)[0]);
            let all = Direction::ALL.map(looking);
            let mut belief = || Some(draw_belief(&mut random, start, &all, self.belief));
            let sensors = BoxPushing::paper_sensors();
            let observers = Observers {
                adversarial: GridObserver::new(belief(), sensors.adversarial),
                cooperative: GridObserver::new(belief(), sensors.cooperative),
            };
            let true_goal = goals[0].name.clone();
            let document = BoxPushing { width, height, walls, start, goals, true_goal, observers };
            let floor = Floor::new(width, height, &document.walls, MAX_SIDE).ok()?;
            let reached = box_cells(&floor, &document.start);
            let solvable = document.goals.iter().all(|goal| reached[floor.index(goal.cell)]);
            solvable.then_some(document)
        })
    }
}
