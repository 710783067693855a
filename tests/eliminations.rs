//! Goals that may still come, and why a goal is not possible: held against the tables.

use mo_copp::domain::Document;
use mo_copp::plan::Plan;
use mo_copp::problem::Role;
use mo_copp::report::TraceReport;
use mo_copp::trace::{Elimination, ReachableGoals, elimination, nearest, trace};

use crate::common::check::bits;
use crate::common::oracle::{Replayed, replay};
use crate::common::random::{MEDIUM, table};
use crate::common::table::{Goals, Set, members};
use crate::common::{Dice, Judge, Table, box_pushing, gridworld, recycling_robot};

/// The goals that hold in a state of the set or in one that any actions lead to.
fn reachable(table: &Table, belief: Set) -> Goals {
    let (mut seen, mut open): (Set, Vec<usize>) = (belief, members(belief).collect());
    while let Some(state) = open.pop() {
        for &target in table.next[state].iter().flatten() {
            if seen >> target & 1 == 0 {
                seen |= 1 << target;
                open.push(target);
            }
        }
    }
    table.survivors(seen)
}

/// A walk of at most this many actions.
fn walk(dice: &mut Dice, table: &Table, most: usize) -> Vec<usize> {
    let (mut state, mut plan) = (table.start, Vec::new());
    for _ in 0..most {
        let able = |&action: &usize| table.next[state][action].is_some();
        let able: Vec<usize> = (0..table.actions.len()).filter(able).collect();
        if able.is_empty() {
            break;
        }
        let action = dice.pick(&able);
        state = table.next[state][action].unwrap();
        plan.push(action);
    }
    plan
}

fn named(judge: &Judge, plan: &[usize]) -> Plan {
    let names: Vec<&str> = plan.iter().map(|&action| &*judge.table.actions[action]).collect();
    Plan::from_names(judge.problem.task(), &names).unwrap()
}

#[test]
fn what_may_still_come_is_never_ruled_out_and_on_single_facts_nothing_else_is_open() {
    let mut dice = Dice::new(14);
    let (mut closed, mut coarse) = (0, 0);
    for case in 0..240 {
        let (judge, exact) = match case % 4 {
            0 => (
                Judge::new(table(&mut dice, MEDIUM, &[Role::Adversarial, Role::Cooperative])),
                true,
            ),
            1 => {
                let grid = gridworld::random(&mut dice, 5);
                (Judge::of(gridworld::table(&grid), grid.problem().unwrap().into()), true)
            }
            2 => {
                let boxes = box_pushing::random(&mut dice);
                (Judge::of(box_pushing::table(&boxes), boxes.problem().unwrap().into()), false)
            }
            _ => {
                let robot = recycling_robot::random(&mut dice);
                (Judge::of(recycling_robot::table(&robot), robot.problem().unwrap().into()), false)
            }
        };
        let plan = walk(&mut dice, &judge.table, 6);
        let steps = replay(&judge.table, &plan).unwrap();
        let replayed = trace(&judge.problem, &named(&judge, &plan)).unwrap();
        let mut open = ReachableGoals::new(&judge.problem);
        for (step, replayed) in steps.iter().zip(&replayed.steps) {
            for (watcher, &belief) in step.beliefs.iter().enumerate() {
                let found = bits(&open.from(&replayed.beliefs[watcher]));
                let truly = reachable(&judge.table, belief);
                assert_eq!(found & truly, truly, "case {case}");
                closed += found.count_zeros() as usize - (32 - judge.table.goals.len());
                if exact {
                    assert_eq!(found, truly, "case {case}");
                } else {
                    coarse += usize::from(found != truly);
                }
            }
        }
    }
    // Some goals are out of reach, and not every relaxation is exact.
    assert!(closed > 100, "{closed}");
    assert!(coarse < 400, "{coarse}");
}

