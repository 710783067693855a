//! Compares the solvers on one problem, under the same bounds.
//!
//! `cargo run --example compare_solvers`

use std::error::Error;
use std::ops::ControlFlow;
use std::sync::Arc;

use mo_copp::domain::Document;
use mo_copp::solver::{Bounds, Options, Solver, solve};

fn main() -> Result<(), Box<dyn Error>> {
    let problem = Arc::new(Document::parse(include_str!("gridworld.json"))?.problem()?);
    // At least two goals are left to the enemy, at most two to the friend.
    let bounds = Bounds::default().with_at_least(2).with_at_most(2);
    for solver in Solver::ALL {
        let options = Options::new(solver).with_bounds(bounds.clone());
        let outcome = solve(Arc::clone(&problem), options, |_| ControlFlow::Continue(()))?;
        let length = outcome.plan.as_ref().map(mo_copp::plan::Plan::len);
        println!(
            "{:11} {:8} goal difference {:5} {:>2} actions",
            solver.name(),
            outcome.status.name(),
            outcome.goal_difference.unwrap_or(f64::NAN),
            length.unwrap_or_default()
        );
    }
    Ok(())
}
