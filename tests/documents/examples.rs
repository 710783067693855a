//! The documents in `examples/`: one of each domain of the paper and of its motivating example.

use std::collections::BTreeSet;
use std::sync::Arc;

use mo_copp::domain::Document;
use mo_copp::solver::{Options, Solver, Status};

use crate::common::check::solve;

/// By the paper: how many candidate goals there are, and k and j of the search.
const EXAMPLES: [(&str, usize, usize, usize); 7] = [
    ("blocksworld", 5, 3, 3),
    ("box-pushing", 3, 2, 2),
    ("delivery", 6, 6, 1),
    ("driverlog", 5, 3, 3),
    ("gridworld", 3, 2, 2),
    ("logistics", 5, 3, 3),
    ("recycling-robot", 3, 2, 2),
];

#[test]
fn each_is_of_the_size_of_the_paper_and_solved_within_its_bounds() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/examples");
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name());
    let files: BTreeSet<String> = files
        .map(|name| name.into_string().unwrap())
        .filter(|name| std::path::Path::new(name).extension().is_some_and(|end| end == "json"))
        .collect();
    let named: BTreeSet<String> =
        EXAMPLES.iter().map(|(name, ..)| format!("{name}.json")).collect();
    assert_eq!(files, named);
    for (name, goals, k, j) in EXAMPLES {
        let text = std::fs::read_to_string(format!("{folder}/{name}.json")).unwrap();
        assert!(text.lines().all(|line| line.len() <= 120), "{name} is readable");
        let problem = Arc::new(Document::parse(&text).unwrap().problem().unwrap());
        assert_eq!(problem.goals().len(), goals, "{name}");
        for solver in [Solver::Search, Solver::Satisficing] {
            let mut options = Options::new(solver);
            options.bounds.at_least = Some(k);
            options.bounds.at_most = Some(j);
            let outcome = solve(&problem, &options);
            assert_eq!(outcome.status, Status::Solved, "{name}");
            let least = (k as f64 - j as f64) / (goals as f64 - 1.0);
            assert!(outcome.goal_difference >= Some(least), "{name}");
        }
    }
}
