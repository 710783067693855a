//! `mo-copp encode`: prints an integer program.

use std::sync::Arc;

use mo_copp::solver::{Horizon, Options, Solver, lp_format};

use super::args::EncodeArgs;
use super::error::CliError;
use super::{LIMIT, NO_PLAN, input, note, print};

/// Prints the model; the exit code.
pub fn run(args: &EncodeArgs) -> Result<u8, CliError> {
    let problem = input::problem(&args.problem)?;
    let mut options = Options::new(Solver::Ip)
        .with_encoding(args.encoding)
        .with_horizon(Horizon::Steps(args.horizon))
        .with_bounds(input::bounds(&args.bounds, &problem)?);
    options.cost_limit = args.cost_limit;
    options.check(&problem)?;
    match lp_format(Arc::clone(&problem), &options, args.horizon) {
        Ok(program) => {
            print(&program.text)?;
            if program.may_be_solved {
                return Ok(0);
            }
            let horizon = args.horizon;
            note(&format!("infeasible: there is no such plan of {horizon} actions"));
            Ok(NO_PLAN)
        }
        Err(limit) => {
            note(&limit.to_string());
            Ok(LIMIT)
        }
    }
}
