//! Each correction of the printed encoding: the printed form gives a wrong answer, the corrected
//! one the right one.

use mo_copp::problem::Role::{Adversarial, Cooperative};
use mo_copp::solver::Solver;

use crate::common::printed::{self, CORRECTED, Form, Post, Symbols, Ten};
use crate::common::random;
use crate::common::strips::{Eye, Strips, op};
use crate::common::{Dice, Judge, Wish, oracle};
use crate::integer_programs::both_find;

const P: u32 = 1;
const Q: u32 = 2;
const R: u32 = 4;

/// All plans of one action; returns the true optimum once exact search and the corrected forms,
/// this one and the crate's, have all found it.
fn optimum(problem: &Strips) -> Option<i64> {
    let judge = problem.judge();
    let wish = Wish::default();
    let endings = oracle::enumerate(&judge.table, 1);
    let best = oracle::best(&judge.table, &endings, &wish);
    let options = Judge::options(Solver::Exact, Some(1), &wish);
    let ending = judge.check(&options, &judge.solve(&options), &wish);
    assert_eq!(ending.map(|ending| oracle::difference(&judge.table, &ending)), best);
    both_find(&judge, 1, &wish, best);
    assert_eq!(printed::solve(problem, 1, &wish, CORRECTED), best);
    best
}

fn with(problem: &Strips, form: Form) -> Option<i64> {
    printed::solve(problem, 1, &Wish::default(), form)
}

/// Correction 1. `go` leads to the true goal q and everybody sees it, so both sides keep one goal.
/// Equation (7) alone lets the enemy's `g` of r be 1 while nobody believes a state with r.
#[test]
fn seven_alone_gives_every_goal_to_the_enemy() {
    let problem = Strips {
        facts: 3,
        ops: vec![op("go", P, Q, P)],
        start: P,
        goals: vec![Q, R],
        eyes: vec![
            Eye::of_operators(Adversarial, &[P], &["go"]),
            Eye::of_operators(Cooperative, &[P], &["go"]),
        ],
    };
    assert_eq!(optimum(&problem), Some(0));
    assert_eq!(with(&problem, Form { upper_bound_on_g: false, ..CORRECTED }), Some(1));
}

/// Correction 2. `a` leads to the true goal q, `b` to r. The enemy tells them apart and keeps q
/// alone, the friend does not and keeps both: −1.
fn two_symbols() -> Strips {
    Strips {
        facts: 3,
        ops: vec![op("a", P, Q, P), op("b", P, R, P)],
        start: P,
        goals: vec![Q, R],
        eyes: vec![
            Eye::of_operators(Adversarial, &[P], &["a", "b"]),
            Eye::of_operators(Cooperative, &[P], &["step", "step"]),
        ],
    }
}

/// (12) over all `o` forces the enemy's `h` of both actions to 1, (15) over all `o` to 0.
#[test]
fn twelve_and_fifteen_over_all_symbols_are_infeasible() {
    let problem = two_symbols();
    assert_eq!(optimum(&problem), Some(-1));
    let all = Symbols::All;
    assert_eq!(with(&problem, Form { symbols_of_12: all, symbols_of_15: all, ..CORRECTED }), None);
}

/// (12) over all `o` on its own: the enemy's belief ignores the sensor and keeps r too.
#[test]
fn twelve_over_all_symbols_ignores_the_sensor() {
    let (symbols_of_12, symbols_of_15) = (Symbols::All, Symbols::None);
    let form = Form { symbols_of_12, symbols_of_15, ..CORRECTED };
    assert_eq!(with(&two_symbols(), form), Some(0));
    // Both with their own symbol would say so.
    assert_eq!(with(&two_symbols(), CORRECTED), Some(-1));
}

/// (15) over all `o` on its own: the enemy's belief dies, and not even the true goal, which always
/// survives, can be required.
#[test]
fn fifteen_over_all_symbols_kills_the_belief() {
    let (symbols_of_12, symbols_of_15) = (Symbols::None, Symbols::All);
    let form = Form { symbols_of_12, symbols_of_15, ..CORRECTED };
    let wish = Wish { required: vec![(0, 0)], ..Wish::default() };
    assert_eq!(printed::solve(&two_symbols(), 1, &wish, form), None);
    assert_eq!(printed::solve(&two_symbols(), 1, &wish, CORRECTED), Some(-1));
}

/// Correction 3, first half. From {p} only `b` gives r, seen by all, so both sides keep G1 alone.
/// By the printed `post_a` the actor may take `a`, seen as something else, and yet be in {q, r},
/// which contains what `a` adds. (From {r}, which the enemy holds possible, `a` does lead there, so
/// (9) has nothing against it.) Then the enemy holds {p, q} and {q, r} possible and the friend
/// {p, q} alone. (As an equality it allows nothing at all: what `b` adds is there as well, so both
/// `x` must be 1.)
#[test]
fn ten_lets_an_action_lead_to_any_state_with_its_add_effects() {
    let problem = Strips {
        facts: 3,
        ops: vec![op("a", 0, Q, 0), op("b", P, Q | R, P)],
        start: P,
        goals: vec![R, P | Q],
        eyes: vec![
            Eye::of_operators(Adversarial, &[P, R], &["quiet", "loud"]),
            Eye::of_operators(Cooperative, &[P], &["quiet", "loud"]),
        ],
    };
    assert_eq!(optimum(&problem), Some(0));
    let post_of_10 = Post::ContainsAdds;
    assert_eq!(with(&problem, Form { post_of_10, ..CORRECTED }), Some(1));
    assert_eq!(with(&problem, Form { post_of_10, ten: Ten::Equality, ..CORRECTED }), None);
}

/// Correction 3, second half. `stay` and a blocked move both lead from {p} to {p}: by the equality
/// both `x` are the same product, 1, against (17).
#[test]
fn ten_as_an_equality_forbids_two_actions_with_one_effect() {
    let problem = Strips {
        facts: 2,
        ops: vec![op("stay", P, P, 0), op("bump", P, P, 0)],
        start: P,
        goals: vec![P, Q],
        eyes: vec![
            Eye::of_operators(Adversarial, &[P, P | Q], &["still", "bump"]),
            Eye::of_operators(Cooperative, &[P], &["still", "still"]),
        ],
    };
    assert_eq!(optimum(&problem), Some(1));
    assert_eq!(with(&problem, Form { ten: Ten::Equality, ..CORRECTED }), None);
}

/// With every correction on, the equations say what enumeration says, and the crate's encodings
/// and exact search too.
#[test]
fn the_corrected_equations_equal_enumeration() {
    let mut dice = Dice::new(7);
    let mut feasible = 0;
    for number in 0..1000 {
        let problem = Strips::random(&mut dice, 3, 3, &random::PAIR);
        let judge = problem.judge();
        let horizon = dice.below(3);
        let wish =
            if number % 2 == 0 { Wish::default() } else { random::wish(&mut dice, &judge.table) };
        let endings = oracle::enumerate(&judge.table, horizon);
        let best = oracle::best(&judge.table, &endings, &wish);
        feasible += usize::from(best.is_some());
        assert_eq!(printed::solve(&problem, horizon, &wish, CORRECTED), best, "{problem:?}");
        both_find(&judge, horizon, &wish, best);
        let options = Judge::options(Solver::Exact, Some(horizon), &wish);
        let ending = judge.check(&options, &judge.solve(&options), &wish);
        assert_eq!(ending.map(|ending| oracle::difference(&judge.table, &ending)), best);
    }
    assert!((200..800).contains(&feasible), "{feasible} feasible");
}
