//! Action schemas as grounding sees them: equalities are substituted.

use super::atom::{LiftedAtom, Term};
use super::domain::Domain;
use super::effect::ConditionalEffect;
use super::formula::Formula;
use super::object::{ObjectId, Objects};
use super::reach::object;
use super::schema::Schema;
use super::types::TypeSet;

/// A schema over *slots*: parameters that must be equal share one, and a parameter that must equal
/// an object is that object. [`Term::Parameter`] stands for a slot here.
#[derive(Debug)]
pub(super) struct Rule<'a> {
    /// The number of the schema.
    pub schema: usize,
    /// What each parameter of the schema is.
    pub arguments: Vec<Term>,
    /// The types that each slot must be of.
    pub slots: Vec<Vec<&'a TypeSet>>,
    pub positive: Vec<LiftedAtom>,
    pub negative: Vec<LiftedAtom>,
    /// For each slot what it must differ from.
    pub unequal: Vec<Vec<Term>>,
    pub add: Vec<LiftedAtom>,
    /// What is also added is left out where that can be seen here.
    pub delete: Vec<LiftedAtom>,
    /// What else must hold before, over the parameters of the schema.
    pub rest: &'a [Formula],
    /// Effects under conditions or for all objects, over the parameters of the schema.
    pub conditional: &'a [ConditionalEffect],
    /// For each slot in no positive precondition, the objects of its types.
    pub free: Vec<(u32, Vec<ObjectId>)>,
}

impl<'a> Rule<'a> {
    /// The rule of a schema; none where its equalities can never hold.
    pub(super) fn new(domain: &'a Domain, number: usize, objects: &Objects) -> Option<Self> {
        let schema = &domain.schemas[number];
        let arguments = substitute(schema)?;
        let mut slots: Vec<Vec<&TypeSet>> = Vec::new();
        for (position, &term) in (0..).zip(&arguments) {
            let types = schema.parameters.types(position);
            match term {
                Term::Object(object) if !objects.types(object).is_within(types) => return None,
                Term::Object(_) => {}
                Term::Parameter(slot) => {
                    let slot = slot as usize;
                    slots.resize_with(slots.len().max(slot + 1), Vec::new);
                    slots[slot].push(types);
                }
            }
        }
        let replace = |term: &Term| match *term {
            Term::Parameter(position) => arguments[position as usize],
            object @ Term::Object(_) => object,
        };
        let all = |atoms: &[LiftedAtom]| {
            let atom = |atom: &LiftedAtom| LiftedAtom {
                predicate: atom.predicate,
                terms: atom.terms.iter().map(replace).collect(),
            };
            let mut atoms: Vec<LiftedAtom> = atoms.iter().map(atom).collect();
            atoms.sort_unstable();
            atoms.dedup();
            atoms
        };
        let unequal = schema.precondition.unequal.iter();
        let pairs: Vec<_> = unequal.map(|(a, b)| (replace(a), replace(b))).collect();
        if pairs.iter().any(|(one, other)| one == other) {
            return None;
        }
        let mut unequal = vec![Vec::new(); slots.len()];
        for (one, other) in pairs.iter().flat_map(|&(a, b)| [(a, b), (b, a)]) {
            // Two objects do differ, or there would be no rule.
            if let Term::Parameter(slot) = one {
                unequal[slot as usize].push(other);
            }
        }
        let positive = all(&schema.precondition.positive);
        let add = all(&schema.effect.positive);
        let mut delete = all(&schema.effect.negative);
        delete.retain(|atom| add.binary_search(atom).is_err());
        let mut rule = Self {
            schema: number,
            slots,
            negative: all(&schema.precondition.negative),
            unequal,
            add,
            delete,
            rest: &schema.rest,
            conditional: &schema.conditional,
            free: Vec::new(),
            positive,
            arguments,
        };
        rule.free = rule.free_slots(objects);
        Some(rule)
    }

    /// Whether it is one of STRIPS.
    pub(super) fn is_plain(&self) -> bool {
        self.rest.is_empty() && self.conditional.is_empty()
    }

