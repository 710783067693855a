//! Pairwise beliefs: supersets of beliefs that keep, of any two groups of facts, the pairs of values that occur together.
//!
//! What a belief's states have in common in three groups or more is forgotten, so the set of pairs grows no larger than the
//! square of the number of values, however many states a belief has. A pair that is not there occurs in no state of the
//! belief, so a goal with two such facts is dead for the observer. The converse does not hold.
//!
//! This is the progression of mutual exclusion between pairs of facts (h² of Haslum and Geffner 2000, "Admissible heuristics
//! for optimal planning"; the planning graph of Blum and Furst 1997, doi:10.1016/S0004-3702(96)00047-1), restricted
//! at each step to the operators behind the symbol that was seen.

#[cfg(test)]
mod tests;

use super::InitialBelief;
use crate::sensor::{Sensor, Symbol};
use crate::task::{Fact, Operator, State, Task};

/// The most values of all groups together: a set of as many takes half a MiB.
const MOST_VALUES: usize = 2048;

/// A set of pairs of values: which values occur, then for each of these the values that occur with it. Equal sets are equal.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct PairwiseBelief(Box<[u64]>);

/// What an operator that gives a symbol does to values.
#[derive(Debug, Clone)]
struct Effect {
    /// Values that must hold before.
    before: Vec<u32>,
    /// Values that hold afterwards, whatever held before.
    after: Vec<u32>,
    /// The groups of the values in `after`.
    fixed: Vec<u32>,
    /// Values of other groups that are taken away, each with the value for none of the group.
    deleted: Vec<(u32, u32)>,
}

/// Updates of the pairwise beliefs of one sensor.
#[derive(Debug, Clone)]
pub struct PairwiseUpdates {
    /// Where the values of each group begin, and the number of all.
    offsets: Vec<u32>,
    /// Words of a row.
    width: usize,
    symbols: Vec<Vec<Effect>>,
}

fn contains(row: &[u64], value: u32) -> bool {
    row[value as usize / 64] >> (value % 64) & 1 == 1
}

fn insert(row: &mut [u64], value: u32) {
    row[value as usize / 64] |= 1 << (value % 64);
}

fn remove(row: &mut [u64], value: u32) {
    row[value as usize / 64] &= !(1 << (value % 64));
}

fn ones(row: &[u64]) -> impl Iterator<Item = u32> + '_ {
    row.iter().enumerate().flat_map(|(place, &word)| {
        let mut left = word;
        std::iter::from_fn(move || {
            let bit = left.trailing_zeros();
            (left != 0).then(|| {
                left &= left - 1;
                64 * place as u32 + bit
            })
        })
    })
}

impl Effect {
    /// What an operator does where these facts hold afterwards; none where they cannot.
    fn new(task: &Task, offsets: &[u32], operator: &Operator, seen: &[Fact]) -> Option<Self> {
        let layout = task.layout();
        let group = |fact: &Fact| layout.group(*fact) as u32;
        let value = |fact: &Fact| offsets[layout.group(*fact)] + layout.value(*fact) as u32;
        let mut before: Vec<(u32, u32)> =
            operator.preconditions.iter().map(|fact| (group(fact), value(fact))).collect();
        let added: Vec<(u32, u32)> =
            operator.add.iter().map(|fact| (group(fact), value(fact))).collect();
        let is_added = |wanted: u32| added.iter().any(|(group, _)| *group == wanted);
        let is_deleted = |wanted: u32| operator.delete.iter().any(|fact| value(fact) == wanted);
        let touched = |wanted: u32| {
            is_added(wanted) || operator.delete.iter().any(|fact| group(fact) == wanted)
        };
        // What is untouched and seen afterwards held before.
        before.extend(
            seen.iter().map(|f| (group(f), value(f))).filter(|(group, _)| !touched(*group)),
        );
        before.sort_unstable();
        before.dedup();
        if before.windows(2).any(|pair| pair[0].0 == pair[1].0) {
            return None;
        }
        let mut after = added.clone();
        for &(group, value) in before.iter().filter(|(group, _)| !is_added(*group)) {
            let none = offsets[group as usize];
            after.push((group, if is_deleted(value) { none } else { value }));
        }
        after.sort_unstable();
        after.dedup();
        let contradicts = |fact: &Fact| {
            after.iter().any(|&(known, holds)| known == group(fact) && holds != value(fact))
        };
        if seen.iter().any(contradicts) {
            return None;
        }
        let is_fixed = |wanted: u32| after.iter().any(|(group, _)| *group == wanted);
        let conditional = operator.delete.iter().filter(|fact| !is_fixed(group(fact)));
        let deleted = conditional.map(|fact| (value(fact), offsets[layout.group(*fact)])).collect();
        Some(Self {
            before: before.into_iter().map(|(_, value)| value).collect(),
            fixed: after.iter().map(|(group, _)| *group).collect(),
            after: after.into_iter().map(|(_, value)| value).collect(),
            deleted,
        })
    }

