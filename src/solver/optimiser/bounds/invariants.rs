//! The bound by linear invariants over facts: observable classes without listing a state.
//!
//! Give every fact a weight and a state the sum of the weights of its facts. Where each operator
//! changes the sum by an amount that its symbol determines, and the sum is one and the same over the
//! initial belief, the observer always knows the sum: no two states with different sums are ever in
//! one belief. Such weights are the solutions of linear equations, one for each operator, found by
//! Gaussian elimination. Where the amount is 0 for every operator, the sum never changes at all.
//!
//! Where the observer always [knows](super::known_values) the value of some group, such as the place of the only airplane, or
//! one of its blocks, only the operators that may apply then are compared, and states in different blocks are told apart.
//!
//! Any field does. Over a large prime field one solution at random tells apart nearly all that the
//! solutions together do; over GF(2) 64 of them do, and parities are found that way. What they
//! confuse makes the bound higher, never wrong.
//!
//! A goal can survive for an enemy only if some state that satisfies it, whatever its groups of
//! exclusive facts hold otherwise of what is not [excluded](super::mutual_exclusion), has the sum of the final state; so the bound is the greatest
//! number of such goals over the sums of states that satisfy the true goal. Sums are added up group
//! by group. In Logistics the sums are how many packages are in each city. Where there are too many sums,
//! [redundant groups](super::redundant_groups) are left out, then the facts that add to them in the most ways: the invariants
//! over the others hold still.

#[cfg(test)]
mod tests;

use rustc_hash::{FxHashMap, FxHashSet};

use super::elimination::{Sum, Vector, Weights, combine, plus};
use super::known_values::KnownValues;
use super::mutual_exclusion::MutualExclusion;
use super::triple_exclusion::TripleExclusion;
use super::{Bound, Most, redundant_groups};
use crate::limits::LimitReached;
use crate::problem::{Problem, Role};
use crate::sensor::{Sensor, Symbol};
use crate::solver::Watched;
use crate::solver::ground::thresholds::{
    BELIEVED_OF_INVARIANTS, FACTS_OF_INVARIANTS, OPERATORS_OF_INVARIANTS, SUMS_OF_INVARIANTS,
};
use crate::solver::ground::transition_graphs::{Change, TransitionGraphs, changes, value_count};
use crate::solver::optimiser::space::Space;
use crate::task::{Fact, OperatorId, State, Task};

/// The bound.
#[derive(Debug)]
pub(in crate::solver::optimiser) struct Invariants;

/// What an operator changes: one vector it may come to, and differences from it to all others.
pub(super) struct Effect {
    pub(super) changes: Vec<Change>,
    /// Values that it asks of groups.
    pub(super) asks: Vec<(usize, usize)>,
    base: Vector,
    differences: Vec<Vector>,
}

/// A problem as invariants see it.
pub(super) struct Facts<'a> {
    pub(super) task: &'a Task,
    pub(super) effects: Vec<Effect>,
    /// By group: the values it can have.
    pub(super) values: Vec<Vec<usize>>,
    exclusions: MutualExclusion,
    /// None in large tasks.
    triples: Option<TripleExclusion>,
}

impl<'a> Facts<'a> {
    /// None where an operator has effects that this does not look at.
    fn new(problem: &'a Problem) -> Option<Self> {
        let task = problem.task().as_ref();
        let layout = task.layout();
        let graphs = TransitionGraphs::new(task);
        let listed = problem.observers().iter().map(|o| o.initial_belief.listed());
        let believed = listed.collect::<Option<Vec<_>>>()?.into_iter().flatten();
        let starts: Vec<&[u64]> =
            [task.initial_state()].into_iter().chain(believed).map(State::words).collect();
        let values: Vec<Vec<usize>> = (0..layout.group_count())
            .map(|group| {
                let mut from: Vec<usize> =
                    starts.iter().map(|words| layout.group_value(words, group)).collect();
                from.sort_unstable();
                from.dedup();
                let reached = graphs.reachable(group, &from);
                (0..value_count(task, group)).filter(|value| reached[*value]).collect()
            })
            .collect();
        let exclusions = MutualExclusion::new(task, &starts);
        let triples = TripleExclusion::new(task, &starts);
        let mut facts = Self { task, effects: Vec::new(), values, exclusions, triples };
        for operator in task.operators() {
            let changes = changes(task, operator);
            let certain = |change: &&Change| !change.optional;
            for (place, change) in changes.iter().enumerate() {
                let twice = changes[..place].iter().filter(certain);
                if certain(&change) && twice.into_iter().any(|other| other.group == change.group) {
                    return None;
                }
            }
            let asks = operator.preconditions.iter();
            let asks = asks.map(|fact| (layout.group(*fact), layout.value(*fact))).collect();
            let effect = facts.effect(changes, asks, &operator.preconditions);
            facts.effects.push(effect);
        }
        Some(facts)
    }

