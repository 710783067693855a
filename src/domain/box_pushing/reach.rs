//! Reachable cells of the box: a search over pushes instead of single steps.
//!
//! A node is the box's cell with the robot right behind it, so there are four nodes a cell. The
//! robot turns for nothing, so it gets wherever a flood fill around the box does.

use super::BoxState;
use crate::domain::grid::{Cell, Direction, Floor};

/// For each cell whether the box can be pushed there from the start. Quadratic in the number of
/// cells.
pub(super) fn box_cells(floor: &Floor, start: &BoxState) -> Vec<bool> {
    let mut reached = vec![false; floor.len()];
    reached[floor.index(start.r#box)] = true;
    let mut seen = vec![[false; Direction::ALL.len()]; floor.len()];
    let mut open = vec![(start.r#box, start.robot)];
    while let Some((boxed, robot)) = open.pop() {
        let robot_cells = robot_cells(floor, boxed, robot);
        for (number, direction) in Direction::ALL.into_iter().enumerate() {
            let behind = floor.step(boxed, direction.left().left());
            let can_push = behind.is_some_and(|behind| robot_cells[floor.index(behind)]);
            let Some(beyond) = floor.step(boxed, direction).filter(|_| can_push) else { continue };
            let index = floor.index(beyond);
            reached[index] = true;
            if !std::mem::replace(&mut seen[index][number], true) {
                open.push((beyond, boxed));
            }
        }
    }
    reached
}

/// For each cell whether the robot gets there without a push.
fn robot_cells(floor: &Floor, boxed: Cell, robot: Cell) -> Vec<bool> {
    let mut reached = vec![false; floor.len()];
    reached[floor.index(robot)] = true;
    let mut open = vec![robot];
    while let Some(cell) = open.pop() {
        for direction in Direction::ALL {
            let next = floor.step(cell, direction).filter(|&next| next != boxed);
            if let Some(next) = next
                && !std::mem::replace(&mut reached[floor.index(next)], true)
            {
                open.push(next);
            }
        }
    }
    reached
}

#[cfg(test)]
mod tests {
    use super::super::{BoxPushing, BoxPushingShape, MAX_SIDE};
    use super::*;
    use crate::domain::generate::true_goal_is_reachable;

    /// The cells that the state space of a problem says, each asked for alone.
    fn by_states(document: &BoxPushing, floor: &Floor) -> Vec<bool> {
        let mut document = document.clone();
        let mut of_cell = vec![false; floor.len()];
        for cell in floor.free() {
            for goal in &mut document.goals {
                goal.cell = cell;
            }
            let problem = document.problem().unwrap();
            of_cell[floor.index(cell)] = true_goal_is_reachable(&problem);
        }
        of_cell
    }

    #[test]
    fn pushes_reach_the_cells_that_single_steps_do() {
        for (seed, walls) in (1..25).zip([0, 2, 3, 4].into_iter().cycle()) {
            let shape = BoxPushingShape {
                width: 4,
                height: 4,
                goals: 2,
                walls,
                ..BoxPushingShape::default()
            };
            let mut document = shape.generate(seed).unwrap().document;
            // More walls than a generated problem has, so that some cells are out of reach.
            let taken = [document.start.robot, document.start.r#box];
            let more = [[1, 1], [2, 0], [3, 2]].into_iter().filter(|wall| !taken.contains(wall));
            document.walls.extend(more.take(seed as usize % 3));
            let floor =
                Floor::new(document.width, document.height, &document.walls, MAX_SIDE).unwrap();
            assert_eq!(
                box_cells(&floor, &document.start),
                by_states(&document, &floor),
                "seed {seed}"
            );
        }
    }
}
