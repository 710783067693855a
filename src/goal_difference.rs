//! Which candidate goals survive in a belief, and the goal difference.
//!
//! A goal survives when some believed state satisfies it: `G_i = {G | ∃ s ∈ B_i: s ⊨ G}`. The goal
//! difference of Definition 2 is `GD = (|G_X| − |G_C|) / (n − 1)`, between −1 and 1.

use fixedbitset::FixedBitSet;
use rustc_hash::FxHashMap;

use crate::belief::{BeliefId, BeliefSpace, Members};
use crate::task::{Fact, StateId, StateSpace};

/// A set of candidate goals, by their positions in the problem.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct GoalSet(FixedBitSet);

impl GoalSet {
    /// No goal, of `count`.
    pub fn none(count: usize) -> Self {
        Self(FixedBitSet::with_capacity(count))
    }

    /// How many goals are in the set.
    pub fn len(&self) -> usize {
        self.0.count_ones(..)
    }

    /// Whether no goal is in the set.
    pub fn is_empty(&self) -> bool {
        self.0.is_clear()
    }

    /// Whether a goal is in the set.
    pub fn contains(&self, goal: usize) -> bool {
        self.0.contains(goal)
    }

    /// Adds a goal.
    pub fn insert(&mut self, goal: usize) {
        self.0.insert(goal);
    }

    /// The goals in the set, in order.
    pub fn iter(&self) -> impl Iterator<Item = usize> + '_ {
        self.0.ones()
    }
}

/// The goal difference of two counts of surviving goals, of `goals` candidates.
///
/// ```
/// use mo_copp::goal_difference::goal_difference;
/// // The delivery of Figure 1: both packages from factory A, then one from each.
/// assert_eq!(goal_difference(6, 1, 6), 1.0);
/// assert_eq!(goal_difference(6, 4, 6), 0.4);
/// ```
pub fn goal_difference(adversarial: usize, cooperative: usize, goals: usize) -> f64 {
    let numerator = adversarial as f64 - cooperative as f64;
    numerator / (goals as f64 - 1.0)
}

/// A goal difference may have been rounded to three decimals.
const ROUNDING: f64 = 0.000_5 + 1e-9;

/// The goal difference meant by a number that may have been rounded to three decimals, of `goals` candidates; the number
/// itself where none is so near.
///
/// ```
/// use mo_copp::goal_difference::nearest;
/// assert_eq!(nearest(0.667, 4), 2.0 / 3.0);
/// assert_eq!(nearest(0.6, 4), 0.6);
/// ```
pub fn nearest(number: f64, goals: usize) -> f64 {
    let most = goals as f64 - 1.0;
    let near = (number * most).round() / most;
    if (near - number).abs() <= ROUNDING { near } else { number }
}

/// A number that has to do with goal differences of `goals` candidates, as readers see it everywhere: a fraction in its lowest
/// terms where it is one of `goals − 1`, else with at most three decimals.
///
/// ```
/// use mo_copp::goal_difference::written;
/// assert_eq!(written(0.4, 6), "2/5");
/// assert_eq!(written(-4.0 / 6.0, 7), "−2/3");
/// assert_eq!(written(1.0, 7), "1");
/// assert_eq!(written(0.1234, 7), "0.123");
/// ```
pub fn written(difference: f64, goals: usize) -> String {
    let most = goals.saturating_sub(1);
    let numerator = (difference * most as f64).round();
    let rounded = (difference * 1000.0).round() / 1000.0;
    let sign = if rounded < 0.0 { "−" } else { "" };
    if rounded.fract() == 0.0 && (rounded - difference).abs() < 1e-9 {
        return format!("{sign}{}", rounded.abs());
    }
    if most == 0 || (numerator / most as f64 - difference).abs() >= 1e-9 {
        return format!("{sign}{}", rounded.abs());
    }
    let numerator = numerator.abs() as usize;
    let (mut shared, mut rest) = (most, numerator);
    while rest > 0 {
        (shared, rest) = (rest, shared % rest);
    }
    format!("{sign}{}/{}", numerator / shared, most / shared)
}

/// Works out survivors, once for each belief. States that satisfy the same goals share a class, so
/// that a large belief is one pass over small numbers.
#[derive(Debug, Clone)]
pub(crate) struct Survivors {
    goals: Vec<Vec<Fact>>,
    /// Class of each state, by state number; class 0 satisfies no goal.
    classes: Vec<u32>,
    sets: Vec<GoalSet>,
    numbers: FxHashMap<GoalSet, u32>,
    /// Number of the set of each belief, by observer and belief.
    of_beliefs: Vec<Vec<Option<u32>>>,
}

