//! Makes STRIPS operators of drafts: one for each way in which conditions can hold and fail.
//!
//! A decision tree asks for one atom after the other until the precondition holds and each effect is known to take
//! place or not. Its leaves exclude each other, so that an action has one successor in a state at most, and all of
//! them bear the action's name. Nebel 2000 (doi:10.1613/jair.735) shows that without further steps in plans this can
//! take exponentially many operators; the limits of the grounding end that.

use rustc_hash::FxHashMap;

use super::draft::{Draft, Numbered};
use super::exclusive::Exclusive;
use super::ground::{GroundError, MAX_LITERALS_IN_ALL, MAX_OPERATORS};
use super::join::MAX_JOIN_STEPS;
use super::operators::GroundOperator;

/// One draft at work.
struct Split<'a> {
    draft: &'a Draft,
    exclusive: &'a Exclusive,
    /// What is known of atoms.
    known: FxHashMap<u32, bool>,
    /// The atoms that became known, one after the other.
    trail: Vec<u32>,
    /// The literals asked for beside those of the draft.
    asked: Vec<(u32, bool)>,
    made: &'a mut Made,
}

/// The operators made.
struct Made {
    operators: Vec<GroundOperator>,
    literals: usize,
    steps: u64,
    /// Operators that are there beside them.
    others: usize,
}

/// Adds the operators of drafts to those that are there.
pub(super) fn split(
    drafts: &[Draft],
    exclusive: &Exclusive,
    operators: &mut Vec<GroundOperator>,
) -> Result<(), GroundError> {
    let mut made = Made { operators: Vec::new(), literals: 0, steps: 0, others: operators.len() };
    for draft in drafts {
        let mut split = Split {
            draft,
            exclusive,
            known: FxHashMap::default(),
            trail: Vec::new(),
            asked: Vec::new(),
            made: &mut made,
        };
        let positive = draft.positive.iter().map(|&atom| (atom, true));
        let negative = draft.negative.iter().map(|&atom| (atom, false));
        if positive.chain(negative).all(|(atom, holds)| split.assume(atom, holds)) {
            split.precondition()?;
        }
    }
    operators.append(&mut made.operators);
    Ok(())
}

impl Split<'_> {
    /// Takes an atom for true or false, and what excludes it for false; false where that contradicts what is known.
    fn assume(&mut self, atom: u32, holds: bool) -> bool {
        match self.known.get(&atom) {
            Some(&known) => return known == holds,
            None => {
                self.known.insert(atom, holds);
                self.trail.push(atom);
            }
        }
        if holds {
            for &set in self.exclusive.sets_of(atom) {
                for &other in &self.exclusive.sets[set as usize] {
                    match self.known.get(&other) {
                        _ if other == atom => {}
                        Some(true) => return false,
                        Some(false) => {}
                        None => {
                            self.known.insert(other, false);
                            self.trail.push(other);
                        }
                    }
                }
            }
        }
        true
    }

    fn undo(&mut self, to: usize) {
        for atom in self.trail.drain(to..) {
            self.known.remove(&atom);
        }
    }

    /// A formula as far as it is not known.
    fn left(&mut self, formula: &Numbered) -> Numbered {
        let known = &self.known;
        let mut atoms = 1;
        let left = formula.replace(&mut |atom, holds| {
            atoms += 1;
            known
                .get(atom)
                .map_or(Numbered::Atom(*atom, holds), |&known| Numbered::constant(known == holds))
        });
        self.made.steps += atoms;
        left
    }

    /// Asks until the precondition holds.
    fn precondition(&mut self) -> Result<(), GroundError> {
        let draft = self.draft;
        let (trail, asked) = (self.trail.len(), self.asked.len());
        let mut open = None;
        let mut again = true;
        let mut fails = false;
        while again && !fails {
            again = false;
            open = None;
            for formula in &draft.rest {
                let left = self.left(formula);
                if left.value() == Some(false) {
                    fails = true;
                    break;
                }
                for part in left.conjuncts() {
                    match part {
                        &Numbered::Atom(atom, holds) => {
                            fails |= !self.assume(atom, holds);
                            self.asked.push((atom, holds));
                            again = true;
                        }
                        other => open = open.or_else(|| first_atom(other)),
                    }
                }
            }
        }
        self.check()?;
        if !fails {
            match open {
                Some(atom) => self.both(atom, Self::precondition)?,
                None => self.effects(0)?,
            }
        }
        self.undo(trail);
        self.asked.truncate(asked);
        Ok(())
    }

    /// Goes on with an atom that holds, then with one that does not.
    fn both(
        &mut self,
        atom: u32,
        next: impl Fn(&mut Self) -> Result<(), GroundError>,
    ) -> Result<(), GroundError> {
        for holds in [true, false] {
            let trail = self.trail.len();
            if self.assume(atom, holds) {
                self.asked.push((atom, holds));
                next(self)?;
                self.asked.pop();
            }
            self.undo(trail);
        }
        Ok(())
    }

    /// Asks until it is known of each case from this one on whether its condition holds.
    fn effects(&mut self, from: usize) -> Result<(), GroundError> {
        let draft = self.draft;
        for (number, case) in draft.cases.iter().enumerate().skip(from) {
            let left = self.left(&case.condition);
            if left.value().is_none()
                && let Some(atom) = first_atom(&left)
            {
                self.check()?;
                return self.both(atom, |split| split.effects(number));
            }
        }
        self.leaf()
    }

    /// All conditions are known.
    fn leaf(&mut self) -> Result<(), GroundError> {
        let draft = self.draft;
        let [mut add, mut delete] = [draft.add.clone(), draft.delete.clone()];
        for case in &draft.cases {
            if self.left(&case.condition).value() == Some(true) {
                add.extend_from_slice(&case.add);
                delete.extend_from_slice(&case.delete);
            }
        }
        let mut positive = draft.positive.clone();
        let mut negative = draft.negative.clone();
        for &(atom, holds) in &self.asked {
            if holds { positive.push(atom) } else { negative.push(atom) }
        }
        for list in [&mut positive, &mut negative, &mut add, &mut delete] {
            list.sort_unstable();
            list.dedup();
        }
        delete.retain(|atom| add.binary_search(atom).is_err());
        self.made.literals += positive.len() + negative.len() + add.len() + delete.len();
        let instance = draft.instance.clone();
        self.made.operators.push(GroundOperator { instance, positive, negative, add, delete });
        self.check()
    }

    fn check(&mut self) -> Result<(), GroundError> {
        let made = &mut *self.made;
        made.steps += 1;
        if made.operators.len() + made.others > MAX_OPERATORS {
            return Err(GroundError::Operators { limit: MAX_OPERATORS });
        }
        if made.literals > MAX_LITERALS_IN_ALL {
            return Err(GroundError::Literals { limit: MAX_LITERALS_IN_ALL });
        }
        if made.steps > MAX_JOIN_STEPS {
            return Err(GroundError::Steps { limit: MAX_JOIN_STEPS });
        }
        Ok(())
    }
}

/// The atom of a formula that stands first.
fn first_atom(formula: &Numbered) -> Option<u32> {
    match formula {
        Numbered::Atom(atom, _) => Some(*atom),
        Numbered::And(parts) | Numbered::Or(parts) => parts.iter().find_map(first_atom),
    }
}
