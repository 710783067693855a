//! Belief layers: an observer's beliefs along a plan, and the walks through them that show what is possible and what is not.
//!
//! The observer's beliefs along a plan, layer by layer, with a predecessor for each believed state: what is possible has
//! a walk with the same symbols, found by going back. What is not possible is reached, if at all, by a walk that leaves
//! the beliefs somewhere; the one that stays in them longest is the most telling.

use std::hash::BuildHasherDefault;
use std::sync::Arc;

use indexmap::IndexMap;
use rustc_hash::FxHasher;

use super::Unfit;
use super::verdict::{Counterexample, Finding};
use crate::plan::{Plan, execute};
use crate::problem::{Problem, Role};
use crate::sensor::Symbol;
use crate::task::{Edge, StateId, StateSpace};

/// The most states that are met: exercises are for problems that a person can survey.
pub(super) const MAX_STATES: usize = 20_000;

/// States in the order in which they were met, each with the transition that led there first.
type Layer = IndexMap<StateId, Option<(StateId, Edge)>, BuildHasherDefault<FxHasher>>;

/// The beliefs of an observer along a plan.
#[derive(Debug)]
pub(super) struct BeliefLayers {
    problem: Arc<Problem>,
    observer: usize,
    space: StateSpace,
    seen: Vec<Symbol>,
    layers: Vec<Layer>,
    /// Where walks of as many steps end, whatever their symbols; none until that is asked.
    ends: Option<Vec<StateId>>,
}

/// What is said of a goal that holds in a believed state.
pub(super) const POSSIBLE: &str = "possible for";
/// What is said of a believed state.
pub(super) const BELIEVED: &str = "believed by";

/// A word for an observer of a role.
pub(super) fn called(role: Role) -> &'static str {
    match role {
        Role::Adversarial => "the enemy",
        Role::Cooperative => "the friend",
    }
}

impl BeliefLayers {
    /// Follows what the observer at this position sees of a plan.
    pub(super) fn new(problem: &Arc<Problem>, observer: usize, plan: &Plan) -> Result<Self, Unfit> {
        let task = problem.task();
        let label = |words: &[u64]| problem.label(words).to_string();
        let (operators, states) = execute(task, plan, label)
            .map_err(|error| Unfit::new(format!("the walk fails: {error}")))?;
        let sensor = &problem.observers()[observer].sensor;
        let seen: Vec<Symbol> = operators
            .iter()
            .zip(&states[1..])
            .map(|(&operator, state)| sensor.read(task, operator, state.words()))
            .collect();
        let mut space = StateSpace::new(Arc::clone(task));
        let believed = problem.observers()[observer].initial_belief.listed();
        let mut first = believed.ok_or_else(Unfit::too_large)?.to_vec();
        first.sort_unstable();
        let layer: Layer = first.iter().map(|state| (space.intern(state), None)).collect();
        let mut layers = Self {
            problem: Arc::clone(problem),
            observer,
            space,
            seen,
            layers: vec![layer],
            ends: None,
        };
        for step in 0..layers.seen.len() {
            let seen = layers.seen[step];
            let next =
                layers.next(&layers.layers[step].keys().copied().collect::<Vec<_>>(), Some(seen));
            layers.layers.push(next.ok_or_else(Unfit::too_large)?);
        }
        Ok(layers)
    }

    /// The states one step on, with this symbol or with any; none where there are too many.
    fn next(&mut self, from: &[StateId], symbol: Option<Symbol>) -> Option<Layer> {
        let mut next = Layer::default();
        for &state in from {
            self.space.expand(state);
            if self.space.len() > MAX_STATES {
                return None;
            }
            for edge in self.space.edges(state) {
                if symbol.is_none_or(|symbol| self.symbol(edge) == symbol) {
                    next.entry(edge.target).or_insert(Some((state, *edge)));
                }
            }
        }
        Some(next)
    }

    fn symbol(&self, edge: &Edge) -> Symbol {
        let sensor = &self.problem.observers()[self.observer].sensor;
        sensor.read(self.problem.task(), edge.operator, self.space.words(edge.target))
    }

    /// How many steps the plan has.
    pub(super) fn steps(&self) -> usize {
        self.seen.len()
    }

    /// The packed states believed after a step, in the order in which they were met.
    pub(super) fn believed(&self, step: usize) -> impl Iterator<Item = &[u64]> {
        self.layers[step].keys().map(|&state| self.space.words(state))
    }

    /// Whether some state believed at the end has a property.
    pub(super) fn possible(&self, holds: impl Fn(&[u64]) -> bool) -> bool {
        self.believed(self.steps()).any(holds)
    }

    /// A walk back through layers to its beginning: the edges, and where it begins.
    fn back(layers: &[&Layer], end: StateId) -> (StateId, Vec<Edge>) {
        let mut edges = Vec::with_capacity(layers.len());
        let mut at = end;
        for layer in layers.iter().rev() {
            let Some(Some((before, edge))) = layer.get(&at) else { break };
            edges.push(*edge);
            at = *before;
        }
        edges.reverse();
        (at, edges)
    }

    fn counterexample(&self, start: StateId, edges: &[Edge]) -> Counterexample {
        let task = self.problem.task();
        let sensor = &self.problem.observers()[self.observer].sensor;
        let label = |state: StateId| self.problem.label(self.space.words(state));
        let symbols: Vec<Symbol> = edges.iter().map(|edge| self.symbol(edge)).collect();
        let differs = symbols.iter().zip(&self.seen).position(|(shown, seen)| shown != seen);
        Counterexample {
            observer: self.problem.observers()[self.observer].name.clone(),
            start: label(start),
            actions: edges.iter().map(|edge| task.action_name(edge.action).to_owned()).collect(),
            symbols: symbols.iter().map(|&symbol| sensor.name(symbol).to_owned()).collect(),
            end: label(edges.last().map_or(start, |edge| edge.target)),
            differs: differs.map(|step| step + 1),
        }
    }

