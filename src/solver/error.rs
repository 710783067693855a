//! Why a run cannot give an answer.

use thiserror::Error;

use super::OptionsError;

/// Why a run cannot give an answer.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SolveError {
    /// The options do not fit the problem.
    #[error(transparent)]
    Options(#[from] OptionsError),
    /// A plan did not pass its replay. A defect of this program: please report it.
    #[error("internal error: a plan failed its replay: {0}")]
    Replay(String),
    /// What a plan achieves takes too much memory to work out; nothing is wrong with it.
    #[error("the beliefs on a plan's way take too much memory")]
    TooLargeToReplay,
    /// A solver that only the crate with its feature `full` has. Nothing is wrong with the options.
    #[error("this needs the full core, with the feature \"full\"")]
    NeedsFullCore,
}
