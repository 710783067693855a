//! The best-first loop that every variant shares.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::hash::Hash;

use fixedbitset::FixedBitSet;

use crate::limits::{LimitReached, Limits};
use crate::plan::Plan;
use crate::solver::engine::{Advance, Engine, Finding};
use crate::solver::outcome::{Progress, Stats, Status};
use crate::solver::tree::SearchTree;
use crate::task::Action;

/// What becomes of a node whose turn has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Admission {
    /// It is expanded.
    Expand,
    /// It waits for the next round.
    Defer,
    /// It leads nowhere.
    Drop,
}

/// What is searched.
pub(super) trait SearchSpace: Send {
    /// What tells nodes apart.
    type Key: Copy + Eq + Hash + Send;

    /// Where the search begins.
    fn root(&mut self) -> Self::Key;

    /// Whether a plan may end here.
    fn is_goal(&mut self, key: Self::Key) -> bool;

    /// The heuristic value of a node; none for a dead end.
    fn value(&mut self, key: Self::Key) -> Option<i64>;

    /// The nodes that follow.
    fn expand(
        &mut self,
        key: Self::Key,
        found: &mut Vec<(Action, Self::Key)>,
    ) -> Result<(), LimitReached>;

    /// Another value of a node that is `depth` actions from the root. Where there is one, every
    /// other node is chosen by it.
    fn second_value(&mut self, _key: Self::Key, _depth: u32) -> Option<i64> {
        None
    }

    /// Whether a node is expanded in this round. A space that never defers has one round.
    fn admit(&mut self, _key: Self::Key) -> Admission {
        Admission::Expand
    }

    /// All nodes of this round are done and some wait.
    fn next_round(&mut self) {}

    /// The limits in force.
    fn limits(&self) -> &Limits;

    /// Bytes in use, counted by contents.
    fn bytes(&self) -> u64;

    /// Fills in what the space has met.
    fn count(&self, stats: &mut Stats);
}

/// Least value first, then the oldest.
type Open = BinaryHeap<Reverse<(i64, u64, u32)>>;

/// How many nodes are expanded between two looks at the memory.
const EXPANSIONS_BETWEEN_CHECKS: u64 = 16;

/// A best-first search at work.
pub(super) struct BestFirst<S: SearchSpace> {
    space: S,
    tree: SearchTree<S::Key>,
    /// How many actions lead to each node.
    depths: Vec<u32>,
    open: Open,
    /// The same nodes by their second values, once there are any (two lists that take turns: Röger
    /// and Helmert 2010, "The more, the merrier: combining heuristic estimators for satisficing
    /// planning", doi:10.1609/icaps.v20i1.13420).
    second: Open,
    is_turn_of_second: bool,
    /// Nodes whose turn has come: they may still be in the other list.
    taken: FixedBitSet,
    deferred: Open,
    pushed: u64,
    expansions: u64,
    /// The node that ends a plan.
    end: Option<usize>,
    found: Vec<(Action, S::Key)>,
}

impl<S: SearchSpace> BestFirst<S> {
    pub(super) fn new(mut space: S) -> Self {
        let root = space.root();
        let mut search = Self {
            space,
            tree: SearchTree::new(root),
            depths: vec![0],
            open: BinaryHeap::new(),
            second: BinaryHeap::new(),
            is_turn_of_second: false,
            taken: FixedBitSet::new(),
            deferred: BinaryHeap::new(),
            pushed: 0,
            expansions: 0,
            end: None,
            found: Vec::new(),
        };
        search.push(0);
        search
    }

    /// Opens a node that is new, unless it is a dead end. The goal is tested here and not when the
    /// node's turn comes: a plan found is a plan.
    fn push(&mut self, index: usize) {
        let key = self.tree.key(index);
        if self.space.is_goal(key) {
            self.end = Some(index);
        } else if let Some(value) = self.space.value(key) {
            let entry = (value, self.pushed, index as u32);
            self.open.push(Reverse(entry));
            self.push_second(entry);
            self.pushed += 1;
        }
    }

    fn push_second(&mut self, (_, pushed, index): (i64, u64, u32)) {
        let (key, depth) = (self.tree.key(index as usize), self.depths[index as usize]);
        if let Some(value) = self.space.second_value(key, depth) {
            self.second.push(Reverse((value, pushed, index)));
        }
    }

