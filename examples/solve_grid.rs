//! Solves a grid: the best plan of any length, proved, and what each observer makes of it.
//!
//! `cargo run --example solve_grid`

use std::error::Error;
use std::ops::ControlFlow;
use std::sync::Arc;

use mo_copp::domain::Document;
use mo_copp::solver::{Options, Solver, solve};

fn main() -> Result<(), Box<dyn Error>> {
    let document = Document::parse(include_str!("gridworld.json"))?;
    let problem = Arc::new(document.problem()?);
    let outcome =
        solve(Arc::clone(&problem), Options::new(Solver::Exact), |_| ControlFlow::Continue(()))?;
    let plan = outcome.plan.ok_or("no plan")?;
    println!("{}: {}", outcome.status.name(), plan.names(problem.task()).join(", "));
    for (observer, survivors) in problem.observers().iter().zip(outcome.survivors.iter().flatten())
    {
        let names = survivors.iter().map(|goal| problem.goals()[goal].name.as_str());
        println!("{} holds possible: {}", observer.name, names.collect::<Vec<_>>().join(", "));
    }
    println!("goal difference {}", outcome.goal_difference.unwrap_or_default());
    Ok(())
}
