//! A problem as plain tables over positions, and the definitions of the paper on them.

use std::sync::Arc;

use mo_copp::domain::Document;
use mo_copp::problem::{Goal, Observer, Problem, Role, StateNaming};
use mo_copp::sensor::SensorBuilder;
use mo_copp::task::TaskBuilder;
use serde_json::json;

/// A set of states, one bit each.
pub type Set = u128;

/// A set of goals, one bit each.
pub type Goals = u32;

pub fn members(set: Set) -> impl Iterator<Item = usize> {
    (0..128).filter(move |&state| set >> state & 1 == 1)
}

pub fn set(members: &[usize]) -> Set {
    members.iter().fold(0, |set, &state| set | 1 << state)
}

/// The number of a symbol, given one when it is new.
pub fn symbol(names: &mut Vec<String>, name: &str) -> usize {
    names.iter().position(|known| known == name).unwrap_or_else(|| {
        names.push(name.to_owned());
        names.len() - 1
    })
}

/// Somebody who watches.
#[derive(Debug, Clone)]
pub struct Watcher {
    pub role: Role,
    pub belief: Set,
    pub symbols: Vec<String>,
    /// By action and resulting state, a position in `symbols`.
    pub sensor: Vec<Vec<usize>>,
}

/// A problem.
#[derive(Debug, Clone)]
pub struct Table {
    /// As the crate labels them.
    pub states: Vec<String>,
    pub actions: Vec<String>,
    /// The successor, by state and action.
    pub next: Vec<Vec<Option<usize>>>,
    pub start: usize,
    /// The states that satisfy each goal; goals are named G1, G2, ….
    pub goals: Vec<Set>,
    pub goal_names: Vec<String>,
    pub true_goal: usize,
    pub watchers: Vec<Watcher>,
}

impl Table {
    /// `B' = { ŝ | ∃ â, s̄ ∈ B: Γ(s̄, â) = ŝ, O(â, ŝ) = o }`.
    pub fn update(&self, watcher: usize, belief: Set, symbol: usize) -> Set {
        let sensor = &self.watchers[watcher].sensor;
        let mut after = 0;
        for state in members(belief) {
            for (action, target) in self.next[state].iter().enumerate() {
                if let &Some(target) = target
                    && sensor[action][target] == symbol
                {
                    after |= 1 << target;
                }
            }
        }
        after
    }

    /// Goals that some state of the belief satisfies.
    pub fn survivors(&self, belief: Set) -> Goals {
        let alive = |(goal, states): (usize, &Set)| Goals::from(belief & states != 0) << goal;
        self.goals.iter().enumerate().map(alive).sum()
    }

    /// `|G_X|` of the enemy in least doubt and `|G_C|` of the friend in most.
    pub fn counts(&self, survivors: &[Goals]) -> (usize, usize) {
        let (mut adversarial, mut cooperative) = (usize::MAX, 0);
        for (watcher, goals) in self.watchers.iter().zip(survivors) {
            let count = goals.count_ones() as usize;
            match watcher.role {
                Role::Adversarial => adversarial = adversarial.min(count),
                Role::Cooperative => cooperative = cooperative.max(count),
            }
        }
        (adversarial, cooperative)
    }

    pub fn is_goal(&self, state: usize) -> bool {
        self.goals[self.true_goal] >> state & 1 == 1
    }

