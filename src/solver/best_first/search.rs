//! Heuristic search for a plan that keeps the bounds: Algorithm 1 of the paper, complete.
//!
//! A node is the actor's state with the full beliefs. What is closed is the state with a pair of
//! *approximate* beliefs of at most Δ states each, so that a round explores each state in as many
//! ways as there are such pairs; nodes for which no pair is left wait for the next round, with
//! Δ + 1. When Δ reaches the largest belief met, the pair is the full beliefs and the search has
//! seen every node: it answers "no plan" exactly when there is none.
//!
//! The printed algorithm closes the pair of beliefs alone. Two nodes whose beliefs agree and whose
//! states differ are then confused and plans are lost, so the key here holds the state as well.
//!
//! The value of a node is `h_GA(s) + h_{k−1}(B^X) − h_{n−j}(B^C)`: how far the true goal is from
//! the state, plus how far the k − 1 other goals nearest to the enemy's belief are, minus how far
//! the n − j other goals farthest from the friend's belief are (those are the ones to be ruled
//! out). Obfuscation has j = n and legibility k = 1, so that the last or the middle term is empty.

use std::sync::Arc;

use super::approximation::Approximations;
use super::engine::{Admission, BestFirst, SearchSpace};
use crate::heuristic::{GoalValues, UNREACHABLE};
use crate::limits::{LimitReached, Limits};
use crate::problem::{JointSpace, Node, Problem, Role};
use crate::solver::engine::Engine;
use crate::solver::outcome::Stats;
use crate::solver::prospects::Prospects;
use crate::solver::{Bounds, Options};
use crate::task::Action;

/// What a goal that cannot be reached any more counts as in a sum of values: more than goals in
/// problems of the paper's size are away, so that ruling one out for good is worth the way.
const UNREACHABLE_VALUE: i64 = 64;

/// A search that has found no plan after so many expansions works out what can still become of
/// beliefs, and drops the nodes that lead nowhere. Most find one earlier.
const EXPANSIONS_BEFORE_PROSPECTS: u64 = 256;

/// States with beliefs, and how many actions led to them where that matters.
#[derive(Debug)]
struct Beliefs {
    joint: JointSpace,
    values: GoalValues,
    approximations: Approximations,
    bounds: Bounds,
    horizon: Option<usize>,
    expansions: u64,
    prospects: Option<Prospects>,
    scratch: Vec<(Action, Node)>,
}

/// The search on a problem, for plans of any length or of exactly `horizon` actions.
pub(in crate::solver) fn engine(
    problem: Arc<Problem>,
    options: &Options,
    horizon: Option<usize>,
) -> impl Engine + use<> {
    let joint = JointSpace::new(problem, options.limits);
    BestFirst::new(Beliefs {
        values: GoalValues::new(&joint),
        approximations: Approximations::new(),
        bounds: options.heeded_bounds(),
        horizon,
        expansions: 0,
        prospects: None,
        scratch: Vec::new(),
        joint,
    })
}

impl Beliefs {
    /// Whether a node is known to lead nowhere.
    fn is_hopeless(&mut self, node: Node) -> bool {
        let prospects = self.prospects.as_mut();
        prospects.is_some_and(|known| known.are_hopeless(&self.joint, &self.bounds, node))
    }

    /// How far the goals are that the bounds ask for; none when they cannot be kept any more.
    fn value_of_bounds(&mut self, node: Node) -> Option<i64> {
        let problem = Arc::clone(self.joint.problem());
        let goals = problem.goals().len();
        let mut value = 0;
        for (index, observer) in problem.observers().iter().enumerate() {
            let wanted = match observer.role {
                Role::Adversarial => self.bounds.at_least.map_or(0, |k| k - 1),
                Role::Cooperative => self.bounds.at_most.map_or(0, |j| goals - j),
            };
            if wanted == 0 {
                continue;
            }
            let belief = self.joint.belief(node.profile, index);
            let in_full = GoalValues::is_evaluated_in_full(&self.joint, index, belief);
            let values = self.values.of_belief(&mut self.joint, index, belief);
            let others = (0..goals).filter(|&goal| goal != problem.true_goal());
            let mut values: Vec<i64> = others
                .map(|goal| match values[goal] {
                    UNREACHABLE => UNREACHABLE_VALUE,
                    value => i64::from(value).min(UNREACHABLE_VALUE - 1),
                })
                .collect();
            values.sort_unstable();
            match observer.role {
                Role::Adversarial => {
                    if in_full && values[wanted - 1] == UNREACHABLE_VALUE {
                        return None;
                    }
                    value += values[..wanted].iter().sum::<i64>();
                }
                Role::Cooperative => value -= values[goals - 1 - wanted..].iter().sum::<i64>(),
            }
        }
        Some(value)
    }
}

impl SearchSpace for Beliefs {
    /// The node, and the number of actions before it (0 where there is no horizon).
    type Key = (Node, u32);

    fn root(&mut self) -> Self::Key {
        (self.joint.initial(), 0)
    }

    fn is_goal(&mut self, (node, steps): Self::Key) -> bool {
        if self.horizon.is_some_and(|horizon| horizon != steps as usize)
            || !self.joint.is_goal(node.state)
        {
            return false;
        }
        let counts = self.joint.counts(node.profile);
        let sets = self.joint.survivor_sets(node.profile);
        self.bounds.allow(counts, &sets)
    }

    fn value(&mut self, (node, _): Self::Key) -> Option<i64> {
        let goal = self.joint.problem().true_goal();
        let to_goal = self.values.of_state(&self.joint, node.state)[goal];
        if to_goal == UNREACHABLE {
            return None;
        }
        if self.is_hopeless(node) {
            return None;
        }
        Some(i64::from(to_goal) + self.value_of_bounds(node)?)
    }

    /// How long a plan through the node is at least.
    fn second_value(&mut self, (node, _): Self::Key, depth: u32) -> Option<i64> {
        let to_goal = self.prospects.as_ref()?.distance(node.state)?;
        Some(i64::from(depth + to_goal))
    }

    fn expand(
        &mut self,
        (node, steps): Self::Key,
        found: &mut Vec<(Action, Self::Key)>,
    ) -> Result<(), LimitReached> {
        found.clear();
        let steps = match self.horizon {
            None => 0,
            Some(horizon) if steps as usize == horizon => return Ok(()),
            Some(_) => steps + 1,
        };
        self.expansions += 1;
        if self.expansions == EXPANSIONS_BEFORE_PROSPECTS {
            self.prospects = Prospects::new(&mut self.joint)?;
        }
        self.joint.expand(node, |_| true, &mut self.scratch)?;
        found.extend(self.scratch.iter().map(|&(action, node)| (action, (node, steps))));
        Ok(())
    }

    fn admit(&mut self, (node, steps): Self::Key) -> Admission {
        if self.is_hopeless(node) {
            Admission::Drop
        } else if self.approximations.close(&self.joint, node, steps) {
            Admission::Expand
        } else {
            Admission::Defer
        }
    }

    fn next_round(&mut self) {
        self.approximations.grow();
    }

    fn limits(&self) -> &Limits {
        self.joint.limits()
    }

    fn bytes(&self) -> u64 {
        let prospects = self.prospects.as_ref().map_or(0, Prospects::bytes);
        self.joint.bytes() + self.values.bytes() + self.approximations.bytes() + prospects
    }

    fn count(&self, stats: &mut Stats) {
        stats.count_spaces(&self.joint);
        stats.belief_size = self.approximations.size() as u64;
    }
}
