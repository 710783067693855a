//! Mutual exclusion of facts: pairs of facts that no state has together, by h² (Haslum and Geffner 2000, "Admissible heuristics
//! for optimal planning").
//!
//! The pairs that occur together in the states at the beginning are closed under the operators, each looked at with all
//! pairs of its preconditions and what it leaves as it is. A pair that is not met occurs in no state.

use crate::task::Task;

/// Which facts may occur together.
#[derive(Debug)]
pub(super) struct MutualExclusion {
    /// Words of a row.
    width: usize,
    /// By fact: the facts that may hold with it. That of a fact that never holds is empty.
    rows: Vec<u64>,
}

fn contains(row: &[u64], fact: usize) -> bool {
    row[fact / 64] >> (fact % 64) & 1 == 1
}

fn set(row: &mut [u64], fact: usize, to: bool) {
    let bit = 1 << (fact % 64);
    row[fact / 64] = if to { row[fact / 64] | bit } else { row[fact / 64] & !bit };
}

impl MutualExclusion {
    /// Of the states that can be reached from some. Passes over all operators, each linear in their facts times all facts,
    /// until none has a new pair.
    pub(super) fn new(task: &Task, starts: &[&[u64]]) -> Self {
        let facts = task.fact_count();
        let width = facts.div_ceil(64);
        let mut pairs = Self { width, rows: vec![0; facts * width] };
        for words in starts {
            let held: Vec<usize> = task.facts_of(words).iter().map(|fact| fact.index()).collect();
            let mut row = vec![0; width];
            for &fact in &held {
                set(&mut row, fact, true);
            }
            for &fact in &held {
                pairs.join(fact, &row);
            }
        }
        while pairs.pass(task) {}
        pairs
    }

    /// Whether two facts may hold in one state; false is certain.
    pub(super) fn occur_together(&self, one: usize, other: usize) -> bool {
        contains(self.row(one), other)
    }

    fn row(&self, fact: usize) -> &[u64] {
        &self.rows[fact * self.width..][..self.width]
    }

    /// Adds facts that may hold with one; whether one of them is new.
    fn join(&mut self, fact: usize, with: &[u64]) -> bool {
        let row = &mut self.rows[fact * self.width..][..self.width];
        let mut new = false;
        for (word, more) in row.iter_mut().zip(with) {
            new |= more & !*word != 0;
            *word |= more;
        }
        new
    }

    /// Applies each operator once; whether there is a new pair.
    fn pass(&mut self, task: &Task) -> bool {
        let mut new = false;
        for operator in task.operators() {
            let before = &operator.preconditions;
            // What may hold beside the preconditions: everything that ever does where there are none.
            let mut beside = vec![0_u64; self.width];
            if before.is_empty() {
                for fact in (0..task.fact_count()).filter(|&fact| contains(self.row(fact), fact)) {
                    set(&mut beside, fact, true);
                }
            } else {
                beside.fill(u64::MAX);
                for fact in before {
                    let row = self.row(fact.index());
                    for (word, row) in beside.iter_mut().zip(row) {
                        *word &= row;
                    }
                }
            }
            if before.iter().any(|fact| !contains(&beside, fact.index())) {
                continue;
            }
            for fact in &operator.delete {
                set(&mut beside, fact.index(), false);
            }
            for fact in &operator.add {
                set(&mut beside, fact.index(), true);
            }
            for fact in &operator.add {
                new |= self.join(fact.index(), &beside);
            }
            // The other way round.
            for kept in 0..task.fact_count() {
                if contains(&beside, kept) {
                    for fact in &operator.add {
                        let row = &mut self.rows[kept * self.width..][..self.width];
                        set(row, fact.index(), true);
                    }
                }
            }
        }
        new
    }
}
