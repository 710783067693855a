//! Plans: actions of a problem put in, left out, doubled and changed for others.

use std::sync::Arc;

use mo_copp::domain::Document;
use mo_copp::plan::{Plan, next_actions};
use mo_copp::problem::Problem;
use mo_copp::trace::{trace, validate};

use crate::dice::Dice;
use crate::{Target, json, lists, repository_documents, shape};

/// An input is the number of a problem and a plan, one action a line.
pub struct Plans {
    problems: Vec<Arc<Problem>>,
}

impl Plans {
    pub fn new() -> Self {
        let documents = repository_documents();
        let problems = documents
            .iter()
            .map(|text| Arc::new(Document::parse(text).unwrap().problem().unwrap()))
            .collect();
        Self { problems }
    }

    /// The problem, and the lines of the plan.
    fn read<'a>(&self, input: &'a str) -> (&Arc<Problem>, Vec<&'a str>) {
        let mut lines = input.lines();
        let number: usize = lines.next().and_then(|line| line.parse().ok()).unwrap_or(0);
        (&self.problems[number % self.problems.len()], lines.collect())
    }
}

impl Target for Plans {
    fn name(&self) -> &'static str {
        "plans"
    }

    fn seeds(&self) -> Vec<String> {
        (0..self.problems.len()).map(|number| number.to_string()).collect()
    }

    fn changed(&self, dice: &mut Dice, input: &str, other: &str) -> String {
        if dice.percent(5) {
            return json::bytes(dice, input);
        }
        let (problem, lines) = self.read(input);
        let mut lines: Vec<String> = lines.into_iter().map(str::to_owned).collect();
        let number = input.lines().next().unwrap_or("0").to_owned();
        // Mostly an action that can be done next, so that plans get long.
        let plan = Plan::from_names(problem.task(), &lines).ok();
        let next = plan.and_then(|plan| {
            next_actions(problem.task(), &plan, |words| problem.label(words).to_string()).ok()
        });
        let names: Vec<String> = next
            .map(|next| {
                next.iter().map(|one| problem.task().action_name(one.action).to_owned()).collect()
            })
            .unwrap_or_default();
        if !names.is_empty() && dice.percent(70) {
            lines.push(names[dice.below(names.len())].clone());
        } else {
            let others: Vec<_> = other.lines().collect();
            let given = if others.is_empty() { "" } else { others[dice.below(others.len())] };
            lists::change(dice, &mut lines, given.to_owned());
        }
        format!("{number}\n{}", lines.join("\n"))
    }

    fn behaviour(&self, input: &str) -> String {
        let (problem, lines) = self.read(input);
        let number = self.problems.iter().position(|one| Arc::ptr_eq(one, problem)).unwrap_or(0);
        format!("problem {number}: {}", carried_out(problem, &lines))
    }
}

fn carried_out(problem: &Problem, lines: &[&str]) -> String {
    let plan = match Plan::from_names(problem.task(), lines) {
        Ok(plan) => plan,
        Err(error) => return shape(&error.to_string()),
    };
    let traced = match trace(problem, &plan) {
        Ok(traced) => traced,
        Err(error) => return shape(&error.to_string()),
    };
    let difference = traced.goal_difference(problem);
    match validate(problem, &plan) {
        Ok(_) => {
            // The true goal survives for both: that is what keeps it in these bounds.
            assert!((-1.0..=1.0).contains(&difference), "{difference}");
            format!("{} actions, {difference}", plan.len())
        }
        Err(error) => format!("{} actions, {}", plan.len(), shape(&error.to_string())),
    }
}
