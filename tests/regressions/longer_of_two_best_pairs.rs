//! Over all lengths, of two pairs with the best difference the one with fewer survivors for the
//! friend was taken even where its plan was longer; a shortest plan for the best difference is
//! asked for.

use mo_copp::problem::Role;
use mo_copp::solver::Solver;

use crate::common::table::{Table, Watcher, set};
use crate::common::{Judge, Wish};

/// From s0, `short` leads to the true goal at s1 in one step and `long` over s2 to s3 in two; both
/// observers see the action and the enemy begins with s4 as well, from where `short` leads to s5
/// and `long` over s6 to s7.
fn table() -> Table {
    let mut next = vec![vec![None, None]; 8];
    next[0] = vec![Some(1), Some(2)];
    next[2] = vec![None, Some(3)];
    next[4] = vec![Some(5), Some(6)];
    next[6] = vec![None, Some(7)];
    let watcher = |role, belief| Watcher {
        role,
        belief,
        symbols: vec!["short".to_owned(), "long".to_owned()],
        sensor: vec![vec![0; 8], vec![1; 8]],
    };
    Table {
        states: (0..8).map(|state| format!("s{state}")).collect(),
        actions: vec!["short".to_owned(), "long".to_owned()],
        next,
        start: 0,
        // s1 satisfies G1 and G2, s5 G3: (3, 2). s3 satisfies G1 alone, s7 G2: (2, 1).
        goals: vec![set(&[1, 3]), set(&[1, 7]), set(&[5])],
        goal_names: vec!["G1".to_owned(), "G2".to_owned(), "G3".to_owned()],
        true_goal: 0,
        watchers: vec![
            watcher(Role::Adversarial, set(&[0, 4])),
            watcher(Role::Cooperative, set(&[0])),
        ],
    }
}

#[test]
fn the_shorter_plan_is_given() {
    let judge = Judge::new(table());
    let mut options = Judge::options(Solver::Exact, None, &Wish::default());
    options.pairs = true;
    let outcome = judge.solve(&options);
    let pairs = outcome.pairs.as_ref().unwrap();
    let seen: Vec<_> =
        pairs.iter().map(|p| (p.counts.adversarial, p.counts.cooperative, p.plan.len())).collect();
    assert_eq!(seen, [(2, 1, 2), (3, 2, 1)]);
    assert_eq!(outcome.goal_difference, Some(0.5));
    assert_eq!(outcome.plan.unwrap().names(judge.problem.task()), ["short"]);
}
