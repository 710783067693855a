//! The operators behind each symbol as one relation on values of groups, and images under it.
//!
//! A step that gives a symbol is an operator and, where the sensor looks at the resulting state, what it asks of it.
//! Each is a list of partial maps from values to values, one for each level; most levels keep their value. Steps that do the same from a
//! level on are one there, so that a set of steps is met again by many nodes, and the image of a whole
//! belief under all of a symbol's steps is one walk over its nodes (the relational product of symbolic model
//! checking: Burch et al. 1992, doi:10.1016/0890-5401(92)90017-A).

use std::collections::BTreeMap;
use std::sync::Arc;

use rustc_hash::{FxHashMap, FxHashSet};

use crate::limits::LimitReached;
use crate::sensor::{Sensor, Symbol};
use crate::task::{State, Task};

use super::step::{Map, Step, split};
use super::store::{Branch, Diagrams, SetId, state};

/// What a step does from a level on: it keeps all values, or the map of the level and what it does below.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
struct Tail(u32);

/// The step that keeps the values of all levels that are left.
const KEEPS: Tail = Tail(0);

/// A set of tails, by its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct TailSet(u32);

/// New values, each with what is left to do below.
pub(super) type NextValues = Arc<[(u32, TailSet)]>;

/// The relations of one sensor's symbols, and the images worked out so far.
#[derive(Debug, Clone)]
pub struct SymbolRelations {
    /// For each tail but the first its map and the tail below.
    tails: Vec<(u32, Tail)>,
    maps: Vec<Map>,
    sets: Vec<Box<[Tail]>>,
    set_numbers: FxHashMap<Box<[Tail]>, TailSet>,
    /// For a set of tails and an old value: the new values and what is left to do for each.
    steps: FxHashMap<(TailSet, u32), NextValues>,
    /// The steps of each symbol.
    symbols: Vec<TailSet>,
    images: FxHashMap<(SetId, TailSet), SetId>,
}

/// The most values that the maps of a task's operators list together (four bytes each, and as much again while relations are
/// made).
const MOST_MAPPED_VALUES: usize = 4_000_000;

/// The most levels of a diagram: work on it goes as deep as it has levels.
const MOST_LEVELS: usize = 1000;

/// Whether a task is of the kind that diagrams are for: many groups of few facts. An operator lists what it does to each
/// value of each group that it touches, which is too much where groups are as large as a wide grid.
pub fn suits(task: &Task) -> bool {
    let layout = task.layout();
    if layout.group_count() > MOST_LEVELS {
        return false;
    }
    let mut values = 0_usize;
    for operator in task.operators() {
        let touched = operator.preconditions.iter().chain(&operator.add).chain(&operator.delete);
        values += touched.map(|&fact| layout.group_size(layout.group(fact)) + 1).sum::<usize>();
        if values > MOST_MAPPED_VALUES {
            return false;
        }
    }
    true
}

impl SymbolRelations {
    /// The relations of a sensor. Linear in the operators times the levels, and in the cases of the sensor times the facts
    /// they look at.
    pub fn new(task: &Task, sensor: &Sensor) -> Self {
        let mut relations = Self::empty();
        let mut numbers = Numbers::default();
        let mut roots: Vec<Vec<Tail>> = vec![Vec::new(); sensor.symbol_count()];
        for (id, operator) in task.operator_ids() {
            for (step, symbol) in split(task, id, vec![Step::of(task, operator)], sensor) {
                roots[symbol.index()].extend(relations.tail(task, &step, 0, &mut numbers));
            }
        }
        relations.symbols = roots.into_iter().map(|tails| relations.set(tails)).collect();
        relations
    }

    /// The relations of all sensors read together: the symbol of a step is the number of the combination of their symbols.
    pub fn joint(
        task: &Task,
        sensors: &[&Sensor],
        mut number: impl FnMut(&[Symbol]) -> u32,
    ) -> Self {
        let mut relations = Self::empty();
        let mut numbers = Numbers::default();
        let mut roots: Vec<Vec<Tail>> = Vec::new();
        for (id, operator) in task.operator_ids() {
            let mut steps = vec![(Step::of(task, operator), Vec::new())];
            for sensor in sensors {
                let mut next = Vec::new();
                for (step, seen) in steps {
                    for (step, symbol) in split(task, id, vec![step], sensor) {
                        let mut seen: Vec<Symbol> = seen.clone();
                        seen.push(symbol);
                        next.push((step, seen));
                    }
                }
                steps = next;
            }
            for (step, seen) in steps {
                let Some(tail) = relations.tail(task, &step, 0, &mut numbers) else { continue };
                let label = number(&seen) as usize;
                if roots.len() <= label {
                    roots.resize(label + 1, Vec::new());
                }
                roots[label].push(tail);
            }
        }
        relations.symbols = roots.into_iter().map(|tails| relations.set(tails)).collect();
        relations
    }

