//! Combinations of symbols: what all observers see of one transition, as one number.

use rustc_hash::FxHashMap;

use super::Problem;
use crate::belief::diagram::SymbolRelations;
use crate::sensor::{Sensor, Symbol};

/// Columns of the dense profile memory, at most; more combinations of symbols are numbered as they
/// are met.
const DIRECT_COMBINATIONS: usize = 64;

/// Numbers of combinations of symbols, one of each observer.
#[derive(Debug, Clone)]
pub(super) struct CombinationNumbers {
    /// How many symbols each observer has, where a number can be worked out from the symbols.
    direct: Option<Vec<u32>>,
    /// Else those met so far, and the numbers of them.
    met: Vec<Vec<u32>>,
    numbers: FxHashMap<Vec<u32>, u32>,
}

impl CombinationNumbers {
    /// For observers with these numbers of symbols, `all` combinations together.
    pub(super) fn new(all: usize, symbols: impl Iterator<Item = usize>) -> Self {
        let counts = || symbols.map(|count| count as u32).collect();
        Self {
            direct: (all <= DIRECT_COMBINATIONS).then(counts),
            met: Vec::new(),
            numbers: FxHashMap::default(),
        }
    }

    /// The number of a combination.
    pub(super) fn number(&mut self, symbols: &[u32]) -> u32 {
        if let Some(counts) = &self.direct {
            return symbols
                .iter()
                .zip(counts)
                .fold(0, |number, (symbol, count)| number * count + symbol);
        }
        if let Some(&number) = self.numbers.get(symbols) {
            return number;
        }
        let number = self.met.len() as u32;
        self.met.push(symbols.to_vec());
        self.numbers.insert(symbols.to_vec(), number);
        number
    }

    /// The symbol of one observer in a combination.
    pub(super) fn symbol(&self, number: u32, observer: usize) -> Symbol {
        let Some(counts) = &self.direct else {
            return Symbol(self.met[number as usize][observer]);
        };
        let behind: u32 = counts[observer + 1..].iter().product();
        Symbol(number / behind % counts[observer])
    }

    /// The operators behind each combination.
    pub(super) fn relations(&mut self, problem: &Problem) -> SymbolRelations {
        let sensors: Vec<&Sensor> = problem.observers().iter().map(|o| &*o.sensor).collect();
        let mut symbols = Vec::new();
        SymbolRelations::joint(problem.task(), &sensors, |seen| {
            symbols.clear();
            symbols.extend(seen.iter().map(|symbol| symbol.0));
            self.number(&symbols)
        })
    }
}
