//! Goal distances: how far each candidate goal is from a state and from a belief.
//!
//! Each goal is a set of facts; each fact is so many changes of its group away, the preconditions of
//! the operators left aside (an atomic projection: a pattern database of one variable, Edelkamp
//! 2001). The largest of these numbers never says more than the true distance; their sum says more
//! and is the better guide. Where one of them is infinite the goal is out of reach. A belief is as
//! far from a goal as its nearest state. No state is expanded for any of this.

use super::transition_graphs::TransitionGraphs;
use crate::belief::diagram::{Diagrams, SetId};
use crate::belief::{BeliefId, Members};
use crate::problem::{JointSpace, Problem};
use crate::solver::ground::thresholds::PART_OF_MEMORY_FOR_DISTANCES;
use crate::task::{StateId, StateSpace, Task};

/// A goal that cannot be reached any more.
pub(in crate::solver) const NEVER: u8 = u8::MAX;
/// Distances beyond this are not told apart.
const FARTHEST: u32 = NEVER as u32 - 2;

/// Distances of a node that are not worked out, in place of the first.
const UNKNOWN: u8 = NEVER - 1;

/// The distances of a goal's facts by the value of their group.
#[derive(Debug)]
struct FactTable {
    group: usize,
    distances: Vec<Option<u32>>,
}

/// How distances of several facts become one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::solver) enum Combine {
    /// Their sum: a guide.
    Sum,
    /// The largest: never more than the true distance.
    Max,
}

/// Distances of all goals, each worked out once.
#[derive(Debug)]
pub(in crate::solver) struct GoalDistances {
    combine: Combine,
    tables: Vec<FactTable>,
    /// By goal: the tables of its facts.
    goals: Vec<Vec<u32>>,
    /// By state, then by goal.
    states: Vec<u8>,
    /// The most entries of `states`.
    room: usize,
    /// By observer: by belief, then by goal; and which rows are known.
    beliefs: Vec<Vec<u8>>,
    known: Vec<Vec<bool>>,
    /// By observer: the least distances of the goals from the states below a node of its diagrams.
    nodes: Vec<Vec<u8>>,
}

impl GoalDistances {
    /// Reads the operators of a problem: linear in their effects, for each fact of a goal.
    pub(in crate::solver) fn new(problem: &Problem, combine: Combine, memory: u64) -> Self {
        let task = problem.task();
        let graphs = TransitionGraphs::new(task);
        let mut facts: Vec<usize> = Vec::new();
        let mut tables = Vec::new();
        let mut goals = Vec::new();
        for goal in problem.goals() {
            let mut row = Vec::new();
            for fact in &goal.condition {
                let place = facts.iter().position(|known| *known == fact.index());
                let place = place.unwrap_or_else(|| {
                    facts.push(fact.index());
                    let group = task.layout().group(*fact);
                    let value = task.layout().value(*fact);
                    tables.push(FactTable { group, distances: graphs.distances_to(group, value) });
                    tables.len() - 1
                });
                row.push(place as u32);
            }
            goals.push(row);
        }
        Self {
            combine,
            tables,
            goals,
            states: Vec::new(),
            room: (memory / PART_OF_MEMORY_FOR_DISTANCES).min(usize::MAX as u64) as usize,
            beliefs: vec![Vec::new(); problem.observers().len() + 1],
            known: vec![Vec::new(); problem.observers().len() + 1],
            nodes: vec![Vec::new(); problem.observers().len() + 1],
        }
    }

    /// The true distances, where every state that can be met has been listed: from each goal, the
    /// distance of each state.
    pub(in crate::solver) fn listed(problem: &Problem, distances: &[Vec<u32>]) -> Self {
        let states = distances.first().map_or(0, Vec::len);
        let mut rows = Vec::with_capacity(states * distances.len());
        for state in 0..states {
            rows.extend(distances.iter().map(|goal| match goal[state] {
                u32::MAX => NEVER,
                steps => steps.min(FARTHEST) as u8,
            }));
        }
        Self {
            combine: Combine::Max,
            tables: Vec::new(),
            goals: vec![Vec::new(); problem.goals().len()],
            room: rows.len(),
            states: rows,
            beliefs: vec![Vec::new(); problem.observers().len() + 1],
            known: vec![Vec::new(); problem.observers().len() + 1],
            nodes: vec![Vec::new(); problem.observers().len() + 1],
        }
    }

    /// Bytes in use, counted by contents.
    pub(in crate::solver) fn bytes(&self) -> u64 {
        let rows: usize = self.beliefs.iter().chain(&self.nodes).map(Vec::len).sum();
        (self.states.len() + rows) as u64
    }

    /// How many goals there are.
    pub(in crate::solver) fn goals(&self) -> usize {
        self.goals.len()
    }

    /// The distance of a goal from a state, worked out anew.
    pub(in crate::solver) fn measured(
        &self,
        states: &StateSpace,
        state: StateId,
        goal: usize,
    ) -> u8 {
        self.measure(states.task(), states.words(state), goal)
    }

