//! Looks for a shortest plan that fulfils one hope.
//!
//! Nodes hold *trimmed* beliefs: of the enemy's only the states that can still be led to a goal that
//! should survive, of the friend's only those that can still be led to one that should die. What is
//! left out makes no difference to the hope. Beliefs that differ in nothing else become one.
//!
//! A node is left out when another one in the same state, met after no more actions, is at least as
//! good: the enemy believes all that it believes here, the friend no more. Updates keep such an
//! order, so whatever plan goes on from this node goes on from that one and ends no worse.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;

use super::hope::Hope;
use super::tables::Tables;
use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::{JointSpace, Node};
use crate::solver::exact::guided::twins::NEVER;
use crate::solver::live::Live;
use crate::task::{Action, StateId};

/// A node met, with the way to it.
#[derive(Debug, Clone, Copy)]
struct Met {
    node: Node,
    parent: u32,
    action: Action,
    steps: u32,
    /// Another one is at least as good.
    beaten: bool,
}

/// How a step of a pass went.
#[derive(Debug)]
pub(super) enum Went {
    On,
    /// A shortest plan.
    Found(Plan),
    /// There is none, or none shorter than asked for.
    Nowhere,
}

/// A search with estimates that never say too much (A*), the deepest of equal nodes first.
#[derive(Debug)]
pub(super) struct Pass {
    pub(super) hope: Hope,
    met: Vec<Met>,
    open: BTreeMap<u32, Vec<u32>>,
    /// By state, those that are not beaten.
    fronts: FxHashMap<StateId, Vec<u32>>,
    found: Vec<(Action, Node)>,
    begun: bool,
    /// Believed states compared.
    pub(super) compared: u64,
}

/// Whether all of the first are among the second. Both are sorted.
fn among(some: &[StateId], all: &[StateId], compared: &mut u64) -> bool {
    if some.len() > all.len() {
        return false;
    }
    let mut rest = all.iter();
    let found = some.iter().all(|state| rest.by_ref().find(|other| *other >= state) == Some(state));
    *compared += (all.len() - rest.len()) as u64;
    found
}

impl Pass {
    pub(super) fn new(hope: Hope) -> Self {
        Self {
            hope,
            met: Vec::new(),
            open: BTreeMap::new(),
            fronts: FxHashMap::default(),
            found: Vec::new(),
            begun: false,
            compared: 0,
        }
    }

    pub(super) fn generated(&self) -> usize {
        self.met.len()
    }

    /// Bytes in use, counted by contents.
    pub(super) fn bytes(&self) -> u64 {
        ((size_of::<Met>() + 8) * self.met.len()) as u64
    }

    /// Whether the first of two nodes in one state is at least as good as the second.
    fn beats(&mut self, joint: &JointSpace, tables: &Tables, one: Node, other: Node) -> bool {
        let members = |node: Node, observer: usize| {
            joint.beliefs(observer).members(joint.belief(node.profile, observer))
        };
        let (x, c) = (tables.enemy, tables.friend);
        one.profile == other.profile
            || among(members(one, c), members(other, c), &mut self.compared)
                && among(members(other, x), members(one, x), &mut self.compared)
    }

    /// Opens a node, unless it is hopeless or another one is as good.
    fn meet(
        &mut self,
        joint: &mut JointSpace,
        tables: &mut Tables,
        live: &Live,
        node: Node,
        way: (u32, Action, u32),
    ) {
        let Some(distance) = live.distance(node.state) else { return };
        let (parent, action, steps) = way;
        let belief = |joint: &JointSpace, observer| joint.belief(node.profile, observer);
        let (x, c) = (belief(joint, tables.enemy), belief(joint, tables.friend));
        let (x, soonest) = tables.alive(joint, &self.hope.alive, node.state, x);
        let (c, least) = tables.dead(joint, &self.hope.dead, node.state, c, distance as u32);
        let least = least.max(soonest).max(distance as u32);
        if least == NEVER {
            return;
        }
        let beliefs = if tables.enemy < tables.friend { [x, c] } else { [c, x] };
        let node = Node { state: node.state, profile: joint.profile(beliefs) };
        let front = self.fronts.remove(&node.state).unwrap_or_default();
        let beaten = front.iter().any(|&place| {
            let known = self.met[place as usize];
            known.steps <= steps && self.beats(joint, tables, known.node, node)
        });
        let mut kept = front;
        if !beaten {
            kept.retain(|&place| {
                let known = self.met[place as usize];
                let beaten = steps <= known.steps && self.beats(joint, tables, node, known.node);
                self.met[place as usize].beaten = beaten;
                !beaten
            });
            let place = self.met.len() as u32;
            kept.push(place);
            self.met.push(Met { node, parent, action, steps, beaten: false });
            self.open.entry(steps + least).or_default().push(place);
        }
        self.fronts.insert(node.state, kept);
    }

    fn fulfils(&self, joint: &mut JointSpace, tables: &Tables, node: Node) -> bool {
        if !joint.is_goal(node.state) {
            return false;
        }
        let (x, c) = (tables.enemy, tables.friend);
        let enemy = joint.survivors(x, joint.belief(node.profile, x)).clone();
        let friend = joint.survivors(c, joint.belief(node.profile, c));
        self.hope.alive.iter().all(|&goal| enemy.contains(goal))
            && !self.hope.dead.iter().any(|&goal| friend.contains(goal))
    }

    fn plan(&self, mut place: u32) -> Plan {
        let mut actions = Vec::new();
        while place != 0 {
            let met = &self.met[place as usize];
            actions.push(met.action);
            place = met.parent;
        }
        actions.reverse();
        Plan { actions }
    }

    /// Expands the next node; plans of `shorter_than` actions and more are of no interest.
    pub(super) fn step(
        &mut self,
        joint: &mut JointSpace,
        tables: &mut Tables,
        live: &Live,
        shorter_than: u32,
    ) -> Result<Went, LimitReached> {
        if !self.begun {
            self.begun = true;
            let root = joint.initial();
            self.meet(joint, tables, live, root, (0, Action::new(0), 0));
        }
        let next = loop {
            let Some(mut least) = self.open.first_entry() else { return Ok(Went::Nowhere) };
            if *least.key() >= shorter_than {
                return Ok(Went::Nowhere);
            }
            match least.get_mut().pop() {
                None => drop(least.remove()),
                Some(place) if self.met[place as usize].beaten => {}
                Some(place) => break place,
            }
        };
        let Met { node, steps, .. } = self.met[next as usize];
        if self.fulfils(joint, tables, node) {
            return Ok(Went::Found(self.plan(next)));
        }
        let mut found = std::mem::take(&mut self.found);
        joint.expand(node, |state| live.contains(state), &mut found)?;
        for &(action, node) in &found {
            self.meet(joint, tables, live, node, (next, action, steps + 1));
        }
        self.found = found;
        Ok(Went::On)
    }
}