/// The same from the definition: what each step says of a goal, the last that says something.
fn expected(
    table: &Table,
    plan: &[usize],
    steps: &[Replayed],
    watcher: usize,
    goal: usize,
) -> Option<(usize, usize, Set, Set)> {
    let mut last = None;
    let states = table.goals[goal];
    for (index, _) in plan.iter().enumerate() {
        let (before, after) = (&steps[index], &steps[index + 1]);
        if after.beliefs[watcher] & states != 0 {
            last = None;
            continue;
        }
        let belief = before.beliefs[watcher];
        let leads = |&state: &usize| {
            table.next[state].iter().flatten().any(|&target| states >> target & 1 == 1)
        };
        let led: Set = members(belief).filter(leads).map(|state| 1 << state).sum();
        if led != 0 || belief & states != 0 {
            last = Some((index + 1, after.symbols[watcher], led, belief & states));
        }
    }
    last
}

/// A table or a grid, by turns.
fn drawn(dice: &mut Dice, case: usize) -> Judge {
    if case.is_multiple_of(2) {
        return Judge::new(table(dice, MEDIUM, &[Role::Adversarial, Role::Cooperative]));
    }
    let grid = gridworld::random(dice, 4);
    Judge::of(gridworld::table(&grid), grid.problem().unwrap().into())
}

/// The fewest actions from a state of the set to one of the others.
fn actions_between(table: &Table, from: Set, to: Set) -> Option<usize> {
    let (mut seen, mut actions) = (from, 0);
    while seen & to == 0 {
        let next = |state: usize| table.next[state].iter().flatten().map(|&target| 1 << target);
        let more = members(seen).flat_map(next).fold(seen, |set, state: Set| set | state);
        if more == seen {
            return None;
        }
        (seen, actions) = (more, actions + 1);
    }
    Some(actions)
}

#[test]
fn the_believed_state_that_is_nearest_to_a_goal() {
    let mut dice = Dice::new(11);
    let (mut near, mut never) = (0, 0);
    for case in 0..300 {
        let judge = drawn(&mut dice, case);
        let table = &judge.table;
        let plan = walk(&mut dice, table, 6);
        let steps = replay(table, &plan).unwrap();
        let label = |words: &[u64]| format!("{:#}", judge.problem.label(words));
        let named = named(&judge, &plan);
        let step = dice.below(plan.len() + 1);
        for watcher in 0..2 {
            for goal in 0..table.goals.len() {
                let belief = steps[step].beliefs[watcher];
                let expected = actions_between(table, belief, table.goals[goal]);
                let found = nearest(&judge.problem, &named, watcher, goal, step).unwrap();
                assert_eq!(found.as_ref().map(|found| found.actions), expected, "case {case}");
                let Some(found) = found else {
                    never += 1;
                    continue;
                };
                near += usize::from(found.actions > 0);
                let name = label(found.state.words());
                let state = members(belief).find(|&state| *table.states[state] == *name).unwrap();
                assert_eq!(actions_between(table, 1 << state, table.goals[goal]), expected);
            }
        }
    }
    assert!(near > 200 && never > 20, "{near} {never}");
}

