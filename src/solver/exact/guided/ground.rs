//! What all passes share: the nodes met, the tables, and the best plan.

use fixedbitset::FixedBitSet;

use super::estimates::{Aim, Estimates};
use super::pass::Pass;
use super::twins::NEVER;
use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::{JointSpace, Node, SurvivorCounts};
use crate::solver::Bounds;
use crate::solver::exact::graph::Graph;
use crate::solver::exact::pairs::allowed;
use crate::solver::live::Live;
use crate::task::StateId;

/// How many nodes are visited between two looks at the memory.
const VISITS_BETWEEN_CHECKS: u64 = 64;
/// Most problems are solved in fewer visits than the longest way to a goal has steps. The tables of
/// doubts cost more than that; they are made when it turns out harder.
const VISITS_BEFORE_DOUBTS: u64 = 500;

/// The ground that passes go over.
#[derive(Debug)]
pub(super) struct Ground {
    pub(super) joint: JointSpace,
    pub(super) bounds: Bounds,
    pub(super) live: Live,
    pub(super) estimates: Estimates,
    pub(super) graph: Graph,
    /// For each number of actions the states from which a plan of exactly so many can end, as far
    /// as a horizon asks for.
    ending: Vec<FixedBitSet>,
    /// So many steps are known of the tables.
    reach: u32,
    pub(super) visits: u64,
    /// Bytes of passes that are not at work.
    pub(super) resting: u64,
    /// The best plan met.
    pub(super) best: Option<(SurvivorCounts, Plan)>,
}

impl Ground {
    pub(super) fn new(
        mut joint: JointSpace,
        bounds: Bounds,
        live: Live,
        estimates: Estimates,
        horizon: Option<usize>,
    ) -> Result<Self, LimitReached> {
        let graph = Graph::new(joint.initial());
        let mut ground = Self {
            joint,
            bounds,
            live,
            estimates,
            graph,
            ending: Vec::new(),
            reach: 0,
            visits: 0,
            resting: 0,
            best: None,
        };
        if let Some(horizon) = horizon {
            ground.find_endings(horizon)?;
        }
        Ok(ground)
    }

    /// Backwards from the goal.
    fn find_endings(&mut self, horizon: usize) -> Result<(), LimitReached> {
        let count = self.joint.states().len();
        let mut last = FixedBitSet::with_capacity(count);
        for state in 0..count {
            last.set(state, self.joint.is_goal(StateId(state as u32)));
        }
        self.ending.push(last);
        let limits = *self.joint.limits();
        limits.check_bytes(self.joint.bytes() + (horizon as u64 + 1) * count as u64 / 8)?;
        for after in 0..horizon {
            let mut ending = FixedBitSet::with_capacity(count);
            for state in 0..count {
                let edges = self.joint.states().edges(StateId(state as u32));
                let ends =
                    edges.iter().any(|edge| self.ending[after].contains(edge.target.index()));
                ending.set(state, ends);
            }
            self.ending.push(ending);
        }
        Ok(())
    }

    /// Whether a plan can end with exactly so many more actions from a node.
    pub(super) fn can_end(&self, node: usize, left: u32) -> bool {
        self.ending[left as usize].contains(self.graph.node(node).state.index())
    }

    pub(super) fn check_limits(&self, pass: &Pass) -> Result<(), LimitReached> {
        let limits = self.joint.limits();
        if self.visits.is_multiple_of(VISITS_BETWEEN_CHECKS) {
            let endings: usize = self.ending.iter().map(|states| states.len() / 8).sum();
            let own = self.joint.bytes() + self.graph.bytes() + self.estimates.bytes();
            limits.check_bytes(own + endings as u64 + self.resting + pass.bytes())?;
        }
        if self.visits >= limits.expansions {
            return Err(LimitReached::Expansions { limit: limits.expansions });
        }
        Ok(())
    }

    /// Takes note of a visit.
    pub(super) fn count_visit(&mut self) {
        self.visits += 1;
        if self.visits == VISITS_BEFORE_DOUBTS {
            self.estimates.add_doubts(&mut self.joint, &self.live);
        }
    }

    pub(super) fn least(&mut self, node: usize, aim: Aim) -> u32 {
        self.estimates.least(&self.joint, &self.live, self.graph.node(node), aim)
    }

    /// Makes the tables know all that takes at most so many steps.
    pub(super) fn reach(&mut self, until: u32) {
        if until > self.reach {
            self.reach = until;
            self.estimates.extend(until);
        }
    }

    /// Makes the tables know everything.
    pub(super) fn complete(&mut self) {
        self.reach(NEVER);
    }

    pub(super) fn expand(&mut self, node: usize) -> Result<(), LimitReached> {
        let live = &self.live;
        self.graph.expand(&mut self.joint, node, |state| live.contains(state))
    }

    /// What a plan that ends in a node is worth; none where no plan may end.
    pub(super) fn worth(&mut self, node: usize) -> Option<SurvivorCounts> {
        self.worth_of(self.graph.node(node))
    }

    fn worth_of(&mut self, node: Node) -> Option<SurvivorCounts> {
        if !self.joint.is_goal(node.state) {
            return None;
        }
        let counts = self.joint.counts(node.profile);
        allowed(&mut self.joint, &self.bounds, node.profile, counts).then_some(counts)
    }

    pub(super) fn is_better(&self, counts: SurvivorCounts) -> bool {
        let known = self.best.as_ref().map(|(known, _)| known.difference());
        known.is_none_or(|known| counts.difference() > known)
    }

    /// Makes one table after the other know what it says of the first node; false when there are no
    /// more.
    pub(super) fn settle(&mut self, number: usize, horizon: Option<usize>) -> bool {
        let most = horizon.map_or(NEVER, |horizon| horizon as u32);
        self.estimates.settle(number, &self.joint, self.graph.node(0), most)
    }

    /// Whether any plan reaches the true goal, whatever is believed.
    pub(super) fn can_reach_goal(&self, horizon: Option<usize>) -> bool {
        match horizon {
            Some(horizon) => self.can_end(0, horizon as u32),
            None => self.live.contains(self.graph.node(0).state),
        }
    }

    /// Follows a shortest way to the goal, or a way of the horizon's length, and takes note of the
    /// plan where it keeps the bounds. Goes on as long as `room` for believed states lasts.
    pub(super) fn follow_shortest(
        &mut self,
        horizon: Option<usize>,
        room: &mut usize,
    ) -> Result<(), LimitReached> {
        let mut node = self.graph.node(0);
        let mut plan = Plan::default();
        let distance = self.live.distance(node.state).unwrap_or_default();
        for left in (0..horizon.unwrap_or(distance)).rev() {
            let edges = self.joint.states().edges(node.state).iter();
            let leads = |state: StateId| match horizon {
                Some(_) => self.ending[left].contains(state.index()),
                None => self.live.distance(state) == Some(left),
            };
            let mut leading = edges.map(|edge| edge.target).filter(|&state| leads(state));
            let Some(target) = leading.next() else { return Ok(()) };
            for observer in 0..self.joint.problem().observers().len() {
                let belief = self.joint.belief(node.profile, observer);
                *room = room.saturating_sub(self.joint.beliefs(observer).members(belief).len());
            }
            if *room == 0 {
                return Ok(());
            }
            let mut found = Vec::new();
            self.joint.expand(node, |state| state == target, &mut found)?;
            let Some(&(action, next)) = found.first() else { return Ok(()) };
            plan.actions.push(action);
            node = next;
        }
        if let Some(counts) = self.worth_of(node) {
            self.best = Some((counts, plan));
        }
        Ok(())
    }
}
