//! Greedy best-first search: the loop that Algorithm 1 and the baseline share.
//!
//! The node with the least heuristic value is opened first, the oldest one of equals; where a space
//! asks for it, the newest one takes every second turn once values stop falling. A space may put
//! nodes off to a later round.

use std::collections::{BTreeMap, VecDeque};
use std::hash::Hash;

use crate::limits::{LimitReached, Limits};
use crate::plan::Plan;
use crate::solver::engine::{Advance, Engine, Finding};
use crate::solver::ground::search_tree::SearchTree;
use crate::solver::ground::thresholds::EXPANSIONS_BETWEEN_CHECKS;
use crate::solver::outcome::{Progress, Stats, Status};
use crate::task::Action;

/// What becomes of a node whose turn has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::solver) enum Admission {
    /// It is expanded.
    Expand,
    /// It waits for the next round.
    Defer,
    /// It is left out, since it is one that was expanded before.
    Drop,
}

/// What is searched.
pub(in crate::solver) trait SearchSpace: Send {
    /// What tells nodes apart.
    type Key: Copy + Eq + Hash + Send;

    /// Where the search begins.
    fn root(&mut self) -> Self::Key;

    /// Whether a plan may end here.
    fn is_goal(&mut self, key: Self::Key) -> Result<bool, LimitReached>;

    /// The heuristic value of a node; none for a dead end.
    fn value(&mut self, key: Self::Key) -> Option<i64>;

    /// The nodes that follow.
    fn expand(
        &mut self,
        key: Self::Key,
        found: &mut Vec<(Action, Self::Key)>,
    ) -> Result<(), LimitReached>;

    /// Whether a node is expanded in this round. A space that never defers has one round.
    fn admit(&mut self, _key: Self::Key) -> Result<Admission, LimitReached> {
        Ok(Admission::Expand)
    }

    /// All nodes of this round are done and some wait.
    fn next_round(&mut self) {}

    /// After so many expansions without a smaller value than before the newest of equal nodes
    /// takes every second turn: where many nodes look alike the oldest ones alone would be searched
    /// breadth first. None: the oldest always come first.
    fn patience(&self) -> Option<u64> {
        None
    }

    /// The limits in force.
    fn limits(&self) -> &Limits;

    /// Bytes in use, counted by contents.
    fn bytes(&self) -> u64;

    /// Fills in what the space has met.
    fn count(&self, stats: &mut Stats);
}

/// Nodes by value, those of one value by age.
#[derive(Debug, Default)]
struct Open {
    by_value: BTreeMap<i64, VecDeque<u32>>,
    len: usize,
}

impl Open {
    fn push(&mut self, value: i64, index: u32) {
        self.by_value.entry(value).or_default().push_back(index);
        self.len += 1;
    }

    /// The oldest or the newest of the nodes with the least value.
    fn pop(&mut self, newest: bool) -> Option<(i64, u32)> {
        let mut least = self.by_value.first_entry()?;
        let value = *least.key();
        let nodes = least.get_mut();
        let index = if newest { nodes.pop_back() } else { nodes.pop_front() };
        if nodes.is_empty() {
            least.remove();
        }
        self.len -= 1;
        index.map(|index| (value, index))
    }
}

/// A best-first search at work.
pub(in crate::solver) struct BestFirst<S: SearchSpace> {
    space: S,
    tree: SearchTree<S::Key>,
    open: Open,
    deferred: Open,
    expansions: u64,
    /// Whether the root is open.
    begun: bool,
    /// The least value of a node expanded, and how many expansions there were before it.
    least: (i64, u64),
    /// The node that ends a plan.
    end: Option<usize>,
    found: Vec<(Action, S::Key)>,
}

impl<S: SearchSpace> BestFirst<S> {
    pub(in crate::solver) fn new(mut space: S) -> Self {
        let root = space.root();
        Self {
            space,
            tree: SearchTree::new(root),
            open: Open::default(),
            deferred: Open::default(),
            expansions: 0,
            least: (i64::MAX, 0),
            begun: false,
            end: None,
            found: Vec::new(),
        }
    }

    /// Opens a node that is new, unless it is a dead end. The goal is tested here and not when the
    /// node's turn comes: a plan found is a plan.
    fn push(&mut self, index: usize) -> Result<(), LimitReached> {
        let key = self.tree.key(index);
        if self.space.is_goal(key)? {
            self.end = Some(index);
        } else if let Some(value) = self.space.value(key) {
            self.open.push(value, index as u32);
        }
        Ok(())
    }

    fn check_limits(&self) -> Result<(), LimitReached> {
        let limits = self.space.limits();
        if self.expansions >= limits.expansions {
            return Err(LimitReached::Expansions { limit: limits.expansions });
        }
        if !self.expansions.is_multiple_of(EXPANSIONS_BETWEEN_CHECKS) {
            return Ok(());
        }
        let open = size_of::<u32>() * (self.open.len + self.deferred.len);
        limits.check_bytes(self.space.bytes() + self.tree.bytes() + open as u64)
    }

    fn expand(&mut self, index: usize) -> Result<(), LimitReached> {
        self.check_limits()?;
        let mut found = std::mem::take(&mut self.found);
        let expanded = self.space.expand(self.tree.key(index), &mut found);
        self.expansions += 1;
        if expanded.is_ok() {
            for &(action, key) in &found {
                if let Some(new) = self.tree.meet(key, index, action) {
                    self.push(new)?;
                    if self.end.is_some() {
                        break;
                    }
                }
            }
        }
        self.found = found;
        expanded
    }

    fn plan(&self) -> Option<Plan> {
        self.end.map(|index| self.tree.plan(index))
    }
}

impl<S: SearchSpace> Engine for BestFirst<S> {
    fn advance(&mut self, budget: u64) -> Result<Advance, LimitReached> {
        if !self.begun {
            self.begun = true;
            self.push(0)?;
        }
        for _ in 0..budget {
            if let Some(plan) = self.plan() {
                return Ok(Advance::Finished(Finding::plan(Status::Solved, plan)));
            }
            let since = self.expansions - self.least.1;
            let stuck = self.space.patience().is_some_and(|patience| since >= patience);
            let Some((value, index)) = self.open.pop(stuck && since % 2 == 1) else {
                if self.deferred.len == 0 {
                    return Ok(Advance::Finished(Finding::infeasible()));
                }
                self.space.next_round();
                std::mem::swap(&mut self.open, &mut self.deferred);
                continue;
            };
            match self.space.admit(self.tree.key(index as usize))? {
                Admission::Expand => {
                    if value < self.least.0 {
                        self.least = (value, self.expansions);
                    }
                    self.expand(index as usize)?;
                }
                Admission::Defer => self.deferred.push(value, index),
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
