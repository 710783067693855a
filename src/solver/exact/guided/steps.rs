//! The transitions between all states as one observer sees them.

use crate::problem::JointSpace;
use crate::task::StateId;

/// One transition, seen from the state on one side of it.
#[derive(Debug, Clone, Copy)]
pub(in crate::solver::exact) struct Step {
    /// The state on the other side.
    pub state: u32,
    /// Its place among the transitions out of the state it begins in.
    pub place: u32,
}

/// Transitions of one state that look the same.
#[derive(Debug, Clone, Copy)]
pub(in crate::solver::exact) struct Group {
    pub symbol: u32,
    begin: u32,
    end: u32,
}

/// Transitions by state, those of a state by symbol.
#[derive(Debug, Default)]
pub(in crate::solver::exact) struct Rows {
    /// Where the groups of each state end; the first number stands before all.
    ends: Vec<u32>,
    groups: Vec<Group>,
    steps: Vec<Step>,
}

/// The state whose row it is in, the symbol, and the transition.
type Entry = (u32, u32, Step);

impl Rows {
    /// `entries` in any order.
    fn new(states: usize, entries: &[Entry]) -> Self {
        let mut rows: Vec<Vec<(u32, Step)>> = vec![Vec::new(); states];
        for &(row, symbol, step) in entries {
            let row = &mut rows[row as usize];
            let place = row.partition_point(|(known, _)| *known <= symbol);
            row.insert(place, (symbol, step));
        }
        let mut all = Self { ends: vec![0], ..Self::default() };
        for row in rows {
            for same in row.chunk_by(|a, b| a.0 == b.0) {
                let begin = all.steps.len() as u32;
                all.steps.extend(same.iter().map(|(_, step)| *step));
                let (symbol, end) = (same[0].0, all.steps.len() as u32);
                all.groups.push(Group { symbol, begin, end });
            }
            all.ends.push(all.groups.len() as u32);
        }
        all
    }

    /// The transitions of a state in groups, by symbol.
    pub(in crate::solver::exact) fn of(&self, state: u32) -> &[Group] {
        let (begin, end) = (self.ends[state as usize], self.ends[state as usize + 1]);
        &self.groups[begin as usize..end as usize]
    }

    /// The transitions of a group.
    pub(in crate::solver::exact) fn steps(&self, group: Group) -> &[Step] {
        &self.steps[group.begin as usize..group.end as usize]
    }

    /// Those of a state with this symbol.
    pub(in crate::solver::exact) fn with_symbol(&self, state: u32, symbol: u32) -> &[Step] {
        let found = self.of(state).iter().find(|group| group.symbol == symbol);
        found.map_or(&[], |&group| self.steps(group))
    }
}

/// Transitions out of and into each state.
#[derive(Debug)]
pub(in crate::solver::exact) struct Steps {
    pub(in crate::solver::exact) out: Rows,
    pub(in crate::solver::exact) into: Rows,
}

impl Steps {
    /// Those of a space whose states are all expanded.
    pub(in crate::solver::exact) fn new(joint: &mut JointSpace, observer: usize) -> Self {
        let states = joint.states().len();
        let mut out = Vec::with_capacity(joint.states().edge_count());
        let mut into = Vec::with_capacity(joint.states().edge_count());
        for state in 0..states as u32 {
            let range = joint.states().edge_range(StateId(state));
            for (place, edge) in range.enumerate() {
                let symbol = joint.symbol(observer, edge).index() as u32;
                let (target, place) = (joint.states().all_edges()[edge].target.0, place as u32);
                out.push((state, symbol, Step { state: target, place }));
                into.push((target, symbol, Step { state, place }));
            }
        }
        Self { out: Rows::new(states, &out), into: Rows::new(states, &into) }
    }

    /// How many states there are.
    pub(in crate::solver::exact) fn states(&self) -> usize {
        self.out.ends.len() - 1
    }

    /// How many pairs of transitions look the same: what a table over pairs of states takes to
    /// fill.
    pub(in crate::solver::exact) fn same_looking_pairs(&self) -> u64 {
        let mut counts: Vec<u64> = Vec::new();
        for group in &self.out.groups {
            let symbol = group.symbol as usize;
            counts.resize(counts.len().max(symbol + 1), 0);
            counts[symbol] += u64::from(group.end - group.begin);
        }
        counts.iter().map(|count| count.saturating_mul(*count)).fold(0, u64::saturating_add)
    }
}
