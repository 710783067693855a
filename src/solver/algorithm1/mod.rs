//! Algorithm 1 of the paper: greedy best-first search for a plan that keeps the bounds, complete.
//!
//! A node is the actor's state with the beliefs, of which it carries [samples](belief_samples) until
//! the full ones are needed. What is [closed](closed_list) is the state with a pair of
//! *approximate* beliefs of at most Δ states each, so that a round explores each state in as many
//! ways as there are such pairs; nodes for which no pair is left wait for the next round, with
//! Δ + 1. When Δ reaches the largest belief met, the pair is the full beliefs and the search has
//! seen every node: it answers "no plan" exactly when there is none.
//!
//! The printed algorithm closes the pair of beliefs alone. Two nodes whose beliefs agree and whose
//! states differ are then confused and plans are lost, so the key here holds the state as well.
//!
//! The first round needs no full belief, since a subset of one state is the true state: it expands
//! each state once, and works full beliefs out where a state satisfies the true goal and the
//! samples do not settle the bounds. From the second round on a node that waited is looked at with
//! its full beliefs: it is left out where the same state with the same beliefs was expanded, by
//! another way to them.
//!
//! The value of a node is `h_GA(s) + h_{k−1}(B^X) − h_{n−j}(B^C)`: how far the true goal is from
//! the state, plus how far the k − 1 other goals nearest to the enemy's belief are, minus how far
//! the n − j other goals farthest from the friend's belief are (those are the ones to be ruled
//! out). Obfuscation has j = n and legibility k = 1, so that the last or the middle term is empty.

mod belief_samples;
mod closed_list;

use std::sync::Arc;

use rustc_hash::FxHashSet;

use super::ground::best_first::{Admission, BestFirst, SearchSpace};
use super::ground::stages::{Cheapest, Stages};
use crate::goal_difference::GoalSet;
use crate::heuristic::{GoalValues, UNREACHABLE};
use crate::limits::{LimitReached, Limits};
use crate::problem::{JointSpace, Node, Problem, Role, Tuples};
use crate::solver::engine::Engine;
use crate::solver::ground::thresholds::UNREACHABLE_VALUE;
use crate::solver::outcome::Stats;
use crate::solver::{Bounds, Options};
use crate::task::{Action, StateId};
use belief_samples::{BeliefSamples, SampleId};
use closed_list::ClosedList;

/// The actor's state, the number of the samples of all observers, and the [stage](Stages).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Key {
    state: StateId,
    samples: u32,
    stage: u32,
}

/// States with beliefs.
#[derive(Debug)]
struct Beliefs {
    joint: JointSpace,
    values: GoalValues,
    samples: Vec<BeliefSamples>,
    /// One sample for each observer.
    combinations: Tuples,
    closed_list: ClosedList,
    /// What was expanded with full beliefs known.
    expanded: FxHashSet<(Node, u32)>,
    bounds: Bounds,
    stages: Stages,
    cheapest: Cheapest<(StateId, u32)>,
    scratch: Vec<u32>,
}

/// The search on a problem, for plans of any length or of exactly `horizon` actions. With `listed_only` it ends with the
/// memory limit where a belief outgrows its list.
pub(in crate::solver) fn engine(
    problem: Arc<Problem>,
    options: &Options,
    horizon: Option<usize>,
    listed_only: bool,
) -> impl Engine + use<> {
    let mut joint = JointSpace::new(problem, options.limits);
    if listed_only {
        joint.keep_listed();
    }
    let observers = joint.problem().observers().len();
    BestFirst::new(Beliefs {
        values: GoalValues::new(&joint),
        samples: (0..observers).map(|observer| BeliefSamples::new(&joint, observer)).collect(),
        combinations: Tuples::new(observers),
        closed_list: ClosedList::new(),
        expanded: FxHashSet::default(),
        bounds: options.heeded_bounds(),
        stages: Stages::new(joint.problem().task(), horizon, options.cost_limit),
        cheapest: Cheapest::new(),
        scratch: Vec::new(),
        joint,
    })
}

