//! Checks goals and observers of a format with cells, and makes the problem once its task is there.

use std::sync::Arc;

use super::{Cell, Floor, GridGoal, GridObserver};
use crate::document::DocumentError;
use crate::document::json::quoted;
use crate::domain::Observers;
use crate::domain::observers::{true_goal, unexpected};
use crate::problem::{Goal, Observer, Problem, Role, StateLabel, StateNaming};
use crate::sensor::{Sensor, SensorBuilder};
use crate::task::{Fact, Task};

/// How a format writes a state.
pub(in crate::domain) trait Pose: PartialEq {
    /// Several of them, in a message.
    const PLURAL: &'static str;

    /// Each part must be possible. The path is where the state stands.
    fn check(&self, floor: &Floor, path: &dyn Fn() -> String) -> Result<(), DocumentError>;

    /// How it is shown.
    fn label(&self) -> StateLabel;
}

impl Pose for Cell {
    const PLURAL: &'static str = "cells";

    fn check(&self, floor: &Floor, path: &dyn Fn() -> String) -> Result<(), DocumentError> {
        floor.check_free(path, *self)
    }

    fn label(&self) -> StateLabel {
        StateLabel::Cell(self[0], self[1])
    }
}

/// What a document says of goals and observers.
///
/// The first facts of the task say where the robot is: one for each cell, in the order of the
/// floor.
pub(in crate::domain) struct Stage<'a, S> {
    pub(in crate::domain) floor: &'a Floor,
    pub(in crate::domain) start: &'a S,
    pub(in crate::domain) goals: &'a [GridGoal],
    pub(in crate::domain) true_goal: &'a str,
    pub(in crate::domain) observers: &'a Observers<GridObserver<S>>,
}

impl<S: Pose> Stage<'_, S> {
    /// Checks start, goals and observers; the fields may come from anywhere. Each observer must
    /// have a symbol for each of the actions. Returns the true goal.
    pub(in crate::domain) fn check(
        &self,
        actions: &[&'static str],
    ) -> Result<&GridGoal, DocumentError> {
        self.start.check(self.floor, &|| "start".to_owned())?;
        for (index, goal) in self.goals.iter().enumerate() {
            self.floor.check_free(|| format!("goals[{index}].cell"), goal.cell)?;
        }
        for (role, observer) in self.observers.iter() {
            let path = format!("observers.{}", role.name());
            for (index, &cell) in observer.cameras.iter().enumerate() {
                self.floor.check_inside(|| format!("{path}.cameras[{index}]"), cell)?;
            }
            if let Some(belief) = &observer.initial_belief {
                self.check_belief(&format!("{path}.initial_belief"), belief)?;
            }
        }
        self.check_symbols(actions, "")?;
        self.true_goal().map(|index| &self.goals[index])
    }

    /// Each observer must have a symbol for each of the actions, which `why` makes possible.
    pub(in crate::domain) fn check_symbols(
        &self,
        actions: &[&'static str],
        why: &str,
    ) -> Result<(), DocumentError> {
        for (role, observer) in self.observers.iter() {
            observer.sensor.check(&format!("observers.{}", role.name()), actions, why)?;
        }
        Ok(())
    }

    /// No observer may have a symbol for an action that is never possible.
    pub(in crate::domain) fn check_no_symbol(
        &self,
        action: &str,
        expected: &str,
    ) -> Result<(), DocumentError> {
        for (role, observer) in self.observers.iter() {
            if let Some(symbol) = observer.sensor.get(action) {
                let path = format!("observers.{}.sensor.{action}", role.name());
                return Err(DocumentError::invalid(path, quoted(symbol), expected));
            }
        }
        Ok(())
    }

    fn check_belief(&self, path: &str, belief: &[S]) -> Result<(), DocumentError> {
        for (index, state) in belief.iter().enumerate() {
            state.check(self.floor, &|| format!("{path}[{index}]"))?;
        }
        if belief.contains(self.start) {
            return Ok(());
        }
        let found = format!("{} {} without the start", belief.len(), S::PLURAL);
        let expected = format!("the start {:#} among them", self.start.label());
        Err(DocumentError::invalid(path, found, expected))
    }

    fn true_goal(&self) -> Result<usize, DocumentError> {
        let names: Vec<&str> = self.goals.iter().map(|goal| goal.name.as_str()).collect();
        true_goal(&names, self.true_goal)
    }

    /// Makes the problem, once everything is checked. `condition` is what a goal asks of its cell,
    /// `facts` what holds in a state.
    pub(in crate::domain) fn problem(
        &self,
        task: Task,
        condition: impl Fn(Cell) -> Fact,
        facts: impl Fn(&S) -> Vec<Fact>,
        naming: StateNaming,
    ) -> Result<Problem, DocumentError> {
        let goal = |goal: &GridGoal| Goal {
            name: goal.name.clone(),
            condition: vec![condition(goal.cell)],
        };
        let goals = self.goals.iter().map(goal).collect();
        let observers = self
            .observers
            .iter()
            .map(|(role, observer)| self.observer(&task, role, observer, &facts))
            .collect::<Result<_, _>>()?;
        Problem::new(task, goals, self.true_goal()?, observers, naming).map_err(|e| unexpected(&e))
    }

    fn observer(
        &self,
        task: &Task,
        role: Role,
        observer: &GridObserver<S>,
        facts: impl Fn(&S) -> Vec<Fact>,
    ) -> Result<Observer, DocumentError> {
        let belief = match &observer.initial_belief {
            Some(belief) => belief.as_slice(),
            None => std::slice::from_ref(self.start),
        };
        let initial_belief =
            belief.iter().filter_map(|state| task.state(&facts(state)).ok()).collect();
        Ok(Observer {
            name: role.name().to_owned(),
            role,
            sensor: Arc::new(self.sensor(task, observer)?),
            initial_belief,
        })
    }

    fn sensor(&self, task: &Task, observer: &GridObserver<S>) -> Result<Sensor, DocumentError> {
        let cells = self.floor.len();
        let mut camera = vec![None; cells];
        for &cell in &observer.cameras {
            camera[self.floor.index(cell)] = Some(format!("seen at {},{}", cell[0], cell[1]));
        }
        let mut builder = SensorBuilder::new(task);
        for (id, operator) in task.operator_ids() {
            let is_place = |fact: &&Fact| fact.index() < cells;
            let stays =
                operator.preconditions.iter().filter(|fact| !operator.delete.contains(fact));
            // Where the robot is afterwards, as far as the operator says it.
            match operator.add.iter().chain(stays).find(is_place) {
                Some(place) => {
                    if let Some(seen) = &camera[place.index()] {
                        builder.always(id, seen);
                    }
                }
                None => {
                    for (index, seen) in camera.iter().enumerate() {
                        if let Some(seen) = seen {
                            builder.when(id, &[Fact::new(index)], seen);
                        }
                    }
                }
            }
            if let Some(symbol) = observer.sensor.get(task.action_name(operator.action)) {
                builder.always(id, symbol);
            }
        }
        builder
            .build(task)
            .map_err(|error| DocumentError::invalid("observers", error.to_string(), "a symbol"))
    }
}
