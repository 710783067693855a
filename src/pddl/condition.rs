//! Conditions over objects: goals, initial beliefs, what a sensor looks at.

use super::atom::{Atom, Scope};
use super::error::PddlError;
use super::expression::Expression;
use super::formula::Formula;
use super::ground_formula::{Expansion, GroundFormula};
use super::object::{ObjectId, Objects};
use super::predicate::PredicateId;

/// The most atoms and equalities of a condition, once its quantifiers are expanded.
pub const MAX_CONDITION: u64 = if cfg!(target_arch = "wasm32") { 20_000 } else { 200_000 };

/// A conjunction of literals over objects, and of what is no literal.
#[derive(Debug, Clone, Default, PartialEq, Eq, Hash)]
pub struct Condition {
    /// What must hold, sorted.
    pub positive: Vec<Atom>,
    /// What must not hold, sorted.
    pub negative: Vec<Atom>,
    /// Whether it is false whatever holds, as an equality in it may be.
    pub is_false: bool,
    /// The disjunctions, of which each must hold.
    pub clauses: Vec<GroundFormula<Atom>>,
}

impl Condition {
    /// Reads a condition. Equalities are decided and quantifiers expanded here.
    pub(super) fn read(scope: &Scope<'_>, place: Expression<'_>) -> Result<Self, PddlError> {
        let formula = Formula::read(scope, place)?;
        Self::of(&formula, scope.objects, &[]).ok_or_else(|| {
            let found = format!("a condition of more than {MAX_CONDITION} literals");
            place.wrong(found, "at most that, once quantifiers are expanded")
        })
    }

    /// What a formula says with these objects in the places of its variables; none where that is too much.
    pub(super) fn of(formula: &Formula, objects: &Objects, values: &[ObjectId]) -> Option<Self> {
        let mut budget = MAX_CONDITION;
        let mut expansion = Expansion { objects, values: values.to_vec(), budget: &mut budget };
        let atom = |predicate: PredicateId, objects: &[ObjectId], holds: bool| {
            GroundFormula::Atom(Atom { predicate, objects: objects.into() }, holds)
        };
        Some(Self::new(&expansion.formula(formula, &atom)?))
    }

    /// The conjuncts of a formula.
    pub(super) fn new(formula: &GroundFormula<Atom>) -> Self {
        let mut condition = Self { is_false: formula.value() == Some(false), ..Self::default() };
        if condition.is_false {
            return condition;
        }
        for part in formula.conjuncts() {
            match part {
                GroundFormula::Atom(atom, true) => condition.positive.push(atom.clone()),
                GroundFormula::Atom(atom, false) => condition.negative.push(atom.clone()),
                other => condition.clauses.push(other.clone()),
            }
        }
        condition.positive.sort_unstable();
        condition.positive.dedup();
        condition.negative.sort_unstable();
        condition.negative.dedup();
        condition.clauses.sort_unstable();
        condition.clauses.dedup();
        condition
    }

    /// Whether it holds where exactly the atoms hold for which `of` says so.
    pub fn holds(&self, of: &impl Fn(&Atom) -> bool) -> bool {
        !self.is_false
            && self.positive.iter().all(of)
            && !self.negative.iter().any(of)
            && self.clauses.iter().all(|clause| clause.holds(of))
    }

    /// Conjunctions of literals of which one holds exactly where this does; none where there would be more than
    /// `most`.
    pub fn alternatives(&self, most: usize) -> Option<Vec<Self>> {
        if self.clauses.is_empty() {
            return Some(vec![self.clone()]);
        }
        let literals = self.positive.iter().map(|atom| GroundFormula::Atom(atom.clone(), true));
        let negative = self.negative.iter().map(|atom| GroundFormula::Atom(atom.clone(), false));
        let parts = literals.chain(negative).chain(self.clauses.iter().cloned());
        let all = GroundFormula::join(true, parts).alternatives(most)?;
        let condition = |literals: Vec<(Atom, bool)>| {
            let literals =
                literals.into_iter().map(|(atom, holds)| GroundFormula::Atom(atom, holds));
            Self::new(&GroundFormula::join(true, literals))
        };
        Some(all.into_iter().map(condition).collect())
    }
}
