//! A belief of a replay: its states one by one while they are few, a decision diagram where they are many.

use std::sync::Arc;

use fixedbitset::FixedBitSet;
use rustc_hash::FxHashSet;

use super::OperatorsByFact;
use crate::belief::StateCount;
use crate::belief::diagram::{Diagrams, SetId, SymbolRelations};
use crate::limits::{LimitReached, Limits};
use crate::problem::Observer;
use crate::sensor::{Sensor, Symbol};
use crate::task::{Fact, State, Task};

/// Bytes of the diagrams of earlier beliefs, and of what was worked out for them, after which they are let go.
const BYTES_BEFORE_FORGETTING: u64 = 128 << 20;

/// What a replay may take.
#[derive(Debug, Clone, Copy)]
pub(super) struct Budget {
    pub limits: Limits,
    /// Nodes of decision diagrams that are made, of all beliefs together.
    pub nodes: usize,
}

/// Nodes of the diagrams of a replay: some tens of seconds.
const MOST_NODES: usize = 20_000_000;
/// The same where only details are looked for: about a second.
const NODES_OF_DETAILS: usize = 1_000_000;
/// Bytes of these.
const BYTES_OF_DETAILS: u64 = 32 << 20;

impl Budget {
    /// For an answer that has to be known in full.
    pub(super) fn full() -> Self {
        Self { limits: Limits::default(), nodes: MOST_NODES }
    }

    /// For what is nice to know.
    pub(super) fn of_details(limits: Limits) -> Self {
        let limits = limits.with_bytes(limits.bytes.min(BYTES_OF_DETAILS));
        Self { limits, nodes: NODES_OF_DETAILS }
    }
}

/// A set of states that an observer holds possible, in one of two forms with the same answers.
#[derive(Debug, Clone)]
pub struct TracedBelief(Form);

#[derive(Debug, Clone)]
enum Form {
    /// In order of the packed states.
    Listed(Vec<State>),
    Diagram(Box<Unlisted>),
}

#[derive(Debug, Clone)]
struct Unlisted {
    diagrams: Diagrams,
    relations: SymbolRelations,
    set: SetId,
}

impl TracedBelief {
    /// Lists the states, in any order.
    pub(super) fn listed(mut states: Vec<State>) -> Self {
        states.sort_unstable();
        states.dedup();
        Self(Form::Listed(states))
    }

    /// What an observer believes at first.
    pub(super) fn initial(task: &Arc<Task>, observer: &Observer, limits: Limits) -> Self {
        match observer.initial_belief.diagram() {
            None => Self::listed(observer.initial_belief.listed().unwrap_or_default().to_vec()),
            Some((known, set)) => {
                let mut diagrams = Diagrams::new(Arc::clone(task), limits);
                let set = diagrams.adopt(known, set);
                let relations = SymbolRelations::new(task, &observer.sensor);
                Self(Form::Diagram(Box::new(Unlisted { diagrams, relations, set })))
            }
        }
    }

    /// How many states there are.
    pub fn count(&self) -> StateCount {
        match &self.0 {
            Form::Listed(states) => StateCount::Exact(states.len() as u64),
            Form::Diagram(unlisted) => unlisted.diagrams.count(unlisted.set),
        }
    }

    /// The states as a slice, in order of the packed states; none where they are not listed.
    pub fn as_list(&self) -> Option<&[State]> {
        match &self.0 {
            Form::Listed(states) => Some(states),
            Form::Diagram(_) => None,
        }
    }

    /// Some of the states, at most this many; all of them where there are no more, in order of the packed states.
    pub fn some_states(&self, most: usize) -> Vec<State> {
        match &self.0 {
            Form::Listed(states) => states.iter().take(most).cloned().collect(),
            Form::Diagram(unlisted) => {
                let mut states = unlisted.diagrams.first_states(unlisted.set, most);
                states.sort_unstable();
                states
            }
        }
    }

