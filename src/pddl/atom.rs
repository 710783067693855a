//! Atoms: a predicate with terms in the places of its parameters.

use super::cost::Functions;
use super::domain::Domain;
use super::error::PddlError;
use super::expression::{Expression, Expressions};
use super::object::{ObjectId, Objects};
use super::predicate::{PredicateId, Predicates};
use super::schema::Parameters;
use super::types::{TypeSet, Types};

/// What stands in the place of a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Term {
    /// A parameter of the action, by its position.
    Parameter(u32),
    /// An object or a constant.
    Object(ObjectId),
}

/// An atom that may hold parameters of an action.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LiftedAtom {
    /// Its predicate.
    pub predicate: PredicateId,
    /// What stands in the places of its parameters.
    pub terms: Box<[Term]>,
}

/// An atom over objects alone.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Atom {
    /// Its predicate.
    pub predicate: PredicateId,
    /// Its objects.
    pub objects: Box<[ObjectId]>,
}

impl Atom {
    /// As PDDL writes it, with the names of a domain and of objects over it.
    pub fn written(&self, domain: &Domain, objects: &Objects) -> String {
        let mut text = "(".to_owned() + domain.predicates.name(self.predicate);
        for &object in &self.objects {
            text.push(' ');
            text.push_str(objects.name(object));
        }
        text + ")"
    }
}

/// The names that a condition or an effect may use.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scope<'a> {
    pub types: &'a Types,
    pub predicates: &'a Predicates,
    pub objects: &'a Objects,
    pub functions: &'a Functions,
    /// None outside of actions and quantifiers.
    pub parameters: Option<&'a Parameters>,
}

impl Scope<'_> {
    /// An object, a constant or a parameter.
    pub(super) fn term(&self, place: Expression<'_>) -> Result<Term, PddlError> {
        if !place.symbol().is_some_and(|name| name.starts_with('?')) {
            return self.objects.find(place).map(Term::Object);
        }
        let name = place.variable()?;
        match self.parameters {
            None => Err(place.expected("an object, no variable")),
            Some(parameters) => parameters.position(&name).map(Term::Parameter).ok_or_else(|| {
                let found = format!("the undeclared variable {}", place.shown());
                place.wrong(found, format!("a parameter: {}", parameters.written()))
            }),
        }
    }

    fn types_of(&self, term: Term) -> Option<&TypeSet> {
        match term {
            Term::Object(object) => Some(self.objects.types(object)),
            Term::Parameter(position) => {
                self.parameters.map(|parameters| parameters.types(position))
            }
        }
    }

    /// Whether a term may be of these types.
    pub(super) fn fits(&self, term: Term, wanted: &TypeSet) -> bool {
        self.types_of(term).is_none_or(|found| match term {
            Term::Object(_) => found.is_within(wanted),
            Term::Parameter(_) => found.meets(wanted),
        })
    }

    /// An atom whose head has been read: arity and types are checked.
    pub(super) fn atom(
        &self,
        whole: Expression<'_>,
        head: Expression<'_>,
        arguments: Expressions<'_>,
    ) -> Result<LiftedAtom, PddlError> {
        let predicate = self.predicates.find(head)?;
        let parameters = self.predicates.parameters(predicate);
        let mut terms = Vec::with_capacity(parameters.len());
        let mut count = 0;
        for argument in arguments {
            count += 1;
            let Some(wanted) = parameters.get(terms.len()) else { continue };
            let term = self.term(argument)?;
            // A parameter may be of a type that is wider than the predicate's; then only the
            // objects that fit can make the atom hold.
            if !self.fits(term, wanted) {
                let types = self.types_of(term).map(|types| self.types.written(types));
                let found =
                    format!("{} of the type {}", argument.shown(), types.unwrap_or_default());
                let expected = format!(
                    "{} as argument {count} of {}",
                    self.types.written(wanted),
                    self.predicates.name(predicate)
                );
                return Err(argument.wrong(found, expected));
            }
            terms.push(term);
        }
        if count != parameters.len() {
            let found = format!("{} with {}", whole.shown(), arguments_of(count));
            let expected = format!(
                "{} for {}",
                arguments_of(parameters.len()),
                self.predicates.name(predicate)
            );
            return Err(whole.wrong(found, expected));
        }
        Ok(LiftedAtom { predicate, terms: terms.into_boxed_slice() })
    }
}

pub(super) fn arguments_of(count: usize) -> String {
    match count {
        0 => "no argument".to_owned(),
        1 => "1 argument".to_owned(),
        _ => format!("{count} arguments"),
    }
}

impl LiftedAtom {
    /// The atom without parameters; none where it has one.
    pub(super) fn ground(&self) -> Option<Atom> {
        let object = |term: &Term| match term {
            Term::Object(object) => Some(*object),
            Term::Parameter(_) => None,
        };
        let objects = self.terms.iter().map(object).collect::<Option<_>>()?;
        Some(Atom { predicate: self.predicate, objects })
    }
}
