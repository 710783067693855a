//! `mo-copp encode`: prints an integer program.

use std::sync::Arc;

use mo_copp::solver::ip::{encode, lp_format};
use mo_copp::solver::{Horizon, Options, Solver};

use super::args::EncodeArgs;
use super::error::CliError;
use super::{LIMIT, NO_PLAN, input, note, print};

/// Prints the model; the exit code.
pub fn run(args: &EncodeArgs) -> Result<u8, CliError> {
    let problem = input::problem(&args.problem)?;
    let options = Options {
        encoding: args.encoding,
        horizon: Horizon::Steps(args.horizon),
        bounds: input::bounds(&args.bounds, &problem)?,
        ..Options::new(Solver::Ip)
    };
    options.check(&problem)?;
    match encode(Arc::clone(&problem), &options, args.horizon) {
        Ok(Some(encoded)) => {
            print(&lp_format::to_lp(&encoded.model))?;
            Ok(0)
        }
        Ok(None) => {
            let horizon = args.horizon;
            print(&lp_format::infeasible(&format!("there is no such plan of {horizon} actions")))?;
            note(&format!("infeasible: there is no such plan of {horizon} actions"));
            Ok(NO_PLAN)
        }
        Err(limit) => {
            note(&limit.to_string());
            Ok(LIMIT)
        }
    }
}
