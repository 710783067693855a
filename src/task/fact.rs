//! Facts, and how a set of them is packed into machine words.
//!
//! A fact takes one bit. Facts that exclude each other (the cells an agent can stand in) share one
//! field wide enough for their number, as finite-domain variables do (Helmert 2009,
//! doi:10.1016/j.artint.2008.10.013), so that a state of a large grid is still one word.

use super::state::State;

/// A fact of a task, by its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Fact(u32);

impl Fact {
    /// The fact of this number. A task has fewer than 2³² facts.
    pub(crate) fn new(index: usize) -> Self {
        Self(index as u32)
    }

    /// Its number.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// Where a fact lives: it holds when the bits under `mask` of a word equal `value`.
#[derive(Debug, Clone, Copy)]
struct Slot {
    word: u32,
    group: u32,
    mask: u64,
    value: u64,
}

/// A field of a state: the word, the first bit, the mask after shifting.
#[derive(Debug, Clone, Copy)]
struct Field {
    word: u32,
    shift: u32,
    mask: u64,
}

/// The packing of a task's facts. A *group* is a set of facts of which at most one holds.
#[derive(Debug, Clone)]
pub struct Layout {
    slots: Vec<Slot>,
    fields: Vec<Field>,
    /// The facts of each group, in the order of their values.
    groups: Vec<Vec<Fact>>,
    words: usize,
}

impl Layout {
    /// Packs `fact_count` facts. Facts in none of the `groups` become groups of their own.
    pub(crate) fn new(fact_count: usize, groups: &[Vec<Fact>]) -> Self {
        let mut owner = vec![usize::MAX; fact_count];
        let mut all: Vec<Vec<Fact>> = groups.to_vec();
        for (number, group) in groups.iter().enumerate() {
            for fact in group {
                owner[fact.index()] = number;
            }
        }
        for (index, owner) in owner.iter().enumerate() {
            if *owner == usize::MAX {
                all.push(vec![Fact::new(index)]);
            }
        }
        let nowhere = Slot { word: 0, group: 0, mask: 0, value: 1 };
        let mut slots = vec![nowhere; fact_count];
        let mut fields = Vec::with_capacity(all.len());
        let (mut word, mut used) = (0_u32, 0_u32);
        for (number, group) in all.iter().enumerate() {
            // One value more than facts: "none of them".
            let bits = (usize::BITS - group.len().leading_zeros()).max(1);
            if used + bits > u64::BITS {
                word += 1;
                used = 0;
            }
            let mask = (1_u64 << bits) - 1;
            fields.push(Field { word, shift: used, mask });
            for (value, fact) in group.iter().enumerate() {
                slots[fact.index()] = Slot {
                    word,
                    group: number as u32,
                    mask: mask << used,
                    value: (value as u64 + 1) << used,
                };
            }
            used += bits;
        }
        Self { slots, fields, groups: all, words: word as usize + 1 }
    }

    /// How many words a state has.
    pub fn words(&self) -> usize {
        self.words
    }

    /// How many groups there are, the single facts included.
    pub fn group_count(&self) -> usize {
        self.fields.len()
    }

    /// How many facts a group has. Its values go from 0, for none of them, to this number.
    pub(crate) fn group_size(&self, group: usize) -> usize {
        self.groups[group].len()
    }

    /// The state in which each group has this value.
    pub(crate) fn state_of_values(&self, values: &[u32]) -> State {
        let mut words = vec![0; self.words];
        for (group, &value) in values.iter().enumerate() {
            let field = self.fields[group];
            words[field.word as usize] |= u64::from(value) << field.shift;
        }
        State::from_words(words)
    }

    /// The group of a fact.
    pub fn group(&self, fact: Fact) -> usize {
        self.slots[fact.index()].group as usize
    }

    /// The facts of a group, in the order of their values.
    pub(crate) fn facts_of_group(&self, group: usize) -> &[Fact] {
        &self.groups[group]
    }

