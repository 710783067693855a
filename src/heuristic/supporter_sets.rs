//! The relaxed plans `π` of the set-additive heuristic, as bits.
//!
//! Each operator that supports a settled fact keeps its set, with one bit for each supporter that
//! came before it and its own as the highest. The first set takes one word, the last as many as
//! there are supporters divided by 64: in tasks of a few hundred facts a union is a handful of
//! words.

/// Supporters that keep their sets, at most: 4 MiB of bits. In larger tasks those that come later
/// keep none, and their sets are counted by walking them.
const SETS_KEPT: usize = 8192;

/// An operator without a set.
const NONE: u32 = u32::MAX;

/// The sets of the operators that support settled facts.
#[derive(Debug, Clone)]
pub(super) struct SupporterSets {
    /// For each operator the number of its set.
    numbers: Vec<u32>,
    /// The operator of each set.
    kept: Vec<u32>,
    /// Where each set begins, and where the next one will.
    begins: Vec<u32>,
    words: Vec<u64>,
    /// Room for a union.
    union: Vec<u64>,
}

impl SupporterSets {
    /// No set yet, for so many operators.
    pub(super) fn new(operators: usize) -> Self {
        Self {
            numbers: vec![NONE; operators],
            kept: Vec::new(),
            begins: vec![0],
            words: Vec::new(),
            union: Vec::new(),
        }
    }

    /// Forgets all sets. Linear in their number.
    pub(super) fn clear(&mut self) {
        for &operator in &self.kept {
            self.numbers[operator as usize] = NONE;
        }
        self.kept.clear();
        self.begins.truncate(1);
        self.words.clear();
    }

    /// The words of an operator's set.
    fn range(&self, operator: u32) -> Option<std::ops::Range<usize>> {
        let number = self.numbers[operator as usize] as usize;
        (number != NONE as usize)
            .then(|| self.begins[number] as usize..self.begins[number + 1] as usize)
    }

    /// Keeps the set of an operator: itself and the sets of the supporters of its preconditions.
    pub(super) fn keep(&mut self, operator: u32, supporters: impl Iterator<Item = u32>) {
        let bit = self.kept.len();
        if bit == SETS_KEPT || self.numbers[operator as usize] != NONE {
            return;
        }
        let begin = self.words.len();
        self.words.resize(begin + bit / 64 + 1, 0);
        for supporter in supporters {
            let Some(range) = self.range(supporter) else {
                // What follows on a supporter without a set keeps none either.
                self.words.truncate(begin);
                return;
            };
            let (known, new) = self.words.split_at_mut(begin);
            for (word, other) in new.iter_mut().zip(&known[range]) {
                *word |= other;
            }
        }
        self.words[begin + bit / 64] |= 1 << (bit % 64);
        self.numbers[operator as usize] = bit as u32;
        self.kept.push(operator);
        self.begins.push(self.words.len() as u32);
    }

    /// The size of the union of two sets; none where one of the operators has no set.
    pub(super) fn size_of_two(&self, one: u32, other: u32) -> Option<u32> {
        let one = &self.words[self.range(one)?];
        let other = &self.words[self.range(other)?];
        let (short, long) = if one.len() < other.len() { (one, other) } else { (other, one) };
        let (shared, rest) = long.split_at(short.len());
        let shared = short.iter().zip(shared).map(|(one, other)| (one | other).count_ones());
        Some(shared.sum::<u32>() + rest.iter().map(|word| word.count_ones()).sum::<u32>())
    }

    /// The size of the union of several sets; none where one of the operators has no set.
    pub(super) fn size_of_all(&mut self, operators: impl Iterator<Item = u32>) -> Option<u32> {
        let mut union = std::mem::take(&mut self.union);
        union.clear();
        let mut all = true;
        for operator in operators {
            let Some(range) = self.range(operator) else {
                all = false;
                break;
            };
            let set = &self.words[range];
            if union.len() < set.len() {
                union.resize(set.len(), 0);
            }
            for (word, other) in union.iter_mut().zip(set) {
                *word |= other;
            }
        }
        let size = union.iter().map(|word| word.count_ones()).sum();
        self.union = union;
        all.then_some(size)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chain_longer_than_the_sets_kept() {
        let count = SETS_KEPT as u32 + 2;
        let mut sets = SupporterSets::new(count as usize);
        for operator in 0..count {
            sets.keep(operator, operator.checked_sub(2).into_iter());
        }
        // Two chains side by side, the even numbers and the odd ones.
        assert_eq!(sets.size_of_two(0, 1), Some(2));
        assert_eq!(sets.size_of_two(130, 7), Some(66 + 4));
        assert_eq!(sets.size_of_two(8, 130), Some(66));
        assert_eq!(sets.size_of_all([5, 130, 129].into_iter()), Some(66 + 65));
        assert_eq!(sets.size_of_all(std::iter::empty()), Some(0));
        assert_eq!(sets.size_of_two(0, SETS_KEPT as u32), None);
        assert_eq!(sets.size_of_all([SETS_KEPT as u32].into_iter()), None);
        sets.clear();
        assert_eq!(sets.size_of_two(0, 1), None);
        sets.keep(1, std::iter::empty());
        assert_eq!(sets.size_of_two(1, 1), Some(1));
    }
}
