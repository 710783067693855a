//! Action schemas: actions with parameters.

use std::sync::Arc;

use rustc_hash::FxHashMap;

use super::atom::Scope;
use super::cost::CostTerm;
use super::effect::{ConditionalEffect, Effects};
use super::error::PddlError;
use super::expression::{Expression, Expressions};
use super::feature::unsupported;
use super::formula::Formula;
use super::literals::{Literals, MAX_LITERALS};
use super::types::{TypeSet, Types, some};

/// The most parameters of an action.
pub const MAX_PARAMETERS: usize = 64;

/// The parameters of an action.
#[derive(Debug, Clone, Default)]
pub struct Parameters {
    names: Vec<String>,
    types: Vec<Arc<TypeSet>>,
    positions: FxHashMap<String, u32>,
}

impl Parameters {
    fn read(types: &Types, place: Expression<'_>) -> Result<Self, PddlError> {
        let mut parameters = Self::default();
        let items = place.items("a list of parameters, as in (?x ?y - block)")?;
        for (item, set) in types.list(items)? {
            let name = item.variable()?;
            if parameters.position(&name).is_some() {
                let found = format!("the parameter {} for the second time", item.shown());
                return Err(item.wrong(found, "each parameter declared once"));
            }
            parameters.push(item, name, set)?;
        }
        Ok(parameters)
    }

    /// Adds one that is not there yet.
    pub(super) fn push(
        &mut self,
        place: Expression<'_>,
        name: String,
        types: Arc<TypeSet>,
    ) -> Result<(), PddlError> {
        if self.names.len() == MAX_PARAMETERS {
            let found = format!("more than {MAX_PARAMETERS} parameters");
            return Err(place.wrong(found, "at most that"));
        }
        self.positions.insert(name.clone(), self.names.len() as u32);
        self.names.push(name);
        self.types.push(types);
        Ok(())
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.names.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.names.is_empty()
    }

    /// The names, in small letters, their question marks included.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The types of the one at a position.
    pub fn types(&self, position: u32) -> &TypeSet {
        &self.types[position as usize]
    }

    /// The types of the one at a position, to be shared.
    pub(super) fn shared_types(&self, position: u32) -> &Arc<TypeSet> {
        &self.types[position as usize]
    }

    /// The position of the one of this name.
    pub(super) fn position(&self, name: &str) -> Option<u32> {
        self.positions.get(name).copied()
    }

    /// Some names, for an error.
    pub(super) fn written(&self) -> String {
        if self.is_empty() {
            return "there is none".to_owned();
        }
        some(self.names.iter().map(String::as_str))
    }
}

/// An action with parameters.
#[derive(Debug, Clone)]
pub struct Schema {
    /// Its name, in small letters.
    pub name: String,
    /// Its parameters.
    pub parameters: Parameters,
    /// The literals that must hold before.
    pub precondition: Literals,
    /// What else must hold before: disjunctions and quantified formulas.
    pub rest: Vec<Formula>,
    /// What is added (positive) and deleted (negative) always. What is both is added.
    pub effect: Literals,
    /// What is added and deleted under a condition or for all objects.
    pub conditional: Vec<ConditionalEffect>,
    /// What it costs: the sum of these.
    pub cost: Vec<CostTerm>,
}

impl Schema {
    /// Whether another action of its name can be a case of the same action: one that goes by the same parameters
    /// and costs the same.
    pub(super) fn is_case_of(&self, other: &Self) -> bool {
        let types = |schema: &Self| -> Vec<Vec<super::types::TypeId>> {
            schema.parameters.types.iter().map(|types| types.types().to_vec()).collect()
        };
        types(self) == types(other) && self.cost == other.cost
    }

    /// Whether it is one of STRIPS: nothing but literals, and effects that it always has.
    pub fn is_plain(&self) -> bool {
        self.rest.is_empty() && self.conditional.is_empty()
    }

    /// Reads what follows `:action`. The scope is that of the domain, without parameters.
    pub(super) fn read(
        scope: &Scope<'_>,
        place: Expression<'_>,
        mut items: Expressions<'_>,
    ) -> Result<Self, PddlError> {
        const EXPECTED: &str = ":parameters, :precondition or :effect";
        let Some(name) = items.next() else {
            return Err(place.wrong("an action without a name", "(:action name …)"));
        };
        let name = name.name("the name of an action")?;
        let mut parts = [None; 3];
        while let Some(key) = items.next() {
            let Some(part) =
                [":parameters", ":precondition", ":effect"].iter().position(|known| key.is(known))
            else {
                return Err(unsupported(key, key).unwrap_or_else(|| key.expected(EXPECTED)));
            };
            let Some(value) = items.next() else {
                return Err(key.wrong(format!("{} at the end", key.shown()), "what it says"));
            };
            if parts[part].replace(value).is_some() {
                let found = format!("{} for the second time", key.shown());
                return Err(key.wrong(found, "each part of an action once"));
            }
        }
        let [parameters, precondition, effect] = parts;
        let parameters = match parameters {
            Some(place) => Parameters::read(scope.types, place)?,
            None => Parameters::default(),
        };
        let scope = Scope { parameters: Some(&parameters), ..*scope };
        let size = |place: Expression<'_>, size: usize| {
            if size > MAX_LITERALS {
                let expected = format!("at most {MAX_LITERALS} in one action");
                return Err(place.wrong(format!("{size} literals"), expected));
            }
            Ok(())
        };
        let mut literals = Literals::default();
        let mut rest = Vec::new();
        let mut effects = Effects::default();
        if let Some(place) = precondition {
            let formula = Formula::read(&scope, place)?;
            size(place, formula.len())?;
            literals.take(formula, &mut rest);
        }
        if let Some(place) = effect {
            effects = Effects::read(&scope, place)?;
            size(place, effects.len())?;
        }
        let Effects { always: effect, conditional, cost } = effects;
        Ok(Self { name, parameters, precondition: literals, rest, effect, conditional, cost })
    }
}
