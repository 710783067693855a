//! Boards of a delivery: factories with their packages, and the truck.

use crate::domain::delivery::Factory;
use crate::problem::StateLabel;

use super::SIDE;
use super::boards::{BoardInput, Owner};
use super::svg::{Anchor, Number, Svg};

/// The height of the truck's line at the bottom.
const TRUCK: f64 = 64.0;

/// Draws each package as a tile that is filled as far as it is held possible that it is in the truck.
pub(super) fn draw(svg: &mut Svg, input: &BoardInput<'_>, factories: &[Factory]) {
    let own = std::slice::from_ref(&input.step().state);
    let states = match input.owner {
        Owner::Actor => own,
        Owner::Observer(_) => input.belief(),
    };
    let columns = factories.len().clamp(1, 3);
    let rows = factories.len().div_ceil(columns);
    let gap = 12.0;
    let width = (SIDE - gap * (columns as f64 - 1.0)) / columns as f64;
    let height = (SIDE - TRUCK - gap * rows as f64) / rows as f64;
    for (index, factory) in factories.iter().enumerate() {
        let x = (index % columns) as f64 * (width + gap);
        let y = (index / columns) as f64 * (height + gap);
        one_factory(svg, input, factory, [x, y, width, height], states);
    }
    truck(svg, input, factories, states);
}

fn one_factory(
    svg: &mut Svg,
    input: &BoardInput<'_>,
    factory: &Factory,
    [x, y, width, height]: [f64; 4],
    states: &[StateLabel],
) {
    let palette = input.palette;
    svg.rect([x, y, width, height], format_args!(r#"rx="10" fill="{}""#, palette.floor));
    let size = (height * 0.16).clamp(8.0, 20.0);
    let ink = format!(r#"fill="{}""#, palette.ink);
    let heading = [x + width / 2.0, y + size * 1.35];
    let bold = format_args!(r#"{ink} font-weight="600""#).to_string();
    svg.fitted(heading, size, Anchor::Middle, width - 8.0, &factory.name, bold);
    if factory.packages.is_empty() {
        return;
    }
    let top = size * 1.9;
    let count = factory.packages.len();
    // As few columns as let a tile be at least as wide as high.
    let fits = |columns: &usize| {
        let rows = count.div_ceil(*columns) as f64;
        (height - top) / rows <= (width / *columns as f64) * 0.9
    };
    let most = (1..=count).rev().find(fits).unwrap_or(1);
    let columns = (1..=count).find(fits).unwrap_or(count).min(most.max(1)).max(1);
    let rows = count.div_ceil(columns);
    let (cell_width, cell_height) =
        ((width - 12.0) / columns as f64, (height - top - 6.0) / rows as f64);
    for (index, package) in factory.packages.iter().enumerate() {
        let left = x + 6.0 + (index % columns) as f64 * cell_width + cell_width * 0.08;
        let above = y + top + (index / columns) as f64 * cell_height + cell_height * 0.08;
        let tile = [left, above, cell_width * 0.84, cell_height * 0.84];
        let aboard = format!("{package} in the truck");
        let share = share_of(states, &aboard);
        svg.rect(
            tile,
            format_args!(r#"rx="6" fill="{}" stroke="{}""#, palette.parcel, palette.parcel_edge),
        );
        if share > 0.0 {
            let filled = [left, above + tile[3] * (1.0 - share), tile[2], tile[3] * share];
            let fill = match input.owner {
                Owner::Actor => palette.ink,
                Owner::Observer(_) => input.tone.strong,
            };
            svg.rect(filled, format_args!(r#"rx="6" fill="{fill}""#));
        }
        let letter = (tile[3] * 0.4).min(22.0);
        let look = if share == 1.0 {
            format!(r#"fill="{}" font-weight="600""#, palette.on_strong)
        } else {
            // An edge around the letters keeps them readable over both grounds.
            format!(
                r#"fill="{}" stroke="{}" stroke-width="4" paint-order="stroke" stroke-linejoin="round" font-weight="600""#,
                palette.ink, palette.parcel
            )
        };
        let middle = [left + tile[2] / 2.0, above + tile[3] / 2.0 + letter * 0.35];
        svg.fitted(middle, letter, Anchor::Middle, tile[2] - 4.0, package, look);
    }
}

/// Where the truck is, or may be.
fn truck(svg: &mut Svg, input: &BoardInput<'_>, factories: &[Factory], states: &[StateLabel]) {
    let palette = input.palette;
    let y = SIDE - TRUCK;
    svg.rect(
        [0.0, y + 8.0, SIDE, TRUCK - 8.0],
        format_args!(r#"rx="10" fill="{}""#, palette.floor),
    );
    let wheels = Number(y + TRUCK - 12.0);
    let strong = match input.owner {
        Owner::Actor => palette.ink,
        Owner::Observer(_) => input.tone.strong,
    };
    svg.raw(format_args!(
        r#"<g fill="{strong}"><path d="M16 {0}h34v28h-34zM52 {1}h14l8 9v10h-22z"/><circle cx="28" cy="{wheels}" r="6"/><circle cx="62" cy="{wheels}" r="6"/></g>"#,
        Number(y + 20.0),
        Number(y + 29.0)
    ));
    let named =
        factories.iter().map(|factory| (format!("truck at {}", factory.name), &*factory.name));
    let fixed = [("truck in the yard", "the yard"), ("truck at the delivery area", "delivered")];
    let places: Vec<String> = named
        .chain(fixed.map(|(fact, name)| (fact.to_owned(), name)))
        .filter(|(fact, _)| share_of(states, fact) > 0.0)
        .map(|(_, name)| name.to_owned())
        .collect();
    let text = places.join(" or ");
    let look = format!(r#"fill="{}""#, palette.ink);
    svg.fitted([88.0, y + 42.0], 18.0, Anchor::Start, SIDE - 96.0, &text, look);
}

/// In what part of the states a fact holds.
fn share_of(states: &[StateLabel], fact: &str) -> f64 {
    let holds = |state: &&StateLabel| match state {
        StateLabel::Facts(facts) => facts.iter().any(|known| &**known == fact),
        _ => false,
    };
    states.iter().filter(holds).count() as f64 / states.len().max(1) as f64
}
