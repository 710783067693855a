//! Makes a problem of an explicit document.

use std::sync::Arc;

use rustc_hash::{FxHashMap, FxHashSet};

use super::{Explicit, ExplicitObserver};
use crate::document::{DocumentError, Names};
use crate::domain::observers::{listed, true_goal, unexpected};
use crate::problem::{Goal, Observer, Problem, Role, StateNaming};
use crate::sensor::SensorBuilder;
use crate::task::{Fact, Task, TaskBuilder};

/// What an action is called in messages.
const ACTION: &str = "an action";

/// Names and their positions.
struct Index<'a> {
    kind: &'static str,
    names: Vec<&'a str>,
    positions: FxHashMap<&'a str, usize>,
}

impl<'a> Index<'a> {
    fn new(path: &str, kind: &'static str, names: &'a [String]) -> Result<Self, DocumentError> {
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let mut known = Names::default();
        for (position, name) in names.iter().enumerate() {
            let path = || format!("{path}[{position}]");
            if kind == ACTION {
                known.add_action(name, path)?;
            } else {
                known.add(name, "the name", path)?;
            }
        }
        let positions =
            names.iter().enumerate().map(|(position, name)| (*name, position)).collect();
        Ok(Self { kind, names, positions })
    }

    fn find(&self, name: &str, path: impl Fn() -> String) -> Result<usize, DocumentError> {
        self.positions.get(name).copied().ok_or_else(|| {
            let expected = format!("{} of the document: {}", self.kind, listed(&self.names));
            DocumentError::invalid(path(), format!("{name:?}"), expected)
        })
    }
}

/// The document's names, resolved.
struct Resolved<'a> {
    states: Index<'a>,
    actions: Index<'a>,
    /// State, action, state.
    transitions: Vec<[usize; 3]>,
    initial: usize,
    /// The facts of each state: the one that names it, then a fact for each goal it satisfies.
    facts: Vec<Vec<Fact>>,
}

impl Explicit {
    /// Checks that everything fits together and makes the problem: a fact for each state, a fact
    /// for each goal that its states carry, an operator for each transition.
    ///
    /// # Errors
    ///
    /// [`DocumentError`] with the place of what does not fit.
    pub fn problem(&self) -> Result<Problem, DocumentError> {
        let goal_names: Vec<&str> = self.goals.iter().map(|goal| goal.name.as_str()).collect();
        let true_goal = true_goal(&goal_names, &self.true_goal)?;
        let mut builder = TaskBuilder::default();
        let (resolved, goal_facts) = self.resolve(&mut builder)?;
        for &[from, action, to] in &resolved.transitions {
            let action = resolved.actions.names[action];
            let (from, to) = (&resolved.facts[from], &resolved.facts[to]);
            builder.operator(action, &from[..1], to, from);
        }
        let condition = [goal_facts[true_goal]];
        let task = builder
            .build(&resolved.facts[resolved.initial], &condition)
            .map_err(|error| DocumentError::invalid("document", error.to_string(), "a task"))?;
        let goals = goal_names
            .iter()
            .zip(goal_facts)
            .map(|(name, fact)| Goal { name: (*name).to_owned(), condition: vec![fact] })
            .collect();
        let observers = self
            .observers
            .iter()
            .map(|(role, observer)| self.observer(&task, &resolved, role, observer))
            .collect::<Result<_, _>>()?;
        Problem::new(task, goals, true_goal, observers, StateNaming::Names)
            .map_err(|error| unexpected(&error))
    }

