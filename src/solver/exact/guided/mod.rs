//! Tables over pairs of states: [`twins`] can be led to a goal at once, [`doubts`] can be freed.

pub(super) mod doubts;
pub(super) mod steps;
pub(super) mod twins;
