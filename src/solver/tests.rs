//! Solvers on problems whose initial beliefs are not listed, against the same problems with lists.

use std::sync::Arc;

use super::*;
use crate::common::random::{self, MEDIUM, PAIR};
use crate::common::solve;
use crate::common::{Dice, Judge, Wish};
use crate::plan::Plan;

/// Runs a solver on a problem and on the same one without lists; both answers say the same, the second with another plan at
/// most. Whether there was a plan.
fn agree(judge: &Judge, other: &Judge, options: &Options, wish: &Wish) -> bool {
    let (known, found) = (judge.solve(options), solve(&other.problem, options));
    let shortest = known.length_proved == Some(true) && found.length_proved == Some(true);
    let said = |outcome: &Outcome| {
        let exact = matches!(options.solver, Solver::Exact | Solver::Ip);
        let value = outcome.goal_difference.filter(|_| exact);
        (outcome.status, value, outcome.plan.as_ref().filter(|_| shortest).map(Plan::len))
    };
    assert_eq!(said(&known), said(&found), "{options:?}");
    if matches!(options.solver, Solver::Exact | Solver::Ip) {
        other.check_plan(options, &found, wish);
    } else {
        other.check(options, &found, wish);
    }
    found.plan.is_some()
}

#[test]
fn initial_beliefs_that_are_not_listed_change_no_answer() {
    let mut dice = Dice::new(86);
    let mut plans = [0; 4];
    for round in 0..600 {
        let judge = if round % 2 == 0 {
            Judge::built(random::table(&mut dice, MEDIUM, &PAIR), 0)
        } else {
            random::strips(&mut dice).judge()
        };
        let unlisted = judge.problem.with_unlisted_beliefs();
        let other = Judge::of(judge.table.clone(), Arc::new(unlisted));
        let wish = random::wish(&mut dice, &judge.table);
        let solvers = [Solver::Search, Solver::Satisficing, Solver::Exact, Solver::Ip];
        for (solver, plans) in solvers.into_iter().zip(&mut plans) {
            let horizon = (solver == Solver::Ip || dice.percent(50)).then(|| dice.below(4));
            let mut options = Judge::options(solver, horizon, &wish);
            options.limits.listed = dice.pick(&[1, 2, 5, usize::MAX]);
            *plans += usize::from(agree(&judge, &other, &options, &wish));
        }
    }
    assert!(plans.iter().all(|plans| *plans > 50), "{plans:?}");
}
