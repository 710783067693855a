//! Random gridworlds and deliveries: what the crate makes of a document is what the document says.

use std::sync::Arc;

use mo_copp::domain::box_pushing::{BoxPushing, BoxPushingShape};
use mo_copp::domain::delivery::DeliveryShape;
use mo_copp::domain::gridworld::GridworldShape;
use mo_copp::domain::recycling_robot::{RecyclingRobot, RecyclingRobotShape};
use mo_copp::domain::{Delivery, Gridworld};
use mo_copp::solver::{Options, Solver, Status};

use crate::common::check::solve;
use crate::common::{Dice, Judge, Wish, box_pushing, delivery, gridworld, random, recycling_robot};
use crate::{exact, integer_programs, search};

fn of_grid(grid: &Gridworld) -> Judge {
    Judge::of(gridworld::table(grid), Arc::new(grid.problem().unwrap()))
}

fn of_delivery(delivery: &Delivery) -> Judge {
    Judge::of(delivery::table(delivery), Arc::new(delivery.problem().unwrap()))
}

fn of_box(document: &BoxPushing) -> Judge {
    Judge::of(box_pushing::table(document), Arc::new(document.problem().unwrap()))
}

fn of_robot(document: &RecyclingRobot) -> Judge {
    Judge::of(recycling_robot::table(document), Arc::new(document.problem().unwrap()))
}

fn agree(dice: &mut Dice, judge: &Judge) {
    let wish = if dice.percent(30) { Wish::default() } else { random::wish(dice, &judge.table) };
    let horizon = random::horizon(dice, &judge.table, 1100);
    exact::equals_enumeration(judge, horizon, &wish);
    exact::equals_closure(judge, &wish);
    for solver in search::SOLVERS {
        search::agrees(judge, solver, None, &wish);
        search::agrees(judge, solver, Some(horizon), &wish);
    }
}

#[test]
fn gridworlds_agree_with_the_oracles() {
    let mut dice = Dice::new(40);
    for _ in 0..1500 {
        let judge = of_grid(&gridworld::random(&mut dice, 4));
        agree(&mut dice, &judge);
    }
}

#[test]
fn deliveries_agree_with_the_oracles() {
    let mut dice = Dice::new(41);
    for _ in 0..600 {
        let judge = of_delivery(&delivery::random(&mut dice));
        agree(&mut dice, &judge);
    }
}

#[test]
fn box_pushing_agrees_with_the_oracles() {
    let mut dice = Dice::new(46);
    let mut solvable = 0;
    for _ in 0..30 {
        let judge = of_box(&box_pushing::random(&mut dice));
        solvable += usize::from(!judge.endings().is_empty());
        agree(&mut dice, &judge);
    }
    assert!((5..30).contains(&solvable), "{solvable} solvable");
}

#[test]
fn recycling_robots_agree_with_the_oracles() {
    let mut dice = Dice::new(47);
    let mut solvable = 0;
    for _ in 0..30 {
        let judge = of_robot(&recycling_robot::random(&mut dice));
        solvable += usize::from(!judge.endings().is_empty());
        agree(&mut dice, &judge);
    }
    assert!((5..30).contains(&solvable), "{solvable} solvable");
}

#[test]
fn bounds_hold_on_robots() {
    let mut dice = Dice::new(50);
    for _ in 0..250 {
        exact::bounds_hold_for(&of_robot(&recycling_robot::random(&mut dice)), &mut dice);
    }
}

#[test]
fn both_encodings_agree_on_boxes_and_robots() {
    let mut dice = Dice::new(48);
    let mut feasible = 0;
    for number in 0..120 {
        let judge = if number % 2 == 0 {
            of_box(&box_pushing::random(&mut dice))
        } else {
            of_robot(&recycling_robot::random(&mut dice))
        };
        let wish = random::wish(&mut dice, &judge.table);
        let horizon = dice.below(4);
        let found = integer_programs::equal_enumeration(&judge, horizon, &wish);
        feasible += usize::from(found);
    }
    assert!((10..110).contains(&feasible), "{feasible} feasible");
}