    /// A walk with the symbols seen that ends in a state with a property.
    fn same_symbols(&self, holds: &dyn Fn(&[u64]) -> bool) -> Option<Counterexample> {
        let last = self.layers.last()?;
        let end = last.keys().copied().find(|&state| holds(self.space.words(state)))?;
        let (start, edges) = Self::back(&self.layers.iter().collect::<Vec<_>>(), end);
        Some(self.counterexample(start, &edges))
    }

    /// A walk of as many steps that ends in such a state and whose symbols are those seen for as long as any such walk's.
    /// Where there are too many states to know, that is an error.
    fn other_symbols(
        &mut self,
        holds: &dyn Fn(&[u64]) -> bool,
    ) -> Result<Option<Counterexample>, Unfit> {
        let steps = self.steps();
        for leaving in (0..steps).rev() {
            let mut beyond: Vec<Layer> = Vec::new();
            let mut from: Vec<StateId> = self.layers[leaving].keys().copied().collect();
            for _ in leaving..steps {
                let next = self.next(&from, None).ok_or_else(Unfit::too_large)?;
                from = next.keys().copied().collect();
                beyond.push(next);
            }
            if let Some(end) = from.iter().copied().find(|&state| holds(self.space.words(state))) {
                let layers: Vec<&Layer> = self.layers[..=leaving].iter().chain(&beyond).collect();
                let (start, edges) = Self::back(&layers, end);
                return Ok(Some(self.counterexample(start, &edges)));
            }
        }
        Ok(None)
    }

    /// Whether some walk of as many steps ends in such a state, whatever its symbols.
    pub(super) fn reachable(&mut self, holds: impl Fn(&[u64]) -> bool) -> bool {
        if self.ends.is_none() {
            let mut ends: Vec<StateId> = self.layers[0].keys().copied().collect();
            for _ in 0..self.steps() {
                // Where there are too many states, those believed are all that is known of.
                let Some(next) = self.next(&ends, None) else {
                    ends = self.layers[self.steps()].keys().copied().collect();
                    break;
                };
                ends = next.keys().copied().collect();
            }
            self.ends = Some(ends);
        }
        let ends = self.ends.iter().flatten();
        ends.copied().any(|end| holds(self.space.words(end)))
    }

    /// The states that the last symbol alone leaves: those to which a transition with that symbol leads, whatever was told
    /// before it. None where nothing was told, or where there are too many states.
    pub(super) fn told_last(&mut self) -> Option<Vec<StateId>> {
        let last = *self.seen.last()?;
        let mut known: Layer = self.layers[0].clone();
        let mut told = Layer::default();
        let mut at = 0;
        while let Some((&state, _)) = known.get_index(at) {
            at += 1;
            told.extend(self.next(&[state], Some(last))?);
            known.extend(self.next(&[state], None)?);
        }
        Some(told.into_keys().collect())
    }

    /// Whether some of these states has a property.
    pub(super) fn any(&self, states: &[StateId], holds: impl Fn(&[u64]) -> bool) -> bool {
        states.iter().any(|&state| holds(self.space.words(state)))
    }

    /// Why something is possible or believed, or why it is not. `what` names the property, `is` is one of [`POSSIBLE`] and
    /// [`BELIEVED`].
    pub(super) fn finding(
        &mut self,
        what: &str,
        is: &str,
        holds: impl Fn(&[u64]) -> bool,
    ) -> Finding {
        let who = called(self.problem.observers()[self.observer].role);
        if let Some(shown) = self.same_symbols(&holds) {
            let text = if shown.actions.is_empty() {
                format!("{what} is {is} {who}, which believes {} at first.", shown.start)
            } else {
                format!(
                    "{what} is {is} {who}: the walk {} from {} shows it the same symbols and ends at {}.",
                    shown.actions.join(", "),
                    shown.start,
                    shown.end
                )
            };
            return Finding { text, counterexample: Some(shown) };
        }
        let steps = self.steps();
        let shown = match self.other_symbols(&holds) {
            Ok(Some(shown)) => shown,
            Ok(None) => {
                let s = if steps == 1 { "" } else { "s" };
                return Finding::plain(format!(
                    "{what} is not {is} {who}: no walk of {steps} step{s} from where the agent may have begun ends there."
                ));
            }
            Err(_) => {
                return Finding::plain(format!(
                    "{what} is not {is} {who}: no walk that shows it the symbols it was told ends there."
                ));
            }
        };
        let step = shown.differs.unwrap_or(steps);
        let sensor = &self.problem.observers()[self.observer].sensor;
        let text = format!(
            "{what} is not {is} {who}: of all walks that end there, {} from {} shows the right symbols for longest, \
             but at step {step} it shows {:?}, where {who} was told {:?}.",
            shown.actions.join(", "),
            shown.start,
            shown.symbols.get(step - 1).map_or("", |symbol| symbol.as_str()),
            self.seen.get(step - 1).map_or("", |&symbol| sensor.name(symbol)),
        );
        Finding { text, counterexample: Some(shown) }
    }

    /// The symbols that the observer was told.
    pub(super) fn symbols(&self) -> Vec<String> {
        let sensor = &self.problem.observers()[self.observer].sensor;
        self.seen.iter().map(|&symbol| sensor.name(symbol).to_owned()).collect()
    }
}
