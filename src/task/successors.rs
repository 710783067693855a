//! Finds the operators applicable in a state without trying each of them.
//!
//! A decision tree over the groups of facts, as in Fast Downward's successor generator (Helmert
//! 2006, doi:10.1613/jair.1705): an inner node asks for the value of one group and descends into
//! the branch of that value and into the branch of the operators that do not ask.

use super::fact::Layout;
use super::operator::{Operator, OperatorId};

#[derive(Debug, Clone)]
struct Node {
    /// Operators with nothing left to ask.
    here: Vec<OperatorId>,
    switches: Vec<Switch>,
}

/// Asks for the value of one group; branch `v` serves the operators that require value `v`.
#[derive(Debug, Clone)]
struct Switch {
    group: usize,
    branches: Vec<Option<Node>>,
}

/// The decision tree of one task.
#[derive(Debug, Clone)]
pub(crate) struct SuccessorGenerator {
    root: Node,
}

/// An operator with its preconditions as sorted (group, value) pairs.
type Requirement = (OperatorId, Vec<(usize, usize)>);

impl SuccessorGenerator {
    /// Builds the tree. Linear in the sum of the preconditions, but for the empty branches.
    pub(crate) fn new(layout: &Layout, operators: &[Operator]) -> Self {
        let mut requirements: Vec<Requirement> = operators
            .iter()
            .enumerate()
            .filter_map(|(index, operator)| {
                let mut asked: Vec<(usize, usize)> = Vec::new();
                for &fact in &operator.preconditions {
                    let pair = (layout.group(fact), layout.value(fact));
                    // Few: put in one by one, they need no copy of the sort in the wasm file.
                    if let Err(at) = asked.binary_search(&pair) {
                        asked.insert(at, pair);
                    }
                }
                // Two values asked of one group: never applicable.
                let possible = asked.windows(2).all(|pair| pair[0].0 != pair[1].0);
                possible.then(|| (OperatorId::new(index), asked))
            })
            .collect();
        requirements.sort_unstable_by(|a, b| a.1.cmp(&b.1).then(a.0.cmp(&b.0)));
        Self { root: build(&requirements, 0) }
    }

    /// Writes the applicable operators into `found`, in the order of their ids.
    pub(crate) fn applicable(&self, layout: &Layout, words: &[u64], found: &mut Vec<OperatorId>) {
        found.clear();
        collect(&self.root, layout, words, found);
        found.sort_unstable();
    }
}

/// The tree of operators that agree on their first `depth` requirements.
fn build(requirements: &[Requirement], depth: usize) -> Node {
    // The order puts those with nothing left to ask first, then sorts by group and value.
    let done = requirements.partition_point(|(_, asked)| asked.len() == depth);
    let (here, mut rest) = requirements.split_at(done);
    let mut switches = Vec::new();
    while let Some((_, asked)) = rest.first() {
        let group = asked[depth].0;
        let (mut mine, others) =
            rest.split_at(rest.partition_point(|(_, asked)| asked[depth].0 == group));
        let mut branches = Vec::new();
        while let Some((_, asked)) = mine.first() {
            let value = asked[depth].1;
            let (same, more) =
                mine.split_at(mine.partition_point(|(_, asked)| asked[depth].1 == value));
            branches.resize_with(value + 1, || None);
            branches[value] = Some(build(same, depth + 1));
            mine = more;
        }
        switches.push(Switch { group, branches });
        rest = others;
    }
    Node { here: here.iter().map(|(id, _)| *id).collect(), switches }
}

fn collect(node: &Node, layout: &Layout, words: &[u64], found: &mut Vec<OperatorId>) {
    found.extend_from_slice(&node.here);
    for switch in &node.switches {
        if let Some(Some(branch)) = switch.branches.get(layout.group_value(words, switch.group)) {
            collect(branch, layout, words, found);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::TaskBuilder;
    use super::super::fact::Fact;
    use super::*;

    #[test]
    fn agrees_with_trying_every_operator() {
        let mut builder = TaskBuilder::default();
        let facts: Vec<Fact> = (0..7).map(|i| builder.fact(format!("f{i}"))).collect();
        let mut seed = 12345_u32;
        for index in 0..60 {
            let mut preconditions = Vec::new();
            for &fact in &facts {
                seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                if seed >> 30 == 0 {
                    preconditions.push(fact);
                }
            }
            builder.operator(&format!("a{index}"), &preconditions, &[], &[]);
        }
        let task = builder.build(&[], &[]).unwrap();
        let mut found = Vec::new();
        for bits in 0_usize..128 {
            let holding: Vec<Fact> =
                facts.iter().copied().filter(|fact| bits >> fact.index() & 1 == 1).collect();
            let state = task.state(&holding).unwrap();
            task.applicable(state.words(), &mut found);
            let expected: Vec<OperatorId> = (0..task.operators().len())
                .map(OperatorId::new)
                .filter(|&id| task.satisfies(state.words(), &task.operator(id).preconditions))
                .collect();
            assert_eq!(found, expected, "state {bits:07b}");
        }
    }
}
