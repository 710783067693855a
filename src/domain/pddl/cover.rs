//! Whether the cases of a sensor leave no resulting state of an operator out.
//!
//! Known of the resulting state is what never changes, what the operator requires and does not delete,
//! what it adds and what it deletes. For all else both truth values are tried, atom by atom: some case must be certain
//! in the end. That is sound and looks at no reachability, so that cases which cover every reachable
//! state, but not every state, are refused.

use rustc_hash::FxHashMap;

use crate::pddl::{Atom, Condition, Grounded, TaskDefinition};
use crate::task::{Fact, Operator};

/// Splits on an atom, at most; with more the cases are said not to cover everything.
const MAX_SPLITS: u32 = 256;

/// What is known of a state.
type Known<'a> = FxHashMap<&'a Atom, bool>;

/// Whether in every state that the operator can result in one of the conditions holds.
pub(super) fn covers(
    task: &TaskDefinition,
    grounded: &Grounded,
    operator: &Operator,
    cases: &[&Condition],
) -> bool {
    let mut known = Known::default();
    for atom in cases.iter().flat_map(|case| case.positive.iter().chain(&case.negative)) {
        if let Some(holds) = grounded.constant(task, atom) {
            known.insert(atom, holds);
        }
    }
    let mut learn = |facts: &[Fact], holds: bool| {
        for (atom, negated) in facts.iter().filter_map(|&fact| grounded.atom(fact)) {
            known.insert(atom, holds != negated);
        }
    };
    // In the order of their strength: a deleted precondition is gone, and what is deleted and added holds.
    learn(&operator.preconditions, true);
    learn(&operator.delete, false);
    learn(&operator.add, true);
    let cases: Vec<&Condition> = cases.iter().copied().filter(|case| !case.is_false).collect();
    always(&cases, &mut known, &mut 0)
}

/// Recurses once for each atom tried, of which there are few.
fn always<'a>(cases: &[&'a Condition], known: &mut Known<'a>, splits: &mut u32) -> bool {
    let mut open = Vec::with_capacity(cases.len());
    let mut unknown = None;
    for case in cases {
        let literals = || {
            let positive = case.positive.iter().map(|atom| (atom, true));
            positive.chain(case.negative.iter().map(|atom| (atom, false)))
        };
        if literals().any(|(atom, wanted)| known.get(atom).is_some_and(|&holds| holds != wanted)) {
            continue;
        }
        match literals().find(|(atom, _)| !known.contains_key(atom)) {
            None => return true,
            Some((atom, _)) => {
                unknown.get_or_insert(atom);
                open.push(*case);
            }
        }
    }
    let Some(atom) = unknown else { return false };
    *splits += 1;
    if *splits > MAX_SPLITS {
        return false;
    }
    let covered = [true, false].into_iter().all(|holds| {
        known.insert(atom, holds);
        always(&open, known, splits)
    });
    known.remove(atom);
    covered
}
