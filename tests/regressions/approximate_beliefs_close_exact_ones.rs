//! Algorithm 1 put a node off for ever when an approximation of a larger belief had closed the
//! very states that are all this node's observers believe.

use mo_copp::problem::Role;
use mo_copp::solver::{Solver, Status};

use crate::common::table::{Table, Watcher, set};
use crate::common::{Judge, Wish};

/// `a` and `b` lead from s0 to s1, `c` on to s2; from s3, which the observers also hold possible,
/// `a` leads to s4 and `c` on to s5. `a` and `b` look different, so only after `b` is s5 ruled out.
fn table() -> Table {
    let mut next = vec![vec![None; 3]; 6];
    next[0] = vec![Some(1), Some(1), None];
    next[1] = vec![None, None, Some(2)];
    next[3] = vec![Some(4), None, None];
    next[4] = vec![None, None, Some(5)];
    let watcher = |role| Watcher {
        role,
        belief: set(&[0, 3]),
        symbols: ["a", "b", "c"].map(str::to_owned).to_vec(),
        sensor: vec![vec![0; 6], vec![1; 6], vec![2; 6]],
    };
    Table {
        states: (0..6).map(|state| format!("s{state}")).collect(),
        actions: ["a", "b", "c"].map(str::to_owned).to_vec(),
        next,
        start: 0,
        goals: vec![set(&[2]), set(&[5])],
        goal_names: vec!["G1".to_owned(), "G2".to_owned()],
        true_goal: 0,
        watchers: vec![watcher(Role::Adversarial), watcher(Role::Cooperative)],
    }
}

#[test]
fn the_smaller_belief_has_its_turn() {
    let judge = Judge::new(table());
    // G2 must not survive for the friend.
    let wish = Wish { forbidden: vec![(1, 1)], ..Wish::default() };
    let outcome = judge.solve(&Judge::options(Solver::Search, None, &wish));
    assert_eq!(outcome.status, Status::Solved);
    assert_eq!(outcome.plan.unwrap().names(judge.problem.task()), ["b", "c"]);
}
