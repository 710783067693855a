//! How long a plan through a node must still be, to be worth what is aimed at.
//!
//! No estimate says more than the truth, so a node whose estimate is more than the actions left, or
//! [`NEVER`], can be left out, and A* over them finds a shortest plan.

use super::bounds::listing::Listing;
use super::bounds::pairs::Pairs;
use super::space::{Actor, Node, Space};
use crate::limits::LimitReached;
use crate::problem::{JointSpace, Role};
use crate::solver::ground::endings::Endings;
use crate::solver::ground::goal_distances::{self, Combine, GoalDistances};
use crate::solver::ground::projections;
use crate::solver::ground::thresholds::STATES_OF_DISTANCES;
use crate::task::StateId;

/// There is no such plan.
pub(super) const NEVER: u32 = u32::MAX;

/// All that bounds a search from a node on.
#[derive(Debug)]
pub(super) struct Estimates {
    /// Never more than the true distances.
    distances: GoalDistances,
    endings: Option<Endings>,
    /// No plan is worth more.
    pub most: i64,
    nearest: Vec<u32>,
    /// By goal: how many of its facts one step can bring nearer.
    changed: Vec<u32>,
    /// Tables over pairs of states, where they have been made.
    pub pairs: Option<Box<Pairs>>,
}

impl Estimates {
    /// For a problem, at a horizon or over all lengths.
    pub(super) fn new(
        joint: &mut JointSpace,
        horizon: Option<usize>,
        most: i64,
    ) -> Result<Self, LimitReached> {
        let memory = joint.limits().bytes;
        let endings = match horizon {
            Some(horizon) => Endings::new(joint, horizon)?,
            None => None,
        };
        let distances = GoalDistances::new(joint.problem(), Combine::Max, memory);
        let changed = projections::changed_at_once(joint.problem());
        Ok(Self { distances, endings, most, nearest: Vec::new(), changed, pairs: None })
    }

    /// Lists all states for their true distances; false where that would take too much.
    pub(super) fn list(&mut self, space: &mut Space) -> Result<bool, LimitReached> {
        let goals = space.problem().goals().len();
        let most = STATES_OF_DISTANCES / goals;
        let Some(listing) = Listing::new(&mut space.joint, most)? else { return Ok(false) };
        let distances: Vec<Vec<u32>> =
            listing.by_goal.iter().map(|goal| listing.distances(&space.joint, goal)).collect();
        self.distances = GoalDistances::listed(space.problem(), &distances);
        Ok(true)
    }

    /// Whether the states from which a plan of the horizon can end are known.
    pub(super) fn knows_endings(&self) -> bool {
        self.endings.is_some()
    }

    /// Bytes in use, counted by contents.
    pub(super) fn bytes(&self) -> u64 {
        let pairs = self.pairs.as_ref().map_or(0, |pairs| pairs.bytes());
        self.distances.bytes() + self.endings.as_ref().map_or(0, Endings::bytes) + pairs
    }

    /// Whether a plan can end with exactly so many more actions from a node.
    pub(super) fn can_end(&self, actor: Actor, node: Node, left: u32) -> bool {
        match (&self.endings, actor) {
            (Some(endings), Actor::State) => endings.contains(StateId(node.actor), left as usize),
            _ => true,
        }
    }

    /// The node with beliefs trimmed to what can still matter.
    pub(super) fn trim(&mut self, space: &mut Space, actor: Actor, node: Node) -> Node {
        match (actor, &mut self.pairs) {
            (Actor::State, Some(pairs)) => {
                let profile = pairs.trim(space, StateId(node.actor), node.profile);
                Node { profile, ..node }
            }
            _ => node,
        }
    }

    /// The fewest actions of a plan from a node on that is worth the aim, perhaps with one observer
    /// alone looked at.
    pub(super) fn least(
        &mut self,
        space: &mut Space,
        actor: Actor,
        node: Node,
        aim: i64,
        alone: Option<usize>,
    ) -> u32 {
        if let (Actor::State, Some(pairs)) = (actor, &mut self.pairs) {
            return pairs.least(space, StateId(node.actor), node.profile, aim, alone);
        }
        self.distances.update(&space.joint);
        let problem = std::sync::Arc::clone(space.problem());
        let observers = problem.observers().len();
        let true_goal = problem.true_goal();
        let row = match actor {
            Actor::State => self.distances.of_state(StateId(node.actor)),
            Actor::Word => {
                let set = space.actor_states(actor, node);
                Some(self.distances.of_belief(observers, crate::belief::BeliefId(node.actor), set))
            }
        };
        let mut least = row.map_or(0, |row| steps(row[true_goal]));
        match space.distance(actor, node) {
            Some(sum) => least = least.max(sum.div_ceil(self.changed[true_goal])),
            None => return NEVER,
        }
        // With one survivor for the friends, an aim takes so many for the enemies.
        let needed = (aim + 1).max(space.bounds.at_least.unwrap_or(1) as i64).max(1);
        for (observer, watched) in problem.observers().iter().enumerate() {
            if watched.role != Role::Adversarial || alone.is_some_and(|alone| alone != observer) {
                continue;
            }
            let belief = space.joint.belief(node.profile, observer);
            let members = space.joint.beliefs(observer).members(belief);
            let row = self.distances.of_belief(observer, belief, members);
            let bounds = &space.bounds;
            for watched in bounds.required.iter().filter(|w| w.observer == observer) {
                least = least.max(steps(row[watched.goal]));
            }
            let forbidden = |goal: usize| {
                bounds.forbidden.iter().any(|w| w.observer == observer && w.goal == goal)
            };
            self.nearest.clear();
            let sums = space.guide.of_belief(observer, belief, members);
            let allowed = row.iter().zip(sums).enumerate().filter(|(goal, _)| !forbidden(*goal));
            let changed = &self.changed;
            self.nearest.extend(allowed.map(|(goal, (largest, sum))| match steps(*sum) {
                NEVER => NEVER,
                sum => steps(*largest).max(sum.div_ceil(changed[goal])),
            }));
            self.nearest.sort_unstable();
            let last = self.nearest.get(needed as usize - 1).copied().unwrap_or(NEVER);
            least = least.max(last);
        }
        least
    }
}

/// A distance as a number of steps.
fn steps(distance: u8) -> u32 {
    if distance == goal_distances::NEVER { NEVER } else { u32::from(distance) }
}
