//! Formulas over ground atoms, and how a lifted formula becomes one.

use super::atom::Term;
use super::formula::Formula;
use super::object::{ObjectId, Objects};
use super::predicate::PredicateId;

/// A formula over ground atoms in negation normal form. What always holds is the empty conjunction, what never does
/// the empty disjunction; both stand alone, in no other formula.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum GroundFormula<A> {
    /// An atom that must hold (true) or must not.
    Atom(A, bool),
    /// All of these: none, or two at least.
    And(Vec<GroundFormula<A>>),
    /// One of these at least: none, or two at least.
    Or(Vec<GroundFormula<A>>),
}

impl<A: Clone + PartialEq> GroundFormula<A> {
    /// What holds always, or never.
    pub fn constant(holds: bool) -> Self {
        if holds { Self::And(Vec::new()) } else { Self::Or(Vec::new()) }
    }

    /// Whether it holds always (true) or never (false), as far as its form shows.
    pub fn value(&self) -> Option<bool> {
        match self {
            Self::And(parts) if parts.is_empty() => Some(true),
            Self::Or(parts) if parts.is_empty() => Some(false),
            _ => None,
        }
    }

    /// All (true) or one at least (false) of these.
    pub(super) fn join(conjunction: bool, parts: impl IntoIterator<Item = Self>) -> Self {
        let mut kept: Vec<Self> = Vec::new();
        for part in parts {
            match part.value() {
                Some(value) if value == conjunction => continue,
                Some(value) => return Self::constant(value),
                None => {}
            }
            match part {
                Self::And(inner) if conjunction => kept.extend(inner),
                Self::Or(inner) if !conjunction => kept.extend(inner),
                other => kept.push(other),
            }
        }
        match kept.len() {
            0 => Self::constant(conjunction),
            1 => kept.swap_remove(0),
            _ if conjunction => Self::And(kept),
            _ => Self::Or(kept),
        }
    }

    /// The formula with another one in the place of each atom that must hold or must not.
    pub(super) fn replace<B: Clone + PartialEq>(
        &self,
        of: &mut impl FnMut(&A, bool) -> GroundFormula<B>,
    ) -> GroundFormula<B> {
        match self {
            Self::Atom(atom, holds) => of(atom, *holds),
            Self::And(parts) | Self::Or(parts) => {
                let conjunction = matches!(self, Self::And(_));
                let parts: Vec<_> = parts.iter().map(|part| part.replace(of)).collect();
                GroundFormula::join(conjunction, parts)
            }
        }
    }

    /// What holds where this does not.
    pub(super) fn negated(&self) -> Self {
        match self {
            Self::Atom(atom, holds) => Self::Atom(atom.clone(), !holds),
            Self::And(parts) => Self::Or(parts.iter().map(Self::negated).collect()),
            Self::Or(parts) => Self::And(parts.iter().map(Self::negated).collect()),
        }
    }

    /// The conjuncts.
    pub(super) fn conjuncts(&self) -> &[Self] {
        match self {
            Self::And(parts) => parts,
            other => std::slice::from_ref(other),
        }
    }

    /// Calls `visit` with each atom.
    pub(super) fn atoms(&self, visit: &mut impl FnMut(&A)) {
        match self {
            Self::Atom(atom, _) => visit(atom),
            Self::And(parts) | Self::Or(parts) => parts.iter().for_each(|part| part.atoms(visit)),
        }
    }

    /// Whether it holds where exactly the atoms hold for which `of` says so.
    pub fn holds(&self, of: &impl Fn(&A) -> bool) -> bool {
        match self {
            Self::Atom(atom, wanted) => of(atom) == *wanted,
            Self::And(parts) => parts.iter().all(|part| part.holds(of)),
            Self::Or(parts) => parts.iter().any(|part| part.holds(of)),
        }
    }

