//! Grounded operators and the actions they belong to.

use super::fact::Fact;

/// An action: the name under which plans, sensors and the integer programs know an operator. It
/// has at most one applicable operator in any state.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Action(u32);

impl Action {
    pub(crate) fn new(index: usize) -> Self {
        Self(index as u32)
    }

    /// Its number.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// An operator of a task, by its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct OperatorId(u32);

impl OperatorId {
    /// The operator of this number, where the task has so many.
    pub fn of(task: &super::Task, index: usize) -> Option<Self> {
        (index < task.operators().len()).then(|| Self::new(index))
    }

    pub(crate) fn new(index: usize) -> Self {
        Self(index as u32)
    }

    /// Its number.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A grounded STRIPS operator.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Operator {
    /// The action this operator is a case of.
    pub action: Action,
    /// Facts that must hold before.
    pub preconditions: Box<[Fact]>,
    /// Facts that hold afterwards.
    pub add: Box<[Fact]>,
    /// Facts that no longer hold afterwards, unless they are added as well.
    pub delete: Box<[Fact]>,
}

impl Operator {
    /// Whether it does the same as another one, wherever both are applicable.
    pub(super) fn has_effects_of(&self, other: &Self) -> bool {
        (&self.add, &self.delete) == (&other.add, &other.delete)
    }
}
