//! The bound by pairs of states: the actor's, and one that an observer takes for it.
//!
//! *Reachability*, for an enemy: a goal survives a plan exactly when some believed state can be led
//! along it, by transitions that look the same, to a state that satisfies the goal. Both are led at
//! once in the twin plant (Jiang, Huang, Chandra and Kumar 2001, doi:10.1109/9.940942). The fewest
//! steps from (s, s̄) to (true goal, goal), the least over a belief, bound from below how long a plan
//! must still be for the goal to survive; where there are none it is lost.
//!
//! *Elimination*, for a friend: a goal dies when no believed state can be led to it any more. Asked
//! for less, that each believed s̄ alone cannot, if need be along a plan of its own, this is a least
//! fixed point over pairs: s̄ is freed where some transition of the actor leads to a state at which
//! all states that s̄ may go on to are freed. The most steps over a belief bound a plan from below.
//!
//! Believed states that no pair leads to any goal but the true one make no difference any more, so a
//! belief is *trimmed* to the others; nodes that differ in nothing else become one.

use super::classes::observable_classes;
use super::listing::{Listing, Seen};
use super::matrix::BitMatrix;
use super::pair_tables::{Elimination, Reachability, Scratch, by_symbol};
use super::{Bound, Most};
use rustc_hash::{FxHashMap, FxHashSet};

use crate::limits::LimitReached;
use crate::problem::{ProfileId, Role};
use crate::solver::ground::thresholds::{BYTES_OF_PAIRS, STATES_OF_PAIRS, WORDS_OF_A_LEVEL};
use crate::solver::optimiser::estimates::NEVER;
use crate::solver::optimiser::space::Space;
use crate::task::StateId;

/// An observer with a table for each goal but the true one.
#[derive(Debug)]
enum Tables {
    Enemy(usize, Vec<Reachability>),
    Friend(usize, Vec<Elimination>),
}

/// The tables of all observers.
#[derive(Debug)]
pub(in crate::solver::optimiser) struct Pairs {
    goals: usize,
    /// The candidate goals without the true one.
    others: Vec<usize>,
    distances: Vec<u32>,
    tables: Vec<Tables>,
    bytes: u64,
    row: Vec<u32>,
    ahead: Vec<u32>,
    behind: Vec<u32>,
    trimmed: FxHashMap<(StateId, ProfileId), ProfileId>,
}

impl Pairs {
    /// Lists all states and makes the tables; none where they would take too much.
    pub(in crate::solver::optimiser) fn new(
        space: &mut Space,
    ) -> Result<Option<Self>, LimitReached> {
        let Some(listing) = Listing::new(&mut space.joint, STATES_OF_PAIRS)? else {
            return Ok(None);
        };
        let problem = std::sync::Arc::clone(space.problem());
        let (states, goals) = (listing.states, problem.goals().len());
        let others: Vec<usize> = (0..goals).filter(|&goal| goal != problem.true_goal()).collect();
        let table = (states * states) as u64 + BitMatrix::bytes_for(states);
        let bytes = table * (others.len() * problem.observers().len()) as u64;
        let scratch = 6 * BitMatrix::bytes_for(states);
        let limits = *space.joint.limits();
        // The tables are asked of beliefs state by state.
        if bytes + scratch > BYTES_OF_PAIRS.min(limits.bytes / 3) || limits.listed < states {
            return Ok(None);
        }
        let seen: Vec<Vec<Seen>> = (0..problem.observers().len())
            .map(|observer| listing.seen_by(&mut space.joint, observer))
            .collect();
        let width = states.div_ceil(64) as u64;
        for seen in &seen {
            let symbols = seen.chunk_by(|a, b| a.symbol == b.symbol).count() as u64;
            if (2 * seen.len() as u64 + (symbols + 1) * 64 * width) * width > WORDS_OF_A_LEVEL {
                return Ok(None);
            }
        }
        let ends = listing.by_goal[problem.true_goal()].iter();
        let ends: Vec<u32> = ends.copied().filter(|end| listing.reached[*end as usize]).collect();
        let ends = ends.as_slice();
        let distances = listing.distances(&space.joint, ends);
        let matrix = || BitMatrix::new(states);
        let mut scratch = Scratch { one: matrix(), two: matrix(), three: matrix() };
        let mut tables = Vec::new();
        for (observer, watched) in problem.observers().iter().enumerate() {
            let moves = by_symbol(&seen[observer]);
            let root = space.joint.initial().profile;
            let believed = space.joint.beliefs(observer).list(space.joint.belief(root, observer));
            let classes = observable_classes(states, &seen[observer], believed);
            // The two states of a pair that the search comes to are always in one class.
            let possible = |goal: &[u32]| {
                let met: FxHashSet<u32> = goal.iter().map(|g| classes[*g as usize]).collect();
                ends.iter().any(|end| met.contains(&classes[*end as usize]))
            };
            let mut reach = |goal: usize| {
                let goal = &listing.by_goal[goal];
                if !possible(goal) {
                    return Reachability::hopeless();
                }
                Reachability::new(states, &moves, ends, goal, &mut scratch)
            };
            tables.push(match watched.role {
                Role::Adversarial => {
                    Tables::Enemy(observer, others.iter().map(|&goal| reach(goal)).collect())
                }
                Role::Cooperative => {
                    let mut eliminations = Vec::new();
                    for &goal in &others {
                        let goal = &listing.by_goal[goal];
                        if !possible(goal) {
                            eliminations.push(Elimination::dead());
                            continue;
                        }
                        let reach = Reachability::new(states, &moves, ends, goal, &mut scratch);
                        let w = &mut scratch;
                        eliminations
                            .push(Elimination::new(&moves, reach, ends, goal, &distances, w));
                    }
                    Tables::Friend(observer, eliminations)
                }
            });
        }
        Ok(Some(Self {
            goals,
            others,
            distances,
            tables,
            bytes,
            row: Vec::new(),
            ahead: Vec::new(),
            behind: Vec::new(),
            trimmed: FxHashMap::default(),
        }))
    }

