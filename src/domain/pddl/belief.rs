//! What an observer of a PDDL task believes before the first step.

use std::sync::Arc;

use fixedbitset::FixedBitSet;
use indexmap::IndexSet;
use rustc_hash::FxBuildHasher;

use super::build::{Texts, at, limit};
use super::{Pddl, PddlBelief, PddlObserver, PddlState};
use crate::document::DocumentError;
use crate::pddl::{
    Atom, ExtraInputs, Grounded, read_atoms, read_condition, read_literals, read_state, unchanging,
};
use crate::problem::InitialBelief;

/// The most atoms in all listed states of an observer.
const MAX_ATOMS: usize = if cfg!(target_arch = "wasm32") { 1_000_000 } else { 10_000_000 };

/// An initial belief whose texts are read; states and conditions by their positions in [`ExtraInputs`].
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
        fixed: &Fixed,
        path: &str,
        extra: &mut ExtraInputs,
    ) -> Result<Self, DocumentError> {
        let path = format!("{path}.initial_belief");
        match &observer.initial_belief {
            None => Ok(Self::Start),
            Some(PddlBelief::Reachable(text)) => {
                let condition = read_condition(&texts.domain, &texts.task, text);
                let condition = condition.map_err(|e| at(format!("{path}.reachable"), e))?;
                let holds = |atom: &Atom| texts.task.initial.binary_search(atom).is_ok();
                if !condition.holds(&holds) {
                    let found = "a condition that the initial state does not satisfy";
                    let expected = "a condition that it does, since the actor is there";
                    return Err(DocumentError::invalid(
                        format!("{path}.reachable"),
                        found,
                        expected,
                    ));
                }
                extra.conditions.push(condition);
                Ok(Self::Reachable(extra.conditions.len() - 1))
            }
            Some(PddlBelief::States(states)) => {
                // A belief is a set: millions of equal states take no more room than one.
                let mut listed = IndexSet::<Vec<Atom>, FxBuildHasher>::default();
                let mut atoms = 0;
                for (index, state) in states.iter().enumerate() {
                    let state = fixed.state(texts, state, &format!("{path}[{index}]"))?;
                    let size = state.len() + 1;
                    atoms += if listed.insert(state) { size } else { 0 };
                    if atoms > MAX_ATOMS {
                        let found = format!("states with more than {MAX_ATOMS} atoms in all");
                        return Err(DocumentError::invalid(path, found, "at most that"));
                    }
                }
                if !listed.contains(&texts.task.initial) {
                    let found = format!("{} states without the initial state", states.len());
                    let expected = "the initial state among them, as in {}";
                    return Err(DocumentError::invalid(path, found, expected));
                }
                let begin = extra.states.len();
                extra.states.extend(listed);
                Ok(Self::States(begin..extra.states.len()))
            }
        }
    }

    /// The states of a belief, now that the task is grounded.
    pub(super) fn states(
        &self,
        grounded: &Grounded,
        path: &str,
    ) -> Result<InitialBelief, DocumentError> {
        let task = &grounded.task;
        match self {
            Self::Start => Ok(vec![task.initial_state().clone()].into()),
            Self::States(range) => Ok(grounded.states[range.clone()].to_vec().into()),
            Self::Reachable(condition) => {
                // The initial state satisfies it, so it can hold.
                let condition = grounded.conditions[*condition].as_deref().unwrap_or_default();
                let task = Arc::new(task.clone());
                InitialBelief::reachable(&task, condition).map_err(|limit| {
                    let found = format!("a condition over too many states ({limit})");
                    let expected = "a task with fewer reachable states, or a list of states";
                    let path = format!("{path}.initial_belief.reachable");
                    DocumentError::invalid(path, found, expected)
                })
            }
        }
    }
}

/// What no action changes.
pub(super) struct Fixed {
    predicates: FixedBitSet,
    /// The atoms of the initial state that no action changes, sorted.
    atoms: Vec<Atom>,
}

