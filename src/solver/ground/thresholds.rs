//! Every threshold of the solvers: unit, reason, effect. None changes what is proved; they decide what is tried first, when
//! something dearer is worth a try, and how often limits are looked at.

use crate::limits::Limits;

// All engines

/// Expansions between two looks at the memory. An expansion of a large belief can take megabytes.
pub(in crate::solver) const EXPANSIONS_BETWEEN_CHECKS: u64 = 16;
/// States expanded between two looks at the memory.
pub(in crate::solver) const STATES_BETWEEN_CHECKS: usize = 1024;

// What engines share

/// States above which a space is not gone through for dead ends or costs before the search itself: some tenths of a second.
pub(in crate::solver) const STATES_OF_DEAD_ENDS: usize = 200_000;
/// The believed states that the completions of one stop may go through: a search that is stopped has
/// to answer at once.
pub(in crate::solver) const STATES_OF_A_COMPLETION: usize = 4_000_000;
/// The part of the memory limit that distances of states may take: an eighth. Further states count
/// as 0 away from every goal, which makes the order worse and nothing wrong.
pub(in crate::solver) const PART_OF_MEMORY_FOR_DISTANCES: u64 = 8;
/// The part of the memory limit that listing states for endings may take: a quarter. Above, the
/// horizon is kept by estimates alone, which leaves out less: a plan of just this length may need
/// another parity of steps than the estimates see.
pub(in crate::solver) const PART_OF_MEMORY_FOR_ENDINGS: u64 = 4;

// Baseline

/// Expansions without a smaller value after which new nodes take their turns as well. Driverlog
/// with four drivers and eight packages is not solved in millions of expansions without.
pub(in crate::solver) const EXPANSIONS_WITHOUT_A_SMALLER_VALUE: u64 = 1000;

// Algorithm 1

/// What a goal that cannot be reached any more counts as in a sum of values: more than goals in
/// problems of the paper's size are away, so that ruling one out for good is worth the way.
pub(in crate::solver) const UNREACHABLE_VALUE: u32 = 64;
/// States of the largest belief that is kept whole.
pub(in crate::solver) const STATES_OF_A_WHOLE_BELIEF: usize = 64;
/// States that are kept of a larger belief.
pub(in crate::solver) const STATES_KEPT: usize = 16;
/// States that are looked at, evenly spread, of a belief that is larger and known.
pub(in crate::solver) const STATES_LOOKED_AT: usize = 1024;
/// States that are put together in subsets, of a belief that is not listed.
pub(in crate::solver) const STATES_OF_A_SUBSET: usize = 64;

// Explorer

/// Visits of nodes, in layers or under a cost limit, between two looks at the memory. A visit takes some hundred bytes.
pub(in crate::solver) const VISITS_BETWEEN_CHECKS: u64 = 64;
/// When stopped at a horizon, this many nodes are followed to the goal at most.
pub(in crate::solver) const COMPLETIONS: usize = 256;
/// Visits after which layers are no longer gone through: some seconds. Each visit of a node after
/// its first one is no expansion, but it takes time.
pub(in crate::solver) const VISITS_OF_LAYERS: u64 = 100_000_000;

// Integer programs

/// How many nodes are solved between two looks at the memory; a slice ends there at the latest.
pub(in crate::solver) const NODES_BETWEEN_CHECKS: u64 = 64;
/// Expansions spent on the first plan.
pub(in crate::solver) const FIRST_PLAN_EXPANSIONS: u64 = 256;

// Optimiser

/// How much a goal of difference still missing weighs against a step.
pub(in crate::solver) const WEIGHT_OF_VALUE: i64 = 6;
/// How much a goal weighs that is at least as near in a friend's belief as the true one.
pub(in crate::solver) const WEIGHT_OF_THREAT: u32 = 2;

/// Expansions of the first search after which classes are asked for, where there are few states:
/// most small problems are solved before.
pub(in crate::solver) const EXPANSIONS_BEFORE_CLASSES: u64 = 64;
/// States listed for classes then: some milliseconds.
pub(in crate::solver) const STATES_OF_A_SMALL_SPACE: usize = 5_000;
/// Expansions after which tables of pairs are made, which cost as much as some hundred expansions.
pub(in crate::solver) const EXPANSIONS_BEFORE_PAIRS: u64 = 256;
/// Expansions after which the linear invariants are worked out: some milliseconds.
pub(in crate::solver) const EXPANSIONS_BEFORE_INVARIANTS: u64 = 512;
/// Expansions after which classes are asked for whatever the size.
pub(in crate::solver) const EXPANSIONS_BEFORE_ALL_CLASSES: u64 = 4_096;
/// States listed for classes at all: about a second.
pub(in crate::solver) const STATES_OF_CLASSES: usize = 60_000;