    /// The steps of all operators by the first level that they touch: what they do from there on. There are no symbols.
    pub(super) fn by_first_level(task: &Task) -> (Self, Vec<TailSet>) {
        let mut relations = Self::empty();
        let mut numbers = Numbers::default();
        let mut levels: Vec<Vec<Tail>> = vec![Vec::new(); task.layout().group_count()];
        for operator in task.operators() {
            let step = Step::of(task, operator);
            if let Some(first) = step.first_level() {
                levels[first].extend(relations.tail(task, &step, first, &mut numbers));
            }
        }
        let sets = levels.into_iter().map(|tails| relations.set(tails)).collect();
        (relations, sets)
    }

    /// Whether steps keep all values.
    pub(super) fn keeps(&self, steps: TailSet) -> bool {
        *self.sets[steps.0 as usize] == [KEEPS]
    }

    fn empty() -> Self {
        Self {
            tails: Vec::new(),
            maps: Vec::new(),
            sets: Vec::new(),
            set_numbers: FxHashMap::default(),
            steps: FxHashMap::default(),
            symbols: Vec::new(),
            images: FxHashMap::default(),
        }
    }

    /// How many symbols there are.
    pub fn len(&self) -> usize {
        self.symbols.len()
    }

    /// The tail of a step from a level on; none where it can never be taken.
    fn tail(
        &mut self,
        task: &Task,
        step: &Step,
        from: usize,
        numbers: &mut Numbers,
    ) -> Option<Tail> {
        let mut tail = KEEPS;
        for level in (from..task.layout().group_count()).rev() {
            let values = task.layout().group_size(task.group_order().group(level)) + 1;
            let map = match step.map(level, values) {
                Some(map) if map.iter().all(Option::is_none) => return None,
                Some(map) => map,
                None if tail == KEEPS => continue,
                None => (0..values as u32).map(Some).collect(),
            };
            let next = self.maps.len() as u32;
            let map = *numbers.maps.entry(map).or_insert_with_key(|map| {
                self.maps.push(map.clone());
                next
            });
            let next = Tail(self.tails.len() as u32 + 1);
            tail = *numbers.tails.entry((level, map, tail)).or_insert_with(|| {
                self.tails.push((map, tail));
                next
            });
        }
        Some(tail)
    }

    fn set(&mut self, mut tails: Vec<Tail>) -> TailSet {
        tails.sort_unstable();
        tails.dedup();
        let tails = tails.into_boxed_slice();
        if let Some(&known) = self.set_numbers.get(&tails) {
            return known;
        }
        let number = TailSet(self.sets.len() as u32);
        self.sets.push(tails.clone());
        self.set_numbers.insert(tails, number);
        number
    }

    /// What a set of tails makes of an old value: the new ones, each with what is left to do.
    pub(super) fn step(&mut self, set: TailSet, value: u32) -> NextValues {
        if let Some(known) = self.steps.get(&(set, value)) {
            return Arc::clone(known);
        }
        let mut found: BTreeMap<u32, Vec<Tail>> = BTreeMap::new();
        for &tail in &self.sets[set.0 as usize] {
            if let Some((next, below)) = self.follow(tail, value) {
                found.entry(next).or_default().push(below);
            }
        }
        let steps: NextValues =
            found.into_iter().map(|(next, tails)| (next, self.set(tails))).collect();
        self.steps.insert((set, value), Arc::clone(&steps));
        steps
    }

    /// Bytes in use, counted by contents.
    pub fn bytes(&self) -> u64 {
        let steps: usize = self.steps.values().map(|steps| 40 + 8 * steps.len()).sum();
        let sets: usize = self.sets.iter().map(|set| 64 + 8 * set.len()).sum();
        (24 * self.images.len() + steps + sets) as u64
    }