    fn measure(&self, task: &Task, words: &[u64], goal: usize) -> u8 {
        let mut total = 0_u32;
        for &table in &self.goals[goal] {
            let table = &self.tables[table as usize];
            let value = task.layout().group_value(words, table.group);
            total = match (table.distances[value], self.combine) {
                (None, _) => return NEVER,
                (Some(distance), Combine::Sum) => total.saturating_add(distance),
                (Some(distance), Combine::Max) => total.max(distance),
            };
        }
        total.min(FARTHEST) as u8
    }

    /// Works out the rows of all states met so far, as long as there is room.
    pub(in crate::solver) fn update(&mut self, joint: &JointSpace) {
        let width = self.goals.len();
        let states = joint.states();
        let mut rows = std::mem::take(&mut self.states);
        while rows.len() + width <= self.room && rows.len() < width * states.len() {
            let state = StateId((rows.len() / width) as u32);
            let words = states.words(state);
            rows.extend((0..width).map(|goal| self.measure(states.task(), words, goal)));
        }
        self.states = rows;
    }

    /// The distance of each goal from a state.
    pub(in crate::solver) fn of_state(&self, state: StateId) -> Option<&[u8]> {
        let width = self.goals.len();
        self.states.get(state.index() * width..(state.index() + 1) * width)
    }

    fn of_list(&self, list: &[StateId]) -> Vec<u8> {
        let width = self.goals.len();
        let mut least = vec![NEVER; width];
        for &state in list {
            let distances = self.states.get(state.index() * width..(state.index() + 1) * width);
            let Some(distances) = distances else {
                least.fill(0);
                break;
            };
            for (least, &distance) in least.iter_mut().zip(distances) {
                *least = distance.min(*least);
            }
        }
        least
    }

    /// The least distance of each goal from the states of a diagram: level by level, each node once.
    fn of_diagram(&mut self, observer: usize, diagrams: &Diagrams, set: SetId) -> Vec<u8> {
        if self.tables.is_empty() {
            // True distances are of states that are listed.
            return vec![0; self.goals.len()];
        }
        let mut nodes = std::mem::take(&mut self.nodes[observer]);
        self.below(diagrams, set, &mut nodes);
        let width = self.goals.len();
        let least = nodes[set.index() * width..][..width].to_vec();
        self.nodes[observer] = nodes;
        least
    }

    fn below(&self, diagrams: &Diagrams, set: SetId, nodes: &mut Vec<u8>) {
        let width = self.goals.len();
        let row = set.index() * width..(set.index() + 1) * width;
        if nodes.len() < row.end {
            nodes.resize(row.end, UNKNOWN);
        }
        if nodes[row.start] != UNKNOWN {
            return;
        }
        if set == SetId::EMPTY || set == SetId::END {
            nodes[row].fill(if set == SetId::END { 0 } else { NEVER });
            return;
        }
        let mut least = vec![NEVER; width];
        let group = diagrams.group(set);
        for branch in diagrams.branches(set) {
            self.below(diagrams, branch.below, nodes);
            let below = &nodes[branch.below.index() * width..][..width];
            for (goal, least) in least.iter_mut().enumerate() {
                let mut total = below[goal];
                for &table in &self.goals[goal] {
                    let table = &self.tables[table as usize];
                    if table.group != group || total == NEVER {
                        continue;
                    }
                    let here = table.distances[branch.value as usize];
                    total = here.map_or(NEVER, |here| self.combine(total, here));
                }
                *least = total.min(*least);
            }
        }
        nodes[row].copy_from_slice(&least);
    }

    fn combine(&self, total: u8, distance: u32) -> u8 {
        let total = u32::from(total);
        let both = match self.combine {
            Combine::Sum => total.saturating_add(distance),
            Combine::Max => total.max(distance),
        };
        both.min(FARTHEST) as u8
    }

    /// The distance of each goal from a belief of an observer, or of a set with the number of all
    /// observers. The states are those of the belief.
    pub(in crate::solver) fn of_belief(
        &mut self,
        observer: usize,
        belief: BeliefId,
        members: Members<'_>,
    ) -> &[u8] {
        let width = self.goals.len();
        let row = belief.index() * width..(belief.index() + 1) * width;
        let known = self.known[observer].get(belief.index()).copied().unwrap_or(false);
        if !known {
            let least = match members {
                Members::Listed(list) => self.of_list(list),
                Members::Diagram(diagrams, set) => self.of_diagram(observer, diagrams, set),
            };
            let rows = &mut self.beliefs[observer];
            rows.resize(rows.len().max(row.end), NEVER);
            rows[row.clone()].copy_from_slice(&least);
            let known = &mut self.known[observer];
            known.resize(known.len().max(belief.index() + 1), false);
            known[belief.index()] = true;
        }
        &self.beliefs[observer][row]
    }
}
