//! Tiny STRIPS problems: facts are bits, states are sets of bits.

use std::sync::Arc;

use mo_copp::problem::{Goal, Observer, Problem, Role, StateNaming};
use mo_copp::sensor::SensorBuilder;
use mo_copp::task::{Fact, Task, TaskBuilder};

use super::check::Judge;
use super::dice::Dice;
use super::table::{Table, Watcher, symbol};

/// A set of facts.
pub type Facts = u32;

fn numbers(facts: Facts) -> impl Iterator<Item = usize> {
    (0..32).filter(move |&fact| facts >> fact & 1 == 1)
}

#[derive(Debug, Clone)]
pub struct Op {
    pub name: String,
    pub pre: Facts,
    pub add: Facts,
    pub del: Facts,
}

impl Op {
    /// `Γ(s, a) = (s \ delete(a)) ∪ add(a)` where the preconditions hold.
    fn successor(&self, state: Facts) -> Option<Facts> {
        (state & self.pre == self.pre).then_some(state & !self.del | self.add)
    }
}

pub fn op(name: &str, pre: Facts, add: Facts, del: Facts) -> Op {
    Op { name: name.to_owned(), pre, add, del }
}

/// Sees `symbols[a].1` where the resulting state holds the facts `symbols[a].0`, else
/// `symbols[a].2`.
#[derive(Debug, Clone)]
pub struct Eye {
    pub role: Role,
    pub belief: Vec<Facts>,
    pub symbols: Vec<(Facts, &'static str, &'static str)>,
}

impl Eye {
    /// One symbol for each operator.
    pub fn of_operators(role: Role, belief: &[Facts], symbols: &[&'static str]) -> Self {
        let symbols = symbols.iter().map(|&symbol| (0, symbol, symbol)).collect();
        Self { role, belief: belief.to_vec(), symbols }
    }
}

#[derive(Debug, Clone)]
pub struct Strips {
    pub facts: usize,
    pub ops: Vec<Op>,
    pub start: Facts,
    /// The first is the true one.
    pub goals: Vec<Facts>,
    pub eyes: Vec<Eye>,
}

impl Strips {
    /// Every state that anything any observer believes can lead to, the start first.
    pub fn states(&self) -> Vec<Facts> {
        let mut states = vec![self.start];
        states.extend(self.eyes.iter().flat_map(|eye| &eye.belief));
        let mut all: Vec<Facts> = Vec::new();
        while let Some(state) = states.pop() {
            if !all.contains(&state) {
                all.push(state);
                states.extend(self.ops.iter().filter_map(|op| op.successor(state)));
            }
        }
        all.sort_unstable();
        all
    }

    pub fn table(&self) -> Table {
        let states = self.states();
        let place = |state: Facts| states.iter().position(|&known| known == state).unwrap();
        let label = |state: &Facts| {
            let facts: Vec<String> = numbers(*state).map(|fact| format!("f{fact}")).collect();
            format!("{{{}}}", facts.join(", "))
        };
        let row =
            |&state: &Facts| self.ops.iter().map(|op| op.successor(state).map(place)).collect();
        let goal = |&goal: &Facts| {
            let satisfying = states.iter().enumerate().filter(|(_, state)| *state & goal == goal);
            satisfying.map(|(position, _)| 1 << position).sum()
        };
        let watcher = |eye: &Eye| {
            let mut symbols = Vec::new();
            let sensor = eye.symbols.iter().map(|&(facts, seen, otherwise)| {
                let read = |&state: &Facts| if state & facts == facts { seen } else { otherwise };
                states.iter().map(|state| symbol(&mut symbols, read(state))).collect()
            });
            let sensor = sensor.collect();
            let belief = eye.belief.iter().fold(0, |set, &state| set | 1 << place(state));
            Watcher { role: eye.role, belief, symbols, sensor }
        };
        Table {
            states: states.iter().map(label).collect(),
            actions: self.ops.iter().map(|op| op.name.clone()).collect(),
            next: states.iter().map(row).collect(),
            start: place(self.start),
            goals: self.goals.iter().map(goal).collect(),
            goal_names: (1..=self.goals.len()).map(|goal| format!("G{goal}")).collect(),
            true_goal: 0,
            watchers: self.eyes.iter().map(watcher).collect(),
        }
    }

    pub fn task(&self) -> Task {
        let mut task = TaskBuilder::default();
        let facts: Vec<Fact> = (0..self.facts).map(|fact| task.fact(format!("f{fact}"))).collect();
        let of = |set| numbers(set).map(|fact| facts[fact]).collect::<Vec<_>>();
        for op in &self.ops {
            task.operator(&op.name, &of(op.pre), &of(op.add), &of(op.del));
        }
        task.build(&of(self.start), &of(self.goals[0])).unwrap()
    }

    /// Through the Rust API, fact for fact.
    pub fn judge(&self) -> Judge {
        let task = self.task();
        let facts: Vec<Fact> = task.facts().collect();
        let of = |set| numbers(set).map(|fact| facts[fact]).collect::<Vec<_>>();
        let mut observers = Vec::new();
        for (number, eye) in self.eyes.iter().enumerate() {
            let mut sensor = SensorBuilder::new(&task);
            for ((id, _), &(facts, seen, otherwise)) in task.operator_ids().zip(&eye.symbols) {
                sensor.when(id, &of(facts), seen);
                sensor.always(id, otherwise);
            }
            observers.push(Observer {
                name: format!("watcher {number}"),
                role: eye.role,
                sensor: Arc::new(sensor.build(&task).unwrap()),
                initial_belief: eye.belief.iter().map(|&s| task.state(&of(s)).unwrap()).collect(),
            });
        }
        let goal = |(number, &goal)| Goal { name: format!("G{number}"), condition: of(goal) };
        let goals = (1..).zip(&self.goals).map(goal).collect();
        let problem = Problem::new(task, goals, 0, observers, StateNaming::Facts).unwrap();
        Judge::of(self.table(), Arc::new(problem))
    }

    /// A random one with these roles: operators that share effects, facts that delete each other,
    /// sensors that look at a fact.
    pub fn random(dice: &mut Dice, facts: usize, ops: usize, roles: &[Role]) -> Self {
        let some = |dice: &mut Dice, chance| {
            (0..facts).map(|fact| Facts::from(dice.percent(chance)) << fact).sum::<Facts>()
        };
        let count = dice.between(2, ops);
        let mut list: Vec<Op> = Vec::new();
        for number in 0..count {
            let pre = some(dice, 35);
            let name = format!("op{number}");
            if number > 0 && dice.percent(20) {
                let twin = list[dice.below(number)].clone();
                list.push(Op { name, pre: twin.pre & pre, ..twin });
            } else {
                let add = some(dice, 35);
                list.push(Op { name, pre, add, del: some(dice, 30) & !add });
            }
        }
        let start = some(dice, 50);
        let goal_count = dice.between(2, 3);
        let goals = (0..goal_count).map(|_| 1 << dice.below(facts) | some(dice, 25)).collect();
        let eyes = roles
            .iter()
            .map(|&role| {
                let mut belief = vec![start];
                while dice.percent(40) {
                    belief.push(some(dice, 50));
                }
                belief.sort_unstable();
                belief.dedup();
                let names = &["p", "q", "r"][..dice.between(1, 3)];
                let mut read = || {
                    let looked_at = if dice.percent(30) { 1 << dice.below(facts) } else { 0 };
                    (looked_at, dice.pick(names), dice.pick(names))
                };
                Eye { role, belief, symbols: list.iter().map(|_| read()).collect() }
            })
            .collect();
        Self { facts, ops: list, start, goals, eyes }
    }
}