    fn fact(&self, group: usize, value: usize) -> Option<usize> {
        let place = value.checked_sub(1)?;
        self.task.layout().facts_of_group(group).get(place).map(|fact: &Fact| fact.index())
    }

    /// From one value of a group to another.
    fn step(&self, group: usize, from: usize, to: usize) -> Vector {
        let lost = self.fact(group, from).map(|fact| (fact, -1));
        let gained = self.fact(group, to).map(|fact| (fact, 1));
        combine(&[(&lost.into_iter().collect(), 1), (&gained.into_iter().collect(), 1)])
    }

    /// Whether a group may have a value where all of some facts hold.
    fn may_have(&self, group: usize, value: usize, held: &[Fact]) -> bool {
        self.fact(group, value).is_none_or(|fact| {
            held.iter().all(|held| self.exclusions.occur_together(fact, held.index()))
                && self.triples.as_ref().is_none_or(|triples| {
                    held.iter().enumerate().all(|(place, one)| {
                        let mut others = held[..place].iter();
                        others.all(|two| triples.occur_together(one.index(), two.index(), fact))
                    })
                })
        })
    }

    /// What an operator with these preconditions does to sums.
    fn effect(&self, mut changes: Vec<Change>, asks: Vec<(usize, usize)>, held: &[Fact]) -> Effect {
        changes.retain(|change| {
            !change.optional
                || change.from.is_none_or(|from| self.may_have(change.group, from, held))
        });
        let (base, differences) = (Vec::new(), Vec::new());
        let mut effect = Effect { changes: Vec::new(), asks, base, differences };
        for change in &changes {
            match change.from {
                Some(from) if change.optional => {
                    effect.differences.push(self.step(change.group, from, change.to));
                }
                Some(from) => {
                    let step = self.step(change.group, from, change.to);
                    effect.base = combine(&[(&effect.base, 1), (&step, 1)]);
                }
                None => {
                    let values = self.values[change.group].iter().copied();
                    let mut values =
                        values.filter(|value| self.may_have(change.group, *value, held));
                    let Some(first) = values.next() else { continue };
                    let step = self.step(change.group, first, change.to);
                    effect.base = combine(&[(&effect.base, 1), (&step, 1)]);
                    let differ = values.map(|value| self.step(change.group, value, first));
                    effect.differences.extend(differ);
                }
            }
        }
        effect.changes = changes;
        effect
    }

    /// Of facts that are left out: a vector for each, which then has no weight.
    fn without(left_out: &[bool]) -> FxHashSet<Vector> {
        let facts = left_out.iter().enumerate().filter(|(_, left_out)| **left_out);
        facts.map(|(fact, _)| vec![(fact, 1)]).collect()
    }

    /// The values of a group in states that satisfy a goal.
    fn values_with(&self, group: usize, goal: &[Fact]) -> impl Iterator<Item = usize> {
        let layout = self.task.layout();
        let asked = goal.iter().find(|asked| layout.group(**asked) == group);
        let asked = asked.map(|asked| layout.value(*asked));
        let fits = move |value: &usize| {
            asked.is_none_or(|asked| asked == *value) && self.may_have(group, *value, goal)
        };
        self.values[group].iter().copied().filter(fits)
    }

    /// In how many ways the values of a group add to sums of states that satisfy a goal.
    fn choices(&self, group: usize, goal: &[Fact], weights: &[&Weights]) -> Vec<Vec<Sum>> {
        let mut choices: Vec<Vec<Sum>> = Vec::new();
        for value in self.values_with(group, goal) {
            let fact = self.fact(group, value);
            let choice: Vec<Sum> =
                weights.iter().map(|w| fact.map_or((0, 0), |fact| w.of(fact))).collect();
            if !choices.contains(&choice) {
                choices.push(choice);
            }
        }
        choices
    }

    /// Weights whose sum no operator changes.
    pub(super) fn unchanging(&self, left_out: &[bool]) -> Option<Weights> {
        let mut vectors = Self::without(left_out);
        for effect in &self.effects {
            vectors.insert(effect.base.clone());
            vectors.extend(effect.differences.iter().cloned());
        }
        Weights::orthogonal_to(&vectors, self.task.fact_count())
    }

