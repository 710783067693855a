//! Small problems end within the nodes of Algorithm 1, so here it has few or none of them.

use super::*;
use crate::problem::Role;
use crate::solver::Solver;
use crate::solver::common::random::{self, MEDIUM, PAIR};
use crate::solver::common::{Dice, Judge, Wish, oracle};
use crate::trace::validate;

/// Runs a portfolio to its end, `budget` at a time: its plan, and whether the optimiser had a turn.
fn run(
    judge: &Judge,
    nodes: u64,
    horizon: Option<usize>,
    wish: &Wish,
    budget: u64,
) -> (Option<Plan>, bool) {
    let options = Judge::options(Solver::Satisficing, horizon, wish);
    let problem = Arc::clone(&judge.problem);
    let mut portfolio = Portfolio::with_greedy_nodes(nodes, problem, &options, horizon);
    let mut exact = false;
    for _ in 0..100_000 {
        exact |= matches!(portfolio.stage, Stage::Optimiser(..));
        match portfolio.advance(budget).unwrap() {
            Advance::Working => {}
            Advance::Finished(Finding { status, plan, .. }) => {
                let found = if plan.is_some() { Status::Solved } else { Status::Infeasible };
                assert_eq!(status, found);
                return (plan, exact);
            }
        }
    }
    panic!("no end");
}

/// Whether the optimiser had a turn; the answer is that of plain enumeration.
fn agrees(dice: &mut Dice, judge: &Judge, horizon: Option<usize>, wish: &Wish) -> bool {
    let possible = match horizon {
        None => judge.endings().keys().any(|ending| wish.allows(&judge.table, ending)),
        Some(steps) => {
            let endings = oracle::enumerate(&judge.table, steps);
            endings.iter().any(|ending| wish.allows(&judge.table, ending))
        }
    };
    let nodes = dice.pick(&[0, 1, 3, 10]);
    let (plan, exact) = run(judge, nodes, horizon, wish, 1);
    assert_eq!(plan.is_some(), possible, "{nodes} {horizon:?} {wish:?}");
    if let Some(plan) = &plan {
        assert!(wish.allows(&judge.table, &judge.ending(plan)));
        assert!(horizon.is_none_or(|horizon| horizon == plan.len()));
    }
    for budget in [2, 7, u64::MAX] {
        assert_eq!(run(judge, nodes, horizon, wish, budget), (plan.clone(), exact));
    }
    exact
}

#[test]
fn over_all_lengths_a_plan_is_found_exactly_when_there_is_one() {
    let mut dice = Dice::new(80);
    let mut exact = 0;
    for round in 0..4_000 {
        let third = [Role::Adversarial, Role::Cooperative, Role::Cooperative];
        let roles = if round % 8 == 0 { &third[..] } else { &PAIR[..] };
        let judge = Judge::built(random::table(&mut dice, MEDIUM, roles), 0);
        let wish = random::wish(&mut dice, &judge.table);
        exact += usize::from(agrees(&mut dice, &judge, None, &wish));
    }
    assert!(exact > 1_000, "{exact}");
}

#[test]
fn at_a_horizon_a_plan_is_found_exactly_when_there_is_one() {
    let mut dice = Dice::new(81);
    let mut exact = 0;
    for _ in 0..4_000 {
        let judge = Judge::built(random::table(&mut dice, MEDIUM, &PAIR), 0);
        let wish = random::wish(&mut dice, &judge.table);
        let horizon = random::horizon(&mut dice, &judge.table, 300);
        exact += usize::from(agrees(&mut dice, &judge, Some(horizon), &wish));
    }
    assert!(exact > 1_000, "{exact}");
}

