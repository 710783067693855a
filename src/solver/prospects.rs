//! What can still become of the goals in a belief, whatever the actor does.
//!
//! A goal is *open* in a belief when a state that satisfies it can be reached from some believed
//! state. One that is not open will not survive again.
//!
//! A goal is *secured* for an observer when some believed state lies in the goal's *keep*: the
//! largest set of states in which the goal holds and from which, whatever symbol comes, some
//! transition with that symbol leads into the set again. One believed state of it brings the next
//! one, so the goal survives at every later step. (In box pushing a robot that has brought the box
//! to a goal may go on turning or staying, so no goal that survives once can be ruled out again.)
//!
//! Both are worked out on the whole state space, so only where that is small.

use fixedbitset::FixedBitSet;
use rustc_hash::FxHashMap;

use super::Bounds;
use crate::belief::BeliefId;
use crate::goal_difference::GoalSet;
use crate::limits::LimitReached;
use crate::problem::{JointSpace, Node, Role};
use crate::task::StateId;

/// State spaces with more states than this are not gone through,
const MOST_STATES: usize = 10_000;
/// nor those with more transitions than this.
const MOST_EDGES: usize = 200_000;

/// A belief that has not been looked at, a distance that there is none of.
const UNKNOWN: u32 = u32::MAX;

/// Open goals and secured goals.
type Outlook = (GoalSet, GoalSet);

/// Open and secured goals of states and beliefs. Equal outlooks are one number.
#[derive(Debug)]
pub(in crate::solver) struct Prospects {
    outlooks: Vec<Outlook>,
    numbers: FxHashMap<Outlook, u32>,
    /// By observer and state.
    of_states: Vec<Vec<u32>>,
    /// By observer and belief.
    of_beliefs: Vec<Vec<u32>>,
    /// How many actions it takes from each state to the true goal, where it can be reached.
    distances: Vec<u32>,
}

/// A small state space with everything in it.
struct Whole<'a> {
    joint: &'a mut JointSpace,
    /// Where the transitions into each state come from.
    sources: Vec<Vec<u32>>,
}

impl<'a> Whole<'a> {
    /// Goes through the state space; none where it is too large.
    fn new(joint: &'a mut JointSpace) -> Result<Option<Self>, LimitReached> {
        joint.initial();
        let mut index = 0;
        while index < joint.states().len() {
            if joint.states().len() > MOST_STATES || joint.states().edge_count() > MOST_EDGES {
                return Ok(None);
            }
            joint.states_mut().expand(StateId(index as u32));
            index += 1;
        }
        joint.limits().check_bytes(joint.bytes())?;
        let mut sources = vec![Vec::new(); index];
        for source in 0..index as u32 {
            for edge in joint.states().edges(StateId(source)) {
                sources[edge.target.index()].push(source);
            }
        }
        Ok(Some(Self { joint, sources }))
    }

    fn satisfying(&mut self, goal: usize) -> FixedBitSet {
        let states = 0..self.sources.len();
        let holds =
            |&state: &usize| self.joint.goals_of_state(StateId(state as u32)).contains(goal);
        states.filter(holds).collect()
    }

    /// How many actions it takes from each state to a goal; [`UNKNOWN`] where it is out of reach.
    fn distances(&mut self, goal: usize) -> Vec<u32> {
        let mut distances = vec![UNKNOWN; self.sources.len()];
        let mut layer: Vec<usize> = self.satisfying(goal).ones().collect();
        let mut distance = 0;
        while !layer.is_empty() {
            let mut next = Vec::new();
            for state in layer {
                if distances[state] == UNKNOWN {
                    distances[state] = distance;
                    next.extend(self.sources[state].iter().map(|&source| source as usize));
                }
            }
            layer = next;
            distance += 1;
        }
        distances
    }

    /// The symbols that an observer may see while the true goal is still open.
    fn symbols(&mut self, observer: usize, live: &FixedBitSet) -> FixedBitSet {
        let edges = 0..self.joint.states().edge_count();
        let target = |joint: &JointSpace, edge: usize| joint.states().all_edges()[edge].target;
        edges
            .filter(|&edge| live.contains(target(self.joint, edge).index()))
            .collect::<Vec<_>>()
            .into_iter()
            .map(|edge| self.joint.symbol(observer, edge).index())
            .collect()
    }

    /// The keep of a goal: states are dropped from those that satisfy it until every one left has
    /// each of the symbols on a way to another one left.
    fn keep(&mut self, observer: usize, goal: usize, symbols: &FixedBitSet) -> FixedBitSet {
        let mut keep = self.satisfying(goal);
        let mut stack: Vec<usize> = keep.ones().collect();
        while let Some(state) = stack.pop() {
            if !keep.contains(state) {
                continue;
            }
            let mut seen = FixedBitSet::with_capacity(symbols.len());
            for edge in self.joint.states().edge_range(StateId(state as u32)) {
                if keep.contains(self.joint.states().all_edges()[edge].target.index()) {
                    seen.grow_and_insert(self.joint.symbol(observer, edge).index());
                }
            }
            if !symbols.is_subset(&seen) {
                keep.remove(state);
                stack.extend(self.sources[state].iter().map(|&source| source as usize));
            }
        }
        keep
    }
}