    fn map(&self, row: &mut [u64]) {
        for &(value, none) in &self.deleted {
            if contains(row, value) {
                remove(row, value);
                insert(row, none);
            }
        }
    }
}

impl PairwiseUpdates {
    /// Reads the operators behind each symbol of a sensor; none where the task has too many values. Linear in the operators
    /// and the cases of the sensor.
    pub fn new(task: &Task, sensor: &Sensor) -> Option<Self> {
        let layout = task.layout();
        let mut offsets = vec![0_u32];
        let mut values = 0;
        for group in 0..layout.group_count() {
            values += layout.group_size(group) + 1;
            offsets.push(values as u32);
        }
        if values > MOST_VALUES {
            return None;
        }
        let mut symbols = vec![Vec::new(); sensor.symbol_count()];
        for (id, operator) in task.operator_ids() {
            let always = Effect::new(task, &offsets, operator, &[]);
            let value = |fact: &Fact| offsets[layout.group(*fact)] + layout.value(*fact) as u32;
            let otherwise: (&[Fact], Symbol) = (&[], sensor.otherwise(id));
            for (seen, symbol) in sensor.cases(id).chain([otherwise]) {
                symbols[symbol.index()].extend(Effect::new(task, &offsets, operator, seen));
                // After a case that always fits none counts.
                let fits = |effect: &Effect| seen.iter().all(|f| effect.after.contains(&value(f)));
                if always.as_ref().is_none_or(fits) {
                    break;
                }
            }
        }
        Some(Self { offsets, width: values.div_ceil(64), symbols })
    }

    fn values(&self) -> usize {
        self.offsets.last().map_or(0, |values| *values as usize)
    }

    /// The pairs of values in some states.
    pub fn of_states(&self, task: &Task, states: &[State]) -> PairwiseBelief {
        let mut rows = vec![0; self.values() * self.width];
        let layout = task.layout();
        for state in states {
            let mut all = vec![0; self.width];
            for group in 0..layout.group_count() {
                let value = layout.group_value(state.words(), group) as u32;
                insert(&mut all, self.offsets[group] + value);
            }
            for value in ones(&all) {
                self.join(&mut rows, value, &all);
            }
        }
        self.pack(&rows)
    }

    /// The pairs of values that an observer can believe at first. Of states that are not listed these are all pairs of values
    /// that occur.
    pub fn initial(&self, task: &Task, believed: &InitialBelief) -> PairwiseBelief {
        let Some((diagrams, set)) = believed.diagram() else {
            return self.of_states(task, believed.listed().unwrap_or_default());
        };
        let mut rows = vec![0; self.values() * self.width];
        let mut all = vec![0; self.width];
        let present = diagrams.values(set);
        for (offset, values) in self.offsets.iter().zip(&present) {
            for value in values {
                insert(&mut all, offset + value);
            }
        }
        for (offset, values) in self.offsets.iter().zip(&present) {
            for value in values.iter().map(|value| offset + value) {
                self.join(&mut rows, value, &all);
                let others = values.iter().map(|other| offset + other);
                let row = &mut rows[value as usize * self.width..][..self.width];
                others.filter(|other| *other != value).for_each(|other| remove(row, other));
            }
        }
        self.pack(&rows)
    }

