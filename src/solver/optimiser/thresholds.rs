//! Every threshold of the optimiser: unit, reason, effect. None changes what is proved; they decide
//! what is tried first and when something dearer is worth a try.

use super::dominance::Effort;

/// Expansions between two looks at the memory. An expansion of a large belief can take megabytes.
pub(super) const EXPANSIONS_BETWEEN_CHECKS: u64 = 16;

/// Expansions of the first search after which classes are asked for, where there are few states:
/// most small problems are solved before.
pub(super) const EXPANSIONS_BEFORE_CLASSES: u64 = 64;
/// States listed for classes then: some milliseconds.
pub(super) const STATES_OF_A_SMALL_SPACE: usize = 5_000;
/// Expansions after which tables of pairs are made, which cost as much as some hundred expansions.
pub(super) const EXPANSIONS_BEFORE_PAIRS: u64 = 256;
/// Expansions after which the linear invariants are worked out: some milliseconds.
pub(super) const EXPANSIONS_BEFORE_INVARIANTS: u64 = 512;
/// Expansions after which classes are asked for whatever the size.
pub(super) const EXPANSIONS_BEFORE_ALL_CLASSES: u64 = 4_096;
/// States listed for classes at all: about a second.
pub(super) const STATES_OF_CLASSES: usize = 60_000;

/// States above which there are too many pairs: 3,000² bits are 1.1 MiB, one matrix, and a level of a
/// table takes about two milliseconds.
pub(super) const STATES_OF_PAIRS: usize = 3_000;
/// Bytes that all tables of pairs may take together; also no more than a third of the memory limit.
pub(super) const BYTES_OF_PAIRS: u64 = 96 << 20;
/// Words of bit matrices gone through for a level of a table, at most: some milliseconds.
pub(super) const WORDS_OF_A_LEVEL: u64 = 6_000_000;

/// States times goals listed for true distances in the search for a shortest plan, at most: some
/// hundredths of a second.
pub(super) const STATES_OF_DISTANCES: usize = 300_000;
/// Expansions of the search for a shortest plan before tables of pairs are made for it.
pub(super) const EXPANSIONS_BEFORE_PAIRS_SHORTEN: u64 = 256;
/// Expansions of the search for a shortest plan, at most: some tenths of a second on floors, a second in Logistics. Above, the
/// length of the plan stays unproved, and the outcome says so.
pub(super) const EXPANSIONS_TO_SHORTEN: u64 = 40_000;
/// Believed states gone through in it, at most: about a second where each update is new. On floors nearly all are known.
pub(super) const WORK_TO_SHORTEN: u64 = 100_000_000;

/// States of a sample of an enemy's belief, spread over it evenly, and beside them those nearest to each goal.
pub(super) const STATES_OF_A_SAMPLE: usize = 48;
pub(super) const STATES_OF_A_SAMPLE_BY_GOAL: usize = 6;
/// Expansions with samples before beliefs are worked out after all.
pub(super) const EXPANSIONS_WITH_SAMPLES: u64 = 50_000;

/// What going through a belief that is not listed counts as, in believed states.
pub(super) const WORK_OF_A_DIAGRAM: u64 = 10_000;

/// How far nodes are compared for dominance in the first search, whose nodes differ more than a
/// comparison would save.
pub(super) const EFFORT_TO_FIND: Effort = Effort { nodes: 12, states: 32 };
/// The same where tables over pairs have trimmed the beliefs, or a shortest plan is looked for.
pub(super) const EFFORT_TO_PROVE: Effort = Effort { nodes: 256, states: usize::MAX };

/// Transitions gone through in refining blocks, at most: about a hundredth of a second. Blocks left
/// too coarse are not used.
pub(super) const TRANSITIONS_OF_BLOCKS: usize = 500_000;

/// Multiplications of an elimination for invariants, at most: about a tenth of a second.
pub(super) const WORK_OF_ELIMINATION: u64 = 20_000_000;
/// The same of all eliminations for facts that invariants can do without: about a second.
pub(super) const WORK_OF_REDUNDANCY: u64 = 200_000_000;
/// Facts, operators and states of initial beliefs that invariants look at, at most.
pub(super) const FACTS_OF_INVARIANTS: usize = 2_000;
pub(super) const OPERATORS_OF_INVARIANTS: usize = 20_000;
pub(super) const BELIEVED_OF_INVARIANTS: usize = 2_000;
/// Facts for exclusions of three, and words gone through in a pass over all operators, at most: some hundredths of a second.
pub(super) const FACTS_OF_TRIPLES: usize = 400;
pub(super) const WORDS_OF_TRIPLES: u64 = 5_000_000;
/// Combinations of what an observer always knows, at most.
pub(super) const CONTEXTS_OF_INVARIANTS: usize = 256;
/// Different sums of one kind, at most.
pub(super) const SUMS_OF_INVARIANTS: usize = 30_000;
