//! Conjunctions of literals, in preconditions, effects and goals.

use super::atom::{LiftedAtom, Scope, Term};
use super::error::PddlError;
use super::expression::Expression;
use super::feature::unsupported;

/// The most literals in a precondition or an effect of an action.
pub const MAX_LITERALS: usize = 1000;

const EXPECTED: &str = "a literal, as in (on ?x ?y) or (not (on ?x ?y)), or (and …)";

/// A conjunction of literals.
#[derive(Debug, Clone, Default)]
pub struct Literals {
    /// What must hold.
    pub positive: Vec<LiftedAtom>,
    /// What must not.
    pub negative: Vec<LiftedAtom>,
    /// Terms that must be the same.
    pub equal: Vec<(Term, Term)>,
    /// Terms that must not be.
    pub unequal: Vec<(Term, Term)>,
}

impl Literals {
    /// How many literals there are.
    pub fn len(&self) -> usize {
        self.positive.len() + self.negative.len() + self.equal.len() + self.unequal.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Reads a condition. `()` and `(and)` are the empty one.
    pub(super) fn condition(scope: &Scope<'_>, place: Expression<'_>) -> Result<Self, PddlError> {
        let mut literals = Self::default();
        literals.conjunction(scope, place, true)?;
        literals.check_size(scope, place)?;
        Ok(literals)
    }

    /// Reads an effect: `positive` is added, `negative` deleted.
    pub(super) fn effect(scope: &Scope<'_>, place: Expression<'_>) -> Result<Self, PddlError> {
        let mut literals = Self::default();
        literals.conjunction(scope, place, false)?;
        literals.check_size(scope, place)?;
        Ok(literals)
    }

    fn check_size(&self, scope: &Scope<'_>, place: Expression<'_>) -> Result<(), PddlError> {
        if scope.parameters.is_some() && self.len() > MAX_LITERALS {
            return Err(place.wrong(format!("{} literals", self.len()), at_most()));
        }
        Ok(())
    }

    /// Recurses as deep as parentheses are nested, which is bounded.
    fn conjunction(
        &mut self,
        scope: &Scope<'_>,
        place: Expression<'_>,
        equality: bool,
    ) -> Result<(), PddlError> {
        if place.list().is_some_and(|mut items| items.next().is_none()) {
            return Ok(());
        }
        let (head, mut items) = place.headed(EXPECTED)?;
        if head.is("and") {
            return items.try_for_each(|item| self.conjunction(scope, item, equality));
        }
        if !head.is("not") {
            return self.literal(scope, place, false, equality);
        }
        let (Some(negated), None) = (items.next(), items.next()) else {
            return Err(place.expected("(not …) with one atom"));
        };
        let (head, _) = negated.headed("an atom")?;
        if head.is("and") {
            return Err(place.wrong(
                "(not (and …)), which needs :disjunctive-preconditions",
                "a literal of its own for each atom",
            ));
        }
        if head.is("not") {
            return Err(negated.expected("an atom"));
        }
        self.literal(scope, negated, true, equality)
    }

    fn literal(
        &mut self,
        scope: &Scope<'_>,
        place: Expression<'_>,
        negated: bool,
        equality: bool,
    ) -> Result<(), PddlError> {
        let (head, mut items) = place.headed(EXPECTED)?;
        if head.is("=") {
            if !equality {
                return Err(place.expected("an effect, which cannot make things equal"));
            }
            let (Some(one), Some(other), None) = (items.next(), items.next(), items.next()) else {
                return Err(place.expected("(= …) with two arguments"));
            };
            for side in [one, other] {
                if side.list().is_some() {
                    let found = format!("{}, which needs :numeric-fluents", place.shown());
                    return Err(place.wrong(found, "objects and variables in an equality"));
                }
            }
            let pair = (scope.term(one)?, scope.term(other)?);
            if negated {
                self.unequal.push(pair);
            } else {
                self.equal.push(pair);
            }
            return Ok(());
        }
        let declared = |name: &str| scope.predicates.named(&name.to_ascii_lowercase()).is_some();
        if !head.symbol().is_some_and(declared)
            && let Some(error) = unsupported(place, head)
        {
            return Err(error);
        }
        let atom = scope.atom(place, head, items)?;
        if negated {
            self.negative.push(atom);
        } else {
            self.positive.push(atom);
        }
        Ok(())
    }
}

fn at_most() -> String {
    format!("at most {MAX_LITERALS} in one action")
}
