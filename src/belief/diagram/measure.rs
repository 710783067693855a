//! What a set of states comes to: its size, in how many of its states each fact holds, some of its states.

use rustc_hash::{FxHashMap, FxHashSet};

use crate::task::{Fact, State};

use super::store::{Diagrams, SetId};

/// A number of states: exact up to 2⁶⁴ − 1, beyond that to the nearest number that a float holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StateCount {
    /// So many.
    Exact(u64),
    /// About so many, 2⁶⁴ or more.
    About(f64),
}

impl StateCount {
    /// The number, as near as a float holds it.
    pub fn as_f64(self) -> f64 {
        match self {
            Self::Exact(count) => count as f64,
            Self::About(count) => count,
        }
    }

    fn plus(self, other: Self) -> Self {
        match (self, other) {
            (Self::Exact(a), Self::Exact(b)) => match a.checked_add(b) {
                Some(sum) => Self::Exact(sum),
                None => Self::About(a as f64 + b as f64),
            },
            (a, b) => Self::About(a.as_f64() + b.as_f64()),
        }
    }

    fn times(self, other: Self) -> Self {
        match (self, other) {
            (Self::Exact(a), Self::Exact(b)) => match a.checked_mul(b) {
                Some(product) => Self::Exact(product),
                None => Self::About(a as f64 * b as f64),
            },
            (Self::Exact(0), _) | (_, Self::Exact(0)) => Self::Exact(0),
            (a, b) => Self::About(a.as_f64() * b.as_f64()),
        }
    }
}

/// A number in JSON.
impl serde::Serialize for StateCount {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Exact(count) => serializer.serialize_u64(*count),
            Self::About(count) => serializer.serialize_f64(*count),
        }
    }
}

impl std::fmt::Display for StateCount {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Exact(count) => count.fmt(f),
            Self::About(count) => write!(f, "about {count:.2e}"),
        }
    }
}

impl Diagrams {
    /// How many states a set has. Linear in its nodes.
    pub fn count(&self, set: SetId) -> StateCount {
        let mut below = FxHashMap::default();
        self.count_below(set, &mut below)
    }

    fn count_below(&self, set: SetId, done: &mut FxHashMap<SetId, StateCount>) -> StateCount {
        match set {
            SetId::EMPTY => return StateCount::Exact(0),
            SetId::END => return StateCount::Exact(1),
            _ => {}
        }
        if let Some(&known) = done.get(&set) {
            return known;
        }
        let mut sum = StateCount::Exact(0);
        for branch in self.branches(set) {
            sum = sum.plus(self.count_below(branch.below, done));
        }
        done.insert(set, sum);
        sum
    }

    /// The values of each group that occur in some state of a set, in order. Linear in its nodes.
    pub fn values(&self, set: SetId) -> Vec<Vec<u32>> {
        let mut found = vec![Vec::new(); self.depth() as usize];
        let mut met = FxHashSet::from_iter([SetId::EMPTY, SetId::END]);
        let mut left = vec![set];
        while let Some(set) = left.pop() {
            if met.insert(set) {
                let here = &mut found[self.group(set)];
                here.extend(self.branches(set).iter().map(|branch| branch.value));
                left.extend(self.branches(set).iter().map(|branch| branch.below));
            }
        }
        for values in &mut found {
            values.sort_unstable();
            values.dedup();
        }
        found
    }

    /// Whether a set has more than so many states. Each node is gone through once, however many sets are asked for.
    pub fn has_more_than(&mut self, set: SetId, states: usize) -> bool {
        for id in self.counts.len()..self.len() {
            let below = self.branches(SetId(id as u32)).iter();
            let count =
                below.map(|branch| self.counts[branch.below.index()]).fold(0, u64::saturating_add);
            self.counts.push(count);
        }
        self.counts[set.index()] > states as u64
    }

    /// At most so many states of a set, spread over it evenly; all of them where there are no more.
    pub fn spread_states(&self, set: SetId, most: usize) -> Vec<State> {
        let mut states = Vec::new();
        let mut spread = Spread { done: FxHashMap::default(), values: Vec::new() };
        spread.walk(self, set, most, &mut states);
        states
    }

