//! How states are shown: as their document names them where it does, as facts elsewhere.

use std::sync::Arc;

use serde::{Serialize, Serializer};

use crate::task::{Fact, Task};

/// A state as people and other programs read it.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(untagged)]
pub enum StateLabel {
    /// Column and row of a grid.
    Cell(u32, u32),
    /// A name.
    Name(Arc<str>),
    /// The facts that hold.
    Facts(Vec<Arc<str>>),
    /// What has a value, with it: an object in JSON.
    Parts(#[serde(serialize_with = "as_object")] Vec<(&'static str, Value)>),
}

/// The value of a part of a state.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(untagged)]
pub enum Value {
    /// Column and row of a grid.
    Cell(u32, u32),
    /// A number.
    Number(u32),
    /// A name.
    Name(&'static str),
}

fn as_object<S: Serializer>(
    parts: &[(&'static str, Value)],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_map(parts.iter().map(|(key, value)| (key, value)))
}

/// A cell in words, as the page says it as well; with `#` as documents have it.
fn write_cell(f: &mut std::fmt::Formatter<'_>, column: u32, row: u32) -> std::fmt::Result {
    if f.alternate() {
        write!(f, "[{column}, {row}]")
    } else {
        write!(f, "column {column}, row {row}")
    }
}

impl std::fmt::Display for Value {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match *self {
            Self::Cell(column, row) => write_cell(f, column, row),
            Self::Number(number) => write!(f, "{number}"),
            Self::Name(name) => f.write_str(name),
        }
    }
}

impl std::fmt::Display for StateLabel {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Cell(column, row) => write_cell(f, *column, *row),
            Self::Name(name) => f.write_str(name),
            Self::Facts(facts) => write!(f, "{{{}}}", facts.join(", ")),
            Self::Parts(parts) => {
                // A cell in words has a comma itself, and semicolons stand between states.
                let between = if f.alternate() { ", " } else { " · " };
                f.write_str("{")?;
                for (place, (key, value)) in parts.iter().enumerate() {
                    write!(f, "{}{key} ", if place == 0 { "" } else { between })?;
                    value.fmt(f)?;
                }
                f.write_str("}")
            }
        }
    }
}

impl StateLabel {
    /// States one after another: names with commas between them, what has commas itself with semicolons.
    ///
    /// ```
    /// use mo_copp::problem::StateLabel;
    /// let cells = [StateLabel::Cell(1, 0), StateLabel::Cell(3, 2)];
    /// assert_eq!(StateLabel::list(&cells), "column 1, row 0; column 3, row 2");
    /// ```
    pub fn list<'l>(labels: impl IntoIterator<Item = &'l Self>) -> String {
        let mut text = String::new();
        for label in labels {
            if !text.is_empty() {
                text.push_str(label.separator());
            }
            text.push_str(&label.to_string());
        }
        text
    }

    /// What stands between this and another one.
    pub(crate) fn separator(&self) -> &'static str {
        if matches!(self, Self::Name(_)) { ", " } else { "; " }
    }
}

/// A part of a state that has a value: where something is, how full it is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Part {
    /// What has the value.
    pub key: &'static str,
    /// The value that each fact means. The first one that holds counts.
    pub values: Vec<(Fact, Value)>,
}

/// How the states of a problem are labelled.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum StateNaming {
    /// The first exclusive group of facts stands for the cells of a grid, row by row.
    Cells {
        /// Cells in a row.
        width: u32,
    },
    /// The first exclusive group of facts holds one fact named for each state.
    Names,
    /// All facts that hold.
    Facts,
    /// Those of the first facts that hold; what follows says nothing new, such as that another
    /// fact does not hold.
    FirstFacts {
        /// How many there are.
        count: usize,
    },
    /// The parts of a state by their names.
    Parts(Vec<Part>),
}

impl StateNaming {
    /// The label of a packed state. Constant for cells and names, linear in the facts elsewhere.
    pub(crate) fn label(&self, task: &Task, words: &[u64]) -> StateLabel {
        let names = |fact| task.shared_fact_name(fact);
        let first = || task.layout().group_value(words, 0).saturating_sub(1);
        match self {
            Self::Facts => StateLabel::Facts(task.facts_of(words).into_iter().map(names).collect()),
            Self::FirstFacts { count } => {
                let shown = task.facts_of(words).into_iter().filter(|fact| fact.index() < *count);
                StateLabel::Facts(shown.map(names).collect())
            }
            Self::Names => StateLabel::Name(names(Fact::new(first()))),
            Self::Cells { width } => {
                let cell = first() as u32;
                StateLabel::Cell(cell % width, cell / width)
            }
            Self::Parts(parts) => {
                let of_part = |part: &Part| {
                    let holds = |(fact, _): &&(Fact, Value)| task.layout().holds(words, *fact);
                    part.values.iter().find(holds).map(|&(_, value)| (part.key, value))
                };
                StateLabel::Parts(parts.iter().filter_map(of_part).collect())
            }
        }
    }
}
