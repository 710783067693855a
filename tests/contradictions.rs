//! Bounds that contradict themselves: every solver says at once that no plan keeps them, whatever the task.

use std::sync::Arc;

use mo_copp::problem::{Problem, Role};
use mo_copp::solver::remedy::{Reason, RemedyRun};
use mo_copp::solver::{Bounds, Encoding, Horizon, Options, Solver, Status, UpperBound, Watched};
use mo_copp::solver::{Run, upper_bounds};

use crate::common::random::{self, MEDIUM};
use crate::common::table::Table;
use crate::common::{Dice, Judge, Wish, solve};
use crate::golden::replay;
use crate::observers::COMPANIES;
use crate::search::heeded;

/// From the definitions: what an observer must believe possible, what it must not, and how many of each there are.
pub fn contradictory(table: &Table, wish: &Wish) -> bool {
    let goals = table.goals.len();
    let of = |list: &[(usize, usize)], watcher| {
        (0..goals).filter(|goal| list.contains(&(watcher, *goal))).collect::<Vec<_>>()
    };
    table.watchers.iter().enumerate().any(|(number, watcher)| {
        let mut alive = of(&wish.required, number);
        alive.extend((!alive.contains(&table.true_goal)).then_some(table.true_goal));
        let dead = of(&wish.forbidden, number);
        let counts = match watcher.role {
            Role::Adversarial => wish.k.is_some_and(|k| k > goals - dead.len()),
            Role::Cooperative => wish.j.is_some_and(|j| j < alive.len()),
        };
        counts || dead.iter().any(|goal| alive.contains(goal))
    })
}

/// Wishes with many named goals.
fn wish(dice: &mut Dice, table: &Table) -> Wish {
    let mut wish = random::wish(dice, table);
    for list in [&mut wish.required, &mut wish.forbidden] {
        while dice.percent(50) {
            list.push((dice.below(table.watchers.len()), dice.below(table.goals.len())));
        }
    }
    wish
}

#[test]
fn every_solver_answers_at_once_and_as_enumeration_does() {
    let mut dice = Dice::new(110);
    let mut seen = [0; 2];
    for number in 0..4_000 {
        let roles = COMPANIES[number % COMPANIES.len()];
        let judge = Judge::built(random::table(&mut dice, MEDIUM, roles), 0);
        let wish = wish(&mut dice, &judge.table);
        let solver = Solver::ALL[number % Solver::ALL.len()];
        let heard = heeded(solver, &wish);
        let horizon = (solver == Solver::Ip || dice.percent(50))
            .then(|| random::horizon(&mut dice, &judge.table, 100));
        let mut options = Judge::options(solver, horizon, &wish);
        options.encoding = dice.pick(&Encoding::ALL);
        let contradictory = contradictory(&judge.table, &heard);
        seen[usize::from(contradictory)] += 1;
        if !contradictory {
            continue;
        }
        assert!(!judge.endings().keys().any(|ending| heard.allows(&judge.table, ending)));
        let outcome = judge.solve(&options);
        let work = (outcome.stats.expansions, outcome.stats.nodes, outcome.stats.states);
        assert_eq!((outcome.status, work), (Status::Infeasible, (0, 0, 0)), "{heard:?}");
        let mut run = RemedyRun::new(Arc::clone(&judge.problem), options).unwrap();
        while !run.advance(16).unwrap() {}
        let reachable = !judge.endings().is_empty();
        let advice = run.outcome().unwrap();
        match advice.reason {
            Some(Reason::Unreachable) => assert!(!reachable),
            Some(Reason::Length) => assert!(reachable && horizon.is_some()),
            reason => assert_eq!((reason, reachable), (Some(Reason::Bounds), true)),
        }
    }
    assert!(seen.iter().all(|&count| count > 1_000), "{seen:?}");
}

fn watched(problem: &Problem, observer: &str, goal: &str) -> Vec<Watched> {
    let observer = problem.observer_named(observer).unwrap();
    vec![Watched { observer, goal: problem.goal_named(goal).unwrap() }]
}

