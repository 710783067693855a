//! Cells that are drawn anew: walls, goals, the start, and the initial beliefs that hold it.

use rand::Rng;

use super::block::Vary;
use super::dice::take;
use super::edit::Draft;
use super::initial_belief::{Believable, Others};
use crate::domain::grid::Cell;

/// The cells that walls, goals and a start can be drawn from: those of what varies, and those in which nothing is.
pub(super) fn free_cells(draft: &Draft, varies: &dyn Fn(Vary) -> bool) -> Vec<Cell> {
    let Some([width, height]) = draft.size() else { return Vec::new() };
    let (walls, goals, taken) = (draft.walls(), draft.goals(), draft.taken());
    let cells = (0..height).flat_map(|row| (0..width).map(move |column| [column, row]));
    let is_free = |cell: &Cell| {
        (varies(Vary::Walls) || !walls.contains(cell))
            && (varies(Vary::Goals) || !goals.contains(cell))
            && (varies(Vary::Start) || draft.start() != Some(*cell))
            && !taken.contains(cell)
    };
    cells.filter(is_free).collect()
}

/// Draws walls, goals, start and beliefs, those that vary, as many as there were.
pub(super) fn draw_cells(
    draft: &mut Draft,
    varies: &dyn Fn(Vary) -> bool,
    random: &mut impl Rng,
) -> Option<()> {
    let (mut walls, mut goals, mut start) = (draft.walls(), draft.goals(), draft.start()?);
    let (taken, start_before) = (draft.taken(), draft.start_state().clone());
    let mut free = free_cells(draft, varies);
    if varies(Vary::Walls) {
        walls = take(random, &mut free, walls.len())?;
        draft.set_walls(&walls);
    }
    if varies(Vary::Goals) {
        goals = take(random, &mut free, goals.len())?;
        draft.set_goals(&goals);
    }
    if varies(Vary::Start) {
        start = take(random, &mut free, 1)?[0];
        draft.set_start(start);
    }
    if !(varies(Vary::Start) || varies(Vary::Walls)) {
        return Some(());
    }
    let mut cells = free;
    for cell in goals.into_iter().chain(taken).chain([start]) {
        // A cell may be that of a goal and of the start.
        if !cells.contains(&cell) {
            cells.push(cell);
        }
    }
    let start = draft.start_state().clone();
    let (start_before, battery_levels) = (&start_before, draft.battery_levels());
    let believable = Believable { start_before, start: &start, cells: &cells, battery_levels };
    for observer in ["adversarial", "cooperative"] {
        let Some(belief) = draft.belief(observer) else { continue };
        let others = Others::new(belief, &believable);
        let states = others.draw(random)?;
        draft.set_belief(observer, states.into_iter().chain([start.clone()]));
    }
    Some(())
}
