//! The search space: where the actor may be, with what every observer believes.
//!
//! A node is a profile of beliefs with an *actor component*, which is one of two things:
//!
//! - [`Actor::State`]: the actor's state. Good where much is known of pairs of states.
//! - [`Actor::Word`]: the states the actor may be in after the symbols seen so far. A joint observer
//!   that begins in the initial state alone and sees what all observers see takes the actor's
//!   place: its belief is the set of states that some plan with these symbols ends in, so the
//!   search runs over words of symbols and the plan is read off backwards. Where a friend's symbol
//!   determines those of all others and its initial belief is the initial state alone, the friend
//!   is that joint observer. Many states share a node then.

use std::sync::Arc;

use crate::belief::{BeliefId, Members, StateSets};
use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::{JointSpace, Problem, ProfileId, Role, SurvivorCounts};
use crate::solver::Bounds;
use crate::solver::ground::goal_distances::{Combine, GoalDistances, NEVER};
use crate::solver::ground::thresholds::WORK_OF_A_DIAGRAM;
use crate::solver::outcome::Stats;
use crate::task::{Action, StateId};

/// What stands for the actor in a node.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Actor {
    State,
    Word,
}

/// A node: the number of a state or of a set of states, and a profile.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Node {
    pub actor: u32,
    pub profile: ProfileId,
}

/// Successors that are not known yet.
const UNEXPANDED: u32 = u32::MAX;

/// All that is known of a problem, shared by the searches that the optimiser makes.
#[derive(Debug)]
pub(super) struct Space {
    pub joint: JointSpace,
    pub bounds: Bounds,
    /// The guide of the search.
    pub guide: GoalDistances,
    words: StateSets,
    /// Where the successors of each word set begin and end.
    rows: Vec<(u32, u32)>,
    successors: Vec<(u32, BeliefId)>,
    found: Vec<(u32, BeliefId)>,
    /// By word set: whether the true goal holds in a member; none where that is not known.
    ends: Vec<Option<bool>>,
    /// Believed states gone through: what the work is measured by.
    pub touched: u64,
}

impl Space {
    pub(super) fn new(joint: JointSpace, bounds: Bounds) -> Self {
        let guide = GoalDistances::new(joint.problem(), Combine::Sum, joint.limits().bytes);
        let words = StateSets::new(joint.problem().task(), joint.limits());
        Self {
            joint,
            bounds,
            guide,
            words,
            rows: Vec::new(),
            successors: Vec::new(),
            found: Vec::new(),
            ends: Vec::new(),
            touched: 0,
        }
    }

    pub(super) fn problem(&self) -> &Arc<Problem> {
        self.joint.problem()
    }

    /// Bytes in use, counted by contents.
    pub(super) fn bytes(&self) -> u64 {
        let own = 8 * self.successors.len() + 10 * self.rows.len();
        self.joint.bytes() + self.guide.bytes() + self.words.bytes() + own as u64
    }

    /// Counts the states and beliefs met.
    pub(super) fn count(&self, stats: &mut Stats) {
        stats.count_spaces(&self.joint);
    }

    /// The node before the first action.
    pub(super) fn root(&mut self, actor: Actor) -> Node {
        let root = self.joint.initial();
        let actor = match actor {
            Actor::State => root.state.0,
            Actor::Word => self.words.single(root.state).0,
        };
        self.guide.update(&self.joint);
        Node { actor, profile: root.profile }
    }

