//! Instances of a rule whose preconditions hold among the atoms reached so far.
//!
//! Preconditions are matched one after the other, always the one with the fewest atoms left to try:
//! an index gives the atoms of a predicate with a given object in a given place, so that static
//! preconditions cut the work as soon as one of their parameters is known.

use rustc_hash::FxHashMap;

use super::atom::{LiftedAtom, Term};
use super::atom_table::AtomTable;
use super::ground::{GroundError, MAX_OPERATORS};
use super::object::{ObjectId, Objects};
use super::predicate::PredicateId;
use super::rule::Rule;

/// Atoms and inequalities tried in all joins together, at most. About a second of work.
pub const MAX_JOIN_STEPS: u64 = if cfg!(target_arch = "wasm32") { 50_000_000 } else { 100_000_000 };

/// Atoms by predicate, and by predicate, place and object.
#[derive(Debug, Default)]
pub(super) struct Index {
    of_predicate: FxHashMap<PredicateId, Vec<u32>>,
    of_object: FxHashMap<(PredicateId, u32, ObjectId), Vec<u32>>,
}

impl Index {
    /// From here on the atom is matched. Atoms come in the order of their numbers.
    pub(super) fn insert(&mut self, atoms: &AtomTable, atom: u32) {
        let (predicate, objects) = atoms.get(atom);
        self.of_predicate.entry(predicate).or_default().push(atom);
        for (place, &object) in (0..).zip(objects) {
            self.of_object.entry((predicate, place, object)).or_default().push(atom);
        }
    }

    fn all(&self, predicate: PredicateId) -> &[u32] {
        self.of_predicate.get(&predicate).map_or(&[], Vec::as_slice)
    }

    fn with(&self, predicate: PredicateId, place: u32, object: ObjectId) -> &[u32] {
        self.of_object.get(&(predicate, place, object)).map_or(&[], Vec::as_slice)
    }
}

/// The instances of a rule that were found, as the values of its slots one after the other.
#[derive(Debug, Default)]
pub(super) struct Found {
    pub count: usize,
    pub values: Vec<ObjectId>,
}

/// Matches one rule.
#[derive(Debug)]
pub(super) struct Join<'a> {
    pub rule: &'a Rule<'a>,
    pub objects: &'a Objects,
    pub atoms: &'a AtomTable,
    pub index: &'a Index,
    /// The atom that is new: the preconditions before `trigger` match older ones only, so that each
    /// instance is found once.
    pub newest: u32,
    /// The precondition that the newest atom has matched.
    pub trigger: usize,
    pub values: Vec<Option<ObjectId>>,
    /// Preconditions not matched yet.
    pub open: Vec<usize>,
    pub steps: &'a mut u64,
    pub found: &'a mut Found,
}

impl<'a> Join<'a> {
    /// Matches the trigger with the newest atom, then everything else.
    pub(super) fn start(&mut self) -> Result<(), GroundError> {
        self.try_atom(self.trigger, self.newest)
    }

    /// Goes on where a precondition matches an atom.
    fn try_atom(&mut self, precondition: usize, atom: u32) -> Result<(), GroundError> {
        let mut bound = 0_u64;
        let fits = self.bind(precondition, atom, &mut bound);
        let done = match if fits { self.differ(bound) } else { Ok(false) } {
            Ok(true) => self.rest(),
            Ok(false) => Ok(()),
            Err(limit) => Err(limit),
        };
        while bound != 0 {
            self.values[bound.trailing_zeros() as usize] = None;
            bound &= bound - 1;
        }
        done
    }

    /// Matches a precondition with an atom; the slots that got a value are noted in `bound`.
    fn bind(&mut self, precondition: usize, atom: u32, bound: &mut u64) -> bool {
        let (_, objects) = self.atoms.get(atom);
        let terms = &self.rule.positive[precondition].terms;
        for (&term, &object) in terms.iter().zip(objects) {
            match self.value(term) {
                Some(value) if value != object => return false,
                Some(_) => {}
                None => {
                    let Term::Parameter(slot) = term else { return false };
                    if !self.rule.fits(slot, object, self.objects) {
                        return false;
                    }
                    self.values[slot as usize] = Some(object);
                    *bound |= 1 << slot;
                }
            }
        }
        true
    }

    fn value(&self, term: Term) -> Option<ObjectId> {
        match term {
            Term::Object(object) => Some(object),
            Term::Parameter(slot) => self.values[slot as usize],
        }
    }

    /// Whether slots that have just got a value differ from what they must.
    fn differ(&mut self, bound: u64) -> Result<bool, GroundError> {
        let rule = self.rule;
        let mut left = bound;
        while left != 0 {
            let slot = left.trailing_zeros() as usize;
            left &= left - 1;
            let others = &rule.unequal[slot];
            self.count_steps(others.len())?;
            let value = self.values[slot];
            if others.iter().any(|&other| self.value(other) == value) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Whether a precondition may match an atom.
    fn is_old_enough(&self, precondition: usize, atom: u32) -> bool {
        if precondition < self.trigger { atom < self.newest } else { atom <= self.newest }
    }

    /// Atoms among which are all that a precondition can match: as few as the index can tell.
    fn candidates(&self, atom: &LiftedAtom) -> &'a [u32] {
        let index = self.index;
        let mut best = index.all(atom.predicate);
        for (place, &term) in (0..).zip(&atom.terms) {
            if let Some(object) = self.value(term) {
                let with = index.with(atom.predicate, place, object);
                if with.len() < best.len() {
                    best = with;
                }
            }
        }
        best
    }

    fn count_steps(&mut self, steps: usize) -> Result<(), GroundError> {
        *self.steps += steps as u64;
        if *self.steps > MAX_JOIN_STEPS {
            return Err(GroundError::Steps { limit: MAX_JOIN_STEPS });
        }
        Ok(())
    }

    /// Matches the open preconditions. Recurses once for each.
    pub(super) fn rest(&mut self) -> Result<(), GroundError> {
        self.count_steps(1 + self.open.len())?;
        let mut best: Option<(usize, &[u32])> = None;
        for (place, &precondition) in self.open.iter().enumerate() {
            let candidates = self.candidates(&self.rule.positive[precondition]);
            if best.is_none_or(|(_, best)| candidates.len() < best.len()) {
                best = Some((place, candidates));
            }
        }
        let Some((place, candidates)) = best else { return self.free(0) };
        self.count_steps(candidates.len())?;
        let precondition = self.open.swap_remove(place);
        for &atom in candidates {
            if self.is_old_enough(precondition, atom) {
                self.try_atom(precondition, atom)?;
            }
        }
        self.open.push(precondition);
        let last = self.open.len() - 1;
        self.open.swap(place, last);
        Ok(())
    }

    /// Gives values to the slots in no positive precondition.
    fn free(&mut self, number: usize) -> Result<(), GroundError> {
        let rule = self.rule;
        let Some((slot, objects)) = rule.free.get(number) else {
            if self.found.count == MAX_OPERATORS {
                return Err(GroundError::Operators { limit: MAX_OPERATORS });
            }
            self.found.count += 1;
            self.found.values.extend(self.values.iter().copied().flatten());
            return Ok(());
        };
        self.count_steps(objects.len())?;
        for &object in objects {
            self.values[*slot as usize] = Some(object);
            if self.differ(1 << *slot)? {
                self.free(number + 1)?;
            }
        }
        self.values[*slot as usize] = None;
        Ok(())
    }
}