    /// In how many states of a set each fact of the task holds, by the facts' numbers. Linear in its nodes.
    pub fn fact_counts(&self, set: SetId) -> Vec<StateCount> {
        let task = self.task();
        let mut counts = vec![StateCount::Exact(0); task.fact_count()];
        let mut by_place = FxHashMap::default();
        for fact in task.facts() {
            let place = (self.level_of(fact), task.layout().value(fact) as u32);
            by_place.insert(place, fact);
        }
        let mut below = FxHashMap::default();
        self.count_below(set, &mut below);
        // Level by level, each node after all that lead to it.
        let mut above: Vec<(SetId, StateCount)> = vec![(set, StateCount::Exact(1))];
        for level in 0..self.depth() {
            let mut next: std::collections::BTreeMap<SetId, StateCount> =
                std::collections::BTreeMap::new();
            for (node, ways) in above {
                for branch in self.branches(node) {
                    let through = ways.times(self.count_below(branch.below, &mut below));
                    if let Some(fact) = by_place.get(&(level, branch.value)) {
                        let count: &mut StateCount = &mut counts[fact.index()];
                        *count = count.plus(through);
                    }
                    let known = next.entry(branch.below).or_insert(StateCount::Exact(0));
                    *known = known.plus(ways);
                }
            }
            above = next.into_iter().collect();
        }
        counts
    }

    /// In how many states of a set a conjunction of facts holds. Linear in its nodes.
    pub fn count_satisfying(&self, set: SetId, condition: &[Fact]) -> StateCount {
        let layout = self.task().layout();
        let mut wanted = std::collections::BTreeMap::new();
        for &fact in condition {
            let (level, value) = (self.level_of(fact), layout.value(fact) as u32);
            if wanted.insert(level, value).is_some_and(|known| known != value) {
                return StateCount::Exact(0);
            }
        }
        let mut done = FxHashMap::default();
        self.count_wanted(set, &wanted, &mut done)
    }

    fn count_wanted(
        &self,
        set: SetId,
        wanted: &std::collections::BTreeMap<u32, u32>,
        done: &mut FxHashMap<SetId, StateCount>,
    ) -> StateCount {
        match set {
            SetId::EMPTY => return StateCount::Exact(0),
            SetId::END => return StateCount::Exact(1),
            _ => {}
        }
        if let Some(&known) = done.get(&set) {
            return known;
        }
        let value = wanted.get(&self.level(set));
        let mut sum = StateCount::Exact(0);
        for branch in self.branches(set) {
            if value.is_none_or(|&value| value == branch.value) {
                sum = sum.plus(self.count_wanted(branch.below, wanted, done));
            }
        }
        done.insert(set, sum);
        sum
    }

    /// The first states of a set, by increasing values of the groups; at most `most`.
    pub fn first_states(&self, set: SetId, most: usize) -> Vec<State> {
        let mut states = Vec::new();
        let mut values = Vec::with_capacity(self.depth() as usize);
        self.walk(set, most, &mut values, &mut states);
        states
    }

    fn walk(&self, set: SetId, most: usize, values: &mut Vec<u32>, states: &mut Vec<State>) {
        if states.len() >= most || set == SetId::EMPTY {
            return;
        }
        if set == SetId::END {
            states.push(self.state(values));
            return;
        }
        for branch in self.branches(set) {
            values.push(branch.value);
            self.walk(branch.below, most, values, states);
            values.pop();
        }
    }
}

/// A walk to states that are spread over a set.
struct Spread {
    done: FxHashMap<SetId, StateCount>,
    values: Vec<u32>,
}

impl Spread {
    /// Each branch has its part of the states wanted.
    fn walk(&mut self, diagrams: &Diagrams, set: SetId, most: usize, states: &mut Vec<State>) {
        if most == 0 || set == SetId::EMPTY {
            return;
        }
        if set == SetId::END {
            states.push(diagrams.state(&self.values));
            return;
        }
        let all = diagrams.count_below(set, &mut self.done).as_f64();
        let mut before = 0.0;
        for branch in diagrams.branches(set) {
            let count = diagrams.count_below(branch.below, &mut self.done).as_f64();
            let part = |count: f64| (count / all * most as f64).floor() as usize;
            let wanted = if all <= most as f64 {
                count as usize
            } else {
                part(before + count) - part(before)
            };
            before += count;
            self.values.push(branch.value);
            self.walk(diagrams, branch.below, wanted, states);
            self.values.pop();
        }
    }
}
