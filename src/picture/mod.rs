//! Pictures: the boards of a step, or of a whole plan, as SVG.
//!
//! A picture shows what the page shows: the agent's board and, for each observer, the belief `B_t`
//! after the step (Section 2 of the paper) with the candidate goals that survive in it. It is one text
//! without references to anything outside of it: fonts are the reader's own, colours stand in
//! the text, names of the document are escaped. Command, page and JavaScript draw with this module, so
//! that the same document, plan and step give the same text everywhere. Natively [`png`] makes pixels of it.
//!
//! ```
//! use mo_copp::domain::{Delivery, Document};
//! use mo_copp::picture::{PictureOptions, draw};
//! use mo_copp::plan::Plan;
//! let document = Document::from(Delivery::figure_1());
//! let problem = document.problem()?;
//! let plan = Plan::from_names(problem.task(), &["load a1", "load a2", "deliver"])?;
//! let svg = draw(&document, &problem, &plan, &PictureOptions::step(3))?;
//! assert!(svg.starts_with("<svg") && svg.contains("Goal difference 1"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod boards;
mod cells;
mod delivery;
mod floor;
mod goals;
mod listing;
mod palette;
#[cfg(not(target_arch = "wasm32"))]
pub mod png;
mod request;
mod sheet;
mod signs;
mod svg;
mod things;

use thiserror::Error;

use crate::domain::Document;
use crate::plan::{Plan, PlanError};
use crate::problem::Problem;
use crate::report::{Scene, TraceReport};

pub use palette::Theme;
pub use request::read_picture_options;

/// Which boards a picture shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Boards {
    /// The agent's board and those of all observers.
    #[default]
    All,
    /// The agent's alone.
    Actor,
    /// One observer's alone, by its place in the problem.
    Observer(usize),
}

/// Which steps of the plan a picture shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Steps {
    /// One step; 0 is the start.
    One(usize),
    /// All steps, one after another, without end.
    Animated {
        /// How long each step is shown, in milliseconds; from 100 to 60,000.
        milliseconds: u32,
    },
}

/// What a picture looks like.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each stands for itself, as the flags of the command do"
)]
pub struct PictureOptions {
    /// The steps.
    pub steps: Steps,
    /// The boards.
    pub boards: Boards,
    /// Whether headings, the list of goals and the line about the step are there; without them a picture is
    /// its boards alone.
    pub captions: bool,
    /// Whether the true goal is marked as such.
    pub true_goal: bool,
    /// Whether the agent stops where the plan ends. Else it may go on: nothing is ruled out, and no difference is told.
    pub ended: bool,
    /// Whether boards of cells have the numbers of columns and rows at their edges.
    pub numbers: bool,
    /// Light or dark.
    pub theme: Theme,
}

impl PictureOptions {
    /// All boards of one step with captions, light.
    pub fn step(step: usize) -> Self {
        Self {
            steps: Steps::One(step),
            boards: Boards::All,
            captions: true,
            true_goal: true,
            ended: true,
            numbers: false,
            theme: Theme::Light,
        }
    }

    /// All boards of all steps, each shown so long, with captions, light.
    pub fn animated(milliseconds: u32) -> Self {
        Self { steps: Steps::Animated { milliseconds }, ..Self::step(0) }
    }
}

/// Why there is no picture.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum PictureError {
    /// The plan cannot be carried out.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The plan has no such step.
    #[error(
        "step: found {found}, expected a whole number from 0 to {last}, the length of the plan"
    )]
    Step {
        /// The step asked for.
        found: usize,
        /// The last there is.
        last: usize,
    },
    /// The problem has no such observer.
    #[error("board: found observer {found}, expected a whole number from 0 to {last}")]
    Observer {
        /// The observer asked for.
        found: usize,
        /// The last there is.
        last: usize,
    },
    /// A time outside of what an animation takes.
    #[error("milliseconds: found {found}, expected a whole number from 100 to 60000")]
    Milliseconds {
        /// The time asked for.
        found: u32,
    },
    /// An animation that would be too large to be of use.
    #[error(
        "the animation would have {found} characters, more than {most}: a shorter plan or one board alone is smaller"
    )]
    TooLarge {
        /// How large it is.
        found: usize,
        /// How large it may be.
        most: usize,
    },
}

/// The side of a board, in units of the picture.
const SIDE: f64 = 360.0;

/// The most characters of an animation.
const MOST_CHARACTERS: usize = 32 << 20;

/// The most states of a belief that a board lists one by one.
const LISTED_STATES: usize = 64;

/// Draws a plan of the problem that the document describes.
///
/// Linear in the replay (see [`crate::trace::pass`]) and in the text that comes out.
///
/// # Errors
///
/// [`PictureError`] where the plan cannot be carried out, or has no such step, the problem no such observer, or
/// the picture would be too large.
pub fn draw(
    document: &Document,
    problem: &Problem,
    plan: &Plan,
    options: &PictureOptions,
) -> Result<String, PictureError> {
    if let Boards::Observer(found) = options.boards
        && found >= problem.observers().len()
    {
        return Err(PictureError::Observer { found, last: problem.observers().len() - 1 });
    }
    if let Steps::One(found) = options.steps
        && found > plan.len()
    {
        return Err(PictureError::Step { found, last: plan.len() });
    }
    let mut scene = Scene::new(document, problem);
    if !options.true_goal {
        // No goal has this name.
        scene.true_goal.clear();
    }
    let trace = TraceReport::overview(problem, plan, LISTED_STATES)?;
    let sheet = sheet::Sheet::new(&scene, document, &trace, options);
    match options.steps {
        Steps::One(step) => Ok(sheet.still(step)),
        Steps::Animated { milliseconds } if (100..=60_000).contains(&milliseconds) => {
            sheet.animated(milliseconds, MOST_CHARACTERS)
        }
        Steps::Animated { milliseconds } => Err(PictureError::Milliseconds { found: milliseconds }),
    }
}
