//! A linear program with integer variables, as data.

use std::fmt;

use crate::limits::{LimitReached, Limits};

/// A variable of a model, by its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Variable(pub(super) u32);

impl Variable {
    /// Its number.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A short name: a letter for the kind of variable or row, and numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Name {
    letter: &'static str,
    numbers: [u32; 4],
    count: u8,
}

impl Name {
    /// A name of up to four numbers.
    pub fn new<const N: usize>(letter: &'static str, numbers: [usize; N]) -> Self {
        let mut all = [0; 4];
        for (to, from) in all.iter_mut().zip(numbers) {
            *to = from as u32;
        }
        Self { letter, numbers: all, count: N.min(4) as u8 }
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.letter)?;
        for number in &self.numbers[..usize::from(self.count)] {
            write!(f, "_{number}")?;
        }
        Ok(())
    }
}

/// Which values a variable takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// 0 or 1.
    Binary,
    /// Anything between its bounds.
    Continuous,
}

/// What a model knows of a variable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VariableData {
    /// Its name.
    pub name: Name,
    /// Which values it takes.
    pub kind: Kind,
    /// Its least value.
    pub lower: f64,
    /// Its greatest value.
    pub upper: f64,
    /// What one unit of it adds to the objective.
    pub objective: f64,
}

/// How the left side of a row compares with the right side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Comparison {
    /// At most.
    AtMost,
    /// Equal.
    Equal,
    /// At least.
    AtLeast,
}

/// A linear constraint.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Its name.
    pub name: Name,
    /// Variables and coefficients, each variable once.
    pub terms: Vec<(Variable, f64)>,
    /// The comparison.
    pub comparison: Comparison,
    /// The right side.
    pub right: f64,
}

/// A model to maximise.
#[derive(Debug, Clone, Default)]
pub struct Model {
    variables: Vec<VariableData>,
    rows: Vec<Row>,
    nonzeros: u64,
    notes: Vec<String>,
}

impl Model {
    /// All variables.
    pub fn variables(&self) -> &[VariableData] {
        &self.variables
    }

    /// All rows.
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// Explanations that go into a printed model.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    pub(super) fn note(&mut self, text: impl Into<String>) {
        self.notes.push(text.into());
    }

    pub(super) fn add(&mut self, name: Name, kind: Kind) -> Variable {
        self.variables.push(VariableData { name, kind, lower: 0.0, upper: 1.0, objective: 0.0 });
        Variable(self.variables.len() as u32 - 1)
    }

    pub(super) fn fix(&mut self, variable: Variable, value: f64) {
        self.bound(variable, value, value);
    }

    pub(super) fn bound(&mut self, variable: Variable, lower: f64, upper: f64) {
        let data = &mut self.variables[variable.index()];
        (data.lower, data.upper) = (lower, upper);
    }

    pub(super) fn maximise(&mut self, variable: Variable, gain: f64) {
        self.variables[variable.index()].objective += gain;
    }

    /// Adds a row; terms of one variable are added up.
    pub(super) fn row(
        &mut self,
        name: Name,
        mut terms: Vec<(Variable, f64)>,
        comparison: Comparison,
        right: f64,
    ) {
        terms.sort_unstable_by_key(|(variable, _)| *variable);
        terms.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            if same {
                kept.1 += next.1;
            }
            same
        });
        terms.retain(|(_, coefficient)| *coefficient != 0.0);
        self.nonzeros += terms.len() as u64;
        self.rows.push(Row { name, terms, comparison, right });
    }

    pub(super) fn check(&self, limits: &Limits) -> Result<(), LimitReached> {
        if self.nonzeros > limits.nonzeros {
            return Err(LimitReached::Model { limit: limits.nonzeros });
        }
        Ok(())
    }
}
