//! Whether a pattern over operators fits any.
//!
//! Asked is whether some instance of the action fits whose arguments have the right types, whose
//! equalities hold, and whose preconditions on predicates that no action changes hold at first.
//! Whether the operator can ever apply is left open: a document may speak of what this task never
//! comes to.

use fixedbitset::FixedBitSet;

use super::atom::{Atom, LiftedAtom, Term};
use super::definition::TaskDefinition;
use super::domain::Domain;
use super::object::ObjectId;
use super::pattern::Pattern;
use super::schema::Schema;

/// Objects tried, at most; after that a pattern is taken for one that fits.
const MAX_STEPS: usize = 1_000_000;

/// Objects in the places of a schema's parameters, one after the other.
struct Search<'a> {
    task: &'a TaskDefinition,
    schema: &'a Schema,
    /// What no action changes, each with the position of its last parameter.
    fixed: Vec<(&'a LiftedAtom, bool)>,
    pattern: &'a Pattern,
    objects: Vec<ObjectId>,
    steps: usize,
}

impl Pattern {
    /// Whether some operator of the task could match.
    pub fn fits_some(&self, domain: &Domain, task: &TaskDefinition) -> bool {
        let Some(number) = self.schema() else { return true };
        if self.takes_all_arguments() {
            return true;
        }
        let name = &domain.schemas[number].name;
        let mut changes = FixedBitSet::with_capacity(domain.predicates.len());
        changes.extend(domain.changing());
        let is_fixed = |atom: &&LiftedAtom| !changes.contains(atom.predicate.index());
        let mut cases = domain.schemas.iter().filter(|schema| schema.name == *name);
        cases.any(|schema| {
            let positive = schema.precondition.positive.iter().map(|atom| (atom, true));
            let negative = schema.precondition.negative.iter().map(|atom| (atom, false));
            let fixed = positive.chain(negative).filter(|(atom, _)| is_fixed(atom)).collect();
            let objects = Vec::new();
            Search { task, schema, fixed, pattern: self, objects, steps: 0 }.any()
        })
    }
}

impl Search<'_> {
    /// Recurses once for each parameter.
    fn any(&mut self) -> bool {
        let position = self.objects.len();
        if position == self.schema.parameters.len() {
            return true;
        }
        let types = self.schema.parameters.types(position as u32);
        for object in self.task.objects.ids() {
            self.steps += 1;
            if self.steps > MAX_STEPS {
                return true;
            }
            if !self.task.objects.types(object).is_within(types)
                || !self.pattern.allows(self.task, position, object, &self.objects)
            {
                continue;
            }
            self.objects.push(object);
            if self.holds(position) && self.any() {
                return true;
            }
            self.objects.pop();
        }
        false
    }

    fn object(&self, term: Term) -> Option<ObjectId> {
        match term {
            Term::Object(object) => Some(object),
            Term::Parameter(position) => self.objects.get(position as usize).copied(),
        }
    }

    /// Whether nothing that is known since this position has a value is false.
    fn holds(&self, position: usize) -> bool {
        let last = |terms: &[Term]| {
            let positions = terms.iter().map(|term| match term {
                Term::Object(_) => 0,
                Term::Parameter(position) => *position as usize,
            });
            positions.max().unwrap_or(0) == position
        };
        let pair = |one: Term, other: Term, wanted: bool| {
            !last(&[one, other]) || (self.object(one) == self.object(other)) == wanted
        };
        let precondition = &self.schema.precondition;
        precondition.equal.iter().all(|&(one, other)| pair(one, other, true))
            && precondition.unequal.iter().all(|&(one, other)| pair(one, other, false))
            && self.fixed.iter().filter(|(atom, _)| last(&atom.terms)).all(|&(atom, wanted)| {
                let objects = atom.terms.iter().map(|&term| self.object(term));
                let Some(objects) = objects.collect::<Option<Box<[ObjectId]>>>() else {
                    return true;
                };
                let atom = Atom { predicate: atom.predicate, objects };
                self.task.initial.binary_search(&atom).is_ok() == wanted
            })
    }
}
