//! Random problem documents, the same for the same seed everywhere.

use std::sync::Arc;

use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg32;
use thiserror::Error;

use super::Document;
#[cfg(feature = "full")]
pub use super::drawable::Domain;
use crate::problem::Problem;
use crate::task::StateSpace;

/// Why no document can be drawn.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum GenerateError {
    /// A size that makes no sense.
    #[error("{what}: found {found}, expected {expected}")]
    Shape {
        /// Which number.
        what: &'static str,
        /// What it is.
        found: String,
        /// What it should be.
        expected: String,
    },
    /// Every document drawn had a goal that cannot be reached.
    #[error("no solvable problem among {tries} drawn; fewer walls would help")]
    Unsolvable {
        /// How many were drawn.
        tries: u32,
    },
}

/// A random document, and how many were drawn and thrown away before it because their true goal
/// could not be reached. Every generator returns this.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Drawn<T = Document> {
    /// The document.
    pub document: T,
    /// How many were thrown away.
    pub redraws: u32,
}

impl<T: Into<Document>> Drawn<T> {
    /// The same as a document of any format.
    pub fn any(self) -> Drawn {
        Drawn { document: self.document.into(), redraws: self.redraws }
    }
}

/// How often a problem is drawn before giving up.
const MAX_TRIES: u32 = 1000;

/// The random numbers of a seed.
pub(super) fn random(seed: u64) -> impl Rng {
    Pcg32::seed_from_u64(seed)
}

/// Checks a number of a shape.
pub(super) fn in_range(
    what: &'static str,
    found: u32,
    range: std::ops::RangeInclusive<u32>,
) -> Result<(), GenerateError> {
    if range.contains(&found) {
        return Ok(());
    }
    let expected = format!("a whole number from {} to {}", range.start(), range.end());
    Err(GenerateError::Shape { what, found: found.to_string(), expected })
}

/// Takes `count` of the items at random, in random order.
pub(super) fn draw<T>(random: &mut impl Rng, items: &mut Vec<T>, count: usize) -> Vec<T> {
    (0..count.min(items.len()))
        .map(|_| items.swap_remove(random.random_range(0..items.len() as u32) as usize))
        .collect()
}

/// An initial belief: the start with others of the states at random, `count` in all, in order.
pub(super) fn draw_belief<S: Copy + Ord>(
    random: &mut impl Rng,
    start: S,
    states: &[S],
    count: u32,
) -> Vec<S> {
    let mut others = states.iter().copied().filter(|state| *state != start).collect();
    let mut belief = draw(random, &mut others, count as usize - 1);
    belief.push(start);
    belief.sort_unstable();
    belief
}

/// Draws until something comes that is solvable.
pub(super) fn until_solvable<T>(
    mut attempt: impl FnMut() -> Option<T>,
) -> Result<Drawn<T>, GenerateError> {
    for redraws in 0..MAX_TRIES {
        if let Some(document) = attempt() {
            return Ok(Drawn { document, redraws });
        }
    }
    Err(GenerateError::Unsolvable { tries: MAX_TRIES })
}

/// How many states are gone through before a goal counts as out of reach.
const MOST_STATES: usize = 1_000_000;

/// Whether the actor can reach its goal, breadth first.
pub(super) fn true_goal_is_reachable(problem: &Problem) -> bool {
    let task = problem.task();
    let mut space = StateSpace::new(Arc::clone(task));
    let mut next = space.intern(task.initial_state());
    loop {
        if task.satisfies(space.words(next), task.goal()) {
            return true;
        }
        space.expand(next);
        match space.after(next) {
            Some(state) if space.len() <= MOST_STATES => next = state,
            _ => return false,
        }
    }
}
