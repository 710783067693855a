//! Beliefs: the sets of states an observer holds possible.
//!
//! On symbol `o` a belief becomes
//! `B' = { ŝ | ∃ â, s̄ ∈ B: Γ(s̄, â) = ŝ, O_i(â, ŝ) = o }` (Section 2 of the paper). Under one
//! sensor beliefs form a deterministic automaton, the subset construction (Rabin and Scott 1959,
//! doi:10.1147/rd.32.0114), and the part of it that a problem reaches is small. So beliefs are
//! interned in a [`BeliefSpace`] and each (belief, symbol) is worked out once, for every solver.

pub mod diagram;
mod initial_belief;
pub mod pairwise;
mod space;
mod state_sets;
mod subsets;
mod transition_table;

pub use diagram::StateCount;
pub use initial_belief::InitialBelief;
pub use space::{BeliefId, BeliefSpace, Keep};
pub use state_sets::{Members, StateSets};
pub use transition_table::TransitionTable;
