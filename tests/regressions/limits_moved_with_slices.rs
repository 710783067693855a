//! A limit on expansions was looked at every 64 of a slice, so that it let 64 pass in one go and
//! none too many in slices of one.

use std::sync::Arc;

use mo_copp::domain::Delivery;
use mo_copp::limits::LimitReached;
use mo_copp::solver::{Horizon, Options, Run, Solver};

#[test]
fn exactly_as_many_as_allowed() {
    let problem = Arc::new(Delivery::figure_1().problem().unwrap());
    for (solver, horizon) in [
        (Solver::Exact, Horizon::Any),
        (Solver::Exact, Horizon::Steps(3)),
        (Solver::Search, Horizon::Any),
        (Solver::Satisficing, Horizon::Any),
        (Solver::Baseline, Horizon::Any),
    ] {
        for slice in [1, 2, u64::MAX] {
            let mut options = Options::new(solver);
            options.horizon = horizon;
            options.pairs = solver == Solver::Exact;
            options.limits.expansions = 2;
            let mut run = Run::new(Arc::clone(&problem), options).unwrap();
            while !run.advance(slice).unwrap() {}
            let outcome = run.outcome().unwrap();
            assert_eq!(outcome.limit, Some(LimitReached::Expansions { limit: 2 }));
            assert_eq!(outcome.stats.expansions, 2, "{} in slices of {slice}", solver.name());
        }
    }
}
