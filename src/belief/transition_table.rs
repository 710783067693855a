//! Transition table: (number, number) → number, dense where the second number is small.

use rustc_hash::FxHashMap;

/// Widest row that is kept as an array.
const DENSE_WIDTH: usize = 64;
const EMPTY: u32 = u32::MAX;

/// Remembers which number follows from a row and a column.
#[derive(Debug, Clone)]
pub enum TransitionTable {
    /// One array cell for each column of each row met.
    Dense {
        /// Columns in a row.
        width: usize,
        /// The cells, row after row.
        cells: Vec<u32>,
    },
    /// A map, for many columns.
    Sparse(FxHashMap<(u32, u32), u32>),
}

impl TransitionTable {
    /// An empty table for columns below `columns`.
    pub fn new(columns: usize) -> Self {
        if columns <= DENSE_WIDTH {
            Self::Dense { width: columns, cells: Vec::new() }
        } else {
            Self::Sparse(FxHashMap::default())
        }
    }

    /// What was remembered.
    pub fn get(&self, row: u32, column: u32) -> Option<u32> {
        match self {
            Self::Dense { width, cells } => {
                let value = *cells.get(row as usize * width + column as usize)?;
                (value != EMPTY).then_some(value)
            }
            Self::Sparse(map) => map.get(&(row, column)).copied(),
        }
    }

    /// Remembers a value below 2³² − 1.
    pub fn set(&mut self, row: u32, column: u32, value: u32) {
        match self {
            Self::Dense { width, cells } => {
                let needed = (row as usize + 1) * *width;
                if cells.len() < needed {
                    cells.resize(needed, EMPTY);
                }
                cells[row as usize * *width + column as usize] = value;
            }
            Self::Sparse(map) => {
                map.insert((row, column), value);
            }
        }
    }

    /// Bytes in use.
    pub fn bytes(&self) -> u64 {
        match self {
            Self::Dense { cells, .. } => 4 * cells.len() as u64,
            Self::Sparse(map) => 16 * map.len() as u64,
        }
    }
}
