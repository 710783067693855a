//! Disjunctions in goals and initial beliefs: an atom of its own stands for each.
//!
//! Conditions outside of actions are conjunctions of facts. For a disjunction an atom is made up that holds exactly
//! where it does: it is set in the initial states, and every operator that changes an atom of the disjunction sets it
//! anew, by what the disjunction says of the state after the operator (its regression). States stay as many as they
//! were, since the atom follows from the others.

use rustc_hash::FxHashMap;

use super::atom::Atom;
use super::atom_table::AtomTable;
use super::condition::Condition;
use super::draft::{Draft, Numbered};
use super::ground_formula::GroundFormula;
use super::operators::GroundOperator;
use super::predicate::PredicateId;

/// A disjunction and the atom that stands for it.
#[derive(Debug)]
pub(super) struct Derived {
    pub atom: u32,
    pub formula: Numbered,
}

/// The disjunctions of conditions, each once, and the conditions with atoms in their place.
pub(super) fn derive(
    conditions: &[&Condition],
    predicates: usize,
    atoms: &mut AtomTable,
) -> (Vec<Derived>, Vec<Condition>) {
    let mut all: Vec<Derived> = Vec::new();
    let mut numbers: FxHashMap<GroundFormula<Atom>, u32> = FxHashMap::default();
    let mut replaced = Vec::with_capacity(conditions.len());
    for condition in conditions {
        let mut plain = Condition { clauses: Vec::new(), ..(*condition).clone() };
        for clause in &condition.clauses {
            let predicate = PredicateId::new(
                predicates + *numbers.entry(clause.clone()).or_insert(all.len() as u32) as usize,
            );
            if predicate.index() == predicates + all.len() {
                let formula = clause.replace(&mut |atom, holds| match atoms.find_atom(atom) {
                    None => Numbered::constant(!holds),
                    Some(number) => Numbered::Atom(number, holds),
                });
                let atom = atoms.intern(predicate, &[]);
                all.push(Derived { atom, formula });
            }
            plain.positive.push(Atom { predicate, objects: Box::new([]) });
        }
        plain.positive.sort_unstable();
        replaced.push(plain);
    }
    (all, replaced)
}

/// Makes drafts of the operators that change atoms of disjunctions, and sets these there and in the drafts.
pub(super) fn regress(
    all: &[Derived],
    operators: &mut Vec<GroundOperator>,
    drafts: &mut Vec<Draft>,
) {
    if all.is_empty() {
        return;
    }
    let mut of_atom: FxHashMap<u32, Vec<usize>> = FxHashMap::default();
    for (number, derived) in all.iter().enumerate() {
        derived.formula.atoms(&mut |atom| of_atom.entry(*atom).or_default().push(number));
    }
    let touched = |changed: &mut dyn Iterator<Item = &u32>| {
        let mut numbers: Vec<usize> =
            changed.filter_map(|atom| of_atom.get(atom)).flatten().copied().collect();
        numbers.sort_unstable();
        numbers.dedup();
        numbers
    };
    for draft in drafts.iter_mut() {
        let cases = draft.cases.iter().flat_map(|case| case.add.iter().chain(&case.delete));
        let numbers = touched(&mut draft.add.iter().chain(&draft.delete).chain(cases));
        for number in numbers {
            set(draft, &all[number]);
        }
    }
    let mut kept = Vec::with_capacity(operators.len());
    for operator in operators.drain(..) {
        let numbers = touched(&mut operator.add.iter().chain(&operator.delete));
        if numbers.is_empty() {
            kept.push(operator);
            continue;
        }
        let mut draft = Draft::of(operator);
        for number in numbers {
            set(&mut draft, &all[number]);
        }
        drafts.push(draft);
    }
    *operators = kept;
}

/// Sets the atom of a disjunction by what that says after the draft.
fn set(draft: &mut Draft, derived: &Derived) {
    let effects = |atom: u32, add: bool| {
        let always = if add { &draft.add } else { &draft.delete };
        let listed = |case: &super::draft::Case| {
            if add { case.add.contains(&atom) } else { case.delete.contains(&atom) }
        };
        let cases =
            draft.cases.iter().filter(|case| listed(case)).map(|case| case.condition.clone());
        let always = Numbered::constant(always.binary_search(&atom).is_ok());
        Numbered::join(false, std::iter::once(always).chain(cases))
    };
    let before = |atom: u32| {
        if draft.positive.contains(&atom) {
            Numbered::constant(true)
        } else if draft.negative.contains(&atom) {
            Numbered::constant(false)
        } else {
            Numbered::Atom(atom, true)
        }
    };
    let negated = |formula: Numbered| formula.negated();
    let mut after = |atom: &u32, holds: bool| {
        let stays = Numbered::join(true, [before(*atom), negated(effects(*atom, false))]);
        let holds_after = Numbered::join(false, [effects(*atom, true), stays]);
        if holds { holds_after } else { negated(holds_after) }
    };
    let formula = derived.formula.replace(&mut after);
    draft.effect(negated(formula.clone()), derived.atom, false);
    draft.effect(formula, derived.atom, true);
    draft.tidy();
}
