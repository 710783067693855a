//! Best-first search over nodes: the one loop of the optimiser.
//!
//! What is looked for is a plan that is worth at least an *aim*. Over all lengths a node is met once;
//! at a horizon once after each number of steps.

use rustc_hash::FxHashMap;

use super::dominance::{Antichain, Effort, Policy, Steps};
use super::estimates::Estimates;
use super::order;
use super::queue::{BucketQueue, Ties};
use super::space::{Actor, Node, Space};
use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::SurvivorCounts;
use crate::solver::ground::thresholds::{
    NODES_COMPARED_TO_FIND, NODES_COMPARED_TO_PROVE, STATES_COMPARED_TO_FIND,
};
use crate::task::StateId;

/// A node that has been met.
#[derive(Debug, Clone, Copy)]
pub(super) struct Met {
    pub node: Node,
    pub parent: u32,
    /// A transition of the state space that leads here from the parent, or one that looks the same.
    pub edge: u32,
    pub steps: u32,
    /// Steps since the value last rose.
    pub since: u32,
    /// The best value on the way here.
    pub merit: i64,
    /// Another node is at least as good.
    pub dominated: bool,
}

/// In which order nodes are taken up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Order {
    /// The most promising first: to find good plans soon.
    Promise,
    /// The least length of a plan through the node first (A*): the first plan is a shortest one.
    Length,
    /// After the most steps first: at a horizon, where all plans are equally long.
    Depth,
}

/// How a search goes about it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Way {
    pub actor: Actor,
    pub order: Order,
    pub horizon: Option<u32>,
    /// Whether dominated nodes are left out.
    pub dominance: Policy,
    /// Plans must be shorter than this.
    pub shorter_than: u32,
    /// The one observer that is looked at, all others taken to end as well as can be: a relaxation.
    pub alone: Option<usize>,
}

/// What a step has come to.
#[derive(Debug)]
pub(super) enum Step {
    On,
    /// A plan that is worth more than what was aimed at before; the aim has been raised.
    Found(SurvivorCounts, Plan),
    /// No plan is left that is worth what is aimed at.
    Exhausted,
}

/// One search.
#[derive(Debug)]
pub(super) struct Search {
    way: Way,
    /// Plans must be worth at least this.
    pub aim: i64,
    met: Vec<Met>,
    /// By node, at a horizon also by steps: the fewest steps that lead there.
    known: FxHashMap<(Node, u32), u32>,
    queue: BucketQueue,
    antichain: Option<Antichain>,
    found: Vec<(u32, Node)>,
    begun: bool,
}

impl Search {
    pub(super) fn new(space: &Space, way: Way, aim: i64) -> Self {
        let ties = match way.order {
            Order::Promise => Ties::OldestFirst,
            Order::Length | Order::Depth => Ties::NewestFirst,
        };
        let steps = match (way.horizon, way.order) {
            (Some(_), _) => Steps::Equal,
            (None, Order::Length) => Steps::NoMore,
            (None, _) => Steps::Any,
        };
        let effort = match way.order {
            Order::Promise => {
                Effort { nodes: NODES_COMPARED_TO_FIND, states: STATES_COMPARED_TO_FIND }
            }
            Order::Length | Order::Depth => {
                Effort { nodes: NODES_COMPARED_TO_PROVE, states: usize::MAX }
            }
        };
        let (problem, bounds) = (space.problem(), &space.bounds);
        let antichain = Antichain::new(way.dominance, problem, bounds, steps, effort);
        Self {
            way,
            aim,
            met: Vec::new(),
            known: FxHashMap::default(),
            queue: BucketQueue::new(ties),
            antichain,
            found: Vec::new(),
            begun: false,
        }
    }

    /// How many nodes have been met.
    pub(super) fn len(&self) -> usize {
        self.met.len()
    }

    /// Bytes in use, counted by contents.
    pub(super) fn bytes(&self) -> u64 {
        let own = size_of::<Met>() * self.met.len() + 18 * self.known.len();
        let antichain = self.antichain.as_ref().map_or(0, Antichain::bytes);
        own as u64 + self.queue.bytes() + antichain
    }

    /// The actions that lead to a node.
    fn plan(&self, space: &mut Space, number: u32) -> Plan {
        let mut way = Vec::new();
        let mut number = number;
        loop {
            let met = &self.met[number as usize];
            way.push((met.edge, met.node));
            if met.steps == 0 {
                break;
            }
            number = met.parent;
        }
        way.reverse();
        space.plan(self.way.actor, &way)
    }

    /// What a plan that ends in a node achieves, as far as this search looks.
    fn worth(&self, space: &mut Space, node: Node) -> Option<SurvivorCounts> {
        match self.way.alone {
            None => space.worth(self.way.actor, node),
            Some(observer) => space.worth_alone(self.way.actor, node, observer),
        }
    }

