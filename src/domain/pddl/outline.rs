//! What a page needs to show a PDDL document: objects, predicates, and what holds at first.

use serde::Serialize;

use super::Pddl;
use crate::document::DocumentError;
use crate::domain::observers::true_goal;
use crate::pddl::{Atom, TypeId};

/// A PDDL document in names. Atoms are texts as in the labels of states: `(on a b)`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Outline {
    /// The name of the domain.
    pub domain: String,
    /// The objects of the problem and the constants of the domain.
    pub objects: Vec<OutlineObject>,
    /// The predicates of the domain.
    pub predicates: Vec<OutlinePredicate>,
    /// All atoms that hold at first; those that no action changes stand in no label of a state.
    pub initial: Vec<String>,
}

/// An object.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct OutlineObject {
    /// Its name.
    pub name: String,
    /// All types that it is of, `object` among them.
    pub types: Vec<String>,
}

/// A predicate.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct OutlinePredicate {
    /// Its name.
    pub name: String,
    /// How many arguments it has.
    pub arguments: usize,
    /// Whether any action changes its atoms.
    pub changes: bool,
}

impl Pddl {
    /// What there is to show.
    ///
    /// # Errors
    ///
    /// [`DocumentError`] where the PDDL cannot be read.
    pub fn outline(&self) -> Result<Outline, DocumentError> {
        let names: Vec<&str> = self.goals.iter().map(|goal| goal.name.as_str()).collect();
        let texts = self.texts(true_goal(&names, &self.true_goal)?)?;
        let (domain, task) = (&texts.domain, &texts.task);
        let mut changes = vec![false; domain.predicates.len()];
        for predicate in domain.changing() {
            changes[predicate] = true;
        }
        let predicate = |(id, changes)| OutlinePredicate {
            name: domain.predicates.name(id).to_owned(),
            arguments: domain.predicates.parameters(id).len(),
            changes,
        };
        let object = |id| OutlineObject {
            name: task.objects.name(id).to_owned(),
            types: domain
                .types
                .ids()
                .filter(|&kind: &TypeId| task.objects.types(id).is_within(domain.types.alone(kind)))
                .map(|kind| domain.types.name(kind).to_owned())
                .collect(),
        };
        let atom = |atom: &Atom| atom.written(domain, &task.objects);
        Ok(Outline {
            domain: domain.name.clone(),
            objects: task.objects.ids().map(object).collect(),
            predicates: domain.predicates.ids().zip(changes).map(predicate).collect(),
            initial: task.initial.iter().map(atom).collect(),
        })
    }
}
