//! Writes a problem in code: a thief, a guard and an accomplice.
//!
//! The thief enters and takes the gold or the silver. The guard (the enemy) hears that something is
//! taken; the accomplice (the friend) sees what.
//!
//! `cargo run --example problem_in_code`

use std::error::Error;
use std::ops::ControlFlow;
use std::sync::Arc;

use mo_copp::problem::{Goal, Observer, Problem, Role, StateNaming};
use mo_copp::sensor::{Sensor, SensorBuilder};
use mo_copp::solver::{Options, Solver, solve};
use mo_copp::task::{Task, TaskBuilder};

fn main() -> Result<(), Box<dyn Error>> {
    let mut task = TaskBuilder::default();
    let (outside, inside) = (task.fact("outside"), task.fact("inside"));
    let (gold, silver) = (task.fact("has gold"), task.fact("has silver"));
    task.exclusive(vec![outside, inside]);
    task.operator("enter", &[outside], &[inside], &[outside]);
    task.operator("take gold", &[inside], &[gold], &[]);
    task.operator("take silver", &[inside], &[silver], &[]);
    let task = task.build(&[outside], &[gold])?;

    let goal = |name: &str, fact| Goal { name: name.to_owned(), condition: vec![fact] };
    let goals = vec![goal("gold", gold), goal("silver", silver)];
    let guard = sensor(&task, |action| if action == "enter" { "a door" } else { "a noise" })?;
    let accomplice = sensor(&task, |action| action)?;
    let observer = |name: &str, role, sensor| Observer {
        name: name.to_owned(),
        role,
        sensor: Arc::new(sensor),
        initial_belief: vec![task.initial_state().clone()].into(),
    };
    let observers = vec![
        observer("guard", Role::Adversarial, guard),
        observer("accomplice", Role::Cooperative, accomplice),
    ];
    let problem = Arc::new(Problem::new(task, goals, 0, observers, StateNaming::Facts)?);

    let outcome =
        solve(Arc::clone(&problem), Options::new(Solver::Exact), |_| ControlFlow::Continue(()))?;
    let plan = outcome.plan.ok_or("no plan")?;
    println!("plan: {}", plan.names(problem.task()).join(", "));
    println!("goal difference {}", outcome.goal_difference.unwrap_or_default());
    Ok(())
}

/// A sensor that reads a symbol off the name of each action.
fn sensor(task: &Task, symbol: impl Fn(&str) -> &str) -> Result<Sensor, Box<dyn Error>> {
    let mut sensor = SensorBuilder::new(task);
    for (id, operator) in task.operator_ids() {
        sensor.always(id, symbol(task.action_name(operator.action)));
    }
    Ok(sensor.build(task)?)
}
