//! Final beliefs: whether they keep the bounds.

use crate::problem::{JointSpace, ProfileId, SurvivorCounts};
use crate::solver::Bounds;

/// Whether a plan may end with a profile. Looks at the sets of survivors only where the bounds name
/// goals.
pub(in crate::solver) fn allowed(
    joint: &mut JointSpace,
    bounds: &Bounds,
    profile: ProfileId,
    counts: SurvivorCounts,
) -> bool {
    if bounds.required.is_empty() && bounds.forbidden.is_empty() {
        return bounds.allow(counts, &[]);
    }
    let sets = joint.survivor_sets(profile);
    bounds.allow(counts, &sets)
}
