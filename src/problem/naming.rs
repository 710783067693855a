//! How states are shown: as their document names them where it does, as facts elsewhere.

use serde::Serialize;

use crate::task::{Fact, Task};

/// A state as people and other programs read it.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(untagged)]
pub enum StateLabel {
    /// Column and row of a grid.
    Cell(u32, u32),
    /// A name.
    Name(String),
    /// The facts that hold.
    Facts(Vec<String>),
}

impl std::fmt::Display for StateLabel {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Cell(column, row) => write!(f, "[{column}, {row}]"),
            Self::Name(name) => f.write_str(name),
            Self::Facts(facts) => write!(f, "{{{}}}", facts.join(", ")),
        }
    }
}

/// How the states of a problem are labelled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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
}

impl StateNaming {
    /// The label of a packed state. Constant for cells and names, linear in the facts elsewhere.
    pub(crate) fn label(self, task: &Task, words: &[u64]) -> StateLabel {
        let names = |fact| task.fact_name(fact).to_owned();
        let first = || task.layout().group_value(words, 0).saturating_sub(1);
        match self {
            Self::Facts => StateLabel::Facts(task.facts_of(words).into_iter().map(names).collect()),
            Self::FirstFacts { count } => {
                let shown = task.facts_of(words).into_iter().filter(|fact| fact.index() < count);
                StateLabel::Facts(shown.map(names).collect())
            }
            Self::Names => StateLabel::Name(names(Fact::new(first()))),
            Self::Cells { width } => {
                let cell = first() as u32;
                StateLabel::Cell(cell % width, cell / width)
            }
        }
    }
}
