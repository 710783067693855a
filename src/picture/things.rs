//! What lies on a floor: the box and the can, where they are and where they were at first.

use crate::domain::grid::Cell;

use super::boards::{BoardInput, Owner};
use super::floor::{Floor, Spot, place, spots};
use super::svg::{Number, Svg};

/// What lies on the floor.
struct Thing {
    /// The part of a state that says where it is.
    part: &'static str,
    /// Its width and height in cells.
    size: [f64; 2],
    /// The same in the cell of a goal, whose badge it must stand out behind.
    behind_a_goal: [f64; 2],
}

const THINGS: [Thing; 2] = [
    Thing { part: "box", size: [0.56, 0.56], behind_a_goal: [0.82, 0.82] },
    Thing { part: "can", size: [0.34, 0.34 * 1.35], behind_a_goal: [0.5, 0.86] },
];

impl Thing {
    /// Its width and height in a cell of a board.
    fn size_in(&self, cell: Cell, input: &BoardInput<'_>, floor: &Floor<'_>) -> [f64; 2] {
        let with_goal = input.scene.goals.iter().any(|goal| goal.cell == Some(cell));
        let size = if with_goal { self.behind_a_goal } else { self.size };
        size.map(|part| part * floor.sign())
    }
}

/// Where the box or the can was at first, once it is elsewhere: an outline as faint as that of the robot's start.
pub(super) fn begun(svg: &mut Svg, input: &BoardInput<'_>, floor: &Floor<'_>) {
    for thing @ Thing { part, .. } in &THINGS {
        let first = input.steps.first().and_then(|step| place(&step.state, part));
        let Some(cell) = first.filter(|&cell| place(&input.step().state, part) != Some(cell))
        else {
            continue;
        };
        let [x, y] = floor.middle(cell);
        let [width, height] = thing.size_in(cell, input, floor);
        let line = Number((floor.sign() * 0.05).max(1.0));
        svg.rect(
            [x - width / 2.0, y - height / 2.0, width, height],
            format_args!(
                r#"rx="2" fill="none" stroke="{}" stroke-width="{line}""#,
                input.palette.muted
            ),
        );
    }
}

/// The box or the can: solid where it is certain, dashed where it is one of several places.
pub(super) fn things(svg: &mut Svg, input: &BoardInput<'_>, floor: &Floor<'_>) {
    let palette = input.palette;
    for thing @ Thing { part, .. } in &THINGS {
        let spots = match (input.owner, input.summary()) {
            (Owner::Observer(_), Some(summary)) => spots(summary, part),
            _ => {
                let cell = place(&input.step().state, part);
                cell.into_iter().map(|cell| Spot { cell, certain: true }).collect()
            }
        };
        for Spot { cell, certain } in spots {
            let [x, y] = floor.middle(cell);
            let [width, height] = thing.size_in(cell, input, floor);
            let look = if certain {
                format!(r#"fill="{}" stroke="{}""#, palette.parcel, palette.parcel_edge)
            } else {
                format!(
                    r#"fill="none" stroke="{}" stroke-dasharray="3 2" stroke-width="1.5""#,
                    palette.parcel_edge
                )
            };
            let corner = [x - width / 2.0, y - height / 2.0, width, height];
            svg.rect(corner, format_args!(r#"rx="2" {look}"#));
        }
    }
}
