//! Sensors: what an observer sees of a step.
//!
//! A sensor model `O_i: Op × S → Ω_i` (Definition 1) maps an operator and the state it results in
//! to one symbol, deterministically. For each operator a sensor holds a list of cases over facts of
//! the resulting state (a camera sees some cells exactly) and a symbol for all other states.

use rustc_hash::FxHashMap;
use thiserror::Error;

use crate::task::{Fact, OperatorId, Task};

/// An observation symbol of one sensor, by its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Symbol(pub(crate) u32);

impl Symbol {
    /// Its number, from 0.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// What a sensor reads on one operator.
#[derive(Debug, Clone)]
struct Reading {
    cases: Vec<(Box<[Fact]>, Symbol)>,
    otherwise: Symbol,
}

/// A deterministic sensor: one symbol for each (operator, resulting state).
///
/// ```
/// use mo_copp::{sensor::SensorBuilder, task::TaskBuilder};
/// let mut task = TaskBuilder::default();
/// let (here, there) = (task.fact("here"), task.fact("there"));
/// task.operator("go", &[here], &[there], &[here]);
/// let task = task.build(&[here], &[there])?;
/// let mut sensor = SensorBuilder::new(&task);
/// let go = mo_copp::task::OperatorId::of(&task, 0).unwrap();
/// sensor.when(go, &[there], "seen there");
/// sensor.always(go, "a noise");
/// let sensor = sensor.build(&task)?;
/// let after = task.state(&[there]).unwrap();
/// assert_eq!(sensor.name(sensor.read(&task, go, after.words())), "seen there");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Sensor {
    symbols: Vec<String>,
    readings: Vec<Reading>,
}

impl Sensor {
    /// How many symbols the sensor can give.
    pub fn symbol_count(&self) -> usize {
        self.symbols.len()
    }

    /// The name of a symbol.
    pub fn name(&self, symbol: Symbol) -> &str {
        &self.symbols[symbol.index()]
    }

    /// The symbols that an operator may give, one for each case.
    pub(crate) fn symbols_of(&self, operator: OperatorId) -> impl Iterator<Item = Symbol> + '_ {
        let reading = &self.readings[operator.index()];
        reading.cases.iter().map(|(_, symbol)| *symbol).chain([reading.otherwise])
    }

    /// The symbol for an operator, whatever it results in; none where that matters.
    pub fn fixed(&self, operator: OperatorId) -> Option<Symbol> {
        let reading = &self.readings[operator.index()];
        let same = reading.cases.iter().all(|(_, symbol)| *symbol == reading.otherwise);
        same.then_some(reading.otherwise)
    }

    /// The cases over facts of the resulting state that a sensor looks at, the first that fits counts.
    pub(crate) fn cases(&self, operator: OperatorId) -> impl Iterator<Item = (&[Fact], Symbol)> {
        let cases = &self.readings[operator.index()].cases;
        cases.iter().map(|(facts, symbol)| (&**facts, *symbol))
    }

    /// The symbol where no case fits.
    pub(crate) fn otherwise(&self, operator: OperatorId) -> Symbol {
        self.readings[operator.index()].otherwise
    }

    /// The symbol for an operator that has resulted in the packed state `after`.
    pub fn read(&self, task: &Task, operator: OperatorId, after: &[u64]) -> Symbol {
        let reading = &self.readings[operator.index()];
        let case = reading.cases.iter().find(|(facts, _)| task.satisfies(after, facts));
        case.map_or(reading.otherwise, |&(_, symbol)| symbol)
    }
}

/// An operator for which a sensor has no symbol.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("the sensor gives no symbol for action {action}")]
pub struct MissingSymbol {
    /// The action of the operator.
    pub action: String,
}

/// Collects readings; of several that fit, the first one given counts.
#[derive(Debug, Clone)]
pub struct SensorBuilder {
    symbols: Vec<String>,
    numbers: FxHashMap<String, Symbol>,
    cases: Vec<Vec<(Box<[Fact]>, Symbol)>>,
    otherwise: Vec<Option<Symbol>>,
}

impl SensorBuilder {
    /// A sensor without any reading yet.
    pub fn new(task: &Task) -> Self {
        let count = task.operators().len();
        Self {
            symbols: Vec::new(),
            numbers: FxHashMap::default(),
            cases: vec![Vec::new(); count],
            otherwise: vec![None; count],
        }
    }

    /// Reads `symbol` on an operator where these facts hold in the resulting state.
    pub fn when(&mut self, operator: OperatorId, facts: &[Fact], symbol: &str) {
        let symbol = self.symbol(symbol);
        if self.otherwise[operator.index()].is_none() {
            self.cases[operator.index()].push((facts.into(), symbol));
        }
    }

    /// Reads `symbol` on an operator where no case before this one fits.
    pub fn always(&mut self, operator: OperatorId, symbol: &str) {
        let symbol = self.symbol(symbol);
        self.otherwise[operator.index()].get_or_insert(symbol);
    }

    fn symbol(&mut self, name: &str) -> Symbol {
        if let Some(&symbol) = self.numbers.get(name) {
            return symbol;
        }
        let symbol = Symbol(self.symbols.len() as u32);
        self.symbols.push(name.to_owned());
        self.numbers.insert(name.to_owned(), symbol);
        symbol
    }

    /// The finished sensor.
    ///
    /// # Errors
    ///
    /// [`MissingSymbol`] names the first operator that has no symbol for every resulting state.
    pub fn build(self, task: &Task) -> Result<Sensor, MissingSymbol> {
        let mut readings = Vec::with_capacity(self.cases.len());
        for (index, (cases, otherwise)) in self.cases.into_iter().zip(self.otherwise).enumerate() {
            let Some(otherwise) = otherwise else {
                let action = task.operators()[index].action;
                return Err(MissingSymbol { action: task.action_name(action).to_owned() });
            };
            readings.push(Reading { cases, otherwise });
        }
        Ok(Sensor { symbols: self.symbols, readings })
    }
}
