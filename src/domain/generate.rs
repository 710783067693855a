//! Random problem documents, the same for the same seed everywhere.

use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg32;
use thiserror::Error;

/// Why no document can be drawn.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
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

/// A document and how many were drawn and thrown away before it because their true goal could not
/// be reached.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Generated<T> {
    /// The document.
    pub document: T,
    /// How many were thrown away.
    pub redrawn: u32,
}

/// How often a problem is drawn before giving up.
pub(super) const MAX_TRIES: u32 = 1000;

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
