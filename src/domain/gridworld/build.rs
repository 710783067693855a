//! Makes a problem of a gridworld.

use super::{Gridworld, MAX_SIDE, MOVES, STAY};
use crate::document::DocumentError;
use crate::domain::grid::{Cell, Direction, Floor, Stage};
use crate::problem::{Problem, StateNaming};
use crate::task::{Fact, Task, TaskBuilder};

impl Gridworld {
    /// Checks that everything fits together and makes the problem: one fact for each cell, one
    /// operator for each move from each free cell.
    ///
    /// # Errors
    ///
    /// [`DocumentError`] with the place of what does not fit.
    pub fn problem(&self) -> Result<Problem, DocumentError> {
        let floor = Floor::new(self.width, self.height, &self.walls, MAX_SIDE)?;
        let stage = Stage {
            floor: &floor,
            start: &self.start,
            goals: &self.goals,
            true_goal: &self.true_goal,
            observers: &self.observers,
        };
        let true_goal = stage.check(&MOVES)?;
        if self.stay {
            stage.check_symbols(&[STAY], ", since the agent may stay")?;
        } else {
            stage.check_no_symbol(STAY, "nothing, since the agent may not stay")?;
        }
        let fact = |cell: Cell| Fact::new(floor.index(cell));
        let task = self.task(&floor, true_goal.cell)?;
        let naming = StateNaming::Cells { width: self.width };
        stage.problem(task, fact, |cell| vec![fact(*cell)], naming)
    }

    fn task(&self, floor: &Floor, goal: Cell) -> Result<Task, DocumentError> {
        let mut builder = TaskBuilder::default();
        let facts = floor.facts(&mut builder, "at");
        let fact = |cell| facts[floor.index(cell)];
        builder.exclusive(facts.clone());
        for direction in Direction::ALL {
            builder.action(direction.name());
        }
        for from in floor.free() {
            for direction in Direction::ALL {
                if let Some(to) = floor.step(from, direction) {
                    let (from, to) = ([fact(from)], [fact(to)]);
                    builder.operator(direction.name(), &from, &to, &from);
                }
            }
            if self.stay {
                let here = [fact(from)];
                builder.operator(STAY, &here, &here, &here);
            }
        }
        builder
            .build(&[fact(self.start)], &[fact(goal)])
            .map_err(|error| DocumentError::invalid("document", error.to_string(), "a task"))
    }
}
