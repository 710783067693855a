//! Parallel walks: plans with walks beside them that show the enemies the same.
//!
//! A goal in which such a walk ends survives for the enemy. So a plan and its walks are looked for together, as in the
//! self-composition of the task (Barthe, D'Argenio and Rezk 2004, doi:10.1109/CSFW.2004.17), one component after the other:
//! first a plan along a [route](routes) of goals, made of greedy [legs](legs), then for each enemy and other goal the
//! [walkers](walkers), a beam search that follows what the enemy sees of the plan.
//!
//! No enemy's belief is ever worked out. A friend's belief is bounded from above by its
//! [pairs of values](crate::belief::pairwise); only where these leave too many goals open is it worked out, as long as it can
//! be listed.
//!
//! The search is not complete: where its routes come to their end, nothing is proved.

mod estimates;
mod legs;
mod routes;
#[cfg(test)]
mod tests;
mod walkers;

use std::sync::Arc;

use rustc_hash::FxHashMap;

use self::estimates::GoalEstimates;
use self::legs::{Effort, Evaluation, LegSearch, LegStep};
use self::walkers::Walkers;
use super::engine::{Advance, Engine, Finding};
use super::outcome::{Progress, Stats, Status};
use super::{Bounds, Options};
use crate::belief::pairwise::PairwiseUpdates;
use crate::goal_difference::GoalSet;
use crate::limits::{LimitReached, Limits};
use crate::plan::Plan;
use crate::problem::{JointSpace, Problem, Role};
use crate::sensor::Symbol;
use crate::solver::ground::thresholds::{
    BEAM_WIDER, BEAM_WIDTH, BEAM_WIDTH_AT_MOST, EVALUATIONS_BESIDE,
};
use crate::task::StateId;
use crate::trace::{Witness, open_goals};

/// The engine.
pub(in crate::solver) struct ParallelWalks {
    joint: JointSpace,
    bounds: Bounds,
    limits: Limits,
    estimates: GoalEstimates,
    routes: Box<dyn Iterator<Item = Vec<usize>> + Send>,
    /// States of a beam, at most.
    width: usize,
    /// How legs are looked for: for each width in one way and then in the other.
    evaluation: Evaluation,
    /// By state and goal: the transitions of a leg and its end.
    legs: FxHashMap<(StateId, usize, Evaluation), Leg>,
    /// By observer, none for a friend: one for each goal but the true one, the nearest first.
    walkers: Vec<Option<Vec<Walkers>>>,
    /// By observer, none for an enemy and where there are too many pairs.
    pairs: Vec<Option<PairwiseUpdates>>,
    stage: Stage,
    tried: u64,
    /// How often each means settled something.
    counts: Stats,
}

/// Transitions and the state they end in, where a leg was found.
type Leg = Option<(Vec<usize>, StateId)>;

/// What is worked on.
#[derive(Debug)]
enum Stage {
    /// The next leg of a route from the end of those before it: the transitions so far, their end and the goals ahead.
    Leg(Vec<usize>, StateId, Vec<usize>),
    /// The search for that leg, which is not known yet.
    Search(Box<LegSearch>, Vec<usize>, StateId, Vec<usize>),
    /// What friends hold possible at the end of a plan.
    Friends(Vec<usize>),
    /// The walks beside a plan: of one enemy and goal.
    Walk(Vec<usize>, Vec<Witness>, usize, usize),
    Found(Plan, Vec<Witness>),
    /// There is no route left.
    Exhausted,
}

/// Whether the walks can show what is asked: that goals survive for an enemy and are dead for a friend.
pub(in crate::solver) fn suits(problem: &Problem, bounds: &Bounds, horizon: Option<usize>) -> bool {
    let role = |observer: usize| problem.observers()[observer].role;
    let true_goal = problem.true_goal();
    horizon.is_none()
        && bounds.at_least.is_some_and(|k| k > 1)
        && bounds.forbidden.iter().all(|w| role(w.observer) == Role::Cooperative)
        && bounds
            .required
            .iter()
            .all(|w| role(w.observer) == Role::Adversarial || w.goal == true_goal)
}

