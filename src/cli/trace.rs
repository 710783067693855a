//! `mo-copp trace`: replays a plan and prints each step.

use std::fmt::Write;

use mo_copp::goal_difference::written;
use mo_copp::plan::{Plan, PlanError};
use mo_copp::problem::{Problem, StateLabel, SurvivorCounts};
use mo_copp::report::TraceReport;
use mo_copp::trace::{check_cost, pass, trace};

use super::args::TraceArgs;
use super::error::CliError;
use super::{NO_PLAN, input, plan_text, print, print_json, visible};

/// Believed states of each step in JSON where all of them are too many.
const STATES_OF_SUMMARY: usize = 64;

/// Believed states shown in text.
const STATES_SHOWN: usize = 6;

/// Replays and prints; the exit code.
pub fn run(args: &TraceArgs) -> Result<u8, CliError> {
    let problem = input::problem(&args.problem)?;
    let plan = plan_text::plan(&problem, args.plan.as_deref(), args.plan_file.as_deref())?;
    let within = check_cost(&problem, &plan, args.cost_limit);
    if args.json {
        let mut report = match trace(&problem, &plan) {
            Ok(trace) => TraceReport::new(&problem, &trace),
            // Too many states to list: what they have in common, and some of them.
            Err(PlanError::TooManyStates { .. }) => {
                TraceReport::overview(&problem, &plan, STATES_OF_SUMMARY)?
            }
            Err(error) => return Err(error.into()),
        };
        report.valid &= within.is_ok();
        print_json(&report)?;
        return Ok(if report.valid { 0 } else { NO_PLAN });
    }
    let (mut text, reaches_goal) = text(&problem, &plan)?;
    if let Err(error) = &within {
        // Writing to a text cannot fail.
        let _ = writeln!(text, "{error}");
    }
    print(&visible(&text))?;
    Ok(if reaches_goal && within.is_ok() { 0 } else { NO_PLAN })
}

/// The steps for people, and whether the plan ends in the true goal.
fn text(problem: &Problem, plan: &Plan) -> Result<(String, bool), PlanError> {
    let mut text = String::new();
    let mut number = 0;
    let mut counts = SurvivorCounts { adversarial: 0, cooperative: 0 };
    let reaches_goal = pass(problem, plan, |step| {
        // Writing to a text cannot fail.
        let _ = match step.action {
            None => writeln!(text, "start: {}", problem.label(step.state.words())),
            Some(action) => writeln!(
                text,
                "step {number}: {} to {}",
                problem.task().action_name(action),
                problem.label(step.state.words())
            ),
        };
        for (index, observer) in problem.observers().iter().enumerate() {
            let told = match &step.symbols[index] {
                Some(symbol) => format!("is told {symbol}, "),
                None => String::new(),
            };
            let belief = &step.beliefs[index];
            let states: Vec<StateLabel> = belief
                .some_states(STATES_SHOWN)
                .iter()
                .map(|state| problem.label(state.words()))
                .collect();
            let mut shown = StateLabel::list(&states);
            let count = belief.count();
            if count.as_f64() > STATES_SHOWN as f64 {
                shown.push_str("; …");
            }
            let goals: Vec<&str> = step.survivors[index]
                .iter()
                .map(|goal| problem.goals()[goal].name.as_str())
                .collect();
            let plural = if count.as_f64() == 1.0 { "" } else { "s" };
            let _ = writeln!(
                text,
                "  {}: {told}{count} state{plural} ({shown}); possible goals: {}",
                observer.name,
                // An agent that went on could make goals possible.
                if goals.is_empty() { "none yet".to_owned() } else { goals.join(", ") }
            );
        }
        number += 1;
        counts = problem.survivor_counts(step.survivors);
        Ok(())
    })?;
    let goal = &problem.goals()[problem.true_goal()].name;
    let difference = written(problem.goal_difference(counts), problem.goals().len());
    if let Some(cost) = plan.cost(problem.task()) {
        let _ = writeln!(text, "cost: {cost}");
    }
    if reaches_goal {
        let _ = writeln!(text, "the plan reaches the true goal {goal}");
        let _ = writeln!(text, "goal difference: {difference}");
    } else {
        let _ = writeln!(text, "the plan does not reach the true goal {goal}");
        let SurvivorCounts { adversarial, cooperative } = counts;
        let _ = writeln!(
            text,
            "if it stopped here: {adversarial} goals possible for the enemy, {cooperative} for the friend, \
             goal difference {difference}"
        );
    }
    Ok((text, reaches_goal))
}
