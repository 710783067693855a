//! Replays with listed beliefs against replays with diagrams.

use super::*;
use crate::common::Dice;
use crate::domain::generate::Domain;
use crate::domain::pddl::generate::LogisticsShape;

/// A walk of at most so many actions.
fn walk(problem: &Problem, dice: &mut Dice, steps: usize) -> Plan {
    let task = problem.task();
    let mut plan = Plan::default();
    let mut words = task.initial_state().words().to_vec();
    for _ in 0..steps {
        let mut applicable = Vec::new();
        task.applicable(&words, &mut applicable);
        if applicable.is_empty() {
            break;
        }
        let operator = dice.pick(&applicable);
        task.apply(operator, &mut words);
        plan.actions.push(task.operator(operator).action);
    }
    plan
}

/// What a replay says of each step: how many states, some of them, which goals, which facts how often.
fn told(problem: &Problem, plan: &Plan, listed: usize) -> (Vec<String>, usize) {
    let mut replay = Replay::new(problem, plan).unwrap();
    replay.listed = listed;
    let mut unlisted = 0;
    let mut said = Vec::new();
    loop {
        for belief in &replay.beliefs {
            unlisted += usize::from(belief.as_list().is_none());
            let task = problem.task();
            let goals: Vec<StateCount> = problem
                .goals()
                .iter()
                .map(|goal| belief.count_satisfying(task, &goal.condition))
                .collect();
            let states = belief.some_states(usize::MAX);
            said.push(format!(
                "{:?} {states:?} {goals:?} {:?} {:?}",
                belief.count(),
                belief.fact_counts(task),
                belief.facts(task).ones().collect::<Vec<_>>(),
            ));
        }
        let survivors = replay.survivors();
        let goals = survivors.iter().map(|goals| goals.iter().collect::<Vec<_>>());
        said.push(format!("{:?}", goals.collect::<Vec<_>>()));
        match replay.step().unwrap() {
            Some(symbols) => said.push(format!("{symbols:?}")),
            None => return (said, unlisted),
        }
    }
}

#[test]
fn both_forms_of_a_belief_say_the_same() {
    let mut dice = Dice::new(21);
    let mut unlisted = 0;
    for domain in Domain::ALL {
        for seed in 1..=4 {
            let problem = domain.draw(seed).unwrap().document.problem().unwrap();
            let plan = walk(&problem, &mut dice, 5);
            let (listed, none) = told(&problem, &plan, usize::MAX);
            assert_eq!(none, 0);
            for most in [0, 1, 7] {
                let (said, count) = told(&problem, &plan, most);
                for (said, listed) in said.iter().zip(&listed) {
                    assert_eq!(said, listed, "{} {seed} {most}", domain.name());
                }
                assert_eq!(said.len(), listed.len());
                unlisted += count;
            }
        }
    }
    assert!(unlisted > 200, "{unlisted}");
}

#[test]
fn initial_beliefs_that_are_not_listed_say_the_same() {
    let mut dice = Dice::new(23);
    let mut compared = 0;
    for domain in Domain::ALL {
        for seed in 1..=4 {
            let problem = domain.draw(seed).unwrap().document.problem().unwrap();
            let other = problem.with_unlisted_beliefs();
            let plan = walk(&problem, &mut dice, 5);
            let (listed, _) = told(&problem, &plan, usize::MAX);
            let (said, unlisted) = told(&other, &plan, usize::MAX);
            assert!(unlisted > 0);
            assert_eq!(said, listed, "{} {seed}", domain.name());
            let why = elimination(&other, &plan, 0, 0, plan.len());
            assert!(matches!(why, Err(PlanError::TooManyStates { step: 0, .. })), "{why:?}");
            compared += said.len();
        }
    }
    assert!(compared > 300, "{compared}");
}

/// Ten packages in two cities: the enemy, which sees names of operators alone, soon believes more states than any list
/// holds.
#[test]
fn a_belief_that_no_list_holds_is_replayed() {
    let shape = LogisticsShape { packages: 10, ..LogisticsShape::default() };
    let problem = shape.generate(1).unwrap().document.problem().unwrap();
    let mut dice = Dice::new(22);
    let mut most: f64 = 0.0;
    for _ in 0..3 {
        let plan = walk(&problem, &mut dice, 120);
        pass(&problem, &plan, |step| {
            for (index, belief) in step.beliefs.iter().enumerate() {
                most = most.max(belief.count().as_f64());
                let holds = |goal: usize| {
                    belief.satisfies(problem.task(), &problem.goals()[goal].condition)
                };
                for goal in 0..problem.goals().len() {
                    assert_eq!(step.survivors[index].contains(goal), holds(goal));
                }
            }
            Ok(())
        })
        .unwrap();
    }
    assert!(most > MAX_STATES as f64, "{most}");
}
