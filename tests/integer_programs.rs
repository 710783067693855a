//! Both integer programs against plain enumeration, and against exact search where the problems
//! are larger.

use mo_copp::solver::{Encoding, Solver, Status};

use crate::common::random::{self, PAIR, SMALL, Size};
use crate::common::{Dice, Judge, Wish, oracle};

/// Both encodings must find this difference, or none.
pub fn both_find(judge: &Judge, horizon: usize, wish: &Wish, best: Option<i64>) {
    for encoding in Encoding::ALL {
        let mut options = Judge::options(Solver::Ip, Some(horizon), wish);
        options.encoding = encoding;
        let outcome = judge.solve(&options);
        assert_eq!(outcome.encoding, Some(encoding));
        let ending = judge.check(&options, &outcome, wish);
        let found = ending.map(|ending| oracle::difference(&judge.table, &ending));
        assert_eq!(found, best, "{} T={horizon} {wish:?}", encoding.name());
        let status = if best.is_some() { Status::Optimal } else { Status::Infeasible };
        assert_eq!(outcome.status, status);
    }
}

/// Both encodings must find what enumeration finds; returns whether there is a plan.
pub fn equal_enumeration(judge: &Judge, horizon: usize, wish: &Wish) -> bool {
    let endings = oracle::enumerate(&judge.table, horizon);
    let best = oracle::best(&judge.table, &endings, wish);
    both_find(judge, horizon, wish, best);
    best.is_some()
}

fn on_random_problems(seed: u64, problems: usize, size: Size) {
    let mut dice = Dice::new(seed);
    let mut infeasible = 0;
    for number in 0..problems {
        let judge = Judge::new(random::table(&mut dice, size, &PAIR));
        let horizon = random::horizon(&mut dice, &judge.table, 300);
        let wish =
            if number % 3 == 0 { Wish::default() } else { random::wish(&mut dice, &judge.table) };
        infeasible += usize::from(!equal_enumeration(&judge, horizon, &wish));
    }
    assert!((problems / 4..problems * 3 / 4).contains(&infeasible), "{infeasible} infeasible");
}

#[test]
fn both_encodings_equal_enumeration_on_small_problems() {
    on_random_problems(5, 8000, SMALL);
}

#[test]
fn both_encodings_equal_enumeration_on_larger_problems() {
    on_random_problems(6, 3000, Size { states: 6, actions: 3, goals: 4 });
}
