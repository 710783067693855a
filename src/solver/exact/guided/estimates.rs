//! How long a plan must still be to be worth what is aimed at.

use super::classes::Classes;
use super::doubts::Doubts;
use super::steps::Steps;
use super::twins::{NEVER, Twins};
use crate::limits::LimitReached;
use crate::problem::{JointSpace, Node, Role};
use crate::solver::Bounds;
use crate::solver::live::Live;
use crate::task::StateId;

/// State spaces above this size have too many pairs.
const MOST_STATES: usize = 2_900;
/// The most pairs in all tables together, and the most pairs of transitions gone through for them.
const MOST_PAIRS: u64 = 9_000_000;
const MOST_PAIRS_OF_TRANSITIONS: u64 = 150_000_000;

/// What a pair takes in any table, at most.
const BYTES_OF_A_PAIR: u64 = 6;

/// What a plan should achieve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Aim {
    /// The least `|G_X| − |G_C|`.
    pub value: i64,
    /// The least `|G_X|`.
    pub at_least: usize,
    /// The greatest `|G_C|`.
    pub at_most: usize,
}

/// An observer with a table for each goal that is not the true one.
#[derive(Debug)]
struct Watcher<T> {
    observer: usize,
    steps: Steps,
    tables: Vec<T>,
}

/// The tables of all observers.
#[derive(Debug)]
pub(super) struct Estimates {
    goals: usize,
    /// The candidate goals without the true one.
    others: Vec<usize>,
    enemies: Vec<Watcher<Twins>>,
    friends: Vec<Watcher<Doubts>>,
    /// Enemies, and goals by their places in `others`, that must survive.
    required: Vec<(usize, usize)>,
    /// Counted up whenever estimates may have grown.
    edition: u32,
    scratch: Vec<u32>,
    ahead: Vec<u32>,
    behind: Vec<u32>,
}

/// The states of a space that satisfy each goal.
fn states_of_goals(joint: &mut JointSpace) -> Vec<Vec<u32>> {
    let mut states = vec![Vec::new(); joint.problem().goals().len()];
    for state in 0..joint.states().len() as u32 {
        for goal in joint.goals_of_state(StateId(state)).iter() {
            states[goal].push(state);
        }
    }
    states
}

/// Sorts a few numbers; there are as many as goals.
fn sort(numbers: &mut [u32]) {
    for end in 1..numbers.len() {
        let place = numbers[..end].partition_point(|&known| known <= numbers[end]);
        numbers[place..=end].rotate_right(1);
    }
}

impl Estimates {
    /// Goes through the whole state space; none where it or the tables would be too large.
    pub(super) fn new(
        joint: &mut JointSpace,
        bounds: &Bounds,
    ) -> Result<Option<Self>, LimitReached> {
        let root = joint.initial();
        let mut expanded = 0;
        while expanded < joint.states().len() {
            if joint.states().len() > MOST_STATES {
                return Ok(None);
            }
            joint.states_mut().expand(StateId(expanded as u32));
            expanded += 1;
        }
        let problem = std::sync::Arc::clone(joint.problem());
        let states = joint.states().len();
        let goals = problem.goals().len();
        let others: Vec<usize> = (0..goals).filter(|&goal| goal != problem.true_goal()).collect();
        let tables = (others.len() * problem.observers().len()) as u64;
        let pairs = tables * (states * states) as u64;
        if pairs > MOST_PAIRS {
            return Ok(None);
        }
        joint.limits().check_bytes(joint.bytes() + BYTES_OF_A_PAIR * pairs)?;
        let by_goal = states_of_goals(joint);
        let (mut enemies, mut friends) = (Vec::new(), Vec::new());
        let mut work = 0;
        for (observer, watched) in problem.observers().iter().enumerate() {
            let steps = Steps::new(joint, observer);
            work += steps.same_looking_pairs().saturating_mul(others.len() as u64);
            match watched.role {
                Role::Adversarial => {
                    let believed =
                        joint.beliefs(observer).members(joint.belief(root.profile, observer));
                    let mut classes = Classes::new(&steps);
                    let pairs = classes.pairs(believed.iter().map(|other| (root.state.0, other.0)));
                    let reached = &by_goal[problem.true_goal()];
                    let mut table = |&goal: &usize| match &pairs {
                        Some(pairs) if !classes.hold(pairs, reached, &by_goal[goal]) => {
                            Twins::hopeless()
                        }
                        _ => Twins::new(states, reached, &by_goal[goal]),
                    };
                    let tables = others.iter().map(&mut table).collect();
                    enemies.push(Watcher { observer, steps, tables });
                }
                Role::Cooperative => friends.push(Watcher { observer, steps, tables: Vec::new() }),
            }
        }
        if work > MOST_PAIRS_OF_TRANSITIONS {
            return Ok(None);
        }
        let required = bounds.required.iter().filter_map(|watched| {
            let enemy = enemies.iter().position(|enemy| enemy.observer == watched.observer)?;
            Some((enemy, others.iter().position(|&goal| goal == watched.goal)?))
        });
        Ok(Some(Self {
            goals,
            required: required.collect(),
            others,
            enemies,
            friends,
            edition: 0,
            scratch: Vec::new(),
            ahead: Vec::new(),
            behind: Vec::new(),
        }))
    }

