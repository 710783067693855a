//! Why there is no plan and what would do, against brute force.

use std::collections::{BTreeSet, HashSet};
use std::sync::Arc;

use mo_copp::domain::gridworld::GridworldShape;
use mo_copp::solver::remedy::{Advice, Change, Reason, RemedyRun};
use mo_copp::solver::{Horizon, Options, Solver, Status};

use crate::common::check::solve;
use crate::common::oracle::Ending;
use crate::common::random::{self, MEDIUM, PAIR};
use crate::common::{Dice, Judge, Wish, oracle};
use crate::observers::COMPANIES;
use crate::search::heeded;

/// Far longer than anything that the small problems here need: lengths after which all layers
/// have been there before.
const LONGEST: usize = 150;

/// The endings of the plans of every length up to the longest.
fn endings(judge: &Judge) -> Vec<BTreeSet<Ending>> {
    let table = &judge.table;
    let start = (table.start, table.watchers.iter().map(|w| w.belief).collect::<Vec<_>>());
    let mut layer = HashSet::from([start]);
    let mut all = Vec::new();
    for _ in 0..=LONGEST {
        let ends = layer.iter().filter(|(state, _)| table.is_goal(*state));
        all.push(ends.map(|(_, beliefs)| oracle::ending(table, beliefs)).collect());
        let mut next = HashSet::new();
        for situation in &layer {
            for action in 0..table.actions.len() {
                next.extend(oracle::step(table, situation, action).map(|(_, after)| after));
            }
        }
        layer = next;
    }
    all
}

/// What should be advised: the reason, and (change, value, best numerator).
type Expected = (Option<Reason>, Vec<(Change, usize, i64)>);

fn expected(
    judge: &Judge,
    all: &[BTreeSet<Ending>],
    asked: Option<usize>,
    wish: &Wish,
) -> Expected {
    let table = &judge.table;
    let anywhere: BTreeSet<Ending> = all.iter().flatten().cloned().collect();
    let here = asked.map_or(&anywhere, |horizon| &all[horizon]);
    if oracle::best(table, here, wish).is_some() {
        return (None, Vec::new());
    }
    if anywhere.is_empty() {
        return (Some(Reason::Unreachable), Vec::new());
    }
    let mut remedies = Vec::new();
    let mut offer = |change, value, wish: &Wish, endings: &BTreeSet<Ending>| {
        let best = oracle::best(table, endings, wish);
        remedies.extend(best.map(|best| (change, value, best)));
        best.is_some()
    };
    let goals = table.goals.len();
    if let Some(k) = wish.k {
        let _ = (1..k).rev().any(|value| {
            offer(Change::AtLeast, value, &Wish { k: Some(value), ..wish.clone() }, here)
        });
    }
    if let Some(j) = wish.j {
        let _ = (j + 1..=goals).any(|value| {
            offer(Change::AtMost, value, &Wish { j: Some(value), ..wish.clone() }, here)
        });
    }
    if let Some(asked) = asked {
        let _ = (0..asked).rev().any(|t| offer(Change::Horizon, t, wish, &all[t]));
        let _ = (asked + 1..=LONGEST).any(|t| offer(Change::Horizon, t, wish, &all[t]));
    }
    let by = |&(change, value, _): &(Change, usize, i64)| {
        let from = match change {
            Change::Horizon => asked,
            Change::AtLeast => wish.k,
            Change::AtMost => wish.j,
            other => panic!("{other:?}"),
        };
        (from.unwrap().abs_diff(value), change, std::cmp::Reverse(value))
    };
    remedies.sort_by_key(by);
    let reason = if here.is_empty() { Reason::Length } else { Reason::Bounds };
    (Some(reason), remedies)
}

fn advise(judge: &Judge, options: &Options, budget: u64) -> Advice {
    let mut run = RemedyRun::new(Arc::clone(&judge.problem), options.clone()).unwrap();
    for _ in 0..1_000_000 {
        if run.advance(budget).unwrap() {
            return run.outcome().unwrap();
        }
    }
    panic!("no end");
}

/// Each remedy does what it says when it is tried, as a wish and as options.
fn check_remedies(judge: &Judge, options: &Options, wish: &Wish, advice: &Advice) {
    for remedy in &advice.remedies {
        let (mut options, mut wish) = (options.clone(), wish.clone());
        match remedy.change {
            Change::Horizon => options.horizon = Horizon::Steps(remedy.value),
            Change::AtLeast => wish.k = Some(remedy.value),
            Change::AtMost => wish.j = Some(remedy.value),
            other => panic!("{other:?}"),
        }
        options.solver = Solver::Exact;
        options.bounds = wish.bounds();
        let outcome = judge.solve(&options);
        assert_eq!(outcome.status, Status::Optimal);
        if advice.complete {
            assert_eq!(outcome.goal_difference, Some(remedy.goal_difference));
        }
        assert!(wish.allows(&judge.table, &judge.ending(&remedy.plan)));
        assert!(outcome.goal_difference >= Some(remedy.goal_difference));
        if let Horizon::Steps(steps) = options.horizon {
            assert_eq!(remedy.plan.len(), steps);
        }
    }
}