    /// Weights whose sum an observer always knows: in each combination of values that it knows, all
    /// operators that may apply and give one symbol change the sum alike.
    fn known_by(
        &self,
        sensor: &Sensor,
        believed: &[Vec<Fact>],
        left_out: &[bool],
    ) -> Option<Weights> {
        let mut vectors = Self::without(left_out);
        let symbols: Vec<Vec<usize>> = (0..self.effects.len())
            .map(|number| sensor.symbols_of(OperatorId::new(number)).map(Symbol::index).collect())
            .collect();
        for effect in &self.effects {
            vectors.extend(effect.differences.iter().cloned());
        }
        let blocks = KnownValues::new(self, &symbols, believed);
        for context in blocks.contexts(self) {
            let mut first: FxHashMap<usize, &Vector> = FxHashMap::default();
            for (effect, symbols) in self.effects.iter().zip(&symbols) {
                if blocks.excludes(&context, effect) {
                    continue;
                }
                for symbol in symbols {
                    let known = first.entry(*symbol).or_insert(&effect.base);
                    vectors.insert(combine(&[(known, 1), (&effect.base, -1)]));
                }
            }
        }
        let as_vector =
            |facts: &Vec<Fact>| facts.iter().map(|f| (f.index(), 1)).collect::<Vector>();
        if let Some((start, others)) = believed.split_first() {
            let start = as_vector(start);
            for other in others {
                vectors.insert(combine(&[(&as_vector(other), 1), (&start, -1)]));
            }
        }
        let mut weights = Weights::orthogonal_to(&vectors, self.task.fact_count())?;
        let groups = (0..self.values.len()).map(|group| self.task.layout().facts_of_group(group));
        for (group, of_group) in groups.enumerate() {
            if of_group.iter().all(|fact| !left_out[fact.index()]) {
                let blocks = of_group.iter().map(|fact| {
                    (fact.index(), blocks.block(group, self.task.layout().value(*fact)))
                });
                weights.tell_apart(group, blocks.filter(|(_, block)| *block != 0));
            }
        }
        Some(weights)
    }

    fn sum(&self, weights: &Weights, facts: &[Fact]) -> Sum {
        let _ = self;
        facts.iter().fold((0, 0), |sum, fact| plus(sum, weights.of(fact.index())))
    }

    /// The sums under several weights of all states that satisfy a goal; none where there are too
    /// many.
    fn sums(&self, goal: &[Fact], weights: &[&Weights]) -> Option<FxHashSet<Vec<Sum>>> {
        let mut sums: FxHashSet<Vec<Sum>> = FxHashSet::from_iter([vec![(0, 0); weights.len()]]);
        for group in 0..self.values.len() {
            let choices = self.choices(group, goal, weights);
            let mut next = FxHashSet::default();
            for sum in &sums {
                for choice in &choices {
                    next.insert(sum.iter().zip(choice).map(|(a, b)| plus(*a, *b)).collect());
                }
            }
            if next.len() > SUMS_OF_INVARIANTS {
                return None;
            }
            sums = next;
        }
        Some(sums)
    }
}

/// An enemy: the weights it knows, and the sums at which each goal can survive for it.
struct Enemy<'a> {
    observer: usize,
    weights: &'a Weights,
    goals: Vec<FxHashSet<Sum>>,
}

impl Invariants {
    /// The bound; none where it would take too much.
    fn compute(space: &Space) -> Option<Most> {
        let problem = space.problem();
        let task = problem.task();
        let believed = problem.observers().iter().map(|o| o.initial_belief.count().as_f64());
        let believed = believed.sum::<f64>() as usize;
        if task.fact_count() > FACTS_OF_INVARIANTS
            || task.operators().len() > OPERATORS_OF_INVARIANTS
            || believed > BELIEVED_OF_INVARIANTS
        {
            return None;
        }
        let facts = Facts::new(problem)?;
        let mut left_out = vec![false; task.fact_count()];
        let mut redundant = true;
        loop {
            let unchanging = facts.unchanging(&left_out)?;
            let known = Self::known(problem, &facts, &left_out)?;
            if let Some(most) = Self::most_of(space, &facts, &unchanging, &known) {
                return Some(most);
            }
            // There are too many sums.
            if std::mem::take(&mut redundant)
                && redundant_groups::leave_out(problem, &facts, &mut left_out).is_some()
            {
                continue;
            }
            // Without the facts that add to them in the most ways there are fewer.
            let choices = Self::most_choices(problem, &facts, &unchanging, &known);
            let most = choices.iter().copied().max().filter(|most| *most > 1)?;
            for (group, _) in choices.iter().enumerate().filter(|(_, count)| **count == most) {
                for goal in problem.goals() {
                    for value in facts.values_with(group, &goal.condition) {
                        facts.fact(group, value).into_iter().for_each(|fact| left_out[fact] = true);
                    }
                }
            }
        }
    }

