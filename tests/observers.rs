//! Three and more observers: of several enemies the one in least doubt counts, of several friends
//! the one in most.

use mo_copp::problem::Role::{self, Adversarial, Cooperative};

use crate::common::random::{self, MEDIUM, SMALL};
use crate::common::strips::Strips;
use crate::common::{Dice, Judge};
use crate::{exact, integer_programs, search};

pub const COMPANIES: [&[Role]; 6] = [
    &[Adversarial, Adversarial, Cooperative],
    &[Adversarial, Cooperative, Cooperative],
    // The integer programs decide on the first observer's flows: let it be a friend too.
    &[Cooperative, Adversarial],
    &[Cooperative, Adversarial, Cooperative, Adversarial],
    &[Cooperative, Cooperative, Adversarial, Adversarial, Adversarial],
    &[Adversarial, Adversarial, Adversarial, Cooperative],
];

/// Facts that mean nothing: now and then enough for a second and a third word.
const PADDING: [usize; 4] = [0, 0, 70, 130];

#[test]
fn exact_search_equals_the_oracles() {
    let mut dice = Dice::new(30);
    for number in 0..6000 {
        let roles = COMPANIES[number % COMPANIES.len()];
        let padding = dice.pick(&PADDING);
        let judge = Judge::built(random::table(&mut dice, MEDIUM, roles), padding);
        let wish = random::wish(&mut dice, &judge.table);
        let horizon = random::horizon(&mut dice, &judge.table, 300);
        exact::equals_enumeration(&judge, horizon, &wish);
        exact::equals_closure(&judge, &wish);
    }
}

#[test]
fn both_encodings_equal_enumeration() {
    let mut dice = Dice::new(31);
    let mut feasible = 0;
    for number in 0..2000 {
        let roles = COMPANIES[number % COMPANIES.len()];
        let judge = Judge::built(random::table(&mut dice, SMALL, roles), 0);
        let wish = random::wish(&mut dice, &judge.table);
        let horizon = random::horizon(&mut dice, &judge.table, 100);
        let found = integer_programs::equal_enumeration(&judge, horizon, &wish);
        feasible += usize::from(found);
    }
    assert!((500..1500).contains(&feasible), "{feasible} feasible");
}

#[test]
fn the_searches_are_complete() {
    let mut dice = Dice::new(32);
    for number in 0..4000 {
        let roles = COMPANIES[number % COMPANIES.len()];
        let padding = dice.pick(&PADDING);
        let judge = Judge::built(random::table(&mut dice, MEDIUM, roles), padding);
        let wish = random::wish(&mut dice, &judge.table);
        let horizon = random::horizon(&mut dice, &judge.table, 100);
        for solver in search::SOLVERS {
            search::agrees(&judge, solver, None, &wish);
            search::agrees(&judge, solver, Some(horizon), &wish);
        }
    }
}

/// Facts and operators of their own, not one fact for each state.
#[test]
fn on_random_strips_tasks_everything_equals_the_oracles() {
    let mut dice = Dice::new(33);
    for number in 0..4000 {
        let roles = COMPANIES[number % COMPANIES.len()];
        let judge = Strips::random(&mut dice, 4, 4, roles).judge();
        let wish = random::wish(&mut dice, &judge.table);
        let horizon = random::horizon(&mut dice, &judge.table, 100);
        exact::equals_enumeration(&judge, horizon, &wish);
        exact::equals_closure(&judge, &wish);
        for solver in search::SOLVERS {
            search::agrees(&judge, solver, None, &wish);
        }
        if number % 4 == 0 {
            integer_programs::equal_enumeration(&judge, horizon.min(3), &wish);
        }
    }
}
