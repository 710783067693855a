//! Small Blocksworlds, Logistics and Driverlogs: what the crate makes of a document is what its
//! actions mean.

use std::sync::Arc;

use mo_copp::domain::Pddl;
use mo_copp::domain::pddl::generate::{BlocksworldShape, DriverlogShape, LogisticsShape};
use mo_copp::problem::Observer;
use mo_copp::solver::{Options, ReachablePair, Solver};

use crate::common::{Dice, Judge, Wish, atoms, random, solve};
use crate::{exact, integer_programs, search};

fn judge(document: &Pddl) -> Judge {
    Judge::of(atoms::table(document), Arc::new(document.problem().unwrap()))
}

fn small(seed: u64) -> [Pddl; 4] {
    with_beliefs(seed, 1)
}

fn with_beliefs(seed: u64, belief: u32) -> [Pddl; 4] {
    let blocks = BlocksworldShape { blocks: 3, goals: 3, belief };
    let city = LogisticsShape { cities: 1, airplanes: 1, packages: 2, facts: 1, goals: 2, belief };
    let cities =
        LogisticsShape { cities: 2, airplanes: 1, packages: 1, facts: 1, goals: 3, belief };
    let drivers =
        DriverlogShape { places: 3, drivers: 1, trucks: 1, packages: 1, goals: 4, belief };
    [
        blocks.generate(seed).unwrap().document,
        city.generate(seed).unwrap().document,
        cities.generate(seed).unwrap().document,
        drivers.generate(seed).unwrap().document,
    ]
}

/// Each observer's initial belief is drawn for itself: each is the larger one in some problems and
/// holds the initial state, and the friend can be left in more doubt than the enemy.
#[test]
fn initial_beliefs_are_drawn_for_each_observer_by_itself() {
    let mut larger = [0, 0];
    let mut negative = 0;
    for seed in 0..40 {
        for document in small(seed) {
            assert_eq!(document.observers.adversarial.initial_belief, None);
        }
        for document in with_beliefs(seed, 6) {
            let problem = Arc::new(document.problem().unwrap());
            let sizes: Vec<usize> = problem
                .observers()
                .iter()
                .map(|o| o.initial_belief.listed().unwrap().len())
                .collect();
            assert!(sizes.iter().all(|size| (1..=6).contains(size)), "{sizes:?}");
            larger[0] += usize::from(sizes[0] > sizes[1]);
            larger[1] += usize::from(sizes[1] > sizes[0]);
            let start = problem.task().initial_state();
            let known = |observer: &Observer| observer.initial_belief.contains(start);
            assert!(problem.observers().iter().all(known));
            let mut options = Options::new(Solver::Exact);
            options.pairs = true;
            let pairs = solve(&problem, &options).pairs.unwrap();
            let below = |pair: &ReachablePair| pair.counts.difference() < 0;
            negative += usize::from(pairs.iter().any(below));
        }
    }
    assert!(larger.iter().all(|&count| count > 20) && negative > 0, "{larger:?} {negative}");
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

/// The small documents of a seed; from the seventh seed on with other atoms.
fn drawn(dice: &mut Dice, seed: u64) -> [Judge; 4] {
    small(seed).map(|mut document| {
        if seed > 5 {
            atoms::change(dice, &mut document);
        }
        judge(&document)
    })
}

#[test]
fn exact_search_and_the_others_agree_with_the_oracles() {
    let mut dice = Dice::new(70);
    for seed in 0..60 {
        for judge in drawn(&mut dice, seed) {
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
fn bounds_hold_on_a_thousand_documents_in_pddl() {
    let mut dice = Dice::new(72);
    for seed in 0..250 {
        for judge in drawn(&mut dice, seed) {
            exact::bounds_hold_for(&judge, &mut dice);
        }
    }
}

#[test]
fn both_encodings_agree_with_enumeration() {
    let mut dice = Dice::new(71);
    let mut feasible = 0;
    for seed in 0..40 {
        for judge in drawn(&mut dice, seed) {
            let wish = random::wish(&mut dice, &judge.table);
            let horizon = dice.between(2, 5);
            let found = integer_programs::equal_enumeration(&judge, horizon, &wish);
            feasible += usize::from(found);
        }
    }
    assert!((20..140).contains(&feasible), "{feasible} feasible");
}
