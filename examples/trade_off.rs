//! Shows the trade-off: every pair of goals left to the enemy and to the friend that plans can end
//! with, and a shortest plan for each.
//!
//! `cargo run --example trade_off`

use std::error::Error;
use std::ops::ControlFlow;
use std::sync::Arc;

use mo_copp::domain::Document;
use mo_copp::solver::{Options, Solver, solve};

fn main() -> Result<(), Box<dyn Error>> {
    let problem = Arc::new(Document::parse(include_str!("gridworld.json"))?.problem()?);
    let options = Options::new(Solver::Exact).with_pairs(true);
    let outcome = solve(Arc::clone(&problem), options, |_| ControlFlow::Continue(()))?;
    println!("enemy friend  GD    plan");
    for point in outcome.pairs.iter().flatten() {
        println!(
            "{:5} {:6}  {:.2}  {}",
            point.counts.adversarial,
            point.counts.cooperative,
            problem.goal_difference(point.counts),
            point.plan.names(problem.task()).join(", ")
        );
    }
    Ok(())
}
