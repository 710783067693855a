//! The transitions between all states as one observer sees them.

use crate::problem::JointSpace;
use crate::task::StateId;

/// One transition, from either side.
#[derive(Debug, Clone, Copy)]
pub(super) struct Step {
    /// What the observer sees of it.
    pub symbol: u32,
    /// The state on the other side.
    pub state: u32,
    /// Its place among the transitions out of the state it begins in.
    pub place: u32,
}

/// Transitions by state, those of a state by symbol.
#[derive(Debug)]
struct Rows {
    /// Where the transitions of each state end; the first number stands before all.
    ends: Vec<usize>,
    steps: Vec<Step>,
}

impl Rows {
    fn new(rows: Vec<Vec<Step>>) -> Self {
        let mut ends = vec![0];
        let mut steps = Vec::new();
        for mut row in rows {
            row.sort_by_key(|step| step.symbol);
            steps.extend_from_slice(&row);
            ends.push(steps.len());
        }
        Self { ends, steps }
    }

    fn of(&self, state: usize) -> &[Step] {
        &self.steps[self.ends[state]..self.ends[state + 1]]
    }
}

/// Transitions out of and into each state.
#[derive(Debug)]
pub(super) struct Steps {
    out: Rows,
    into: Rows,
}

impl Steps {
    /// Those of a space whose states are all expanded.
    pub(super) fn new(joint: &mut JointSpace, observer: usize) -> Self {
        let count = joint.states().len();
        let mut out = Vec::with_capacity(count);
        for state in 0..count {
            let range = joint.states().edge_range(StateId(state as u32));
            let step = |edge| Step {
                symbol: joint.symbol(observer, edge).index() as u32,
                state: joint.states().all_edges()[edge].target.0,
                place: 0,
            };
            out.push(range.map(step).collect());
        }
        let mut out = Rows::new(out);
        let mut into = vec![Vec::new(); count];
        for state in 0..count {
            let (begin, end) = (out.ends[state], out.ends[state + 1]);
            for (place, step) in out.steps[begin..end].iter_mut().enumerate() {
                step.place = place as u32;
                into[step.state as usize].push(Step { state: state as u32, ..*step });
            }
        }
        Self { out, into: Rows::new(into) }
    }

    /// How many states there are.
    pub(super) fn states(&self) -> usize {
        self.out.ends.len() - 1
    }

    /// The transitions out of a state, by symbol.
    pub(super) fn out(&self, state: u32) -> &[Step] {
        self.out.of(state as usize)
    }

    /// The transitions into a state, by symbol.
    pub(super) fn into(&self, state: u32) -> &[Step] {
        self.into.of(state as usize)
    }

    /// How many pairs of transitions look the same: what a table over pairs of states takes to
    /// fill.
    pub(super) fn same_looking_pairs(&self) -> u64 {
        let mut counts: Vec<u64> = Vec::new();
        for step in &self.out.steps {
            let symbol = step.symbol as usize;
            counts.resize(counts.len().max(symbol + 1), 0);
            counts[symbol] += 1;
        }
        counts.iter().map(|count| count.saturating_mul(*count)).fold(0, u64::saturating_add)
    }
}

/// Those with this symbol, among transitions by symbol.
pub(super) fn with_symbol(steps: &[Step], symbol: u32) -> &[Step] {
    let begin = steps.partition_point(|step| step.symbol < symbol);
    let end = steps.partition_point(|step| step.symbol <= symbol);
    &steps[begin..end]
}
