//! Slices, cancels, limits and raised horizons.

use std::sync::Arc;

use mo_copp::domain::generate::Domain;
use mo_copp::limits::{LimitReached, Limits};
use mo_copp::solver::{Encoding, Horizon, Options, Outcome, Run, Solver, Status, abandoned};

use crate::common::random::{self, MEDIUM, PAIR, SMALL};
use crate::common::{Dice, Judge, Wish, oracle, solve};
use crate::contradictions::contradictory;
use crate::search::heeded;

/// Advances by this budget to the end.
fn in_slices(judge: &Judge, options: &Options, budget: u64) -> Outcome {
    let mut run = Run::new(Arc::clone(&judge.problem), options.clone()).unwrap();
    for _ in 0..1_000_000 {
        if run.advance(budget).unwrap() {
            return run.outcome().unwrap();
        }
    }
    panic!("no end");
}

/// The same answer. An integer program that turns out infeasible comes back from microlp without
/// its counts; only an interrupted one before it has left some.
fn assert_same(mut one: Outcome, other: &Outcome) {
    if one.solver == Solver::Ip && one.plan.is_none() {
        one.stats.nodes = other.stats.nodes;
        one.stats.iterations = other.stats.iterations;
    }
    assert_eq!(one, *other);
}

/// A solver with random options that it takes.
fn random_options(dice: &mut Dice, judge: &Judge, wish: &Wish) -> Options {
    let solver = dice.pick(&Solver::ALL);
    let fixed = solver == Solver::Ip || dice.percent(50);
    let horizon = fixed.then(|| random::horizon(dice, &judge.table, 100));
    let mut options = Judge::options(solver, horizon, wish);
    options.encoding = dice.pick(&Encoding::ALL);
    options.pairs = solver == Solver::Exact && dice.percent(30);
    options
}

fn random_case(dice: &mut Dice) -> (Judge, Wish, Options) {
    let judge = Judge::new(random::table(dice, MEDIUM, &PAIR));
    let wish = random::wish(dice, &judge.table);
    let options = random_options(dice, &judge, &wish);
    let wish = heeded(options.solver, &wish);
    (judge, wish, options)
}

/// Of a run that was stopped, the pairs found until then: of the plan at least, and none but those
/// that the whole run finds.
fn check_pairs(options: &Options, outcome: &Outcome, whole: &Outcome) {
    assert_eq!(outcome.pairs.is_some(), options.pairs);
    let Some(points) = &outcome.pairs else { return };
    assert!(points.windows(2).all(|two| two[0].counts < two[1].counts));
    let all = whole.pairs.as_ref().unwrap();
    for point in points {
        assert!(all.iter().any(|known| known.counts == point.counts));
    }
    assert_eq!(outcome.plan.is_some(), !points.is_empty());
}

/// A run that was stopped has the best plan where it says so, and says so where all pairs were
/// wanted and none can be better.
fn check_status(options: &Options, outcome: &Outcome, whole: &Outcome) {
    match outcome.status {
        Status::Optimal => assert_eq!(outcome.goal_difference, whole.goal_difference),
        Status::Feasible => {
            assert!(outcome.plan.is_some());
            assert!(!options.pairs || outcome.goal_difference != Some(1.0));
        }
        Status::Limit => assert!(outcome.plan.is_none()),
        status => panic!("{status:?} with a limit"),
    }
}

#[test]
fn slices_of_any_size_give_the_same_outcome() {
    let mut dice = Dice::new(20);
    for _ in 0..1500 {
        let (judge, wish, options) = random_case(&mut dice);
        let whole = in_slices(&judge, &options, u64::MAX);
        judge.check(&options, &whole, &wish);
        for budget in [1, 2, 3, 7, 64] {
            assert_same(in_slices(&judge, &options, budget), &whole);
        }
    }
}

