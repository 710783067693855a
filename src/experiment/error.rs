//! What can go wrong in an experiment.

use thiserror::Error;

use crate::document::DocumentError;
use crate::domain::generate::GenerateError;
use crate::solver::SolveError;

/// Why an experiment cannot go on.
#[derive(Debug, Error)]
pub enum ExperimentError {
    /// An option that makes no sense.
    #[error("{option}: found {found}, expected {expected}")]
    Choice {
        /// Which.
        option: &'static str,
        /// What was given.
        found: String,
        /// What would do.
        expected: String,
    },
    /// A file or folder that cannot be read or written.
    #[error("{file}: {error}")]
    File {
        /// Its name.
        file: String,
        /// What the system says.
        error: std::io::Error,
    },
    /// A file of records that another run is writing.
    #[error("{file}: another run is writing this file; wait for its end or choose another --out")]
    InUse {
        /// Its name.
        file: String,
    },
    /// A line of a file of records that is none of this run.
    #[error("{file}, line {line}: found {found}, expected {expected}")]
    Line {
        /// The file's name.
        file: String,
        /// The line, from 1.
        line: usize,
        /// What it says.
        found: String,
        /// What it should say.
        expected: String,
    },
    /// Records that are not there.
    #[error(
        "{missing} of {all} records are missing, the first of them: {first}; run what is missing, \
         then merge again"
    )]
    Incomplete {
        /// How many.
        missing: usize,
        /// Of how many.
        all: usize,
        /// One of them, and where it belongs.
        first: String,
    },
    /// A problem that cannot be drawn.
    #[error("{domain}, seed {seed}: {error}")]
    Draw {
        /// The domain.
        domain: &'static str,
        /// The seed.
        seed: u64,
        /// Why.
        error: GenerateError,
    },
    /// A drawn problem that is not well-formed.
    #[error("{domain}, seed {seed}: {error}")]
    Document {
        /// The domain.
        domain: &'static str,
        /// The seed.
        seed: u64,
        /// Why.
        error: DocumentError,
    },
    /// A solver that broke down.
    #[error("{domain}, seed {seed}, {solver}: {error}")]
    Solve {
        /// The domain.
        domain: &'static str,
        /// The seed.
        seed: u64,
        /// The solver.
        solver: &'static str,
        /// Why.
        error: SolveError,
    },
    /// A figure that cannot be drawn.
    #[error("the figure {name} cannot be drawn: {reason}")]
    Figure {
        /// Its file.
        name: String,
        /// Why.
        reason: String,
    },
}

impl ExperimentError {
    /// An option that makes no sense.
    pub fn choice(
        option: &'static str,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) -> Self {
        Self::Choice { option, found: found.into(), expected: expected.into() }
    }

    pub(super) fn file(file: &std::path::Path, error: std::io::Error) -> Self {
        Self::File { file: file.display().to_string(), error }
    }
}
