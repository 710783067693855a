//! Costs of actions: numeric functions whose values never change, and `total-cost`, which they are added to.
//!
//! Read is what `:action-costs` allows (PDDL 3.1): functions with numbers as values given in the `:init`, effects
//! `(increase (total-cost) …)` by a number or a function's value, and `(:metric minimize (total-cost))`. Costs are whole
//! numbers from 0. Without the metric they do not count.

use std::sync::Arc;

use rustc_hash::FxHashMap;

use super::atom::{Scope, Term, arguments_of};
use super::error::{PddlError, quoted};
use super::expression::{Expression, Expressions};
use super::object::ObjectId;
use super::types::{TypeSet, Types, some, typed_list};

/// The largest value of a function and the largest cost of one action.
pub const MAX_COST: u64 = 1_000_000_000;

/// The name of what costs are added to.
const TOTAL: &str = "total-cost";

/// The functions of a domain.
#[derive(Debug, Clone, Default)]
pub struct Functions {
    names: Vec<String>,
    parameters: Vec<Box<[Arc<TypeSet>]>>,
    numbers: FxHashMap<String, u32>,
}

/// A part of the cost of an action.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum CostTerm {
    /// A number.
    Number(u64),
    /// The value of a function, by its number, for these terms.
    Function(u32, Box<[Term]>),
}

/// The values of functions in a task.
#[derive(Debug, Clone, Default)]
pub struct FunctionValues(FxHashMap<(u32, Box<[ObjectId]>), u64>);

impl Functions {
    /// Reads a `:functions` section.
    pub(super) fn read(types: &Types, items: Expressions<'_>) -> Result<Self, PddlError> {
        let mut functions = Self::default();
        for typed in typed_list(items)? {
            if let Some(kind) = typed.kind
                && !kind.is("number")
            {
                let found =
                    format!("a function of the type {}, which needs :object-fluents", kind.shown());
                return Err(kind.wrong(found, "functions of the type number"));
            }
            let (head, parameters) = typed.item.headed("a function, as in (distance ?from ?to)")?;
            let parameters = types.list(parameters)?;
            for (variable, _) in &parameters {
                variable.variable()?;
            }
            let name = head.name("the name of a function")?;
            if name == TOTAL && !parameters.is_empty() {
                return Err(typed.item.expected("(total-cost) without arguments"));
            }
            let id = functions.names.len() as u32;
            if functions.numbers.insert(name.clone(), id).is_some() {
                let found = format!("the function {} for the second time", head.shown());
                return Err(head.wrong(found, "each function declared once"));
            }
            functions.names.push(name);
            functions.parameters.push(parameters.into_iter().map(|(_, set)| set).collect());
        }
        Ok(functions)
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.names.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.names.is_empty()
    }

    fn is_total(&self, function: u32) -> bool {
        self.names[function as usize] == TOTAL
    }

    /// The function that a list calls, and its arguments.
    fn call(
        &self,
        scope: &Scope<'_>,
        place: Expression<'_>,
    ) -> Result<(u32, Box<[Term]>), PddlError> {
        let (head, arguments) = place.headed("a function, as in (distance ?from ?to)")?;
        let name = head.name("the name of a function")?;
        let Some(&function) = self.numbers.get(&name) else {
            let found = format!("the undeclared function {}", head.shown());
            let names = some(self.names.iter().map(String::as_str));
            let expected = if names.is_empty() {
                "a function of the domain, which has none".to_owned()
            } else {
                format!("a function of the domain: {names}")
            };
            return Err(head.wrong(found, expected));
        };
        let wanted = &self.parameters[function as usize];
        let mut terms = Vec::with_capacity(wanted.len());
        let arguments: Vec<_> = arguments.collect();
        if arguments.len() != wanted.len() {
            let found = format!("{} with {}", place.shown(), arguments_of(arguments.len()));
            return Err(place.wrong(found, format!("{} for {name}", arguments_of(wanted.len()))));
        }
        for (argument, types) in arguments.into_iter().zip(wanted) {
            let term = scope.term(argument)?;
            if !scope.fits(term, types) {
                let found = format!("{} of another type", argument.shown());
                return Err(argument.wrong(found, scope.types.written(types)));
            }
            terms.push(term);
        }
        Ok((function, terms.into()))
    }
}