impl Beliefs {
    fn sample(&self, key: Key, observer: usize) -> SampleId {
        SampleId(self.combinations.get(key.samples)[observer])
    }

    /// How far the goals are that the bounds ask for; none when they cannot be kept any more.
    fn value_of_bounds(&mut self, key: Key) -> Option<i64> {
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
            let sample = self.sample(key, index);
            let whole = self.samples[index].whole(&self.joint, sample).is_some();
            let values = self.samples[index].values(&mut self.joint, &mut self.values, sample);
            let others = (0..goals).filter(|&goal| goal != problem.true_goal());
            // As u32, of which the wasm file has a sort already.
            let mut values: Vec<u32> = others
                .map(|goal| match values[goal] {
                    UNREACHABLE => UNREACHABLE_VALUE,
                    value => value.min(UNREACHABLE_VALUE - 1),
                })
                .collect();
            values.sort_unstable();
            match observer.role {
                Role::Adversarial => {
                    if whole && values[wanted - 1] == UNREACHABLE_VALUE {
                        return None;
                    }
                    value += values[..wanted].iter().copied().map(i64::from).sum::<i64>();
                }
                Role::Cooperative => {
                    let farthest = &values[goals - 1 - wanted..];
                    value -= farthest.iter().copied().map(i64::from).sum::<i64>();
                }
            }
        }
        Some(value)
    }

    /// Whether the bounds are kept. What a sample settles is settled without the full belief, and a
    /// friend's, which is mostly smaller, is worked out before an enemy's.
    fn keeps_bounds(&mut self, key: Key) -> Result<bool, LimitReached> {
        let problem = Arc::clone(self.joint.problem());
        let goals = problem.goals().len();
        let (mut unsettled, mut enemies) = (Vec::new(), Vec::new());
        for (index, observer) in problem.observers().iter().enumerate() {
            let sample = self.sample(key, index);
            let surely = self.samples[index].survivors(&mut self.joint, &mut self.values, sample);
            if self.breaks_an_upper_bound(index, observer.role, &surely) {
                return Ok(false);
            }
            let upper = self.bounds.forbidden.iter().any(|watched| watched.observer == index)
                || observer.role == Role::Cooperative
                    && self.bounds.at_most.is_some_and(|j| j < goals);
            let missing = self
                .bounds
                .required
                .iter()
                .any(|w| w.observer == index && !surely.contains(w.goal))
                || observer.role == Role::Adversarial
                    && self.bounds.at_least.is_some_and(|k| surely.len() < k);
            if upper || missing {
                match observer.role {
                    Role::Cooperative => unsettled.push(index),
                    Role::Adversarial => enemies.push(index),
                }
            }
        }
        unsettled.append(&mut enemies);
        for index in unsettled {
            let sample = self.sample(key, index);
            let belief = self.samples[index].belief(&mut self.joint, sample)?;
            let survivors = self.joint.survivors(index, belief).clone();
            let role = problem.observers()[index].role;
            let enough = role != Role::Adversarial
                || self.bounds.at_least.is_none_or(|k| survivors.len() >= k);
            let required = self.bounds.required.iter().filter(|w| w.observer == index);
            let all = required.map(|w| w.goal).all(|goal| survivors.contains(goal));
            if !enough || !all || self.breaks_an_upper_bound(index, role, &survivors) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Whether too many goals survive, or one that must not.
    fn breaks_an_upper_bound(&self, observer: usize, role: Role, survivors: &GoalSet) -> bool {
        let forbidden = self.bounds.forbidden.iter().filter(|w| w.observer == observer);
        role == Role::Cooperative && self.bounds.at_most.is_some_and(|j| survivors.len() > j)
            || forbidden.map(|w| w.goal).any(|goal| survivors.contains(goal))
    }
}

impl SearchSpace for Beliefs {
    type Key = Key;

    fn root(&mut self) -> Key {
        let Node { state, profile } = self.joint.initial();
        self.scratch.clear();
        for (index, samples) in self.samples.iter_mut().enumerate() {
            let belief = self.joint.belief(profile, index);
            self.scratch.push(samples.of_belief(&mut self.joint, &mut self.values, belief).0);
        }
        Key { state, samples: self.combinations.intern(&self.scratch), stage: Stages::FIRST }
    }

    fn is_goal(&mut self, key: Key) -> Result<bool, LimitReached> {
        if !self.stages.may_end(key.stage) || !self.joint.is_goal(key.state) {
            return Ok(false);
        }
        self.keeps_bounds(key)
    }

    fn value(&mut self, key: Key) -> Option<i64> {
        let goal = self.joint.problem().true_goal();
        let to_goal = self.values.of_state(&self.joint, key.state)[goal];
        if to_goal == UNREACHABLE {
            return None;
        }
        Some(i64::from(to_goal) + self.value_of_bounds(key)?)
    }

    fn expand(&mut self, key: Key, found: &mut Vec<(Action, Key)>) -> Result<(), LimitReached> {
        found.clear();
        if self.stages.is_last(key.stage) {
            return Ok(());
        }
        self.joint.states_mut().expand(key.state);
        for edge in self.joint.states().edge_range(key.state) {
            let taken = self.joint.states().all_edges()[edge];
            let Some(stage) = self.stages.after(key.stage, taken.action) else { continue };
            self.scratch.clear();
            for (index, samples) in self.samples.iter_mut().enumerate() {
                let before = SampleId(self.combinations.get(key.samples)[index]);
                let symbol = self.joint.symbol(index, edge);
                let (joint, values) = (&mut self.joint, &mut self.values);
                let next = samples.follow(joint, values, before, symbol, taken.target)?;
                self.scratch.push(next.0);
            }
            let samples = self.combinations.intern(&self.scratch);
            if self.cheapest.admit(&self.stages, (taken.target, samples), stage) {
                found.push((taken.action, Key { state: taken.target, samples, stage }));
            }
        }
        Ok(())
    }

    fn admit(&mut self, key: Key) -> Result<Admission, LimitReached> {
        let observers = self.samples.len();
        let whole = (0..observers)
            .all(|i| self.samples[i].whole(&self.joint, self.sample(key, i)).is_some());
        if self.closed_list.size() == 1 && !whole {
            let new = self.closed_list.close_state(key.state, observers, key.stage);
            return Ok(if new { Admission::Expand } else { Admission::Defer });
        }
        let mut beliefs = Vec::with_capacity(observers);
        for index in 0..observers {
            let sample = self.sample(key, index);
            beliefs.push(self.samples[index].belief(&mut self.joint, sample)?);
        }
        let node = Node { state: key.state, profile: self.joint.profile(beliefs) };
        if self.expanded.contains(&(node, key.stage)) {
            return Ok(Admission::Drop);
        }
        if !self.closed_list.close(&mut self.joint, node, key.stage) {
            return Ok(Admission::Defer);
        }
        self.expanded.insert((node, key.stage));
        Ok(Admission::Expand)
    }

    fn next_round(&mut self) {
        self.closed_list.grow();
    }

    fn limits(&self) -> &Limits {
        self.joint.limits()
    }

    fn bytes(&self) -> u64 {
        let samples: u64 = self.samples.iter().map(BeliefSamples::bytes).sum();
        let expanded = (size_of::<(Node, u32)>() + 1) * self.expanded.len();
        let beliefs = self.joint.bytes() + self.values.bytes() + self.combinations.bytes();
        let stages = self.stages.bytes() + self.cheapest.bytes();
        beliefs + samples + expanded as u64 + self.closed_list.bytes() + stages
    }

    fn count(&self, stats: &mut Stats) {
        stats.count_spaces(&self.joint);
        stats.belief_size = self.closed_list.size() as u64;
    }
}
