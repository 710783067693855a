//! Answers by brute force, from the definitions alone.

use std::collections::{BTreeMap, BTreeSet, HashSet};

use mo_copp::solver::{Bounds, Watched};

use super::table::{Goals, Set, Table};

/// The goals that survive for each watcher at the end of a plan.
pub type Ending = Vec<Goals>;

/// What a plan must achieve.
#[derive(Debug, Clone, Default)]
pub struct Wish {
    pub k: Option<usize>,
    pub j: Option<usize>,
    /// Watcher and goal.
    pub required: Vec<(usize, usize)>,
    pub forbidden: Vec<(usize, usize)>,
}

impl Wish {
    pub fn allows(&self, table: &Table, ending: &[Goals]) -> bool {
        let (adversarial, cooperative) = table.counts(ending);
        let survives = |&(watcher, goal): &(usize, usize)| ending[watcher] >> goal & 1 == 1;
        self.k.is_none_or(|k| adversarial >= k)
            && self.j.is_none_or(|j| cooperative <= j)
            && self.required.iter().all(survives)
            && !self.forbidden.iter().any(survives)
    }

    pub fn bounds(&self) -> Bounds {
        let watched = |pairs: &[(usize, usize)]| {
            pairs.iter().map(|&(observer, goal)| Watched { observer, goal }).collect()
        };
        let mut bounds = Bounds::default()
            .with_required(watched(&self.required))
            .with_forbidden(watched(&self.forbidden));
        (bounds.at_least, bounds.at_most) = (self.k, self.j);
        bounds
    }
}

/// A state with what each watcher believes.
type Situation = (usize, Vec<Set>);

fn first(table: &Table) -> Situation {
    (table.start, table.watchers.iter().map(|watcher| watcher.belief).collect())
}

/// The situation after an action, with the symbols seen; none where it is not applicable.
pub fn step(
    table: &Table,
    situation: &Situation,
    action: usize,
) -> Option<(Vec<usize>, Situation)> {
    let target = table.next[situation.0][action]?;
    let read = |(watcher, &belief): (usize, &Set)| {
        let symbol = table.watchers[watcher].sensor[action][target];
        (symbol, table.update(watcher, belief, symbol))
    };
    let (symbols, beliefs) = situation.1.iter().enumerate().map(read).unzip();
    Some((symbols, (target, beliefs)))
}

pub fn ending(table: &Table, beliefs: &[Set]) -> Ending {
    beliefs.iter().map(|&belief| table.survivors(belief)).collect()
}

/// Goes through every plan of exactly `horizon` actions, one by one. Returns each ending there is.
pub fn enumerate(table: &Table, horizon: usize) -> BTreeSet<Ending> {
    fn descend(table: &Table, situation: &Situation, left: usize, found: &mut BTreeSet<Ending>) {
        if left == 0 {
            if table.is_goal(situation.0) {
                found.insert(ending(table, &situation.1));
            }
            return;
        }
        for action in 0..table.actions.len() {
            if let Some((_, next)) = step(table, situation, action) {
                descend(table, &next, left - 1, found);
            }
        }
    }
    let mut found = BTreeSet::new();
    descend(table, &first(table), horizon, &mut found);
    found
}

/// Goes through every situation that any plan can lead to. Returns each ending there is, with the
/// length of a shortest plan for it.
pub fn close(table: &Table) -> BTreeMap<Ending, usize> {
    let mut layer = vec![first(table)];
    let mut known: HashSet<Situation> = layer.iter().cloned().collect();
    let mut endings = BTreeMap::new();
    let mut length = 0;
    while !layer.is_empty() {
        let mut next = Vec::new();
        for situation in &layer {
            if table.is_goal(situation.0) {
                endings.entry(ending(table, &situation.1)).or_insert(length);
            }
            for action in 0..table.actions.len() {
                if let Some((_, after)) = step(table, situation, action)
                    && known.insert(after.clone())
                {
                    next.push(after);
                }
            }
        }
        layer = next;
        length += 1;
    }
    endings
}

/// The numerator of the goal difference.
pub fn difference(table: &Table, ending: &[Goals]) -> i64 {
    let (adversarial, cooperative) = table.counts(ending);
    adversarial as i64 - cooperative as i64
}

/// The best numerator among the endings a wish allows.
pub fn best<'a>(
    table: &Table,
    endings: impl IntoIterator<Item = &'a Ending>,
    wish: &Wish,
) -> Option<i64> {
    let allowed = endings.into_iter().filter(|ending| wish.allows(table, ending));
    allowed.map(|ending| difference(table, ending)).max()
}

/// One step of a replay.
pub struct Replayed {
    pub state: usize,
    /// Empty at the start.
    pub symbols: Vec<usize>,
    pub beliefs: Vec<Set>,
}

/// Replays a plan; none where a step is not applicable.
pub fn replay(table: &Table, plan: &[usize]) -> Option<Vec<Replayed>> {
    let mut situation = first(table);
    let start = Replayed { state: situation.0, symbols: Vec::new(), beliefs: situation.1.clone() };
    let mut steps = vec![start];
    for &action in plan {
        let (symbols, next) = step(table, &situation, action)?;
        situation = next;
        steps.push(Replayed { state: situation.0, symbols, beliefs: situation.1.clone() });
    }
    Some(steps)
}
