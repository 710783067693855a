//! Random gridworlds, and what they mean as tables, worked out from their description.

use mo_copp::domain::grid::{Cell, GridGoal, GridObserver, Symbols};
use mo_copp::domain::{Gridworld, Observers};
use mo_copp::problem::Role;

use super::dice::Dice;
use super::table::{Table, Watcher, set, symbol};

/// Walls, stay, cameras, initial beliefs: each now and then.
pub fn random(dice: &mut Dice, longest_side: usize) -> Gridworld {
    let (width, height) = (dice.between(1, longest_side), dice.between(2, longest_side));
    let mut free: Vec<Cell> =
        (0..width * height).map(|index| [(index % width) as u32, (index / width) as u32]).collect();
    let mut walls = Vec::new();
    while free.len() > 2 && dice.percent(45) {
        walls.push(free.swap_remove(dice.below(free.len())));
    }
    let stay = dice.percent(40);
    let start = dice.pick(&free);
    let goals = dice.between(2, 4);
    let goals = (1..=goals)
        .map(|number| GridGoal { name: format!("G{number}"), cell: dice.pick(&free) })
        .collect();
    let mut observer = |mut sensor: Symbols| {
        let some = |dice: &mut Dice, chance| {
            let cells = free.iter().filter(|_| dice.percent(chance));
            cells.copied().collect::<Vec<Cell>>()
        };
        let initial_belief = dice.percent(50).then(|| {
            let mut cells = some(dice, 30);
            if !cells.contains(&start) {
                cells.push(start);
            }
            cells
        });
        let cameras = if dice.percent(40) { some(dice, 20) } else { Vec::new() };
        if dice.percent(30) {
            let names = ["p", "q", "r"];
            for action in ["north", "south", "east", "west"] {
                sensor.set(action, dice.pick(&names));
            }
        }
        if stay {
            sensor.set("stay", dice.pick(&["still", "vertical", "north-east"]));
        }
        GridObserver { initial_belief, cameras, sensor }
    };
    let sensors = Gridworld::paper_sensors();
    let adversarial = observer(sensors.adversarial);
    let cooperative = observer(sensors.cooperative);
    Gridworld {
        width: width as u32,
        height: height as u32,
        walls,
        start,
        goals,
        true_goal: "G1".to_owned(),
        stay,
        observers: Observers { adversarial, cooperative },
    }
}

/// States are the free cells, labelled as cells.
pub fn table(grid: &Gridworld) -> Table {
    let mut cells: Vec<Cell> = Vec::new();
    for row in 0..grid.height {
        for column in 0..grid.width {
            if !grid.walls.contains(&[column, row]) {
                cells.push([column, row]);
            }
        }
    }
    let place = |cell: &Cell| cells.iter().position(|known| known == cell);
    let moves = |[column, row]: Cell| {
        let mut targets = vec![
            row.checked_sub(1).map(|row| [column, row]),
            Some([column, row + 1]),
            Some([column + 1, row]),
            column.checked_sub(1).map(|column| [column, row]),
        ];
        if grid.stay {
            targets.push(Some([column, row]));
        }
        targets.iter().map(|target| place(target.as_ref()?)).collect()
    };
    let actions = &["north", "south", "east", "west", "stay"][..if grid.stay { 5 } else { 4 }];
    let watcher = |role, observer: &GridObserver<Cell>| {
        let mut symbols = Vec::new();
        let sensor = actions
            .iter()
            .map(|&action| {
                let name = observer.sensor.get(action).unwrap();
                let of_cell = |cell: &Cell| {
                    if observer.cameras.contains(cell) {
                        symbol(&mut symbols, &format!("seen at {},{}", cell[0], cell[1]))
                    } else {
                        symbol(&mut symbols, name)
                    }
                };
                cells.iter().map(of_cell).collect()
            })
            .collect();
        let belief = observer.initial_belief.clone().unwrap_or_else(|| vec![grid.start]);
        let belief = set(&belief.iter().map(|cell| place(cell).unwrap()).collect::<Vec<_>>());
        Watcher { role, belief, symbols, sensor }
    };
    Table {
        states: cells.iter().map(|[column, row]| format!("[{column}, {row}]")).collect(),
        actions: actions.iter().map(|&action| action.to_owned()).collect(),
        next: cells.iter().map(|&cell| moves(cell)).collect(),
        start: place(&grid.start).unwrap(),
        goals: grid.goals.iter().map(|goal| set(&[place(&goal.cell).unwrap()])).collect(),
        goal_names: grid.goals.iter().map(|goal| goal.name.clone()).collect(),
        true_goal: grid.goals.iter().position(|goal| goal.name == grid.true_goal).unwrap(),
        watchers: vec![
            watcher(Role::Adversarial, &grid.observers.adversarial),
            watcher(Role::Cooperative, &grid.observers.cooperative),
        ],
    }
}
