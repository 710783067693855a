//! Cost limits: every solver against the enumeration of all plans that cost no more, with costs of 0
//! among them, and without costs against plans of at most N actions.

use std::collections::{BTreeMap, BTreeSet, HashSet};

use mo_copp::problem::Role;
use mo_copp::solver::remedy::RemedyRun;
use mo_copp::solver::{Encoding, Options, Outcome, Run, Solver, Status};
use mo_copp::trace::{InvalidPlan, check_cost};

use crate::common::oracle::{Ending, difference, ending, step};
use crate::common::random::{self, MEDIUM, PAIR, SMALL, Size};
use crate::common::table::{Set, Table};
use crate::common::{Dice, Judge, Wish, oracle};
use crate::observers::COMPANIES;
use crate::search::{SOLVERS, heeded};

/// A problem with a cost for each action of the table, or none, and the limit.
struct Priced {
    judge: Judge,
    costs: Option<Vec<u64>>,
    limit: u64,
}

type Situation = (usize, Vec<Set>);

impl Priced {
    fn random(dice: &mut Dice, size: Size, roles: &[Role]) -> Self {
        let table = random::table(dice, size, roles);
        let costs = dice.percent(80).then(|| {
            let most = dice.pick(&[1, 3, 9]);
            table.actions.iter().map(|_| dice.below(most + 1) as u64).collect::<Vec<u64>>()
        });
        let problem = table.built_with_costs(0, costs.as_deref());
        let most = dice.pick(&[4, 8, 14]);
        let limit = dice.below(most) as u64;
        Self { judge: Judge::of(table, problem), costs, limit }
    }

    fn cost(&self, action: usize) -> u64 {
        self.costs.as_ref().map_or(1, |costs| costs[action])
    }

    fn first(table: &Table) -> Situation {
        (table.start, table.watchers.iter().map(|watcher| watcher.belief).collect())
    }

    /// Every ending of plans within the limit, with the length of a shortest one: breadth first over
    /// situations with what they have cost, nothing left out.
    fn close(&self) -> BTreeMap<Ending, usize> {
        let table = &self.judge.table;
        let mut layer = vec![(Self::first(table), 0)];
        let mut known: HashSet<(Situation, u64)> = layer.iter().cloned().collect();
        let (mut endings, mut length) = (BTreeMap::new(), 0);
        while !layer.is_empty() {
            let mut next = Vec::new();
            for (situation, cost) in &layer {
                if table.is_goal(situation.0) {
                    endings.entry(ending(table, &situation.1)).or_insert(length);
                }
                for action in 0..table.actions.len() {
                    let sum = cost + self.cost(action);
                    let Some((_, after)) = step(table, situation, action) else { continue };
                    if sum <= self.limit && known.insert((after.clone(), sum)) {
                        next.push((after, sum));
                    }
                }
            }
            (layer, length) = (next, length + 1);
        }
        endings
    }

    /// Every plan of exactly `length` actions within the limit, one by one.
    fn enumerate(&self, horizon: usize) -> BTreeSet<Ending> {
        let mut found = BTreeSet::new();
        self.descend(&Self::first(&self.judge.table), horizon, self.limit, &mut found);
        found
    }

    fn descend(&self, at: &Situation, left: usize, money: u64, found: &mut BTreeSet<Ending>) {
        let table = &self.judge.table;
        if left == 0 {
            if table.is_goal(at.0) {
                found.insert(ending(table, &at.1));
            }
            return;
        }
        for action in 0..table.actions.len() {
            if let (Some((_, next)), Some(money)) =
                (step(table, at, action), money.checked_sub(self.cost(action)))
            {
                self.descend(&next, left - 1, money, found);
            }
        }
    }

    fn solve(&self, options: &Options) -> Outcome {
        let outcome = self.judge.solve(options);
        assert_eq!(outcome.cost_limit, Some(self.limit));
        if let Some(plan) = &outcome.plan {
            let cost: u64 = self.judge.positions(plan).iter().map(|&a| self.cost(a)).sum();
            assert!(cost <= self.limit, "{cost} of {}", self.limit);
            check_cost(&self.judge.problem, plan, Some(cost)).unwrap();
            if let Some(less) = cost.checked_sub(1) {
                let expected = InvalidPlan::TooExpensive { cost: u128::from(cost), limit: less };
                assert_eq!(check_cost(&self.judge.problem, plan, Some(less)), Err(expected));
            }
        }
        outcome
    }

    fn options(&self, solver: Solver, horizon: Option<usize>, wish: &Wish) -> Options {
        Judge::options(solver, horizon, wish).with_cost_limit(self.limit)
    }
}

/// How many problems had a plan, and how many had one without the limit alone.
#[derive(Default)]
struct Tally {
    plans: usize,
    lost: usize,
}

fn best<'a>(
    priced: &Priced,
    endings: impl IntoIterator<Item = &'a Ending>,
    wish: &Wish,
) -> Option<i64> {
    oracle::best(&priced.judge.table, endings, wish)
}

