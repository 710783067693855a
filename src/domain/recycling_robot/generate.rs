//! Draws random recycling robots.

use super::reach::can_cells;
use super::{Can, MAX_LEVELS, MAX_SIDE, RecyclingRobot, RobotState};
use crate::domain::Observers;
use crate::domain::generate::{
    Drawn, GenerateError, draw, draw_belief, in_range, random, until_solvable,
};
use crate::domain::grid::{Floor, GridObserver, Size, goals_in};

/// The size of a random recycling robot's world. The default is the paper's: 4 × 4 with a can, a
/// battery of 5 levels, three goals and its two sensors; the paper does not say how initial beliefs
/// are drawn, so each observer knows where the can lies and how full the battery is, and holds 4
/// random cells possible for the robot, its own among them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RecyclingRobotShape {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Candidate goals: the bins.
    pub goals: u32,
    /// Walls.
    pub walls: u32,
    /// States in each initial belief: cells the robot could be in.
    pub belief: u32,
    /// Levels of the battery.
    pub battery_levels: u32,
}

impl Default for RecyclingRobotShape {
    fn default() -> Self {
        Self { width: 4, height: 4, goals: 3, walls: 0, belief: 4, battery_levels: 5 }
    }
}

impl RecyclingRobotShape {
    /// Draws a world in which every candidate goal can be reached: one that cannot would be no
    /// candidate. The first goal is the true one. Charger, can and bins are in different cells, the
    /// robot begins anywhere, with a full battery.
    ///
    /// # Errors
    ///
    /// The numbers make no sense together, or there are so many walls, or so few levels, that no
    /// draw is solvable.
    ///
    /// ```
    /// use mo_copp::domain::recycling_robot::RecyclingRobotShape;
    /// let shape = RecyclingRobotShape::default();
    /// assert_eq!(shape.generate(1)?, shape.generate(1)?);
    /// # Ok::<(), mo_copp::domain::generate::GenerateError>(())
    /// ```
    pub fn generate(self, seed: u64) -> Result<Drawn<RecyclingRobot>, GenerateError> {
        let Self { width, height, walls, battery_levels, .. } = self;
        let size = Size { width, height, walls, taken: 2 };
        let free = size.check(self.goals, MAX_SIDE)?;
        in_range("battery levels", battery_levels, 2..=MAX_LEVELS)?;
        in_range("belief", self.belief, 1..=free)?;
        let mut random = random(seed);
        until_solvable(|| {
            let (walls, mut cells) = size.draw(&mut random);
            let free = cells.clone();
            let goals = goals_in(&draw(&mut random, &mut cells, self.goals as usize));
            let taken = draw(&mut random, &mut cells, 2);
            let (charger, can, battery) = (taken[0], Can::At(taken[1]), battery_levels - 1);
            let all: Vec<RobotState> =
                free.into_iter().map(|robot| RobotState { robot, battery, can }).collect();
            let start = draw(&mut random, &mut all.clone(), 1)[0];
            let mut belief = || Some(draw_belief(&mut random, start, &all, self.belief));
            let sensors = RecyclingRobot::paper_sensors();
            let observers = Observers {
                adversarial: GridObserver::new(belief(), sensors.adversarial),
                cooperative: GridObserver::new(belief(), sensors.cooperative),
            };
            let document = RecyclingRobot {
                width,
                height,
                walls,
                charger,
                battery_levels,
                start,
                true_goal: goals[0].name.clone(),
                goals,
                observers,
            };
            let floor = Floor::new(width, height, &document.walls, MAX_SIDE).ok()?;
            let reached = can_cells(&document, &floor);
            let solvable = document.goals.iter().all(|goal| reached[floor.index(goal.cell)]);
            solvable.then_some(document)
        })
    }
}