#[test]
fn the_last_states_that_would_have_led_to_a_goal() {
    let mut dice = Dice::new(10);
    let mut found_some = 0;
    for case in 0..300 {
        let judge = drawn(&mut dice, case);
        let table = &judge.table;
        let plan = walk(&mut dice, table, 6);
        let steps = replay(table, &plan).unwrap();
        let label = |words: &[u64]| format!("{:#}", judge.problem.label(words));
        for watcher in 0..2 {
            for goal in 0..table.goals.len() {
                let named = named(&judge, &plan);
                let found = elimination(&judge.problem, &named, watcher, goal, plan.len()).unwrap();
                let expected = expected(table, &plan, &steps, watcher, goal);
                assert_eq!(found.is_some(), expected.is_some(), "case {case}");
                let (Some(found), Some((step, symbol, led, held))) = (found, expected) else {
                    continue;
                };
                found_some += 1;
                let Elimination { led: found_led, held: found_held, .. } = &found;
                assert_eq!(
                    (found.step, &found.symbol),
                    (step, &table.watchers[watcher].symbols[symbol])
                );
                let names = |set: Set| {
                    let mut names: Vec<&str> = members(set).map(|s| &*table.states[s]).collect();
                    names.sort_unstable();
                    names.into_iter().map(str::to_owned).collect::<Vec<_>>()
                };
                let mut seen: Vec<String> =
                    found_led.iter().map(|m| label(m.state.words())).collect();
                seen.sort_unstable();
                assert_eq!((seen, found.led_count), (names(led), led.count_ones() as usize));
                let mut seen: Vec<String> = found_held.iter().map(|s| label(s.words())).collect();
                seen.sort_unstable();
                assert_eq!((seen, found.held_count), (names(held), held.count_ones() as usize));
                for missed in found_led {
                    assert_ne!(missed.symbol, found.symbol, "it would have been another symbol");
                    let goal = &judge.problem.goals()[goal].condition;
                    assert!(judge.problem.task().satisfies(missed.result.words(), goal));
                }
            }
        }
    }
    assert!(found_some > 200, "{found_some}");
}

#[test]
fn a_goal_is_ruled_out_by_a_wall_of_no_return_and_all_others_at_the_end() {
    // One way: from a there is no way back to the start's left neighbour.
    let document = r#"{"format": "explicit", "states": ["left", "start", "a", "b"], "actions": ["l", "r"],
        "transitions": [["start", "l", "left"], ["start", "r", "a"], ["a", "r", "b"]],
        "initial_state": "start",
        "goals": [{"name": "L", "states": ["left"]}, {"name": "B", "states": ["b"]}, {"name": "S", "states": ["start"]}],
        "true_goal": "B",
        "observers": {
          "adversarial": {"sensor": [["l", "left", "moved"], ["r", "a", "moved"], ["r", "b", "moved"]]},
          "cooperative": {"sensor": [["l", "left", "l"], ["r", "a", "r"], ["r", "b", "r"]]}}}"#;
    let problem = Document::parse(document).unwrap().problem().unwrap();
    let plan = Plan::from_names(problem.task(), &["r", "r"]).unwrap();
    let report = TraceReport::overview(&problem, &plan, 5).unwrap();
    let ruled_out: Vec<serde_json::Value> =
        report.steps.iter().map(|step| serde_json::to_value(&step.ruled_out).unwrap()).collect();
    assert_eq!(ruled_out[0], serde_json::json!({"adversarial": [], "cooperative": []}));
    // The enemy takes the agent for left or at a; the friend knows it is at a.
    assert_eq!(ruled_out[1], serde_json::json!({"adversarial": ["S"], "cooperative": ["L", "S"]}));
    assert_eq!(
        ruled_out[2],
        serde_json::json!({"adversarial": ["L", "S"], "cooperative": ["L", "S"]})
    );
    let friend = problem.observer_named("cooperative").unwrap();
    let ended = elimination(&problem, &plan, friend, 0, 2).unwrap().unwrap();
    assert_eq!((ended.step, ended.symbol.as_str(), ended.led[0].symbol.as_str()), (1, "r", "l"));
    assert!(elimination(&problem, &plan, friend, 0, 0).unwrap().is_none(), "nothing was seen yet");
    assert!(elimination(&problem, &plan, friend, 1, 2).unwrap().is_none(), "it is possible");
}

#[test]
fn at_the_start_of_a_grid_no_goal_is_ruled_out() {
    let text = std::fs::read_to_string("www/problems/eight-by-eight.json").unwrap();
    let document = Document::parse(&text).unwrap();
    let problem = document.problem().unwrap();
    let plan = Plan::from_names(problem.task(), &[] as &[&str]).unwrap();
    let report = TraceReport::overview(&problem, &plan, 1).unwrap();
    assert_eq!(
        serde_json::to_value(&report.steps[0].ruled_out).unwrap(),
        serde_json::json!({"adversarial": [], "cooperative": []})
    );
}
