//! What bounds imply by themselves: goals that survive in every plan, or in none, and contradictions.
//!
//! At its end the actor is where the true goal holds, and every observer believes that state possible: the true goal
//! survives for all. A goal whose condition holds wherever that of a surviving one does survives too. That says how good a
//! plan can be, and which bounds no plan keeps.

use fixedbitset::FixedBitSet;

use super::options::{Bounds, Watched};
use crate::problem::{Problem, Role};

impl Bounds {
    /// A difference `|G_X| − |G_C|` that no plan with these bounds can beat: every goal is left to
    /// the enemy except those that cannot be, to the friend those that must be. None where no plan keeps
    /// them, whatever the task.
    pub(crate) fn most_difference(&self, problem: &Problem) -> Option<i64> {
        let (mut left_to_enemy, mut left_to_friend) = (problem.goals().len(), 0);
        for (number, observer) in problem.observers().iter().enumerate() {
            let survive =
                implied(problem, named(&self.required, number).chain([problem.true_goal()]));
            let die = implying(problem, named(&self.forbidden, number));
            if !survive.is_disjoint(&die) {
                return None;
            }
            let (least, most) =
                (survive.count_ones(..), problem.goals().len() - die.count_ones(..));
            match observer.role {
                Role::Adversarial => left_to_enemy = left_to_enemy.min(most),
                Role::Cooperative => left_to_friend = left_to_friend.max(least),
            }
        }
        let keeps = self.at_least.is_none_or(|k| k <= left_to_enemy)
            && self.at_most.is_none_or(|j| j >= left_to_friend);
        keeps.then_some(left_to_enemy as i64 - left_to_friend as i64)
    }
}

/// The goals named for an observer.
fn named(list: &[Watched], observer: usize) -> impl Iterator<Item = usize> {
    list.iter().filter(move |watched| watched.observer == observer).map(|watched| watched.goal)
}

/// The goals that hold in every state in which one of these does.
fn implied(problem: &Problem, goals: impl Iterator<Item = usize>) -> FixedBitSet {
    pairs(problem, goals, |named, other| includes(problem, named, other))
}

/// The goals that hold only in states in which one of these does.
fn implying(problem: &Problem, goals: impl Iterator<Item = usize>) -> FixedBitSet {
    pairs(problem, goals, |named, other| includes(problem, other, named))
}

fn pairs(
    problem: &Problem,
    goals: impl Iterator<Item = usize>,
    related: impl Fn(usize, usize) -> bool,
) -> FixedBitSet {
    let count = problem.goals().len();
    let mut found = FixedBitSet::with_capacity(count);
    for named in goals {
        found.extend((0..count).filter(|&other| related(named, other)));
    }
    found
}

/// Whether the condition of a goal has every fact of that of another.
fn includes(problem: &Problem, goal: usize, other: usize) -> bool {
    let (whole, part) = (&problem.goals()[goal].condition, &problem.goals()[other].condition);
    part.len() <= whole.len() && part.iter().all(|fact| whole.contains(fact))
}
