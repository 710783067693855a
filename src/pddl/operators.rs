//! Ground operators over numbered atoms, and which of them can really apply once negative
//! preconditions are heeded.

use fixedbitset::FixedBitSet;

use super::atom::{LiftedAtom, Term};
use super::atom_table::AtomTable;
use super::definition::TaskDefinition;
use super::domain::Domain;
use super::draft::Draft;
use super::ground::{GroundError, MAX_LITERALS_IN_ALL};
use super::join::MAX_JOIN_STEPS;
use super::object::ObjectId;
use super::reach::{Instance, Reached, instantiate, may_change, object};
use super::rule::Rule;

/// An operator; atoms are numbers in the [`AtomTable`].
#[derive(Debug, Clone)]
pub(super) struct GroundOperator {
    pub instance: Instance,
    pub positive: Vec<u32>,
    /// Atoms that may hold but must not.
    pub negative: Vec<u32>,
    pub add: Vec<u32>,
    pub delete: Vec<u32>,
}

/// Atoms, the operators over them, and drafts of more.
#[derive(Debug)]
pub(super) struct Candidates {
    pub atoms: AtomTable,
    pub plain: Vec<GroundOperator>,
    pub drafts: Vec<Draft>,
}

/// What can hold and what can be false in some reachable state, deletes and adds ignored in turn.
#[derive(Debug)]
pub(super) struct Possible {
    pub hold: FixedBitSet,
    pub fail: FixedBitSet,
}

/// The operators of the instances reached, those left out whose preconditions contradict
/// themselves.
pub(super) fn operators(
    domain: &Domain,
    task: &TaskDefinition,
    rules: &[Rule<'_>],
    reached: Reached,
) -> Result<Candidates, GroundError> {
    let Reached { atoms, instances, .. } = reached;
    let may_change = may_change(domain);
    let mut drafts = Vec::new();
    let mut budget = MAX_JOIN_STEPS;
    let mut operators = Vec::with_capacity(instances.len());
    let mut literals = 0;
    let mut objects = Vec::new();
    for instance in instances {
        let rule = &rules[instance.rule as usize];
        let mut all = |lifted: &[LiftedAtom], values: &[ObjectId]| {
            let mut found: Vec<u32> = Vec::with_capacity(lifted.len());
            for atom in lifted {
                instantiate(atom, values, &mut objects);
                // An atom that is not there never holds.
                found.extend(atoms.find(atom.predicate, &objects));
            }
            found.sort_unstable();
            found.dedup();
            found
        };
        let positive = all(&rule.positive, &instance.values);
        let negative = all(&rule.negative, &instance.values);
        let add = all(&rule.add, &instance.values);
        let mut delete = all(&rule.delete, &instance.values);
        delete.retain(|atom| add.binary_search(atom).is_err());
        if negative.iter().any(|atom| positive.binary_search(atom).is_ok()) {
            continue;
        }
        let cost = &domain.schemas[rule.schema].cost;
        // An action whose cost has no value cannot be taken.
        if task.has_costs && !cost.is_empty() && cost_of(domain, task, rule, &instance).is_none() {
            continue;
        }
        literals += positive.len() + negative.len() + add.len() + delete.len();
        if literals > MAX_LITERALS_IN_ALL {
            return Err(GroundError::Literals { limit: MAX_LITERALS_IN_ALL });
        }
        let arguments = (!rule.is_plain()).then(|| rule.arguments_of(&instance.values));
        let operator = GroundOperator { instance, positive, negative, add, delete };
        let Some(arguments) = arguments else {
            operators.push(operator);
            continue;
        };
        let known = (&task.objects, &atoms);
        let draft = Draft::new(operator, rule, arguments, &may_change, known, &mut budget)?;
        literals += draft.size();
        if literals > MAX_LITERALS_IN_ALL {
            return Err(GroundError::Literals { limit: MAX_LITERALS_IN_ALL });
        }
        drafts.push(draft);
    }
    Ok(Candidates { atoms, plain: operators, drafts })
}

/// What an instance costs; none where a function has no value.
pub(super) fn cost_of(
    domain: &Domain,
    task: &TaskDefinition,
    rule: &Rule<'_>,
    instance: &Instance,
) -> Option<u64> {
    let object = |term: Term| match term {
        Term::Object(object) => object,
        Term::Parameter(position) => object(rule.arguments[position as usize], &instance.values),
    };
    task.values.cost(&domain.schemas[rule.schema].cost, object)
}

/// Keeps the operators that can apply when an atom, once it has held, may hold again, and once it
/// has been false, may be false again. `initial` are the atoms of each initial state.
pub(super) fn keep_possible(
    operators: &mut Vec<GroundOperator>,
    atom_count: usize,
    initial: &[FixedBitSet],
) -> Possible {
    let mut possible = Possible {
        hold: FixedBitSet::with_capacity(atom_count),
        fail: FixedBitSet::with_capacity(atom_count),
    };
    for state in initial {
        possible.hold.union_with(state);
        let mut rest = state.clone();
        rest.toggle_range(..);
        possible.fail.union_with(&rest);
    }
    // The operators that wait for an atom to hold, and for one to be false.
    let mut waiting: [Vec<Vec<u32>>; 2] =
        [vec![Vec::new(); atom_count], vec![Vec::new(); atom_count]];
    let mut missing = vec![0_u32; operators.len()];
    for (number, operator) in operators.iter().enumerate() {
        for (side, (atoms, known)) in
            [(&operator.positive, &possible.hold), (&operator.negative, &possible.fail)]
                .into_iter()
                .enumerate()
        {
            for &atom in atoms.iter().filter(|&&atom| !known.contains(atom as usize)) {
                waiting[side][atom as usize].push(number as u32);
                missing[number] += 1;
            }
        }
    }
    let mut ready: Vec<u32> =
        (0..operators.len() as u32).filter(|&number| missing[number as usize] == 0).collect();
    let mut applies = FixedBitSet::with_capacity(operators.len());
    while let Some(number) = ready.pop() {
        applies.insert(number as usize);
        let operator = &operators[number as usize];
        for (side, (atoms, known)) in
            [(&operator.add, &mut possible.hold), (&operator.delete, &mut possible.fail)]
                .into_iter()
                .enumerate()
        {
            for &atom in atoms.iter().filter(|&&atom| !known.put(atom as usize)) {
                for &waiter in &waiting[side][atom as usize] {
                    missing[waiter as usize] -= 1;
                    if missing[waiter as usize] == 0 {
                        ready.push(waiter);
                    }
                }
            }
        }
    }
    let mut number = 0;
    operators.retain(|_| {
        number += 1;
        applies.contains(number - 1)
    });
    possible
}
