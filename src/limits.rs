//! Limits: where work stops before memory or patience runs out.
//!
//! A limit is neither an error nor the answer that no plan exists. It counts contents (bytes,
//! expansions, nodes), never time, so that the same input stops at the same place.

use thiserror::Error;

/// The longest text that is read in bytes, a document or PDDL: 32 MiB natively, 8 MiB in wasm. All
/// that takes texts in, the page too, reads this number and has none of its own.
pub const MAX_TEXT_BYTES: usize = if cfg!(target_arch = "wasm32") { 8 << 20 } else { 32 << 20 };

/// What a text that is longer than [`MAX_TEXT_BYTES`] is told: what was found, and what was expected. Both to the byte,
/// since a text may be too long by one.
///
/// ```
/// use mo_copp::limits::{MAX_TEXT_BYTES, excess_of_text};
/// assert_eq!(excess_of_text(&" ".repeat(MAX_TEXT_BYTES)), None);
/// let (found, expected) = excess_of_text(&" ".repeat(MAX_TEXT_BYTES + 1)).unwrap();
/// assert_eq!(found, "33,554,433 bytes of text");
/// assert_eq!(expected, "at most 32 MiB (33,554,432 bytes)");
/// ```
pub fn excess_of_text(text: &str) -> Option<(String, String)> {
    let most = MAX_TEXT_BYTES;
    let expected = || format!("at most {} MiB ({} bytes)", most >> 20, grouped(most));
    (text.len() > most).then(|| (format!("{} bytes of text", grouped(text.len())), expected()))
}

/// A number with a comma before each three digits.
fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let groups = digits.as_bytes().rchunks(3).rev();
    let groups: Vec<_> = groups.map(String::from_utf8_lossy).collect();
    groups.join(",")
}

/// The most values (texts, numbers, lists, objects) of a document. A value takes 24 bytes where it
/// stands and at least 32 where it points to, and a list three times that while it grows, so that
/// `[[0],[0],…]` would take 40 times the memory of its text.
pub const MAX_VALUES: usize = if cfg!(target_arch = "wasm32") { 1_000_000 } else { 4_000_000 };

/// A limit that was met.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum LimitReached {
    /// The states, transitions, beliefs and search nodes take more memory than allowed.
    #[error("memory limit reached: {limit_mib} MiB of states, beliefs and nodes")]
    Memory {
        /// The limit in MiB (2²⁰ bytes).
        limit_mib: u64,
    },
    /// A belief outgrew its list where only lists were allowed.
    #[error("list limit reached: a belief of more than {limit} states")]
    Listed {
        /// The limit.
        limit: u64,
    },
    /// More nodes were expanded than allowed.
    #[error("expansion limit reached: {limit}")]
    Expansions {
        /// The limit.
        limit: u64,
    },
    /// More branch-and-bound nodes than allowed.
    #[error("node limit reached: {limit} branch-and-bound nodes")]
    Nodes {
        /// The limit.
        limit: u64,
    },
    /// An integer program larger than the solver takes.
    #[error(
        "model limit reached: the integer program would have more than {limit} nonzero coefficients"
    )]
    Model {
        /// The limit in nonzero coefficients.
        limit: u64,
    },
    /// The horizon was raised as far as allowed; nothing is known of longer plans.
    #[error("horizon limit reached: {limit} steps")]
    Horizon {
        /// The limit.
        limit: u64,
    },
    /// The integer programming solver gave up, or contradicted a plan that is known to be there.
    #[error("the integer programming solver failed for numerical reasons")]
    Numerical,
    /// Somebody asked for the work to stop.
    #[error("stopped on request")]
    Cancelled,
}

/// What a run may use.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct Limits {
    /// Bytes of states, transitions, beliefs and nodes, counted by contents. Containers that grow
    /// can hold up to three times as much for a moment, so the default is a third of what the
    /// process may take: 2 GiB natively, 512 MiB in wasm.
    pub bytes: u64,
    /// Expansions of an exact or best-first search.
    pub expansions: u64,
    /// Nodes of branch and bound.
    pub nodes: u64,
    /// Nonzero coefficients of an integer program.
    pub nonzeros: u64,
    /// States of a belief that the exact solver and the searches list. A larger belief is a decision diagram, where those
    /// suit the task. Answers are the same whatever the number.
    pub listed: usize,
}

/// A longer list takes longer to go through than a diagram takes to make (measured on Logistics: 20,000 states are listed
/// in about the time that the diagrams of a task take at first).
pub(crate) const LISTED_STATES: usize = 20_000;

const MIB: u64 = 1 << 20;

impl Limits {
    /// The same with at most so many bytes.
    #[must_use]
    pub fn with_bytes(mut self, bytes: u64) -> Self {
        self.bytes = bytes;
        self
    }

    /// The same with at most so many expansions.
    #[must_use]
    pub fn with_expansions(mut self, expansions: u64) -> Self {
        self.expansions = expansions;
        self
    }

    /// The same with at most so many nodes of branch and bound.
    #[must_use]
    pub fn with_nodes(mut self, nodes: u64) -> Self {
        self.nodes = nodes;
        self
    }

    /// The same with at most so many nonzero coefficients.
    #[must_use]
    pub fn with_nonzeros(mut self, nonzeros: u64) -> Self {
        self.nonzeros = nonzeros;
        self
    }

    /// The same with beliefs listed up to a number of states.
    #[must_use]
    pub fn with_listed(mut self, states: usize) -> Self {
        self.listed = states;
        self
    }

    /// Checks a number of bytes against the limit.
    ///
    /// # Errors
    ///
    /// [`LimitReached::Memory`] when it is over.
    pub fn check_bytes(&self, bytes: u64) -> Result<(), LimitReached> {
        if bytes > self.bytes {
            return Err(LimitReached::Memory { limit_mib: self.bytes / MIB });
        }
        Ok(())
    }
}

impl Default for Limits {
    fn default() -> Self {
        let wasm = cfg!(target_arch = "wasm32");
        Self {
            bytes: if wasm { 160 * MIB } else { 640 * MIB },
            expansions: u64::MAX,
            nodes: u64::MAX,
            nonzeros: if wasm { 400_000 } else { 1_600_000 },
            listed: LISTED_STATES,
        }
    }
}
