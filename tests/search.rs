//! Algorithm 1 is complete: it says that there is no plan exactly when no situation that any plan
//! can lead to keeps the bounds. The same for its variants and the baseline.

use mo_copp::solver::{Solver, Status};

use crate::common::random::{self, MEDIUM, PAIR};
use crate::common::{Dice, Judge, Wish, oracle};

pub const SOLVERS: [Solver; 5] =
    [Solver::Search, Solver::Satisficing, Solver::Baseline, Solver::Obfuscate, Solver::Legible];

/// The part of a wish that a solver heeds.
pub fn heeded(solver: Solver, wish: &Wish) -> Wish {
    match solver {
        Solver::Baseline => Wish::default(),
        Solver::Obfuscate => Wish { j: None, ..wish.clone() },
        Solver::Legible => Wish { k: None, ..wish.clone() },
        _ => wish.clone(),
    }
}

/// A solver must find a plan exactly when the oracles do.
pub fn agrees(judge: &Judge, solver: Solver, horizon: Option<usize>, wish: &Wish) {
    let heeded = heeded(solver, wish);
    let possible = match horizon {
        None => judge.endings().keys().any(|e| heeded.allows(&judge.table, e)),
        Some(steps) => {
            oracle::enumerate(&judge.table, steps).iter().any(|e| heeded.allows(&judge.table, e))
        }
    };
    let options = Judge::options(solver, horizon, wish);
    let outcome = judge.solve(&options);
    judge.check(&options, &outcome, &heeded);
    let status = if possible { Status::Solved } else { Status::Infeasible };
    assert_eq!(outcome.status, status, "{} {horizon:?} {wish:?}", solver.name());
}

#[test]
fn over_all_lengths_says_infeasible_exactly_when_it_is() {
    let mut dice = Dice::new(3);
    for _ in 0..20_000 {
        let judge = Judge::new(random::table(&mut dice, MEDIUM, &PAIR));
        let wish = random::wish(&mut dice, &judge.table);
        for solver in SOLVERS {
            agrees(&judge, solver, None, &wish);
        }
    }
}

#[test]
fn at_a_horizon_says_infeasible_exactly_when_it_is() {
    let mut dice = Dice::new(4);
    for _ in 0..20_000 {
        let judge = Judge::new(random::table(&mut dice, MEDIUM, &PAIR));
        let wish = random::wish(&mut dice, &judge.table);
        let horizon = random::horizon(&mut dice, &judge.table, 300);
        for solver in SOLVERS {
            agrees(&judge, solver, Some(horizon), &wish);
        }
    }
}