#[test]
fn after_a_limit_of_the_optimiser_algorithm_1_goes_on() {
    let mut dice = Dice::new(82);
    let mut alone = 0;
    for _ in 0..300 {
        let judge = Judge::built(random::table(&mut dice, MEDIUM, &PAIR), 0);
        let wish = random::wish(&mut dice, &judge.table);
        let options = Judge::options(Solver::Satisficing, None, &wish);
        let problem = Arc::clone(&judge.problem);
        let mut portfolio = Portfolio::with_greedy_nodes(0, problem, &options, None);
        portfolio.options.limits.expansions = 1;
        let finding = loop {
            if let Advance::Finished(finding) = portfolio.advance(1).unwrap() {
                break finding;
            }
        };
        alone += usize::from(matches!(portfolio.stage, Stage::GreedyAlone(_)));
        let possible = judge.endings().keys().any(|ending| wish.allows(&judge.table, ending));
        assert_eq!(finding.plan.is_some(), possible);
    }
    assert!(alone > 50, "{alone}");
}

/// Of a run with so little memory that every part of the portfolio meets a limit: the limit, and whether Algorithm 1 went on.
fn limited(judge: &Judge, options: &Options, nodes: u64) -> Option<(LimitReached, bool)> {
    let problem = Arc::clone(&judge.problem);
    let mut portfolio = Portfolio::with_greedy_nodes(nodes, problem, options, None);
    loop {
        match portfolio.advance(1) {
            Ok(Advance::Working) => {}
            Ok(Advance::Finished(_)) => return None,
            Err(limit) => return Some((limit, matches!(portfolio.stage, Stage::GreedyAlone(_)))),
        }
    }
}

/// `mib` MiB are named, whatever share the parts of the portfolio had.
#[test]
fn the_limit_said_is_the_one_given() {
    let document = crate::domain::generate::Domain::Logistics.draw(1).unwrap().document;
    let problem = Arc::new(document.problem().unwrap());
    for (mib, nodes) in [(3, u64::MAX), (3, 10), (2, 0)] {
        let mut options = Options::new(Solver::Satisficing);
        (options.bounds.at_least, options.bounds.at_most) = (Some(5), Some(1));
        options.limits = options.limits.with_bytes(mib << 20);
        let mut portfolio =
            Portfolio::with_greedy_nodes(nodes, Arc::clone(&problem), &options, None);
        let limit = loop {
            if let Err(limit) = portfolio.advance(1) {
                break limit;
            }
        };
        assert_eq!(limit, LimitReached::Memory { limit_mib: mib });
        assert!(matches!(portfolio.stage, Stage::GreedyAlone(_)));
    }
}

/// What a single part could do with all of the memory is done.
#[test]
fn algorithm_1_has_all_of_the_memory_that_the_optimiser_gave_back() {
    let mut dice = Dice::new(86);
    let (mut alone, mut stopped) = (0, 0);
    for _ in 0..1_500 {
        let judge = Judge::built(random::table(&mut dice, MEDIUM, &PAIR), 0);
        let wish = random::wish(&mut dice, &judge.table);
        let mut options = Judge::options(Solver::Satisficing, None, &wish);
        options.limits.bytes = dice.pick(&[100, 1_000, 2_000, 4_000, 8_000]);
        let mut greedy = algorithm1::engine(Arc::clone(&judge.problem), &options, None, false);
        let enough = loop {
            match greedy.advance(1) {
                Ok(Advance::Working) => {}
                answer => break answer.is_ok(),
            }
        };
        match limited(&judge, &options, dice.pick(&[0, 3, u64::MAX])) {
            Some((limit, last)) => {
                assert!(!enough && last, "{limit}");
                stopped += 1;
            }
            None => alone += usize::from(enough),
        }
    }
    assert!(alone > 100 && stopped > 100, "{alone} {stopped}");
}

/// Runs exact search with a first plan from elsewhere to its end: the finding, or what it is stopped with at a limit.
fn best(mut engine: BestPlan, budget: u64) -> (Finding, bool) {
    let mut learned = false;
    for _ in 0..1_000_000 {
        let before = engine.has_plan();
        match engine.advance(budget) {
            Ok(Advance::Working) => {
                learned |= !before && engine.has_plan() && engine.stats().belief_size > 0;
            }
            Ok(Advance::Finished(finding)) => return (finding, learned),
            Err(limit) => return (engine.stop(limit), learned),
        }
    }
    panic!("no end");
}

