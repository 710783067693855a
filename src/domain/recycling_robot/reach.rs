//! Reachable cells of the can: two searches of the robot, first without the can, then with it.
//!
//! A fuller battery allows all that an emptier one does, so the fullest level with which the robot
//! gets to a cell is all that counts.

use super::{Can, RecyclingRobot};
use crate::domain::grid::{Cell, Direction, Floor};

/// For each cell whether the can gets there. Linear in cells times levels.
pub(super) fn can_cells(document: &RecyclingRobot, floor: &Floor) -> Vec<bool> {
    let start = document.start;
    let levels = |from, level| levels(document, floor, from, level);
    let mut reached = vec![false; floor.len()];
    let picked_up = match start.can {
        Can::Held => Some((start.robot, start.battery)),
        Can::At(cell) => {
            let index = floor.index(cell);
            reached[index] = true;
            levels(start.robot, start.battery)[index].map(|level| (cell, level))
        }
    };
    if let Some((cell, level)) = picked_up {
        for (reached, level) in reached.iter_mut().zip(levels(cell, level)) {
            *reached |= level.is_some();
        }
    }
    reached
}

/// The fullest level with which the robot gets to each cell.
fn levels(document: &RecyclingRobot, floor: &Floor, from: Cell, level: u32) -> Vec<Option<u32>> {
    let full = document.battery_levels - 1;
    let mut fullest = vec![None; floor.len()];
    let mut open = vec![(from, level)];
    while let Some((cell, level)) = open.pop() {
        let level = if cell == document.charger { full } else { level };
        let known = &mut fullest[floor.index(cell)];
        if *known >= Some(level) {
            continue;
        }
        *known = Some(level);
        if let Some(less) = level.checked_sub(1) {
            let next = Direction::ALL.into_iter().filter_map(|way| floor.step(cell, way));
            open.extend(next.map(|next| (next, less)));
        }
    }
    fullest
}

#[cfg(test)]
mod tests {
    use super::super::{MAX_SIDE, RecyclingRobotShape};
    use super::*;
    use crate::domain::generate::true_goal_is_reachable;

    #[test]
    fn two_searches_reach_the_cells_that_the_state_space_does() {
        for (seed, levels) in (1..40).zip([2, 3, 4, 5].into_iter().cycle()) {
            let shape = RecyclingRobotShape {
                width: 4,
                height: 3,
                goals: 2,
                walls: 2,
                battery_levels: 5,
                ..RecyclingRobotShape::default()
            };
            let mut document = shape.generate(seed).unwrap().document;
            // Fewer levels than the generated problem needs, so that some cells are out of reach.
            document.battery_levels = levels;
            document.start.battery = levels - 1 - seed as u32 % 2;
            if seed % 5 == 0 {
                document.start.can = Can::Held;
            }
            for observer in
                [&mut document.observers.adversarial, &mut document.observers.cooperative]
            {
                observer.initial_belief = None;
            }
            let floor =
                Floor::new(document.width, document.height, &document.walls, MAX_SIDE).unwrap();
            let reached = can_cells(&document, &floor);
            for cell in floor.free() {
                for goal in &mut document.goals {
                    goal.cell = cell;
                }
                let problem = document.problem().unwrap();
                let by_states = true_goal_is_reachable(&problem);
                assert_eq!(reached[floor.index(cell)], by_states, "seed {seed}, {cell:?}");
            }
        }
    }
}
