//! Beliefs worked out by hand, the paper's delivery, and the two degenerate sensors.

use std::sync::Arc;

use mo_copp::domain::grid::{GridGoal, GridObserver};
use mo_copp::domain::{Delivery, Document, Gridworld, Observers};
use mo_copp::plan::Plan;
use mo_copp::problem::Problem;
use mo_copp::solver::{Options, Solver, Status};
use mo_copp::trace::{Trace, trace, validate};

use crate::common::random::{self, MEDIUM, PAIR};
use crate::common::table::{Set, Watcher, members};
use crate::common::{Dice, Judge, oracle, solve};

/// A corridor with a side door:
///
/// ```text
/// s0 -go-> s1 -go-> s2 -go-> s3     s0 -jump-> s2     s4 -jump-> s1     s1 -wait-> s1
/// ```
///
/// The enemy hears go, jump or wait, and begins with {s0, s4}. The friend has a lamp at s2: it sees
/// "lit" whenever a step ends there and "dark" elsewhere, and begins with {s0}.
const CORRIDOR: &str = r#"{"format": "explicit",
  "states": ["s0", "s1", "s2", "s3", "s4"], "actions": ["go", "jump", "wait"],
  "transitions": [["s0", "go", "s1"], ["s1", "go", "s2"], ["s2", "go", "s3"],
    ["s0", "jump", "s2"], ["s4", "jump", "s1"], ["s1", "wait", "s1"]],
  "initial_state": "s0",
  "goals": [{"name": "G1", "states": ["s2", "s3"]}, {"name": "G2", "states": ["s1"]},
    {"name": "G3", "states": ["s2"]}, {"name": "G4", "states": []}],
  "true_goal": "G1",
  "observers": {
    "adversarial": {"initial_belief": ["s4", "s0"], "sensor": [["go", "s1", "go"],
      ["go", "s2", "go"], ["go", "s3", "go"], ["jump", "s2", "jump"], ["jump", "s1", "jump"],
      ["wait", "s1", "wait"]]},
    "cooperative": {"sensor": [["go", "s1", "dark"], ["go", "s2", "lit"], ["go", "s3", "dark"],
      ["jump", "s2", "lit"], ["jump", "s1", "dark"], ["wait", "s1", "dark"]]}}}"#;

fn corridor() -> Problem {
    Document::parse(CORRIDOR).unwrap().problem().unwrap()
}

/// What an observer believes after each step, joined by spaces.
fn beliefs(problem: &Problem, trace: &Trace, observer: usize) -> Vec<String> {
    let step = |step: &mo_copp::trace::TraceStep| {
        let label = |state: &mo_copp::task::State| problem.label(state.words()).to_string();
        let mut states: Vec<String> = step.beliefs[observer].iter().map(label).collect();
        states.sort();
        states.join(" ")
    };
    trace.steps.iter().map(step).collect()
}

fn goals(problem: &Problem, trace: &Trace, observer: usize) -> Vec<String> {
    let name = |goal: usize| problem.goals()[goal].name.as_str();
    let step = |step: &mo_copp::trace::TraceStep| {
        step.survivors[observer].iter().map(name).collect::<Vec<_>>().join(" ")
    };
    trace.steps.iter().map(step).collect()
}

fn follow(problem: &Problem, actions: &[&str]) -> Trace {
    trace(problem, &Plan::from_names(problem.task(), actions).unwrap()).unwrap()
}

#[test]
fn jump_in_the_corridor() {
    let problem = corridor();
    let trace = follow(&problem, &["jump", "go"]);
    // "jump": s0 → s2, s4 → s1. "go" from {s1, s2}: s2, s3.
    assert_eq!(beliefs(&problem, &trace, 0), ["s0 s4", "s1 s2", "s2 s3"]);
    // "lit": s0 → s2 by jump; go leads to s1, which is dark. "dark" from {s2}: s3.
    assert_eq!(beliefs(&problem, &trace, 1), ["s0", "s2", "s3"]);
    assert_eq!(goals(&problem, &trace, 0), ["", "G1 G2 G3", "G1 G3"]);
    assert_eq!(goals(&problem, &trace, 1), ["", "G1 G3", "G1"]);
    // (2 − 1) / 3.
    assert_eq!(trace.goal_difference(&problem), 1.0 / 3.0);
    assert!(trace.reaches_goal);
}

