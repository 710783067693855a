//! Boards without places: the facts of a state, and in how many believed states each fact holds.

use crate::belief::StateCount;
use crate::problem::StateLabel;
use crate::report::Feature;

use super::SIDE;
use super::boards::{BoardInput, Owner};
use super::svg::{Anchor, Number, Svg};

const SIZE: f64 = 17.0;
const LINE: f64 = 24.0;
const LEFT: f64 = 10.0;

/// How many lines a board has room for.
const LINES: usize = (SIDE / LINE) as usize;

pub(super) fn draw(svg: &mut Svg, input: &BoardInput<'_>) {
    svg.rect([0.0, 0.0, SIDE, SIDE], format_args!(r#"rx="10" fill="{}""#, input.palette.floor));
    match (input.owner, input.summary()) {
        (Owner::Observer(_), Some(summary)) if !summary.shares.is_empty() => {
            let rows: Vec<(String, StateCount)> = summary
                .shares
                .iter()
                .map(|share| {
                    let name = match &share.feature {
                        Feature::Fact { fact } => fact.clone(),
                        Feature::Part { part, value } => format!("{part} {value}"),
                    };
                    (name, share.states)
                })
                .collect();
            shares(svg, input, &rows, summary.states, summary.left_out);
        }
        (Owner::Observer(_), _) => {
            let names: Vec<String> = input.belief().iter().map(ToString::to_string).collect();
            let all = input.believed_states().as_f64();
            let more = (all - names.len() as f64).max(0.0) as usize;
            lines(svg, input, &names, more);
        }
        (Owner::Actor, _) => {
            let names = match &input.step().state {
                StateLabel::Facts(facts) => facts.iter().map(ToString::to_string).collect(),
                state => vec![state.to_string()],
            };
            lines(svg, input, &names, 0);
        }
    }
}

/// The rows that fit, and how many are left out.
fn fitting_rows(count: usize, more: usize) -> (usize, usize) {
    if count <= LINES && more == 0 {
        (count, 0)
    } else {
        let shown = count.min(LINES - 1);
        (shown, count - shown + more)
    }
}

fn lines(svg: &mut Svg, input: &BoardInput<'_>, names: &[String], more: usize) {
    let (shown, left_out) = fitting_rows(names.len(), more);
    let look = format!(r#"fill="{}""#, input.palette.ink);
    for (row, name) in names.iter().take(shown).enumerate() {
        let at = [LEFT, LINE * (row as f64 + 0.75)];
        svg.fitted(at, SIZE, Anchor::Start, SIDE - 2.0 * LEFT, name, &look);
    }
    rest(svg, input, shown, left_out);
}

/// Each fact with a bar: in what part of the believed states it holds.
fn shares(
    svg: &mut Svg,
    input: &BoardInput<'_>,
    rows: &[(String, StateCount)],
    states: StateCount,
    more: usize,
) {
    let (shown, left_out) = fitting_rows(rows.len(), more);
    let palette = input.palette;
    for (row, (name, count)) in rows.iter().take(shown).enumerate() {
        let top = LINE * row as f64;
        let share = count.as_f64() / states.as_f64().max(1.0);
        let bar = [LEFT - 4.0, top + 2.0, (SIDE - 2.0 * LEFT + 8.0) * share, LINE - 4.0];
        svg.rect(bar, format_args!(r#"rx="4" fill="{}""#, input.tone.tint));
        let number =
            if *count == states { "all".to_owned() } else { format!("{count} of {states}") };
        let room = number.chars().count() as f64 * SIZE * 0.6;
        let at = [LEFT, top + LINE * 0.72];
        let look = format!(r#"fill="{}""#, palette.ink);
        svg.fitted(at, SIZE, Anchor::Start, SIDE - 2.0 * LEFT - room - 8.0, name, look);
        svg.raw(format_args!(
            r#"<text x="{}" y="{}" font-size="{}" text-anchor="end" fill="{}">{number}</text>"#,
            Number(SIDE - LEFT),
            Number(top + LINE * 0.72),
            Number(SIZE * 0.85),
            palette.ink
        ));
    }
    rest(svg, input, shown, left_out);
}

fn rest(svg: &mut Svg, input: &BoardInput<'_>, shown: usize, left_out: usize) {
    if left_out > 0 {
        let at = [LEFT, LINE * (shown as f64 + 0.75)];
        let look = format!(r#"fill="{}" font-style="italic""#, input.palette.muted);
        svg.text(at, SIZE, Anchor::Start, &format!("and {left_out} more"), look);
    }
}