#[test]
fn over_all_lengths_the_exact_solver_finds_the_best_and_a_shortest_one() {
    let mut dice = Dice::new(701);
    let mut tally = Tally::default();
    for number in 0..6000 {
        let roles = if number % 4 == 0 { COMPANIES[number / 4 % COMPANIES.len()] } else { &PAIR };
        let priced = Priced::random(&mut dice, MEDIUM, roles);
        let (judge, table) = (&priced.judge, &priced.judge.table);
        let wish = random::wish(&mut dice, table);
        let endings = priced.close();
        let expected = best(&priced, endings.keys(), &wish);
        let options = priced.options(Solver::Exact, None, &wish);
        let outcome = priced.solve(&options);
        let found = judge.check(&options, &outcome, &wish);
        assert_eq!(found.map(|ending| difference(table, &ending)), expected);
        if let (Some(plan), Some(value)) = (&outcome.plan, expected) {
            let worth = |(ending, _): &(&Ending, &usize)| {
                wish.allows(table, ending) && difference(table, ending) == value
            };
            let shortest = endings.iter().filter(worth).map(|(_, length)| *length).min();
            assert_eq!((Some(plan.len()), outcome.length_proved), (shortest, Some(true)));
            tally.plans += 1;
        } else if best(&priced, judge.endings().keys(), &wish).is_some() {
            tally.lost += 1;
        }
        // Every reachable pair.
        let outcome = priced.solve(&options.clone().with_pairs(true));
        let pairs: BTreeSet<(usize, usize)> = outcome
            .pairs
            .unwrap()
            .iter()
            .map(|pair| {
                let ending = judge.ending(&pair.plan);
                assert_eq!(
                    table.counts(&ending),
                    (pair.counts.adversarial, pair.counts.cooperative)
                );
                check_cost(&judge.problem, &pair.plan, Some(priced.limit)).unwrap();
                table.counts(&ending)
            })
            .collect();
        let allowed = endings.keys().filter(|ending| wish.allows(table, ending));
        assert_eq!(pairs, allowed.map(|ending| table.counts(ending)).collect());
    }
    assert!(tally.plans > 1500 && tally.lost > 300, "{} {}", tally.plans, tally.lost);
}

#[test]
fn at_a_horizon_and_of_each_length_the_best_is_that_of_the_enumeration() {
    let mut dice = Dice::new(702);
    let mut tally = Tally::default();
    for _ in 0..5000 {
        let priced = Priced::random(&mut dice, MEDIUM, &PAIR);
        let (judge, table) = (&priced.judge, &priced.judge.table);
        let wish = random::wish(&mut dice, table);
        let horizon = random::horizon(&mut dice, table, 300);
        let expected = best(&priced, &priced.enumerate(horizon), &wish);
        let options = priced.options(Solver::Exact, Some(horizon), &wish);
        let outcome = priced.solve(&options);
        let found = judge.check(&options, &outcome, &wish);
        assert_eq!(found.map(|ending| difference(table, &ending)), expected);
        let free = oracle::enumerate(table, horizon);
        tally.plans += usize::from(expected.is_some());
        tally.lost += usize::from(expected.is_none() && best(&priced, &free, &wish).is_some());
        let options = priced.options(Solver::Exact, None, &wish).with_lengths(horizon);
        let outcome = priced.solve(&options);
        let points = outcome.lengths.unwrap();
        assert_eq!(points.len(), horizon + 1);
        for point in points {
            let expected = best(&priced, &priced.enumerate(point.length), &wish);
            assert_eq!(point.best.as_ref().map(|best| best.counts.difference()), expected);
            if let Some(best) = point.best {
                assert_eq!(best.plan.len(), point.length);
                check_cost(&judge.problem, &best.plan, Some(priced.limit)).unwrap();
            }
        }
    }
    assert!(tally.plans > 600 && tally.lost > 100, "{} {}", tally.plans, tally.lost);
}

/// What a solver finds within a cost limit, and that it is proved where there is nothing.
#[test]
fn searches_find_a_plan_exactly_when_there_is_one() {
    let mut dice = Dice::new(703);
    let mut tally = Tally::default();
    for _ in 0..5000 {
        let priced = Priced::random(&mut dice, MEDIUM, &PAIR);
        let (judge, table) = (&priced.judge, &priced.judge.table);
        let wish = random::wish(&mut dice, table);
        let horizon = dice.percent(40).then(|| random::horizon(&mut dice, table, 200));
        let endings: BTreeSet<Ending> = match horizon {
            None => priced.close().into_keys().collect(),
            Some(steps) => priced.enumerate(steps),
        };
        for solver in SOLVERS {
            let heeded = heeded(solver, &wish);
            let possible = endings.iter().any(|ending| heeded.allows(table, ending));
            let options = priced.options(solver, horizon, &wish);
            let outcome = priced.solve(&options);
            judge.check(&options, &outcome, &heeded);
            let status = if possible { Status::Solved } else { Status::Infeasible };
            assert_eq!(outcome.status, status, "{} {horizon:?} {wish:?}", solver.name());
            tally.plans += usize::from(possible);
            tally.lost += usize::from(!possible);
        }
    }
    assert!(tally.plans > 3000 && tally.lost > 3000, "{} {}", tally.plans, tally.lost);
}