#[test]
fn a_cancelled_run_keeps_the_best_plan() {
    let mut dice = Dice::new(21);
    let mut seen = [0, 0, 0];
    for _ in 0..5000 {
        let (judge, wish, options) = random_case(&mut dice);
        let whole = in_slices(&judge, &options, u64::MAX);
        let mut run = Run::new(Arc::clone(&judge.problem), options.clone()).unwrap();
        let mut finished = false;
        for _ in 0..dice.below(8) {
            finished = run.advance(1).unwrap();
            if finished {
                break;
            }
        }
        let progress = run.progress();
        let outcome = run.outcome().unwrap();
        // Known before any work.
        finished |= contradictory(&judge.table, &wish);
        if finished {
            seen[0] += 1;
            assert_same(outcome.clone(), &whole);
        } else {
            check_pairs(&options, &outcome, &whole);
            // Left behind without its run, from what was last heard of it.
            let left = abandoned(&judge.problem, &options, Some(&progress)).unwrap();
            let status = if left.plan.is_some() { Status::Feasible } else { Status::Limit };
            assert_eq!((left.status, left.limit), (status, Some(LimitReached::Cancelled)));
            assert_eq!(left.plan, progress.plan);
            judge.check_plan(&options, &left, &wish);
            let ending = judge.check_plan(&options, &outcome, &wish);
            // A search that has a plan is done, whoever stops it.
            if outcome.status == Status::Solved {
                assert!(whole.status == Status::Solved && ending.is_some());
            } else {
                seen[if ending.is_some() { 1 } else { 2 }] += 1;
                check_status(&options, &outcome, &whole);
                assert_eq!(outcome.limit, Some(LimitReached::Cancelled));
                assert!(ending.is_none() || whole.status == Status::Optimal);
            }
            assert!(
                outcome.goal_difference <= whole.goal_difference || whole.status != Status::Optimal
            );
        }
        // The answer stays.
        assert!(run.advance(1).unwrap());
        assert_eq!(run.outcome().unwrap(), outcome);
    }
    assert!(seen.iter().all(|&count| count > 100), "{seen:?}");
}

#[test]
fn progress_holds_what_the_outcome_then_says() {
    let mut dice = Dice::new(22);
    let (mut bounded, mut gaps) = (0, 0);
    for _ in 0..1500 {
        let (judge, wish, options) = random_case(&mut dice);
        let whole = in_slices(&judge, &options, u64::MAX);
        let mut run = Run::new(Arc::clone(&judge.problem), options.clone()).unwrap();
        let mut done = 0;
        let mut finished = false;
        while !finished {
            finished = run.advance(1).unwrap();
            let progress = run.progress();
            assert_eq!(progress.solver, options.solver);
            assert!(progress.done >= done);
            done = progress.done;
            if let (Some(bound), Some(best)) = (progress.bound, whole.goal_difference) {
                assert!(bound >= best - 1e-9, "bound {bound}, best {best}");
                bounded += 1;
            }
            if let (Some(value), Some(best)) = (progress.goal_difference, whole.goal_difference)
                && whole.status == Status::Optimal
            {
                assert!(value <= best + 1e-9, "value {value}, best {best}");
            }
            if let Some(plan) = &progress.plan {
                let ending = judge.ending(plan);
                assert!(wish.allows(&judge.table, &ending));
                let most = judge.table.goals.len() as f64 - 1.0;
                let difference = oracle::difference(&judge.table, &ending) as f64 / most;
                assert!((progress.goal_difference.unwrap() - difference).abs() < 1e-9);
                let gap = progress.bound.map(|bound| bound - progress.goal_difference.unwrap());
                assert_eq!(progress.gap().is_some(), gap.is_some());
                // Not clamped: the bound is no less than the value.
                assert!(gap.is_none_or(|gap| gap >= -1e-9), "{gap:?}");
                assert!(progress.gap().zip(gap).is_none_or(|(a, b)| (a - b).abs() < 1e-9));
                gaps += usize::from(gap.is_some_and(|gap| gap > 1e-9));
            }
        }
        assert_same(run.outcome().unwrap(), &whole);
    }
    assert!(bounded > 500 && gaps > 20, "{bounded} {gaps}");
}

/// What a limited run may say: the same as without the limit, or that it was limited.
fn check_limited(
    judge: &Judge,
    options: &Options,
    wish: &Wish,
    whole: &Outcome,
    outcome: &Outcome,
) -> bool {
    let ending = judge.check_plan(options, outcome, wish);
    let Some(limit) = outcome.limit else {
        // Short of memory, a part of the portfolio may leave the work to another, which finds another plan.
        let short = options.limits.bytes < Limits::default().bytes;
        if short && options.solver == Solver::Satisficing {
            assert_eq!(outcome.status, whole.status);
            return false;
        }
        // Short of memory, exact search may leave the proof that there is no plan to other means.
        let mut same = outcome.clone();
        if whole.status == Status::Infeasible && options.solver == Solver::Exact {
            same.stats = whole.stats;
        }
        assert_eq!(&same, whole);
        return false;
    };
    assert_eq!(ending.is_some(), outcome.plan.is_some());
    check_status(options, outcome, whole);
    check_pairs(options, outcome, whole);
    assert_ne!(limit, LimitReached::Cancelled);
    true
}