    /// The states the actor may be in.
    pub(super) fn actor_states(&self, actor: Actor, node: Node) -> Members<'_> {
        match actor {
            Actor::State => Members::Listed(&[]),
            Actor::Word => self.words.members(BeliefId(node.actor)),
        }
    }

    /// The estimated distance of the true goal from where the actor may be; none where it cannot be
    /// reached.
    pub(super) fn distance(&mut self, actor: Actor, node: Node) -> Option<u32> {
        let goal = self.problem().true_goal();
        let joint_observer = self.problem().observers().len();
        let distance = match actor {
            Actor::State => self.guide.of_state(StateId(node.actor)).map_or(0, |row| row[goal]),
            Actor::Word => {
                let set = BeliefId(node.actor);
                self.guide.of_belief(joint_observer, set, self.words.members(set))[goal]
            }
        };
        (distance != NEVER).then_some(u32::from(distance))
    }

    /// The estimated distance of each goal from what an observer believes.
    pub(super) fn distances_of_belief(&mut self, observer: usize, profile: ProfileId) -> &[u8] {
        let belief = self.joint.belief(profile, observer);
        let members = self.joint.beliefs(observer).members(belief);
        self.guide.of_belief(observer, belief, members)
    }

    /// Whether a plan may end in a node as far as the actor is concerned.
    pub(super) fn reaches_goal(&mut self, actor: Actor, node: Node) -> bool {
        if actor == Actor::State {
            return self.joint.is_goal(StateId(node.actor));
        }
        if let Some(Some(known)) = self.ends.get(node.actor as usize) {
            return *known;
        }
        let ends = match self.words.members(BeliefId(node.actor)) {
            Members::Listed(list) => list.iter().any(|state| self.joint.is_goal(*state)),
            Members::Diagram(diagrams, set) => {
                let problem = self.joint.problem();
                diagrams.satisfies(set, &problem.goals()[problem.true_goal()].condition)
            }
        };
        self.ends.resize(self.ends.len().max(node.actor as usize + 1), None);
        self.ends[node.actor as usize] = Some(ends);
        ends
    }

    /// Whether a profile keeps the bounds in the end.
    fn allowed(&mut self, profile: ProfileId, counts: SurvivorCounts) -> bool {
        if self.bounds.required.is_empty() && self.bounds.forbidden.is_empty() {
            return self.bounds.allow(counts, &[]);
        }
        let sets = self.joint.survivor_sets(profile);
        self.bounds.allow(counts, &sets)
    }

    /// What a plan that ends in a node achieves; none where no plan may end there.
    pub(super) fn worth(&mut self, actor: Actor, node: Node) -> Option<SurvivorCounts> {
        if !self.reaches_goal(actor, node) {
            return None;
        }
        let counts = self.joint.counts(node.profile);
        self.allowed(node.profile, counts).then_some(counts)
    }

    /// The profile in which all observers but one believe what they did at first.
    pub(super) fn only(&mut self, profile: ProfileId, observer: usize) -> ProfileId {
        let belief = self.joint.belief(profile, observer);
        let first = self.joint.initial().profile;
        let observers = 0..self.problem().observers().len();
        let beliefs: Vec<BeliefId> = observers
            .map(|other| if other == observer { belief } else { self.joint.belief(first, other) })
            .collect();
        self.joint.profile(beliefs)
    }

    /// What a plan that ends in a node achieves at best, where one observer alone is looked at; none
    /// where the plan may not end there for that observer.
    pub(super) fn worth_alone(
        &mut self,
        actor: Actor,
        node: Node,
        observer: usize,
    ) -> Option<SurvivorCounts> {
        if !self.reaches_goal(actor, node) {
            return None;
        }
        let goals = self.problem().goals().len();
        let role = self.problem().observers()[observer].role;
        let belief = self.joint.belief(node.profile, observer);
        let survivors = self.joint.survivors(observer, belief);
        let (bounds, count) = (&self.bounds, survivors.len());
        let here = |watched: &&crate::solver::Watched| watched.observer == observer;
        let kept = bounds.required.iter().filter(here).all(|w| survivors.contains(w.goal))
            && !bounds.forbidden.iter().filter(here).any(|w| survivors.contains(w.goal));
        let (fits, counts) = match role {
            Role::Adversarial => (
                bounds.at_least.is_none_or(|k| count >= k),
                SurvivorCounts { adversarial: count, cooperative: 1 },
            ),
            Role::Cooperative => (
                bounds.at_most.is_none_or(|j| count <= j),
                SurvivorCounts { adversarial: goals, cooperative: count },
            ),
        };
        (kept && fits).then_some(counts)
    }

    /// By how much final beliefs like those of a profile break the bounds: a guide.
    pub(super) fn shortfall(&mut self, profile: ProfileId) -> i64 {
        let counts = self.joint.counts(profile);
        let k = self.bounds.at_least.map_or(0, |k| k.saturating_sub(counts.adversarial));
        let j = self.bounds.at_most.map_or(0, |j| counts.cooperative.saturating_sub(j));
        let mut missing = k + j;
        if !self.bounds.required.is_empty() || !self.bounds.forbidden.is_empty() {
            let sets = self.joint.survivor_sets(profile);
            let holds = |w: &&crate::solver::Watched| sets[w.observer].contains(w.goal);
            missing += self.bounds.required.iter().filter(|w| !holds(w)).count();
            missing += self.bounds.forbidden.iter().filter(holds).count();
        }
        missing as i64
    }

    /// Writes the nodes that follow a node into `found`, each with what leads there: a transition from a state, a combination
    /// of symbols from a word.
    pub(super) fn expand(
        &mut self,
        actor: Actor,
        node: Node,
        keep: impl Fn(StateId) -> bool,
        found: &mut Vec<(u32, Node)>,
    ) -> Result<(), LimitReached> {
        found.clear();
        self.touched += 1;
        match actor {
            Actor::State => {
                let state = StateId(node.actor);
                self.joint.states_mut().expand(state);
                for edge in self.joint.states().edge_range(state) {
                    let target = self.joint.states().all_edges()[edge].target;
                    if keep(target) {
                        let profile = self.joint.profile_after(node.profile, edge)?;
                        found.push((edge as u32, Node { actor: target.0, profile }));
                    }
                }
            }
            Actor::Word => {
                let (begin, end) = self.word_successors(BeliefId(node.actor))?;
                for observer in 0..self.problem().observers().len() {
                    let belief = self.joint.belief(node.profile, observer);
                    self.touched += work(self.joint.beliefs(observer).members(belief));
                }
                self.joint.update_all(node.profile)?;
                for place in begin..end {
                    let (combination, set) = self.successors[place as usize];
                    let profile =
                        self.joint.profile_after_combination(node.profile, combination)?;
                    found.push((combination, Node { actor: set.0, profile }));
                }
            }
        }
        self.guide.update(&self.joint);
        Ok(())
    }

    /// Where the successors of a word set lie, worked out once.
    fn word_successors(&mut self, set: BeliefId) -> Result<(u32, u32), LimitReached> {
        self.rows.resize(self.words.len(), (UNEXPANDED, 0));
        let known = self.rows[set.index()];
        if known.0 != UNEXPANDED {
            return Ok(known);
        }
        self.touched += work(self.words.members(set));
        let limits = *self.joint.limits();
        let others = self.joint.bytes() - self.joint.states().bytes();
        self.words.expand_members(self.joint.states_mut(), set, &limits, others)?;
        self.joint.word_images(&mut self.words, set, &mut self.found)?;
        let begin = self.successors.len() as u32;
        self.successors.extend_from_slice(&self.found);
        let row = (begin, self.successors.len() as u32);
        self.rows.resize(self.words.len(), (UNEXPANDED, 0));
        self.rows[set.index()] = row;
        Ok(row)
    }

    /// The plan along nodes from the root, each but the first with what leads to it.
    pub(super) fn plan(&mut self, actor: Actor, way: &[(u32, Node)]) -> Plan {
        if actor == Actor::State {
            let edges = self.joint.states().all_edges();
            let taken = way.iter().skip(1).map(|(edge, _)| edges[*edge as usize].action);
            return Plan { actions: taken.collect() };
        }
        let Some((_, last)) = way.last() else { return Plan::default() };
        let Some(mut target) = self.end_of_word(BeliefId(last.actor)) else {
            return Plan::default();
        };
        let mut actions: Vec<Action> = Vec::new();
        for pair in way.windows(2).rev() {
            let (before, (combination, _)) = (pair[0].1, pair[1]);
            let set = BeliefId(before.actor);
            let Some((state, action)) =
                self.joint.word_predecessor(&self.words, set, combination, target)
            else {
                return Plan::default();
            };
            actions.push(action);
            target = state;
        }
        actions.reverse();
        Plan { actions }
    }

    /// A state of a word set in which the true goal holds.
    fn end_of_word(&mut self, set: BeliefId) -> Option<StateId> {
        match self.words.members(set) {
            Members::Listed(list) => list.iter().copied().find(|state| self.joint.is_goal(*state)),
            Members::Diagram(diagrams, set) => {
                let problem = self.joint.problem();
                let state = diagrams.find(set, &problem.goals()[problem.true_goal()].condition)?;
                Some(self.joint.states_mut().intern(&state))
            }
        }
    }
}

/// How much work a set is, in states.
fn work(members: Members<'_>) -> u64 {
    match members {
        Members::Listed(list) => list.len() as u64,
        Members::Diagram(..) => WORK_OF_A_DIAGRAM,
    }
}
