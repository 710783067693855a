//! The best of each length in one go, against the enumeration of all plans and against exact search
//! at each horizon.

use std::sync::Arc;

use mo_copp::domain::gridworld::GridworldShape;
use mo_copp::limits::LimitReached;
use mo_copp::problem::SurvivorCounts;
use mo_copp::solver::{
    Horizon, LengthPoint, MAX_LENGTHS, Options, Outcome, Run, Solver, Status, abandoned,
};

use crate::common::check::solve;
use crate::common::random::{self, MEDIUM, PAIR, Size};
use crate::common::{Dice, Judge, Wish, oracle};
use crate::observers::COMPANIES;

fn lengths(longest: usize, wish: &Wish) -> Options {
    let mut options = Judge::options(Solver::Exact, None, wish);
    options.lengths = Some(longest);
    options
}

fn pair(counts: SurvivorCounts) -> (usize, usize) {
    (counts.adversarial, counts.cooperative)
}

/// Each plan does what its point says.
fn check_points(judge: &Judge, points: &[LengthPoint], wish: &Wish) {
    for (length, point) in points.iter().enumerate() {
        assert_eq!(point.length, length);
        let Some(best) = &point.best else { continue };
        assert_eq!(best.plan.len(), length);
        let ending = judge.ending(&best.plan);
        assert!(wish.allows(&judge.table, &ending));
        assert_eq!(judge.table.counts(&ending), pair(best.counts));
    }
}

/// The best of all points, the shorter of equals.
fn best(points: &[LengthPoint]) -> Option<(i64, usize)> {
    let found = points.iter().filter_map(|point| {
        point.best.as_ref().map(|best| (best.counts.difference(), point.length))
    });
    found.max_by_key(|&(difference, length)| (difference, std::cmp::Reverse(length)))
}

fn check_outcome(judge: &Judge, options: &Options, outcome: &Outcome, wish: &Wish) {
    let points = outcome.lengths.as_ref().unwrap();
    assert_eq!(points.len(), options.lengths.unwrap() + 1);
    check_points(judge, points, wish);
    let ending = judge.check(options, outcome, wish);
    let best = best(points);
    assert_eq!(ending.map(|e| oracle::difference(&judge.table, &e)), best.map(|(d, _)| d));
    assert_eq!(outcome.plan.as_ref().map(mo_copp::plan::Plan::len), best.map(|(_, length)| length));
}

#[test]
fn equals_the_enumeration_of_all_plans_of_each_length() {
    let mut dice = Dice::new(61);
    let (mut plans, mut none) = (0, 0);
    for number in 0..4000 {
        let roles = if number % 4 == 0 { COMPANIES[number / 4 % COMPANIES.len()] } else { &PAIR };
        let judge = Judge::built(random::table(&mut dice, MEDIUM, roles), 0);
        let longest = random::horizon(&mut dice, &judge.table, 600);
        let wish =
            if number % 3 == 0 { Wish::default() } else { random::wish(&mut dice, &judge.table) };
        let options = lengths(longest, &wish);
        let outcome = judge.solve(&options);
        check_outcome(&judge, &options, &outcome, &wish);
        for point in outcome.lengths.unwrap() {
            let endings = oracle::enumerate(&judge.table, point.length);
            let expected = oracle::best(&judge.table, &endings, &wish);
            assert_eq!(point.best.map(|best| best.counts.difference()), expected);
            *(if expected.is_some() { &mut plans } else { &mut none }) += 1;
        }
    }
    assert!(plans > 3000 && none > 3000, "{plans} with a plan, {none} without");
}

/// Longer than enumeration is up to, and all pairs of all lengths besides.
#[test]
fn equals_exact_search_at_each_horizon() {
    let mut dice = Dice::new(62);
    for _ in 0..600 {
        let size = Size { states: 12, actions: 4, goals: 5 };
        let judge = Judge::new(random::table(&mut dice, size, &PAIR));
        let wish = random::wish(&mut dice, &judge.table);
        let mut options = lengths(dice.below(25), &wish);
        options.pairs = dice.percent(50);
        let outcome = judge.solve(&options);
        check_outcome(&judge, &options, &outcome, &wish);
        let mut pairs = Vec::new();
        for point in outcome.lengths.as_ref().unwrap() {
            let mut alone = Judge::options(Solver::Exact, Some(point.length), &wish);
            alone.pairs = options.pairs;
            let alone = judge.solve(&alone);
            let difference =
                |best: &mo_copp::solver::ReachablePair| judge.problem.goal_difference(best.counts);
            assert_eq!(point.best.as_ref().map(difference), alone.goal_difference);
            for found in alone.pairs.into_iter().flatten() {
                if !pairs.iter().any(|&(counts, _)| counts == pair(found.counts)) {
                    pairs.push((pair(found.counts), point.length));
                }
            }
        }
        assert_eq!(outcome.pairs.is_some(), options.pairs);
        if let Some(found) = &outcome.pairs {
            pairs.sort_unstable();
            let found: Vec<_> = found.iter().map(|p| (pair(p.counts), p.plan.len())).collect();
            assert_eq!(found, pairs);
        }
    }
}

