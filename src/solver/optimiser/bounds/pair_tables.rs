//! Tables over pairs of states: how soon a goal can survive for an observer, and how soon it can be
//! dead.
//!
//! Rows of bits, a bit for each other state, are worked on a level at a time: a level takes the
//! transitions times the states, a 64th each.

use super::listing::Seen;
use super::matrix::BitMatrix;
use crate::solver::optimiser::estimates::NEVER;
use crate::task::StateId;

/// Beyond so many steps nothing is told apart.
const FARTHEST: u8 = u8::MAX - 1;
const UNKNOWN: u8 = u8::MAX;

/// The transitions of an observer that carry one symbol.
#[derive(Debug)]
pub(super) struct Moves(Vec<(u32, u32)>);

pub(super) fn by_symbol(seen: &[Seen]) -> Vec<Moves> {
    let groups = seen.chunk_by(|a, b| a.symbol == b.symbol);
    groups.map(|group| Moves(group.iter().map(|s| (s.from, s.to)).collect())).collect()
}

/// Matrices to work with.
#[derive(Debug)]
pub(super) struct Scratch {
    pub one: BitMatrix,
    pub two: BitMatrix,
    pub three: BitMatrix,
}

/// The fewest steps from pairs to (true goal, goal).
#[derive(Debug)]
pub(super) struct Reachability {
    states: usize,
    least: Vec<u8>,
    reached: BitMatrix,
}

impl Reachability {
    pub(super) fn new(
        states: usize,
        moves: &[Moves],
        ends: &[u32],
        goal: &[u32],
        w: &mut Scratch,
    ) -> Self {
        let mut least = vec![UNKNOWN; states * states];
        let mut reached = BitMatrix::new(states);
        for &state in ends {
            for &other in goal {
                reached.insert(state as usize, other as usize);
                least[state as usize * states + other as usize] = 0;
            }
        }
        let mut frontier = reached.clone();
        let mut level = 0_u8;
        loop {
            level = level.saturating_add(1).min(FARTHEST);
            // In `three`, transposed: the pairs that lead to the frontier.
            w.three.clear();
            for Moves(moves) in moves {
                w.one.clear();
                for &(from, to) in moves {
                    w.one.unite(from as usize, &frontier, to as usize);
                }
                w.two.transpose_of(&w.one);
                for &(from, to) in moves {
                    w.three.unite(from as usize, &w.two, to as usize);
                }
            }
            frontier.transpose_of(&w.three);
            let mut any = false;
            let width = states.div_ceil(64);
            for (place, (new, old)) in
                frontier.words_mut().iter_mut().zip(reached.words_mut()).enumerate()
            {
                *new &= !*old;
                *old |= *new;
                let mut bits = *new;
                any |= bits != 0;
                let (row, first) = (place / width, place % width * 64);
                while bits != 0 {
                    least[row * states + first + bits.trailing_zeros() as usize] = level;
                    bits &= bits - 1;
                }
            }
            if !any {
                return Self { states, least, reached };
            }
        }
    }

    /// Knows that no pair the search can come to leads there.
    pub(super) fn hopeless() -> Self {
        Self { states: 0, least: Vec::new(), reached: BitMatrix::new(0) }
    }

    /// The fewest steps of any believed state.
    pub(super) fn least(&self, state: StateId, believed: &[StateId]) -> u32 {
        if self.states == 0 {
            return NEVER;
        }
        let row = &self.least[state.index() * self.states..][..self.states];
        let least = believed.iter().map(|other| row[other.index()]).min().unwrap_or(UNKNOWN);
        if least == UNKNOWN { NEVER } else { u32::from(least) }
    }

    pub(super) fn leads(&self, state: StateId, other: StateId) -> bool {
        self.states != 0 && self.reached.contains(state.index(), other.index())
    }
}

/// After how many steps a plan may end at the soonest with a goal dead.
#[derive(Debug)]
pub(super) struct Elimination {
    states: usize,
    /// 0 where the other state cannot be led to the goal anyhow.
    steps: Vec<u8>,
    reached: BitMatrix,
}

impl Elimination {
    pub(super) fn new(
        moves: &[Moves],
        reachability: Reachability,
        ends: &[u32],
        goal: &[u32],
        distances: &[u32],
        w: &mut Scratch,
    ) -> Self {
        let Reachability { states, least: mut steps, reached } = reachability;
        let width = states.div_ceil(64);
        let mut open = reached.clone();
        let mut satisfies = vec![0_u64; width];
        for &state in goal {
            satisfies[state as usize / 64] |= 1 << (state % 64);
        }
        for &state in ends {
            for (word, goal) in open.row_mut(state as usize).iter_mut().zip(&satisfies) {
                *word &= goal;
            }
        }
        let record = |before: &[u64], after: &[u64], steps: &mut [u8], level: u32| {
            let mut any = false;
            for (place, (old, new)) in before.iter().zip(after).enumerate() {
                let mut bits = old & !new;
                any |= bits != 0;
                let (row, first) = (place / width, place % width * 64);
                while bits != 0 {
                    let pair = row * states + first + bits.trailing_zeros() as usize;
                    steps[pair] = level.min(u32::from(FARTHEST)) as u8;
                    bits &= bits - 1;
                }
            }
            any
        };
        for step in &mut steps {
            *step = if *step == UNKNOWN { 0 } else { UNKNOWN };
        }
        record(reached.words(), open.words(), &mut steps, 0);
        let farthest = distances.iter().filter(|d| **d != u32::MAX).max().copied().unwrap_or(0);
        let mut next = open.clone();
        let mut level = 0;
        loop {
            level += 1;
            next.words_mut().copy_from_slice(open.words());
            w.one.transpose_of(&open);
            for Moves(moves) in moves {
                // In `three`: by actor's state, the others that have a way to go on open.
                w.two.clear();
                for &(from, to) in moves {
                    w.two.unite(from as usize, &w.one, to as usize);
                }
                w.three.transpose_of(&w.two);
                for &(from, to) in moves {
                    if distances[to as usize] < level {
                        next.intersect(from as usize, &w.three, to as usize);
                    }
                }
            }
            let changed = record(open.words(), next.words(), &mut steps, level);
            std::mem::swap(&mut open, &mut next);
            if !changed && level > farthest {
                return Self { states, steps, reached };
            }
        }
    }

    /// Knows that the goal is dead whatever the plan.
    pub(super) fn dead() -> Self {
        Self { states: 0, steps: Vec::new(), reached: BitMatrix::new(0) }
    }

    /// The most steps of any believed state.
    pub(super) fn most(&self, state: StateId, believed: &[StateId]) -> u32 {
        if self.states == 0 {
            return 0;
        }
        let row = &self.steps[state.index() * self.states..][..self.states];
        let most = believed.iter().map(|other| row[other.index()]).max().unwrap_or(0);
        if most == UNKNOWN { NEVER } else { u32::from(most) }
    }

    pub(super) fn leads(&self, state: StateId, other: StateId) -> bool {
        self.states != 0 && self.reached.contains(state.index(), other.index())
    }
}
