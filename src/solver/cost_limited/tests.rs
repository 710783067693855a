//! Whenever the optimiser gives way, the answer is that of the exploration alone.

use std::sync::Arc;

use super::*;
use crate::common::random::{self, MEDIUM, PAIR};
use crate::common::{Dice, Wish};
use crate::solver::{Horizon, Solver};
use crate::trace::{check_cost, validate};

fn answer(engine: &mut dyn Engine) -> Finding {
    loop {
        if let Advance::Finished(finding) = engine.advance(1).unwrap() {
            return finding;
        }
    }
}

#[test]
fn whenever_the_optimiser_gives_way_the_answer_is_the_same() {
    let mut dice = Dice::new(711);
    let (mut plans, mut none, mut given_way) = (0, 0, 0);
    for _ in 0..1500 {
        let table = random::table(&mut dice, MEDIUM, &PAIR);
        let costs: Vec<u64> = table.actions.iter().map(|_| dice.below(4) as u64).collect();
        let problem = table.built_with_costs(0, Some(&costs));
        let wish: Wish = random::wish(&mut dice, &table);
        let horizon = dice.percent(30).then(|| random::horizon(&mut dice, &table, 200));
        let limit = dice.below(9) as u64;
        let mut options = Options::new(Solver::Exact).with_cost_limit(limit);
        options.horizon = horizon.map_or(Horizon::Any, Horizon::Steps);
        options.bounds = wish.bounds();
        let lengths = horizon.map_or(Lengths::Any, Lengths::Exactly);
        let alone = answer(&mut CostBounded::new(Arc::clone(&problem), &options, lengths));
        let worth = |plan: &Plan| {
            check_cost(&problem, plan, Some(limit)).unwrap();
            validate(&problem, plan).unwrap().counts.difference()
        };
        let expected = alone.plan.as_ref().map(|plan| (worth(plan), plan.len()));
        *(if expected.is_some() { &mut plans } else { &mut none }) += 1;
        for expansions in [0, 1, 2, 5, RELAXED_EXPANSIONS] {
            let problem = Arc::clone(&problem);
            let mut engine =
                CostLimited::with_relaxed_expansions(expansions, problem, &options, horizon);
            let found = answer(&mut engine);
            given_way += usize::from(matches!(engine.stage, Stage::Bounded(_)));
            assert_eq!(found.status, alone.status);
            let value = found.plan.as_ref().map(|plan| (worth(plan), plan.len()));
            assert_eq!(value, expected, "{expansions}");
            assert_eq!(found.length_proved, alone.length_proved);
        }
    }
    assert!(plans > 300 && none > 300 && given_way > 1000, "{plans} {none} {given_way}");
}
