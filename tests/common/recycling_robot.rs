//! Random recycling robots, and what they mean as tables, worked out from their description.

use mo_copp::domain::grid::Cell;
use mo_copp::domain::recycling_robot::{Can, RecyclingRobot, RobotState};
use mo_copp::problem::Role;

use super::dice::Dice;
use super::floor::{self, Floor};
use super::table::{Table, Watcher, set};

const ACTIONS: [&str; 8] = ["north", "south", "east", "west", "pick-up", "drop", "charge", "stay"];

/// No more free cells, so that the states fit the tables.
const MOST_CELLS: usize = 6;

pub fn random(dice: &mut Dice) -> RecyclingRobot {
    let floor = Floor::random(dice, MOST_CELLS);
    let battery_levels = dice.between(1, 3) as u32;
    let all = states(&floor, battery_levels);
    let start = dice.pick(&all);
    let goals = floor.goals(dice, 3);
    let charger = dice.pick(&floor.free);
    let sensors = RecyclingRobot::paper_sensors();
    let observers = floor::observers(dice, &floor, &all, start, sensors, &ACTIONS);
    RecyclingRobot {
        width: floor.width,
        height: floor.height,
        walls: floor.walls,
        charger,
        battery_levels,
        start,
        goals,
        true_goal: "G1".to_owned(),
        observers,
    }
}

fn states(floor: &Floor, levels: u32) -> Vec<RobotState> {
    let mut states = Vec::new();
    for &robot in &floor.free {
        for battery in 0..levels {
            let cans = floor.free.iter().map(|&cell| Can::At(cell)).chain([Can::Held]);
            states.extend(cans.map(|can| RobotState { robot, battery, can }));
        }
    }
    states
}

fn after(
    document: &RecyclingRobot,
    floor: &Floor,
    state: RobotState,
    action: &str,
) -> Option<RobotState> {
    let RobotState { robot, battery, can } = state;
    match action {
        "stay" => Some(state),
        "charge" => (robot == document.charger)
            .then_some(RobotState { battery: document.battery_levels - 1, ..state }),
        "pick-up" => (can == Can::At(robot)).then_some(RobotState { can: Can::Held, ..state }),
        "drop" => (can == Can::Held).then_some(RobotState { can: Can::At(robot), ..state }),
        way => {
            let left = battery.checked_sub(1)?;
            // Bumping into a wall is no move.
            Some(match floor.next(robot, way) {
                Some(robot) => RobotState { robot, battery: left, can },
                None => state,
            })
        }
    }
}

/// Every robot, level and can there could be is a state.
pub fn table(document: &RecyclingRobot) -> Table {
    let floor = Floor::of(document.width, document.height, &document.walls);
    let states = states(&floor, document.battery_levels);
    let place = |state: &RobotState| states.iter().position(|known| known == state).unwrap();
    let robots: Vec<Cell> = states.iter().map(|state| state.robot).collect();
    let watcher = |role, observer| {
        let (symbols, sensor) = floor::sensor(observer, &ACTIONS, &robots);
        let belief = floor::belief(observer, document.start);
        let belief = set(&belief.iter().map(place).collect::<Vec<_>>());
        Watcher { role, belief, symbols, sensor }
    };
    let with_can_in = |cell: Cell| {
        let all = 0..states.len();
        set(&all.filter(|&state| states[state].can == Can::At(cell)).collect::<Vec<_>>())
    };
    let label = |state: &RobotState| {
        let can = match state.can {
            Can::At([column, row]) => format!("[{column}, {row}]"),
            Can::Held => "held".to_owned(),
        };
        let [column, row] = state.robot;
        format!("{{robot [{column}, {row}], battery {}, can {can}}}", state.battery)
    };
    let next = |state: &RobotState| {
        let after = |action: &&str| after(document, &floor, *state, action).as_ref().map(place);
        ACTIONS.iter().map(after).collect()
    };
    Table {
        states: states.iter().map(label).collect(),
        actions: ACTIONS.map(str::to_owned).to_vec(),
        next: states.iter().map(next).collect(),
        start: place(&document.start),
        goals: document.goals.iter().map(|goal| with_can_in(goal.cell)).collect(),
        goal_names: document.goals.iter().map(|goal| goal.name.clone()).collect(),
        true_goal: document.goals.iter().position(|g| g.name == document.true_goal).unwrap(),
        watchers: vec![
            watcher(Role::Adversarial, &document.observers.adversarial),
            watcher(Role::Cooperative, &document.observers.cooperative),
        ],
    }
}
