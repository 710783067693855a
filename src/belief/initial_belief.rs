//! What an observer holds possible before the first step.

use std::sync::Arc;

use super::diagram::{Diagrams, SetId, StateCount, reachable, suits};
use crate::limits::{LISTED_STATES, LimitReached, Limits};
use crate::task::{Fact, State, StateSpace, Task};

/// The most states that are gone through one by one for those with a condition, in a task that no diagrams suit.
const MAX_STATES: usize = if cfg!(target_arch = "wasm32") { 200_000 } else { 1_000_000 };
/// How many bytes they may take with their transitions, or their diagram with what is worked out for it.
const MAX_BYTES: u64 = if cfg!(target_arch = "wasm32") { 64 << 20 } else { 512 << 20 };

/// States that stand for a set that is not listed: of all, and of those in which a condition holds.
const MOST_SPREAD: usize = 1_000;
const MOST_SATISFYING: usize = 100;

/// A set of states: a list where they are few, a decision diagram where they are many.
///
/// ```
/// use mo_copp::domain::Delivery;
/// let problem = Delivery::figure_1().problem()?;
/// let believed = &problem.observers()[0].initial_belief;
/// assert!(believed.contains(problem.task().initial_state()));
/// assert_eq!(believed.listed().map(<[_]>::len), Some(1));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct InitialBelief(Form);

#[derive(Debug, Clone)]
enum Form {
    Listed(Vec<State>),
    Diagram(Arc<(Diagrams, SetId)>),
}

impl InitialBelief {
    /// All states of a task that can be reached from its initial state and satisfy a condition: gone through one by one while
    /// they are few, else by saturation, without listing them.
    ///
    /// # Errors
    ///
    /// [`LimitReached::Memory`] where the states, or the nodes of their diagram, are too many.
    ///
    /// ```
    /// use mo_copp::{domain::Delivery, problem::InitialBelief};
    /// let problem = Delivery::figure_1().problem()?;
    /// let all = InitialBelief::reachable(problem.task(), &[])?;
    /// let ends = InitialBelief::reachable(problem.task(), problem.task().goal())?;
    /// assert!(ends.count().as_f64() < all.count().as_f64());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn reachable(task: &Arc<Task>, condition: &[Fact]) -> Result<Self, LimitReached> {
        let limits = Limits::default().with_bytes(MAX_BYTES);
        let suits = suits(task);
        let most = if suits { LISTED_STATES } else { MAX_STATES };
        let mut space = StateSpace::new(Arc::clone(task));
        let mut found = Vec::new();
        let mut next = Some(space.intern(task.initial_state()));
        while let Some(state) = next {
            let words = space.words(state);
            if task.satisfies(words, condition) {
                found.push(State::from_words(words.to_vec()));
            }
            let too_many = space.len() > most || space.bytes() > MAX_BYTES;
            if too_many && suits {
                return Self::reachable_unlisted(task, condition, limits);
            }
            if too_many {
                return Err(LimitReached::Memory { limit_mib: MAX_BYTES >> 20 });
            }
            space.expand(state);
            next = space.after(state);
        }
        Ok(found.into())
    }

    /// The same without listing them, unless few are left.
    fn reachable_unlisted(
        task: &Arc<Task>,
        condition: &[Fact],
        limits: Limits,
    ) -> Result<Self, LimitReached> {
        let (mut diagrams, all) = reachable(task, limits)?;
        let set = diagrams.satisfying(all, condition)?;
        if diagrams.has_more_than(set, LISTED_STATES) {
            let (diagrams, set) = diagrams.alone(set);
            return Ok(Self::of_diagram(diagrams, set));
        }
        Ok(diagrams.first_states(set, LISTED_STATES).into())
    }

    /// A set of a store that holds no other.
    pub(crate) fn of_diagram(diagrams: Diagrams, set: SetId) -> Self {
        Self(Form::Diagram(Arc::new((diagrams, set))))
    }

    /// The same states as a diagram.
    #[cfg(test)]
    pub(crate) fn unlisted(&self, task: &Arc<Task>) -> Self {
        let limits = Limits::default();
        let mut diagrams = Diagrams::new(Arc::clone(task), limits);
        let set = diagrams.of_states(self.listed().unwrap_or_default());
        Self::of_diagram(diagrams, set.unwrap_or(SetId::EMPTY))
    }

    /// The states one by one; none where they are too many.
    pub fn listed(&self) -> Option<&[State]> {
        match &self.0 {
            Form::Listed(states) => Some(states),
            Form::Diagram(_) => None,
        }
    }

    /// The diagram; none where the states are listed.
    pub(crate) fn diagram(&self) -> Option<(&Diagrams, SetId)> {
        match &self.0 {
            Form::Listed(_) => None,
            Form::Diagram(unlisted) => Some((&unlisted.0, unlisted.1)),
        }
    }

    /// All states where they are listed. Else some that are spread over the set evenly, and over those in which each of some
    /// conditions holds: few enough to follow each of them.
    pub(crate) fn some_states<'a>(
        &self,
        conditions: impl Iterator<Item = &'a [Fact]>,
    ) -> Vec<State> {
        let Some((diagrams, set)) = self.diagram() else {
            return self.listed().unwrap_or_default().to_vec();
        };
        let mut states = diagrams.spread_states(set, MOST_SPREAD);
        let (mut diagrams, set) = diagrams.alone(set);
        for condition in conditions {
            // Where memory is short the others do.
            if let Ok(satisfying) = diagrams.satisfying(set, condition) {
                states.extend(diagrams.spread_states(satisfying, MOST_SATISFYING));
            }
        }
        states.sort_unstable();
        states.dedup();
        states
    }

    /// Whether a state is held possible. Linear in a list, in the groups of facts of a diagram.
    pub fn contains(&self, state: &State) -> bool {
        match &self.0 {
            Form::Listed(states) => states.contains(state),
            Form::Diagram(unlisted) => unlisted.0.contains(unlisted.1, state),
        }
    }

    /// How many states there are; a state that a list names twice counts twice.
    pub fn count(&self) -> StateCount {
        match &self.0 {
            Form::Listed(states) => StateCount::Exact(states.len() as u64),
            Form::Diagram(unlisted) => unlisted.0.count(unlisted.1),
        }
    }
}

impl From<Vec<State>> for InitialBelief {
    fn from(states: Vec<State>) -> Self {
        Self(Form::Listed(states))
    }
}

impl FromIterator<State> for InitialBelief {
    fn from_iter<I: IntoIterator<Item = State>>(states: I) -> Self {
        Self::from(Vec::from_iter(states))
    }
}
