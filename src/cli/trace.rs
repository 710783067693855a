//! `mo-copp trace`: replays a plan and prints each step.

use std::fmt::Write;

use mo_copp::plan::Plan;
use mo_copp::problem::Problem;
use mo_copp::report::TraceReport;
use mo_copp::task::Task;
use mo_copp::trace::{Trace, trace};

use super::args::TraceArgs;
use super::error::CliError;
use super::{NO_PLAN, input, print, print_json, visible};

/// Believed states shown in text.
const STATES_SHOWN: usize = 6;

/// Replays and prints; the exit code.
pub fn run(args: &TraceArgs) -> Result<u8, CliError> {
    let problem = input::problem(&args.problem)?;
    let names: Vec<String> = match (&args.plan, &args.plan_file) {
        (Some(plan), _) => split(plan, ','),
        // Other planners write what they found about a plan as comments of PDDL.
        (None, Some(file)) => {
            let mut lines = split(&input::text(file)?, '\n');
            let task = problem.task();
            lines.retain(|line| !line.starts_with(';') || task.action_named(line).is_some());
            lines
        }
        (None, None) => Vec::new(),
    };
    let names: Vec<String> = names.iter().map(|name| as_known(problem.task(), name)).collect();
    let plan = Plan::from_names(problem.task(), &names)?;
    let trace = trace(&problem, &plan)?;
    if args.json {
        let report = TraceReport::new(&problem, &trace);
        print_json(&report)?;
    } else {
        print(&visible(&text(&problem, &trace)))?;
    }
    Ok(if trace.reaches_goal { 0 } else { NO_PLAN })
}

/// The name as the task has it: operators of PDDL may be given in capitals, with more blanks and
/// without parentheses.
fn as_known(task: &Task, name: &str) -> String {
    let bare = name.trim_matches(['(', ')']).to_lowercase();
    let words: Vec<&str> = bare.split_whitespace().collect();
    let in_pddl = format!("({})", words.join(" "));
    let is_known = |name: &str| task.action_named(name).is_some();
    if !is_known(name) && is_known(&in_pddl) { in_pddl } else { name.to_owned() }
}

fn split(text: &str, between: char) -> Vec<String> {
    text.split(between).map(str::trim).filter(|name| !name.is_empty()).map(str::to_owned).collect()
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
    let _ = writeln!(text, "the plan {end} the true goal {goal}");
    let _ = writeln!(text, "goal difference: {:.3}", trace.goal_difference(problem));
    text
}
