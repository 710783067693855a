//! What linear invariants exclude.

#![allow(clippy::unwrap_used)]

use std::sync::Arc;

use crate::domain::Document;
use crate::solver::{Options, Solver, UpperBound, upper_bounds};

/// Whether k goals can survive, by the invariants alone.
fn is_excluded(text: &str, k: usize) -> bool {
    let problem = Arc::new(Document::parse(text).unwrap().problem().unwrap());
    let mut options = Options::new(Solver::Satisficing);
    options.bounds.at_least = Some(k);
    let bounds = upper_bounds(&problem, &options).unwrap();
    bounds.contains(&("linear invariants", UpperBound::Infeasible))
}

/// Parcels on two shelves of two towns, lifted by hand, and one van: what the van carries is no value of the group of
/// places, and what lies on what makes many sums.
#[test]
fn how_much_is_in_each_town_is_known_where_the_place_of_the_van_is() {
    let text = include_str!("stacks.json");
    assert!(!is_excluded(text, 2) && is_excluded(text, 3));
}

/// Each town has a second place, and all roads go from town to town.
#[test]
fn how_much_is_in_each_town_is_known_where_the_town_of_the_van_is() {
    let roads = "(adjacent l1 n2) (adjacent n2 l1) (adjacent n1 l2) (adjacent l2 n1)
        (adjacent n1 n2) (adjacent n2 n1) (adjacent l1 l2)"
        .replace('\n', " ");
    let text = include_str!("stacks.json")
        .replace("l1 l2 - location", "l1 l2 n1 n2 - location")
        .replace("(adjacent l1 l2)", &roads);
    assert!(!is_excluded(&text, 2) && is_excluded(&text, 3));
    let inside = text.replace("(adjacent n1 n2)", "(adjacent n1 n2) (adjacent l1 n1)");
    assert!(!is_excluded(&inside, 3), "the van may be in either town");
}

#[test]
fn what_lies_on_something_is_where_that_is() {
    let text = include_str!("stacks.json").replace("(in cb q2)", "(on cb cc)");
    assert!(!is_excluded(&text, 2) && is_excluded(&text, 3));
}
