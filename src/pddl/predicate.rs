//! Predicates.

use std::sync::Arc;

use rustc_hash::FxHashMap;

use super::error::PddlError;
use super::expression::{Expression, Expressions};
use super::types::{TypeSet, Types, some};

/// A predicate of a domain, by its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PredicateId(u32);

impl PredicateId {
    pub(super) fn new(index: usize) -> Self {
        Self(index as u32)
    }

    /// Its number.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// The predicates of a domain, with the types of their parameters.
#[derive(Debug, Clone, Default)]
pub struct Predicates {
    names: Vec<String>,
    parameters: Vec<Box<[Arc<TypeSet>]>>,
    numbers: FxHashMap<String, PredicateId>,
}

impl Predicates {
    /// Reads a `:predicates` section.
    pub(super) fn read(types: &Types, items: Expressions<'_>) -> Result<Self, PddlError> {
        const EXPECTED: &str = "a predicate, as in (on ?x ?y)";
        let mut predicates = Self::default();
        for item in items {
            let (head, parameters) = item.headed(EXPECTED)?;
            let parameters = types.list(parameters)?;
            for (variable, _) in &parameters {
                variable.variable()?;
            }
            // Some domains declare it, though it needs no declaration.
            if head.is("=") {
                continue;
            }
            let name = head.name("the name of a predicate")?;
            let id = PredicateId::new(predicates.names.len());
            if predicates.numbers.insert(name.clone(), id).is_some() {
                let found = format!("the predicate {} for the second time", head.shown());
                return Err(head.wrong(found, "each predicate declared once"));
            }
            predicates.names.push(name);
            predicates.parameters.push(parameters.into_iter().map(|(_, set)| set).collect());
        }
        Ok(predicates)
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.names.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.names.is_empty()
    }

    /// All of them, in order.
    pub fn ids(&self) -> impl Iterator<Item = PredicateId> + use<> {
        (0..self.names.len()).map(PredicateId::new)
    }

    /// The name of one, in small letters.
    pub fn name(&self, id: PredicateId) -> &str {
        &self.names[id.index()]
    }

    /// The one of this name, which stands here in small letters.
    pub fn named(&self, name: &str) -> Option<PredicateId> {
        self.numbers.get(name).copied()
    }

    /// The types of its parameters.
    pub fn parameters(&self, id: PredicateId) -> &[Arc<TypeSet>] {
        &self.parameters[id.index()]
    }

    /// The predicate named here.
    pub(super) fn find(&self, place: Expression<'_>) -> Result<PredicateId, PddlError> {
        let name = place.name("the name of a predicate")?;
        self.named(&name).ok_or_else(|| {
            let found = format!("the undeclared predicate {}", place.shown());
            let names = some(self.names.iter().map(String::as_str));
            place.wrong(found, format!("a predicate of the domain: {names}"))
        })
    }
}