impl Prospects {
    /// Linear in the transitions times goals and observers; none where the state space is large.
    ///
    /// # Errors
    ///
    /// The memory limit.
    pub(in crate::solver) fn new(joint: &mut JointSpace) -> Result<Option<Self>, LimitReached> {
        let problem = std::sync::Arc::clone(joint.problem());
        let (goals, observers) = (problem.goals().len(), problem.observers().len());
        let Some(mut whole) = Whole::new(joint)? else { return Ok(None) };
        let states = whole.sources.len();
        let distances: Vec<Vec<u32>> = (0..goals).map(|goal| whole.distances(goal)).collect();
        let reaching = |distances: &Vec<u32>| {
            (0..states).filter(|&state| distances[state] != UNKNOWN).collect()
        };
        let open: Vec<FixedBitSet> = distances.iter().map(reaching).collect();
        let mut prospects = Self {
            outlooks: Vec::new(),
            numbers: FxHashMap::default(),
            of_states: Vec::with_capacity(observers),
            of_beliefs: vec![Vec::new(); observers],
            distances: distances[problem.true_goal()].clone(),
        };
        let among = |sets: &[FixedBitSet], state: usize| {
            let mut among = GoalSet::none(goals);
            for (goal, set) in sets.iter().enumerate() {
                if set.contains(state) {
                    among.insert(goal);
                }
            }
            among
        };
        for observer in 0..observers {
            let symbols = whole.symbols(observer, &open[problem.true_goal()]);
            let keeps: Vec<FixedBitSet> =
                (0..goals).map(|goal| whole.keep(observer, goal, &symbols)).collect();
            let of_state = |state| (among(&open, state), among(&keeps, state));
            let numbers = (0..states).map(|state| prospects.number(of_state(state))).collect();
            prospects.of_states.push(numbers);
        }
        Ok(Some(prospects))
    }

    fn number(&mut self, outlook: Outlook) -> u32 {
        if let Some(&number) = self.numbers.get(&outlook) {
            return number;
        }
        let number = self.outlooks.len() as u32;
        self.outlooks.push(outlook.clone());
        self.numbers.insert(outlook, number);
        number
    }

    /// Bytes in use, counted by contents.
    pub(in crate::solver) fn bytes(&self) -> u64 {
        let numbers = self.of_states.iter().chain(&self.of_beliefs).map(Vec::len).sum::<usize>();
        4 * numbers as u64
    }

    fn of_belief(&mut self, joint: &JointSpace, observer: usize, belief: BeliefId) -> &Outlook {
        let row = &mut self.of_beliefs[observer];
        if row.len() <= belief.index() {
            row.resize(belief.index() + 1, UNKNOWN);
        }
        if row[belief.index()] == UNKNOWN {
            let numbers = &self.of_states[observer];
            let seen: FixedBitSet = joint
                .beliefs(observer)
                .members(belief)
                .iter()
                .map(|state| numbers[state.index()] as usize)
                .collect();
            let goals = joint.problem().goals().len();
            let mut union = (GoalSet::none(goals), GoalSet::none(goals));
            for number in seen.ones() {
                union.0.unite(&self.outlooks[number].0);
                union.1.unite(&self.outlooks[number].1);
            }
            let number = self.number(union);
            self.of_beliefs[observer][belief.index()] = number;
        }
        &self.outlooks[self.of_beliefs[observer][belief.index()] as usize]
    }

    /// How many actions it takes from a state to the true goal.
    pub(in crate::solver) fn distance(&self, state: StateId) -> Option<u32> {
        Some(self.distances[state.index()]).filter(|&distance| distance != UNKNOWN)
    }

    /// Whether no plan that goes on from a node can keep the bounds.
    pub(in crate::solver) fn are_hopeless(
        &mut self,
        joint: &JointSpace,
        bounds: &Bounds,
        node: Node,
    ) -> bool {
        let problem = joint.problem();
        let of_actor = self.of_states[0][node.state.index()] as usize;
        if !self.outlooks[of_actor].0.contains(problem.true_goal()) {
            return true;
        }
        problem.observers().iter().enumerate().any(|(index, observer)| {
            let belief = joint.belief(node.profile, index);
            let (open, secured) = self.of_belief(joint, index, belief);
            let counts = match observer.role {
                Role::Adversarial => bounds.at_least.is_some_and(|k| open.len() < k),
                Role::Cooperative => bounds.at_most.is_some_and(|j| secured.len() > j),
            };
            let mut required = bounds.required.iter().filter(|w| w.observer == index);
            let mut forbidden = bounds.forbidden.iter().filter(|w| w.observer == index);
            counts
                || required.any(|w| !open.contains(w.goal))
                || forbidden.any(|w| secured.contains(w.goal))
        })
    }

    /// The most that `|G_X| − |G_C|` can be at the end of any plan that goes on from a node.
    pub(in crate::solver) fn most(&mut self, joint: &JointSpace, node: Node) -> i64 {
        let (mut adversarial, mut cooperative) = (i64::MAX, 1);
        for (index, observer) in joint.problem().observers().iter().enumerate() {
            let belief = joint.belief(node.profile, index);
            let (open, secured) = self.of_belief(joint, index, belief);
            match observer.role {
                Role::Adversarial => adversarial = adversarial.min(open.len() as i64),
                Role::Cooperative => cooperative = cooperative.max(secured.len() as i64),
            }
        }
        adversarial - cooperative
    }
}