    /// Opens all nodes by their second values too, as soon as there are any.
    fn open_second(&mut self) {
        if !self.second.is_empty() || self.space.second_value(self.tree.key(0), 0).is_none() {
            return;
        }
        let taken = |index: u32| self.taken.contains(index as usize);
        let open = self.open.iter().map(|Reverse(entry)| *entry);
        let waiting: Vec<_> = open.filter(|&(_, _, index)| !taken(index)).collect();
        waiting.into_iter().for_each(|entry| self.push_second(entry));
    }

    /// The next node whose turn it is, with its value and when it was opened.
    fn pop(&mut self) -> Option<(i64, u64, u32)> {
        loop {
            let from_second = self.is_turn_of_second && !self.second.is_empty();
            let list = if from_second { &mut self.second } else { &mut self.open };
            let Reverse((mut value, pushed, index)) = list.pop()?;
            self.taken.grow(self.tree.len());
            if self.taken.put(index as usize) {
                continue;
            }
            self.is_turn_of_second = !self.is_turn_of_second;
            if from_second {
                let Some(first) = self.space.value(self.tree.key(index as usize)) else { continue };
                value = first;
            }
            return Some((value, pushed, index));
        }
    }

    /// Opens the nodes that wait.
    fn begin_round(&mut self) {
        self.space.next_round();
        std::mem::swap(&mut self.open, &mut self.deferred);
        self.second.clear();
        for Reverse((_, _, index)) in &self.open {
            self.taken.remove(*index as usize);
        }
        self.open_second();
    }

    fn check_limits(&self) -> Result<(), LimitReached> {
        let limits = self.space.limits();
        if self.expansions >= limits.expansions {
            return Err(LimitReached::Expansions { limit: limits.expansions });
        }
        if !self.expansions.is_multiple_of(EXPANSIONS_BETWEEN_CHECKS) {
            return Ok(());
        }
        let entries = self.open.len() + self.second.len() + self.deferred.len();
        let own = size_of::<Reverse<(i64, u64, u32)>>() * entries + 4 * self.depths.len();
        limits.check_bytes(self.space.bytes() + self.tree.bytes() + own as u64)
    }

    fn expand(&mut self, index: usize) -> Result<(), LimitReached> {
        self.check_limits()?;
        let mut found = std::mem::take(&mut self.found);
        let expanded = self.space.expand(self.tree.key(index), &mut found);
        self.expansions += 1;
        if expanded.is_ok() {
            for &(action, key) in &found {
                if let Some(new) = self.tree.meet(key, index, action) {
                    self.depths.push(self.depths[index] + 1);
                    self.push(new);
                    if self.end.is_some() {
                        break;
                    }
                }
            }
        }
        self.found = found;
        self.open_second();
        expanded
    }

    fn plan(&self) -> Option<Plan> {
        self.end.map(|index| self.tree.plan(index))
    }
}

impl<S: SearchSpace> Engine for BestFirst<S> {
    fn advance(&mut self, budget: u64) -> Result<Advance, LimitReached> {
        for _ in 0..budget {
            if let Some(plan) = self.plan() {
                return Ok(Advance::Finished(Finding::plan(Status::Solved, plan)));
            }
            let Some(next) = self.pop() else {
                if self.deferred.is_empty() {
                    return Ok(Advance::Finished(Finding::infeasible()));
                }
                self.begin_round();
                continue;
            };
            let (_, _, index) = next;
            match self.space.admit(self.tree.key(index as usize)) {
                Admission::Expand => self.expand(index as usize)?,
                Admission::Defer => self.deferred.push(Reverse(next)),
                Admission::Drop => {}
            }
        }
        Ok(Advance::Working)
    }

    fn stop(&mut self, limit: LimitReached) -> Finding {
        match self.plan() {
            Some(plan) => Finding::plan(Status::Solved, plan),
            None => Finding::stopped(None, limit),
        }
    }

    fn report(&self, _progress: &mut Progress) {}

    fn stats(&self) -> Stats {
        let mut stats = Stats {
            expansions: self.expansions,
            generated: self.tree.len() as u64,
            ..Stats::default()
        };
        self.space.count(&mut stats);
        stats
    }
}
