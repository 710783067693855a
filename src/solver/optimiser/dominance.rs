//! Dominance: the antichain of nodes that no other node is at least as good as.
//!
//! Updates of beliefs are monotone: if one belief holds all states of another, it does so after any
//! symbol. So of two nodes with one actor component, the one in which every enemy believes at least
//! as much and every friend at most as much ends no worse, whatever plan goes on from there, and the
//! other is left out (antichains: De Wulf, Doyen, Henzinger and Raskin 2006,
//! <https://doi.org/10.1007/11817963_5>).
//!
//! Where that is sound:
//!
//! | asked for | dominance |
//! |---|---|
//! | best value; k and j; a goal required of an enemy or forbidden to a friend | yes |
//! | a shortest best plan | only over nodes that take no fewer steps |
//! | a plan of exactly T actions | only over nodes after equally many steps |
//! | a goal required of a friend or forbidden to an enemy | that observer's beliefs must be equal |
//! | every reachable pair of counts | no |

use std::cmp::Ordering;

use rustc_hash::FxHashMap;

use super::search::Met;
use super::space::Space;
use super::thresholds::NODES_COMPARED;
use crate::problem::{Problem, ProfileId, Role};
use crate::solver::Bounds;
use crate::task::StateId;

/// How an observer's beliefs in two nodes must compare for the first to be as good.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Relation {
    /// The first holds all states of the second.
    Superset,
    /// The second holds all states of the first.
    Subset,
    /// They are equal.
    Equal,
}

/// The relation asked of each observer.
fn relations(problem: &Problem, bounds: &Bounds) -> Vec<Relation> {
    let named = |list: &[crate::solver::Watched], observer: usize| {
        list.iter().any(|w| w.observer == observer && w.goal != problem.true_goal())
    };
    let relation = |(number, observer): (usize, &crate::problem::Observer)| match observer.role {
        Role::Adversarial if named(&bounds.forbidden, number) => Relation::Equal,
        Role::Adversarial => Relation::Superset,
        Role::Cooperative if named(&bounds.required, number) => Relation::Equal,
        Role::Cooperative => Relation::Subset,
    };
    problem.observers().iter().enumerate().map(relation).collect()
}

/// Which nodes may dominate one that takes some number of steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Steps {
    /// All: only the value counts.
    Any,
    /// Those that take no more: a shortest plan is looked for.
    NoMore,
    /// Those that take equally many: plans of one length are looked for.
    Equal,
}

/// Whether dominated nodes are left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Policy {
    /// Where that is sound.
    Sound,
    /// Nowhere: what the tests hold the rest against.
    #[cfg(test)]
    Off,
    /// As if only the best value of plans of all lengths without named goals were asked for: what
    /// the tests show to be wrong elsewhere.
    #[cfg(test)]
    Careless,
}

/// Nodes that none met so far dominates, by actor component.
#[derive(Debug)]
pub(super) struct Antichain {
    relations: Vec<Relation>,
    steps: Steps,
    fronts: FxHashMap<(u32, u32), Vec<u32>>,
    len: usize,
}

/// Whether all of the first are among the second. Both are sorted.
fn is_subset(some: &[StateId], all: &[StateId]) -> bool {
    if some.len() > all.len() {
        return false;
    }
    let mut rest = all.iter();
    some.iter().all(|state| rest.by_ref().find(|other| *other >= state) == Some(state))
}

impl Antichain {
    /// The empty antichain; none where no node is to be left out.
    #[allow(clippy::unnecessary_wraps)] // The tests leave out none.
    pub(super) fn new(
        policy: Policy,
        problem: &Problem,
        bounds: &Bounds,
        steps: Steps,
    ) -> Option<Self> {
        let (relations, steps) = match policy {
            Policy::Sound => (relations(problem, bounds), steps),
            #[cfg(test)]
            Policy::Off => return None,
            #[cfg(test)]
            Policy::Careless => (relations(problem, &Bounds::default()), Steps::Any),
        };
        Some(Self { relations, steps, fronts: FxHashMap::default(), len: 0 })
    }

    /// Whether the first of two profiles is at least as good.
    fn dominates(&self, space: &Space, one: ProfileId, other: ProfileId) -> bool {
        one == other
            || self.relations.iter().enumerate().all(|(observer, relation)| {
                let (a, b) =
                    (space.joint.belief(one, observer), space.joint.belief(other, observer));
                let members = |belief| space.joint.beliefs(observer).members(belief);
                a == b
                    || match relation {
                        Relation::Superset => is_subset(members(b), members(a)),
                        Relation::Subset => is_subset(members(a), members(b)),
                        Relation::Equal => false,
                    }
            })
    }

    /// Whether steps let the first node dominate the second.
    fn may(&self, one: u32, other: u32) -> bool {
        match self.steps {
            Steps::Any => true,
            Steps::NoMore => one.cmp(&other) != Ordering::Greater,
            Steps::Equal => one == other,
        }
    }

    /// Takes a node in, unless it is dominated; marks those that it dominates. True when it is in.
    pub(super) fn admit(&mut self, space: &Space, met: &mut [Met], new: &Met, number: u32) -> bool {
        let key = (new.node.actor, if self.steps == Steps::Equal { new.steps } else { 0 });
        let mut front = self.fronts.remove(&key).unwrap_or_default();
        let compared = front.len().saturating_sub(NODES_COMPARED);
        let dominated = front[compared..].iter().rev().any(|&known| {
            let known = &met[known as usize];
            self.may(known.steps, new.steps)
                && self.dominates(space, known.node.profile, new.node.profile)
        });
        if !dominated {
            let before = front.len();
            let mut place = 0;
            front.retain(|&known| {
                place += 1;
                if place <= compared {
                    return true;
                }
                let known = &mut met[known as usize];
                known.dominated = self.may(new.steps, known.steps)
                    && self.dominates(space, new.node.profile, known.node.profile);
                !known.dominated
            });
            front.push(number);
            self.len = self.len + front.len() - before;
        }
        self.fronts.insert(key, front);
        !dominated
    }

    /// Bytes in use, counted by contents.
    pub(super) fn bytes(&self) -> u64 {
        (4 * self.len + 40 * self.fronts.len()) as u64
    }
}
