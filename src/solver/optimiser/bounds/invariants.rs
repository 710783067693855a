//! The bound by linear invariants over facts: observable classes without listing a state.
//!
//! Give every fact a weight and a state the sum of the weights of its facts. Where each operator
//! changes the sum by an amount that its symbol determines, and the sum is one and the same over the
//! initial belief, the observer always knows the sum: no two states with different sums are ever in
//! one belief. Such weights are the solutions of linear equations, one for each operator, found by
//! Gaussian elimination. Where the amount is 0 for every operator, the sum never changes at all.
//!
//! Where the observer always knows the value of some group, such as the place of the only airplane,
//! only the operators that may apply at that value are compared.
//!
//! Any field does. Over a large prime field one solution at random tells apart nearly all that the
//! solutions together do; over GF(2) 64 of them do, and parities are found that way. What they
//! confuse makes the bound higher, never wrong.
//!
//! A goal can survive for an enemy only if some state that satisfies it, whatever its groups of
//! exclusive facts hold otherwise, has the sum of the final state; so the bound is the greatest
//! number of such goals over the sums of states that satisfy the true goal. Sums are added up group
//! by group. In Logistics the sums are how many packages are in each city.

use rustc_hash::{FxHashMap, FxHashSet};

use super::elimination::{Sum, Vector, Weights, combine, plus};
use super::{Bound, Most};
use crate::limits::LimitReached;
use crate::problem::{Problem, Role};
use crate::sensor::{Sensor, Symbol};
use crate::solver::Watched;
use crate::solver::ground::transition_graphs::{Change, TransitionGraphs, changes, value_count};
use crate::solver::optimiser::space::Space;
use crate::solver::optimiser::thresholds::{
    BELIEVED_OF_INVARIANTS, CONTEXTS_OF_INVARIANTS, FACTS_OF_INVARIANTS, OPERATORS_OF_INVARIANTS,
    SUMS_OF_INVARIANTS,
};
use crate::task::{Fact, OperatorId, State, Task};

/// The bound.
#[derive(Debug)]
pub(in crate::solver::optimiser) struct Invariants;

/// What an operator changes: one vector it may come to, and differences from it to all others.
struct Effect {
    changes: Vec<Change>,
    /// Values that it asks of groups.
    asks: Vec<(usize, usize)>,
    base: Vector,
    differences: Vec<Vector>,
}

