//! Setters of options: each gives the same options with one part changed.

use super::options::{Bounds, Encoding, Horizon, Options, Watched};
use crate::limits::Limits;

impl Options {
    /// The same with this integer program, for [`Solver::Ip`](super::Solver::Ip).
    #[must_use]
    pub fn with_encoding(mut self, encoding: Encoding) -> Self {
        self.encoding = encoding;
        self
    }

    /// The same with this length of plans.
    #[must_use]
    pub fn with_horizon(mut self, horizon: Horizon) -> Self {
        self.horizon = horizon;
        self
    }

    /// The same with a horizon that is raised by this many actions while it has no plan.
    #[must_use]
    pub fn with_horizon_step(mut self, step: usize) -> Self {
        self.horizon_step = step;
        self
    }

    /// The same with a horizon that is raised up to this many actions.
    #[must_use]
    pub fn with_horizon_limit(mut self, limit: usize) -> Self {
        self.horizon_limit = limit;
        self
    }

    /// The same with these bounds on the final beliefs.
    #[must_use]
    pub fn with_bounds(mut self, bounds: Bounds) -> Self {
        self.bounds = bounds;
        self
    }

    /// The same, with every reachable pair of survivor counts or without.
    #[must_use]
    pub fn with_pairs(mut self, pairs: bool) -> Self {
        self.pairs = pairs;
        self
    }

    /// The same with the best plan of each length up to this one.
    #[must_use]
    pub fn with_lengths(mut self, longest: usize) -> Self {
        self.lengths = Some(longest);
        self
    }

    /// The same for plans that cost at most this much, or have at most that number of actions where the task has
    /// no costs.
    #[must_use]
    pub fn with_cost_limit(mut self, limit: u64) -> Self {
        self.cost_limit = Some(limit);
        self
    }

    /// The same with these limits.
    #[must_use]
    pub fn with_limits(mut self, limits: Limits) -> Self {
        self.limits = limits;
        self
    }
}

impl Bounds {
    /// The same with at least k goals that survive for every enemy.
    #[must_use]
    pub fn with_at_least(mut self, k: usize) -> Self {
        self.at_least = Some(k);
        self
    }

    /// The same with at most j goals that survive for every friend.
    #[must_use]
    pub fn with_at_most(mut self, j: usize) -> Self {
        self.at_most = Some(j);
        self
    }

    /// The same with goals that must survive.
    #[must_use]
    pub fn with_required(mut self, required: Vec<Watched>) -> Self {
        self.required = required;
        self
    }

    /// The same with goals that must not survive.
    #[must_use]
    pub fn with_forbidden(mut self, forbidden: Vec<Watched>) -> Self {
        self.forbidden = forbidden;
        self
    }
}