    /// Meets a node. Returns what a plan that ends there achieves, where that is what is aimed at.
    fn meet(
        &mut self,
        space: &mut Space,
        estimates: &mut Estimates,
        mut new: Met,
    ) -> Option<SurvivorCounts> {
        let actor = self.way.actor;
        let left = match self.way.horizon {
            Some(horizon) => horizon.checked_sub(new.steps)?,
            None => self.way.shorter_than.checked_sub(new.steps + 1)?,
        };
        if self.way.horizon.is_some() && !estimates.can_end(actor, new.node, left) {
            return None;
        }
        new.node = estimates.trim(space, actor, new.node);
        if let Some(observer) = self.way.alone {
            new.node.profile = space.only(new.node.profile, observer);
        }
        let stage = if self.way.horizon.is_some() { new.steps } else { 0 };
        let reopens = self.way.order == Order::Length;
        let known = self.known.get(&(new.node, stage));
        if known.is_some_and(|steps| !reopens || *steps <= new.steps) {
            return None;
        }
        self.known.insert((new.node, stage), new.steps);
        let least = estimates.least(space, actor, new.node, self.aim, self.way.alone);
        if least > left {
            return None;
        }
        let ends = self.way.horizon.is_none_or(|horizon| horizon == new.steps);
        let worth = if ends { self.worth(space, new.node) } else { None };
        if let Some(counts) = worth {
            new.rise(counts.difference());
        } else if self.way.order == Order::Promise && space.reaches_goal(actor, new.node) {
            let value = space.joint.counts(new.node.profile).difference();
            new.rise(value - space.shortfall(new.node.profile));
        }
        let priority = match self.way.order {
            Order::Promise => order::promise(space, actor, &new, estimates.most)?,
            Order::Length => new.steps + least,
            Order::Depth => left,
        };
        let number = self.met.len() as u32;
        if let Some(antichain) = &mut self.antichain
            && !antichain.admit(space, &mut self.met, &new, number)
        {
            return None;
        }
        self.met.push(new);
        self.queue.push(priority, number);
        let now = self.way.order != Order::Length;
        worth.filter(|counts| now && counts.difference() >= self.aim)
    }

    /// Takes up the next node.
    pub(super) fn step(
        &mut self,
        space: &mut Space,
        estimates: &mut Estimates,
    ) -> Result<Step, LimitReached> {
        if !self.begun {
            self.begun = true;
            let node = space.root(self.way.actor);
            let root = Met {
                node,
                parent: 0,
                edge: 0,
                steps: 0,
                since: 0,
                merit: 1 - space.problem().goals().len() as i64,
                dominated: false,
            };
            if let Some(counts) = self.meet(space, estimates, root) {
                return Ok(self.found(space, counts, 0));
            }
        }
        let number = loop {
            let Some((_, number)) = self.queue.pop() else { return Ok(Step::Exhausted) };
            let met = &self.met[number as usize];
            let stale = self.way.order == Order::Length
                && self.known.get(&(met.node, 0)).is_some_and(|steps| *steps < met.steps);
            if !met.dominated && !stale {
                break number;
            }
        };
        let parent = self.met[number as usize];
        if self.way.order == Order::Length
            && let Some(counts) = self.worth(space, parent.node)
            && counts.difference() >= self.aim
        {
            return Ok(self.found(space, counts, number));
        }
        if self.way.horizon == Some(parent.steps) {
            return Ok(Step::On);
        }
        let mut successors = std::mem::take(&mut self.found);
        let keep = |state: StateId| match self.way.horizon {
            Some(horizon) => {
                let left = horizon - parent.steps - 1;
                let node = Node { actor: state.0, profile: parent.node.profile };
                estimates.can_end(Actor::State, node, left)
            }
            None => true,
        };
        let expanded = space.expand(self.way.actor, parent.node, keep, &mut successors);
        let mut best: Option<(SurvivorCounts, u32)> = None;
        for &(edge, node) in &successors {
            let new = Met {
                node,
                parent: number,
                edge,
                steps: parent.steps + 1,
                since: parent.since + 1,
                merit: parent.merit,
                dominated: false,
            };
            let Some(counts) = self.meet(space, estimates, new) else { continue };
            let better = best.is_none_or(|(known, _)| counts.difference() > known.difference());
            if better {
                best = Some((counts, self.met.len() as u32 - 1));
            }
        }
        self.found = successors;
        expanded?;
        Ok(best.map_or(Step::On, |(counts, number)| self.found(space, counts, number)))
    }

    fn found(&mut self, space: &mut Space, counts: SurvivorCounts, number: u32) -> Step {
        self.aim = counts.difference() + 1;
        Step::Found(counts, self.plan(space, number))
    }
}

impl Met {
    /// Takes note of a value.
    fn rise(&mut self, value: i64) {
        if value > self.merit {
            (self.merit, self.since) = (value, 0);
        }
    }
}