#[test]
fn every_remedy_will_do_and_nothing_nearer() {
    let mut dice = Dice::new(70);
    let mut seen = [0; 7];
    for _ in 0..4000 {
        let roles = if dice.percent(20) { dice.pick(&COMPANIES) } else { &PAIR };
        let judge = Judge::built(random::table(&mut dice, MEDIUM, roles), 0);
        let wish = random::wish(&mut dice, &judge.table);
        let far = dice.percent(15);
        let asked = dice.percent(70).then(|| dice.below(if far { 40 } else { 9 }));
        let solver = dice.pick(&[
            Solver::Exact,
            Solver::Search,
            Solver::Satisficing,
            Solver::Obfuscate,
            Solver::Legible,
        ]);
        let options = Judge::options(solver, asked, &wish);
        let heeded = heeded(solver, &wish);
        let (reason, remedies) = expected(&judge, &endings(&judge), asked, &heeded);
        let advice = advise(&judge, &options, u64::MAX);
        assert_eq!(advice.reason, reason, "{asked:?} {wish:?}");
        assert!(advice.complete);
        let most = judge.table.goals.len() as f64 - 1.0;
        let found: Vec<_> = advice
            .remedies
            .iter()
            .map(|r| (r.change, r.value, (r.goal_difference * most).round() as i64))
            .collect();
        assert_eq!(found, remedies, "{asked:?} {wish:?}");
        check_remedies(&judge, &options, &heeded, &advice);
        let shortest = judge.endings().values().copied().min();
        assert_eq!(advice.shortest, shortest);
        for budget in [1, 10] {
            assert_eq!(advise(&judge, &options, budget), advice);
        }
        if reason.is_some() {
            let problem = Arc::clone(&judge.problem);
            let mut run = RemedyRun::after_proof(problem, options.clone()).unwrap();
            while !run.advance(7).unwrap() {}
            assert_eq!(run.outcome().unwrap(), advice);
        }
        let reasons = [None, Some(Reason::Unreachable), Some(Reason::Length), Some(Reason::Bounds)];
        seen[reasons.iter().position(|r| *r == reason).unwrap()] += 1;
        for remedy in &advice.remedies {
            seen[4 + remedy.change as usize] += 1;
        }
    }
    assert!(seen.iter().all(|&count| count > 100), "{seen:?}");
}

#[test]
fn a_limited_or_stopped_search_says_that_there_may_be_more() {
    let mut dice = Dice::new(71);
    let (mut limited, mut stopped) = (0, 0);
    for _ in 0..2000 {
        let judge = Judge::new(random::table(&mut dice, MEDIUM, &PAIR));
        let wish = random::wish(&mut dice, &judge.table);
        let asked = dice.percent(80).then(|| dice.below(9));
        let mut options = Judge::options(Solver::Exact, asked, &wish);
        let whole = advise(&judge, &options, u64::MAX);
        let check = |advice: &Advice, options: &Options| {
            if advice.complete {
                assert_eq!(*advice, whole);
            } else {
                assert!(advice.reason.is_none() || advice.reason == whole.reason);
                assert!(advice.shortest.is_none() || advice.shortest == whole.shortest);
                check_remedies(&judge, options, &wish, advice);
            }
        };
        let mut run = RemedyRun::new(Arc::clone(&judge.problem), options.clone()).unwrap();
        for _ in 0..dice.below(16) {
            run.advance(2).unwrap();
        }
        let advice = run.outcome().unwrap();
        check(&advice, &options);
        assert_eq!(run.outcome().unwrap(), advice);
        stopped += usize::from(!advice.complete);
        let unlimited = options.clone();
        options.limits.expansions = dice.below(20) as u64;
        let advice = advise(&judge, &options, u64::MAX);
        check(&advice, &unlimited);
        limited += usize::from(!advice.complete);
        assert_eq!(advise(&judge, &options, 1), advice);
        options.limits = unlimited.limits;
        options.limits.bytes = dice.pick(&[0, 300, 1000, 3000]);
        let advice = advise(&judge, &options, u64::MAX);
        check(&advice, &unlimited);
        assert_eq!(advise(&judge, &options, 1), advice);
    }
    assert!(limited > 200 && stopped > 200, "{limited} {stopped}");
}

/// Parity: without staying, no plan of the paper's grid is longer by an odd number of actions.
#[test]
fn on_the_paper_s_grid() {
    let problem =
        Arc::new(GridworldShape::default().generate(3).unwrap().document.problem().unwrap());
    let mut options = Options::new(Solver::Exact);
    let shortest = solve(&problem, &Options::new(Solver::Baseline)).plan.unwrap().len();
    options.horizon = Horizon::Steps(shortest + 1);
    let mut run = RemedyRun::new(Arc::clone(&problem), options.clone()).unwrap();
    while !run.advance(64).unwrap() {}
    let advice = run.outcome().unwrap();
    let remedies: Vec<_> = advice.remedies.iter().map(|r| (r.change, r.value)).collect();
    assert_eq!(advice.reason, Some(Reason::Length));
    assert_eq!(remedies, [(Change::Horizon, shortest + 2), (Change::Horizon, shortest)]);
    assert!(advice.complete);
}

#[test]
fn lengths_have_no_remedy() {
    let problem = Arc::new(mo_copp::domain::Delivery::figure_1().problem().unwrap());
    let mut options = Options::new(Solver::Exact);
    options.lengths = Some(2);
    assert_eq!(
        RemedyRun::new(problem, options).unwrap_err().to_string(),
        "lengths: found 2, expected nothing, since remedies are for one horizon or for all"
    );
}