#[test]
fn go_in_the_corridor() {
    let problem = corridor();
    let trace = follow(&problem, &["go", "wait", "go"]);
    // "go": s0 → s1, nothing from s4. "wait": s1. "go": s2.
    assert_eq!(beliefs(&problem, &trace, 0), ["s0 s4", "s1", "s1", "s2"]);
    // "dark": s0 → s1 by go. "dark" from {s1}: wait to s1; go to s2 is lit. "lit": s2.
    assert_eq!(beliefs(&problem, &trace, 1), ["s0", "s1", "s1", "s2"]);
    assert_eq!(goals(&problem, &trace, 0).last().unwrap(), "G1 G3");
    assert_eq!(trace.goal_difference(&problem), 0.0);
}

#[test]
fn a_symbol_covers_actions_that_only_other_states_allow() {
    // The enemy begins with {s0, s4}; the actor's own go says nothing of s4, where go is not
    // possible; but "jump" counts s4's jump, which the actor could not take.
    let problem = corridor();
    assert_eq!(beliefs(&problem, &follow(&problem, &["go"]), 0), ["s0 s4", "s1"]);
    assert_eq!(beliefs(&problem, &follow(&problem, &["jump"]), 0), ["s0 s4", "s1 s2"]);
}

#[test]
fn plans_that_cannot_be_carried_out() {
    let problem = corridor();
    let error = Plan::from_names(problem.task(), &["go", "fly"]).unwrap_err().to_string();
    assert_eq!(error, "step 2: found \"fly\", expected an action of this problem: go, jump, wait");
    let plan = Plan::from_names(problem.task(), &["go", "jump"]).unwrap();
    let error = trace(&problem, &plan).unwrap_err().to_string();
    assert_eq!(
        error,
        "step 2: found jump, which is not applicable in s1: it leads nowhere from there"
    );
    let plan = Plan::from_names(problem.task(), &["go"]).unwrap();
    assert!(!trace(&problem, &plan).unwrap().reaches_goal);
    let error = validate(&problem, &plan).unwrap_err().to_string();
    assert_eq!(error, "the plan ends in a state without the true goal");
}

#[test]
fn plans_and_traces_that_are_too_long() {
    let problem = corridor();
    let error = Plan::from_names(problem.task(), &vec!["go"; 10_001]).unwrap_err().to_string();
    assert_eq!(error, "the plan: found 10001 actions, expected at most 10000");
    // 65,536 cells for each observer, and so for each of 2 × 31 beliefs: more than 4 million.
    let cells: Vec<[u32; 2]> = (0..1 << 16).map(|index| [index % 256, index / 256]).collect();
    let mut sensor = Gridworld::paper_sensors().adversarial;
    sensor.set("stay", "north");
    let observer = GridObserver::new(Some(cells), sensor);
    let goal = |name: &str| GridGoal { name: name.to_owned(), cell: [1, 1] };
    let grid = Gridworld {
        width: 256,
        height: 256,
        walls: Vec::new(),
        start: [1, 1],
        goals: vec![goal("G1"), goal("G2")],
        true_goal: "G1".to_owned(),
        stay: true,
        observers: Observers { adversarial: observer.clone(), cooperative: observer },
    };
    let problem = grid.problem().unwrap();
    let plan = Plan::from_names(problem.task(), &["stay"; 40]).unwrap();
    let error = trace(&problem, &plan).unwrap_err().to_string();
    assert_eq!(error, "trace limit reached at step 30: 4000000 believed states");
}

#[test]
fn both_packages_from_one_factory() {
    let problem = Delivery::figure_1().problem().unwrap();
    let trace = follow(&problem, &["load a1", "load a2", "deliver"]);
    let last = trace.steps.last().unwrap();
    assert_eq!((last.survivors[0].len(), last.survivors[1].len()), (6, 1));
    assert_eq!(trace.goal_difference(&problem), 1.0);
    assert_eq!(goals(&problem, &trace, 1).last().unwrap(), "a1+a2");
}

#[test]
fn one_package_from_each_factory() {
    let mut delivery = Delivery::figure_1();
    delivery.true_goal = "b1+a2".to_owned();
    let problem = delivery.problem().unwrap();
    for plan in [["load a2", "load b1", "deliver"], ["load b1", "load a2", "deliver"]] {
        let trace = follow(&problem, &plan);
        let last = trace.steps.last().unwrap();
        assert_eq!((last.survivors[0].len(), last.survivors[1].len()), (6, 4));
        assert_eq!(trace.goal_difference(&problem), 0.4);
        assert_eq!(goals(&problem, &trace, 1).last().unwrap(), "a1+b1 a1+b2 a2+b1 a2+b2");
    }
}

