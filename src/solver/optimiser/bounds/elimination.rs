//! Linear equations over facts, solved by Gaussian elimination over a large prime field and over
//! GF(2).

use rustc_hash::FxHashSet;

use crate::solver::ground::thresholds::WORK_OF_ELIMINATION;

/// A Mersenne prime.
const PRIME: u64 = (1 << 61) - 1;
fn multiply(a: u64, b: u64) -> u64 {
    (u128::from(a) * u128::from(b) % u128::from(PRIME)) as u64
}

fn add(a: u64, b: u64) -> u64 {
    let sum = a + b;
    if sum >= PRIME { sum - PRIME } else { sum }
}

fn negate(a: u64) -> u64 {
    if a == 0 { 0 } else { PRIME - a }
}

fn inverse(a: u64) -> u64 {
    let (mut result, mut base, mut exponent) = (1, a, PRIME - 2);
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = multiply(result, base);
        }
        base = multiply(base, base);
        exponent >>= 1;
    }
    result
}

/// The numbers of splitmix64: the same everywhere.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    }
}

/// A change of a state as a sparse vector over facts, sorted by fact.
pub(super) type Vector = Vec<(usize, i32)>;

/// The sum of vectors, each times a sign.
pub(super) fn combine(parts: &[(&Vector, i32)]) -> Vector {
    let mut all: Vector = Vec::new();
    for (vector, sign) in parts {
        all.extend(vector.iter().map(|&(fact, amount)| (fact, sign * amount)));
    }
    all.sort_unstable();
    let mut sum: Vector = Vec::new();
    for (fact, amount) in all {
        match sum.last_mut() {
            Some((last, total)) if *last == fact => *total += amount,
            _ => sum.push((fact, amount)),
        }
    }
    sum.retain(|(_, amount)| *amount != 0);
    sum
}

/// Weights of the facts: over the prime field, and 64 times over GF(2).
#[derive(Debug)]
pub(super) struct Weights {
    prime: Vec<u64>,
    bits: Vec<u64>,
    /// Of the equations that they solve, over each field.
    pub(super) ranks: [usize; 2],
    /// Multiplications that it took.
    pub(super) work: u64,
}

/// The sums of a state under one set of weights.
pub(super) type Sum = (u64, u64);

pub(super) fn plus(a: Sum, b: Sum) -> Sum {
    (add(a.0, b.0), a.1 ^ b.1)
}

impl Weights {
    /// Weights that each of these vectors sums up to 0 under; none where that takes too long.
    pub(super) fn orthogonal_to(vectors: &FxHashSet<Vector>, facts: usize) -> Option<Self> {
        let mut ordered: Vec<&Vector> = vectors.iter().collect();
        ordered.sort_unstable();
        let mut random = Random(facts as u64);
        let (prime, rank, work) = solve_prime(&ordered, facts, &mut random)?;
        let (bits, rank_of_bits) = solve_bits(&ordered, facts, &mut random);
        Some(Self { prime, bits, ranks: [rank, rank_of_bits], work })
    }

    /// Adds a weight of its own for each block of the facts of a group.
    pub(super) fn tell_apart(
        &mut self,
        group: usize,
        blocks: impl Iterator<Item = (usize, usize)>,
    ) {
        for (fact, block) in blocks {
            let mut random = Random((group as u64) << 32 | block as u64);
            self.prime[fact] = add(self.prime[fact], random.next() % PRIME);
            self.bits[fact] ^= random.next();
        }
    }

    /// The weights of one fact.
    pub(super) fn of(&self, fact: usize) -> Sum {
        (self.prime[fact], self.bits[fact])
    }
}

/// A random solution over the prime field, the rank, and the multiplications that it took.
fn solve_prime(
    vectors: &[&Vector],
    facts: usize,
    random: &mut Random,
) -> Option<(Vec<u64>, usize, u64)> {
    let mut rows: Vec<(usize, Vec<u64>)> = Vec::new();
    let mut work = 0;
    for vector in vectors {
        let mut dense = vec![0; facts];
        for &(fact, amount) in *vector {
            let size = u64::from(amount.unsigned_abs());
            dense[fact] = if amount < 0 { negate(size) } else { size };
        }
        for (pivot, row) in &rows {
            let factor = negate(dense[*pivot]);
            if factor != 0 {
                work += facts as u64;
                for (value, more) in dense.iter_mut().zip(row) {
                    if *more != 0 {
                        *value = add(*value, multiply(factor, *more));
                    }
                }
            }
        }
        if work > WORK_OF_ELIMINATION {
            return None;
        }
        if let Some(pivot) = dense.iter().position(|value| *value != 0) {
            let factor = inverse(dense[pivot]);
            for value in &mut dense {
                *value = multiply(factor, *value);
            }
            rows.push((pivot, dense));
        }
    }
    let mut weights: Vec<u64> = (0..facts).map(|_| random.next() % PRIME).collect();
    // A row is 0 at the pivots of the rows before it, so the last one is solved first.
    for (pivot, row) in rows.iter().rev() {
        let others = row.iter().zip(&weights).enumerate().filter(|(fact, _)| fact != pivot);
        let sum = others.fold(0, |sum, (_, (value, weight))| add(sum, multiply(*value, *weight)));
        weights[*pivot] = negate(sum);
    }
    Some((weights, rows.len(), work))
}

/// 64 random solutions over GF(2), a bit for each, and the rank.
fn solve_bits(vectors: &[&Vector], facts: usize, random: &mut Random) -> (Vec<u64>, usize) {
    let mut rows: Vec<(usize, Vec<u64>)> = Vec::new();
    for vector in vectors {
        let mut dense = vec![0_u64; facts.div_ceil(64)];
        for &(fact, amount) in *vector {
            dense[fact / 64] ^= u64::from(amount % 2 != 0) << (fact % 64);
        }
        for (pivot, row) in &rows {
            if dense[pivot / 64] >> (pivot % 64) & 1 == 1 {
                dense.iter_mut().zip(row).for_each(|(word, other)| *word ^= other);
            }
        }
        if let Some(place) = dense.iter().position(|word| *word != 0) {
            rows.push((place * 64 + dense[place].trailing_zeros() as usize, dense));
        }
    }
    let mut weights: Vec<u64> = (0..facts).map(|_| random.next()).collect();
    for (pivot, row) in rows.iter().rev() {
        let others =
            (0..facts).filter(|fact| fact != pivot && row[fact / 64] >> (fact % 64) & 1 == 1);
        weights[*pivot] = others.fold(0, |sum, fact| sum ^ weights[fact]);
    }
    (weights, rows.len())
}