#[test]
fn both_integer_programs_keep_the_limit() {
    let mut dice = Dice::new(704);
    let mut tally = Tally::default();
    for number in 0..400 {
        let priced = Priced::random(&mut dice, SMALL, &PAIR);
        let (judge, table) = (&priced.judge, &priced.judge.table);
        let wish = random::wish(&mut dice, table);
        let horizon = random::horizon(&mut dice, table, 30);
        let expected = best(&priced, &priced.enumerate(horizon), &wish);
        let encoding = Encoding::ALL[number % 2];
        let options = priced.options(Solver::Ip, Some(horizon), &wish).with_encoding(encoding);
        let outcome = priced.solve(&options);
        let found = judge.check(&options, &outcome, &wish);
        assert_eq!(found.map(|ending| difference(table, &ending)), expected, "{encoding:?}");
        tally.plans += usize::from(expected.is_some());
        let free = oracle::enumerate(table, horizon);
        tally.lost += usize::from(expected.is_none() && best(&priced, &free, &wish).is_some());
    }
    assert!(tally.plans > 50 && tally.lost > 10, "{} {}", tally.plans, tally.lost);
}

/// The same answer in slices of any size, and what is asked for of a run that is stopped.
#[test]
fn slices_change_no_answer() {
    let mut dice = Dice::new(705);
    for _ in 0..300 {
        let priced = Priced::random(&mut dice, MEDIUM, &PAIR);
        let wish = random::wish(&mut dice, &priced.judge.table);
        for solver in [Solver::Exact, Solver::Satisficing, Solver::Search, Solver::Baseline] {
            let options = priced.options(solver, None, &wish);
            let whole = priced.solve(&options);
            let mut run = Run::new(priced.judge.problem.clone(), options.clone()).unwrap();
            while !run.advance(1).unwrap() {}
            assert_eq!(run.outcome().unwrap(), whole);
            let mut stopped = Run::new(priced.judge.problem.clone(), options.clone()).unwrap();
            stopped.advance(2).unwrap();
            priced.judge.check_plan(&options, &stopped.outcome().unwrap(), &heeded(solver, &wish));
        }
    }
}

#[test]
fn costs_of_any_size_are_counted_right() {
    let mut dice = Dice::new(706);
    let mut beyond = 0;
    for number in 0..300 {
        let table = random::table(&mut dice, SMALL, &PAIR);
        let large = |dice: &mut Dice| dice.pick(&[0, 1, u64::MAX / 2, u64::MAX - 1, u64::MAX]);
        let costs: Vec<u64> = table.actions.iter().map(|_| large(&mut dice)).collect();
        let problem = table.built_with_costs(0, Some(&costs));
        let priced = Priced { judge: Judge::of(table, problem), costs: Some(costs), limit: 1 };
        for solver in [Solver::Exact, Solver::Satisficing, Solver::Search, Solver::Baseline] {
            for limit in [0, 1, u64::MAX / 2 + 1, u64::MAX] {
                let options = Judge::options(solver, None, &Wish::default()).with_cost_limit(limit);
                let outcome = priced.judge.solve(&options);
                let plan = outcome.plan.as_ref();
                beyond += usize::from(plan.is_none() && !priced.judge.endings().is_empty());
                let cost = |plan| {
                    let taken: Vec<usize> = priced.judge.positions(plan);
                    taken.iter().map(|&action| u128::from(priced.cost(action))).sum::<u128>()
                };
                assert!(plan.is_none_or(|plan| cost(plan) <= u128::from(limit)));
            }
        }
        // The integer program, which takes longer, either agrees with exact search or says that it cannot
        // tell.
        if number % 10 != 0 {
            continue;
        }
        for (limit, encoding) in [1, u64::MAX / 2 + 1].into_iter().zip(Encoding::ALL) {
            let at = |solver| {
                let options = Judge::options(solver, Some(2), &Wish::default());
                priced.judge.solve(&options.with_encoding(encoding).with_cost_limit(limit))
            };
            let (exact, ip) = (at(Solver::Exact), at(Solver::Ip));
            assert!(ip.limit.is_some() || ip.goal_difference == exact.goal_difference);
        }
    }
    assert!(beyond > 100, "{beyond}");
}

/// What would do is not looked for: the options say so.
#[test]
fn remedies_are_not_searched_under_a_cost_limit() {
    let mut dice = Dice::new(707);
    let judge = Judge::new(random::table(&mut dice, SMALL, &PAIR));
    let options = Judge::options(Solver::Exact, None, &Wish::default()).with_cost_limit(3);
    let error = RemedyRun::new(judge.problem.clone(), options).unwrap_err().to_string();
    assert!(error.starts_with("cost limit: found 3, expected nothing"), "{error}");
}
