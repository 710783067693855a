//! All states that a task can reach, as a diagram: saturation.
//!
//! An operator counts to the first level that it touches. The nodes below are closed under the operators of their levels
//! before those of a level above are applied, and what these lead to is closed at once, so that few nodes are made that
//! are not part of the answer (Ciardo, Lüttgen and Siminiceanu 2001, "Saturation: an efficient iteration strategy for
//! symbolic state-space generation", doi:10.1007/3-540-45319-9_23).

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use rustc_hash::FxHashMap;

use super::relation::{SymbolRelations, TailSet};
use super::store::{Branch, Diagrams, SetId};
use crate::limits::{LimitReached, Limits};
use crate::task::Task;

/// The states that some sequence of actions leads to from the initial state of a task of the kind that
/// [`suits`](super::suits) diagrams, in a store that holds no other set.
///
/// # Errors
///
/// [`LimitReached::Memory`] when the nodes, or what is remembered beside them, outgrow `limits`.
pub fn reachable(task: &Arc<Task>, limits: Limits) -> Result<(Diagrams, SetId), LimitReached> {
    let (relations, operators) = SymbolRelations::by_first_level(task);
    let diagrams = Diagrams::new(Arc::clone(task), limits);
    let mut closure = Closure {
        diagrams,
        relations,
        operators,
        closed: FxHashMap::default(),
        images: FxHashMap::default(),
    };
    let start = closure.diagrams.single(task.initial_state())?;
    let set = closure.of(start)?;
    Ok(closure.diagrams.alone(set))
}

/// How many images are worked out between two looks at the memory that is taken beside the nodes.
const IMAGES_BETWEEN_CHECKS: usize = 4096;

/// Sets that are closed under the operators of their level and of those below.
struct Closure {
    diagrams: Diagrams,
    relations: SymbolRelations,
    /// The operators by the first level that they touch.
    operators: Vec<TailSet>,
    closed: FxHashMap<SetId, SetId>,
    /// The closed image of a closed set under steps.
    images: FxHashMap<(SetId, TailSet), SetId>,
}

impl Closure {
    /// The least closed set with all states of another.
    fn of(&mut self, set: SetId) -> Result<SetId, LimitReached> {
        if set == SetId::EMPTY || set == SetId::END {
            return Ok(set);
        }
        if let Some(&known) = self.closed.get(&set) {
            return Ok(known);
        }
        let mut values = BTreeMap::new();
        for index in 0..self.diagrams.branches(set).len() {
            let Branch { value, below } = self.diagrams.branches(set)[index];
            values.insert(value, self.of(below)?);
        }
        let closed = self.close(self.diagrams.level(set), values)?;
        self.closed.insert(set, closed);
        Ok(closed)
    }

    /// The closed image of a closed set.
    fn image(&mut self, set: SetId, steps: TailSet) -> Result<SetId, LimitReached> {
        if set == SetId::EMPTY || set == SetId::END || self.relations.keeps(steps) {
            return Ok(set);
        }
        if let Some(&known) = self.images.get(&(set, steps)) {
            return Ok(known);
        }
        let mut values = BTreeMap::new();
        for index in 0..self.diagrams.branches(set).len() {
            let Branch { value, below } = self.diagrams.branches(set)[index];
            self.follow(steps, value, below, &mut values, |_| {})?;
        }
        let image = self.close(self.diagrams.level(set), values)?;
        self.images.insert((set, steps), image);
        if self.images.len().is_multiple_of(IMAGES_BETWEEN_CHECKS) {
            let remembered = 24 * (self.images.len() + self.closed.len()) as u64;
            self.diagrams.check(self.relations.bytes() + remembered)?;
        }
        Ok(image)
    }

    /// Applies the operators of a level to the closed sets below each of its values until they lead to nothing new.
    fn close(
        &mut self,
        level: u32,
        mut values: BTreeMap<u32, SetId>,
    ) -> Result<SetId, LimitReached> {
        let operators = self.operators[level as usize];
        let mut new: BTreeSet<u32> = values.keys().copied().collect();
        while let Some(value) = new.pop_first() {
            let below = values[&value];
            self.follow(operators, value, below, &mut values, |grown| {
                new.insert(grown);
            })?;
        }
        let branches: Vec<Branch> =
            values.into_iter().map(|(value, below)| Branch { value, below }).collect();
        self.diagrams.node(level, &branches)
    }

    /// Joins what steps make of one value, and of the closed set below it, to closed sets below values; `grown` hears of
    /// those that are larger then.
    fn follow(
        &mut self,
        steps: TailSet,
        value: u32,
        below: SetId,
        values: &mut BTreeMap<u32, SetId>,
        mut grown: impl FnMut(u32),
    ) -> Result<(), LimitReached> {
        for &(next, left) in &*self.relations.step(steps, value) {
            let image = self.image(below, left)?;
            let known = values.get(&next).copied().unwrap_or(SetId::EMPTY);
            let joined = self.diagrams.union(known, image)?;
            if joined != known {
                values.insert(next, joined);
                grown(next);
            }
        }
        Ok(())
    }
}
