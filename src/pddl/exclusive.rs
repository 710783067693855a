//! Sets of ground atoms of which at most one holds in any reachable state.
//!
//! Each set is proved from the ground operators alone: in every initial state at most one of its
//! atoms holds, and an operator that adds one of them adds no other, requires one of them, and
//! deletes that one unless it is the one it adds. An operator that requires two of them can never
//! apply.

use fixedbitset::FixedBitSet;
use rustc_hash::{FxHashMap, FxHashSet};

use super::atom_table::AtomTable;
use super::draft::{Case, Draft, Numbered, literals};
use super::invariant::Candidate;
use super::object::ObjectId;
use super::operators::GroundOperator;

/// In no set.
const NONE: u32 = u32::MAX;

/// The sets found.
#[derive(Debug)]
pub(super) struct Exclusive {
    /// Each with its atoms in order, two at least.
    pub sets: Vec<Vec<u32>>,
    /// The sets of each atom.
    of_atom: Vec<Vec<u32>>,
}

impl Exclusive {
    /// Proves what it can of the candidates.
    pub(super) fn new(
        candidates: &[Candidate],
        atoms: &AtomTable,
        operators: &[GroundOperator],
        drafts: &[Draft],
        initial: &[FixedBitSet],
    ) -> Self {
        let mut exclusive = Self { sets: Vec::new(), of_atom: vec![Vec::new(); atoms.len()] };
        let mut seen: FxHashSet<Vec<u32>> = FxHashSet::default();
        for candidate in candidates {
            for set in proved(candidate, atoms, operators, drafts, initial) {
                if set.len() > 1 && seen.insert(set.clone()) {
                    for &atom in &set {
                        exclusive.of_atom[atom as usize].push(exclusive.sets.len() as u32);
                    }
                    exclusive.sets.push(set);
                }
            }
        }
        exclusive
    }

    /// The sets of an atom.
    pub(super) fn sets_of(&self, atom: u32) -> &[u32] {
        self.of_atom.get(atom as usize).map_or(&[], Vec::as_slice)
    }

    /// Whether two of these atoms, which are all different, can never hold together.
    pub(super) fn contradict(&self, atoms: &[u32]) -> bool {
        let mut sets: Vec<u32> =
            atoms.iter().flat_map(|&atom| &self.of_atom[atom as usize]).copied().collect();
        sets.sort_unstable();
        sets.windows(2).any(|pair| pair[0] == pair[1])
    }

    /// The sets that a state is packed by: greedily the one with the most atoms that are in none
    /// chosen before. `kept` says which atoms count.
    pub(super) fn chosen(&self, kept: impl Fn(u32) -> bool) -> Vec<Vec<u32>> {
        let mut sets: Vec<Vec<u32>> = self.sets.clone();
        for set in &mut sets {
            set.retain(|&atom| kept(atom));
        }
        let mut taken = FixedBitSet::with_capacity(self.of_atom.len());
        // By size, as far as it is known; what was taken since is found out when the turn comes.
        let mut by_size: Vec<Vec<u32>> = Vec::new();
        for (number, set) in (0..).zip(&sets) {
            by_size.resize_with(by_size.len().max(set.len() + 1), Vec::new);
            by_size[set.len()].push(number);
        }
        let mut chosen = Vec::new();
        while let Some(mut numbers) = by_size.pop() {
            let size = by_size.len();
            if size < 2 {
                break;
            }
            numbers.sort_unstable();
            for number in numbers {
                let set = &sets[number as usize];
                let left = set.iter().filter(|&&atom| !taken.contains(atom as usize)).count();
                if left < size {
                    by_size[left].push(number);
                } else {
                    taken.extend(set.iter().map(|&atom| atom as usize));
                    chosen.push(set.clone());
                }
            }
        }
        chosen
    }
}

