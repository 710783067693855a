//! Legs: walks of the actor from a state to a goal, by greedy best-first search or breadth first.
//!
//! With deferred evaluation a state is evaluated when it is taken from the open list, where it waits with the value of the
//! one before it, and those that preferred actions lead to wait in a list of their own as well, which is taken from more often
//! after each step forward. That finds legs in larger tasks; with eager evaluation, where each state waits with its own
//! value, they are others and mostly shorter. In a small state space values can lead nowhere for long, while going through all
//! of it breadth first takes less than a second.
//!
//! Source: Richter and Helmert 2009, "Preferred operators and deferred evaluation in satisficing planning"
//! (doi:10.1609/icaps.v19i1.13345).

use std::collections::{BTreeMap, VecDeque};

use rustc_hash::FxHashMap;

use super::estimates::GoalEstimates;
use crate::heuristic::UNREACHABLE;
use crate::problem::JointSpace;
use crate::solver::ground::thresholds::{
    EVALUATIONS_OF_A_FIRST_LEG, EVALUATIONS_OF_A_LEG, EVALUATIONS_ON_THE_WAY, STATES_BREADTH_FIRST,
    STATES_FOR_A_VALUE, TRANSITIONS_BREADTH_FIRST, TURNS_OF_PREFERRED,
};
use crate::task::{Action, StateId};

/// How much a search for a leg may take.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Effort {
    /// To a goal on the way to another.
    OnTheWay,
    /// In the first round.
    First,
    /// In later rounds.
    Most,
}

impl Effort {
    /// States evaluated, at most.
    fn evaluations(self) -> usize {
        match self {
            Self::OnTheWay => EVALUATIONS_ON_THE_WAY,
            Self::First => EVALUATIONS_OF_A_FIRST_LEG,
            Self::Most => EVALUATIONS_OF_A_LEG,
        }
    }
}

/// A state that waits: the transition that leads to it, and the state before.
type Waiting = (usize, StateId);

/// States that wait by their value, equal ones in the order in which they came.
#[derive(Debug, Default)]
struct OpenList {
    waiting: BTreeMap<u32, VecDeque<Waiting>>,
    /// How many they are.
    count: usize,
    /// How often it was taken from, less what it gained.
    turns: i64,
}

impl OpenList {
    fn push(&mut self, value: u32, waiting: Waiting) {
        self.count += 1;
        self.waiting.entry(value).or_default().push_back(waiting);
    }

    fn pop(&mut self) -> Option<Waiting> {
        let mut first = self.waiting.first_entry()?;
        let waiting = first.get_mut().pop_front();
        if first.get().is_empty() {
            first.remove();
        }
        self.count -= 1;
        self.turns += 1;
        waiting
    }
}

/// When states are evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Evaluation {
    /// When they are taken from the open list.
    Deferred,
    /// Never: breadth first.
    Blind,
    /// When they come to it.
    Eager,
}

/// The search for a leg.
#[derive(Debug)]
pub(super) struct LegSearch {
    goal: usize,
    evaluation: Evaluation,
    effort: Effort,
    all: OpenList,
    preferred: OpenList,
    /// What led to each state that was evaluated; nothing to the first.
    met: FxHashMap<StateId, Option<Waiting>>,
    least: u32,
    /// States evaluated, or without values expanded.
    work: usize,
    transitions: usize,
    /// The preferred actions of the state at hand.
    actions: Vec<Action>,
}

/// How far the search is.
pub(super) enum LegStep {
    /// There is more to expand.
    Working,
    /// The transitions of a walk from the state to one in which the goal holds; none where none was found.
    Over(Option<Vec<usize>>),
}

impl LegSearch {
    /// To a goal.
    pub(super) fn new(goal: usize, evaluation: Evaluation, effort: Effort) -> Self {
        Self {
            goal,
            evaluation,
            effort,
            all: OpenList::default(),
            preferred: OpenList::default(),
            met: FxHashMap::default(),
            least: UNREACHABLE,
            work: 0,
            transitions: 0,
            actions: Vec::new(),
        }
    }

    /// The goal.
    pub(super) fn goal(&self) -> usize {
        self.goal
    }

    /// Bytes in use, counted by contents.
    pub(super) fn bytes(&self) -> u64 {
        let waiting = self.all.count + self.preferred.count;
        (size_of::<Waiting>() * (waiting + 2 * self.met.len())) as u64
    }

    /// Evaluates and expands a state.
    fn expand(
        &mut self,
        joint: &mut JointSpace,
        estimates: &mut GoalEstimates,
        state: StateId,
    ) -> LegStep {
        let value = match self.evaluation {
            Evaluation::Deferred => {
                estimates.with_preferred(joint, state, self.goal, &mut self.actions)
            }
            Evaluation::Eager => estimates.of_state(joint, state, self.goal),
            Evaluation::Blind => {
                if self.work.is_multiple_of(STATES_FOR_A_VALUE) {
                    estimates.worked_out += 1;
                }
                u32::from(!joint.goals_of_state(state).contains(self.goal))
            }
        };
        if value == 0 {
            return LegStep::Over(Some(self.edges(state)));
        }
        if value == UNREACHABLE {
            return LegStep::Working;
        }
        if value < self.least {
            self.least = value;
            self.preferred.turns -= TURNS_OF_PREFERRED;
        }
        self.work += 1;
        joint.states_mut().expand(state);
        for edge in joint.states().edge_range(state) {
            let taken = joint.states().all_edges()[edge];
            self.transitions += 1;
            if self.met.contains_key(&taken.target) {
                continue;
            }
            if self.evaluation == Evaluation::Eager {
                self.work += 1;
                let value = estimates.of_state(joint, taken.target, self.goal);
                if value != UNREACHABLE {
                    self.all.push(value, (edge, state));
                }
                continue;
            }
            self.all.push(value, (edge, state));
            if self.actions.binary_search(&taken.action).is_ok() {
                self.preferred.push(value, (edge, state));
            }
        }
        LegStep::Working
    }

    fn is_spent(&self) -> bool {
        match self.evaluation {
            Evaluation::Deferred | Evaluation::Eager => self.work >= self.effort.evaluations(),
            Evaluation::Blind => {
                self.work >= STATES_BREADTH_FIRST || self.transitions >= TRANSITIONS_BREADTH_FIRST
            }
        }
    }

    /// The transitions that led to a state.
    fn edges(&self, state: StateId) -> Vec<usize> {
        let mut edges = Vec::new();
        let mut at = state;
        while let Some((edge, before)) = self.met[&at] {
            edges.push(edge);
            at = before;
        }
        edges.reverse();
        edges
    }

    /// Takes the next state, the first one at first.
    pub(super) fn step(
        &mut self,
        joint: &mut JointSpace,
        estimates: &mut GoalEstimates,
        from: StateId,
    ) -> LegStep {
        if self.met.is_empty() {
            self.met.insert(from, None);
            return self.expand(joint, estimates, from);
        }
        if self.is_spent() {
            return LegStep::Over(None);
        }
        let lists = if self.preferred.turns <= self.all.turns {
            [&mut self.preferred, &mut self.all]
        } else {
            [&mut self.all, &mut self.preferred]
        };
        let Some((edge, before)) = lists.into_iter().find_map(OpenList::pop) else {
            return LegStep::Over(None);
        };
        let state = joint.states().all_edges()[edge].target;
        if self.met.contains_key(&state) {
            return LegStep::Working;
        }
        self.met.insert(state, Some((edge, before)));
        self.expand(joint, estimates, state)
    }
}
