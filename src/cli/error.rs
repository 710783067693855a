//! What can go wrong between the command line and the library.

use mo_copp::document::DocumentError;
use mo_copp::domain::generate::GenerateError;
use mo_copp::domain::pddl::import::ImportError;
use mo_copp::exercise::ExerciseError;
use mo_copp::experiment::ExperimentError;
use mo_copp::limits::LimitReached;
use mo_copp::pddl::PddlError;
use mo_copp::picture::PictureError;
use mo_copp::picture::png::PngError;
use mo_copp::plan::PlanError;
use mo_copp::solver::{OptionsError, SolveError};
use thiserror::Error;

/// An error of the command, with the file it is about.
#[derive(Debug, Error)]
pub enum CliError {
    /// A file that cannot be read.
    #[error("{file}: {reason}")]
    Read {
        /// Its name, with line and column where the reason is about a place in it.
        file: String,
        /// Why.
        reason: String,
    },
    /// A file that cannot be written.
    #[error("{file}: cannot be written: {reason}")]
    Write {
        /// Its name.
        file: String,
        /// Why.
        reason: String,
    },
    /// A picture that cannot be drawn.
    #[error("{0}")]
    Picture(PictureError),
    /// A picture of which there is no PNG.
    #[error("{0}")]
    Png(#[from] PngError),
    /// A document that is wrong.
    #[error("{file}: {error}")]
    Document {
        /// The file's name, with line and column.
        file: String,
        /// What is wrong.
        error: DocumentError,
    },
    /// A PDDL text that is wrong.
    #[error("{file}: {error}")]
    Pddl {
        /// The file's name.
        file: String,
        /// What is wrong.
        error: PddlError,
    },
    /// An argument that does not fit the problem.
    #[error("{0}")]
    Options(#[from] OptionsError),
    /// A plan that cannot be carried out.
    #[error("the plan fails: {0}")]
    Plan(#[from] PlanError),
    /// Nothing can be generated.
    #[error("{0}")]
    Generate(#[from] GenerateError),
    /// Files that cannot be imported.
    #[error("{0}")]
    Import(#[from] ImportError),
    /// A solver broke down.
    #[error("{0}")]
    Solve(#[from] SolveError),
    /// A model that is too large to write.
    #[error("{0}")]
    Limit(#[from] LimitReached),
    /// An exercise without a variant of the seed.
    #[error("{0}")]
    Exercise(#[from] ExerciseError),
    /// An experiment that cannot go on.
    #[error("{0}")]
    Experiment(#[from] ExperimentError),
    /// A signal asked to stop before there was an answer.
    #[error("{}", LimitReached::Cancelled)]
    Stopped,
    /// A part of the program that panicked.
    #[error("a defect of this program, please report it: {what}")]
    Defect {
        /// What it said.
        what: String,
    },
    /// The output cannot be written.
    #[error("cannot write the output: {0}")]
    Output(std::io::Error),
}

impl From<PictureError> for CliError {
    fn from(error: PictureError) -> Self {
        match error {
            PictureError::Plan(error) => Self::Plan(error),
            error => Self::Picture(error),
        }
    }
}