    /// Bytes in use, counted by contents.
    pub(in crate::solver::optimiser) fn bytes(&self) -> u64 {
        self.bytes + 20 * self.trimmed.len() as u64
    }

    /// The actions that a plan must still have at least, to end in the true goal worth the aim, perhaps
    /// with one observer alone looked at.
    pub(in crate::solver::optimiser) fn least(
        &mut self,
        space: &Space,
        state: StateId,
        profile: ProfileId,
        aim: i64,
        alone: Option<usize>,
    ) -> u32 {
        let mut least = self.distances[state.index()];
        // At place i: until i + 1 goals beside the true one can survive for each enemy, or be dead
        // for each friend.
        for list in [&mut self.ahead, &mut self.behind] {
            list.clear();
            list.resize(self.others.len(), 0);
        }
        for tables in &self.tables {
            let (Tables::Enemy(observer, _) | Tables::Friend(observer, _)) = tables;
            if alone.is_some_and(|alone| alone != *observer) {
                continue;
            }
            let belief = space.joint.belief(profile, *observer);
            let believed = space.joint.beliefs(*observer).list(belief);
            let named = |list: &[crate::solver::Watched], goal: usize| {
                list.iter().any(|w| w.observer == *observer && w.goal == goal)
            };
            self.row.clear();
            let (list, must) = match tables {
                Tables::Enemy(_, tables) => {
                    self.row.extend(tables.iter().map(|table| table.least(state, believed)));
                    (&mut self.ahead, &space.bounds.required)
                }
                Tables::Friend(_, tables) => {
                    self.row.extend(tables.iter().map(|table| table.most(state, believed)));
                    (&mut self.behind, &space.bounds.forbidden)
                }
            };
            for (&steps, &goal) in self.row.iter().zip(&self.others) {
                if named(must, goal) {
                    least = least.max(steps);
                }
            }
            self.row.sort_unstable();
            for (most, &steps) in list.iter_mut().zip(&self.row) {
                *most = steps.max(*most);
            }
        }
        let at_least = space.bounds.at_least.unwrap_or(1).max(1);
        let at_most = space.bounds.at_most.unwrap_or(self.goals) as i64;
        let mut best = NEVER;
        for survivors in at_least..=self.goals {
            let allowed = (survivors as i64 - aim).min(at_most);
            if allowed < 1 {
                continue;
            }
            let dead = self.goals.saturating_sub(allowed as usize);
            let of = |steps: &[u32], count: usize| count.checked_sub(1).map_or(0, |i| steps[i]);
            best = best.min(of(&self.ahead, survivors - 1).max(of(&self.behind, dead)));
        }
        least.max(best)
    }

    /// The profile with all beliefs trimmed to the states that can still matter while the actor is
    /// in a state; that state is kept.
    pub(in crate::solver::optimiser) fn trim(
        &mut self,
        space: &mut Space,
        state: StateId,
        profile: ProfileId,
    ) -> ProfileId {
        if let Some(&known) = self.trimmed.get(&(state, profile)) {
            return known;
        }
        let mut beliefs = Vec::with_capacity(self.tables.len());
        for tables in &self.tables {
            let (Tables::Enemy(observer, _) | Tables::Friend(observer, _)) = tables;
            let belief = space.joint.belief(profile, *observer);
            let members = space.joint.beliefs(*observer).list(belief);
            let leads = |other: StateId| match tables {
                Tables::Enemy(_, tables) => tables.iter().any(|table| table.leads(state, other)),
                Tables::Friend(_, tables) => tables.iter().any(|table| table.leads(state, other)),
            };
            let kept: Vec<StateId> =
                members.iter().copied().filter(|other| *other == state || leads(*other)).collect();
            beliefs.push(if kept.len() == members.len() {
                belief
            } else {
                space.joint.intern_belief(*observer, kept)
            });
        }
        let trimmed = space.joint.profile(beliefs);
        self.trimmed.insert((state, profile), trimmed);
        trimmed
    }
}

/// The bound from the initial state and the initial beliefs.
#[derive(Debug)]
pub(in crate::solver::optimiser) struct PairBound;

impl Bound for PairBound {
    fn name(&self) -> &'static str {
        "pairs of states"
    }

    fn most(&mut self, space: &mut Space) -> Result<Most, LimitReached> {
        let Some(mut pairs) = Pairs::new(space)? else { return Ok(Most::Unaffordable) };
        Ok(pairs.most(space))
    }
}

impl Pairs {
    /// The greatest value that is not ruled out from the initial state.
    pub(in crate::solver::optimiser) fn most(&mut self, space: &mut Space) -> Most {
        let root = space.joint.initial();
        let top = self.goals as i64 - 1;
        let mut possible =
            |aim: &i64| self.least(space, root.state, root.profile, *aim, None) != NEVER;
        (-top..=top).rev().find(|aim| possible(aim)).map_or(Most::Infeasible, Most::Value)
    }
}