#[test]
fn the_paper_s_grid_at_forty_lengths() {
    for seed in 0..6 {
        let document = GridworldShape { walls: 6, ..GridworldShape::default() };
        let document = document.generate(seed).unwrap().document;
        let problem = Arc::new(document.problem().unwrap());
        let mut options = Options::new(Solver::Exact);
        options.lengths = Some(40);
        for point in solve(&problem, &options).lengths.unwrap() {
            let mut alone = Options::new(Solver::Exact);
            alone.horizon = Horizon::Steps(point.length);
            let difference = point.best.map(|best| problem.goal_difference(best.counts));
            assert_eq!(difference, solve(&problem, &alone).goal_difference, "{}", point.length);
        }
    }
}

/// Advances by this budget to the end.
fn in_slices(judge: &Judge, options: &Options, budget: u64) -> Outcome {
    let mut run = Run::new(Arc::clone(&judge.problem), options.clone()).unwrap();
    while !run.advance(budget).unwrap() {}
    run.outcome().unwrap()
}

#[test]
fn what_is_proved_is_kept_when_it_is_stopped() {
    let mut dice = Dice::new(63);
    let (mut cancelled, mut limited) = (0, 0);
    for _ in 0..1500 {
        let judge = Judge::new(random::table(&mut dice, MEDIUM, &PAIR));
        let wish = random::wish(&mut dice, &judge.table);
        let options = lengths(dice.below(12), &wish);
        let whole = in_slices(&judge, &options, u64::MAX);
        assert_eq!(in_slices(&judge, &options, 1), whole);
        let proved = whole.lengths.as_ref().unwrap();
        let check = |outcome: &Outcome| {
            let points = outcome.lengths.as_ref().unwrap();
            assert!((1..=proved.len()).contains(&points.len()));
            // The same differences; the plans for them may be others.
            check_points(&judge, points, &wish);
            for (point, whole) in points.iter().zip(proved) {
                let difference =
                    |point: &LengthPoint| point.best.as_ref().map(|b| b.counts.difference());
                assert_eq!(difference(point), difference(whole));
            }
            let ending = judge.check_plan(&options, outcome, &wish);
            let feasible = match outcome.status {
                // None can be better.
                Status::Optimal => {
                    assert_eq!(outcome.goal_difference, whole.goal_difference);
                    true
                }
                Status::Feasible => {
                    assert_ne!(outcome.goal_difference, Some(1.0));
                    true
                }
                status => {
                    assert_eq!(status, Status::Limit);
                    false
                }
            };
            assert_eq!(feasible, ending.is_some());
            assert!(points.iter().all(|p| p.best.is_none()) || feasible);
        };
        let mut run = Run::new(Arc::clone(&judge.problem), options.clone()).unwrap();
        let mut finished = false;
        for _ in 0..dice.between(1, 9) {
            finished = run.advance(1).unwrap();
        }
        let progress = run.progress();
        let outcome = run.outcome().unwrap();
        if finished {
            assert_eq!(outcome, whole);
        } else {
            cancelled += 1;
            assert_eq!(outcome.limit, Some(LimitReached::Cancelled));
            check(&outcome);
            let left = abandoned(&judge.problem, &options, Some(&progress)).unwrap();
            assert_eq!((&left.plan, &left.lengths), (&progress.plan, &None));
        }
        let mut options = options.clone();
        options.limits.expansions = dice.below(8) as u64;
        let outcome = in_slices(&judge, &options, u64::MAX);
        assert_eq!(in_slices(&judge, &options, 1), outcome);
        if outcome.limit.is_none() {
            assert_eq!(outcome, whole);
        } else {
            limited += 1;
            check(&outcome);
        }
    }
    assert!(cancelled > 300 && limited > 300, "{cancelled} cancelled, {limited} limited");
}

#[test]
fn a_memory_limit_is_met_at_the_same_place_whatever_the_slices() {
    let mut dice = Dice::new(64);
    let mut limited = 0;
    for _ in 0..600 {
        let judge = Judge::new(random::table(&mut dice, MEDIUM, &PAIR));
        let mut options = lengths(200, &Wish::default());
        options.limits.bytes = dice.pick(&[0, 300, 1000, 3000, 10_000]);
        let outcome = in_slices(&judge, &options, u64::MAX);
        limited += usize::from(outcome.limit == Some(LimitReached::Memory { limit_mib: 0 }));
        for budget in [1, 7] {
            assert_eq!(in_slices(&judge, &options, budget), outcome);
        }
    }
    assert!(limited > 100, "{limited}");
}

#[test]
fn options_that_do_not_go_with_lengths_are_refused() {
    let problem = Arc::new(mo_copp::domain::Delivery::figure_1().problem().unwrap());
    let refused = |solver, horizon, longest| {
        let mut options = Options::new(solver);
        (options.horizon, options.lengths) = (horizon, Some(longest));
        Run::new(Arc::clone(&problem), options).unwrap_err().to_string()
    };
    assert_eq!(
        refused(Solver::Exact, Horizon::Auto, MAX_LENGTHS + 1),
        "lengths: found 1001, expected a whole number from 0 to 1000"
    );
    assert_eq!(
        refused(Solver::Search, Horizon::Auto, 9),
        "lengths: found the solver search, expected the solver exact"
    );
    assert_eq!(
        refused(Solver::Exact, Horizon::Steps(3), 9),
        "lengths: found a horizon of 3, expected no horizon, since all from 0 to 9 are tried"
    );
}