#[test]
fn every_solver_finds_the_delivery_answers() {
    for (true_goal, difference) in [("a1+a2", 1.0), ("b1+b2", 1.0), ("a1+b2", 0.4)] {
        let mut delivery = Delivery::figure_1();
        delivery.true_goal = true_goal.to_owned();
        let problem = Arc::new(delivery.problem().unwrap());
        for solver in Solver::ALL {
            let outcome = solve(&problem, &Options::new(solver));
            assert_eq!(outcome.goal_difference, Some(difference), "{}", solver.name());
            let best = matches!(solver, Solver::Exact | Solver::Ip);
            let status = if best { Status::Optimal } else { Status::Solved };
            assert_eq!(outcome.status, status);
        }
    }
}

/// Everything that exactly one more step can lead to.
fn image(table: &crate::common::Table, states: Set) -> Set {
    let targets = members(states).flat_map(|state| table.next[state].iter().flatten());
    targets.fold(0, |set, &target| set | 1 << target)
}

#[test]
fn one_symbol_for_all_means_everything_reachable_in_that_many_steps() {
    let mut dice = Dice::new(9);
    let mut steps = 0;
    for _ in 0..500 {
        let mut table = random::table(&mut dice, MEDIUM, &PAIR);
        for watcher in &mut table.watchers {
            let row = vec![0; table.states.len()];
            watcher.symbols = vec!["something".to_owned()];
            watcher.sensor = vec![row; table.actions.len()];
        }
        let judge = Judge::new(table);
        let (plan, trace) = wander(&mut dice, &judge);
        for observer in 0..2 {
            let mut expected = judge.table.watchers[observer].belief;
            for after in &trace.steps {
                let label = |state: usize| judge.table.states[state].clone();
                let mut expected_names: Vec<String> = members(expected).map(label).collect();
                expected_names.sort();
                let mut found: Vec<String> = after.beliefs[observer]
                    .iter()
                    .map(|state| format!("{:#}", judge.problem.label(state.words())))
                    .collect();
                found.sort();
                assert_eq!(found, expected_names);
                expected = image(&judge.table, expected);
            }
        }
        steps += plan.len();
    }
    assert!(steps > 1000);
}

#[test]
fn a_symbol_for_each_pair_means_a_single_state() {
    let mut dice = Dice::new(10);
    let mut steps = 0;
    for _ in 0..500 {
        let mut table = random::table(&mut dice, MEDIUM, &PAIR);
        let (states, actions) = (table.states.len(), table.actions.len());
        for watcher in &mut table.watchers {
            *watcher = Watcher {
                role: watcher.role,
                belief: 1 << table.start,
                symbols: (0..states * actions).map(|symbol| format!("o{symbol}")).collect(),
                sensor: (0..actions)
                    .map(|a| (0..states).map(|s| a * states + s).collect())
                    .collect(),
            };
        }
        let judge = Judge::new(table);
        let (plan, trace) = wander(&mut dice, &judge);
        for step in &trace.steps {
            for belief in &step.beliefs {
                assert_eq!(belief.as_slice(), std::slice::from_ref(&step.state));
            }
        }
        steps += plan.len();
    }
    assert!(steps > 1000);
}

/// A random walk of at most six actions, traced by the crate.
fn wander(dice: &mut Dice, judge: &Judge) -> (Plan, Trace) {
    let table = &judge.table;
    let mut state = table.start;
    let mut names = Vec::new();
    for _ in 0..6 {
        let possible: Vec<usize> =
            (0..table.actions.len()).filter(|&a| table.next[state][a].is_some()).collect();
        if possible.is_empty() {
            break;
        }
        let action = dice.pick(&possible);
        names.push(table.actions[action].as_str());
        state = table.next[state][action].unwrap();
    }
    let plan = Plan::from_names(judge.problem.task(), &names).unwrap();
    let traced = trace(&judge.problem, &plan).unwrap();
    (plan, traced)
}

#[test]
fn random_walks_are_traced_as_the_definitions_say() {
    let mut dice = Dice::new(11);
    for _ in 0..3000 {
        let judge = Judge::new(random::table(&mut dice, MEDIUM, &PAIR));
        let (plan, traced) = wander(&mut dice, &judge);
        judge.check_trace(&plan);
        let replayed = oracle::replay(&judge.table, &judge.positions(&plan)).unwrap();
        let valid = judge.table.is_goal(replayed.last().unwrap().state);
        assert_eq!(validate(&judge.problem, &plan).is_ok(), valid);
        assert_eq!(traced.steps.len(), plan.len() + 1);
    }
}
