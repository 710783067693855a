//! Domain transition graphs: how each group of exclusive facts changes, all others left aside.
//!
//! A group holds one of its facts or none, so it is a variable with finitely many values, and every
//! operator is a set of changes of values (Jonsson and Bäckström 1998,
//! doi:10.1016/S0004-3702(98)00035-0; Helmert 2006, doi:10.1613/jair.1705). The graph of one group
//! is an abstraction of the state space: whatever path there is in the space, its changes of the
//! group are a path in the graph.

use crate::task::{Operator, Task};

/// One change of a group by an operator.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::solver) struct Change {
    /// The group.
    pub group: usize,
    /// The value it must have before; none where the operator does not ask for one.
    pub from: Option<usize>,
    /// The value it has afterwards; 0 for none of its facts.
    pub to: usize,
    /// Whether a value other than `from` stays as it is: a fact deleted that the operator does not
    /// ask for.
    pub optional: bool,
}

/// The value that an operator asks of a group.
fn asked(task: &Task, operator: &Operator, group: usize) -> Option<usize> {
    let layout = task.layout();
    let fact = operator.preconditions.iter().find(|fact| layout.group(**fact) == group);
    fact.map(|fact| layout.value(*fact))
}

/// The changes that an operator makes, one for each group it touches; two where it adds two facts
/// of one group.
pub(in crate::solver) fn changes(task: &Task, operator: &Operator) -> Vec<Change> {
    let layout = task.layout();
    let mut changes: Vec<Change> = Vec::new();
    for &fact in &operator.add {
        let group = layout.group(fact);
        let from = asked(task, operator, group);
        changes.push(Change { group, from, to: layout.value(fact), optional: false });
    }
    for &fact in &operator.delete {
        let group = layout.group(fact);
        if operator.add.iter().any(|added| layout.group(*added) == group) {
            continue;
        }
        let value = layout.value(fact);
        match asked(task, operator, group) {
            Some(asked) if asked != value => {}
            Some(_) => changes.push(Change { group, from: Some(value), to: 0, optional: false }),
            None => changes.push(Change { group, from: Some(value), to: 0, optional: true }),
        }
    }
    changes
}

/// How many values a group has, none of its facts included.
pub(in crate::solver) fn value_count(task: &Task, group: usize) -> usize {
    task.layout().facts_of_group(group).len() + 1
}

/// The graphs of all groups.
#[derive(Debug)]
pub(in crate::solver) struct TransitionGraphs {
    /// By group: its edges from value to value.
    edges: Vec<Vec<(u32, u32)>>,
    /// By group: values that an operator can bring about whatever the group held before.
    from_any: Vec<Vec<u32>>,
    values: Vec<usize>,
}

impl TransitionGraphs {
    /// Linear in the effects of the operators.
    pub(in crate::solver) fn new(task: &Task) -> Self {
        let groups = task.layout().group_count();
        let mut graphs = Self {
            edges: vec![Vec::new(); groups],
            from_any: vec![Vec::new(); groups],
            values: (0..groups).map(|group| value_count(task, group)).collect(),
        };
        for operator in task.operators() {
            for change in changes(task, operator) {
                match change.from {
                    Some(from) if from != change.to => {
                        graphs.edges[change.group].push((from as u32, change.to as u32));
                    }
                    Some(_) => {}
                    None => graphs.from_any[change.group].push(change.to as u32),
                }
            }
        }
        for list in &mut graphs.edges {
            list.sort_unstable();
            list.dedup();
        }
        for list in &mut graphs.from_any {
            list.sort_unstable();
            list.dedup();
        }
        graphs
    }

    /// The fewest operators by which each value of a group becomes `target`; none where that cannot
    /// happen. Breadth first, backwards.
    pub(in crate::solver) fn distances_to(&self, group: usize, target: usize) -> Vec<Option<u32>> {
        let mut before: Vec<Vec<u32>> = vec![Vec::new(); self.values[group]];
        for &(from, to) in &self.edges[group] {
            before[to as usize].push(from);
        }
        let mut distances = vec![None; self.values[group]];
        distances[target] = Some(0);
        let mut queue = vec![target as u32];
        let mut next = 0;
        while let Some(&value) = queue.get(next) {
            next += 1;
            let further = distances[value as usize].map(|distance| distance + 1);
            let any = self.from_any[group].contains(&value);
            let sources: Vec<u32> = if any {
                (0..distances.len() as u32).collect()
            } else {
                std::mem::take(&mut before[value as usize])
            };
            for source in sources {
                if distances[source as usize].is_none() {
                    distances[source as usize] = further;
                    queue.push(source);
                }
            }
        }
        distances
    }

    /// The values that a group can come to have from some values, those included.
    pub(in crate::solver) fn reachable(&self, group: usize, from: &[usize]) -> Vec<bool> {
        let mut after: Vec<Vec<u32>> = vec![Vec::new(); self.values[group]];
        for &(from, to) in &self.edges[group] {
            after[from as usize].push(to);
        }
        let mut reached = vec![false; self.values[group]];
        let mut open: Vec<u32> = from.iter().map(|value| *value as u32).collect();
        open.extend(&self.from_any[group]);
        while let Some(value) = open.pop() {
            if !std::mem::replace(&mut reached[value as usize], true) {
                open.append(&mut after[value as usize]);
            }
        }
        reached
    }
}
