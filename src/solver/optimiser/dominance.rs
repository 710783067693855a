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
use crate::belief::BeliefId;
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

/// How far nodes are compared. What is not compared is kept: more nodes than need be, never fewer.
#[derive(Debug, Clone, Copy)]
pub(super) struct Effort {
    /// Nodes compared with a new one, the latest first, at most.
    pub nodes: usize,
    /// States of the smaller belief, at most.
    pub states: usize,
}

/// Nodes that none met so far dominates, by actor component.
#[derive(Debug)]
pub(super) struct Antichain {
    relations: Vec<Relation>,
    steps: Steps,
    fronts: FxHashMap<(u32, u32), Vec<u32>>,
    len: usize,
    effort: Effort,
    /// By observer and belief: the remainders by 64 of its states' numbers, a bit each. A subset has
    /// no other bits, which mostly saves looking at the states.
    signatures: Vec<Vec<u64>>,
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
        effort: Effort,
    ) -> Option<Self> {
        let (relations, steps) = match policy {
            Policy::Sound => (relations(problem, bounds), steps),
            #[cfg(test)]
            Policy::Off => return None,
            #[cfg(test)]
            Policy::Careless => (relations(problem, &Bounds::default()), Steps::Any),
        };
        let signatures = vec![Vec::new(); problem.observers().len()];
        Some(Self { relations, steps, fronts: FxHashMap::default(), len: 0, effort, signatures })
    }

    /// Makes sure that the signatures of a profile's beliefs are known.
    fn sign(&mut self, space: &Space, profile: ProfileId) {
        for (observer, signatures) in self.signatures.iter_mut().enumerate() {
            let belief = space.joint.belief(profile, observer);
            if signatures.get(belief.index()).is_none_or(|signature| *signature == 0) {
                let members = space.joint.beliefs(observer).members(belief);
                // A set that is not listed is taken for a part of none.
                let signature = members.listed().map_or(u64::MAX, |list| {
                    list.iter().fold(0, |bits, state| bits | 1 << (state.index() % 64))
                });
                signatures.resize(signatures.len().max(belief.index() + 1), 0);
                signatures[belief.index()] = signature;
            }
        }
    }

    /// Whether the first of two profiles is at least as good.
    fn dominates(&self, space: &Space, one: ProfileId, other: ProfileId) -> bool {
        one == other
            || self.relations.iter().enumerate().all(|(observer, relation)| {
                let (a, b) =
                    (space.joint.belief(one, observer), space.joint.belief(other, observer));
                let (less, more) = match relation {
                    _ if a == b => return true,
                    Relation::Superset => (b, a),
                    Relation::Subset => (a, b),
                    Relation::Equal => return false,
                };
                let signature = |belief: BeliefId| self.signatures[observer][belief.index()];
                let members = |belief| space.joint.beliefs(observer).members(belief).listed();
                signature(less) & !signature(more) == 0
                    && members(less).zip(members(more)).is_some_and(|(less, more)| {
                        less.len() <= self.effort.states && is_subset(less, more)
                    })
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
        self.sign(space, new.node.profile);
        let mut front = self.fronts.remove(&key).unwrap_or_default();
        let compared = front.len().saturating_sub(self.effort.nodes);
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
        let signatures: usize = self.signatures.iter().map(Vec::len).sum();
        (4 * self.len + 40 * self.fronts.len() + 8 * signatures) as u64
    }
}