    /// Counted up whenever estimates may have grown.
    pub(super) fn edition(&self) -> u32 {
        self.edition
    }

    /// Makes the tables of what can survive for the enemies know all that takes at most so many
    /// steps.
    pub(super) fn extend(&mut self, until: u32) {
        for enemy in &mut self.enemies {
            for table in &mut enemy.tables {
                table.extend(&enemy.steps, until);
            }
        }
        self.edition += 1;
    }

    /// Makes one of these tables know what it says of a node, or that it is more than `most`; false
    /// when there is no such table.
    pub(super) fn settle(
        &mut self,
        number: usize,
        joint: &JointSpace,
        node: Node,
        most: u32,
    ) -> bool {
        let (enemy, table) = (number / self.others.len(), number % self.others.len());
        let Some(Watcher { observer, steps, tables }) = self.enemies.get_mut(enemy) else {
            return false;
        };
        let believed = joint.beliefs(*observer).members(joint.belief(node.profile, *observer));
        let table = &mut tables[table];
        let mut depth = 0;
        while depth < most && !table.complete() && table.least(node.state, believed) > depth {
            depth += 1;
            table.extend(steps, depth);
        }
        if table.least(node.state, believed) == NEVER {
            // Then it is lost wherever a plan leads, and nobody need look it up any more.
            *table = Twins::hopeless();
        }
        self.edition += 1;
        true
    }

    /// Makes the tables of the doubts that the friends can be freed of, once.
    pub(super) fn add_doubts(&mut self, joint: &mut JointSpace, live: &Live) {
        let by_goal = states_of_goals(joint);
        let true_goal = joint.problem().true_goal();
        let states = joint.states().len();
        for friend in &mut self.friends {
            for &goal in self.others.iter().skip(friend.tables.len()) {
                let mut twins = Twins::new(states, &by_goal[true_goal], &by_goal[goal]);
                twins.extend(&friend.steps, NEVER);
                let is = |goal: usize| {
                    let by_goal = &by_goal;
                    move |state: u32| by_goal[goal].binary_search(&state).is_ok()
                };
                let doubts = Doubts::new(&friend.steps, &twins, live, is(true_goal), is(goal));
                friend.tables.push(doubts);
            }
        }
        self.edition += 1;
    }

    /// The actions that a plan must still have at least, to end in the true goal with what is aimed
    /// at.
    pub(super) fn least(&mut self, joint: &JointSpace, live: &Live, node: Node, aim: Aim) -> u32 {
        let Some(distance) = live.distance(node.state) else { return NEVER };
        let mut least = distance as u32;
        // At place i: until i + 1 goals beside the true one can survive for each enemy, or be dead
        // for each friend.
        self.ahead.clear();
        self.ahead.resize(self.others.len(), 0);
        self.behind.clear();
        self.behind.resize(self.others.len(), 0);
        for (number, enemy) in self.enemies.iter().enumerate() {
            let belief = joint.belief(node.profile, enemy.observer);
            let believed = joint.beliefs(enemy.observer).members(belief);
            self.scratch.clear();
            self.scratch.extend(enemy.tables.iter().map(|table| table.least(node.state, believed)));
            for &(_, goal) in self.required.iter().filter(|(enemy, _)| *enemy == number) {
                least = least.max(self.scratch[goal]);
            }
            sort(&mut self.scratch);
            for (most, &steps) in self.ahead.iter_mut().zip(&self.scratch) {
                *most = steps.max(*most);
            }
        }
        for friend in &self.friends {
            let belief = joint.belief(node.profile, friend.observer);
            let believed = joint.beliefs(friend.observer).members(belief);
            self.scratch.clear();
            let most = |table: &Doubts| table.most(node.state, believed, distance as u32);
            self.scratch.extend(friend.tables.iter().map(most));
            sort(&mut self.scratch);
            for (most, &steps) in self.behind.iter_mut().zip(&self.scratch) {
                *most = steps.max(*most);
            }
        }
        let mut best = NEVER;
        for survivors in aim.at_least.max(1)..=self.goals {
            let allowed = (survivors as i64 - aim.value).min(aim.at_most as i64);
            if allowed < 1 {
                continue;
            }
            let dead = self.goals.saturating_sub(allowed as usize);
            let of = |steps: &[u32], count: usize| count.checked_sub(1).map_or(0, |i| steps[i]);
            best = best.min(of(&self.ahead, survivors - 1).max(of(&self.behind, dead)));
        }
        least.max(best)
    }

    /// Bytes in use, counted by contents.
    pub(super) fn bytes(&self) -> u64 {
        let twins = self.enemies.iter().flat_map(|enemy| &enemy.tables).map(Twins::bytes);
        let doubts = self.friends.iter().flat_map(|friend| &friend.tables).map(Doubts::bytes);
        twins.chain(doubts).sum()
    }
}
