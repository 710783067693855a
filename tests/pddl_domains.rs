//! Small Blocksworlds, Logistics and Driverlogs: what the crate makes of a document is what its
//! actions mean.

use std::sync::Arc;

use mo_copp::domain::Pddl;
use mo_copp::domain::pddl::generate::{BlocksworldShape, DriverlogShape, LogisticsShape};

use crate::common::{Dice, Judge, Wish, atoms, random};
use crate::{exact, integer_programs, search};

fn judge(document: &Pddl) -> Judge {
    Judge::of(atoms::table(document), Arc::new(document.problem().unwrap()))
}

fn small(seed: u64) -> [Pddl; 4] {
    let blocks = BlocksworldShape { blocks: 3, goals: 3 };
    let city = LogisticsShape { cities: 1, airplanes: 1, packages: 2, facts: 1, goals: 2 };
    let cities = LogisticsShape { cities: 2, airplanes: 1, packages: 1, facts: 1, goals: 3 };
    let drivers = DriverlogShape { places: 3, drivers: 1, trucks: 1, packages: 1, goals: 4 };
    [
        blocks.generate(seed).unwrap().document,
        city.generate(seed).unwrap().document,
        cities.generate(seed).unwrap().document,
        drivers.generate(seed).unwrap().document,
    ]
}

/// The sizes of the state spaces: 13 ways to stack three blocks and 9 with one in the hand; a truck
/// in two places and packages in two, the truck or the airplane; and so on.
#[test]
fn small_state_spaces_have_the_sizes_worked_out_by_hand() {
    for seed in 0..10 {
        let sizes = small(seed).map(|document| judge(&document).table.states.len());
        assert_eq!(sizes, [13 + 9, 2 * 4 * 4, 2 * 2 * 2 * 7, (3 + 2 + 1) * 3 * 4]);
    }
}

#[test]
fn exact_search_and_the_others_agree_with_the_oracles() {
    let mut dice = Dice::new(70);
    for seed in 0..60 {
        for mut document in small(seed) {
            if seed > 5 {
                atoms::change(&mut dice, &mut document);
            }
            let judge = judge(&document);
            assert!(!judge.endings().is_empty(), "the true goal can be reached");
            let wish = if dice.percent(30) {
                Wish::default()
            } else {
                random::wish(&mut dice, &judge.table)
            };
            let horizon = random::horizon(&mut dice, &judge.table, 1100);
            exact::equals_enumeration(&judge, horizon, &wish);
            exact::equals_closure(&judge, &wish);
            for solver in search::SOLVERS {
                search::agrees(&judge, solver, None, &wish);
                search::agrees(&judge, solver, Some(horizon), &wish);
            }
        }
    }
}

#[test]
fn both_encodings_agree_with_enumeration() {
    let mut dice = Dice::new(71);
    let mut feasible = 0;
    for seed in 0..40 {
        for mut document in small(seed) {
            if seed > 5 {
                atoms::change(&mut dice, &mut document);
            }
            let judge = judge(&document);
            let wish = random::wish(&mut dice, &judge.table);
            let horizon = dice.between(2, 5);
            let found = integer_programs::equal_enumeration(&judge, horizon, &wish);
            feasible += usize::from(found);
        }
    }
    assert!((20..140).contains(&feasible), "{feasible} feasible");
}
