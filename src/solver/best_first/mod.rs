//! Greedy best-first search: one loop, and the spaces it searches.
//!
//! - [`engine`] is the loop: it opens the node with the least heuristic value, the older one of two
//!   equals (in the baseline also the newer one where nothing gets better for long), and may put
//!   nodes off to a later round,
//! - [`baseline`] searches states for the true goal alone,
//! - [`search`] searches states with beliefs for a plan that keeps the bounds (Algorithm 1), also
//!   with one of the bounds alone (obfuscate, legible),
//! - [`sketches`] is as much of the beliefs as the search has to see,
//! - [`patience`] is that search with an end to its patience, where other means say more,
//! - [`approximation`] picks the approximate beliefs by which Algorithm 1 tells nodes apart.

pub mod approximation;
pub mod baseline;
pub mod engine;
pub mod patience;
pub mod search;
pub mod sketches;
