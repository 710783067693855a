//! Conjunctions of facts over a set of states: whether one holds somewhere, where, and in which states.

use rustc_hash::{FxHashMap, FxHashSet};

use super::store::{Branch, Diagrams, SetId};
use crate::limits::LimitReached;
use crate::task::{Fact, State};

impl Diagrams {
    /// The value that a conjunction of facts asks of each level, sorted by level; nothing where two of its facts
    /// exclude each other.
    fn wanted(&self, condition: &[Fact]) -> Option<Vec<(u32, u32)>> {
        let layout = self.task().layout();
        let mut wanted: Vec<(u32, u32)> = condition
            .iter()
            .map(|&fact| (self.level_of(fact), layout.value(fact) as u32))
            .collect();
        wanted.sort_unstable();
        wanted.dedup();
        wanted.is_sorted_by(|a, b| a.0 < b.0).then_some(wanted)
    }

    /// The states of the set that satisfy a conjunction of facts. Linear in the nodes of the set.
    ///
    /// # Errors
    ///
    /// [`LimitReached::Memory`] when the nodes outgrow the limit.
    pub fn satisfying(&mut self, set: SetId, condition: &[Fact]) -> Result<SetId, LimitReached> {
        match self.wanted(condition) {
            Some(wanted) => self.restricted(set, &wanted, &mut FxHashMap::default()),
            None => Ok(SetId::EMPTY),
        }
    }

    fn restricted(
        &mut self,
        set: SetId,
        wanted: &[(u32, u32)],
        done: &mut FxHashMap<SetId, SetId>,
    ) -> Result<SetId, LimitReached> {
        let Some(&(level, value)) = wanted.first() else { return Ok(set) };
        if set == SetId::EMPTY {
            return Ok(set);
        }
        if let Some(&known) = done.get(&set) {
            return Ok(known);
        }
        let here = self.level(set);
        let mut branches = Vec::new();
        for index in 0..self.branches(set).len() {
            let branch = self.branches(set)[index];
            let left = match here == level {
                true if branch.value != value => continue,
                true => &wanted[1..],
                false => wanted,
            };
            let below = self.restricted(branch.below, left, done)?;
            if below != SetId::EMPTY {
                branches.push(Branch { below, ..branch });
            }
        }
        let kept = self.node(here, &branches)?;
        done.insert(set, kept);
        Ok(kept)
    }

    /// A state of the set that satisfies a conjunction of facts.
    pub fn find(&self, set: SetId, condition: &[Fact]) -> Option<State> {
        let wanted = self.wanted(condition)?;
        let (mut dead, mut values) = (FxHashSet::default(), Vec::new());
        let mut at = set;
        if !self.reaches(at, &wanted, &mut dead) {
            return None;
        }
        while at != SetId::END {
            let left = &wanted[wanted.partition_point(|(level, _)| *level < self.level(at))..];
            let (value, below) = self.branches(at).iter().find_map(|branch| {
                let left = match left.first() {
                    Some(&(level, value)) if level == self.level(at) => {
                        if value != branch.value {
                            return None;
                        }
                        &left[1..]
                    }
                    _ => left,
                };
                let fits = self.reaches(branch.below, left, &mut dead);
                fits.then_some((branch.value, branch.below))
            })?;
            values.push(value);
            at = below;
        }
        Some(self.state(&values))
    }

    /// Whether some state of the set satisfies a conjunction of facts. Linear in the nodes of the set; makes none.
    pub fn satisfies(&self, set: SetId, condition: &[Fact]) -> bool {
        let Some(wanted) = self.wanted(condition) else { return false };
        let mut dead = FxHashSet::default();
        self.reaches(set, &wanted, &mut dead)
    }

    fn reaches(&self, set: SetId, wanted: &[(u32, u32)], dead: &mut FxHashSet<SetId>) -> bool {
        if set == SetId::EMPTY {
            return false;
        }
        let Some(&(level, value)) = wanted.first() else { return true };
        if dead.contains(&set) {
            return false;
        }
        let here = self.level(set);
        let found = self.branches(set).iter().any(|branch| {
            if here == level {
                branch.value == value && self.reaches(branch.below, &wanted[1..], dead)
            } else {
                self.reaches(branch.below, wanted, dead)
            }
        });
        if !found {
            dead.insert(set);
        }
        found
    }
}
