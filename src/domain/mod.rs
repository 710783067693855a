//! The domains: formats of problem documents, one folder each.
//!
//! Each folder holds what its documents say (the struct, which is also how they are written), how
//! they are read, how a problem is made of them, and how a random one is drawn. Domains know no
//! solver.

pub mod box_pushing;
pub mod delivery;
#[cfg(feature = "full")]
mod drawable;
pub mod explicit;
pub mod generate;
pub mod grid;
pub mod gridworld;
mod observers;
#[cfg(feature = "full")]
pub mod pddl;
pub mod recycling_robot;
#[cfg(all(feature = "full", not(target_arch = "wasm32")))]
pub mod schema;

use serde::Serialize;

pub use box_pushing::BoxPushing;
pub use delivery::Delivery;
pub use explicit::Explicit;
pub use gridworld::Gridworld;
pub use observers::Observers;
#[cfg(feature = "full")]
pub use pddl::Pddl;
pub use recycling_robot::RecyclingRobot;

use crate::document::DocumentError;
use crate::document::json::Json;
use crate::document::reader::Reader;
use crate::problem::Problem;

/// The key of a document under which an exercise stands. The problem does not depend on it.
pub const EXERCISE: &str = "exercise";

/// A problem document of any format.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "format", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Document {
    /// Cells, walls and moves.
    Gridworld(Gridworld),
    /// A robot that turns, moves and pushes a box.
    BoxPushing(BoxPushing),
    /// A robot with a battery, a can and bins.
    RecyclingRobot(RecyclingRobot),
    /// Figure 1 of the paper: factories, packages, a truck.
    Delivery(Delivery),
    /// States and transitions one by one.
    Explicit(Explicit),
    /// A task in PDDL, with sensors by rule.
    #[cfg(feature = "full")]
    Pddl(Pddl),
}

impl From<Gridworld> for Document {
    fn from(document: Gridworld) -> Self {
        Self::Gridworld(document)
    }
}

impl From<BoxPushing> for Document {
    fn from(document: BoxPushing) -> Self {
        Self::BoxPushing(document)
    }
}

impl From<RecyclingRobot> for Document {
    fn from(document: RecyclingRobot) -> Self {
        Self::RecyclingRobot(document)
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

#[cfg(feature = "full")]
impl From<Pddl> for Document {
    fn from(document: Pddl) -> Self {
        Self::Pddl(document)
    }
}

impl Document {
    /// Reads a document of any format. An exercise in it is no part of the problem: the module `exercise` reads it.
    ///
    /// # Errors
    ///
    /// [`DocumentError`] names the place, what was found and what was expected; without the feature
    /// `full`, a document in PDDL is [`DocumentError::NeedsFullCore`].
    ///
    /// ```
    /// use mo_copp::domain::Document;
    /// let error = Document::parse(r#"{"format": "chess"}"#).unwrap_err();
    /// assert_eq!(
    ///     error.to_string(),
    ///     r#"format: found "chess", expected gridworld, box-pushing, recycling-robot, delivery, explicit or pddl"#
    /// );
    /// ```
    pub fn parse(text: &str) -> Result<Self, DocumentError> {
        const EXPECTED: &str =
            "gridworld, box-pushing, recycling-robot, delivery, explicit or pddl";
        let json = Json::parse(text)?.without(EXERCISE);
        let reader = Reader::new(&json);
        let format = reader.entries()?.required("format", EXPECTED)?;
        let Json::Text(name) = format.value() else { return Err(format.expected(EXPECTED)) };
        match &**name {
            "gridworld" => Gridworld::read(&reader).map(Self::Gridworld),
            "box-pushing" => BoxPushing::read(&reader).map(Self::BoxPushing),
            "recycling-robot" => RecyclingRobot::read(&reader).map(Self::RecyclingRobot),
            "delivery" => Delivery::read(&reader).map(Self::Delivery),
            "explicit" => Explicit::read(&reader).map(Self::Explicit),
            #[cfg(not(feature = "full"))]
            "pddl" => Err(DocumentError::NeedsFullCore),
            #[cfg(feature = "full")]
            "pddl" => Pddl::read(&reader).map(Self::Pddl),
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
            Self::BoxPushing(pushing) => pushing.problem(),
            Self::RecyclingRobot(robot) => robot.problem(),
            Self::Delivery(delivery) => delivery.problem(),
            Self::Explicit(explicit) => explicit.problem(),
            #[cfg(feature = "full")]
            Self::Pddl(pddl) => pddl.problem(),
        }
    }

    /// The document as JSON text.
    pub fn to_json(&self) -> String {
        // Only texts, numbers and lists: writing them cannot fail.
        serde_json::to_string_pretty(self).unwrap_or_default()
    }
}