    /// By group: in how many ways its values add to sums, for the goal with the most.
    fn most_choices(
        problem: &Problem,
        facts: &Facts<'_>,
        unchanging: &Weights,
        known: &[Weights],
    ) -> Vec<usize> {
        let weights: Vec<&Weights> = [unchanging].into_iter().chain(known).collect();
        let of_group = |group: usize| {
            let goals = problem.goals().iter();
            let choices = goals.map(|goal| facts.choices(group, &goal.condition, &weights).len());
            choices.max().unwrap_or(0)
        };
        (0..facts.values.len()).map(of_group).collect()
    }

    /// What each enemy knows.
    pub(super) fn known(
        problem: &Problem,
        facts: &Facts<'_>,
        left_out: &[bool],
    ) -> Option<Vec<Weights>> {
        let enemies = problem.observers().iter().filter(|o| o.role == Role::Adversarial);
        enemies
            .map(|enemy| {
                let believed = enemy.initial_belief.listed()?.iter();
                let believed: Vec<Vec<Fact>> =
                    believed.map(|state| facts.task.facts_of(state.words())).collect();
                facts.known_by(&enemy.sensor, &believed, left_out)
            })
            .collect()
    }

    /// The bound by these weights; none where there are too many sums.
    fn most_of(
        space: &Space,
        facts: &Facts<'_>,
        unchanging: &Weights,
        known: &[Weights],
    ) -> Option<Most> {
        let problem = space.problem();
        let task = problem.task();
        let start = facts.sum(unchanging, &task.facts_of(task.initial_state().words()));
        let mut enemies = Vec::new();
        let adversarial =
            problem.observers().iter().enumerate().filter(|(_, o)| o.role == Role::Adversarial);
        for ((observer, watched), weights) in adversarial.zip(known) {
            let believed = watched.initial_belief.listed()?.iter();
            let begins: FxHashSet<Sum> = believed
                .map(|state| facts.sum(unchanging, &task.facts_of(state.words())))
                .collect();
            let mut goals = Vec::new();
            for goal in problem.goals() {
                let sums = facts.sums(&goal.condition, &[unchanging, weights])?;
                let possible = sums.into_iter().filter(|sum| begins.contains(&sum[0]));
                goals.push(possible.map(|sum| sum[1]).collect());
            }
            enemies.push(Enemy { observer, weights, goals });
        }
        let all: Vec<&Weights> =
            [unchanging].into_iter().chain(enemies.iter().map(|enemy| enemy.weights)).collect();
        let ends = facts.sums(task.goal(), &all)?;
        let bounds = &space.bounds;
        let of = |list: &[Watched], observer: usize| -> FxHashSet<usize> {
            list.iter().filter(|w| w.observer == observer).map(|w| w.goal).collect()
        };
        let friends =
            problem.observers().iter().enumerate().filter(|(_, o)| o.role == Role::Cooperative);
        let least = friends.map(|(observer, _)| {
            let mut left = of(&bounds.required, observer);
            left.insert(problem.true_goal());
            left.len()
        });
        let least = least.max().unwrap_or(1);
        let mut most: Option<i64> = None;
        for end in ends.iter().filter(|end| end[0] == start) {
            let mut survivors = problem.goals().len();
            let mut allowed = true;
            for (enemy, sum) in enemies.iter().zip(&end[1..]) {
                let possible = |goal: &usize| enemy.goals[*goal].contains(sum);
                let forbidden = of(&bounds.forbidden, enemy.observer);
                allowed &= of(&bounds.required, enemy.observer).iter().all(possible);
                let left = (0..problem.goals().len()).filter(|goal| !forbidden.contains(goal));
                survivors = survivors.min(left.filter(possible).count());
            }
            allowed &= bounds.at_least.is_none_or(|k| survivors >= k)
                && bounds.at_most.is_none_or(|j| least <= j);
            if allowed {
                let value = survivors as i64 - least as i64;
                most = Some(most.map_or(value, |known| known.max(value)));
            }
        }
        Some(most.map_or(Most::Infeasible, Most::Value))
    }
}

impl Bound for Invariants {
    fn name(&self) -> &'static str {
        "linear invariants"
    }

    fn most(&mut self, space: &mut Space) -> Result<Most, LimitReached> {
        Ok(Self::compute(space).unwrap_or(Most::Unaffordable))
    }
}
