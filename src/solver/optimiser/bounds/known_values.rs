//! Known values: groups of exclusive facts whose value an observer always knows.

use rustc_hash::FxHashMap;

use super::invariants::Facts;
use crate::solver::optimiser::thresholds::CONTEXTS_OF_INVARIANTS;
use crate::task::Fact;

impl Facts<'_> {
    /// The groups whose values an observer always knows, since it knows them at first and each symbol
    /// determines the next value from the present one; in every combination of values.
    pub(super) fn contexts(
        &self,
        symbols: &[Vec<usize>],
        believed: &[Vec<Fact>],
    ) -> Vec<Vec<(usize, usize)>> {
        let layout = self.task.layout();
        let begins = |group: usize| {
            let value = |state: &Vec<Fact>| {
                let fact = state.iter().find(|fact| layout.group(**fact) == group);
                fact.map_or(0, |fact| layout.value(*fact))
            };
            let mut values = believed.iter().map(value);
            let first = values.next();
            values.all(|value| Some(value) == first)
        };
        let mut contexts: Vec<Vec<(usize, usize)>> = vec![Vec::new()];
        for (group, values) in self.values.iter().enumerate() {
            // A group that no operator asks for makes no difference to which of them apply.
            let asked = self.effects.iter().any(|e| e.asks.iter().any(|ask| ask.0 == group));
            if values.len() * contexts.len() > CONTEXTS_OF_INVARIANTS
                || !asked
                || !begins(group)
                || !values.iter().all(|value| self.is_determined(group, *value, symbols))
            {
                continue;
            }
            let with = |context: &Vec<(usize, usize)>| {
                let context = context.clone();
                values.iter().map(move |value| [context.clone(), vec![(group, *value)]].concat())
            };
            contexts = contexts.iter().flat_map(with).collect();
        }
        contexts
    }

    /// Whether each symbol determines the next value of a group from one value.
    fn is_determined(&self, group: usize, value: usize, symbols: &[Vec<usize>]) -> bool {
        let mut next: FxHashMap<usize, usize> = FxHashMap::default();
        for (effect, symbols) in self.effects.iter().zip(symbols) {
            if effect.asks.iter().any(|ask| ask.0 == group && ask.1 != value) {
                continue;
            }
            let mut to = value;
            for change in effect.changes.iter().filter(|change| change.group == group) {
                match change.from {
                    // What a fact that is deleted unasked leaves may be one thing or the other.
                    Some(from) if change.optional && from == value => return false,
                    Some(from) if from != value => {}
                    _ => to = change.to,
                }
            }
            for symbol in symbols {
                if *next.entry(*symbol).or_insert(to) != to {
                    return false;
                }
            }
        }
        true
    }
}
