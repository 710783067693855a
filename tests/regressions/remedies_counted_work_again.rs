//! Of a space of 267 nodes the search for remedies expanded 19,633: each question began anew, so that
//! its 100,000 expansions were spent before it had come to a j of 5.

use std::sync::Arc;

use mo_copp::domain::Document;
use mo_copp::solver::remedy::{Change, RemedyRun};
use mo_copp::solver::{Options, Solver, Status, solve};

const DOCUMENT: &str = include_str!("remedy-incomplete.json");

#[test]
fn a_small_space_is_searched_to_its_end_once() {
    let problem = Arc::new(Document::parse(DOCUMENT).unwrap().problem().unwrap());
    let mut options = Options::new(Solver::Exact);
    (options.bounds.at_least, options.bounds.at_most) = (Some(5), Some(3));
    let outcome =
        solve(Arc::clone(&problem), options.clone(), |_| std::ops::ControlFlow::Continue(()));
    assert_eq!(outcome.unwrap().status, Status::Infeasible);
    options.limits.expansions = 1_000;
    for proved in [false, true] {
        let begin = if proved { RemedyRun::after_proof } else { RemedyRun::new };
        let mut run = begin(Arc::clone(&problem), options.clone()).unwrap();
        while !run.advance(16).unwrap() {}
        let advice = run.outcome().unwrap();
        assert!(advice.complete);
        let changes: Vec<_> = advice.remedies.iter().map(|it| (it.change, it.value)).collect();
        assert!(changes.contains(&(Change::AtMost, 5)), "{changes:?}");
        // The states on the way to the nearest goal, and each node once.
        assert!(run.progress().done <= 267 + 10, "{}", run.progress().done);
    }
}
