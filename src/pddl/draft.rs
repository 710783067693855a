//! Drafts of ground operators: instances of actions whose effects have conditions.
//!
//! So are instances whose precondition is no conjunction of literals. `split` makes operators of drafts.

use super::atom_table::AtomTable;
use super::ground::GroundError;
use super::ground_formula::{Expansion, GroundFormula};
use super::join::MAX_JOIN_STEPS;
use super::object::ObjectId;
use super::operators::{GroundOperator, Possible};
use super::predicate::PredicateId;
use super::reach::Instance;
use super::rule::Rule;

/// A formula over numbered atoms.
pub(super) type Numbered = GroundFormula<u32>;

/// Marks what stands for a part of a draft among operators.
const RELAXED: u32 = u32::MAX;

/// Effects under one condition.
#[derive(Debug, Clone)]
pub(super) struct Case {
    pub condition: Numbered,
    pub add: Vec<u32>,
    pub delete: Vec<u32>,
}

/// A draft; atoms are numbers in the [`AtomTable`].
#[derive(Debug, Clone)]
pub(super) struct Draft {
    pub instance: Instance,
    pub positive: Vec<u32>,
    pub negative: Vec<u32>,
    /// What else must hold before.
    pub rest: Vec<Numbered>,
    pub add: Vec<u32>,
    pub delete: Vec<u32>,
    pub cases: Vec<Case>,
}

impl Draft {
    /// The draft of an operator with further parts of its rule. Atoms of predicates for which `changes` says so may
    /// change; all others hold where they are known.
    pub(super) fn new(
        operator: GroundOperator,
        rule: &Rule<'_>,
        arguments: Vec<ObjectId>,
        changes: &[bool],
        (objects, atoms): (&super::object::Objects, &AtomTable),
        budget: &mut u64,
    ) -> Result<Self, GroundError> {
        let GroundOperator { instance, positive, negative, add, delete } = operator;
        let mut draft =
            Self { instance, positive, negative, rest: Vec::new(), add, delete, cases: Vec::new() };
        let atom = |predicate: PredicateId, objects: &[ObjectId], holds: bool| {
            match atoms.find(predicate, objects) {
                // An atom that is not there never holds.
                None => Numbered::constant(!holds),
                Some(_) if !changes[predicate.index()] => Numbered::constant(holds),
                Some(number) => Numbered::Atom(number, holds),
            }
        };
        let mut expansion = Expansion { objects, values: arguments, budget };
        let all = (|| {
            for formula in rule.rest {
                draft.rest.push(expansion.formula(formula, &atom)?);
            }
            for effect in rule.conditional {
                expansion.for_all(&effect.variables, &mut |expansion| {
                    let condition = expansion.formula(&effect.condition, &atom)?;
                    let objects: Vec<ObjectId> =
                        effect.atom.terms.iter().map(|&term| expansion.object(term)).collect();
                    if let Some(atom) = atoms.find(effect.atom.predicate, &objects) {
                        draft.effect(condition, atom, effect.add);
                    }
                    Some(true)
                })?;
            }
            Some(())
        })();
        all.ok_or(GroundError::Steps { limit: MAX_JOIN_STEPS })?;
        draft.tidy();
        Ok(draft)
    }

    /// The draft of an operator of STRIPS.
    pub(super) fn of(operator: GroundOperator) -> Self {
        let GroundOperator { instance, positive, negative, add, delete } = operator;
        Self { instance, positive, negative, rest: Vec::new(), add, delete, cases: Vec::new() }
    }

    /// Adds an effect.
    pub(super) fn effect(&mut self, condition: Numbered, atom: u32, add: bool) {
        let condition = if add {
            condition
        } else {
            // Where the atom does not hold, deleting it changes nothing.
            let parts =
                condition.conjuncts().iter().filter(|part| **part != Numbered::Atom(atom, true));
            Numbered::join(true, parts.cloned().collect::<Vec<_>>())
        };
        match condition.value() {
            Some(false) => {}
            Some(true) if add => self.add.push(atom),
            Some(true) => self.delete.push(atom),
            None => {
                let known = self.cases.iter_mut().find(|case| case.condition == condition);
                let case = match known {
                    Some(case) => case,
                    None => {
                        self.cases.push(Case { condition, add: Vec::new(), delete: Vec::new() });
                        let last = self.cases.len() - 1;
                        &mut self.cases[last]
                    }
                };
                if add {
                    case.add.push(atom);
                } else {
                    case.delete.push(atom);
                }
            }
        }
    }

