//! A run had proved that no plan keeps the bounds, and the search for remedies asked again: cut short,
//! it had no reason, although a shortest plan and no horizon leave none but the bounds.

use std::sync::Arc;

use mo_copp::domain::Document;
use mo_copp::solver::remedy::{Reason, RemedyRun};
use mo_copp::solver::{Horizon, Options, Solver, Watched};

const DOCUMENT: &str = include_str!("remedy-reason-null.json");

#[test]
fn the_proof_is_the_reason() {
    let problem = Arc::new(Document::parse(DOCUMENT).unwrap().problem().unwrap());
    let mut options = Options::new(Solver::Search);
    options.bounds.at_most = Some(1);
    let observer = problem.observer_named("cooperative").unwrap();
    options.bounds.required = vec![Watched { observer, goal: problem.goal_named("G2").unwrap() }];
    let mut limited = options.clone();
    limited.limits.expansions = 20;
    let mut at_horizon = limited.clone();
    at_horizon.horizon = Horizon::Steps(2);
    for options in [&limited, &at_horizon, &options] {
        let mut run = RemedyRun::after_proof(Arc::clone(&problem), options.clone()).unwrap();
        while !run.advance(16).unwrap() {}
        let advice = run.outcome().unwrap();
        assert_eq!((advice.reason, advice.shortest), (Some(Reason::Bounds), Some(0)));
    }
}
