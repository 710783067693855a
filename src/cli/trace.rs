//! `mo-copp trace`: replays a plan and prints each step.

use std::fmt::Write;

use mo_copp::problem::Problem;
use mo_copp::report::TraceReport;
use mo_copp::trace::{Trace, trace};

use super::args::TraceArgs;
use super::error::CliError;
use super::{NO_PLAN, input, plan_text, print, print_json, visible};

/// Believed states shown in text.
const STATES_SHOWN: usize = 6;

/// Replays and prints; the exit code.
pub fn run(args: &TraceArgs) -> Result<u8, CliError> {
    let problem = input::problem(&args.problem)?;
    let plan = plan_text::plan(&problem, args.plan.as_deref(), args.plan_file.as_deref())?;
    let trace = trace(&problem, &plan)?;
    if args.json {
        let report = TraceReport::new(&problem, &trace);
        print_json(&report)?;
    } else {
        print(&visible(&text(&problem, &trace)))?;
    }
    Ok(if trace.reaches_goal { 0 } else { NO_PLAN })
}

fn text(problem: &Problem, trace: &Trace) -> String {
    let mut text = String::new();
    for (number, step) in trace.steps.iter().enumerate() {
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
            let seen = match &step.symbols[index] {
                Some(symbol) => format!("saw {symbol}, "),
                None => String::new(),
            };
            let belief = &step.beliefs[index];
            let mut states: Vec<String> = belief
                .iter()
                .take(STATES_SHOWN)
                .map(|state| problem.label(state.words()).to_string())
                .collect();
            if belief.len() > STATES_SHOWN {
                states.push("…".to_owned());
            }
            let goals: Vec<&str> = step.survivors[index]
                .iter()
                .map(|goal| problem.goals()[goal].name.as_str())
                .collect();
            let plural = if belief.len() == 1 { "" } else { "s" };
            let _ = writeln!(
                text,
                "  {}: {seen}{} state{plural} ({}); goals left: {}",
                observer.name,
                belief.len(),
                states.join(" "),
                if goals.is_empty() { "none".to_owned() } else { goals.join(", ") }
            );
        }
    }
    let end = if trace.reaches_goal { "reaches" } else { "does not reach" };
    let goal = &problem.goals()[problem.true_goal()].name;
    let actions = trace.steps.iter().filter_map(|step| step.action).collect();
    if let Some(cost) = (mo_copp::plan::Plan { actions }).cost(problem.task()) {
        let _ = writeln!(text, "cost: {cost}");
    }
    let _ = writeln!(text, "the plan {end} the true goal {goal}");
    let _ = writeln!(text, "goal difference: {:.3}", trace.goal_difference(problem));
    text
}
