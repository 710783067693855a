//! Conditions over objects: goals, initial beliefs, what a sensor looks at.

use super::atom::{Atom, LiftedAtom, Scope};
use super::error::PddlError;
use super::expression::Expression;
use super::literals::Literals;

/// A conjunction of literals over objects.
#[derive(Debug, Clone, Default, PartialEq, Eq, Hash)]
pub struct Condition {
    /// What must hold, sorted.
    pub positive: Vec<Atom>,
    /// What must not hold, sorted.
    pub negative: Vec<Atom>,
    /// Whether an equality in it is false, so that no state satisfies it.
    pub is_false: bool,
}

impl Condition {
    /// Reads a condition. Equalities are decided here.
    pub(super) fn read(scope: &Scope<'_>, place: Expression<'_>) -> Result<Self, PddlError> {
        let literals = Literals::condition(scope, place)?;
        let ground = |atoms: &[LiftedAtom]| {
            let mut atoms: Vec<Atom> = atoms.iter().filter_map(LiftedAtom::ground).collect();
            atoms.sort_unstable();
            atoms.dedup();
            atoms
        };
        Ok(Self {
            positive: ground(&literals.positive),
            negative: ground(&literals.negative),
            is_false: literals.equal.iter().any(|(one, other)| one != other)
                || literals.unequal.iter().any(|(one, other)| one == other),
        })
    }
}