/// Logistics drawn, where to look through all of it would take more than the memory there is.
#[test]
fn the_true_goal_cannot_be_forbidden_however_large_the_task() {
    let problem = Arc::new(replay::draw("logistics", 2).problem().unwrap());
    assert_eq!(problem.goals()[problem.true_goal()].name, "G1");
    let goals = problem.goals().len();
    let forbidden = |observer| Bounds::default().with_forbidden(watched(&problem, observer, "G1"));
    let both = Bounds::default()
        .with_required(watched(&problem, "adversarial", "G2"))
        .with_forbidden(watched(&problem, "adversarial", "G2"));
    let too_many = Bounds::default().with_at_least(goals).with_forbidden(watched(
        &problem,
        "adversarial",
        "G2",
    ));
    let too_few =
        Bounds::default().with_at_most(1).with_required(watched(&problem, "cooperative", "G2"));
    for bounds in [forbidden("adversarial"), forbidden("cooperative"), both, too_many, too_few] {
        for solver in [Solver::Exact, Solver::Ip, Solver::Search, Solver::Satisficing] {
            let options = Options::new(solver).with_bounds(bounds.clone());
            for options in [options.clone(), options.clone().with_horizon(Horizon::Steps(40))] {
                let outcome = solve(&problem, &options);
                assert_eq!((outcome.status, outcome.stats.states), (Status::Infeasible, 0));
            }
        }
        let options = Options::new(Solver::Exact).with_bounds(bounds);
        let found = upper_bounds(&problem, &options).unwrap();
        assert_eq!(found[0], ("trivial", UpperBound::Infeasible));
        let pairs = solve(&problem, &options.clone().with_pairs(true));
        assert_eq!((pairs.status, pairs.pairs), (Status::Infeasible, Some(Vec::new())));
        let lengths = solve(&problem, &options.clone().with_lengths(3));
        assert_eq!(lengths.status, Status::Infeasible);
        assert!(lengths.lengths.unwrap().iter().map(|point| point.length).eq(0..=3));
        let cost = solve(&problem, &options.clone().with_cost_limit(5));
        assert_eq!((cost.status, cost.stats.states), (Status::Infeasible, 0));
        let mut run = RemedyRun::new(Arc::clone(&problem), options.clone()).unwrap();
        for _ in 0..400 {
            run.advance(16).unwrap();
        }
        assert_eq!(run.outcome().unwrap().reason, Some(Reason::Bounds));
    }
}

/// A goal that holds wherever the true one does survives with it.
#[test]
fn a_goal_implied_by_the_true_one_cannot_be_forbidden() {
    let text = r#"{"format": "pddl",
        "domain": "(define (domain d) (:predicates (a) (b) (c)) (:action go :parameters () :precondition (a) :effect (and (b) (c))))",
        "problem": "(define (problem p) (:domain d) (:init (a)) (:goal (and (b) (c))))",
        "goals": [{"name": "G1", "condition": "(and (b) (c))"}, {"name": "G2", "condition": "(b)"}, {"name": "G3", "condition": "(a)"}],
        "true_goal": "G1",
        "observers": {"adversarial": {"sensor": "{name}"}, "cooperative": {"sensor": "{name}"}}}"#;
    let problem = Arc::new(mo_copp::domain::Document::parse(text).unwrap().problem().unwrap());
    let bounds = [
        Bounds::default().with_forbidden(watched(&problem, "adversarial", "G2")),
        Bounds::default().with_at_most(1),
    ];
    for bounds in bounds {
        let options = Options::new(Solver::Exact).with_bounds(bounds);
        let mut run = Run::new(Arc::clone(&problem), options).unwrap();
        assert!(run.advance(1).unwrap());
        let outcome = run.outcome().unwrap();
        assert_eq!((outcome.status, outcome.stats.states), (Status::Infeasible, 0));
    }
}
