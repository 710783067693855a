//! The fewest steps from a state to the true goal by projections: never more than the true number.
//!
//! Of the [atomic projections](GoalDistances) of the goal's facts, the largest distance is such a
//! number, and so is their sum where it is divided by how many of them one step can bring nearer
//! (uniform cost partitioning: Katz and Domshlak 2010, <https://doi.org/10.1016/j.artint.2010.04.021>,
//! on abstractions). No state is expanded for it.

use super::goal_distances::{Combine, GoalDistances, NEVER};
use crate::problem::Problem;
use crate::task::{StateId, StateSpace};

/// Estimates of one problem.
#[derive(Debug)]
pub(in crate::solver) struct Projections {
    goal: usize,
    largest: GoalDistances,
    sum: GoalDistances,
    changed: u64,
}

impl Projections {
    /// Reads the operators: linear in their effects, for each fact of a goal.
    pub(in crate::solver) fn new(problem: &Problem) -> Self {
        let goal = problem.true_goal();
        // No row is kept.
        let distances = |combine| GoalDistances::new(problem, combine, 0);
        Self {
            goal,
            largest: distances(Combine::Max),
            sum: distances(Combine::Sum),
            changed: u64::from(changed_at_once(problem)[goal]),
        }
    }

    /// No way to the true goal has fewer steps; none where there is no way.
    pub(in crate::solver) fn least(&self, states: &StateSpace, state: StateId) -> Option<u64> {
        let of = |distances: &GoalDistances| distances.measured(states, state, self.goal);
        let largest = of(&self.largest);
        if largest == NEVER {
            return None;
        }
        Some(u64::from(largest).max(u64::from(of(&self.sum)).div_ceil(self.changed)))
    }

    /// Bytes in use, counted by contents.
    pub(in crate::solver) fn bytes(&self) -> u64 {
        self.largest.bytes() + self.sum.bytes()
    }
}

/// By goal: the most groups of its facts that one operator changes, at least 1. A step brings the sum
/// of their distances down by no more.
pub(in crate::solver) fn changed_at_once(problem: &Problem) -> Vec<u32> {
    let task = problem.task();
    let group = |fact| task.layout().group(fact);
    let mut most = vec![1_u32; problem.goals().len()];
    let goals: Vec<Vec<usize>> = problem
        .goals()
        .iter()
        .map(|goal| goal.condition.iter().map(|fact| group(*fact)).collect())
        .collect();
    let mut changed: Vec<usize> = Vec::new();
    for operator in task.operators() {
        changed.clear();
        changed.extend(operator.add.iter().chain(&operator.delete).map(|fact| group(*fact)));
        changed.sort_unstable();
        changed.dedup();
        for (most, wanted) in most.iter_mut().zip(&goals) {
            let count = changed.iter().filter(|group| wanted.contains(group)).count();
            *most = (*most).max(count as u32);
        }
    }
    most
}