    /// Sorts what is listed and leaves out what is there twice.
    pub(super) fn tidy(&mut self) {
        for list in [&mut self.add, &mut self.delete] {
            list.sort_unstable();
            list.dedup();
        }
        self.delete.retain(|atom| self.add.binary_search(atom).is_err());
    }

    /// How many literals it has.
    pub(super) fn size(&self) -> usize {
        let size = |formula: &Numbered| {
            let mut count = 0;
            formula.atoms(&mut |_| count += 1);
            count
        };
        let of_case = |case: &Case| size(&case.condition) + case.add.len() + case.delete.len();
        self.positive.len()
            + self.negative.len()
            + self.add.len()
            + self.delete.len()
            + self.rest.iter().map(size).sum::<usize>()
            + self.cases.iter().map(of_case).sum::<usize>()
    }

    /// Operators that together do what it does when conditions are taken for their literals alone: one for what it
    /// always does and one for each case.
    pub(super) fn relaxed(&self, into: &mut Vec<GroundOperator>) {
        let (mut positive, mut negative) = (self.positive.clone(), self.negative.clone());
        for formula in &self.rest {
            literals(formula, &mut positive, &mut negative);
        }
        let mut push = |condition: Option<&Numbered>, add: &[u32], delete: &[u32]| {
            let (mut positive, mut negative) = (positive.clone(), negative.clone());
            if let Some(condition) = condition {
                literals(condition, &mut positive, &mut negative);
            }
            let instance = Instance { rule: RELAXED, values: Box::new([]) };
            let (add, delete) = (add.to_vec(), delete.to_vec());
            into.push(GroundOperator { instance, positive, negative, add, delete });
        };
        push(None, &self.add, &self.delete);
        for case in &self.cases {
            push(Some(&case.condition), &case.add, &case.delete);
        }
    }

    /// What it is where atoms hold and fail only as far as that is possible; none where it never applies.
    pub(super) fn possible(mut self, possible: &Possible) -> Option<Self> {
        let hold = |atom: &u32| possible.hold.contains(*atom as usize);
        let fail = |atom: &u32| possible.fail.contains(*atom as usize);
        if !self.positive.iter().all(hold) || !self.negative.iter().all(fail) {
            return None;
        }
        let mut of = |atom: &u32, holds: bool| match (hold(atom), fail(atom)) {
            (true, true) => Numbered::Atom(*atom, holds),
            (can_hold, _) => Numbered::constant(can_hold == holds),
        };
        self.rest = self.rest.iter().map(|formula| formula.replace(&mut of)).collect();
        if self.rest.iter().any(|formula| formula.value() == Some(false)) {
            return None;
        }
        for case in std::mem::take(&mut self.cases) {
            let condition = case.condition.replace(&mut of);
            for (atoms, add) in [(&case.add, true), (&case.delete, false)] {
                for &atom in atoms {
                    self.effect(condition.clone(), atom, add);
                }
            }
        }
        self.tidy();
        Some(self)
    }
}

/// Takes out what stands for parts of drafts.
pub(super) fn remove_relaxed(operators: &mut Vec<GroundOperator>) {
    operators.retain(|operator| operator.instance.rule != RELAXED);
}

/// The literals among the conjuncts of a formula.
pub(super) fn literals(formula: &Numbered, positive: &mut Vec<u32>, negative: &mut Vec<u32>) {
    for part in formula.conjuncts() {
        if let Numbered::Atom(atom, holds) = part {
            let list = if *holds { &mut *positive } else { &mut *negative };
            if !list.contains(atom) {
                list.push(*atom);
            }
        }
    }
}