    fn join(&self, rows: &mut [u64], value: u32, other: &[u64]) {
        let row = &mut rows[value as usize * self.width..][..self.width];
        for (word, other) in row.iter_mut().zip(other) {
            *word |= other;
        }
    }

    /// Leaves the rows of values out that do not occur.
    fn pack(&self, rows: &[u64]) -> PairwiseBelief {
        let mut present = vec![0; self.width];
        for value in 0..self.values() as u32 {
            if contains(&rows[value as usize * self.width..][..self.width], value) {
                insert(&mut present, value);
            }
        }
        let mut packed = present.clone();
        for value in ones(&present) {
            packed.extend_from_slice(&rows[value as usize * self.width..][..self.width]);
        }
        PairwiseBelief(packed.into_boxed_slice())
    }

    /// The values that occur together with one; none where it does not occur.
    fn row<'a>(&self, belief: &'a PairwiseBelief, value: u32) -> Option<&'a [u64]> {
        let (present, rows) = belief.0.split_at(self.width);
        if !contains(present, value) {
            return None;
        }
        let (word, bit) = (value as usize / 64, value % 64);
        let before: u32 = present[..word].iter().map(|word| word.count_ones()).sum();
        let place = before + (present[word] & ((1 << bit) - 1)).count_ones();
        Some(&rows[place as usize * self.width..][..self.width])
    }

    /// The pairs after a symbol: at least those that occur in the belief after it, where the belief before has no others
    /// than these. Linear in the operators behind the symbol, times the pairs.
    pub fn update(&self, belief: &PairwiseBelief, symbol: Symbol) -> PairwiseBelief {
        let mut next = vec![0; self.values() * self.width];
        let mut free = vec![0; self.width];
        let mut row = vec![0; self.width];
        let mut moved = vec![0; self.width];
        for effect in &self.symbols[symbol.index()] {
            free.copy_from_slice(&belief.0[..self.width]);
            let rows = effect.before.iter().map(|value| self.row(belief, *value));
            for known in rows {
                match known {
                    Some(known) => free.iter_mut().zip(known).for_each(|(free, row)| *free &= row),
                    None => free.fill(0),
                }
            }
            // Its preconditions can hold together where each of them occurs with all others.
            if effect.before.iter().any(|value| !contains(&free, *value))
                || belief.0[..self.width].iter().all(|word| *word == 0)
            {
                continue;
            }
            for &group in &effect.fixed {
                let group = group as usize;
                (self.offsets[group]..self.offsets[group + 1])
                    .for_each(|value| remove(&mut free, value));
            }
            let mut after = vec![0; self.width];
            effect.after.iter().for_each(|value| insert(&mut after, *value));
            moved.copy_from_slice(&free);
            effect.map(&mut moved);
            for value in ones(&free) {
                let Some(known) = self.row(belief, value) else { continue };
                for (place, word) in row.iter_mut().enumerate() {
                    *word = known[place] & free[place];
                }
                effect.map(&mut row);
                row.iter_mut().zip(&after).for_each(|(word, after)| *word |= after);
                let gone = effect.deleted.iter().find(|(deleted, _)| *deleted == value);
                self.join(&mut next, gone.map_or(value, |(_, none)| *none), &row);
            }
            moved.iter_mut().zip(&after).for_each(|(word, after)| *word |= after);
            for &value in &effect.after {
                self.join(&mut next, value, &moved);
            }
        }
        self.pack(&next)
    }

    /// Whether a conjunction of facts holds in a state of the belief, as far as its pairs tell: false is certain.
    pub fn may_satisfy(&self, task: &Task, belief: &PairwiseBelief, condition: &[Fact]) -> bool {
        let layout = task.layout();
        let values: Vec<u32> = condition
            .iter()
            .map(|&fact| self.offsets[layout.group(fact)] + layout.value(fact) as u32)
            .collect();
        if values.is_empty() {
            return belief.0[..self.width].iter().any(|word| *word != 0);
        }
        values.iter().all(|value| {
            self.row(belief, *value)
                .is_some_and(|row| values.iter().all(|other| contains(row, *other)))
        })
    }
}