/// Walks beside a plan from elsewhere: those that came with it, or else for each enemy and goal one, where it is found.
pub(in crate::solver) fn beside(
    problem: &Arc<Problem>,
    plan: &Plan,
    known: Vec<Witness>,
    limits: Limits,
) -> Vec<Witness> {
    if !known.is_empty() {
        return known;
    }
    let mut joint = JointSpace::new(Arc::clone(problem), limits);
    joint.keep_listed();
    let Some(edges) = transitions(&mut joint, plan) else { return Vec::new() };
    let mut estimates = GoalEstimates::new(&joint);
    let mut found = Vec::new();
    for (place, observer) in problem.observers().iter().enumerate() {
        let goals = 0..problem.goals().len();
        for goal in goals.filter(|&goal| goal != problem.true_goal()) {
            let bytes = joint.bytes() + estimates.bytes();
            if observer.role == Role::Cooperative
                || estimates.worked_out > EVALUATIONS_BESIDE
                || limits.check_bytes(bytes).is_err()
            {
                continue;
            }
            let mut walkers = Walkers::new(&mut joint, &mut estimates, (place, goal), BEAM_WIDTH);
            if let Some((start, actions)) = walkers.walk(&mut joint, &mut estimates, &edges) {
                let start = joint.states().state(start);
                found.push(Witness { observer: place, goal, start, actions });
            }
        }
    }
    found
}

/// The transitions of a plan; none where it has an action that cannot be taken.
fn transitions(joint: &mut JointSpace, plan: &Plan) -> Option<Vec<usize>> {
    let mut at = joint.initial().state;
    let mut edges = Vec::with_capacity(plan.actions.len());
    for &action in &plan.actions {
        joint.states_mut().expand(at);
        let states = joint.states();
        let edge = states.edge_range(at).find(|&edge| states.all_edges()[edge].action == action)?;
        at = states.all_edges()[edge].target;
        edges.push(edge);
    }
    Some(edges)
}

impl ParallelWalks {
    pub(in crate::solver) fn new(problem: &Arc<Problem>, options: &Options) -> Self {
        let mut joint = JointSpace::new(Arc::clone(problem), options.limits);
        joint.keep_listed();
        let pairs = |observer: &crate::problem::Observer| match observer.role {
            Role::Adversarial => None,
            Role::Cooperative => PairwiseUpdates::new(problem.task(), &observer.sensor),
        };
        let mut search = Self {
            bounds: options.heeded_bounds(),
            limits: options.limits,
            estimates: GoalEstimates::new(&joint),
            joint,
            routes: Box::new(std::iter::empty()),
            width: BEAM_WIDTH,
            evaluation: Evaluation::Deferred,
            legs: FxHashMap::default(),
            walkers: Vec::new(),
            pairs: problem.observers().iter().map(pairs).collect(),
            stage: Stage::Exhausted,
            tried: 0,
            counts: Stats::default(),
        };
        search.begin_walkers();
        search.begin_routes();
        search.stage = search.first_leg();
        search
    }

    /// Begins with all routes.
    fn begin_routes(&mut self) {
        let problem = self.joint.problem();
        let (goals, true_goal) = (problem.goals().len(), problem.true_goal());
        // Nearest first, where an enemy says how near they are.
        let walkers = self.walkers.iter().flatten().next();
        let nearest = walkers.into_iter().flatten().map(Walkers::goal);
        let mut others: Vec<usize> = nearest.collect();
        others.extend((0..goals).filter(|&goal| goal != true_goal && walkers.is_none()));
        let routes = routes::routes(&others, true_goal);
        // Routes through two goals are many: they wait for the widest beams.
        self.routes = if self.width < BEAM_WIDTH_AT_MOST {
            Box::new(routes)
        } else {
            Box::new(routes.chain(routes::through_two(&others, true_goal)))
        };
    }

    /// Begins with new walkers.
    fn begin_walkers(&mut self) {
        let problem = Arc::clone(self.joint.problem());
        let (goals, true_goal) = (problem.goals().len(), problem.true_goal());
        self.walkers.clear();
        for (place, observer) in problem.observers().iter().enumerate() {
            let (joint, estimates) = (&mut self.joint, &mut self.estimates);
            self.walkers.push((observer.role == Role::Adversarial).then(|| {
                let others = (0..goals).filter(|&goal| goal != true_goal);
                let mut all: Vec<Walkers> = others
                    .map(|goal| Walkers::new(joint, estimates, (place, goal), self.width))
                    .collect();
                all.sort_by_key(Walkers::distance);
                all
            }));
        }
    }

    /// How many values of states were worked out: what the work is measured by.
    pub(in crate::solver) fn evaluations(&self) -> u64 {
        self.estimates.worked_out
    }

    fn next_route(&mut self) -> Stage {
        self.tried += 1;
        self.first_leg()
    }

