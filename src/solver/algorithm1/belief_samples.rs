//! Belief samples: as much of a belief as the search has to see.
//!
//! Algorithm 1 carries both full beliefs in every node, and a belief may hold a hundred thousand
//! states. Yet of most nodes nothing is asked but how far the goals are from the beliefs. So a node
//! carries *samples*. The sample of a belief of at most `STATES_OF_A_WHOLE_BELIEF` states is all of it. That of a
//! larger one is some `STATES_KEPT` states of it, those nearest to the candidate goals, followed from one
//! symbol to the next as a beam search would: the states of the next sample are successors of the
//! states of the one before.
//!
//! A sample is a lower bound: each of its states is in the belief, so that a goal that
//! survives in the sample survives in the belief. The converse does not hold; then the
//! full belief is worked out, which every sample can do from the symbols that led to it, and which
//! is remembered. Two samples with the same full belief are one as soon as it is known.

use fixedbitset::FixedBitSet;

use crate::belief::{BeliefId, TransitionTable};
use crate::goal_difference::GoalSet;
use crate::heuristic::{GoalValues, UNREACHABLE};
use crate::limits::LimitReached;
use crate::problem::JointSpace;
use crate::sensor::Symbol;
use crate::solver::ground::thresholds::{STATES_KEPT, STATES_LOOKED_AT, STATES_OF_A_WHOLE_BELIEF};
use crate::task::StateId;

/// No belief, no sample yet.
const UNKNOWN: u32 = u32::MAX;

/// No values yet.
const NO_VALUE: u32 = UNREACHABLE - 1;

/// A sample, by its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct SampleId(pub u32);

/// Where a sample comes from, and what is known of it.
#[derive(Debug, Clone, Copy)]
struct Origin {
    /// The sample before; the full belief is known where there is none.
    before: u32,
    symbol: Symbol,
    /// The full belief, once it is known.
    belief: u32,
    /// Where its states begin, and how many are kept.
    begin: u32,
    count: u32,
}

/// The samples of one observer.
#[derive(Debug)]
pub(super) struct BeliefSamples {
    observer: usize,
    goals: usize,
    true_goal: usize,
    origins: Vec<Origin>,
    states: Vec<StateId>,
    /// A row of values for each sample, of which the first is `NO_VALUE` until they are worked out.
    values: Vec<u32>,
    transitions: TransitionTable,
    /// The sample of each belief that was known when it was made.
    of_beliefs: Vec<u32>,
    found: Vec<StateId>,
}

impl BeliefSamples {
    /// No sample of an observer's beliefs yet.
    pub(super) fn new(joint: &JointSpace, observer: usize) -> Self {
        let problem = joint.problem();
        Self {
            observer,
            goals: problem.goals().len(),
            true_goal: problem.true_goal(),
            origins: Vec::new(),
            states: Vec::new(),
            values: Vec::new(),
            transitions: TransitionTable::new(joint.beliefs(observer).sensor().symbol_count()),
            of_beliefs: Vec::new(),
            found: Vec::new(),
        }
    }

    /// Bytes in use, counted by contents.
    pub(super) fn bytes(&self) -> u64 {
        let numbers = self.states.len() + self.values.len() + self.of_beliefs.len();
        (size_of::<Origin>() * self.origins.len() + 4 * numbers) as u64 + self.transitions.bytes()
    }

    /// The full belief, where it is known.
    fn known(&self, sample: SampleId) -> Option<BeliefId> {
        let belief = self.origins[sample.0 as usize].belief;
        (belief != UNKNOWN).then_some(BeliefId(belief))
    }

    /// The full belief, where it is known and small enough to be the sample.
    pub(super) fn whole(&self, joint: &JointSpace, sample: SampleId) -> Option<BeliefId> {
        let members = |belief| joint.beliefs(self.observer).members(belief).listed();
        self.known(sample).filter(|&belief| {
            members(belief).is_some_and(|list| list.len() <= STATES_OF_A_WHOLE_BELIEF)
        })
    }

    fn add(&mut self, before: u32, symbol: Symbol, belief: u32) -> SampleId {
        let sample = SampleId(self.origins.len() as u32);
        let begin = self.states.len() as u32;
        self.states.extend_from_slice(&self.found);
        let count = self.found.len() as u32;
        self.origins.push(Origin { before, symbol, belief, begin, count });
        self.values.resize(self.values.len() + self.goals, NO_VALUE);
        sample
    }

    /// The sample of a belief.
    pub(super) fn of_belief(
        &mut self,
        joint: &mut JointSpace,
        values: &mut GoalValues,
        belief: BeliefId,
    ) -> SampleId {
        let known = self.of_beliefs.get(belief.index()).copied();
        if let Some(known) = known.filter(|&known| known != UNKNOWN) {
            return SampleId(known);
        }
        let members = joint.beliefs(self.observer).members(belief);
        self.found.clear();
        if members.listed().is_none_or(|list| list.len() > STATES_OF_A_WHOLE_BELIEF) {
            self.found = joint.some_members(self.observer, belief, STATES_LOOKED_AT);
            self.keep_nearest(joint, values);
        }
        let sample = self.add(UNKNOWN, Symbol(0), belief.0);
        if self.of_beliefs.len() <= belief.index() {
            self.of_beliefs.resize(belief.index() + 1, UNKNOWN);
        }
        self.of_beliefs[belief.index()] = sample.0;
        sample
    }

