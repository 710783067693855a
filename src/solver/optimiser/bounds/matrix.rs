//! Bit matrices: relations between states, a row of bits for each, with a fast transpose.

/// A square matrix of bits.
#[derive(Debug, Clone)]
pub(super) struct BitMatrix {
    /// Rows, a multiple of 64.
    rows: usize,
    /// Words of a row.
    width: usize,
    words: Vec<u64>,
}

/// Transposes a block of 64 by 64 bits in place: swaps halves, quarters and so on (Warren 2012,
/// *Hacker's Delight*, section 7-3).
fn transpose_block(block: &mut [u64; 64]) {
    let mut half = 32;
    let mut mask = 0x0000_0000_ffff_ffff_u64;
    while half != 0 {
        let mut row = 0;
        while row < 64 {
            let swapped = ((block[row] >> half) ^ block[row + half]) & mask;
            block[row] ^= swapped << half;
            block[row + half] ^= swapped;
            row = (row + half + 1) & !half;
        }
        half >>= 1;
        mask ^= mask << half;
    }
}

impl BitMatrix {
    /// The empty relation on so many states.
    pub(super) fn new(states: usize) -> Self {
        let width = states.div_ceil(64);
        Self { rows: width * 64, width, words: vec![0; width * 64 * width] }
    }

    /// Bytes that a matrix on so many states takes.
    pub(super) fn bytes_for(states: usize) -> u64 {
        let width = states.div_ceil(64) as u64;
        8 * 64 * width * width
    }

    pub(super) fn row(&self, row: usize) -> &[u64] {
        &self.words[row * self.width..][..self.width]
    }

    pub(super) fn row_mut(&mut self, row: usize) -> &mut [u64] {
        &mut self.words[row * self.width..][..self.width]
    }

    pub(super) fn contains(&self, row: usize, column: usize) -> bool {
        self.words[row * self.width + column / 64] >> (column % 64) & 1 == 1
    }

    pub(super) fn insert(&mut self, row: usize, column: usize) {
        self.words[row * self.width + column / 64] |= 1 << (column % 64);
    }

    pub(super) fn clear(&mut self) {
        self.words.fill(0);
    }

    pub(super) fn words(&self) -> &[u64] {
        &self.words
    }

    pub(super) fn words_mut(&mut self) -> &mut [u64] {
        &mut self.words
    }

    /// Makes a row the union of itself and a row of another matrix.
    pub(super) fn unite(&mut self, row: usize, other: &Self, from: usize) {
        for (word, more) in self.row_mut(row).iter_mut().zip(other.row(from)) {
            *word |= more;
        }
    }

    /// Makes a row the intersection of itself and a row of another matrix.
    pub(super) fn intersect(&mut self, row: usize, other: &Self, from: usize) {
        for (word, less) in self.row_mut(row).iter_mut().zip(other.row(from)) {
            *word &= less;
        }
    }

    /// Overwrites this matrix with the transpose of another one.
    pub(super) fn transpose_of(&mut self, other: &Self) {
        let width = self.width;
        let mut block = [0_u64; 64];
        for above in 0..self.rows / 64 {
            for left in 0..width {
                let mut any = 0;
                for (row, word) in block.iter_mut().enumerate() {
                    *word = other.words[(above * 64 + row) * width + left];
                    any |= *word;
                }
                if any != 0 {
                    transpose_block(&mut block);
                }
                for (row, word) in block.iter().enumerate() {
                    self.words[(left * 64 + row) * width + above] = *word;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_transpose_swaps_rows_and_columns() {
        let mut matrix = BitMatrix::new(130);
        let mut seed = 7_u32;
        for row in 0..130 {
            for column in 0..130 {
                seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                if seed >> 30 == 0 {
                    matrix.insert(row, column);
                }
            }
        }
        let mut transpose = BitMatrix::new(130);
        transpose.transpose_of(&matrix);
        for row in 0..130 {
            for column in 0..130 {
                assert_eq!(matrix.contains(row, column), transpose.contains(column, row));
            }
        }
    }
}
