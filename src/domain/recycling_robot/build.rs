//! Makes a problem of the recycling robot.

use super::{
    ACTIONS, CHARGE, Can, DROP, HELD, MAX_LEVELS, MAX_SIDE, PICK_UP, RecyclingRobot, RobotState,
    STAY,
};
use crate::document::DocumentError;
use crate::domain::grid::{Cell, Direction, Floor, Pose, Stage};
use crate::problem::{Part, Problem, StateLabel, StateNaming, Value};
use crate::task::{Fact, Task, TaskBuilder};

/// The facts of the recycling robot.
struct Facts<'a> {
    floor: &'a Floor,
    robot: Vec<Fact>,
    /// By level.
    battery: Vec<Fact>,
    can: Vec<Fact>,
    held: Fact,
}

impl<'a> Facts<'a> {
    fn new(floor: &'a Floor, levels: u32, builder: &mut TaskBuilder) -> Self {
        let robot = floor.facts(builder, "robot at");
        let can = floor.facts(builder, "can at");
        let held = builder.fact("can held");
        let battery: Vec<Fact> =
            (0..levels).map(|level| builder.fact(format!("battery {level}"))).collect();
        builder.exclusive(robot.clone());
        builder.exclusive([can.as_slice(), &[held]].concat());
        builder.exclusive(battery.clone());
        Self { floor, robot, battery, can, held }
    }

    fn robot(&self, cell: Cell) -> Fact {
        self.robot[self.floor.index(cell)]
    }

    fn can(&self, can: Can) -> Fact {
        match can {
            Can::At(cell) => self.can[self.floor.index(cell)],
            Can::Held => self.held,
        }
    }

    /// What holds in a state.
    fn of(&self, state: &RobotState) -> Vec<Fact> {
        vec![self.robot(state.robot), self.battery[state.battery as usize], self.can(state.can)]
    }

    /// How states are shown: as documents write them.
    fn naming(&self) -> StateNaming {
        let levels = self.battery.iter().copied().zip((0..).map(Value::Number)).collect();
        let mut can = self.floor.values(&self.can);
        can.push((self.held, Value::Name(HELD)));
        StateNaming::Parts(vec![
            Part { key: "robot", values: self.floor.values(&self.robot) },
            Part { key: "battery", values: levels },
            Part { key: "can", values: can },
        ])
    }
}

impl Pose for RobotState {
    const PLURAL: &'static str = "states";

    fn check(&self, floor: &Floor, path: &dyn Fn() -> String) -> Result<(), DocumentError> {
        floor.check_free(|| format!("{}.robot", path()), self.robot)?;
        match self.can {
            Can::At(cell) => floor.check_free(|| format!("{}.can", path()), cell),
            Can::Held => Ok(()),
        }
    }

    fn label(&self) -> StateLabel {
        let can = match self.can {
            Can::At([column, row]) => Value::Cell(column, row),
            Can::Held => Value::Name(HELD),
        };
        StateLabel::Parts(vec![
            ("robot", Value::Cell(self.robot[0], self.robot[1])),
            ("battery", Value::Number(self.battery)),
            ("can", can),
        ])
    }
}

impl RecyclingRobot {
    /// Checks that everything fits together and makes the problem.
    ///
    /// # Errors
    ///
    /// [`DocumentError`] with the place of what does not fit.
    pub fn problem(&self) -> Result<Problem, DocumentError> {
        let floor = Floor::new(self.width, self.height, &self.walls, MAX_SIDE)?;
        floor.check_free(|| "charger".to_owned(), self.charger)?;
        self.check_battery()?;
        let stage = Stage {
            floor: &floor,
            start: &self.start,
            goals: &self.goals,
            true_goal: &self.true_goal,
            observers: &self.observers,
        };
        let true_goal = stage.check(&ACTIONS)?;
        let mut builder = TaskBuilder::default();
        let facts = Facts::new(&floor, self.battery_levels, &mut builder);
        let task = self.task(builder, &facts, true_goal.cell)?;
        let condition = |cell| facts.can(Can::At(cell));
        stage.problem(task, condition, |state| facts.of(state), facts.naming())
    }

    /// The fields may come from anywhere: the number of levels, and every level.
    fn check_battery(&self) -> Result<(), DocumentError> {
        if !(1..=MAX_LEVELS).contains(&self.battery_levels) {
            let expected = format!("a whole number from 1 to {MAX_LEVELS}");
            let found = self.battery_levels.to_string();
            return Err(DocumentError::invalid("battery_levels", found, expected));
        }
        let full = self.battery_levels - 1;
        let check = |path: &dyn Fn() -> String, state: &RobotState| {
            if state.battery <= full {
                return Ok(());
            }
            let expected = format!("at most {full}, with {} levels from 0", self.battery_levels);
            let path = format!("{}.battery", path());
            Err(DocumentError::invalid(path, state.battery.to_string(), expected))
        };
        check(&|| "start".to_owned(), &self.start)?;
        for (role, observer) in self.observers.iter() {
            for (index, state) in observer.initial_belief.iter().flatten().enumerate() {
                let path = || format!("observers.{}.initial_belief[{index}]", role.name());
                check(&path, state)?;
            }
        }
        Ok(())
    }

    fn task(
        &self,
        mut builder: TaskBuilder,
        facts: &Facts<'_>,
        goal: Cell,
    ) -> Result<Task, DocumentError> {
        for action in ACTIONS {
            builder.action(action);
        }
        for from in facts.floor.free() {
            for direction in Direction::ALL {
                let to = facts.floor.step(from, direction);
                for level in facts.battery.windows(2) {
                    let before = [facts.robot(from), level[1]];
                    match to.map(|to| [facts.robot(to), level[0]]) {
                        Some(after) => builder.operator(direction.name(), &before, &after, &before),
                        None => builder.operator(direction.name(), &before, &[], &[]),
                    }
                }
            }
            let (robot, can) = (facts.robot(from), facts.can(Can::At(from)));
            builder.operator(PICK_UP, &[robot, can], &[facts.held], &[can]);
            builder.operator(DROP, &[robot, facts.held], &[can], &[facts.held]);
        }
        if let Some(&full) = facts.battery.last() {
            for &level in &facts.battery {
                let before = [facts.robot(self.charger), level];
                builder.operator(CHARGE, &before, &[full], &[level]);
            }
        }
        builder.operator(STAY, &[], &[], &[]);
        builder
            .build(&facts.of(&self.start), &[facts.can(Can::At(goal))])
            .map_err(|error| DocumentError::invalid("document", error.to_string(), "a task"))
    }
}
