//! Atoms of the initial state that no operator changes.

use rustc_hash::FxHashSet;

use super::atom::Atom;
use super::definition::TaskDefinition;
use super::domain::Domain;
use super::ground::GroundError;
use super::operators::{Candidates, operators};
use super::reach::reach;
use super::rule::Rule;

/// The atoms of the initial state that no operator adds or deletes which can apply after the
/// initial state and some further atoms, deletes and negative preconditions ignored. Sorted.
///
/// # Errors
///
/// [`GroundError`] where a limit is met.
pub fn unchanging(
    domain: &Domain,
    task: &TaskDefinition,
    more: &[Atom],
) -> Result<Vec<Atom>, GroundError> {
    let rules: Vec<Rule<'_>> = (0..domain.schemas.len())
        .filter_map(|number| Rule::new(domain, number, &task.objects))
        .collect();
    let initial: Vec<&Atom> = task.initial.iter().chain(more).collect();
    let reached = reach(domain, &rules, &task.objects, &initial)?;
    let Candidates { atoms, plain, drafts } = operators(domain, task, &rules, reached)?;
    let mut changed: FxHashSet<u32> = FxHashSet::default();
    for operator in &plain {
        changed.extend(operator.add.iter().chain(&operator.delete));
    }
    for draft in &drafts {
        changed.extend(draft.add.iter().chain(&draft.delete));
        changed.extend(draft.cases.iter().flat_map(|case| case.add.iter().chain(&case.delete)));
    }
    let stays =
        |atom: &&Atom| atoms.find_atom(atom).is_none_or(|number| !changed.contains(&number));
    Ok(task.initial.iter().filter(stays).cloned().collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pddl::{read_domain, read_task};

    #[test]
    fn an_atom_that_no_operator_changes_is_left() {
        let domain = read_domain(
            "(define (domain d) (:constants a b) (:predicates (p ?x)) (:action go :effect (p a)))",
        )
        .unwrap();
        let task = "(define (problem t) (:domain d) (:init (p a) (p b)) (:goal (p a)))";
        let task = read_task(&domain, task).unwrap();
        let left = unchanging(&domain, &task, &[]).unwrap();
        assert_eq!(left, [task.initial[1].clone()]);
    }
}
