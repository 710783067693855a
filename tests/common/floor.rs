//! What random box pushing and random recycling robots share: a few cells, and who watches.

use mo_copp::domain::Observers;
use mo_copp::domain::grid::{Cell, GridGoal, GridObserver, Symbols};

use super::dice::Dice;
use super::table::symbol;

/// The cells of a small grid.
#[derive(Debug, Clone)]
pub struct Floor {
    pub width: u32,
    pub height: u32,
    pub walls: Vec<Cell>,
    /// By row.
    pub free: Vec<Cell>,
}

impl Floor {
    pub fn of(width: u32, height: u32, walls: &[Cell]) -> Self {
        let all = (0..width * height).map(|index| [index % width, index / width]);
        let free = all.filter(|cell| !walls.contains(cell)).collect();
        Self { width, height, walls: walls.to_vec(), free }
    }

    /// From 3 free cells to so many.
    pub fn random(dice: &mut Dice, most: usize) -> Self {
        let (width, height) = (dice.between(1, 4) as u32, dice.between(2, 4) as u32);
        let mut floor = Self::of(width.max(if height < 3 { 2 } else { 1 }), height, &[]);
        let target = dice.between(3, most.min(floor.free.len()));
        while floor.free.len() > target {
            let wall = floor.free.remove(dice.below(floor.free.len()));
            floor.walls.push(wall);
        }
        floor
    }

    pub fn goals(&self, dice: &mut Dice, most: usize) -> Vec<GridGoal> {
        let count = dice.between(2, most);
        (1..=count)
            .map(|number| GridGoal { name: format!("G{number}"), cell: dice.pick(&self.free) })
            .collect()
    }

    /// The free cell on that side.
    pub fn next(&self, [column, row]: Cell, side: &str) -> Option<Cell> {
        let next = match side {
            "north" => [column, row.checked_sub(1)?],
            "south" => [column, row + 1],
            "east" => [column + 1, row],
            _ => [column.checked_sub(1)?, row],
        };
        self.free.contains(&next).then_some(next)
    }
}

/// Initial beliefs, cameras and odd sensors, each now and then.
pub fn observers<S: Copy + PartialEq>(
    dice: &mut Dice,
    floor: &Floor,
    states: &[S],
    start: S,
    sensors: Observers<Symbols>,
    actions: &[&'static str],
) -> Observers<GridObserver<S>> {
    let mut observer = |mut sensor: Symbols| {
        let initial_belief = dice.percent(50).then(|| {
            let mut believed: Vec<S> = states.iter().filter(|_| dice.percent(8)).copied().collect();
            if !believed.contains(&start) {
                believed.push(start);
            }
            believed
        });
        let camera =
            |dice: &mut Dice| floor.free.iter().filter(|_| dice.percent(25)).copied().collect();
        let cameras: Vec<Cell> = if dice.percent(30) { camera(dice) } else { Vec::new() };
        if dice.percent(30) {
            for action in actions {
                sensor.set(action, dice.pick(&["p", "q", "r"]));
            }
        }
        GridObserver { initial_belief, cameras, sensor }
    };
    let adversarial = observer(sensors.adversarial);
    let cooperative = observer(sensors.cooperative);
    Observers { adversarial, cooperative }
}

/// The symbols, and the one of each action and resulting state, of which `robots` are the cells.
pub fn sensor<S>(
    observer: &GridObserver<S>,
    actions: &[&str],
    robots: &[Cell],
) -> (Vec<String>, Vec<Vec<usize>>) {
    let mut symbols = Vec::new();
    let mut read = |action: &str, robot: &Cell| {
        if observer.cameras.contains(robot) {
            symbol(&mut symbols, &format!("seen at {},{}", robot[0], robot[1]))
        } else {
            symbol(&mut symbols, observer.sensor.get(action).unwrap())
        }
    };
    let rows =
        actions.iter().map(|action| robots.iter().map(|robot| read(action, robot)).collect());
    let rows = rows.collect();
    (symbols, rows)
}

pub fn belief<S: Copy>(observer: &GridObserver<S>, start: S) -> Vec<S> {
    observer.initial_belief.clone().unwrap_or_else(|| vec![start])
}