impl CostTerm {
    /// Reads what follows `increase`.
    pub(super) fn read(
        scope: &Scope<'_>,
        place: Expression<'_>,
        mut items: Expressions<'_>,
    ) -> Result<Self, PddlError> {
        let (Some(what), Some(by), None) = (items.next(), items.next(), items.next()) else {
            return Err(place.expected("(increase (total-cost) …)"));
        };
        let (function, _) = scope.functions.call(scope, what)?;
        if !scope.functions.is_total(function) {
            let found = format!("{}, which needs :numeric-fluents", place.shown());
            return Err(place.wrong(found, "(increase (total-cost) …)"));
        }
        if by.symbol().is_some() {
            return number(by).map(Self::Number);
        }
        let (function, terms) = scope.functions.call(scope, by)?;
        if scope.functions.is_total(function) {
            return Err(by.expected("a number or a function whose value never changes"));
        }
        Ok(Self::Function(function, terms))
    }
}

impl FunctionValues {
    /// Reads what follows `=` in an `:init`.
    pub(super) fn read(
        &mut self,
        scope: &Scope<'_>,
        place: Expression<'_>,
        mut items: Expressions<'_>,
    ) -> Result<(), PddlError> {
        let (Some(call), Some(value), None) = (items.next(), items.next(), items.next()) else {
            return Err(place.expected("(= (function …) number)"));
        };
        let (function, terms) = scope.functions.call(scope, call)?;
        let value = number(value)?;
        let object = |term: &Term| match term {
            Term::Object(object) => Some(*object),
            Term::Parameter(_) => None,
        };
        let Some(objects) = terms.iter().map(object).collect::<Option<Box<[ObjectId]>>>() else {
            return Err(call.expected("objects as arguments"));
        };
        match self.0.insert((function, objects), value) {
            Some(other) if other != value => {
                let found = format!("another value of {}, which was {other}", call.shown());
                Err(place.wrong(found, "one value for each"))
            }
            _ => Ok(()),
        }
    }

    /// What an action costs with these objects as arguments; none where a function has no value.
    pub(super) fn cost(
        &self,
        terms: &[CostTerm],
        object: impl Fn(Term) -> ObjectId,
    ) -> Option<u64> {
        terms.iter().try_fold(0_u64, |sum, term| {
            let value = match term {
                CostTerm::Number(number) => *number,
                CostTerm::Function(function, terms) => {
                    let objects = terms.iter().map(|&term| object(term)).collect();
                    *self.0.get(&(*function, objects))?
                }
            };
            Some((sum + value).min(MAX_COST))
        })
    }
}

/// A whole number from 0, which may be written as `3.0`.
fn number(place: Expression<'_>) -> Result<u64, PddlError> {
    let expected = || place.expected(&format!("a whole number from 0 to {MAX_COST}"));
    let text = place.symbol().ok_or_else(expected)?;
    let whole = match text.split_once('.') {
        Some((whole, rest)) if !rest.is_empty() && rest.bytes().all(|byte| byte == b'0') => whole,
        _ => text,
    };
    let digits = !whole.is_empty() && whole.bytes().all(|byte| byte.is_ascii_digit());
    let number = whole.parse().ok().filter(|&number: &u64| digits && number <= MAX_COST);
    number.ok_or_else(expected)
}

/// Reads a `:metric` section: `minimize (total-cost)`.
pub(super) fn metric(
    functions: &Functions,
    place: Expression<'_>,
    mut items: Expressions<'_>,
) -> Result<(), PddlError> {
    const EXPECTED: &str = "(:metric minimize (total-cost))";
    let (Some(direction), Some(what), None) = (items.next(), items.next(), items.next()) else {
        return Err(place.expected(EXPECTED));
    };
    if !direction.is("minimize") {
        return Err(direction.expected(EXPECTED));
    }
    let name = match what.symbol() {
        Some(name) => Some(name),
        None => {
            let (head, mut rest) = what.headed(EXPECTED)?;
            if rest.next().is_none() { head.symbol() } else { None }
        }
    };
    match name.map(str::to_ascii_lowercase) {
        Some(name) if name == TOTAL && functions.numbers.contains_key(TOTAL) => Ok(()),
        Some(name) if name == TOTAL => {
            let found = format!("the undeclared function {}", quoted(TOTAL));
            Err(what.wrong(found, "(total-cost) among the :functions of the domain"))
        }
        _ => Err(what.wrong(format!("{}, which needs :numeric-fluents", what.shown()), EXPECTED)),
    }
}