    /// The first leg of the next route, perhaps with other legs or wider beams.
    fn first_leg(&mut self) -> Stage {
        let root = self.joint.initial();
        let mut route = self.routes.next();
        if route.is_none()
            && (self.evaluation != Evaluation::Eager || self.width < BEAM_WIDTH_AT_MOST)
        {
            self.evaluation = match self.evaluation {
                Evaluation::Deferred => Evaluation::Blind,
                Evaluation::Blind => Evaluation::Eager,
                Evaluation::Eager => Evaluation::Deferred,
            };
            if self.evaluation == Evaluation::Deferred {
                self.width *= BEAM_WIDER;
                self.begin_walkers();
                // What was not found is looked for with more effort.
                self.legs.retain(|_, leg| leg.is_some());
            }
            self.begin_routes();
            route = self.routes.next();
        }
        route.map_or(Stage::Exhausted, |route| Stage::Leg(Vec::new(), root.state, route))
    }

    fn leg(&mut self, mut edges: Vec<usize>, from: StateId, mut ahead: Vec<usize>) -> Stage {
        let Some(&goal) = ahead.first() else { return Stage::Friends(edges) };
        match self.legs.get(&(from, goal, self.evaluation)) {
            None => {
                let effort = match (ahead.len(), self.width) {
                    (1, BEAM_WIDTH) => Effort::First,
                    (1, _) => Effort::Most,
                    _ => Effort::OnTheWay,
                };
                let search = Box::new(LegSearch::new(goal, self.evaluation, effort));
                Stage::Search(search, edges, from, ahead)
            }
            Some(Some((leg, end))) => {
                edges.extend_from_slice(leg);
                ahead.remove(0);
                Stage::Leg(edges, *end, ahead)
            }
            // A goal that is not found on the way is passed over.
            Some(None) if ahead.len() > 1 => {
                ahead.remove(0);
                Stage::Leg(edges, from, ahead)
            }
            // Without a direct way no route of these legs ends well.
            Some(None) if from == self.joint.initial().state => {
                self.routes = Box::new(std::iter::empty());
                self.next_route()
            }
            Some(None) => self.next_route(),
        }
    }

    fn search(
        &mut self,
        mut search: Box<LegSearch>,
        edges: Vec<usize>,
        from: StateId,
        ahead: Vec<usize>,
    ) -> Stage {
        let LegStep::Over(found) = search.step(&mut self.joint, &mut self.estimates, from) else {
            return Stage::Search(search, edges, from, ahead);
        };
        let leg = found.map(|leg| {
            let end = leg.last().map(|edge| self.joint.states().all_edges()[*edge].target);
            (leg, end.unwrap_or(from))
        });
        self.legs.insert((from, search.goal(), self.evaluation), leg);
        Stage::Leg(edges, from, ahead)
    }

    fn seen(&mut self, observer: usize, edges: &[usize]) -> Vec<Symbol> {
        edges.iter().map(|&edge| self.joint.symbol(observer, edge)).collect()
    }

    /// Whether friends hold few enough goals possible at the end of a plan, as far as that is known.
    fn friends_keep_bounds(&mut self, edges: &[usize]) -> bool {
        let problem = Arc::clone(self.joint.problem());
        for (friend, observer) in problem.observers().iter().enumerate() {
            if observer.role != Role::Cooperative {
                continue;
            }
            let seen = self.seen(friend, edges);
            if self.pairs_keep_bounds(friend, &seen) {
                self.counts.settled_by_pairs += 1;
                continue;
            }
            self.counts.settled_by_beliefs += 1;
            let survivors = self.survivors(friend, &seen);
            if !survivors.is_some_and(|survivors| self.keeps(friend, &survivors)) {
                return false;
            }
        }
        true
    }

    fn pairs_keep_bounds(&self, friend: usize, seen: &[Symbol]) -> bool {
        let problem = self.joint.problem();
        let observer = &problem.observers()[friend];
        let open = open_goals(problem, observer, self.pairs[friend].as_ref(), seen);
        self.keeps(friend, &open)
    }

    /// The goals that survive for a friend; none where its beliefs cannot be listed.
    fn survivors(&mut self, friend: usize, seen: &[Symbol]) -> Option<GoalSet> {
        let root = self.joint.initial();
        let mut belief = self.joint.belief(root.profile, friend);
        for &symbol in seen {
            belief = self.joint.update(friend, belief, symbol).ok()?;
        }
        Some(self.joint.survivors(friend, belief).clone())
    }

