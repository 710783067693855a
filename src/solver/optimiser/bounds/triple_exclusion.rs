//! Exclusion of three facts: sets of three that no state has together, by h³ (Haslum and Geffner 2000, "Admissible heuristics
//! for optimal planning").
//!
//! As [of two](super::mutual_exclusion), with which it agrees on pairs and says more: a block on one that is in a pile is in
//! that pile, which no two of these facts show.

use crate::solver::ground::thresholds::{FACTS_OF_TRIPLES, WORDS_OF_TRIPLES};
use crate::task::{Operator, Task};

/// Which three facts may occur together.
#[derive(Debug)]
pub(super) struct TripleExclusion {
    facts: usize,
    /// Words of a row.
    width: usize,
    /// By pair of facts, ordered: the facts that may hold with both.
    rows: Vec<u64>,
}

fn contains(row: &[u64], fact: usize) -> bool {
    row[fact / 64] >> (fact % 64) & 1 == 1
}

/// The facts of a set.
fn members(row: &[u64]) -> impl Iterator<Item = usize> {
    row.iter().enumerate().flat_map(|(place, &word)| {
        let rest = std::iter::successors(Some(word), |word| Some(word & word.wrapping_sub(1)));
        let bits = rest.take_while(|word| *word != 0);
        bits.map(move |word| 64 * place + word.trailing_zeros() as usize)
    })
}

impl TripleExclusion {
    /// Of the states that can be reached from some; none where the task is too large for it.
    pub(super) fn new(task: &Task, starts: &[&[u64]]) -> Option<Self> {
        let facts = task.fact_count();
        let width = facts.div_ceil(64);
        let words = (task.operators().len() * facts * width) as u64;
        if facts > FACTS_OF_TRIPLES || words > WORDS_OF_TRIPLES {
            return None;
        }
        let mut triples = Self { facts, width, rows: vec![0; facts * facts * width] };
        for start in starts {
            let held: Vec<usize> = task.facts_of(start).iter().map(|fact| fact.index()).collect();
            let set = triples.set(held.iter().copied());
            for &one in &held {
                for &other in &held {
                    triples.join(one, other, &set);
                }
            }
        }
        while task.operators().iter().fold(false, |new, operator| triples.apply(operator) | new) {}
        Some(triples)
    }

    /// Whether three facts, some of which may be the same, may hold in one state; false is certain.
    pub(super) fn occur_together(&self, one: usize, two: usize, three: usize) -> bool {
        contains(self.row(one, two), three)
    }

    fn set(&self, facts: impl Iterator<Item = usize>) -> Vec<u64> {
        let mut row = vec![0; self.width];
        facts.for_each(|fact| row[fact / 64] |= 1 << (fact % 64));
        row
    }

    fn row(&self, one: usize, two: usize) -> &[u64] {
        &self.rows[(one * self.facts + two) * self.width..][..self.width]
    }

    /// Adds facts that may hold with two, in every order of the three; whether one of them is new.
    fn join(&mut self, one: usize, two: usize, with: &[u64]) -> bool {
        let new: Vec<u64> =
            self.row(one, two).iter().zip(with).map(|(known, more)| more & !known).collect();
        for three in members(&new) {
            for [a, b, c] in [
                [one, two, three],
                [two, one, three],
                [one, three, two],
                [three, one, two],
                [two, three, one],
                [three, two, one],
            ] {
                self.rows[(a * self.facts + b) * self.width + c / 64] |= 1 << (c % 64);
            }
        }
        new.iter().any(|word| *word != 0)
    }

    /// Applies an operator once; whether there are new ones.
    fn apply(&mut self, operator: &Operator) -> bool {
        let numbers = |facts: &[crate::task::Fact]| -> Vec<usize> {
            facts.iter().map(|fact| fact.index()).collect()
        };
        let (asked, add) = (numbers(&operator.preconditions), numbers(&operator.add));
        let (added, deleted) =
            (self.set(add.iter().copied()), self.set(numbers(&operator.delete).into_iter()));
        // What may hold beside the preconditions: everything that ever does where there are none.
        let ever = (0..self.facts).filter(|&fact| contains(self.row(fact, fact), fact));
        let mut beside = self.set(ever);
        for &one in &asked {
            for &two in &asked {
                beside.iter_mut().zip(self.row(one, two)).for_each(|(word, row)| *word &= row);
            }
        }
        if asked.iter().any(|fact| !contains(&beside, *fact)) {
            return false;
        }
        let after = |set: &mut [u64]| {
            for ((word, deleted), added) in set.iter_mut().zip(&deleted).zip(&added) {
                *word = *word & !deleted | added;
            }
        };
        let mut new = false;
        let mut left = beside.clone();
        after(&mut left);
        for &one in &add {
            for &two in &add {
                new |= self.join(one, two, &left);
            }
        }
        for kept in members(&left).filter(|fact| !contains(&added, *fact)) {
            let mut with = beside.clone();
            for &one in &asked {
                with.iter_mut().zip(self.row(one, kept)).for_each(|(word, row)| *word &= row);
            }
            with.iter_mut().zip(self.row(kept, kept)).for_each(|(word, row)| *word &= row);
            after(&mut with);
            for &one in &add {
                new |= self.join(one, kept, &with);
            }
        }
        new
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;
    use crate::domain::generate::Domain;
    use crate::task::StateSpace;
    use std::sync::Arc;

    /// Held against all states of small problems.
    #[test]
    fn no_state_has_three_facts_that_are_excluded() {
        let mut excluded = 0;
        for (domain, seed) in
            [Domain::Blocksworld, Domain::Driverlog, Domain::Gridworld].into_iter().zip(1..)
        {
            let problem = domain.draw(seed).unwrap().document.problem().unwrap();
            let task = problem.task();
            let triples = TripleExclusion::new(task, &[task.initial_state().words()]).unwrap();
            let mut space = StateSpace::new(Arc::clone(task));
            space.intern(task.initial_state());
            let mut next = 0;
            while next < space.len().min(5_000) {
                let state = crate::task::StateId(next as u32);
                let held = task.facts_of(space.words(state));
                for one in &held {
                    for two in &held {
                        for three in &held {
                            let [a, b, c] = [one, two, three].map(|fact| fact.index());
                            assert!(triples.occur_together(a, b, c), "{a} {b} {c}");
                        }
                    }
                }
                space.expand(state);
                next += 1;
            }
            let facts = task.fact_count();
            excluded += (0..facts)
                .flat_map(|a| (0..facts).map(move |b| (a, b)))
                .map(|(a, b)| (0..facts).filter(|&c| !triples.occur_together(a, b, c)).count())
                .sum::<usize>();
        }
        assert!(excluded > 0);
    }
}
