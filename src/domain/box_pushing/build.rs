//! Makes a problem of box pushing.
//!
//! Whether a cell is clear of the box is a fact of its own, since a move into it asks for that and
//! STRIPS has no other way to say that the box is elsewhere.

use super::{ACTIONS, BoxPushing, BoxState, FORWARD, LEFT, MAX_SIDE, RIGHT, STAY};
use crate::document::DocumentError;
use crate::domain::grid::{Cell, Direction, Floor, Pose, Stage};
use crate::problem::{Part, Problem, StateLabel, StateNaming, Value};
use crate::task::{Fact, Task, TaskBuilder};

/// The facts of box pushing.
struct Facts<'a> {
    floor: &'a Floor,
    robot: Vec<Fact>,
    /// In the order of [`Direction::ALL`].
    facing: Vec<Fact>,
    clear: Vec<Fact>,
    boxed: Vec<Fact>,
}

impl<'a> Facts<'a> {
    fn new(floor: &'a Floor, builder: &mut TaskBuilder) -> Self {
        let robot = floor.facts(builder, "robot at");
        let clear = floor.facts(builder, "clear");
        let boxed = floor.facts(builder, "box at");
        let facing: Vec<Fact> = Direction::ALL
            .iter()
            .map(|direction| builder.fact(format!("facing {}", direction.name())))
            .collect();
        builder.exclusive(robot.clone());
        builder.exclusive(facing.clone());
        for (&clear, &boxed) in clear.iter().zip(&boxed) {
            builder.exclusive(vec![clear, boxed]);
        }
        Self { floor, robot, facing, clear, boxed }
    }

    fn robot(&self, cell: Cell) -> Fact {
        self.robot[self.floor.index(cell)]
    }

    fn facing(&self, direction: Direction) -> Fact {
        self.facing[direction as usize]
    }

    fn clear(&self, cell: Cell) -> Fact {
        self.clear[self.floor.index(cell)]
    }

    fn boxed(&self, cell: Cell) -> Fact {
        self.boxed[self.floor.index(cell)]
    }

    /// What holds in a state.
    fn of(&self, state: &BoxState) -> Vec<Fact> {
        let elsewhere = self.floor.free().filter(|&cell| cell != state.r#box);
        [self.robot(state.robot), self.facing(state.facing), self.boxed(state.r#box)]
            .into_iter()
            .chain(elsewhere.map(|cell| self.clear(cell)))
            .collect()
    }

    /// How states are shown: as documents write them.
    fn naming(&self) -> StateNaming {
        let names = Direction::ALL.iter().map(|direction| Value::Name(direction.name()));
        let facing = self.facing.iter().copied().zip(names).collect();
        StateNaming::Parts(vec![
            Part { key: "robot", values: self.floor.values(&self.robot) },
            Part { key: "facing", values: facing },
            Part { key: "box", values: self.floor.values(&self.boxed) },
        ])
    }
}

impl Pose for BoxState {
    const PLURAL: &'static str = "states";

    fn check(&self, floor: &Floor, path: &dyn Fn() -> String) -> Result<(), DocumentError> {
        let of_box = || format!("{}.box", path());
        floor.check_free(|| format!("{}.robot", path()), self.robot)?;
        floor.check_free(of_box, self.r#box)?;
        if self.robot == self.r#box {
            let found = format!("[{}, {}], where the robot is", self.robot[0], self.robot[1]);
            return Err(DocumentError::invalid(of_box(), found, "a cell of its own"));
        }
        Ok(())
    }

    fn label(&self) -> StateLabel {
        StateLabel::Parts(vec![
            ("robot", Value::Cell(self.robot[0], self.robot[1])),
            ("facing", Value::Name(self.facing.name())),
            ("box", Value::Cell(self.r#box[0], self.r#box[1])),
        ])
    }
}

impl BoxPushing {
    /// Checks that everything fits together and makes the problem.
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
        let true_goal = stage.check(&ACTIONS)?;
        let mut builder = TaskBuilder::default();
        let facts = Facts::new(&floor, &mut builder);
        let task = self.task(builder, &facts, true_goal.cell)?;
        stage.problem(task, |cell| facts.boxed(cell), |state| facts.of(state), facts.naming())
    }

    fn task(
        &self,
        mut builder: TaskBuilder,
        facts: &Facts<'_>,
        goal: Cell,
    ) -> Result<Task, DocumentError> {
        for from in facts.floor.free() {
            for direction in Direction::ALL {
                forward(&mut builder, facts, from, direction);
            }
        }
        builder.operator(STAY, &[], &[], &[]);
        for (action, turn) in
            [(LEFT, Direction::left as fn(Direction) -> Direction), (RIGHT, Direction::right)]
        {
            for direction in Direction::ALL {
                let before = [facts.facing(direction)];
                builder.operator(action, &before, &[facts.facing(turn(direction))], &before);
            }
        }
        builder
            .build(&facts.of(&self.start), &[facts.boxed(goal)])
            .map_err(|error| DocumentError::invalid("document", error.to_string(), "a task"))
    }
}

/// Moving on from a cell: into a clear cell, with the box before it, or not at all.
fn forward(builder: &mut TaskBuilder, facts: &Facts<'_>, from: Cell, direction: Direction) {
    let (robot, facing) = (facts.robot(from), facts.facing(direction));
    let Some(to) = facts.floor.step(from, direction) else {
        builder.operator(FORWARD, &[robot, facing], &[], &[]);
        return;
    };
    builder.operator(FORWARD, &[robot, facing, facts.clear(to)], &[facts.robot(to)], &[robot]);
    let Some(beyond) = facts.floor.step(to, direction) else {
        builder.operator(FORWARD, &[robot, facing, facts.boxed(to)], &[], &[]);
        return;
    };
    let before = [robot, facts.boxed(to), facts.clear(beyond)];
    let after = [facts.robot(to), facts.clear(to), facts.boxed(beyond)];
    builder.operator(FORWARD, &[&before[..], &[facing]].concat(), &after, &before);
}
