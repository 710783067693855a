//! Why there is no plan, and which change of a single option would allow one.
//!
//! A plan of a horizon T with bounds k and j can fail for three reasons: the true goal cannot be
//! reached, no plan has exactly T actions, or no such plan keeps the bounds. Each remedy changes one
//! of T, k and j by as little as will do; that less will not do is proved by exact search, unless a
//! limit came before the proof.
//!
//! - [`run`](RemedyRun) explores a small space to its end, and asks of others one question after the
//!   other,
//! - `next_horizons` tries the horizons next to the one asked for.

mod next_horizons;
mod run;

pub use run::RemedyRun;

use crate::plan::Plan;

/// Why there is no plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Reason {
    /// No plan reaches the true goal.
    Unreachable,
    /// Plans reach it, but none in exactly so many actions.
    Length,
    /// Plans of the horizon reach it, but none of them keeps the bounds.
    Bounds,
}

impl Reason {
    /// The name in output.
    pub fn name(self) -> &'static str {
        match self {
            Self::Unreachable => "unreachable",
            Self::Length => "length",
            Self::Bounds => "bounds",
        }
    }
}

/// The option to change. Of two changes by as much, the earlier one stands first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Change {
    /// Another number of actions.
    Horizon,
    /// Fewer goals that must survive for the enemy (k).
    AtLeast,
    /// More goals that may survive for the friend (j).
    AtMost,
}

impl Change {
    /// The name in output.
    pub fn name(self) -> &'static str {
        match self {
            Self::Horizon => "horizon",
            Self::AtLeast => "k",
            Self::AtMost => "j",
        }
    }
}

/// A change that allows a plan. All other options stay as they are.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Remedy {
    /// The option.
    pub change: Change,
    /// Its new value.
    pub value: usize,
    /// The goal difference of the plan.
    pub goal_difference: f64,
    /// The best plan then.
    pub plan: Plan,
}

/// Why there is no plan, and what would do.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Advice {
    /// Why; none where there is a plan after all, or the work stopped before that was known.
    pub reason: Option<Reason>,
    /// The length of a shortest plan for the true goal, whatever anybody believes; none where there
    /// is no such plan, or the work stopped before that was known.
    pub shortest: Option<usize>,
    /// The remedies, the smallest change first.
    pub remedies: Vec<Remedy>,
    /// Whether every remedy there is was found, and nothing nearer would do. Otherwise a limit or a
    /// cancel came before.
    pub complete: bool,
}
