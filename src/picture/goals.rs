//! The list of candidate goals below a board: which of them the observer holds possible.

use super::SIDE;
use super::boards::{BoardInput, Owner};
use super::signs::star;
use super::svg::{Anchor, Number, Svg};

const SIZE: f64 = 18.0;
const LINE: f64 = 28.0;

/// Goals that are listed one by one.
const MOST: usize = 24;

/// How high the list is.
pub(super) fn height(goals: usize) -> f64 {
    let shown = goals.min(MOST);
    let lines = shown.div_ceil(columns(shown)) + usize::from(goals > MOST);
    lines as f64 * LINE + 6.0
}

fn columns(shown: usize) -> usize {
    match shown {
        0..=6 => 1,
        7..=16 => 2,
        _ => 3,
    }
}

/// Draws the list; its upper left corner is the origin.
pub(super) fn draw(svg: &mut Svg, input: &BoardInput<'_>) {
    let goals = &input.scene.goals;
    let palette = input.palette;
    let shown = goals.len().min(MOST);
    let columns = columns(shown);
    let rows = shown.div_ceil(columns);
    let width = SIDE / columns as f64;
    for (index, goal) in goals.iter().take(shown).enumerate() {
        let x = (index / rows) as f64 * width;
        let y = (index % rows) as f64 * LINE + LINE / 2.0;
        let is_true = goal.name == input.scene.true_goal;
        let mut left = x + 4.0;
        let mut possible = true;
        match input.owner {
            // Both sides' signs, since the agent knows what each believes.
            Owner::Actor => {
                for (observer, seen) in input.scene.observers.iter().enumerate() {
                    let on = input.survives(observer, &goal.name);
                    sign(svg, [left + 8.0, y], seen.role, on, palette);
                    left += 22.0;
                }
            }
            Owner::Observer(observer) => {
                let role = input.scene.observers.get(observer).map_or("", |seen| seen.role);
                possible = input.survives(observer, &goal.name);
                sign(svg, [left + 8.0, y], role, possible, palette);
                left += 22.0;
            }
        }
        // Before the end of the plan a goal that is not possible now may still become so.
        let look = if possible || !input.is_last() {
            format!(r#"fill="{}""#, if possible { palette.ink } else { palette.muted })
        } else {
            format!(r#"fill="{}" text-decoration="line-through""#, palette.muted)
        };
        let room = width - (left - x) - 30.0;
        svg.fitted([left + 24.0, y + SIZE * 0.35], SIZE, Anchor::Start, room, &goal.name, look);
        if is_true {
            star(svg, [left + 10.0, y], 9.0, palette.star, palette.star_edge);
        }
    }
    if goals.len() > MOST {
        let at = [4.0, (rows as f64 + 0.5) * LINE + SIZE * 0.35];
        let look = format!(r#"fill="{}" font-style="italic""#, palette.muted);
        svg.text(at, SIZE, Anchor::Start, &format!("and {} more", goals.len() - MOST), look);
    }
}

/// A diamond for the enemy, a disc for the friend: filled while the goal is possible for them.
fn sign(svg: &mut Svg, [x, y]: [f64; 2], role: &str, on: bool, palette: &super::palette::Palette) {
    let tone = if role == "adversarial" { palette.enemy } else { palette.friend };
    let fill = if on { tone.strong } else { "none" };
    let look = format!(r#"fill="{fill}" stroke="{}" stroke-width="1.6""#, tone.strong);
    if role == "adversarial" {
        let (x, y) = (Number(x), Number(y));
        svg.raw(format_args!(
            r#"<path transform="translate({x} {y})" d="M0 -8L8 0L0 8L-8 0z" {look}/>"#
        ));
    } else {
        svg.circle([x, y], 7.0, look);
    }
}