#[test]
fn an_expansion_limit_stops_at_the_same_place_whatever_the_slices() {
    let mut dice = Dice::new(23);
    let mut limited = 0;
    for _ in 0..3000 {
        let (judge, wish, mut options) = random_case(&mut dice);
        let whole = in_slices(&judge, &options, u64::MAX);
        let limit = dice.below(12) as u64;
        options.limits.expansions = limit;
        let outcome = in_slices(&judge, &options, u64::MAX);
        let stopped = check_limited(&judge, &options, &wish, &whole, &outcome);
        limited += usize::from(stopped);
        assert_eq!(stopped, whole.stats.expansions > limit, "{limit} {whole:?} {outcome:?}");
        if stopped {
            assert_eq!(outcome.limit, Some(LimitReached::Expansions { limit }));
            assert_eq!(outcome.stats.expansions, limit);
        }
        for budget in [1, 3, 10] {
            assert_same(in_slices(&judge, &options, budget), &outcome);
        }
    }
    assert!(limited > 150, "{limited}");
}

#[test]
fn a_memory_limit_is_named() {
    let mut dice = Dice::new(24);
    let mut limited = 0;
    for _ in 0..2000 {
        let (judge, wish, mut options) = random_case(&mut dice);
        let whole = in_slices(&judge, &options, u64::MAX);
        options.limits.bytes = dice.pick(&[0, 1, 100, 300, 1000, 3000, 10_000]);
        let outcome = in_slices(&judge, &options, u64::MAX);
        if check_limited(&judge, &options, &wish, &whole, &outcome) {
            limited += 1;
            assert_eq!(outcome.limit, Some(LimitReached::Memory { limit_mib: 0 }));
        }
        for budget in [1, 3, 10] {
            assert_same(in_slices(&judge, &options, budget), &outcome);
        }
    }
    assert!(limited > 400, "{limited}");
}

#[test]
fn limits_of_the_integer_programs_are_named() {
    let mut dice = Dice::new(25);
    let (mut nodes, mut models) = (0, 0);
    for _ in 0..600 {
        let judge = Judge::new(random::table(&mut dice, MEDIUM, &PAIR));
        let wish = random::wish(&mut dice, &judge.table);
        let horizon = Some(random::horizon(&mut dice, &judge.table, 300));
        let mut options = Judge::options(Solver::Ip, horizon, &wish);
        options.encoding = dice.pick(&Encoding::ALL);
        let whole = in_slices(&judge, &options, u64::MAX);
        options.limits = Limits::default().with_nodes(dice.below(2) as u64);
        let outcome = in_slices(&judge, &options, u64::MAX);
        if check_limited(&judge, &options, &wish, &whole, &outcome) {
            nodes += 1;
            let limit = options.limits.nodes;
            assert_eq!(outcome.limit, Some(LimitReached::Nodes { limit }));
        }
        options.limits = Limits::default().with_nonzeros(dice.below(60) as u64);
        let outcome = in_slices(&judge, &options, u64::MAX);
        if check_limited(&judge, &options, &wish, &whole, &outcome) {
            models += 1;
            let limit = options.limits.nonzeros;
            assert_eq!(outcome.limit, Some(LimitReached::Model { limit }));
            assert_eq!((outcome.status, outcome.stats.nodes), (Status::Limit, 0));
        }
    }
    assert!(models > 100, "{models}");
    println!("{nodes} node limits, {models} model limits");
}

/// The first horizon of a series that has a plan, with its best difference.
fn first_feasible(
    judge: &Judge,
    wish: &Wish,
    horizons: impl Iterator<Item = usize>,
) -> Option<(usize, i64)> {
    for horizon in horizons {
        let endings = oracle::enumerate(&judge.table, horizon);
        if let Some(best) = oracle::best(&judge.table, &endings, wish) {
            return Some((horizon, best));
        }
    }
    None
}

const LONGEST: usize = 5;

