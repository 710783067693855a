//! Exact search against plain enumeration of every plan, and against the closure of every
//! situation.

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::sync::Arc;

use mo_copp::solver::{Horizon, Options, Outcome, Solver, Status, UpperBound, solve, upper_bounds};

use crate::common::random::{self, MEDIUM, PAIR, Size};
use crate::common::table::{Table, Watcher, set};
use crate::common::{Dice, Judge, Wish, oracle};
use crate::golden::replay;
use crate::search;

/// Pairs of counts with the shortest plan for each.
fn pairs(
    judge: &Judge,
    endings: &BTreeMap<Vec<u32>, usize>,
    wish: &Wish,
) -> BTreeMap<(usize, usize), usize> {
    let mut pairs = BTreeMap::new();
    for (ending, &length) in endings {
        if wish.allows(&judge.table, ending) {
            let shortest = pairs.entry(judge.table.counts(ending)).or_insert(length);
            *shortest = length.min(*shortest);
        }
    }
    pairs
}

/// The reported pairs with the lengths of their plans, each plan replayed.
fn reported(judge: &Judge, outcome: &Outcome, wish: &Wish) -> BTreeMap<(usize, usize), usize> {
    let points = outcome.pairs.as_ref().unwrap();
    assert!(points.is_sorted_by(|a, b| a.counts < b.counts));
    let mut pairs = BTreeMap::new();
    for point in points {
        let ending = judge.ending(&point.plan);
        let counts = (point.counts.adversarial, point.counts.cooperative);
        assert_eq!(judge.table.counts(&ending), counts);
        assert!(wish.allows(&judge.table, &ending));
        pairs.insert(counts, point.plan.len());
    }
    let dominated = |&&(x, c): &&(usize, usize)| {
        pairs
            .keys()
            .any(|&(other_x, other_c)| other_x >= x && other_c <= c && (other_x, other_c) != (x, c))
    };
    let front = outcome.front().unwrap();
    let front = front.iter().map(|pair| (pair.counts.adversarial, pair.counts.cooperative));
    assert!(front.eq(pairs.keys().filter(|pair| !dominated(pair)).copied()));
    pairs
}

fn check_best(judge: &Judge, options: &Options, outcome: &Outcome, wish: &Wish, best: Option<i64>) {
    let ending = judge.check(options, outcome, wish);
    assert_eq!(ending.map(|ending| oracle::difference(&judge.table, &ending)), best);
    let status = if best.is_some() { Status::Optimal } else { Status::Infeasible };
    assert_eq!(outcome.status, status);
}

/// Exact search at a horizon: the best difference and the pairs of every plan there is.
pub fn equals_enumeration(judge: &Judge, horizon: usize, wish: &Wish) {
    let endings = oracle::enumerate(&judge.table, horizon);
    let mut options = Judge::options(Solver::Exact, Some(horizon), wish);
    let best = oracle::best(&judge.table, &endings, wish);
    check_best(judge, &options, &judge.solve(&options), wish, best);
    options.pairs = true;
    let outcome = judge.solve(&options);
    check_best(judge, &options, &outcome, wish, best);
    let lengths = endings.into_iter().map(|ending| (ending, horizon)).collect();
    assert_eq!(reported(judge, &outcome, wish), pairs(judge, &lengths, wish));
}

/// No upper bound is below the best of all plans, and none says that there is no plan where there is
/// one.
pub fn bounds_hold(judge: &Judge, options: &Options, best: Option<i64>) {
    let most = judge.table.goals.len() as f64 - 1.0;
    for (name, bound) in upper_bounds(&judge.problem, options).unwrap() {
        match (bound, best) {
            (UpperBound::AtMost(bound), Some(best)) => {
                assert!(bound >= best as f64 / most - 1e-9, "{name}: {bound} below {best}");
            }
            (UpperBound::Infeasible, best) => assert_eq!(best, None, "{name}"),
            // No plan keeps what is asked, or the bound is too dear.
            _ => {}
        }
    }
}

/// Each bound against the closure, without wishes and with random ones.
pub fn bounds_hold_for(judge: &Judge, dice: &mut Dice) {
    for wish in [Wish::default(), random::wish(dice, &judge.table)] {
        let best = oracle::best(&judge.table, judge.endings().keys(), &wish);
        bounds_hold(judge, &Judge::options(Solver::Exact, None, &wish), best);
    }
}

/// Exact search over all lengths: the best difference, a shortest plan for it, the pairs and a
/// shortest plan for each.
pub fn equals_closure(judge: &Judge, wish: &Wish) {
    let endings = judge.endings();
    let expected = pairs(judge, endings, wish);
    let best = oracle::best(&judge.table, endings.keys(), wish);
    let mut options = Judge::options(Solver::Exact, None, wish);
    bounds_hold(judge, &options, best);
    for pairs_too in [false, true] {
        options.pairs = pairs_too;
        let outcome = judge.solve(&options);
        check_best(judge, &options, &outcome, wish, best);
        if pairs_too {
            assert_eq!(reported(judge, &outcome, wish), expected);
        }
        let with_best =
            |((x, c), _): &(&(usize, usize), &usize)| Some(*x as i64 - *c as i64) == best;
        let shortest = expected.iter().filter(with_best).map(|(_, &length)| length).min();
        assert_eq!(outcome.plan.map(|plan| plan.len()), shortest);
    }
}

