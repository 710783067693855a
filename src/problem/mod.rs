//! The problem: a task, its candidate goals and its observers.
//!
//! Definition 1 of the paper (MO-COPP), with the observers in a list, each with a role. More than
//! one of a role is allowed: nothing but the objective asks for roles.

mod combinations;
mod joint_space;
mod naming;
mod tuples;

use std::sync::Arc;

use thiserror::Error;

pub(crate) use joint_space::{JointSpace, Node, ProfileId};
pub use naming::{Part, StateLabel, StateNaming, Value};
pub(crate) use tuples::Tuples;

pub use crate::belief::{InitialBelief, StateCount};
use crate::goal_difference::{GoalSet, goal_difference};
use crate::sensor::Sensor;
use crate::task::{Fact, Task};

/// Whose side an observer is on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Role {
    /// The enemy, X in the paper: many goals should survive for it.
    Adversarial,
    /// The friend, C in the paper: few goals should survive for it.
    Cooperative,
}

impl Role {
    /// The name in documents and output.
    pub fn name(self) -> &'static str {
        match self {
            Self::Adversarial => "adversarial",
            Self::Cooperative => "cooperative",
        }
    }
}

/// A candidate goal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Goal {
    /// Its name.
    pub name: String,
    /// The facts that must all hold.
    pub condition: Vec<Fact>,
}

/// Somebody who watches.
#[derive(Debug, Clone)]
pub struct Observer {
    /// The name in documents and output.
    pub name: String,
    /// Friend or enemy.
    pub role: Role,
    /// What it sees of a step.
    pub sensor: Arc<Sensor>,
    /// The states it holds possible before the first step.
    pub initial_belief: InitialBelief,
}

/// Why a problem cannot be made.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ProblemError {
    /// Fewer than two candidate goals, or more than [`MAX_GOALS`].
    #[error("found {found} candidate goals, expected 2 to {MAX_GOALS}")]
    GoalCount {
        /// How many there are.
        found: usize,
    },
    /// Two goals of one name.
    #[error("goal {name} is named twice")]
    GoalTwice {
        /// The name.
        name: String,
    },
    /// The true goal is none of the candidates, or differs from the task's goal.
    #[error("the true goal is not a candidate goal with the condition of the task's goal")]
    TrueGoal,
    /// No observer of a role.
    #[error("there is no {role} observer, expected at least one", role = role.name())]
    NoObserver {
        /// The role nobody has.
        role: Role,
    },
    /// Two observers of one name.
    #[error("observer {name} is named twice")]
    ObserverTwice {
        /// The name.
        name: String,
    },
    /// An initial belief without the initial state.
    #[error("the initial belief of observer {observer} lacks the initial state")]
    BeliefWithoutStart {
        /// The observer's name.
        observer: String,
    },
}

/// The most candidate goals a problem may have.
pub const MAX_GOALS: usize = 1024;

/// A mixed-observer controlled observability planning problem.
#[derive(Debug, Clone)]
pub struct Problem {
    task: Arc<Task>,
    goals: Vec<Goal>,
    true_goal: usize,
    observers: Vec<Observer>,
    naming: StateNaming,
}

impl Problem {
    /// Checks the parts and puts them together. `true_goal` is a position in `goals`.
    ///
    /// # Errors
    ///
    /// [`ProblemError`] where the parts do not make a problem.
    pub fn new(
        task: Task,
        goals: Vec<Goal>,
        true_goal: usize,
        observers: Vec<Observer>,
        naming: StateNaming,
    ) -> Result<Self, ProblemError> {
        if !(2..=MAX_GOALS).contains(&goals.len()) {
            return Err(ProblemError::GoalCount { found: goals.len() });
        }
        for (index, goal) in goals.iter().enumerate() {
            if goals[..index].iter().any(|other| other.name == goal.name) {
                return Err(ProblemError::GoalTwice { name: goal.name.clone() });
            }
        }
        if goals.get(true_goal).is_none_or(|goal| goal.condition != task.goal()) {
            return Err(ProblemError::TrueGoal);
        }
        for role in [Role::Adversarial, Role::Cooperative] {
            if observers.iter().all(|observer| observer.role != role) {
                return Err(ProblemError::NoObserver { role });
            }
        }
        for (index, observer) in observers.iter().enumerate() {
            if observers[..index].iter().any(|other| other.name == observer.name) {
                return Err(ProblemError::ObserverTwice { name: observer.name.clone() });
            }
            if !observer.initial_belief.contains(task.initial_state()) {
                return Err(ProblemError::BeliefWithoutStart { observer: observer.name.clone() });
            }
        }
        Ok(Self { task: Arc::new(task), goals, true_goal, observers, naming })
    }

    /// The same problem; the initial beliefs are not listed.
    #[cfg(test)]
    pub(crate) fn with_unlisted_beliefs(&self) -> Self {
        let mut other = self.clone();
        for observer in &mut other.observers {
            observer.initial_belief = observer.initial_belief.unlisted(&self.task);
        }
        other
    }

    /// The task of the actor.
    pub fn task(&self) -> &Arc<Task> {
        &self.task
    }

    /// The candidate goals.
    pub fn goals(&self) -> &[Goal] {
        &self.goals
    }

    /// The position of the true goal.
    pub fn true_goal(&self) -> usize {
        self.true_goal
    }

    /// The position of the goal of this name.
    pub fn goal_named(&self, name: &str) -> Option<usize> {
        self.goals.iter().position(|goal| goal.name == name)
    }

    /// The observers.
    pub fn observers(&self) -> &[Observer] {
        &self.observers
    }

    /// The position of the observer of this name.
    pub fn observer_named(&self, name: &str) -> Option<usize> {
        self.observers.iter().position(|observer| observer.name == name)
    }

    /// How states are labelled.
    pub fn naming(&self) -> &StateNaming {
        &self.naming
    }

    /// How a packed state is shown to people and other programs.
    pub fn label(&self, words: &[u64]) -> StateLabel {
        self.naming.label(&self.task, words)
    }

    /// How many goals survive for the side of each role, from one set an observer: of several
    /// enemies the one that is in least doubt counts, of several friends the one in most.
    pub fn survivor_counts(&self, sets: &[GoalSet]) -> SurvivorCounts {
        let of_role = |role| {
            let mine = self.observers.iter().zip(sets).filter(move |(o, _)| o.role == role);
            mine.map(|(_, set)| set.len())
        };
        SurvivorCounts {
            adversarial: of_role(Role::Adversarial).min().unwrap_or(0),
            cooperative: of_role(Role::Cooperative).max().unwrap_or(0),
        }
    }

    /// The goal difference of survivor counts, for this number of candidate goals.
    pub fn goal_difference(&self, counts: SurvivorCounts) -> f64 {
        goal_difference(counts.adversarial, counts.cooperative, self.goals.len())
    }
}

/// How many candidate goals survive for each side.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SurvivorCounts {
    /// `|G_X|`.
    pub adversarial: usize,
    /// `|G_C|`.
    pub cooperative: usize,
}

impl SurvivorCounts {
    /// `|G_X| − |G_C|`, the numerator of the goal difference.
    pub fn difference(self) -> i64 {
        self.adversarial as i64 - self.cooperative as i64
    }
}
