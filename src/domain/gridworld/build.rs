//! Makes a problem of a gridworld.

use std::sync::Arc;

use super::{Cell, GridObserver, Gridworld, MAX_SIDE};
use crate::document::DocumentError;
use crate::domain::observers::{true_goal, unexpected};
use crate::problem::{Goal, Observer, Problem, Role, StateNaming};
use crate::sensor::{Sensor, SensorBuilder};
use crate::task::{Fact, State, Task, TaskBuilder};

/// The moves in the order of their operators, with what they add to column and row.
const MOVES: [(&str, i64, i64); 5] =
    [("north", 0, -1), ("south", 0, 1), ("east", 1, 0), ("west", -1, 0), ("stay", 0, 0)];

impl Gridworld {
    /// Checks that everything fits together and makes the problem: one fact for each cell, one
    /// operator for each move from each free cell.
    ///
    /// # Errors
    ///
    /// [`DocumentError`] with the place of what does not fit.
    pub fn problem(&self) -> Result<Problem, DocumentError> {
        self.check()?;
        let task = self.task()?;
        let names: Vec<&str> = self.goals.iter().map(|goal| goal.name.as_str()).collect();
        let true_goal = true_goal(&names, &self.true_goal)?;
        let goal = |goal: &super::GridGoal| Goal {
            name: goal.name.clone(),
            condition: vec![self.fact(goal.cell)],
        };
        let goals = self.goals.iter().map(goal).collect();
        let observers = self
            .observers
            .iter()
            .map(|(role, observer)| self.observer(&task, role, observer))
            .collect::<Result<_, _>>()?;
        let naming = StateNaming::Cells { width: self.width };
        Problem::new(task, goals, true_goal, observers, naming).map_err(|e| unexpected(&e))
    }

    fn index(&self, [column, row]: Cell) -> usize {
        row as usize * self.width as usize + column as usize
    }

    fn fact(&self, cell: Cell) -> Fact {
        Fact::new(self.index(cell))
    }

    /// The fields may come from anywhere: sizes and cells first.
    fn check(&self) -> Result<(), DocumentError> {
        for (key, side) in [("width", self.width), ("height", self.height)] {
            if !(1..=MAX_SIDE).contains(&side) {
                let expected = format!("a whole number from 1 to {MAX_SIDE}");
                return Err(DocumentError::invalid(key, side.to_string(), expected));
            }
        }
        for (index, &cell) in self.walls.iter().enumerate() {
            self.check_inside(|| format!("walls[{index}]"), cell)?;
        }
        let free = self.free_cells();
        self.check_free(&free, || "start".to_owned(), self.start)?;
        for (index, goal) in self.goals.iter().enumerate() {
            self.check_free(&free, || format!("goals[{index}].cell"), goal.cell)?;
        }
        for (role, observer) in self.observers.iter() {
            let path = format!("observers.{}", role.name());
            for (index, &cell) in observer.cameras.iter().enumerate() {
                self.check_inside(|| format!("{path}.cameras[{index}]"), cell)?;
            }
            if let Some(belief) = &observer.initial_belief {
                let path = format!("{path}.initial_belief");
                for (index, &cell) in belief.iter().enumerate() {
                    self.check_free(&free, || format!("{path}[{index}]"), cell)?;
                }
                if !belief.contains(&self.start) {
                    let found = format!("{} cells without the start", belief.len());
                    let [column, row] = self.start;
                    let expected = format!("the start [{column}, {row}] among them");
                    return Err(DocumentError::invalid(path, found, expected));
                }
            }
            if self.stay && observer.sensor.stay.is_none() {
                let path = format!("{path}.sensor.stay");
                let expected = "the symbol the observer sees, since the agent may stay";
                return Err(DocumentError::invalid(path, "nothing", expected));
            }
        }
        Ok(())
    }