    fn resolve<'a>(
        &'a self,
        builder: &mut TaskBuilder,
    ) -> Result<(Resolved<'a>, Vec<Fact>), DocumentError> {
        let states = Index::new("states", "a state", &self.states)?;
        let actions = Index::new("actions", ACTION, &self.actions)?;
        for action in &actions.names {
            builder.action(action);
        }
        let named: Vec<Fact> = states.names.iter().map(|name| builder.fact(*name)).collect();
        builder.exclusive(named.clone());
        let mut facts: Vec<Vec<Fact>> = named.into_iter().map(|fact| vec![fact]).collect();
        let mut goal_facts = Vec::new();
        for (index, goal) in self.goals.iter().enumerate() {
            let fact = builder.fact(format!("goal {}", goal.name));
            goal_facts.push(fact);
            for (position, name) in goal.states.iter().enumerate() {
                let state = states.find(name, || format!("goals[{index}].states[{position}]"))?;
                if !facts[state].contains(&fact) {
                    facts[state].push(fact);
                }
            }
        }
        let mut transitions = Vec::with_capacity(self.transitions.len());
        let mut seen = FxHashSet::default();
        for (index, [from, action, to]) in self.transitions.iter().enumerate() {
            let path = |part: usize| move || format!("transitions[{index}][{part}]");
            let from = states.find(from, path(0))?;
            let action = actions.find(action, path(1))?;
            let to = states.find(to, path(2))?;
            if !seen.insert((from, action)) {
                let [from, action, _] = &self.transitions[index];
                let found = format!("a second transition of {action:?} in {from:?}");
                let expected = "at most one successor for each state and action";
                return Err(DocumentError::invalid(
                    format!("transitions[{index}]"),
                    found,
                    expected,
                ));
            }
            transitions.push([from, action, to]);
        }
        let initial = states.find(&self.initial_state, || "initial_state".to_owned())?;
        Ok((Resolved { states, actions, transitions, initial, facts }, goal_facts))
    }

    fn observer(
        &self,
        task: &Task,
        resolved: &Resolved<'_>,
        role: Role,
        observer: &ExplicitObserver,
    ) -> Result<Observer, DocumentError> {
        let path = format!("observers.{}", role.name());
        let mut belief = vec![resolved.initial];
        if let Some(names) = &observer.initial_belief {
            belief.clear();
            for (index, name) in names.iter().enumerate() {
                let path = || format!("{path}.initial_belief[{index}]");
                belief.push(resolved.states.find(name, path)?);
            }
            if !belief.contains(&resolved.initial) {
                let found = format!("{} states without the initial state", belief.len());
                let expected = format!("{:?} among them", self.initial_state);
                let path = format!("{path}.initial_belief");
                return Err(DocumentError::invalid(path, found, expected));
            }
        }
        let mut symbols = FxHashMap::default();
        let mut shapes = Names::default();
        for (index, [action, state, symbol]) in observer.sensor.iter().enumerate() {
            let path = |part: usize| {
                let path = &path;
                move || format!("{path}.sensor[{index}][{part}]")
            };
            let pair =
                (resolved.actions.find(action, path(0))?, resolved.states.find(state, path(1))?);
            shapes.add_symbol(symbol, path(2))?;
            if symbols.insert(pair, symbol).is_some() {
                let found = format!("a second symbol for {action:?} resulting in {state:?}");
                let place = format!("observers.{}.sensor[{index}]", role.name());
                return Err(DocumentError::invalid(place, found, "one symbol for each pair"));
            }
        }
        let mut sensor = SensorBuilder::new(task);
        for ((id, _), &[_, action, to]) in task.operator_ids().zip(&resolved.transitions) {
            let Some(symbol) = symbols.get(&(action, to)) else {
                let (action, to) = (resolved.actions.names[action], resolved.states.names[to]);
                let found = format!("no symbol for {action:?} resulting in {to:?}");
                let expected = "a symbol for every action and resulting state that occurs";
                return Err(DocumentError::invalid(format!("{path}.sensor"), found, expected));
            };
            sensor.always(id, symbol);
        }
        let state = |state: &usize| task.state(&resolved.facts[*state]).ok();
        let initial_belief = belief.iter().filter_map(state).collect();
        let sensor = sensor.build(task).map_err(|error| {
            DocumentError::invalid(format!("{path}.sensor"), error.to_string(), "a symbol")
        })?;
        let name = role.name().to_owned();
        Ok(Observer { name, role, sensor: Arc::new(sensor), initial_belief })
    }
}
