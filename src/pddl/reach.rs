//! What can be reached when deletes and negative preconditions are ignored: the atoms, and the
//! operators that can apply.
//!
//! Every atom is taken up once, in the order in which it is found, and joined with those taken up
//! before it (semi-naive evaluation, as of a Datalog program: Helmert 2009,
//! doi:10.1016/j.artint.2008.10.013). Predicates that no action changes are there from the start.

use super::atom::{Atom, LiftedAtom, Term};
use super::atom_table::AtomTable;
use super::domain::Domain;
use super::ground::{GroundError, MAX_ATOMS, MAX_LITERALS_IN_ALL, MAX_OPERATORS};
use super::ground_formula::{Expansion, GroundFormula};
use super::join::{Found, Index, Join, MAX_JOIN_STEPS};
use super::object::{ObjectId, Objects};
use super::predicate::PredicateId;
use super::rule::Rule;

/// A rule with values for its slots.
#[derive(Debug, Clone)]
pub(super) struct Instance {
    pub rule: u32,
    pub values: Box<[ObjectId]>,
}

/// What was reached.
#[derive(Debug)]
pub(super) struct Reached {
    pub atoms: AtomTable,
    pub instances: Vec<Instance>,
    /// Literals of all instances, at least.
    literals: usize,
    /// Atoms and equalities that conditions may still be tried on.
    budget: u64,
}

/// For each predicate whether any action adds or deletes its atoms.
pub(super) fn may_change(domain: &Domain) -> Vec<bool> {
    let mut changes = vec![false; domain.predicates.len()];
    domain.changing().for_each(|predicate| changes[predicate] = true);
    changes
}

/// The object that a term of a rule stands for.
pub(super) fn object(term: Term, values: &[ObjectId]) -> ObjectId {
    match term {
        Term::Object(object) => object,
        Term::Parameter(slot) => values[slot as usize],
    }
}

/// Writes the objects of a lifted atom into `objects`.
pub(super) fn instantiate(atom: &LiftedAtom, values: &[ObjectId], objects: &mut Vec<ObjectId>) {
    objects.clear();
    objects.extend(atom.terms.iter().map(|&term| object(term, values)));
}