impl Survivors {
    /// For goals as conjunctions of facts, and a number of observers.
    pub fn new(goals: Vec<Vec<Fact>>, observers: usize) -> Self {
        let none = GoalSet::none(goals.len());
        Self {
            goals,
            classes: Vec::new(),
            sets: vec![none.clone()],
            numbers: FxHashMap::from_iter([(none, 0)]),
            of_beliefs: vec![Vec::new(); observers],
        }
    }

    fn number(&mut self, set: GoalSet) -> u32 {
        if let Some(&number) = self.numbers.get(&set) {
            return number;
        }
        let number = self.sets.len() as u32;
        self.sets.push(set.clone());
        self.numbers.insert(set, number);
        number
    }

    fn class(&mut self, states: &StateSpace, state: StateId) -> u32 {
        for index in self.classes.len()..=state.index() {
            let words = states.words(StateId(index as u32));
            let mut set = GoalSet::none(self.goals.len());
            for (goal, condition) in self.goals.iter().enumerate() {
                if states.task().satisfies(words, condition) {
                    set.insert(goal);
                }
            }
            let class = self.number(set);
            self.classes.push(class);
        }
        self.classes[state.index()]
    }

    /// The goals that a state satisfies.
    pub fn of_state(&mut self, states: &StateSpace, state: StateId) -> &GoalSet {
        let class = self.class(states, state);
        &self.sets[class as usize]
    }

    fn survivors(&mut self, states: &StateSpace, members: Members<'_>) -> GoalSet {
        let mut union = GoalSet::none(self.goals.len());
        match members {
            Members::Listed(list) => {
                let mut seen = FixedBitSet::with_capacity(self.sets.len());
                for &state in list {
                    seen.grow_and_insert(self.class(states, state) as usize);
                }
                for class in seen.ones() {
                    union.0.union_with(&self.sets[class].0);
                }
            }
            Members::Diagram(diagrams, set) => {
                for (goal, condition) in self.goals.iter().enumerate() {
                    if diagrams.satisfies(set, condition) {
                        union.insert(goal);
                    }
                }
            }
        }
        union
    }

    /// The goals that survive in a belief of the observer at position `observer`.
    pub fn of_belief(
        &mut self,
        states: &StateSpace,
        observer: usize,
        beliefs: &BeliefSpace,
        belief: BeliefId,
    ) -> &GoalSet {
        let known = self.of_beliefs[observer].get(belief.index()).copied().flatten();
        let number = if let Some(number) = known {
            number
        } else {
            let union = self.survivors(states, beliefs.members(belief));
            let number = self.number(union);
            let row = &mut self.of_beliefs[observer];
            row.resize(row.len().max(belief.index() + 1), None);
            row[belief.index()] = Some(number);
            number
        };
        &self.sets[number as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_goal_difference_is_told_from_three_decimals_and_written_exactly() {
        for goals in 2..=40 {
            for numerator in -(goals as i32 - 1)..goals as i32 {
                let exact = f64::from(numerator) / (goals as f64 - 1.0);
                let rounded: f64 = format!("{exact:.3}").parse().unwrap();
                assert_eq!(nearest(rounded, goals), exact, "{numerator} of {goals}");
                assert_eq!(nearest(exact, goals), exact, "{numerator} of {goals}");
                let text = written(exact, goals);
                let plain = text.replace('−', "-");
                let told = match plain.split_once('/') {
                    Some((above, below)) => {
                        above.parse::<f64>().unwrap() / below.parse::<f64>().unwrap()
                    }
                    None => plain.parse().unwrap(),
                };
                assert!((told - exact).abs() < 1e-12, "{text} for {numerator} of {goals}");
            }
        }
    }

    #[test]
    fn other_numbers_stay_as_they_are() {
        assert_eq!(nearest(0.668, 4), 0.668);
        assert_eq!(written(0.668, 4), "0.668");
        assert_eq!(written(-1.0 / 3.0, 4), "−1/3");
        assert_eq!(written(0.125, 9), "1/8");
        assert_eq!(written(0.0625, 17), "1/16");
        assert_eq!(written(-0.0, 4), "0");
        assert_eq!(written(-1.0, 4), "−1");
        assert_eq!(written(0.0, 4), "0");
        assert_eq!(written(1.0, 1), "1");
    }
}
