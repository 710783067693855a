//! Traces a plan: after each step what the observers saw, what they believe and which goals survive.
//!
//! `cargo run --example trace_plan`

use std::error::Error;

use mo_copp::domain::Document;
use mo_copp::plan::Plan;
use mo_copp::trace::trace;

fn main() -> Result<(), Box<dyn Error>> {
    let problem = Document::parse(include_str!("delivery.json"))?.problem()?;
    let task = problem.task();
    let plan = Plan::from_names(task, &["load a1", "load a2", "deliver"])?;
    let trace = trace(&problem, &plan)?;
    for (number, step) in trace.steps.iter().enumerate() {
        let action = step.action.map_or("(the start)", |action| task.action_name(action));
        println!("{number}. {action}");
        for (index, observer) in problem.observers().iter().enumerate() {
            println!(
                "   {:11} saw {}, believes {} states, {} goals survive",
                observer.name,
                step.symbols[index].as_deref().unwrap_or("nothing"),
                step.beliefs[index].len(),
                step.survivors[index].len()
            );
        }
    }
    println!("goal difference {}", trace.goal_difference(&problem));
    Ok(())
}