    /// As a disjunction of conjunctions of literals; none where there would be more than `most`.
    pub(super) fn alternatives(&self, most: usize) -> Option<Vec<Vec<(A, bool)>>> {
        let all = match self {
            Self::Atom(atom, holds) => vec![vec![(atom.clone(), *holds)]],
            Self::Or(parts) => {
                let mut all = Vec::new();
                for part in parts {
                    all.extend(part.alternatives(most)?);
                }
                all
            }
            Self::And(parts) => {
                let mut all = vec![Vec::new()];
                for part in parts {
                    let more = part.alternatives(most)?;
                    if all.len().saturating_mul(more.len()) > most {
                        return None;
                    }
                    let with = |before: &Vec<(A, bool)>| {
                        let before = before.clone();
                        more.iter()
                            .map(move |next| [before.as_slice(), next.as_slice()].concat())
                            .collect::<Vec<_>>()
                    };
                    all = all.iter().flat_map(with).collect();
                }
                all
            }
        };
        (all.len() <= most).then_some(all)
    }
}

/// The objects in the places of a formula's variables, while it is made a ground one.
pub(super) struct Expansion<'a> {
    pub objects: &'a Objects,
    /// The object of each position, those of quantifiers last.
    pub values: Vec<ObjectId>,
    /// Atoms and equalities that may still be looked at.
    pub budget: &'a mut u64,
}

impl Expansion<'_> {
    /// The object that a term stands for.
    pub(super) fn object(&self, term: Term) -> ObjectId {
        match term {
            Term::Object(object) => object,
            Term::Parameter(position) => self.values[position as usize],
        }
    }

    /// The ground formula, in which `atom` stands for each atom that must hold or must not; none where the budget
    /// does not suffice. What cannot matter any more is not looked at.
    pub(super) fn formula<A: Clone + PartialEq>(
        &mut self,
        formula: &Formula,
        atom: &impl Fn(PredicateId, &[ObjectId], bool) -> GroundFormula<A>,
    ) -> Option<GroundFormula<A>> {
        match formula {
            Formula::Atom(lifted, holds) => {
                self.count(1)?;
                let objects: Vec<ObjectId> =
                    lifted.terms.iter().map(|&term| self.object(term)).collect();
                Some(atom(lifted.predicate, &objects, *holds))
            }
            Formula::Equal(one, other, holds) => {
                self.count(1)?;
                Some(GroundFormula::constant((self.object(*one) == self.object(*other)) == *holds))
            }
            Formula::And(parts) | Formula::Or(parts) => {
                let conjunction = matches!(formula, Formula::And(_));
                let mut found = Vec::with_capacity(parts.len());
                for part in parts {
                    let part = self.formula(part, atom)?;
                    let decides = part.value() == Some(!conjunction);
                    found.push(part);
                    if decides {
                        break;
                    }
                }
                Some(GroundFormula::join(conjunction, found))
            }
            Formula::Forall(variables, body) | Formula::Exists(variables, body) => {
                let conjunction = matches!(formula, Formula::Forall(..));
                let mut found = Vec::new();
                self.for_all(variables, &mut |expansion| {
                    let part = expansion.formula(body, atom)?;
                    let decides = part.value() == Some(!conjunction);
                    if part.value() != Some(conjunction) {
                        found.push(part);
                    }
                    Some(!decides)
                })?;
                Some(GroundFormula::join(conjunction, found))
            }
        }
    }

    /// Calls `visit` with every choice of objects for variables until it answers that this is enough (false); none
    /// where the budget does not suffice.
    pub(super) fn for_all(
        &mut self,
        variables: &[super::formula::Bound],
        visit: &mut dyn FnMut(&mut Self) -> Option<bool>,
    ) -> Option<bool> {
        let Some(((position, types), rest)) = variables.split_first() else {
            self.count(1)?;
            return visit(self);
        };
        let before = self.values.clone();
        // Positions are given in order; one that lies further back is in no scope here.
        self.values.resize(*position as usize + 1, ObjectId::new(0));
        let objects = self.objects;
        for object in objects.ids() {
            if objects.types(object).is_within(types) {
                self.values.truncate(*position as usize);
                self.values.push(object);
                if !self.for_all(rest, visit)? {
                    self.values = before;
                    return Some(false);
                }
            }
        }
        self.values = before;
        Some(true)
    }

    fn count(&mut self, steps: u64) -> Option<()> {
        *self.budget = self.budget.checked_sub(steps)?;
        Some(())
    }
}
