//! Atoms that can come to hold when deletes are ignored.

use super::atom::Atom;
use super::atom_table::AtomTable;
use super::definition::TaskDefinition;
use super::domain::Domain;
use super::ground::GroundError;
use super::reach::reach;
use super::rule::Rule;

/// The atoms of the delete relaxation: those that hold at first and those that operators can add.
#[derive(Debug)]
pub struct Reachable(AtomTable);

impl Reachable {
    /// Those of a task, negative preconditions ignored as well.
    ///
    /// # Errors
    ///
    /// [`GroundError`] where a limit is met.
    pub fn new(domain: &Domain, task: &TaskDefinition) -> Result<Self, GroundError> {
        let rules: Vec<Rule<'_>> = (0..domain.schemas.len())
            .filter_map(|number| Rule::new(domain, number, &task.objects))
            .collect();
        let initial: Vec<&Atom> = task.initial.iter().collect();
        Ok(Self(reach(domain, &rules, &task.objects, &initial)?.atoms))
    }

    /// Whether an atom is one of them.
    pub fn contains(&self, atom: &Atom) -> bool {
        self.0.find_atom(atom).is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pddl::{read_condition, read_domain, read_task};

    #[test]
    fn what_holds_at_first_and_what_is_added_is_reachable() {
        let domain = read_domain(
            "(define (domain d) (:predicates (at ?x) (road ?x ?y))
               (:action go :parameters (?x ?y) :precondition (and (at ?x) (road ?x ?y))
                 :effect (and (at ?y) (not (at ?x)))))",
        )
        .unwrap();
        let task = "(define (problem t) (:domain d) (:objects a b c d)
            (:init (at a) (road a b) (road b a) (road c d)) (:goal (at b)))";
        let task = read_task(&domain, task).unwrap();
        let reachable = Reachable::new(&domain, &task).unwrap();
        let contains = |text: &str| {
            let condition = read_condition(&domain, &task, text).unwrap();
            reachable.contains(&condition.positive[0])
        };
        for (atom, expected) in [
            ("(at a)", true),
            ("(at b)", true),
            ("(at c)", false),
            ("(at d)", false),
            ("(road c d)", true),
            ("(road d c)", false),
        ] {
            assert_eq!(contains(atom), expected, "{atom}");
        }
    }
}
