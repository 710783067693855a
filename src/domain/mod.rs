//! The domains: formats of problem documents, one folder each.
//!
//! Each folder holds what its documents say (the struct, which is also how they are written), how
//! they are read, how a problem is made of them, and how a random one is drawn. Domains know no
//! solver.

pub mod delivery;
pub mod explicit;
pub mod generate;
pub mod grid;
pub mod gridworld;
mod observers;
pub mod pddl;

use serde::Serialize;

pub use delivery::Delivery;
pub use explicit::Explicit;
pub use gridworld::Gridworld;
pub use observers::Observers;
pub use pddl::Pddl;

use crate::document::DocumentError;
use crate::document::json::Json;
use crate::document::reader::Reader;
use crate::problem::Problem;

/// A problem document of any format.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "format", rename_all = "kebab-case")]
pub enum Document {
    /// Cells, walls and moves.
    Gridworld(Gridworld),
    /// Figure 1 of the paper: factories, packages, a truck.
    Delivery(Delivery),
    /// States and transitions one by one.
    Explicit(Explicit),
    /// A task in PDDL, with sensors by rule.
    Pddl(Pddl),
}

impl From<Gridworld> for Document {
    fn from(document: Gridworld) -> Self {
        Self::Gridworld(document)
    }
}

impl From<Delivery> for Document {
    fn from(document: Delivery) -> Self {
        Self::Delivery(document)
    }
}

impl From<Explicit> for Document {
    fn from(document: Explicit) -> Self {
        Self::Explicit(document)
    }
}

impl From<Pddl> for Document {
    fn from(document: Pddl) -> Self {
        Self::Pddl(document)
    }
}

impl Document {
    /// Reads a document of any format.
    ///
    /// # Errors
    ///
    /// [`DocumentError`] names the place, what was found and what was expected.
    ///
    /// ```
    /// use mo_copp::domain::Document;
    /// let error = Document::parse(r#"{"format": "chess"}"#).unwrap_err();
    /// assert_eq!(
    ///     error.to_string(),
    ///     r#"format: found "chess", expected gridworld, delivery, explicit or pddl"#
    /// );
    /// ```
    pub fn parse(text: &str) -> Result<Self, DocumentError> {
        const EXPECTED: &str = "gridworld, delivery, explicit or pddl";
        let json = Json::parse(text)?;
        let reader = Reader::new(&json);
        let format = reader.entries()?.required("format", EXPECTED)?;
        match format.value() {
            Json::Text(name) if name == "gridworld" => {
                Gridworld::read(&reader).map(Self::Gridworld)
            }
            Json::Text(name) if name == "delivery" => Delivery::read(&reader).map(Self::Delivery),
            Json::Text(name) if name == "explicit" => Explicit::read(&reader).map(Self::Explicit),
            Json::Text(name) if name == "pddl" => Pddl::read(&reader).map(Self::Pddl),
            _ => Err(format.expected(EXPECTED)),
        }
    }

    /// The problem a document describes.
    ///
    /// # Errors
    ///
    /// [`DocumentError`] names the place of what does not fit together.
    pub fn problem(&self) -> Result<Problem, DocumentError> {
        match self {
            Self::Gridworld(gridworld) => gridworld.problem(),
            Self::Delivery(delivery) => delivery.problem(),
            Self::Explicit(explicit) => explicit.problem(),
            Self::Pddl(pddl) => pddl.problem(),
        }
    }

    /// The document as JSON text.
    pub fn to_json(&self) -> String {
        // Only texts, numbers and lists: writing them cannot fail.
        serde_json::to_string_pretty(self).unwrap_or_default()
    }
}
