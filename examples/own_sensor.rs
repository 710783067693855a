//! Gives the enemy a sensor of its own: it sees nothing but whether the agent is in the top row.
//!
//! `cargo run --example own_sensor`

use std::error::Error;
use std::ops::ControlFlow;
use std::sync::Arc;

use mo_copp::domain::Document;
use mo_copp::problem::{Problem, Role};
use mo_copp::sensor::SensorBuilder;
use mo_copp::solver::{Options, Solver, solve};
use mo_copp::task::Task;

fn main() -> Result<(), Box<dyn Error>> {
    let read = Document::parse(include_str!("gridworld.json"))?.problem()?;
    let task = read.task();
    // The facts of a grid say in which cell the agent is; these are the ones of row 0.
    let top: Vec<_> = task.facts().filter(|&fact| task.fact_name(fact).ends_with(",0")).collect();
    let mut sensor = SensorBuilder::new(task);
    for (id, _) in task.operator_ids() {
        for &fact in &top {
            sensor.when(id, &[fact], "in the top row");
        }
        sensor.always(id, "elsewhere");
    }
    let sensor = Arc::new(sensor.build(task)?);

    let mut observers = read.observers().to_vec();
    for observer in observers.iter_mut().filter(|observer| observer.role == Role::Adversarial) {
        observer.sensor = Arc::clone(&sensor);
    }
    let (goals, true_goal) = (read.goals().to_vec(), read.true_goal());
    let problem =
        Problem::new(Task::clone(task), goals, true_goal, observers, read.naming().clone())?;
    let outcome =
        solve(Arc::new(problem), Options::new(Solver::Exact), |_| ControlFlow::Continue(()))?;
    println!(
        "{}: goal difference {}",
        outcome.status.name(),
        outcome.goal_difference.unwrap_or_default()
    );
    Ok(())
}