    /// The objects in the places of the schema's parameters.
    pub(super) fn arguments_of(&self, values: &[ObjectId]) -> Vec<ObjectId> {
        self.arguments.iter().map(|&term| object(term, values)).collect()
    }

    /// For each conditional effect that adds an atom a rule that adds it always, with further slots for its
    /// variables: good enough to guess invariants from.
    pub(super) fn guesses(&self) -> Vec<Self> {
        let count = self.slots.len() as u32;
        let parameters = self.arguments.len() as u32;
        let slot = |term: &Term| match *term {
            Term::Parameter(position) if position < parameters => self.arguments[position as usize],
            Term::Parameter(position) => Term::Parameter(count + position - parameters),
            object @ Term::Object(_) => object,
        };
        let lifted = |atom: &LiftedAtom| LiftedAtom {
            predicate: atom.predicate,
            terms: atom.terms.iter().map(slot).collect(),
        };
        let deleted = self.conditional.iter().filter(|effect| !effect.add);
        let deleted: Vec<LiftedAtom> = deleted.map(|effect| lifted(&effect.atom)).collect();
        let guess = |effect: &ConditionalEffect| {
            let mut positive = self.positive.clone();
            if let Formula::And(parts) = &effect.condition {
                let mut literals = super::literals::Literals::default();
                let mut rest = Vec::new();
                parts.iter().cloned().for_each(|part| literals.take(part, &mut rest));
                positive.extend(literals.positive.iter().map(lifted));
            }
            let variables = effect.variables.iter().map(|(position, _)| *position + 1).max();
            let more = variables.unwrap_or(parameters) - parameters;
            Self {
                schema: self.schema,
                arguments: self.arguments.clone(),
                slots: vec![Vec::new(); (count + more) as usize],
                positive,
                negative: Vec::new(),
                unequal: Vec::new(),
                add: vec![lifted(&effect.atom)],
                delete: self.delete.iter().chain(&deleted).cloned().collect(),
                rest: &[],
                conditional: &[],
                free: Vec::new(),
            }
        };
        self.conditional.iter().filter(|effect| effect.add).map(guess).collect()
    }

    fn free_slots(&self, objects: &Objects) -> Vec<(u32, Vec<ObjectId>)> {
        let mut bound = vec![false; self.slots.len()];
        for term in self.positive.iter().flat_map(|atom| &atom.terms) {
            if let Term::Parameter(slot) = term {
                bound[*slot as usize] = true;
            }
        }
        let free = (0..self.slots.len() as u32).filter(|&slot| !bound[slot as usize]);
        let of_types = |slot| objects.ids().filter(|&id| self.fits(slot, id, objects)).collect();
        free.map(|slot| (slot, of_types(slot))).collect()
    }

    /// Whether an object is of the types of a slot.
    pub(super) fn fits(&self, slot: u32, object: ObjectId, objects: &Objects) -> bool {
        let types = objects.types(object);
        self.slots[slot as usize].iter().all(|wanted| types.is_within(wanted))
    }
}

/// What each parameter is once the equalities are heeded; none where they contradict each other.
fn substitute(schema: &Schema) -> Option<Vec<Term>> {
    let count = schema.parameters.len() as u32;
    let mut class: Vec<Term> = (0..count).map(Term::Parameter).collect();
    for &(one, other) in &schema.precondition.equal {
        let find = |term: Term| match term {
            Term::Parameter(position) => class[position as usize],
            Term::Object(_) => term,
        };
        let (from, to) = match (find(one), find(other)) {
            (one, other) if one == other => continue,
            (Term::Object(_), Term::Object(_)) => return None,
            (object @ Term::Object(_), parameter) | (parameter, object) => (parameter, object),
        };
        for term in &mut class {
            if *term == from {
                *term = to;
            }
        }
    }
    // The parameters that are left, numbered without gaps.
    let mut slots: Vec<Term> = Vec::new();
    let mut number = |term: Term| match term {
        Term::Object(_) => term,
        Term::Parameter(_) => {
            let known = slots.iter().position(|&slot| slot == term);
            Term::Parameter(known.unwrap_or_else(|| {
                slots.push(term);
                slots.len() - 1
            }) as u32)
        }
    };
    Some(class.into_iter().map(&mut number).collect())
}
