//! Hopes: which goals should survive for the enemy, and which should die for the friend.

use crate::solver::Bounds;

/// Goals beside the true one, by their positions in the problem.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Hope {
    /// Those that survive for the enemy.
    pub alive: Vec<usize>,
    /// Those that die for the friend.
    pub dead: Vec<usize>,
}

/// Sets of goals, all those of one size that hold some which must be there.
fn sets(goals: &[usize], size: usize, needed: &[usize]) -> Vec<Vec<usize>> {
    let of_size = |set: &Vec<usize>| set.len() == size && needed.iter().all(|n| set.contains(n));
    let members = |bits: u32| (0..goals.len()).filter(move |i| bits >> i & 1 == 1);
    let all = (0..1_u32 << goals.len()).map(|bits| members(bits).map(|i| goals[i]).collect());
    all.filter(of_size).collect()
}

/// The hopes of which a plan must fulfil one to keep the bounds, from the best to the worst by what
/// they are worth; with `best` false all of them that ask for no more than the bounds do, together.
pub(super) fn hopes(others: &[usize], bounds: &Bounds, best: bool) -> Vec<Vec<Hope>> {
    let goals = others.len() + 1;
    let needed = |watched: &[crate::solver::Watched]| {
        watched.iter().map(|w| w.goal).filter(|goal| others.contains(goal)).collect::<Vec<_>>()
    };
    let (required, forbidden) = (needed(&bounds.required), needed(&bounds.forbidden));
    // More than asked for, where more goals are named than counted.
    let count = |named: &Vec<usize>| others.iter().filter(|goal| named.contains(goal)).count();
    let alive = bounds.at_least.map_or(0, |k| k - 1).max(count(&required));
    let dead = bounds.at_most.map_or(0, |j| goals - j).max(count(&forbidden));
    let of = |alive: usize, dead: usize| {
        let pairs = sets(others, alive, &required).into_iter().flat_map(|alive| {
            let dead = sets(others, dead, &forbidden).into_iter();
            dead.map(move |dead| Hope { alive: alive.clone(), dead })
        });
        pairs.collect::<Vec<_>>()
    };
    if !best {
        return vec![of(alive, dead)];
    }
    let worth = (alive + dead..=2 * others.len()).rev();
    let group = |worth: usize| {
        let sizes = alive..=others.len().min(worth - dead);
        let sizes = sizes.filter(|alive| worth - alive <= others.len());
        sizes.flat_map(|alive| of(alive, worth - alive)).collect()
    };
    worth.map(group).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::Watched;

    #[test]
    fn a_search_hopes_for_what_its_bounds_ask_for_and_no_more() {
        let bounds = Bounds { at_least: Some(2), at_most: Some(2), ..Bounds::default() };
        let found = hopes(&[1, 2], &bounds, false);
        let hope =
            |alive: &[usize], dead: &[usize]| Hope { alive: alive.into(), dead: dead.into() };
        let all = [hope(&[1], &[1]), hope(&[1], &[2]), hope(&[2], &[1]), hope(&[2], &[2])];
        assert_eq!(found, [all.to_vec()]);
    }

    #[test]
    fn the_best_come_first_and_named_goals_are_in_all_of_them() {
        let bounds = Bounds {
            required: vec![Watched { observer: 0, goal: 2 }],
            forbidden: vec![Watched { observer: 1, goal: 1 }],
            ..Bounds::default()
        };
        let found = hopes(&[1, 2], &bounds, true);
        let sizes: Vec<usize> = found.iter().map(Vec::len).collect();
        assert_eq!(sizes, [1, 2, 1]);
        for hope in found.iter().flatten() {
            assert!(hope.alive.contains(&2) && hope.dead.contains(&1), "{hope:?}");
        }
    }
}