/// Everything that the rules can reach from atoms that hold in some initial state.
pub(super) fn reach(
    domain: &Domain,
    rules: &[Rule<'_>],
    objects: &Objects,
    initial: &[&Atom],
) -> Result<Reached, GroundError> {
    let mut changes = vec![false; domain.predicates.len()];
    for atom in rules.iter().flat_map(|rule| &rule.add) {
        changes[atom.predicate.index()] = true;
    }
    for effect in rules.iter().flat_map(|rule| rule.conditional).filter(|effect| effect.add) {
        changes[effect.atom.predicate.index()] = true;
    }
    let (fluent, fixed): (Vec<&Atom>, Vec<&Atom>) =
        initial.iter().partition(|atom| changes[atom.predicate.index()]);
    let mut atoms = AtomTable::new();
    let mut index = Index::default();
    for atom in fixed {
        let known = atoms.len();
        let number = atoms.intern(atom.predicate, &atom.objects);
        if atoms.len() > known {
            index.insert(&atoms, number);
        }
    }
    let fixed_count = atoms.len() as u32;
    for atom in fluent {
        atoms.intern(atom.predicate, &atom.objects);
    }
    // For each predicate the preconditions that an atom of it may be the last to match.
    let mut triggers: Vec<Vec<(usize, usize)>> = vec![Vec::new(); domain.predicates.len()];
    for (number, rule) in rules.iter().enumerate() {
        for (place, atom) in rule.positive.iter().enumerate() {
            if changes[atom.predicate.index()] {
                triggers[atom.predicate.index()].push((number, place));
            }
        }
    }
    let mut steps = 0;
    let mut found = Found::default();
    let may_change = may_change(domain);
    let mut reached = Reached { atoms, instances: Vec::new(), literals: 0, budget: MAX_JOIN_STEPS };
    let take = |reached: &mut Reached, number: usize, found: &mut Found| {
        if rules[number].is_plain() {
            reached.take(number, &rules[number], found)
        } else {
            reached.take_cases(number, &rules[number], found, objects, &may_change)
        }
    };
    for (number, rule) in rules.iter().enumerate() {
        if rule.positive.iter().all(|atom| !changes[atom.predicate.index()]) {
            let mut join = Join {
                rule,
                objects,
                atoms: &reached.atoms,
                index: &index,
                newest: fixed_count,
                trigger: 0,
                values: vec![None; rule.slots.len()],
                open: (0..rule.positive.len()).collect(),
                steps: &mut steps,
                found: &mut found,
            };
            join.rest()?;
            take(&mut reached, number, &mut found)?;
        }
    }
    let mut next = fixed_count;
    while (next as usize) < reached.atoms.len() {
        let (predicate, _) = reached.atoms.get(next);
        index.insert(&reached.atoms, next);
        for &(number, trigger) in &triggers[predicate.index()] {
            let rule = &rules[number];
            let mut join = Join {
                rule,
                objects,
                atoms: &reached.atoms,
                index: &index,
                newest: next,
                trigger,
                values: vec![None; rule.slots.len()],
                open: (0..rule.positive.len()).filter(|&place| place != trigger).collect(),
                steps: &mut steps,
                found: &mut found,
            };
            join.start()?;
            take(&mut reached, number, &mut found)?;
        }
        next += 1;
    }
    Ok(reached)
}

impl Reached {
    /// Takes up instances of a rule with further conditions, as far as what never changes lets these hold, and what
    /// they can add.
    fn take_cases(
        &mut self,
        number: usize,
        rule: &Rule<'_>,
        found: &mut Found,
        objects: &Objects,
        may_change: &[bool],
    ) -> Result<(), GroundError> {
        let width = rule.slots.len();
        let mut kept = Found::default();
        let mut added: Vec<(PredicateId, Vec<ObjectId>)> = Vec::new();
        for instance in 0..found.count {
            let values = &found.values[instance * width..][..width];
            let atoms = &self.atoms;
            // What may change is left open.
            let atom = |predicate: PredicateId, objects: &[ObjectId], holds: bool| {
                if may_change[predicate.index()] {
                    GroundFormula::Atom((), holds)
                } else {
                    GroundFormula::constant(atoms.find(predicate, objects).is_some() == holds)
                }
            };
            let values_of = rule.arguments_of(values);
            let mut expansion = Expansion { objects, values: values_of, budget: &mut self.budget };
            let fits = (|| {
                for formula in rule.rest {
                    if expansion.formula(formula, &atom)?.value() == Some(false) {
                        return Some(false);
                    }
                }
                for effect in rule.conditional.iter().filter(|effect| effect.add) {
                    expansion.for_all(&effect.variables, &mut |expansion| {
                        let condition = expansion.formula(&effect.condition, &atom)?;
                        if condition.value() != Some(false) {
                            let terms = effect.atom.terms.iter();
                            let objects = terms.map(|&term| expansion.object(term)).collect();
                            added.push((effect.atom.predicate, objects));
                        }
                        Some(true)
                    })?;
                }
                Some(true)
            })();
            if fits.ok_or(GroundError::Steps { limit: MAX_JOIN_STEPS })? {
                kept.count += 1;
                kept.values.extend_from_slice(values);
            }
            self.literals += added.len();
            for (predicate, objects) in added.drain(..) {
                self.atoms.intern(predicate, &objects);
            }
            if self.atoms.len() > MAX_ATOMS {
                return Err(GroundError::Atoms { limit: MAX_ATOMS });
            }
        }
        found.count = 0;
        found.values.clear();
        self.take(number, rule, &mut kept)
    }

    /// Takes up instances and what they add.
    fn take(
        &mut self,
        number: usize,
        rule: &Rule<'_>,
        found: &mut Found,
    ) -> Result<(), GroundError> {
        if self.instances.len() + found.count > MAX_OPERATORS {
            return Err(GroundError::Operators { limit: MAX_OPERATORS });
        }
        // Each is one step of work here too.
        self.literals += found.count * (rule.positive.len() + rule.add.len());
        if self.literals > MAX_LITERALS_IN_ALL {
            return Err(GroundError::Literals { limit: MAX_LITERALS_IN_ALL });
        }
        let width = rule.slots.len();
        let mut objects = Vec::new();
        for instance in 0..found.count {
            let values = &found.values[instance * width..][..width];
            for atom in &rule.add {
                instantiate(atom, values, &mut objects);
                self.atoms.intern(atom.predicate, &objects);
            }
            if self.atoms.len() > MAX_ATOMS {
                return Err(GroundError::Atoms { limit: MAX_ATOMS });
            }
            self.instances.push(Instance { rule: number as u32, values: values.into() });
        }
        found.count = 0;
        found.values.clear();
        Ok(())
    }
}
