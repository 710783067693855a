//! Boards of cells: gridworld, box pushing and recycling robot.

use std::fmt::Write;

use crate::belief::StateCount;
use crate::domain::grid::Cell;
use crate::problem::{StateLabel, Value};
use crate::report::Feature;

use super::boards::{BoardInput, Owner};
use super::floor::{APART, Floor, place, spots};
use super::signs::{bolt, star};
use super::svg::{Anchor, Escaped, Number, Svg, fitting};
use super::things::{begun, things};

pub(super) fn draw(svg: &mut Svg, input: &BoardInput<'_>, floor: &Floor<'_>, start: Cell) {
    let palette = input.palette;
    let believed: Vec<Cell> = match input.owner {
        Owner::Actor => Vec::new(),
        Owner::Observer(_) => match input.summary() {
            Some(summary) => spots(summary, "robot").iter().map(|spot| spot.cell).collect(),
            None => input.belief().iter().filter_map(|state| place(state, "robot")).collect(),
        },
    };
    let all = (0..floor.height).flat_map(|row| (0..floor.width).map(move |column| [column, row]));
    svg.raw(format_args!(r#"<path d="{}" fill="{}"/>"#, floor.squares(all), palette.floor));
    if !believed.is_empty() {
        let path = floor.squares(believed.iter().copied());
        svg.raw(format_args!(r#"<path d="{path}" fill="{}"/>"#, input.tone.tint));
    }
    if !floor.walls.is_empty() {
        let path = floor.squares(floor.walls.iter().copied());
        svg.raw(format_args!(r#"<path d="{path}" fill="{}"/>"#, palette.wall));
    }
    if floor.numbers {
        edge_numbers(svg, floor, palette.muted);
    }
    cameras(svg, input, floor);
    let side = floor.side();
    for &cell in &believed {
        svg.circle(floor.middle(cell), side * 0.1, format_args!(r#"fill="{}""#, input.tone.strong));
    }
    let stroke = format_args!(
        r#"fill="none" stroke="{}" stroke-width="{}""#,
        palette.muted,
        Number((floor.sign() * 0.05).max(1.0))
    )
    .to_string();
    svg.circle(floor.middle(start), floor.sign() * 0.2, &stroke);
    if let Some(charger) = floor.charger {
        bolt(svg, floor.middle(charger), floor.sign() * 0.3, palette.star, palette.star_edge);
    }
    if input.owner == Owner::Actor {
        way(svg, input, floor);
    }
    begun(svg, input, floor);
    things(svg, input, floor);
    goals(svg, input, floor);
    robot(svg, input, floor);
}

/// The numbers of columns and rows, by which cells are named; where cells are small, of some of them.
fn edge_numbers(svg: &mut Svg, floor: &Floor<'_>, colour: &str) {
    const SIZE: f64 = 16.0;
    let ([left, top], side) = (floor.origin(), floor.side());
    let each = [1, 2, 5, 10].into_iter().find(|&each| f64::from(each) * side >= APART);
    let each = each.unwrap_or(20) as usize;
    let look = format!(r#"fill="{colour}""#);
    for column in (0..floor.width).step_by(each) {
        let x = left + side * (f64::from(column) + 0.5);
        svg.text([x, top - 6.0], SIZE, Anchor::Middle, &column.to_string(), &look);
    }
    for row in (0..floor.height).step_by(each) {
        let y = top + side * (f64::from(row) + 0.5) + SIZE * 0.35;
        svg.text([left - 6.0, y], SIZE, Anchor::End, &row.to_string(), &look);
    }
}

/// The corners of the cells that a camera watches.
fn cameras(svg: &mut Svg, input: &BoardInput<'_>, floor: &Floor<'_>) {
    let side = floor.side();
    let mut path = String::new();
    for &cell in input.cameras().iter().filter(|cell| !floor.walls.contains(cell)) {
        let [x, y] = floor.middle(cell);
        for (right, down) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
            let (corner_x, corner_y) = (x + right * side * 0.4, y + down * side * 0.4);
            let _ = write!(
                path,
                "M{} {}V{}H{}",
                Number(corner_x),
                Number(corner_y - down * side * 0.2),
                Number(corner_y),
                Number(corner_x - right * side * 0.2)
            );
        }
    }
    if !path.is_empty() {
        let width = Number((side * 0.04).max(1.0));
        svg.raw(format_args!(
            r#"<path d="{path}" fill="none" stroke="{}" stroke-width="{width}"/>"#,
            input.tone.strong
        ));
    }
}

/// The agent's way: walked as a line, to come as dots.
fn way(svg: &mut Svg, input: &BoardInput<'_>, floor: &Floor<'_>) {
    let points = |steps: &[crate::report::StepReport]| -> String {
        let cells = steps.iter().filter_map(|step| place(&step.state, "robot"));
        let point = |cell| {
            let [x, y] = floor.middle(cell);
            format!("{},{}", Number(x), Number(y))
        };
        cells.map(point).collect::<Vec<_>>().join(" ")
    };
    let width = Number((floor.side() * 0.08).max(1.5));
    let dash = Number((floor.side() * 0.2).max(3.0));
    let palette = input.palette;
    svg.raw(format_args!(
        r#"<polyline points="{}" fill="none" stroke="{}" stroke-width="{width}" stroke-linecap="round" stroke-dasharray="0.1 {dash}"/>"#,
        points(&input.steps[input.at..]),
        palette.muted
    ));
    svg.raw(format_args!(
        r#"<polyline points="{}" fill="none" stroke="{}" stroke-width="{width}" stroke-linecap="round" stroke-linejoin="round"/>"#,
        points(&input.steps[..=input.at]),
        palette.ink
    ));
}

/// Candidate goals: a badge each; those of one cell stand side by side.
fn goals(svg: &mut Svg, input: &BoardInput<'_>, floor: &Floor<'_>) {
    let palette = input.palette;
    for (index, goal) in input.scene.goals.iter().enumerate() {
        let Some(cell) = goal.cell else { continue };
        let together: Vec<usize> = input
            .scene
            .goals
            .iter()
            .enumerate()
            .filter(|(_, other)| other.cell == Some(cell))
            .map(|(at, _)| at)
            .collect();
        let columns = together.len().isqrt().max(1);
        let rows = together.len().div_ceil(columns);
        let rank = together.iter().position(|&at| at == index).unwrap_or(0);
        let share = |at: usize, of: usize, room: f64| ((at as f64 + 0.5) / of as f64 - 0.5) * room;
        let [x, y] = floor.middle(cell);
        let size = floor.sign() * (1.25 / rows as f64).min(1.1 / columns as f64).min(1.0);
        let x = x + share(rank % columns, columns, 0.8 * floor.sign());
        let y = y + share(rank / columns, rows, 0.9 * floor.sign());
        let (fill, ink, edge) = match input.owner {
            Owner::Actor => (palette.card, palette.ink, palette.ink),
            Owner::Observer(observer) if input.survives(observer, &goal.name) => {
                (input.tone.strong, palette.on_strong, input.tone.strong)
            }
            Owner::Observer(_) => (palette.card, palette.muted, palette.muted),
        };
        svg.raw("<g><title>");
        svg.raw(Escaped(&goal.name));
        svg.raw("</title>");
        let frame = [x - size * 0.35, y - size * 0.27, size * 0.7, size * 0.54];
        let line = Number((size * 0.04).max(1.0));
        svg.rect(
            frame,
            format_args!(
                r#"rx="{}" fill="{fill}" stroke="{edge}" stroke-width="{line}""#,
                Number(size * 0.16)
            ),
        );
        if fill == palette.card && input.owner != Owner::Actor && input.is_last() {
            svg.raw(format_args!(
                r#"<path d="M{} {}L{} {}" stroke="{edge}" stroke-width="{line}"/>"#,
                Number(x - size * 0.33),
                Number(y + size * 0.25),
                Number(x + size * 0.33),
                Number(y - size * 0.25)
            ));
        }
        let label = fitting(&goal.name, size * 0.34, size * 0.72);
        let weight = r#"font-weight="600""#;
        let at = [x, y + size * 0.12];
        svg.text(at, size * 0.34, Anchor::Middle, &label, format_args!(r#"fill="{ink}" {weight}"#));
        if goal.name == input.scene.true_goal {
            star(
                svg,
                [x + size * 0.33, y - size * 0.28],
                size * 0.2,
                palette.star,
                palette.star_edge,
            );
        }
        svg.raw("</g>");
    }
}

/// The agent: solid on its own board, a dashed outline on an observer's, which does not see it.
fn robot(svg: &mut Svg, input: &BoardInput<'_>, floor: &Floor<'_>) {
    let state = &input.step().state;
    let Some(cell) = place(state, "robot") else { return };
    let palette = input.palette;
    let on_goal = input.scene.goals.iter().any(|goal| goal.cell == Some(cell));
    let size = floor.sign();
    let radius = size * if on_goal { 0.44 } else { 0.27 };
    let width = Number((size * 0.06).max(1.5));
    let look = match (input.owner, on_goal) {
        (Owner::Actor, false) => format!(r#"fill="{}""#, palette.ink),
        (Owner::Actor, true) => {
            format!(r#"fill="none" stroke="{}" stroke-width="{width}""#, palette.ink)
        }
        (Owner::Observer(_), _) => format!(
            r#"fill="none" stroke="{}" stroke-width="{width}" stroke-dasharray="{} {}""#,
            palette.ink,
            Number(size * 0.14),
            Number(size * 0.1)
        ),
    };
    let [x, y] = floor.middle(cell);
    let facing = match state {
        StateLabel::Cell(..) => {
            svg.circle([x, y], radius, look);
            return;
        }
        StateLabel::Parts(parts) => parts.iter().find_map(|(key, value)| match value {
            Value::Name(name) if *key == "facing" => Some(*name),
            _ => None,
        }),
        _ => None,
    };
    let frame = [x - radius, y - radius, 2.0 * radius, 2.0 * radius];
    svg.rect(frame, format_args!(r#"rx="{}" {look}"#, Number(radius * 0.4)));
    // Where the robot looks is hidden from observers as well.
    if let (Some(facing), Owner::Actor) = (facing, input.owner) {
        let turn = match facing {
            "east" => 90,
            "south" => 180,
            "west" => 270,
            _ => 0,
        };
        let (x, y, wide, high) = (Number(x), Number(y), Number(size * 0.17), Number(size * 0.18));
        let base = Number(radius);
        svg.raw(format_args!(
            r#"<path transform="translate({x} {y}) rotate({turn}) translate(0 -{base})" d="M-{wide} 0L0 -{high}L{wide} 0z" fill="{}"/>"#,
            palette.ink
        ));
    }
}

/// What is known of the battery, and of a can that the robot holds.
pub(super) fn battery(input: &BoardInput<'_>, full: u32) -> String {
    match (input.owner, input.summary()) {
        (Owner::Observer(_), Some(summary)) => {
            let (mut levels, mut held) = (Vec::new(), StateCount::Exact(0));
            for share in &summary.shares {
                match &share.feature {
                    Feature::Part { part: "battery", value: Value::Number(level) } => {
                        levels.push(*level);
                    }
                    Feature::Part { part: "can", value: Value::Name(_) } => held = share.states,
                    _ => {}
                }
            }
            levels.sort_unstable();
            let can = match held {
                StateCount::Exact(0) => "",
                held if held == summary.states => ", holds the can",
                _ => ", may hold the can",
            };
            let shown = match levels.as_slice() {
                [] => String::new(),
                [level] => format!("battery {level} of {full}"),
                [first, .., last] if (last - first) as usize + 1 == levels.len() => {
                    format!("battery {first} to {last} of {full}")
                }
                levels => {
                    let levels: Vec<String> = levels.iter().map(u32::to_string).collect();
                    format!("battery {} of {full}", levels.join(", "))
                }
            };
            format!("{shown}{can}")
        }
        _ => {
            let StateLabel::Parts(parts) = &input.step().state else { return String::new() };
            let level = parts.iter().find_map(|(key, value)| match value {
                Value::Number(level) if *key == "battery" => Some(*level),
                _ => None,
            });
            let held =
                parts.iter().any(|(key, value)| *key == "can" && matches!(value, Value::Name(_)));
            let can = if held { ", holds the can" } else { "" };
            level.map_or_else(String::new, |level| format!("battery {level} of {full}{can}"))
        }
    }
}
