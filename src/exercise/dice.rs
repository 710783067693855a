//! Draws by number, the same on every machine.

use rand::{Rng, RngExt};

/// A number below another; none where there is none.
pub(super) fn below(random: &mut impl Rng, count: usize) -> Option<usize> {
    let count = u32::try_from(count).ok().filter(|&count| count > 0)?;
    Some(random.random_range(0..count) as usize)
}

/// Takes this many at random.
pub(super) fn take<T>(random: &mut impl Rng, among: &mut Vec<T>, count: usize) -> Option<Vec<T>> {
    (0..count).map(|_| Some(among.swap_remove(below(random, among.len())?))).collect()
}