    /// The belief after a symbol: every state that some operator leads to from a state of `belief` and on which the
    /// sensor reads the symbol (Section 2 of the paper). Each pair of a node and a set of steps is worked
    /// out once.
    ///
    /// # Errors
    ///
    /// [`LimitReached::Memory`] when the nodes outgrow the limit of `diagrams`.
    pub fn update(
        &mut self,
        diagrams: &mut Diagrams,
        belief: SetId,
        symbol: Symbol,
    ) -> Result<SetId, LimitReached> {
        let next = self.image(diagrams, belief, self.symbols[symbol.index()])?;
        if diagrams.is_tight(24 * self.images.len() as u64) {
            // What has been worked out can be worked out again.
            self.forget_images();
            diagrams.forget_unions();
        }
        diagrams.check(self.bytes())?;
        Ok(next)
    }

    /// Forgets the images that were worked out: they are of other diagrams.
    pub fn forget_images(&mut self) {
        self.images = FxHashMap::default();
    }

    /// A state of `belief` from which a step that gives the symbol leads to a state.
    pub fn predecessor(
        &self,
        diagrams: &Diagrams,
        belief: SetId,
        symbol: Symbol,
        target: &State,
    ) -> Option<State> {
        let task = diagrams.task();
        let (layout, order) = (task.layout(), task.group_order());
        let wanted: Vec<u32> = (0..layout.group_count())
            .map(|level| layout.group_value(target.words(), order.group(level)) as u32)
            .collect();
        let tails = self.sets[self.symbols.get(symbol.index())?.0 as usize].to_vec();
        let mut before = Backwards { wanted, dead: FxHashSet::default(), values: Vec::new() };
        before.walk(self, diagrams, belief, tails).then(|| state(task, &before.values))
    }

    /// Where a tail leads from an old value: the new one, and what is left to do.
    fn follow(&self, tail: Tail, value: u32) -> Option<(u32, Tail)> {
        let Some(place) = tail.0.checked_sub(1) else { return Some((value, KEEPS)) };
        let (map, below) = self.tails[place as usize];
        let next = self.maps[map as usize].get(value as usize).copied().flatten()?;
        Some((next, below))
    }

    fn image(
        &mut self,
        diagrams: &mut Diagrams,
        set: SetId,
        steps: TailSet,
    ) -> Result<SetId, LimitReached> {
        match &*self.sets[steps.0 as usize] {
            [] => return Ok(SetId::EMPTY),
            [KEEPS] => return Ok(set),
            _ => {}
        }
        if set == SetId::EMPTY || set == SetId::END {
            return Ok(set);
        }
        if let Some(&known) = self.images.get(&(set, steps)) {
            return Ok(known);
        }
        let mut reached: BTreeMap<u32, SetId> = BTreeMap::new();
        for index in 0..diagrams.branches(set).len() {
            let Branch { value, below } = diagrams.branches(set)[index];
            for &(next, left) in &*self.step(steps, value) {
                let image = self.image(diagrams, below, left)?;
                if image != SetId::EMPTY {
                    let known = reached.get(&next).copied().unwrap_or(SetId::EMPTY);
                    reached.insert(next, diagrams.union(known, image)?);
                }
            }
        }
        let branches: Vec<Branch> =
            reached.into_iter().map(|(value, below)| Branch { value, below }).collect();
        let image = diagrams.node(diagrams.level(set), &branches)?;
        self.images.insert((set, steps), image);
        Ok(image)
    }
}

/// Numbers of maps and tails while relations are made.
#[derive(Debug, Default)]
struct Numbers {
    maps: FxHashMap<Map, u32>,
    tails: FxHashMap<(usize, u32, Tail), Tail>,
}

/// A walk down a diagram to a state that steps lead from to a wanted one.
struct Backwards {
    wanted: Vec<u32>,
    dead: FxHashSet<(SetId, Vec<Tail>)>,
    values: Vec<u32>,
}

impl Backwards {
    fn walk(
        &mut self,
        relations: &SymbolRelations,
        diagrams: &Diagrams,
        set: SetId,
        tails: Vec<Tail>,
    ) -> bool {
        if set == SetId::EMPTY || tails.is_empty() {
            return false;
        }
        if set == SetId::END {
            return true;
        }
        if self.dead.contains(&(set, tails.clone())) {
            return false;
        }
        let wanted = self.wanted[diagrams.level(set) as usize];
        for &Branch { value, below } in diagrams.branches(set) {
            let mut left: Vec<Tail> = tails
                .iter()
                .filter_map(|&tail| relations.follow(tail, value))
                .filter_map(|(next, left)| (next == wanted).then_some(left))
                .collect();
            left.sort_unstable();
            left.dedup();
            self.values.push(value);
            if self.walk(relations, diagrams, below, left) {
                return true;
            }
            self.values.pop();
        }
        self.dead.insert((set, tails));
        false
    }
}