    /// As an `explicit` document; the watchers must be one enemy and one friend.
    pub fn document(&self) -> String {
        let name = |state: usize| &self.states[state];
        let names = |set: Set| members(set).map(name).collect::<Vec<_>>();
        let mut transitions = Vec::new();
        for (state, row) in self.next.iter().enumerate() {
            for (action, target) in row.iter().enumerate() {
                if let &Some(target) = target {
                    transitions.push([name(state), &self.actions[action], name(target)]);
                }
            }
        }
        let goal =
            |(name, states): (&String, &Set)| json!({"name": name, "states": names(*states)});
        let observer = |role| {
            let watcher = self.watchers.iter().find(|watcher| watcher.role == role).unwrap();
            let mut sensor = Vec::new();
            for (action, row) in watcher.sensor.iter().enumerate() {
                for (state, &symbol) in row.iter().enumerate() {
                    sensor.push([&self.actions[action], name(state), &watcher.symbols[symbol]]);
                }
            }
            json!({"initial_belief": names(watcher.belief), "sensor": sensor})
        };
        json!({
            "format": "explicit",
            "states": self.states,
            "actions": self.actions,
            "transitions": transitions,
            "initial_state": name(self.start),
            "goals": self.goal_names.iter().zip(&self.goals).map(goal).collect::<Vec<_>>(),
            "true_goal": self.goal_names[self.true_goal],
            "observers": {
                "adversarial": observer(Role::Adversarial),
                "cooperative": observer(Role::Cooperative),
            },
        })
        .to_string()
    }

    /// Read by the crate from the document.
    pub fn problem(&self) -> Arc<Problem> {
        Arc::new(Document::parse(&self.document()).unwrap().problem().unwrap())
    }

    /// Built through the Rust API, for any number of watchers: a fact for each state, a fact for
    /// each goal, and as many again as asked for that always hold and mean nothing, so that a state
    /// takes several words.
    pub fn built_problem(&self, padding: usize) -> Arc<Problem> {
        self.built_with_costs(padding, None)
    }

    /// The same with a cost for each action.
    pub fn built_with_costs(&self, padding: usize, costs: Option<&[u64]>) -> Arc<Problem> {
        let mut task = TaskBuilder::default();
        let named: Vec<_> = self.states.iter().map(|name| task.fact(name)).collect();
        task.exclusive(named.clone());
        let pads: Vec<_> = (0..padding).map(|pad| task.fact(format!("pad {pad}"))).collect();
        let goal_facts: Vec<_> = self.goal_names.iter().map(|name| task.fact(name)).collect();
        let facts = |state: usize| {
            let carried = self.goals.iter().zip(&goal_facts);
            let carried = carried.filter(|(states, _)| **states >> state & 1 == 1);
            [named[state]].into_iter().chain(carried.map(|(_, &fact)| fact)).collect::<Vec<_>>()
        };
        let mut pairs = Vec::new();
        for (state, row) in self.next.iter().enumerate() {
            for (action, target) in row.iter().enumerate() {
                if let &Some(target) = target {
                    let before = facts(state);
                    task.operator(&self.actions[action], &before[..1], &facts(target), &before);
                    pairs.push((action, target));
                }
            }
        }
        for (name, &cost) in self.actions.iter().zip(costs.into_iter().flatten()) {
            let action = task.action(name);
            task.cost(action, cost);
        }
        let full = |state: usize| [facts(state).as_slice(), &pads].concat();
        let task = task.build(&full(self.start), &[goal_facts[self.true_goal]]).unwrap();
        let mut observers = Vec::new();
        for (number, watcher) in self.watchers.iter().enumerate() {
            let mut sensor = SensorBuilder::new(&task);
            for ((id, _), &(action, target)) in task.operator_ids().zip(&pairs) {
                sensor.always(id, &watcher.symbols[watcher.sensor[action][target]]);
            }
            observers.push(Observer {
                name: format!("{} {number}", watcher.role.name()),
                role: watcher.role,
                sensor: Arc::new(sensor.build(&task).unwrap()),
                initial_belief: members(watcher.belief)
                    .map(|state| task.state(&full(state)).unwrap())
                    .collect(),
            });
        }
        let goal = |(name, fact): (&String, _)| Goal { name: name.clone(), condition: vec![fact] };
        let goals = self.goal_names.iter().zip(goal_facts).map(goal).collect();
        let names = StateNaming::Names;
        Arc::new(Problem::new(task, goals, self.true_goal, observers, names).unwrap())
    }
}