    /// The sample after a symbol, seen as the actor went to the state `truth`.
    ///
    /// Constant for a symbol that was seen here before; else at most linear in the transitions out
    /// of `STATES_OF_A_WHOLE_BELIEF` states, but for their heuristic values.
    pub(super) fn follow(
        &mut self,
        joint: &mut JointSpace,
        values: &mut GoalValues,
        sample: SampleId,
        symbol: Symbol,
        truth: StateId,
    ) -> Result<SampleId, LimitReached> {
        if let Some(known) = self.transitions.get(sample.0, symbol.0) {
            return Ok(SampleId(known));
        }
        let next = match self.whole(joint, sample) {
            Some(belief) => {
                let belief = joint.update(self.observer, belief, symbol)?;
                self.of_belief(joint, values, belief)
            }
            None => {
                self.successors(joint, sample, symbol, truth);
                self.keep_nearest(joint, values);
                self.add(sample.0, symbol, UNKNOWN)
            }
        };
        self.transitions.set(sample.0, symbol.0, next.0);
        Ok(next)
    }

    /// Collects the states that follow the states of a sample on a symbol.
    fn successors(
        &mut self,
        joint: &mut JointSpace,
        sample: SampleId,
        symbol: Symbol,
        truth: StateId,
    ) {
        let Origin { begin, count, .. } = self.origins[sample.0 as usize];
        self.found.clear();
        self.found.push(truth);
        for index in begin..begin + count {
            let state = self.states[index as usize];
            joint.states_mut().expand(state);
            for edge in joint.states().edge_range(state) {
                if joint.symbol(self.observer, edge) == symbol {
                    self.found.push(joint.states().all_edges()[edge].target);
                }
            }
        }
        self.found.sort_unstable();
        self.found.dedup();
    }

    /// Keeps of the states found those nearest to each goal but the true one, which needs no help
    /// to survive.
    fn keep_nearest(&mut self, joint: &JointSpace, values: &mut GoalValues) {
        if self.found.len() <= STATES_KEPT {
            return;
        }
        let share = (STATES_KEPT / (self.goals - 1).max(1)).max(1);
        let mut kept = FixedBitSet::with_capacity(self.found.len());
        let mut nearest: Vec<(u32, u32)> = Vec::with_capacity(self.found.len());
        for goal in (0..self.goals).filter(|&goal| goal != self.true_goal) {
            nearest.clear();
            for (place, &state) in (0..).zip(&self.found) {
                nearest.push((values.of_state(joint, state)[goal], place));
            }
            nearest.select_nth_unstable(share);
            kept.extend(nearest[..share].iter().map(|&(_, place)| place as usize));
            if kept.count_ones(..) >= STATES_KEPT {
                break;
            }
        }
        let mut place = 0;
        self.found.retain(|_| {
            place += 1;
            kept.contains(place - 1)
        });
    }

    /// The full belief of a sample. Takes one update for each symbol since the last sample on the
    /// way here for which it was known.
    ///
    /// # Errors
    ///
    /// The memory limit.
    pub(super) fn belief(
        &mut self,
        joint: &mut JointSpace,
        sample: SampleId,
    ) -> Result<BeliefId, LimitReached> {
        let mut way = Vec::new();
        let mut at = sample.0;
        while self.origins[at as usize].belief == UNKNOWN {
            way.push(at);
            at = self.origins[at as usize].before;
        }
        let mut belief = BeliefId(self.origins[at as usize].belief);
        for at in way.into_iter().rev() {
            belief = joint.update(self.observer, belief, self.origins[at as usize].symbol)?;
            self.origins[at as usize].belief = belief.0;
            // The full belief gives better values.
            self.values[at as usize * self.goals] = NO_VALUE;
        }
        Ok(belief)
    }

    /// How far each goal is from the belief, as far as the sample can tell: the least value over its
    /// states, 0 for a goal that is known to survive. Never too small. [`UNREACHABLE`] is certain
    /// only of a sample that is [`whole`](Self::whole).
    pub(super) fn values(
        &mut self,
        joint: &mut JointSpace,
        values: &mut GoalValues,
        sample: SampleId,
    ) -> &[u32] {
        let begin = sample.0 as usize * self.goals;
        if self.values[begin] == NO_VALUE {
            self.work_out(joint, values, sample);
        }
        &self.values[begin..][..self.goals]
    }

    fn work_out(&mut self, joint: &mut JointSpace, values: &mut GoalValues, sample: SampleId) {
        let mut row = vec![UNREACHABLE; self.goals];
        if let Some(belief) = self.known(sample) {
            for goal in joint.survivors(self.observer, belief).iter() {
                row[goal] = 0;
            }
        }
        if row.iter().any(|&value| value > 0) {
            for &state in self.members(joint, sample) {
                for (least, &value) in row.iter_mut().zip(values.of_state(joint, state)) {
                    *least = value.min(*least);
                }
            }
        }
        self.values[sample.0 as usize * self.goals..][..self.goals].copy_from_slice(&row);
    }

    fn members<'a>(&'a self, joint: &'a JointSpace, sample: SampleId) -> &'a [StateId] {
        let Origin { begin, count, .. } = self.origins[sample.0 as usize];
        match self.whole(joint, sample) {
            Some(belief) => joint.beliefs(self.observer).list(belief),
            None => &self.states[begin as usize..][..count as usize],
        }
    }

    /// The goals that survive in the belief, as far as the sample can tell: all of them where the
    /// full belief is known.
    pub(super) fn survivors(
        &mut self,
        joint: &mut JointSpace,
        values: &mut GoalValues,
        sample: SampleId,
    ) -> GoalSet {
        let mut survivors = GoalSet::none(self.goals);
        for (goal, &value) in self.values(joint, values, sample).iter().enumerate() {
            if value == 0 {
                survivors.insert(goal);
            }
        }
        survivors
    }
}