    /// The value a fact stands for in its group, from 1.
    pub(crate) fn value(&self, fact: Fact) -> usize {
        let slot = self.slots[fact.index()];
        (slot.value >> self.fields[slot.group as usize].shift) as usize
    }

    /// The value of a group in a state: 0 when none of its facts holds.
    pub(crate) fn group_value(&self, words: &[u64], group: usize) -> usize {
        let field = self.fields[group];
        ((words[field.word as usize] >> field.shift) & field.mask) as usize
    }

    /// Whether a fact holds in a state.
    pub fn holds(&self, words: &[u64], fact: Fact) -> bool {
        let slot = self.slots[fact.index()];
        words[slot.word as usize] & slot.mask == slot.value
    }

    /// The facts that hold in a state, in order. Linear in the groups.
    pub(crate) fn holding(&self, words: &[u64]) -> Vec<Fact> {
        let value = |group| self.group_value(words, group).checked_sub(1);
        let of_group = |(group, facts): (usize, &Vec<Fact>)| value(group).map(|v| facts[v]);
        let mut holding: Vec<Fact> = self.groups.iter().enumerate().filter_map(of_group).collect();
        holding.sort_unstable();
        holding
    }

    /// Makes a fact hold, in place of any other of its group.
    pub(crate) fn insert(&self, words: &mut [u64], fact: Fact) {
        let slot = self.slots[fact.index()];
        let word = &mut words[slot.word as usize];
        *word = *word & !slot.mask | slot.value;
    }

    /// Makes a fact not hold.
    pub(crate) fn remove(&self, words: &mut [u64], fact: Fact) {
        if self.holds(words, fact) {
            words[self.slots[fact.index()].word as usize] &= !self.slots[fact.index()].mask;
        }
    }

    /// Packs a set of facts; two that exclude each other come back as the error.
    pub(crate) fn pack(&self, facts: &[Fact]) -> Result<State, (Fact, Fact)> {
        let mut words = vec![0; self.words];
        for (position, &fact) in facts.iter().enumerate() {
            let group = self.group(fact);
            if self.group_value(&words, group) != 0 && !self.holds(&words, fact) {
                let other = facts[..position].iter().find(|other| self.group(**other) == group);
                return Err((*other.unwrap_or(&fact), fact));
            }
            self.insert(&mut words, fact);
        }
        Ok(State::from_words(words))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_group_of_three_takes_two_bits_and_a_single_fact_one() {
        let facts: Vec<Fact> = (0..4).map(Fact::new).collect();
        let layout = Layout::new(4, &[facts[..3].to_vec()]);
        assert_eq!((layout.words(), layout.group_count()), (1, 2));
        let state = layout.pack(&[facts[2], facts[3]]).unwrap();
        assert_eq!(state.words(), &[0b111]);
        assert!(layout.holds(state.words(), facts[2]) && !layout.holds(state.words(), facts[0]));
        assert_eq!(layout.pack(&[facts[0], facts[1]]), Err((facts[0], facts[1])));
    }

    #[test]
    fn fields_do_not_straddle_words() {
        let facts: Vec<Fact> = (0..200).map(Fact::new).collect();
        let layout = Layout::new(200, &[]);
        assert_eq!(layout.words(), 4);
        for &fact in &facts {
            let mut words = vec![0; 4];
            layout.insert(&mut words, fact);
            assert_eq!(words.iter().map(|word| word.count_ones()).sum::<u32>(), 1);
            layout.remove(&mut words, fact);
            assert_eq!(words, vec![0; 4]);
        }
    }

    #[test]
    fn removing_another_fact_of_the_group_changes_nothing() {
        let facts: Vec<Fact> = (0..2).map(Fact::new).collect();
        let layout = Layout::new(2, std::slice::from_ref(&facts));
        let mut words = vec![0];
        layout.insert(&mut words, facts[0]);
        layout.remove(&mut words, facts[1]);
        assert!(layout.holds(&words, facts[0]));
    }
}