/// Of the paper's size. How often they are drawn again is what `docs/domains.md` says.
#[test]
fn thirty_problems_of_each_small_domain_are_solvable() {
    let mut redraws = [0; 3];
    for seed in 1..=30 {
        redraws[0] += GridworldShape::default().generate(seed).unwrap().redraws;
        let boxes = BoxPushingShape::default().generate(seed).unwrap();
        let robots = RecyclingRobotShape::default().generate(seed).unwrap();
        for problem in [boxes.document.problem().unwrap(), robots.document.problem().unwrap()] {
            let problem = Arc::new(problem);
            assert_eq!(problem.goals().len(), 3);
            let outcome = solve(&problem, &Options::new(Solver::Baseline));
            assert_eq!(outcome.status, Status::Solved, "seed {seed}");
        }
        redraws[1] += boxes.redraws;
        redraws[2] += robots.redraws;
    }
    assert_eq!(redraws, [38, 44, 14]);
}

#[test]
fn generated_documents_agree_with_the_oracles() {
    let mut dice = Dice::new(42);
    for seed in 0..60 {
        let shape = GridworldShape { width: 3, height: 3, goals: 3, walls: 1, belief: 3 };
        let judge = of_grid(&shape.generate(seed).unwrap().document);
        // Drawn so that the true goal can be reached.
        assert!(!judge.endings().is_empty());
        agree(&mut dice, &judge);
        let shape = DeliveryShape { factories: 2, packages: 4, deliver: 2 };
        let judge = of_delivery(&shape.generate(seed).unwrap().document);
        assert!(!judge.endings().is_empty());
        agree(&mut dice, &judge);
    }
}

#[test]
fn both_encodings_agree_on_gridworlds() {
    let mut dice = Dice::new(43);
    let mut feasible = 0;
    for _ in 0..400 {
        let judge = of_grid(&gridworld::random(&mut dice, 3));
        let wish = random::wish(&mut dice, &judge.table);
        let horizon = dice.below(5);
        let found = integer_programs::equal_enumeration(&judge, horizon, &wish);
        feasible += usize::from(found);
    }
    assert!((80..320).contains(&feasible), "{feasible} feasible");
}

#[test]
fn both_encodings_agree_on_deliveries() {
    let mut dice = Dice::new(44);
    let mut feasible = 0;
    for _ in 0..150 {
        let delivery = delivery::random(&mut dice);
        let judge = of_delivery(&delivery);
        let wish = random::wish(&mut dice, &judge.table);
        let horizon = delivery.deliver as usize + 1;
        let found = integer_programs::equal_enumeration(&judge, horizon, &wish);
        feasible += usize::from(found);
    }
    assert!((30..140).contains(&feasible), "{feasible} feasible");
}

/// Beliefs of more states than the heuristic looks at, and more symbols than fit a dense memory.
#[test]
fn large_beliefs_and_many_symbols() {
    let mut dice = Dice::new(1045);
    let mut infeasible = 0;
    for number in 0..8 {
        let side = dice.between(9, 10) as u32;
        let shape = GridworldShape { width: side, height: side, goals: 4, walls: 6, belief: 70 };
        let mut grid = shape.generate(number).unwrap().document;
        if number % 2 == 0 {
            // The friend sees most cells exactly.
            let cells = (0..side * side).map(|index| [index % side, index / side]);
            let cameras = cells.filter(|_| dice.percent(85)).collect();
            grid.observers.cooperative.cameras = cameras;
        }
        let judge = of_grid(&grid);
        for _ in 0..3 {
            let wish = random::wish(&mut dice, &judge.table);
            for solver in search::SOLVERS {
                search::agrees(&judge, solver, None, &wish);
            }
            exact::equals_closure(&judge, &wish);
            infeasible +=
                usize::from(!judge.endings().keys().any(|e| wish.allows(&judge.table, e)));
        }
    }
    assert!((1..24).contains(&infeasible), "{infeasible}");
}

/// The size the paper plans at; only the belief-flow encoding is up to it.
#[test]
fn belief_flow_agrees_with_exact_search_on_the_papers_gridworlds() {
    for seed in 0..12 {
        let grid = GridworldShape::default().generate(seed).unwrap().document;
        let judge = of_grid(&grid);
        let [start, goal] = [grid.start, grid.goals[0].cell];
        let shortest = start[0].abs_diff(goal[0]) + start[1].abs_diff(goal[1]);
        let horizon = Some(shortest as usize + 4);
        let wish = Wish::default();
        let found = [Solver::Exact, Solver::Ip].map(|solver| {
            let options = Judge::options(solver, horizon, &wish);
            let outcome = judge.solve(&options);
            judge.check(&options, &outcome, &wish).unwrap();
            outcome.goal_difference
        });
        assert_eq!(found[0], found[1], "seed {seed}");
    }
}
