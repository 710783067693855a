//! Conjunctions of literals, in preconditions and effects.

use super::atom::{LiftedAtom, Term};
use super::formula::Formula;

/// The most literals in a precondition or an effect of an action.
pub const MAX_LITERALS: usize = 1000;

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

    /// Takes the literals out of a conjunction; what is none is added to `rest`.
    pub(super) fn take(&mut self, formula: Formula, rest: &mut Vec<Formula>) {
        match formula {
            Formula::And(parts) => parts.into_iter().for_each(|part| self.take(part, rest)),
            Formula::Atom(atom, true) => self.positive.push(atom),
            Formula::Atom(atom, false) => self.negative.push(atom),
            Formula::Equal(one, other, true) => self.equal.push((one, other)),
            Formula::Equal(one, other, false) => self.unequal.push((one, other)),
            Formula::Or(mut parts) if parts.len() == 1 => {
                parts.drain(..).for_each(|part| self.take(part, rest));
            }
            Formula::Forall(variables, body) => match *body {
                // All of a conjunction is the conjunction of all.
                Formula::And(parts) => rest.extend(
                    parts
                        .into_iter()
                        .map(|part| Formula::Forall(variables.clone(), Box::new(part))),
                ),
                body => rest.push(Formula::Forall(variables, Box::new(body))),
            },
            other => rest.push(other),
        }
    }
}