#[test]
fn a_first_plan_from_elsewhere_changes_no_best_value() {
    let mut dice = Dice::new(83);
    let mut learned = 0;
    for round in 0..4_000 {
        let third = [Role::Adversarial, Role::Cooperative, Role::Adversarial];
        let roles = if round % 8 == 0 { &third[..] } else { &PAIR[..] };
        let judge = Judge::built(random::table(&mut dice, MEDIUM, roles), 0);
        let wish = random::wish(&mut dice, &judge.table);
        let options = Judge::options(Solver::Exact, None, &wish);
        let nodes = dice.pick(&[0, 1, 10]);
        let engine = || BestPlan::with(0, nodes, Arc::clone(&judge.problem), &options);
        let (finding, first) = best(engine(), 1);
        learned += usize::from(first);
        let most = oracle::best(&judge.table, judge.endings().keys(), &wish);
        let plan = finding.plan.as_ref();
        let worth = plan.map(|plan| {
            assert!(wish.allows(&judge.table, &judge.ending(plan)));
            let achieved = validate(&judge.problem, plan).unwrap();
            achieved.counts.difference()
        });
        assert_eq!(worth, most);
        let proved = if most.is_some() { Status::Optimal } else { Status::Infeasible };
        assert_eq!(finding.status, proved);
        assert_eq!(best(engine(), 50).0.plan, finding.plan, "slices change nothing");
    }
    assert!(learned > 100, "{learned}");
}

#[test]
fn waiting_means_give_way_where_the_optimiser_needs_their_memory() {
    let mut dice = Dice::new(85);
    let mut gave_way = 0;
    for _ in 0..3_000 {
        let judge = Judge::built(random::table(&mut dice, MEDIUM, &PAIR), 0);
        let wish = random::wish(&mut dice, &judge.table);
        let mut options = Judge::options(Solver::Exact, None, &wish);
        let alone = |options: &Options| {
            let mut engine = Optimiser::new(Arc::clone(&judge.problem), options, None);
            while matches!(engine.advance(1), Ok(Advance::Working)) {}
            (engine.advance(1).is_ok(), engine.bytes())
        };
        // A little more than the optimiser needs, which is more than its share.
        options.limits.bytes = alone(&options).1 * 3 / 2;
        if !alone(&options).0 {
            continue;
        }
        let first = FirstPlan::new(0, Arc::clone(&judge.problem), &options, None);
        let mut engine = BestPlan::after(Box::new(first), Arc::clone(&judge.problem), &options);
        let finding = loop {
            match engine.advance(1).unwrap() {
                Advance::Working => {}
                Advance::Finished(finding) => break finding,
            }
        };
        assert_ne!(finding.status, Status::Feasible);
        gave_way += usize::from(engine.gave_way());
    }
    assert!(gave_way > 20, "{gave_way}");
}

#[test]
fn where_the_optimiser_has_no_memory_there_is_a_first_plan() {
    let mut dice = Dice::new(84);
    let mut found = 0;
    for _ in 0..500 {
        let judge = Judge::built(random::table(&mut dice, MEDIUM, &PAIR), 0);
        let wish = random::wish(&mut dice, &judge.table);
        let options = Judge::options(Solver::Exact, None, &wish);
        let mut little = options.clone();
        little.limits.bytes = 0;
        let poor = Optimiser::new(Arc::clone(&judge.problem), &little, None);
        let engine = BestPlan::with(u64::MAX, 1_000, Arc::clone(&judge.problem), &options);
        let (finding, _) = best(engine.with_optimiser(poor), 1);
        let possible = judge.endings().keys().any(|ending| wish.allows(&judge.table, ending));
        assert_eq!(finding.plan.is_some(), possible);
        if let Some(plan) = &finding.plan {
            assert!(wish.allows(&judge.table, &judge.ending(plan)));
            assert_ne!(finding.status, Status::Infeasible);
            found += usize::from(finding.status == Status::Feasible);
        }
    }
    assert!(found > 50, "{found}");
}
