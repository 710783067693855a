//! Random box pushing, and what it means as tables, worked out from its description.

use mo_copp::domain::box_pushing::{BoxPushing, BoxState};
use mo_copp::domain::grid::{Cell, Direction};
use mo_copp::problem::Role;

use super::dice::Dice;
use super::floor::{self, Floor};
use super::table::{Table, Watcher, set};

const ACTIONS: [&str; 4] = ["move-forward", "stay", "turn-left", "turn-right"];

/// No more free cells, so that the states fit the tables.
const MOST_CELLS: usize = 6;

pub fn random(dice: &mut Dice) -> BoxPushing {
    let floor = Floor::random(dice, MOST_CELLS);
    let start = dice.pick(&states(&floor));
    let goals = floor.goals(dice, 3);
    let observers = floor::observers(
        dice,
        &floor,
        &states(&floor),
        start,
        BoxPushing::paper_sensors(),
        &ACTIONS,
    );
    BoxPushing {
        width: floor.width,
        height: floor.height,
        walls: floor.walls,
        start,
        goals,
        true_goal: "G1".to_owned(),
        observers,
    }
}

fn states(floor: &Floor) -> Vec<BoxState> {
    let mut states = Vec::new();
    for &robot in &floor.free {
        for facing in Direction::ALL {
            let boxes = floor.free.iter().filter(|&&cell| cell != robot);
            states.extend(boxes.map(|&r#box| BoxState { robot, facing, r#box }));
        }
    }
    states
}

/// Clockwise.
const ROUND: [Direction; 4] =
    [Direction::North, Direction::East, Direction::South, Direction::West];

fn turned(facing: Direction, quarters: usize) -> Direction {
    let place = ROUND.iter().position(|&known| known == facing).unwrap();
    ROUND[(place + quarters) % 4]
}

fn after(floor: &Floor, state: BoxState, action: &str) -> BoxState {
    match action {
        "stay" => state,
        "turn-right" => BoxState { facing: turned(state.facing, 1), ..state },
        "turn-left" => BoxState { facing: turned(state.facing, 3), ..state },
        _ => {
            let next = |cell: Cell| floor.next(cell, state.facing.name());
            let Some(ahead) = next(state.robot) else { return state };
            if ahead != state.r#box {
                return BoxState { robot: ahead, ..state };
            }
            match next(ahead) {
                Some(beyond) => BoxState { robot: ahead, r#box: beyond, ..state },
                None => state,
            }
        }
    }
}

/// Every robot, facing and box there could be is a state.
pub fn table(document: &BoxPushing) -> Table {
    let floor = Floor::of(document.width, document.height, &document.walls);
    let states = states(&floor);
    let place = |state: &BoxState| states.iter().position(|known| known == state).unwrap();
    let robots: Vec<Cell> = states.iter().map(|state| state.robot).collect();
    let watcher = |role, observer| {
        let (symbols, sensor) = floor::sensor(observer, &ACTIONS, &robots);
        let belief = floor::belief(observer, document.start);
        let belief = set(&belief.iter().map(place).collect::<Vec<_>>());
        Watcher { role, belief, symbols, sensor }
    };
    let with_box_in = |cell: Cell| {
        let all = 0..states.len();
        set(&all.filter(|&state| states[state].r#box == cell).collect::<Vec<_>>())
    };
    let label = |state: &BoxState| {
        let ([a, b], [c, d]) = (state.robot, state.r#box);
        format!("{{robot [{a}, {b}], facing {}, box [{c}, {d}]}}", state.facing.name())
    };
    let next = |state: &BoxState| {
        ACTIONS.iter().map(|action| Some(place(&after(&floor, *state, action)))).collect()
    };
    Table {
        states: states.iter().map(label).collect(),
        actions: ACTIONS.map(str::to_owned).to_vec(),
        next: states.iter().map(next).collect(),
        start: place(&document.start),
        goals: document.goals.iter().map(|goal| with_box_in(goal.cell)).collect(),
        goal_names: document.goals.iter().map(|goal| goal.name.clone()).collect(),
        true_goal: document.goals.iter().position(|g| g.name == document.true_goal).unwrap(),
        watchers: vec![
            watcher(Role::Adversarial, &document.observers.adversarial),
            watcher(Role::Cooperative, &document.observers.cooperative),
        ],
    }
}
