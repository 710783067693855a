//! What a step asks of the values of levels and how it changes them: an operator with what a sensor asks of its result.

use std::collections::BTreeMap;

use crate::sensor::{Sensor, Symbol};
use crate::task::{Fact, Operator, OperatorId, Task};

/// The map of one level: the new value of each old one, none where the step can't be taken.
pub(super) type Map = Box<[Option<u32>]>;

/// What one step asks of the values before and after it, and how it changes them, by levels.
#[derive(Debug, Clone, Default)]
pub(super) struct Step {
    /// Value that a level must have before.
    before: BTreeMap<usize, u32>,
    /// Facts that the operator adds, as values of levels.
    add: BTreeMap<usize, u32>,
    /// Values that the operator takes away.
    delete: BTreeMap<usize, Vec<u32>>,
    /// Value that a level must have afterwards.
    after: BTreeMap<usize, u32>,
    /// Values that a level must not have afterwards.
    not_after: BTreeMap<usize, Vec<u32>>,
}

impl Step {
    pub(super) fn of(task: &Task, operator: &Operator) -> Self {
        let (layout, order) = (task.layout(), task.group_order());
        let place = |fact: &Fact| (order.place(layout.group(*fact)), layout.value(*fact) as u32);
        let mut step = Self {
            before: operator.preconditions.iter().map(place).collect(),
            add: operator.add.iter().map(place).collect(),
            ..Self::default()
        };
        for (level, value) in operator.delete.iter().map(place) {
            step.delete.entry(level).or_default().push(value);
        }
        step
    }

    /// The first level that is touched; none where no level is.
    pub(super) fn first_level(&self) -> Option<usize> {
        let levels = [self.before.keys().next(), self.add.keys().next(), self.delete.keys().next()];
        levels.into_iter().flatten().copied().min()
    }

    /// The map of a level; none where it keeps every value.
    pub(super) fn map(&self, level: usize, values: usize) -> Option<Map> {
        let touched = self.before.contains_key(&level)
            || self.add.contains_key(&level)
            || self.delete.contains_key(&level)
            || self.after.contains_key(&level)
            || self.not_after.contains_key(&level);
        touched.then(|| (0..values as u32).map(|value| self.next(level, value)).collect())
    }

    fn next(&self, level: usize, value: u32) -> Option<u32> {
        if self.before.get(&level).is_some_and(|&wanted| wanted != value) {
            return None;
        }
        let deleted = self.delete.get(&level).is_some_and(|values| values.contains(&value));
        let kept = if deleted { 0 } else { value };
        let next = self.add.get(&level).copied().unwrap_or(kept);
        let seen = self.after.get(&level).is_none_or(|&wanted| wanted == next)
            && !self.not_after.get(&level).is_some_and(|values| values.contains(&next));
        seen.then_some(next)
    }

    /// The step where these facts hold afterwards as well; none where two exclude each other.
    fn with(&self, task: &Task, facts: &[Fact]) -> Option<Self> {
        let layout = task.layout();
        let mut step = self.clone();
        for &fact in facts {
            let level = task.group_order().place(layout.group(fact));
            let value = layout.value(fact) as u32;
            if step.after.insert(level, value).is_some_and(|known| known != value) {
                return None;
            }
        }
        Some(step)
    }

    /// The step where not all of these facts hold afterwards, as steps of which no two can be taken together: the first
    /// fact does not hold; the first holds and the second does not; and so on.
    fn without(&self, task: &Task, facts: &[Fact]) -> Vec<Self> {
        let layout = task.layout();
        let mut steps = Vec::new();
        for (place, &fact) in facts.iter().enumerate() {
            if let Some(mut step) = self.with(task, &facts[..place]) {
                let level = task.group_order().place(layout.group(fact));
                let value = layout.value(fact) as u32;
                step.not_after.entry(level).or_default().push(value);
                steps.push(step);
            }
        }
        steps
    }
}

/// The steps of an operator by what a sensor reads on them.
pub(super) fn split(
    task: &Task,
    id: OperatorId,
    mut left: Vec<Step>,
    sensor: &Sensor,
) -> Vec<(Step, Symbol)> {
    let mut found = Vec::new();
    for (facts, symbol) in sensor.cases(id) {
        found.extend(left.iter().filter_map(|step| Some((step.with(task, facts)?, symbol))));
        left = left.iter().flat_map(|step| step.without(task, facts)).collect();
    }
    found.extend(left.into_iter().map(|step| (step, sensor.otherwise(id))));
    found
}
