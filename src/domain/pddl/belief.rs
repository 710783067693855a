//! What an observer of a PDDL task believes before the first step.

use std::sync::Arc;

use fixedbitset::FixedBitSet;

use super::build::{Texts, at};
use super::{PddlBelief, PddlObserver, PddlState};
use crate::document::DocumentError;
use crate::pddl::{Atom, Domain, Grounded, More, read_condition, read_state};
use crate::task::{State, StateId, StateSpace};

/// The most atoms in all listed states of an observer.
const MAX_ATOMS: usize = if cfg!(target_arch = "wasm32") { 1_000_000 } else { 10_000_000 };

/// The most states that are gone through for those with a condition, and how many bytes they may
/// take with their transitions.
const MAX_STATES: usize = if cfg!(target_arch = "wasm32") { 200_000 } else { 1_000_000 };
const MAX_BYTES: u64 = if cfg!(target_arch = "wasm32") { 64 << 20 } else { 512 << 20 };

/// An initial belief whose texts are read; states and conditions by their positions in [`More`].
pub(super) enum Believed {
    /// The initial state alone.
    Start,
    States(std::ops::Range<usize>),
    Reachable(usize),
}

impl Believed {
    /// Reads the texts and adds them to what is grounded.
    pub(super) fn read(
        observer: &PddlObserver,
        texts: &Texts,
        path: &str,
        more: &mut More,
    ) -> Result<Self, DocumentError> {
        let path = format!("{path}.initial_belief");
        match &observer.initial_belief {
            None => Ok(Self::Start),
            Some(PddlBelief::Reachable(text)) => {
                let condition = read_condition(&texts.domain, &texts.task, text);
                let condition = condition.map_err(|e| at(format!("{path}.reachable"), e))?;
                let holds = |atom: &Atom| texts.task.initial.binary_search(atom).is_ok();
                if condition.is_false
                    || !condition.positive.iter().all(holds)
                    || condition.negative.iter().any(holds)
                {
                    let found = "a condition that the initial state does not satisfy";
                    let expected = "a condition that it does, since the actor is there";
                    return Err(DocumentError::invalid(
                        format!("{path}.reachable"),
                        found,
                        expected,
                    ));
                }
                more.conditions.push(condition);
                Ok(Self::Reachable(more.conditions.len() - 1))
            }
            Some(PddlBelief::States(states)) => {
                let fixed = Fixed::new(texts);
                let begin = more.states.len();
                let mut atoms = 0;
                for (index, state) in states.iter().enumerate() {
                    let state = fixed.state(texts, state, &format!("{path}[{index}]"))?;
                    atoms += state.len() + 1;
                    if atoms > MAX_ATOMS {
                        let found = format!("states with more than {MAX_ATOMS} atoms in all");
                        return Err(DocumentError::invalid(path, found, "at most that"));
                    }
                    more.states.push(state);
                }
                if !more.states[begin..].contains(&texts.task.initial) {
                    let found = format!("{} states without the initial state", states.len());
                    let expected = "the initial state among them, as in {}";
                    return Err(DocumentError::invalid(path, found, expected));
                }
                Ok(Self::States(begin..more.states.len()))
            }
        }
    }

    /// The states of a belief, now that the task is grounded.
    pub(super) fn states(
        &self,
        grounded: &Grounded,
        path: &str,
    ) -> Result<Vec<State>, DocumentError> {
        let task = &grounded.task;
        match self {
            Self::Start => Ok(vec![task.initial_state().clone()]),
            Self::States(range) => Ok(grounded.states[range.clone()].to_vec()),
            Self::Reachable(condition) => {
                // The initial state satisfies it, so it can hold.
                let condition = grounded.conditions[*condition].as_deref().unwrap_or_default();
                let mut space = StateSpace::new(Arc::new(task.clone()));
                space.intern(task.initial_state());
                let mut found = Vec::new();
                let mut next = 0;
                while next < space.len() {
                    let state = StateId(next as u32);
                    next += 1;
                    let words = space.words(state);
                    if task.satisfies(words, condition) {
                        found.push(State::from_words(words.to_vec()));
                    }
                    if space.len() > MAX_STATES || space.bytes() > MAX_BYTES {
                        let found =
                            format!("a condition over more than {} states", space.len() - 1);
                        let expected = "a task with fewer reachable states, or a list of states";
                        let path = format!("{path}.initial_belief.reachable");
                        return Err(DocumentError::invalid(path, found, expected));
                    }
                    space.expand(state);
                }
                Ok(found)
            }
        }
    }
}

