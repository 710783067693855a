//! What can be done after a plan, against the tables.

use mo_copp::plan::{Plan, PlanError, next_actions};
use mo_copp::problem::Problem;

use crate::common::random::{self, MEDIUM, PAIR};
use crate::common::{Dice, Judge};

/// Action, resulting state and whether the true goal holds, by name.
fn offered(problem: &Problem, plan: &[String]) -> Result<Vec<(String, String, bool)>, PlanError> {
    let task = problem.task();
    let label = |words: &[u64]| problem.label(words).to_string();
    let next = next_actions(task, &Plan::from_names(task, plan)?, label)?;
    let named = next.iter().map(|next| {
        (task.action_name(next.action).to_owned(), label(next.state.words()), next.goal)
    });
    Ok(named.collect())
}

#[test]
fn every_applicable_action_is_offered_in_the_order_of_the_document() {
    let mut dice = Dice::new(60);
    let (mut walks, mut dead_ends) = (0, 0);
    for _ in 0..3000 {
        let judge = Judge::new(random::table(&mut dice, MEDIUM, &PAIR));
        let table = &judge.table;
        let mut plan = Vec::new();
        let mut state = table.start;
        for _ in 0..dice.below(6) {
            let found = offered(&judge.problem, &plan).unwrap();
            let mut expected: Vec<(String, String, bool)> = Vec::new();
            for (action, target) in table.next[state].iter().enumerate() {
                let name = |&to: &usize| {
                    (table.actions[action].clone(), table.states[to].clone(), table.is_goal(to))
                };
                expected.extend(target.as_ref().map(name));
            }
            assert_eq!(found, expected, "after {plan:?}");
            if found.is_empty() {
                dead_ends += 1;
                break;
            }
            walks += 1;
            let action = dice.pick(&(0..table.actions.len()).collect::<Vec<_>>());
            let Some(target) = table.next[state][action] else {
                plan.push(table.actions[action].clone());
                let refused = offered(&judge.problem, &plan).unwrap_err();
                assert!(matches!(refused, PlanError::NotApplicable { .. }), "{refused}");
                break;
            };
            plan.push(table.actions[action].clone());
            state = target;
        }
    }
    assert!(walks > 2000 && dead_ends > 100, "{walks} steps, {dead_ends} dead ends");
}

#[test]
fn a_plan_that_cannot_be_carried_out_is_refused_with_its_step() {
    let problem = mo_copp::domain::Delivery::figure_1().problem().unwrap();
    let plan = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect::<Vec<_>>();
    let refused = offered(&problem, &plan(&["load a1", "load a1"])).unwrap_err();
    assert!(refused.to_string().starts_with("step 2: found load a1, which is not applicable in"));
    let refused = offered(&problem, &plan(&["fly"])).unwrap_err();
    assert!(refused.to_string().starts_with("step 1: found \"fly\", expected an action"));
}