/// States above which there are too many pairs: 3,000² bits are 1.1 MiB, one matrix, and a level of a
/// table takes about two milliseconds.
pub(in crate::solver) const STATES_OF_PAIRS: usize = 3_000;
/// Bytes that all tables of pairs may take together; also no more than a third of the memory limit.
pub(in crate::solver) const BYTES_OF_PAIRS: u64 = 96 << 20;
/// Words of bit matrices gone through for a level of a table, at most: some milliseconds.
pub(in crate::solver) const WORDS_OF_A_LEVEL: u64 = 6_000_000;

/// States times goals listed for true distances in the search for a shortest plan, at most: some
/// hundredths of a second.
pub(in crate::solver) const STATES_OF_DISTANCES: usize = 300_000;
/// Expansions of the search for a shortest plan before tables of pairs are made for it.
pub(in crate::solver) const EXPANSIONS_BEFORE_PAIRS_SHORTEN: u64 = 256;
/// Expansions of the search for a shortest plan, at most: some tenths of a second on floors, a second in Logistics. Above, the
/// length of the plan stays unproved, and the outcome says so.
pub(in crate::solver) const EXPANSIONS_TO_SHORTEN: u64 = 40_000;
/// Believed states gone through in it, at most: about a second where each update is new. On floors nearly all are known.
pub(in crate::solver) const WORK_TO_SHORTEN: u64 = 100_000_000;

/// States of a sample of an enemy's belief, spread over it evenly, and beside them those nearest to each goal.
pub(in crate::solver) const STATES_OF_A_SAMPLE: usize = 48;
pub(in crate::solver) const STATES_OF_A_SAMPLE_BY_GOAL: usize = 6;
/// Expansions with samples before beliefs are worked out after all.
pub(in crate::solver) const EXPANSIONS_WITH_SAMPLES: u64 = 50_000;

/// What going through a belief that is not listed counts as, in believed states.
pub(in crate::solver) const WORK_OF_A_DIAGRAM: u64 = 10_000;

/// Nodes and believed states that are compared for dominance in the first search, whose nodes differ more than a comparison
/// would save.
pub(in crate::solver) const NODES_COMPARED_TO_FIND: usize = 12;
pub(in crate::solver) const STATES_COMPARED_TO_FIND: usize = 32;
/// Nodes compared where tables over pairs have trimmed the beliefs, or a shortest plan is looked for; their states are all
/// compared then.
pub(in crate::solver) const NODES_COMPARED_TO_PROVE: usize = 256;

/// Transitions gone through in refining blocks, at most: about a hundredth of a second. Blocks left
/// too coarse are not used.
pub(in crate::solver) const TRANSITIONS_OF_BLOCKS: usize = 500_000;

/// Multiplications of an elimination for invariants, at most: about a tenth of a second.
pub(in crate::solver) const WORK_OF_ELIMINATION: u64 = 20_000_000;
/// The same of all eliminations for facts that invariants can do without: about a second.
pub(in crate::solver) const WORK_OF_REDUNDANCY: u64 = 200_000_000;
/// Facts, operators and states of initial beliefs that invariants look at, at most.
pub(in crate::solver) const FACTS_OF_INVARIANTS: usize = 2_000;
pub(in crate::solver) const OPERATORS_OF_INVARIANTS: usize = 20_000;
pub(in crate::solver) const BELIEVED_OF_INVARIANTS: usize = 2_000;
/// Facts for exclusions of three, and words gone through in a pass over all operators, at most: some hundredths of a second.
pub(in crate::solver) const FACTS_OF_TRIPLES: usize = 400;
pub(in crate::solver) const WORDS_OF_TRIPLES: u64 = 5_000_000;
/// Combinations of what an observer always knows, at most.
pub(in crate::solver) const CONTEXTS_OF_INVARIANTS: usize = 256;
/// Different sums of one kind, at most.
pub(in crate::solver) const SUMS_OF_INVARIANTS: usize = 30_000;

// Cost limits

/// The expansions of the optimiser: most of the problems that it proves at all take no more, and where
/// the limit matters they are lost.
pub(in crate::solver) const RELAXED_EXPANSIONS: u64 = 2_000;

// Portfolio