#[test]
fn at_a_horizon_equals_the_enumeration_of_all_plans() {
    let mut dice = Dice::new(1);
    for number in 0..25_000 {
        let judge = Judge::new(random::table(&mut dice, MEDIUM, &PAIR));
        let horizon = random::horizon(&mut dice, &judge.table, 1100);
        let wish =
            if number % 3 == 0 { Wish::default() } else { random::wish(&mut dice, &judge.table) };
        equals_enumeration(&judge, horizon, &wish);
    }
}

/// So that a bound that says nothing does not pass for one that holds.
#[test]
fn every_bound_is_tight_on_some_problems_and_the_better_ones_more_often() {
    let mut dice = Dice::new(13);
    let mut tight = BTreeMap::new();
    for _ in 0..3000 {
        let judge = Judge::new(random::table(&mut dice, MEDIUM, &PAIR));
        let options = Judge::options(Solver::Exact, None, &Wish::default());
        let best = oracle::best(&judge.table, judge.endings().keys(), &Wish::default());
        bounds_hold(&judge, &options, best);
        let most = judge.table.goals.len() as f64 - 1.0;
        let expected =
            best.map_or(UpperBound::Infeasible, |best| UpperBound::AtMost(best as f64 / most));
        for (name, bound) in upper_bounds(&judge.problem, &options).unwrap() {
            *tight.entry(name).or_insert(0) += usize::from(bound == expected);
        }
    }
    println!("{tight:?}");
    assert!(tight["trivial"] > 100, "{tight:?}");
    for name in ["linear invariants", "observable classes", "pairs of states"] {
        assert!(tight[name] > tight["trivial"], "{name}: {tight:?}");
    }
}

#[test]
fn over_all_lengths_equals_the_closure_of_all_situations() {
    let mut dice = Dice::new(2);
    for number in 0..25_000 {
        let judge = Judge::new(random::table(&mut dice, MEDIUM, &PAIR));
        let wish =
            if number % 3 == 0 { Wish::default() } else { random::wish(&mut dice, &judge.table) };
        equals_closure(&judge, &wish);
    }
}

/// Larger than enumeration is up to.
#[test]
fn over_all_lengths_on_larger_problems() {
    let mut dice = Dice::new(12);
    for _ in 0..1500 {
        let size = Size { states: 12, actions: 4, goals: 6 };
        let judge = Judge::new(random::table(&mut dice, size, &PAIR));
        let wish = random::wish(&mut dice, &judge.table);
        equals_closure(&judge, &wish);
        for solver in search::SOLVERS {
            search::agrees(&judge, solver, None, &wish);
        }
    }
}

/// Logistics drawn, whose shortest plans are about as long as the horizon: hundreds of thousands of states
/// can be met within it, and few of them lie on a plan. The values are those of an exhaustive search by layers.
#[test]
fn a_tight_horizon_is_proved_where_states_are_many() {
    for (seed, horizon, value) in [(2, 25, 0.75), (17, 20, 0.0), (29, 26, 0.25)] {
        let problem = Arc::new(replay::draw("logistics", seed).problem().unwrap());
        let options = Options::new(Solver::Exact).with_horizon(Horizon::Steps(horizon));
        let outcome = solve(problem, options, |_| ControlFlow::Continue(())).unwrap();
        let found = (outcome.status, outcome.goal_difference);
        assert_eq!(found, (Status::Optimal, Some(value)), "{seed}");
        assert!(outcome.stats.expansions < 10_000, "{seed}: {}", outcome.stats.expansions);
    }
}

/// As long as a horizon can be: there and back ten thousand times.
#[test]
fn at_the_longest_horizon() {
    let step = |from: usize| vec![Some(1 - from)];
    let watcher = |role| Watcher {
        role,
        belief: set(&[0]),
        symbols: vec!["step".to_owned()],
        sensor: vec![vec![0; 2]],
    };
    let judge = Judge::new(Table {
        states: vec!["s0".to_owned(), "s1".to_owned()],
        actions: vec!["step".to_owned()],
        next: vec![step(0), step(1)],
        start: 0,
        goals: vec![set(&[0]), set(&[1])],
        goal_names: vec!["G1".to_owned(), "G2".to_owned()],
        true_goal: 0,
        watchers: PAIR.map(watcher).to_vec(),
    });
    for (horizon, possible) in [(10_000, true), (9_999, false)] {
        for solver in Solver::ALL {
            let options = Judge::options(solver, Some(horizon), &Wish::default());
            let outcome = judge.solve(&options);
            let ending = judge.check(&options, &outcome, &Wish::default());
            assert_eq!(ending.is_some(), possible, "{} {horizon}", solver.name());
        }
    }
}

#[test]
fn random_strips_problems_equal_enumeration() {
    let mut dice = Dice::new(131);
    for _ in 0..300 {
        let judge = random::strips(&mut dice).judge();
        let wish = random::wish(&mut dice, &judge.table);
        let horizon = dice.below(4);
        equals_enumeration(&judge, horizon, &wish);
    }
}

#[test]
fn no_upper_bound_is_below_the_best_plan_of_random_strips_problems() {
    let mut dice = Dice::new(132);
    let mut infeasible = 0;
    for _ in 0..3_000 {
        let judge = random::strips(&mut dice).judge();
        let wish = random::wish(&mut dice, &judge.table);
        let best = oracle::best(&judge.table, judge.endings().keys(), &wish);
        infeasible += usize::from(best.is_none());
        bounds_hold(&judge, &Judge::options(Solver::Exact, None, &wish), best);
    }
    assert!(infeasible > 100, "{infeasible}");
}
