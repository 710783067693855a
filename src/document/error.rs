//! What can be wrong with a document.

use thiserror::Error;

use super::json::quoted;

/// Why a document was refused. Nothing of it is kept.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum DocumentError {
    /// The text is not JSON.
    #[error("line {line}, column {column}: found {found}, expected {expected}")]
    Syntax {
        /// The line, from 1.
        line: usize,
        /// The column, from 1.
        column: usize,
        /// What stands there.
        found: String,
        /// What should.
        expected: String,
    },
    /// A text in PDDL inside of the document that cannot be read.
    #[error("{path}, line {line}, column {column}: found {found}, expected {expected}")]
    Pddl {
        /// Where the text stands, as in `goals[1].condition`.
        path: String,
        /// The line in the text, from 1.
        line: usize,
        /// The column, from 1.
        column: usize,
        /// What stands there.
        found: String,
        /// What should.
        expected: String,
    },
    /// A key that the format does not have.
    #[error("{path}: found the unknown key {}, expected only {known}", quoted(key))]
    UnknownKey {
        /// Where the object with the key stands, as in `observers.adversarial`.
        path: String,
        /// The key.
        key: String,
        /// The keys that may be there.
        known: String,
    },
    /// A value that does not fit.
    #[error("{path}: found {found}, expected {expected}")]
    Invalid {
        /// Where, as in `goals[1].cell`.
        path: String,
        /// What stands there.
        found: String,
        /// What should.
        expected: String,
    },
    /// A document that only the crate with its feature `full` reads. Nothing is wrong with it.
    #[error("this needs the full core, with the feature \"full\"")]
    NeedsFullCore,
}

impl DocumentError {
    /// A value that does not fit.
    pub fn invalid(
        path: impl Into<String>,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) -> Self {
        Self::Invalid { path: path.into(), found: found.into(), expected: expected.into() }
    }
}