    fn check_inside(
        &self,
        path: impl Fn() -> String,
        [column, row]: Cell,
    ) -> Result<(), DocumentError> {
        if column < self.width && row < self.height {
            return Ok(());
        }
        let expected = format!("a cell inside the {} × {} grid", self.width, self.height);
        Err(DocumentError::invalid(path(), format!("[{column}, {row}]"), expected))
    }

    fn check_free(
        &self,
        free: &[bool],
        path: impl Fn() -> String,
        cell: Cell,
    ) -> Result<(), DocumentError> {
        self.check_inside(&path, cell)?;
        if free[self.index(cell)] {
            return Ok(());
        }
        let found = format!("[{}, {}], which is a wall", cell[0], cell[1]);
        Err(DocumentError::invalid(path(), found, "a free cell"))
    }

    /// Which cells are no walls, row by row.
    pub(super) fn free_cells(&self) -> Vec<bool> {
        let mut free = vec![true; self.width as usize * self.height as usize];
        for &wall in &self.walls {
            free[self.index(wall)] = false;
        }
        free
    }

    fn task(&self) -> Result<Task, DocumentError> {
        let (width, height) = (i64::from(self.width), i64::from(self.height));
        let mut builder = TaskBuilder::default();
        let mut facts = Vec::new();
        for row in 0..height {
            for column in 0..width {
                facts.push(builder.fact(format!("at {column},{row}")));
            }
        }
        builder.exclusive(facts.clone());
        let free = self.free_cells();
        let moves = &MOVES[..if self.stay { 5 } else { 4 }];
        for (name, _, _) in moves {
            builder.action(name);
        }
        for row in 0..height {
            for column in 0..width {
                let from = (row * width + column) as usize;
                for &(name, right, down) in moves {
                    let (column, row) = (column + right, row + down);
                    let inside = (0..width).contains(&column) && (0..height).contains(&row);
                    let to = (row * width + column) as usize;
                    if inside && free[from] && free[to] {
                        builder.operator(name, &[facts[from]], &[facts[to]], &[facts[from]]);
                    }
                }
            }
        }
        let true_cell = self.goals.iter().find(|goal| goal.name == self.true_goal);
        let goal: Vec<Fact> = true_cell.iter().map(|goal| self.fact(goal.cell)).collect();
        builder
            .build(&[self.fact(self.start)], &goal)
            .map_err(|error| DocumentError::invalid("document", error.to_string(), "a task"))
    }

    fn observer(
        &self,
        task: &Task,
        role: Role,
        observer: &GridObserver,
    ) -> Result<Observer, DocumentError> {
        let state = |cell: &Cell| task.state(&[self.fact(*cell)]).ok();
        let start = [self.start];
        let belief = observer.initial_belief.as_deref().unwrap_or(&start);
        let initial_belief: Vec<State> = belief.iter().filter_map(state).collect();
        Ok(Observer {
            name: role.name().to_owned(),
            role,
            sensor: Arc::new(self.sensor(task, observer)?),
            initial_belief,
        })
    }

    fn sensor(&self, task: &Task, observer: &GridObserver) -> Result<Sensor, DocumentError> {
        let symbols = &observer.sensor;
        let mut camera = vec![false; task.fact_count()];
        for &cell in &observer.cameras {
            camera[self.index(cell)] = true;
        }
        let mut builder = SensorBuilder::new(task);
        for (id, operator) in task.operator_ids() {
            let target = operator.add[0].index();
            if camera[target] {
                let (column, row) = (target as u32 % self.width, target as u32 / self.width);
                builder.always(id, &format!("seen at {column},{row}"));
            }
            let symbol = match task.action_name(operator.action) {
                "north" => &symbols.north,
                "south" => &symbols.south,
                "east" => &symbols.east,
                "west" => &symbols.west,
                _ => symbols.stay.as_ref().unwrap_or(&symbols.north),
            };
            builder.always(id, symbol);
        }
        builder
            .build(task)
            .map_err(|error| DocumentError::invalid("observers", error.to_string(), "a symbol"))
    }
}