/// The sets of one candidate that hold the proof.
fn proved(
    candidate: &Candidate,
    atoms: &AtomTable,
    operators: &[GroundOperator],
    drafts: &[Draft],
    initial: &[FixedBitSet],
) -> Vec<Vec<u32>> {
    let mut numbers: FxHashMap<Vec<ObjectId>, u32> = FxHashMap::default();
    let mut sets: Vec<Vec<u32>> = Vec::new();
    let mut set_of = vec![NONE; atoms.len()];
    for atom in 0..atoms.len() as u32 {
        let (predicate, objects) = atoms.get(atom);
        let Some(part) = candidate.iter().find(|part| part.predicate == predicate) else {
            continue;
        };
        let key = part.key.iter().map(|&place| objects[place as usize]).collect();
        let number = *numbers.entry(key).or_insert(sets.len() as u32);
        if number as usize == sets.len() {
            sets.push(Vec::new());
        }
        sets[number as usize].push(atom);
        set_of[atom as usize] = number;
    }
    let mut fails = vec![false; sets.len()];
    for state in initial {
        let mut held = vec![false; sets.len()];
        for atom in state.ones() {
            if set_of[atom] != NONE {
                let set = set_of[atom] as usize;
                fails[set] |= std::mem::replace(&mut held[set], true);
            }
        }
    }
    for operator in operators {
        for (place, &added) in operator.add.iter().enumerate() {
            let set = set_of[added as usize];
            if set != NONE && !fails[set as usize] {
                let of_set = |atom: &&u32| set_of[**atom as usize] == set;
                let mut before = operator.positive.iter().filter(of_set);
                let keeps = match (before.next(), before.next()) {
                    (None, _) => false,
                    (Some(before), None) => {
                        let goes =
                            *before == added || operator.delete.binary_search(before).is_ok();
                        goes && operator.add[place + 1..].iter().find(of_set).is_none()
                    }
                    // It requires two of the set: it never applies.
                    (Some(_), Some(_)) => true,
                };
                fails[set as usize] |= !keeps;
            }
        }
    }
    for draft in drafts {
        breaks(draft, &set_of, &mut fails);
    }
    let mut number = 0;
    sets.retain(|_| {
        number += 1;
        !fails[number - 1]
    });
    sets
}

/// Notes the sets of which a draft may make two atoms hold. An effect that adds one of a set must require one of it,
/// whether in the draft's precondition or in its own condition; that one must go, unless it is the one added; and
/// effects that require the same one must add the same one.
fn breaks(draft: &Draft, set_of: &[u32], fails: &mut [bool]) {
    let mut required = (draft.positive.clone(), draft.negative.clone());
    for formula in &draft.rest {
        literals(formula, &mut required.0, &mut required.1);
    }
    let always: (&[u32], &[u32]) = (&draft.add, &draft.delete);
    let cases = draft.cases.iter().map(|case| {
        let mut known = required.clone();
        literals(&case.condition, &mut known.0, &mut known.1);
        (known, (case.add.as_slice(), case.delete.as_slice()))
    });
    // Of each set and the atom of it that held before, what is added.
    let mut moves: FxHashMap<(u32, u32), u32> = FxHashMap::default();
    for ((positive, negative), (add, delete)) in
        std::iter::once((required.clone(), always)).chain(cases)
    {
        for &added in add {
            let set = set_of[added as usize];
            if set == NONE || fails[set as usize] {
                continue;
            }
            let mut before = positive.iter().filter(|atom| set_of[**atom as usize] == set);
            let Some(&held) = before.next() else {
                fails[set as usize] = true;
                continue;
            };
            // It requires two of the set: it never takes place.
            if before.next().is_some() {
                continue;
            }
            // What surely takes place along with it.
            let along = |case: &&Case| {
                case.condition.conjuncts().iter().all(|part| match part {
                    Numbered::Atom(atom, true) => positive.contains(atom),
                    Numbered::Atom(atom, false) => negative.contains(atom),
                    _ => false,
                })
            };
            let goes = held == added
                || delete.contains(&held)
                || draft.delete.contains(&held)
                || draft.cases.iter().filter(along).any(|case| case.delete.contains(&held));
            let other = moves.insert((set, held), added);
            fails[set as usize] |= !goes || other.is_some_and(|other| other != added);
        }
    }
}