impl Fixed {
    /// Looks through the actions. Where observers list the atoms of states, also actions count that
    /// can apply only there.
    pub(super) fn new(pddl: &Pddl, texts: &Texts) -> Result<Self, DocumentError> {
        let mut predicates = FixedBitSet::with_capacity(texts.domain.predicates.len());
        predicates.insert_range(..);
        for predicate in texts.domain.changing() {
            predicates.remove(predicate);
        }
        let initial = &texts.task.initial;
        let of_fixed = |atom: &Atom| predicates.contains(atom.predicate.index());
        let mut listed: Option<Vec<Atom>> = None;
        for (_, observer) in pddl.observers.iter() {
            let Some(PddlBelief::States(states)) = &observer.initial_belief else { continue };
            for state in states {
                let (PddlState::Atoms(texts_of_atoms)
                | PddlState::Change { add: texts_of_atoms, .. }) = state;
                let all = listed.get_or_insert_default();
                for text in texts_of_atoms {
                    // What cannot be read is told where the states are read.
                    all.extend(read_state(&texts.domain, &texts.task, text).unwrap_or_default());
                }
            }
        }
        let atoms = match listed {
            Some(listed) if !initial.iter().all(of_fixed) => {
                unchanging(&texts.domain, &texts.task, &listed).map_err(|error| limit(&error))?
            }
            _ => initial.iter().filter(|atom| of_fixed(atom)).cloned().collect(),
        };
        Ok(Self { predicates, atoms })
    }

    fn holds(&self, atom: &Atom) -> bool {
        self.predicates.contains(atom.predicate.index())
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
            PddlState::Atoms(listed) => self.listed(texts, listed, path)?,
            PddlState::Change { add, delete } => {
                let fixed = "an atom of a predicate that no action changes";
                let check = |there: bool, atom: &Atom| match initial.binary_search(atom).is_ok() {
                    _ if self.holds(atom) => Some(fixed),
                    true if !there => Some("an atom that holds in the initial state already"),
                    false if there => Some("an atom that does not hold in the initial state"),
                    _ => None,
                };
                let gone = read(texts, delete, &format!("{path}.delete"), |a| check(true, a))?;
                let new = read(texts, add, &format!("{path}.add"), |atom| check(false, atom))?;
                let stays = |atom: &&Atom| gone.binary_search(atom).is_err();
                initial.iter().filter(stays).cloned().chain(new).collect()
            }
        };
        atoms.sort_unstable();
        atoms.dedup();
        Ok(atoms)
    }

    /// The atoms listed, and those that no action changes where the list does not deny them.
    fn listed(
        &self,
        texts: &Texts,
        listed: &[String],
        path: &str,
    ) -> Result<Vec<Atom>, DocumentError> {
        let initial = &texts.task.initial;
        let mut atoms = Vec::with_capacity(listed.len());
        let mut denied = Vec::new();
        for (index, text) in listed.iter().enumerate() {
            let path = format!("{path}[{index}]");
            let literals = read_literals(&texts.domain, &texts.task, text);
            let (hold, fail) = literals.map_err(|e| at(&path, e))?;
            let differs = |atom: &Atom, holds: bool| {
                self.holds(atom) && initial.binary_search(atom).is_ok() != holds
            };
            if hold.iter().any(|atom| differs(atom, true)) || fail.iter().any(|a| differs(a, false))
            {
                let found = "an atom of a predicate that no action changes";
                let expected = "only those that are in the :init";
                return Err(DocumentError::invalid(path, found, expected));
            }
            atoms.extend(hold);
            denied.extend(fail.into_iter().map(|atom| (atom, index)));
        }
        atoms.sort_unstable();
        denied.sort_unstable();
        if let Some((_, index)) = denied.iter().find(|(atom, _)| atoms.binary_search(atom).is_ok())
        {
            let found = "the negation of an atom that is listed too";
            return Err(DocumentError::invalid(format!("{path}[{index}]"), found, "one of them"));
        }
        let is_denied = |atom: &Atom| denied.binary_search_by(|(other, _)| other.cmp(atom)).is_ok();
        atoms.extend(self.atoms.iter().filter(|atom| !is_denied(atom)).cloned());
        Ok(atoms)
    }
}

/// Reads atoms that change the initial state; `check` says what is wrong with one.
fn read(
    texts: &Texts,
    atoms: &[String],
    path: &str,
    check: impl Fn(&Atom) -> Option<&'static str>,
) -> Result<Vec<Atom>, DocumentError> {
    let mut all = Vec::with_capacity(atoms.len());
    for (index, text) in atoms.iter().enumerate() {
        let path = format!("{path}[{index}]");
        let atoms = read_atoms(&texts.domain, &texts.task, text).map_err(|e| at(&path, e))?;
        if let Some(found) = atoms.iter().find_map(&check) {
            return Err(DocumentError::invalid(path, found, "an atom that makes a difference"));
        }
        all.extend(atoms);
    }
    all.sort_unstable();
    Ok(all)
}
