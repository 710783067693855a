//! Formulas over atoms: conditions with disjunction, implication and quantifiers.
//!
//! They are read in negation normal form: a negation is pushed inwards to the atoms and equalities, an implication
//! becomes a disjunction. A variable that a quantifier binds is a [`Term::Parameter`] whose position lies behind
//! those that are in scope already.

use std::sync::Arc;

use super::atom::{LiftedAtom, Scope, Term, arguments_of};
use super::error::PddlError;
use super::expression::{Expression, Expressions};
use super::feature::unsupported;
use super::schema::Parameters;
use super::types::TypeSet;

const EXPECTED: &str = "a literal, as in (on ?x ?y) or (not (on ?x ?y)), or (and …)";

/// A variable that a quantifier binds: its position and its types.
pub type Bound = (u32, Arc<TypeSet>);

/// A formula in negation normal form.
#[derive(Debug, Clone)]
pub enum Formula {
    /// An atom that must hold (true) or must not.
    Atom(LiftedAtom, bool),
    /// Terms that must be the same (true) or must differ.
    Equal(Term, Term, bool),
    /// All of these.
    And(Vec<Formula>),
    /// One of these at least.
    Or(Vec<Formula>),
    /// For all objects in the places of the variables.
    Forall(Vec<Bound>, Box<Formula>),
    /// For some objects in the places of the variables.
    Exists(Vec<Bound>, Box<Formula>),
}

impl Formula {
    /// What always holds.
    pub const TRUE: Self = Self::And(Vec::new());

    /// Reads a condition. `()` and `(and)` hold always. Recurses as deep as parentheses are nested, which is
    /// bounded.
    pub(super) fn read(scope: &Scope<'_>, place: Expression<'_>) -> Result<Self, PddlError> {
        Self::signed(scope, place, true)
    }

    /// Reads a condition or, where `holds` is false, its negation.
    fn signed(scope: &Scope<'_>, place: Expression<'_>, holds: bool) -> Result<Self, PddlError> {
        if place.list().is_some_and(|mut items| items.next().is_none()) {
            return Ok(if holds { Self::TRUE } else { Self::Or(Vec::new()) });
        }
        let (head, mut items) = place.headed(EXPECTED)?;
        let name = head.symbol().unwrap_or_default().to_ascii_lowercase();
        // A predicate may go by the name of a connective that nothing reserves.
        let declared = scope.predicates.named(&name).is_some();
        let all = |items: Expressions<'_>| {
            items.map(|item| Self::signed(scope, item, holds)).collect::<Result<Vec<_>, _>>()
        };
        Ok(match name.as_str() {
            "and" if holds => Self::And(all(items)?),
            "and" => Self::Or(all(items)?),
            "or" if !declared && holds => Self::Or(all(items)?),
            "or" if !declared => Self::And(all(items)?),
            "not" => {
                let (Some(negated), None) = (items.next(), items.next()) else {
                    return Err(place.expected("(not …) with one condition"));
                };
                Self::signed(scope, negated, !holds)?
            }
            "imply" if !declared => {
                let (Some(one), Some(other), None) = (items.next(), items.next(), items.next())
                else {
                    return Err(place.expected("(imply …) with two conditions"));
                };
                let parts =
                    vec![Self::signed(scope, one, !holds)?, Self::signed(scope, other, holds)?];
                if holds { Self::Or(parts) } else { Self::And(parts) }
            }
            "forall" | "exists" if !declared => {
                let (Some(variables), Some(body), None) =
                    (items.next(), items.next(), items.next())
                else {
                    let expected = format!("({name} (?variable …) …) with one condition");
                    return Err(place.expected(&expected));
                };
                let (parameters, bound) = quantified(scope, variables)?;
                let inner = Scope { parameters: Some(&parameters), ..*scope };
                let body = Box::new(Self::signed(&inner, body, holds)?);
                if (name == "forall") == holds {
                    Self::Forall(bound, body)
                } else {
                    Self::Exists(bound, body)
                }
            }
            "=" => {
                let (one, other) = equality(scope, place, items)?;
                Self::Equal(one, other, holds)
            }
            _ => Self::Atom(atom(scope, place)?, holds),
        })
    }

    /// How many atoms, equalities and quantifiers it has.
    pub fn len(&self) -> usize {
        match self {
            Self::Atom(..) | Self::Equal(..) => 1,
            Self::And(parts) | Self::Or(parts) => parts.iter().map(Self::len).sum(),
            Self::Forall(_, body) | Self::Exists(_, body) => 1 + body.len(),
        }
    }

    /// Whether it says nothing.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// The variables of a quantifier: what is in scope with them, and they themselves. A variable hides another of its
/// name.
pub(super) fn quantified(
    scope: &Scope<'_>,
    place: Expression<'_>,
) -> Result<(Parameters, Vec<Bound>), PddlError> {
    let mut parameters = scope.parameters.cloned().unwrap_or_default();
    let mut bound = Vec::new();
    for (item, types) in
        scope.types.list(place.items("a list of variables, as in (?x - block)")?)?
    {
        let name = item.variable()?;
        bound.push((parameters.len() as u32, Arc::clone(&types)));
        parameters.push(item, name, types)?;
    }
    Ok((parameters, bound))
}

/// The two sides of an equality.
fn equality(
    scope: &Scope<'_>,
    place: Expression<'_>,
    mut items: Expressions<'_>,
) -> Result<(Term, Term), PddlError> {
    let (Some(one), Some(other), None) = (items.next(), items.next(), items.next()) else {
        return Err(place.wrong(
            format!(
                "{} with {}",
                place.shown(),
                arguments_of(place.list().map_or(0, Iterator::count).saturating_sub(1))
            ),
            "(= …) with two arguments",
        ));
    };
    for side in [one, other] {
        if side.list().is_some() {
            let found = format!("{}, which needs :numeric-fluents", place.shown());
            return Err(place.wrong(found, "objects and variables in an equality"));
        }
    }
    Ok((scope.term(one)?, scope.term(other)?))
}

/// An atom.
pub(super) fn atom(scope: &Scope<'_>, place: Expression<'_>) -> Result<LiftedAtom, PddlError> {
    let (head, items) = place.headed(EXPECTED)?;
    let declared = |name: &str| scope.predicates.named(&name.to_ascii_lowercase()).is_some();
    if !head.symbol().is_some_and(declared)
        && let Some(error) = unsupported(place, head)
    {
        return Err(error);
    }
    scope.atom(place, head, items)
}