    /// Whether a conjunction of facts holds in some state.
    pub fn satisfies(&self, task: &Task, condition: &[Fact]) -> bool {
        match &self.0 {
            Form::Listed(states) => {
                states.iter().any(|state| task.satisfies(state.words(), condition))
            }
            Form::Diagram(unlisted) => unlisted.diagrams.satisfies(unlisted.set, condition),
        }
    }

    /// In how many states a conjunction of facts holds.
    pub fn count_satisfying(&self, task: &Task, condition: &[Fact]) -> StateCount {
        match &self.0 {
            Form::Listed(states) => {
                let holds = |state: &&State| task.satisfies(state.words(), condition);
                StateCount::Exact(states.iter().filter(holds).count() as u64)
            }
            Form::Diagram(unlisted) => unlisted.diagrams.count_satisfying(unlisted.set, condition),
        }
    }

    /// In how many states each fact of the task holds, by the facts' numbers.
    pub fn fact_counts(&self, task: &Task) -> Vec<StateCount> {
        match &self.0 {
            Form::Listed(states) => {
                let mut counts = vec![0; task.fact_count()];
                for fact in states.iter().flat_map(|state| task.facts_of(state.words())) {
                    counts[fact.index()] += 1;
                }
                counts.into_iter().map(StateCount::Exact).collect()
            }
            Form::Diagram(unlisted) => unlisted.diagrams.fact_counts(unlisted.set),
        }
    }

    /// The facts that hold in some state.
    pub fn facts(&self, task: &Task) -> FixedBitSet {
        let mut facts = FixedBitSet::with_capacity(task.fact_count());
        match &self.0 {
            Form::Listed(states) => {
                for fact in states.iter().flat_map(|state| task.facts_of(state.words())) {
                    facts.insert(fact.index());
                }
            }
            Form::Diagram(unlisted) => {
                let counts = unlisted.diagrams.fact_counts(unlisted.set);
                let holds = |count: &StateCount| *count != StateCount::Exact(0);
                for (fact, _) in counts.iter().enumerate().filter(|(_, count)| holds(count)) {
                    facts.insert(fact);
                }
            }
        }
        facts
    }

    /// The belief after a symbol. A list that would grow beyond `most` states becomes a diagram; the caller asks for that
    /// only where diagrams suit the task.
    pub(super) fn update(
        &mut self,
        task: &Arc<Task>,
        operators: &OperatorsByFact,
        sensor: &Sensor,
        seen: Symbol,
        most: usize,
        budget: &mut Budget,
    ) -> Result<(), LimitReached> {
        if let Form::Listed(states) = &mut self.0 {
            let mut next: FxHashSet<Box<[u64]>> = FxHashSet::default();
            for state in &*states {
                if next.len() > most {
                    break;
                }
                operators.successors(task, state, |id, target| {
                    if sensor.read(task, id, target) == seen && !next.contains(target) {
                        next.insert(target.into());
                    }
                });
            }
            if next.len() <= most {
                *states =
                    next.into_iter().map(|words| State::from_words(words.into_vec())).collect();
                states.sort_unstable();
                return Ok(());
            }
            let mut diagrams = Diagrams::new(Arc::clone(task), budget.limits);
            let set = diagrams.of_states(states)?;
            let relations = SymbolRelations::new(task, sensor);
            self.0 = Form::Diagram(Box::new(Unlisted { diagrams, relations, set }));
        }
        if let Form::Diagram(unlisted) = &mut self.0 {
            let Unlisted { diagrams, relations, set } = &mut **unlisted;
            let before = diagrams.len();
            diagrams.allow(budget.nodes);
            *set = relations.update(diagrams, *set, seen)?;
            budget.nodes = budget.nodes.saturating_sub(diagrams.len() - before);
            diagrams.allow(usize::MAX);
            // Earlier beliefs are not met again.
            if diagrams.bytes() + relations.bytes() > BYTES_BEFORE_FORGETTING {
                (*diagrams, *set) = diagrams.alone(*set);
                relations.forget_images();
            }
        }
        Ok(())
    }
}