/// The nodes that Algorithm 1 may take from its open list at first (whether it expands, defers or drops them).
/// Few searches that find a plan at all take more in a small state space, and the tables of the optimiser cost more than
/// as many nodes.
pub(in crate::solver) const GREEDY_NODES: u64 = 2_000;
/// The nodes that Algorithm 1 may generate in the same turn where there are walks: for each it works out the values of all
/// goals, so that with five of them this is as much work as the walks have. In a task with many operators it would spend
/// all of the time before the walks begin.
pub(in crate::solver) const GREEDY_GENERATED: u64 = 10_000;
/// The values of states that the parallel walks may work out in their first turn: some tenths of a second.
pub(in crate::solver) const WALK_EVALUATIONS: u64 = 50_000;
/// What Algorithm 1 may generate in later rounds, and by how much the turns of the walks are longer then: together some
/// seconds in the second round, a minute in the third.
pub(in crate::solver) const LONGER_ROUNDS: [(u64, u64); 2] = [(100_000, 8), (2_000_000, 80)];
/// Believed states gone through and nodes expanded by the optimiser without a plan, after which one is looked for elsewhere:
/// about half a second. After [`TIMES_AS_MUCH_WORK`] times as many the means have their next round.
pub(in crate::solver) const WORK_WITHOUT_PLAN: u64 = 3_000_000;
/// The same where the means began.
pub(in crate::solver) const WORK_AFTER_MEANS: u64 = 300_000;
pub(in crate::solver) const TIMES_AS_MUCH_WORK: u64 = 10;
/// The means for a first plan and the optimiser beside them have the memory limit divided by this, each.
pub(in crate::solver) const SHARE_OF_MEMORY: u64 = 2;

// Parallel walks

/// States of the walkers' beams at first, at most. Where no route has enough walks they are widened (iterative broadening:
/// Ginsberg and Harvey 1992).
pub(in crate::solver) const BEAM_WIDTH: usize = 16;
/// By how much beams are widened, and how wide they get.
pub(in crate::solver) const BEAM_WIDER: usize = 4;
pub(in crate::solver) const BEAM_WIDTH_AT_MOST: usize = 256;
/// States met after a beam for each that is kept, at most: the nearest are expanded first.
pub(in crate::solver) const MET_FOR_EACH_KEPT: usize = 2;
/// Values of states that may be worked out for the walks beside a plan from elsewhere: some seconds.
pub(in crate::solver) const EVALUATIONS_BESIDE: u64 = 400_000;
/// Goals of a round trip, at most.
pub(in crate::solver) const LONGEST_TRIP: usize = 8;
/// Routes through one other goal before round trips.
pub(in crate::solver) const FIRST_THROUGH_ONE: usize = 3;
/// States evaluated for a leg to a goal on the way to another, at most: tenths of a second.
pub(in crate::solver) const EVALUATIONS_ON_THE_WAY: usize = 20_000;
/// The same for the last leg in the first round: about a second.
pub(in crate::solver) const EVALUATIONS_OF_A_FIRST_LEG: usize = 50_000;
/// The same in later rounds: some seconds. A task that takes more is one for the classical planners.
pub(in crate::solver) const EVALUATIONS_OF_A_LEG: usize = 150_000;
/// States expanded breadth first for a leg, at most, and their transitions: about half a second.
pub(in crate::solver) const STATES_BREADTH_FIRST: usize = 500_000;
pub(in crate::solver) const TRANSITIONS_BREADTH_FIRST: usize = 3_000_000;
/// States expanded without a value that are as much work as one value.
pub(in crate::solver) const STATES_FOR_A_VALUE: usize = 16;
/// Turns that the list of preferred states gains with each smaller value.
pub(in crate::solver) const TURNS_OF_PREFERRED: i64 = 1_000;

// Remedies

/// Expansions after which the search gives up, where the options allow no fewer.
pub(in crate::solver) const EXPANSIONS_OF_REMEDIES: u64 = 1_000_000;
/// The expansions and the bytes of the exhaustive exploration that comes first. It answers all
/// questions in one go where the space is small; where it is not, one question at a time is faster.
pub(in crate::solver) const EXPLORED: Limits = Limits {
    bytes: 32 << 20,
    expansions: 20_000,
    nodes: u64::MAX,
    nonzeros: u64::MAX,
    listed: usize::MAX,
};
/// Expansions of greedy search for any plan, after a proof that none keeps the bounds. Where the state space is too large to
/// find a shortest plan in, it tells the reason.
pub(in crate::solver) const REACH_EXPANSIONS: u64 = 2_000;
/// How many horizons on either side are tried.
pub(in crate::solver) const HORIZONS_TRIED: usize = 3;