    fn keeps(&self, friend: usize, survivors: &GoalSet) -> bool {
        let mut forbidden = self.bounds.forbidden.iter().filter(|w| w.observer == friend);
        self.bounds.at_most.is_none_or(|j| survivors.len() <= j)
            && !forbidden.any(|w| survivors.contains(w.goal))
    }

    fn is_required(&self, enemy: usize, goal: usize) -> bool {
        self.bounds.required.iter().any(|w| (w.observer, w.goal) == (enemy, goal))
    }

    /// The walk of one enemy and goal beside a plan, by position, and what is worked on after it.
    fn walk(
        &mut self,
        edges: Vec<usize>,
        mut found: Vec<Witness>,
        enemy: usize,
        place: usize,
    ) -> Stage {
        let Some(others) = self.walkers.get(enemy) else {
            let edge = |edge: &usize| self.joint.states().all_edges()[*edge].action;
            return Stage::Found(Plan { actions: edges.iter().map(edge).collect() }, found);
        };
        let count = others.as_ref().map_or(0, Vec::len);
        let alive = found.iter().filter(|witness| witness.observer == enemy).count();
        let needed = self.bounds.at_least.map_or(0, |k| k - 1);
        let required = |this: &Self| {
            let mine = this.walkers[enemy].iter().flatten().skip(place);
            mine.into_iter().any(|walkers| this.is_required(enemy, walkers.goal()))
        };
        if count == 0 || alive >= needed && !required(self) {
            return Stage::Walk(edges, found, enemy + 1, 0);
        }
        if place == count || alive + count - place < needed {
            return self.next_route();
        }
        let Self { joint, estimates, walkers, .. } = self;
        let Some(walkers) = walkers[enemy].as_mut().map(|all| &mut all[place]) else {
            return Stage::Exhausted;
        };
        let goal = walkers.goal();
        let walk = walkers.walk(joint, estimates, &edges);
        self.counts.walks += 1;
        self.counts.walks_found += u64::from(walk.is_some());
        match walk {
            Some((start, actions)) => {
                let start = self.joint.states().state(start);
                found.push(Witness { observer: enemy, goal, start, actions });
            }
            None if self.is_required(enemy, goal) => return self.next_route(),
            None => {}
        }
        Stage::Walk(edges, found, enemy, place + 1)
    }

    fn bytes(&self) -> u64 {
        let walkers = self.walkers.iter().flatten().flatten().map(Walkers::bytes).sum::<u64>();
        let search = if let Stage::Search(search, ..) = &self.stage { search.bytes() } else { 0 };
        self.joint.bytes() + self.estimates.bytes() + walkers + search
    }

    /// One state of a leg, one look at the friends or one walk. An error where the search has come to its end.
    fn step(&mut self) -> Result<Option<Advance>, LimitReached> {
        self.limits.check_bytes(self.bytes())?;
        self.stage = match std::mem::replace(&mut self.stage, Stage::Exhausted) {
            Stage::Exhausted => return Err(LimitReached::Expansions { limit: self.tried }),
            Stage::Found(plan, witnesses) => {
                let finding = Finding::plan(Status::Solved, plan);
                return Ok(Some(Advance::Finished(Finding { witnesses, ..finding })));
            }
            Stage::Leg(edges, from, ahead) => self.leg(edges, from, ahead),
            Stage::Search(search, edges, from, ahead) => self.search(search, edges, from, ahead),
            Stage::Friends(edges) if self.friends_keep_bounds(&edges) => {
                Stage::Walk(edges, Vec::new(), 0, 0)
            }
            Stage::Friends(_) => self.next_route(),
            Stage::Walk(edges, found, enemy, place) => self.walk(edges, found, enemy, place),
        };
        Ok(None)
    }
}

impl Engine for ParallelWalks {
    /// An error where the search has come to its end without a plan: nothing is proved by that.
    fn advance(&mut self, budget: u64) -> Result<Advance, LimitReached> {
        for _ in 0..budget {
            if let Some(answer) = self.step()? {
                return Ok(answer);
            }
        }
        Ok(Advance::Working)
    }

    fn stop(&mut self, limit: LimitReached) -> Finding {
        Finding::stopped(None, limit)
    }

    fn report(&self, _progress: &mut Progress) {}

    fn stats(&self) -> Stats {
        let mut stats = self.counts;
        stats.count_spaces(&self.joint);
        stats
    }
}
