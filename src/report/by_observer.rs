//! What there is of each observer, and names of goals.

use serde::Serialize;

use crate::goal_difference::GoalSet;
use crate::problem::Problem;

/// A map from the name of each observer to something, in the problem's order.
#[derive(Debug, Clone, PartialEq)]
pub struct ByObserver<T>(pub(super) Vec<(String, T)>);

impl<T> ByObserver<T> {
    pub(super) fn new(problem: &Problem, of: impl FnMut(usize) -> T) -> Self {
        let names = problem.observers().iter().map(|observer| observer.name.clone());
        Self(names.zip((0..).map(of)).collect())
    }

    /// What belongs to the observer at this place in the problem.
    pub fn get(&self, observer: usize) -> Option<&T> {
        self.0.get(observer).map(|(_, value)| value)
    }
}

impl<T: Serialize> Serialize for ByObserver<T> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

pub(super) fn goal_names(problem: &Problem, set: &GoalSet) -> Vec<String> {
    set.iter().map(|goal| problem.goals()[goal].name.clone()).collect()
}

pub(super) fn names_where(problem: &Problem, wanted: impl Fn(usize) -> bool) -> Vec<String> {
    let goals = problem.goals().iter().enumerate();
    goals.filter(|&(goal, _)| wanted(goal)).map(|(_, goal)| goal.name.clone()).collect()
}