#[test]
fn the_integer_program_raises_the_horizon_until_there_is_a_plan() {
    let mut dice = Dice::new(26);
    let (mut raised, mut limited) = (0, 0);
    for _ in 0..2000 {
        let judge = Judge::new(random::table(&mut dice, SMALL, &PAIR));
        let wish = random::wish(&mut dice, &judge.table);
        let mut options = Judge::options(Solver::Ip, None, &wish);
        options.horizon = Horizon::Auto;
        options.horizon_limit = LONGEST;
        let outcome = in_slices(&judge, &options, u64::MAX);
        let anything = first_feasible(&judge, &Wish::default(), 0..=LONGEST);
        let expected = first_feasible(&judge, &wish, 0..=LONGEST);
        match (expected, anything) {
            (Some((horizon, best)), Some((shortest, _))) => {
                let ending = judge.check(&options, &outcome, &wish).unwrap();
                assert_eq!(outcome.horizon, Some(horizon));
                assert_eq!(oracle::difference(&judge.table, &ending), best);
                raised += usize::from(horizon > shortest);
            }
            _ if contradictory(&judge.table, &wish) => {
                assert_eq!(outcome.status, Status::Infeasible);
            }
            // The true goal is out of reach: proved. (The longest shortest path has 3 steps.)
            (_, None) => assert_eq!(outcome.status, Status::Infeasible),
            // It is not, but no plan up to the last horizon keeps the bounds: nothing is proved of
            // longer ones.
            (None, Some(_)) => {
                limited += 1;
                assert_eq!(outcome.status, Status::Limit);
                assert_eq!(outcome.limit, Some(LimitReached::Horizon { limit: LONGEST as u64 }));
            }
        }
    }
    assert!(raised > 20 && limited > 100, "{raised} raised, {limited} limited");
}

#[test]
fn a_horizon_is_raised_by_steps() {
    let mut dice = Dice::new(27);
    let mut raised = 0;
    for _ in 0..2500 {
        let judge = Judge::new(random::table(&mut dice, SMALL, &PAIR));
        let wish = random::wish(&mut dice, &judge.table);
        let solver = dice.pick(&[
            Solver::Exact,
            Solver::Ip,
            Solver::Search,
            Solver::Satisficing,
            Solver::Baseline,
        ]);
        let wish = heeded(solver, &wish);
        let (from, step) = (dice.below(3), dice.between(1, 2));
        let mut options = Judge::options(solver, Some(from), &wish);
        options.encoding = dice.pick(&Encoding::ALL);
        options.horizon_step = step;
        options.horizon_limit = LONGEST;
        let outcome = in_slices(&judge, &options, u64::MAX);
        for budget in [1, 5] {
            assert_same(in_slices(&judge, &options, budget), &outcome);
        }
        match first_feasible(&judge, &wish, (from..=LONGEST).step_by(step)) {
            Some((horizon, best)) => {
                let ending = judge.check(&options, &outcome, &wish).unwrap();
                assert_eq!(outcome.horizon, Some(horizon));
                if solver != Solver::Ip {
                    // The work at all horizons counts.
                    let alone = |horizon| {
                        let options = Judge::options(solver, Some(horizon), &wish);
                        judge.solve(&options).stats.expansions
                    };
                    let expansions: u64 = (from..=horizon).step_by(step).map(alone).sum();
                    assert_eq!(outcome.stats.expansions, expansions);
                }
                if matches!(solver, Solver::Exact | Solver::Ip) {
                    assert_eq!(oracle::difference(&judge.table, &ending), best);
                }
                raised += usize::from(horizon > from);
            }
            None if contradictory(&judge.table, &wish) => {
                assert_eq!(outcome.status, Status::Infeasible);
            }
            None => {
                assert_eq!((outcome.status, &outcome.plan), (Status::Limit, &None));
                assert_eq!(outcome.limit, Some(LimitReached::Horizon { limit: LONGEST as u64 }));
            }
        }
    }
    assert!(raised > 100, "{raised}");
}

/// The actor has more states than distances are worked out for.
#[test]
fn pairs_of_a_large_task_can_be_stopped_before_any_is_found() {
    let problem = Domain::Logistics.draw(3).unwrap().document.problem().unwrap();
    let mut options = Options::new(Solver::Exact);
    options.pairs = true;
    options.limits.expansions = 50;
    let outcome = solve(&Arc::new(problem), &options);
    assert_eq!(outcome.status, Status::Limit);
    assert!(outcome.pairs.unwrap().is_empty());
}
