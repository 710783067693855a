//! Known values: what an observer always knows of groups of exclusive facts.
//!
//! The values of a group fall into blocks, the finest such that the first values are in one block and equal symbols lead from
//! one block to one block: observable classes of the group's own graph. The observer always knows the block. Where each has one
//! value that is the place of the only airplane; where roads go between two sets of places by turns, the set.

use rustc_hash::FxHashMap;

use super::invariants::{Effect, Facts};
use crate::solver::ground::thresholds::CONTEXTS_OF_INVARIANTS;
use crate::task::Fact;

/// A group and the number of a block of its values.
pub(super) type KnownBlock = (usize, usize);

/// What an observer always knows of each group.
#[derive(Debug)]
pub(super) struct KnownValues {
    /// By group and value: the number of the block.
    blocks: Vec<Vec<usize>>,
}

/// Sets of values, merged as they are found to be confused.
struct Blocks(Vec<usize>);

impl Blocks {
    fn find(&self, mut value: usize) -> usize {
        while self.0[value] != value {
            value = self.0[value];
        }
        value
    }

    /// Whether the two were apart. The least value stands for a block.
    fn merge(&mut self, one: usize, other: usize) -> bool {
        let (one, other) = (self.find(one), self.find(other));
        self.0[one.max(other)] = one.min(other);
        one != other
    }
}

/// The value of a group after an operator, where it applies at a value before.
fn next(effect: &Effect, group: usize, value: usize) -> Option<usize> {
    if effect.asks.iter().any(|ask| ask.0 == group && ask.1 != value) {
        return None;
    }
    let changes = effect.changes.iter().filter(|change| change.group == group);
    let mut applied = changes.filter(|change| change.from.is_none_or(|from| from == value));
    Some(applied.next_back().map_or(value, |change| change.to))
}

impl KnownValues {
    /// With the symbols of each operator and the states that the observer holds possible at first. Passes over all operators
    /// and values until none confuses more.
    pub(super) fn new(facts: &Facts<'_>, symbols: &[Vec<usize>], believed: &[Vec<Fact>]) -> Self {
        let layout = facts.task.layout();
        let of_group = |group: usize| {
            let mut blocks = Blocks((0..=layout.facts_of_group(group).len()).collect());
            let value = |state: &Vec<Fact>| {
                let fact = state.iter().find(|fact| layout.group(**fact) == group);
                fact.map_or(0, |fact| layout.value(*fact))
            };
            if let Some((first, others)) = believed.split_first() {
                for other in others {
                    blocks.merge(value(first), value(other));
                }
            }
            while blocks.0.len() > 1 && facts.confuse(group, symbols, &mut blocks) {}
            (0..blocks.0.len()).map(|value| blocks.find(value)).collect()
        };
        Self { blocks: (0..facts.values.len()).map(of_group).collect() }
    }

    /// The block of a value.
    pub(super) fn block(&self, group: usize, value: usize) -> usize {
        self.blocks[group][value]
    }

    /// Whether an operator applies nowhere in one of some blocks.
    pub(super) fn excludes(&self, known: &[KnownBlock], effect: &Effect) -> bool {
        effect.asks.iter().any(|&(group, value)| {
            known.iter().any(|known| known.0 == group && known.1 != self.block(group, value))
        })
    }

    /// Every combination of known blocks of groups that operators ask for.
    pub(super) fn contexts(&self, facts: &Facts<'_>) -> Vec<Vec<KnownBlock>> {
        let mut contexts: Vec<Vec<KnownBlock>> = vec![Vec::new()];
        for (group, values) in facts.values.iter().enumerate() {
            // A group that no operator asks for makes no difference to which of them apply.
            let asked = facts.effects.iter().any(|e| e.asks.iter().any(|ask| ask.0 == group));
            let mut blocks: Vec<usize> =
                values.iter().map(|value| self.block(group, *value)).collect();
            blocks.sort_unstable();
            blocks.dedup();
            if !asked || blocks.len() < 2 || blocks.len() * contexts.len() > CONTEXTS_OF_INVARIANTS
            {
                continue;
            }
            let with = |context: &Vec<KnownBlock>| {
                let context = context.clone();
                blocks.iter().map(move |block| [context.clone(), vec![(group, *block)]].concat())
            };
            contexts = contexts.iter().flat_map(with).collect();
        }
        contexts
    }
}

impl Facts<'_> {
    /// Merges the values to which equal symbols lead from one block; whether there were some.
    fn confuse(&self, group: usize, symbols: &[Vec<usize>], blocks: &mut Blocks) -> bool {
        let mut merged = false;
        let mut after: FxHashMap<(usize, usize), usize> = FxHashMap::default();
        for (effect, symbols) in self.effects.iter().zip(symbols) {
            for &value in &self.values[group] {
                let Some(next) = next(effect, group, value) else { continue };
                for &symbol in symbols {
                    let first = *after.entry((blocks.find(value), symbol)).or_insert(next);
                    merged |= blocks.merge(first, next);
                }
            }
        }
        merged
    }
}