/// A problem as invariants see it.
struct Facts<'a> {
    task: &'a Task,
    effects: Vec<Effect>,
    /// By group: the values it can have.
    values: Vec<Vec<usize>>,
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
        let mut facts = Self { task, effects: Vec::new(), values };
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
            let effect = facts.effect(changes, asks);
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

    fn effect(&self, changes: Vec<Change>, asks: Vec<(usize, usize)>) -> Effect {
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
                    let values = &self.values[change.group];
                    let Some(&first) = values.first() else { continue };
                    let step = self.step(change.group, first, change.to);
                    effect.base = combine(&[(&effect.base, 1), (&step, 1)]);
                    let others = values.iter().skip(1);
                    let differ = others.map(|&value| self.step(change.group, value, first));
                    effect.differences.extend(differ);
                }
            }
        }
        effect.changes = changes;
        effect
    }

    /// Weights whose sum no operator changes.
    fn unchanging(&self) -> Option<Weights> {
        let mut vectors = FxHashSet::default();
        for effect in &self.effects {
            vectors.insert(effect.base.clone());
            vectors.extend(effect.differences.iter().cloned());
        }
        Weights::orthogonal_to(&vectors, self.task.fact_count())
    }

    /// The groups whose values an observer always knows, since it knows them at first and each symbol
    /// determines the next value from the present one; in every combination of values.
    fn contexts(&self, symbols: &[Vec<usize>], believed: &[Vec<Fact>]) -> Vec<Vec<(usize, usize)>> {
        let layout = self.task.layout();
        let begins = |group: usize| {
            let value = |state: &Vec<Fact>| {
                let fact = state.iter().find(|fact| layout.group(**fact) == group);
                fact.map_or(0, |fact| layout.value(*fact))
            };
            let mut values = believed.iter().map(value);
            let first = values.next();
            values.all(|value| Some(value) == first)
        };
        let mut contexts: Vec<Vec<(usize, usize)>> = vec![Vec::new()];
        for (group, values) in self.values.iter().enumerate() {
            // A group that no operator asks for makes no difference to which of them apply.
            let asked = self.effects.iter().any(|e| e.asks.iter().any(|ask| ask.0 == group));
            if values.len() * contexts.len() > CONTEXTS_OF_INVARIANTS
                || !asked
                || !begins(group)
                || !values.iter().all(|value| self.is_determined(group, *value, symbols))
            {
                continue;
            }
            let with = |context: &Vec<(usize, usize)>| {
                let context = context.clone();
                values.iter().map(move |value| [context.clone(), vec![(group, *value)]].concat())
            };
            contexts = contexts.iter().flat_map(with).collect();
        }
        contexts
    }

    /// Whether each symbol determines the next value of a group from one value.
    fn is_determined(&self, group: usize, value: usize, symbols: &[Vec<usize>]) -> bool {
        let mut next: FxHashMap<usize, usize> = FxHashMap::default();
        for (effect, symbols) in self.effects.iter().zip(symbols) {
            if effect.asks.iter().any(|ask| ask.0 == group && ask.1 != value) {
                continue;
            }
            let mut to = value;
            for change in effect.changes.iter().filter(|change| change.group == group) {
                match change.from {
                    // What a fact that is deleted unasked leaves may be one thing or the other.
                    Some(from) if change.optional && from == value => return false,
                    Some(from) if from != value => {}
                    _ => to = change.to,
                }
            }
            for symbol in symbols {
                if *next.entry(*symbol).or_insert(to) != to {
                    return false;
                }
            }
        }
        true
    }

    /// Weights whose sum an observer always knows: in each combination of values that it knows, all
    /// operators that may apply and give one symbol change the sum alike.
    fn known_by(&self, sensor: &Sensor, believed: &[Vec<Fact>]) -> Option<Weights> {
        let mut vectors = FxHashSet::default();
        let symbols: Vec<Vec<usize>> = (0..self.effects.len())
            .map(|number| sensor.symbols_of(OperatorId::new(number)).map(Symbol::index).collect())
            .collect();
        for effect in &self.effects {
            vectors.extend(effect.differences.iter().cloned());
        }
        for context in self.contexts(&symbols, believed) {
            let mut first: FxHashMap<usize, &Vector> = FxHashMap::default();
            for (effect, symbols) in self.effects.iter().zip(&symbols) {
                let conflicts = |known: &(usize, usize)| {
                    effect.asks.iter().any(|ask| ask.0 == known.0 && ask.1 != known.1)
                };
                if context.iter().any(conflicts) {
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
        Weights::orthogonal_to(&vectors, self.task.fact_count())
    }

    fn sum(&self, weights: &Weights, facts: &[Fact]) -> Sum {
        let _ = self;
        facts.iter().fold((0, 0), |sum, fact| plus(sum, weights.of(fact.index())))
    }

    /// The sums under several weights of all states that satisfy a goal; none where there are too
    /// many.
    fn sums(&self, goal: &[Fact], weights: &[&Weights]) -> Option<FxHashSet<Vec<Sum>>> {
        let layout = self.task.layout();
        let mut sums: FxHashSet<Vec<Sum>> = FxHashSet::from_iter([vec![(0, 0); weights.len()]]);
        for (group, values) in self.values.iter().enumerate() {
            let asked: Vec<usize> = goal
                .iter()
                .filter(|fact| layout.group(**fact) == group)
                .map(|fact| layout.value(*fact))
                .collect();
            let fits = |value: &&usize| asked.iter().all(|asked| asked == *value);
            let mut choices: Vec<Vec<Sum>> = Vec::new();
            for &value in values.iter().filter(fits) {
                let fact = self.fact(group, value);
                let choice: Vec<Sum> =
                    weights.iter().map(|w| fact.map_or((0, 0), |fact| w.of(fact))).collect();
                if !choices.contains(&choice) {
                    choices.push(choice);
                }
            }
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
struct Enemy {
    observer: usize,
    weights: Weights,
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
        let unchanging = facts.unchanging()?;
        let start = facts.sum(&unchanging, &task.facts_of(task.initial_state().words()));
        let mut enemies = Vec::new();
        for (observer, watched) in problem.observers().iter().enumerate() {
            if watched.role != Role::Adversarial {
                continue;
            }
            let believed = watched.initial_belief.listed()?.iter();
            let believed: Vec<Vec<Fact>> =
                believed.map(|state| task.facts_of(state.words())).collect();
            let weights = facts.known_by(&watched.sensor, &believed)?;
            let begins: FxHashSet<Sum> =
                believed.iter().map(|state| facts.sum(&unchanging, state)).collect();
            let mut goals = Vec::new();
            for goal in problem.goals() {
                let sums = facts.sums(&goal.condition, &[&unchanging, &weights])?;
                let possible = sums.into_iter().filter(|sum| begins.contains(&sum[0]));
                goals.push(possible.map(|sum| sum[1]).collect());
            }
            enemies.push(Enemy { observer, weights, goals });
        }
        let all: Vec<&Weights> =
            [&unchanging].into_iter().chain(enemies.iter().map(|enemy| &enemy.weights)).collect();
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
