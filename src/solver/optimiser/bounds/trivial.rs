//! The trivial bound: from the number of goals and what is asked alone.

use super::{Bound, Most};
use crate::limits::LimitReached;
use crate::solver::optimiser::space::Space;

/// Every goal survives for the enemies but those forbidden; for the friends none but the true one
/// and those required.
#[derive(Debug)]
pub(in crate::solver::optimiser) struct Trivial;

impl Bound for Trivial {
    fn name(&self) -> &'static str {
        "trivial"
    }

    fn most(&mut self, space: &mut Space) -> Result<Most, LimitReached> {
        let most = space.bounds.most_difference(space.problem());
        Ok(most.map_or(Most::Infeasible, Most::Value))
    }
}
