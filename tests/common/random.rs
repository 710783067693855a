//! Random problems and wishes.

use mo_copp::problem::Role;

use super::dice::Dice;
use super::oracle::Wish;
use super::strips::{Eye, Facts, Op, Strips};
use super::table::{Set, Table, Watcher};

/// A tiny STRIPS problem with two observers, whose believed states are reachable.
pub fn strips(dice: &mut Dice) -> Strips {
    let facts = dice.between(3, 5);
    let some = |dice: &mut Dice, chance: usize| -> Facts {
        (0..facts).filter(|_| dice.percent(chance)).map(|fact| 1 << fact).sum()
    };
    let op = |name: usize, dice: &mut Dice| {
        let (pre, add) = (some(dice, 30), some(dice, 30));
        Op { name: format!("a{name}"), pre, add, del: some(dice, 40) & !add }
    };
    let ops: Vec<Op> = (0..dice.between(2, 5)).map(|name| op(name, dice)).collect();
    let start = some(dice, 50);
    let walk = |dice: &mut Dice| {
        (0..dice.below(5)).fold(start, |state, _| {
            let op = &ops[dice.below(ops.len())];
            if state & op.pre == op.pre { state & !op.del | op.add } else { state }
        })
    };
    let mut goals = vec![walk(dice)];
    goals.extend((0..dice.between(1, 3)).map(|_| some(dice, 40)));
    let eyes = PAIR.map(|role| {
        let mut belief = vec![start];
        belief.extend((0..dice.below(3)).map(|_| walk(dice)));
        belief.sort_unstable();
        belief.dedup();
        let seen = ["x", "y", "z"];
        let symbols = ops.iter().map(|_| (some(dice, 20), dice.pick(&seen), dice.pick(&seen)));
        Eye { role, belief, symbols: symbols.collect() }
    });
    Strips { facts, ops, start, goals, eyes: eyes.into() }
}

/// How large a random problem is, at most.
#[derive(Debug, Clone, Copy)]
pub struct Size {
    pub states: usize,
    pub actions: usize,
    pub goals: usize,
}

pub const SMALL: Size = Size { states: 4, actions: 3, goals: 3 };
pub const MEDIUM: Size = Size { states: 7, actions: 4, goals: 4 };

/// A problem with everything that may go wrong: actions with the same effect, dead ends, sensors
/// that look at the state, goals that overlap or that no state satisfies, states that nobody
/// reaches.
pub fn table(dice: &mut Dice, size: Size, roles: &[Role]) -> Table {
    let states = dice.between(2, size.states);
    let actions = dice.between(1, size.actions);
    let density = dice.pick(&[35, 60, 85]);
    let mut next = vec![vec![None; actions]; states];
    for (state, row) in next.iter_mut().enumerate() {
        if dice.percent(10) {
            continue;
        }
        for action in 0..actions {
            if action > 0 && dice.percent(20) {
                row[action] = row[dice.below(action)];
            } else if dice.percent(10) {
                row[action] = Some(state);
            } else if dice.percent(density) {
                row[action] = Some(dice.below(states));
            }
        }
    }
    let goal_count = dice.between(2, size.goals);
    let mut goals: Vec<Set> = (0..goal_count)
        .map(|_| match dice.below(10) {
            0 => 0,
            1..=5 => 1 << dice.below(states),
            _ => some(dice, states, 40),
        })
        .collect();
    let start = dice.below(states);
    let true_goal = dice.below(goal_count);
    // Often somewhere that can be reached.
    if dice.percent(60) {
        let mut state = start;
        for _ in 0..dice.between(1, 4) {
            state = next[state][dice.below(actions)].unwrap_or(state);
        }
        goals[true_goal] |= 1 << state;
    }
    let watchers = roles.iter().map(|&role| watcher(dice, role, states, actions, start)).collect();
    Table {
        states: (0..states).map(|state| format!("s{state}")).collect(),
        actions: (0..actions).map(|action| format!("a{action}")).collect(),
        next,
        start,
        goals,
        goal_names: (1..=goal_count).map(|goal| format!("G{goal}")).collect(),
        true_goal,
        watchers,
    }
}

pub const PAIR: [Role; 2] = [Role::Adversarial, Role::Cooperative];

fn some(dice: &mut Dice, states: usize, chance: usize) -> Set {
    (0..states).map(|state| Set::from(dice.percent(chance)) << state).sum()
}

fn watcher(dice: &mut Dice, role: Role, states: usize, actions: usize, start: usize) -> Watcher {
    let belief = 1 << start | if dice.percent(40) { some(dice, states, 45) } else { 0 };
    let kind = dice.below(5);
    let count = match kind {
        0 => 1,
        1 => actions * states,
        _ => dice.between(2, 3),
    };
    let of_action: Vec<usize> = (0..actions).map(|_| dice.below(count)).collect();
    let of_state: Vec<usize> = (0..states).map(|_| dice.below(count)).collect();
    let sensor = (0..actions)
        .map(|action| {
            (0..states)
                .map(|state| match kind {
                    0 => 0,
                    1 => action * states + state,
                    2 => of_action[action],
                    3 => of_state[state],
                    _ => dice.below(count),
                })
                .collect()
        })
        .collect();
    Watcher { role, belief, symbols: (0..count).map(|o| format!("o{o}")).collect(), sensor }
}

/// Bounds, often several, now and then too much to ask.
pub fn wish(dice: &mut Dice, table: &Table) -> Wish {
    let goals = table.goals.len();
    let mut wish = Wish::default();
    if dice.percent(60) {
        wish.k = Some(dice.between(1, goals).min(dice.between(1, goals)));
    }
    if dice.percent(60) {
        wish.j = Some(dice.between(1, goals).max(dice.between(1, goals)));
    }
    for list in [&mut wish.required, &mut wish.forbidden] {
        while dice.percent(10) {
            list.push((dice.below(table.watchers.len()), dice.below(goals)));
        }
    }
    wish
}

/// A horizon with no more than `most` plans to try.
pub fn horizon(dice: &mut Dice, table: &Table, most: usize) -> usize {
    let longest = (0..).take_while(|&t| table.actions.len().pow(t) <= most).take(8).count() - 1;
    dice.below(longest + 1)
}