/// Which predicates no action changes.
struct Fixed(FixedBitSet);

impl Fixed {
    fn new(texts: &Texts) -> Self {
        let mut fixed = FixedBitSet::with_capacity(texts.domain.predicates.len());
        fixed.insert_range(..);
        for predicate in changing(&texts.domain) {
            fixed.remove(predicate);
        }
        Self(fixed)
    }

    fn holds(&self, atom: &Atom) -> bool {
        self.0.contains(atom.predicate.index())
    }

    /// All atoms of a listed state, sorted.
    fn state(
        &self,
        texts: &Texts,
        state: &PddlState,
        path: &str,
    ) -> Result<Vec<Atom>, DocumentError> {
        let initial = &texts.task.initial;
        let mut atoms: Vec<Atom> = match state {
            PddlState::Atoms(listed) => {
                let check = |atom: &Atom| {
                    let known = !self.holds(atom) || initial.binary_search(atom).is_ok();
                    (!known).then_some("an atom of a predicate that no action changes")
                };
                let listed = read(texts, listed, path, "only those that are in the :init", check)?;
                initial.iter().filter(|atom| self.holds(atom)).cloned().chain(listed).collect()
            }
            PddlState::Change { add, delete } => {
                let fixed = "an atom of a predicate that no action changes";
                let check = |there: bool, atom: &Atom| match initial.binary_search(atom).is_ok() {
                    _ if self.holds(atom) => Some(fixed),
                    true if !there => Some("an atom that holds in the initial state already"),
                    false if there => Some("an atom that does not hold in the initial state"),
                    _ => None,
                };
                let expected = "an atom that makes a difference";
                let place = format!("{path}.delete");
                let gone = read(texts, delete, &place, expected, |atom| check(true, atom))?;
                let place = format!("{path}.add");
                let new = read(texts, add, &place, expected, |atom| check(false, atom))?;
                let stays = |atom: &&Atom| gone.binary_search(atom).is_err();
                initial.iter().filter(stays).cloned().chain(new).collect()
            }
        };
        atoms.sort_unstable();
        atoms.dedup();
        Ok(atoms)
    }
}

/// The predicates that actions change, by their numbers.
pub(super) fn changing(domain: &Domain) -> impl Iterator<Item = usize> {
    let effects = domain.schemas.iter().map(|schema| &schema.effect);
    let atoms = effects.flat_map(|effect| effect.positive.iter().chain(&effect.negative));
    atoms.map(|atom| atom.predicate.index())
}

/// Reads atoms; `check` says what is wrong with one.
fn read(
    texts: &Texts,
    atoms: &[String],
    path: &str,
    expected: &str,
    check: impl Fn(&Atom) -> Option<&'static str>,
) -> Result<Vec<Atom>, DocumentError> {
    let mut all = Vec::with_capacity(atoms.len());
    for (index, text) in atoms.iter().enumerate() {
        let path = format!("{path}[{index}]");
        let atoms = read_state(&texts.domain, &texts.task, text).map_err(|e| at(&path, e))?;
        if let Some(found) = atoms.iter().find_map(&check) {
            return Err(DocumentError::invalid(path, found, expected));
        }
        all.extend(atoms);
    }
    all.sort_unstable();
    Ok(all)
}
