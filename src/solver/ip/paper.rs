//! The paper's integer program: equations (3) to (17), with products linearised and the printed
//! form corrected.
//!
//! Variables, all 0 or 1 in a solution (`i` an observer, `t` a step from 1 to T):
//!
//! | variable | meaning |
//! |---|---|
//! | `x_{a,t}` | action `a` is taken at step `t` |
//! | `y_{s,t}` | the actor is in state `s` after step `t` |
//! | `w^i_{o,t}` | observer `i` sees symbol `o` at step `t` |
//! | `b^i_{s,t}` | observer `i` holds state `s` possible after step `t` |
//! | `h^i_{s,a,t}` | `i` holds possible that action `a` was taken in state `s` at step `t` |
//! | `g^i_G` | goal `G` survives for observer `i` in the end |
//! | `p_{s,s',t}` | the product `y_{s,t−1} · y_{s',t}` of (10) |
//! | `q_{a,s',t}` | the product `x_{a,t} · y_{s',t}` of (11) |
//!
//! Corrections, each with a test in which the printed form gives a wrong answer:
//!
//! 1. (7) only pushes `g` up. Maximising would set every `g^X` to 1 for nothing, so
//!    `g^i_G ≤ Σ_{s ⊨ G} b^i_{s,T}` is added.
//! 2. (12), (13) and (15) leave the symbol free. It is the one of `(a, Γ(s, a))`.
//! 3. (10) lets `post_a` be every state with the add effects, and is an equality. Here the
//!    successor is `Γ(s, a)`, and `x_{a,t} ≤ Σ_s p_{s,Γ(s,a),t}` with `Σ_s y_{s,t} = 1`, so that two
//!    actions may have the same effect in a state.
//!
//! Only what can matter gets a variable: actor states on a way of exactly T steps to the true goal,
//! symbols such ways can give, believed states that such symbols can lead to and that can still
//! lead to a candidate goal. Products are linearised by their sums (`Σ_{s'} p_{s,s',t} = y_{s,t−1}`
//! and so on), which is tighter than bounding each by its factors; (7) is written for each state
//! on its own, which implies the printed sum; and the true state is believed (`y_{s,t} ≤ b^i_{s,t}`),
//! as the proof of the paper's first proposition says.

use std::collections::{BTreeMap, BTreeSet};

use super::Encoded;
use super::model::{Comparison, Kind, Model, Name, Variable};
use super::objective::maximise_difference;
use crate::limits::LimitReached;
use crate::problem::{JointSpace, Role};
use crate::sensor::Symbol;
use crate::solver::live::LiveLayers;
use crate::solver::{Bounds, Stats};
use crate::task::{Action, Edge, StateId};

/// A transition with its source.
type Transition = (StateId, Edge, usize);

/// Variables of a step, by what they stand for.
type Of<K> = BTreeMap<K, Variable>;

struct Writer<'a> {
    joint: &'a mut JointSpace,
    bounds: &'a Bounds,
    model: Model,
    horizon: usize,
    /// The actor's possible transitions at each step.
    transitions: Vec<Vec<Transition>>,
    y: Vec<Of<StateId>>,
    x: Vec<Of<Action>>,
}

/// Writes the model; none when the actor has no plan of this length, or a required goal cannot
/// survive.
///
/// # Errors
///
/// The memory limit, or the limit on the size of a model.
pub(super) fn encode(
    joint: &mut JointSpace,
    bounds: &Bounds,
    horizon: usize,
) -> Result<Option<Encoded>, LimitReached> {
    let live = LiveLayers::new(joint, horizon)?;
    let start = joint.initial().state;
    if !live.contains(0, start) {
        return Ok(None);
    }
    let mut transitions = Vec::new();
    let mut layer = BTreeSet::from([start]);
    for step in 0..horizon {
        let mut here = Vec::new();
        let mut next = BTreeSet::new();
        for &state in &layer {
            joint.states_mut().expand(state);
            for position in joint.states().edge_range(state) {
                let edge = joint.states().all_edges()[position];
                if live.contains(step + 1, edge.target) {
                    here.push((state, edge, position));
                    next.insert(edge.target);
                }
            }
        }
        transitions.push(here);
        layer = next;
    }
    let mut writer = Writer {
        joint,
        bounds,
        model: Model::default(),
        horizon,
        transitions,
        y: Vec::new(),
        x: Vec::new(),
    };
    writer.actor()?;
    let mut counts = Vec::new();
    for observer in 0..writer.joint.problem().observers().len() {
        counts.push(writer.observer(observer)?);
    }
    let Writer { joint, mut model, x, .. } = writer;
    maximise_difference(&mut model, joint.problem(), &counts);
    model.check(joint.limits())?;
    let choice = |of: &Of<Action>| of.iter().map(|(&action, &v)| (action, vec![v])).collect();
    let choices = x.iter().map(choice).collect();
    Ok(Some(Encoded { model, choices, spaces: Stats::default() }))
}

/// Terms with one coefficient.
fn each(variables: impl IntoIterator<Item = Variable>, coefficient: f64) -> Vec<(Variable, f64)> {
    variables.into_iter().map(|variable| (variable, coefficient)).collect()
}

impl Writer<'_> {
    fn binary(&mut self, name: Name) -> Variable {
        self.model.add(name, Kind::Binary)
    }

    /// Equations (3), (8) to (10) and (17).
    fn actor(&mut self) -> Result<(), LimitReached> {
        self.model.note("the paper's encoding: x_a_t action, y_s_t state, w_i_o_t symbol,");
        self.model.note("b_i_s_t believed state, h_i_s_a_t believed transition, g_i_G survivor,");
        self.model.note("p and q products of binaries; rows are named after the equations");
        let start = self.joint.initial().state;
        // (3): the initial state; a state with the true goal in the end is all that is live.
        let first = self.binary(Name::new("y", [start.index(), 0]));
        self.model.fix(first, 1.0);
        self.y.push(BTreeMap::from([(start, first)]));
        for step in 1..=self.horizon {
            let transitions = std::mem::take(&mut self.transitions[step - 1]);
            let mut y = BTreeMap::new();
            let mut x = BTreeMap::new();
            let mut p = BTreeMap::new();
            for &(from, edge, _) in &transitions {
                let to = edge.target;
                let action = edge.action.index();
                y.entry(to).or_insert_with(|| self.binary(Name::new("y", [to.index(), step])));
                x.entry(edge.action).or_insert_with(|| self.binary(Name::new("x", [action, step])));
                p.entry((from, to)).or_insert_with(|| {
                    self.binary(Name::new("p", [from.index(), to.index(), step]))
                });
            }
            let before = self.y[step - 1].clone();
            let name = |letter, index| Name::new(letter, [index, step]);
            // One state, one action: (17), as an equality since a plan has exactly T actions.
            self.model.row(
                Name::new("one_state", [step]),
                each(y.values().copied(), 1.0),
                Comparison::Equal,
                1.0,
            );
            self.model.row(
                Name::new("eq17", [step]),
                each(x.values().copied(), 1.0),
                Comparison::Equal,
                1.0,
            );
            for (&action, &taken) in &x {
                let of_action = || transitions.iter().filter(|(_, edge, _)| edge.action == action);
                let sources: BTreeSet<Variable> = of_action().map(|(s, _, _)| before[s]).collect();
                let mut terms = each(sources, -1.0);
                terms.push((taken, 1.0));
                self.model.row(name("eq8", action.index()), terms, Comparison::AtMost, 0.0);
                let products: BTreeSet<Variable> =
                    of_action().map(|(from, edge, _)| p[&(*from, edge.target)]).collect();
                let mut terms = each(products, -1.0);
                terms.push((taken, 1.0));
                self.model.row(name("eq10", action.index()), terms, Comparison::AtMost, 0.0);
            }
            for (&to, &there) in &y {
                let into = || transitions.iter().filter(|(_, edge, _)| edge.target == to);
                let actions: BTreeSet<Variable> = into().map(|(_, e, _)| x[&e.action]).collect();
                let sources: BTreeSet<Variable> = into().map(|(s, _, _)| before[s]).collect();
                let mut terms = each(actions, 1.0);
                terms.extend(each(sources, 1.0));
                terms.push((there, -2.0));
                self.model.row(name("eq9", to.index()), terms, Comparison::AtLeast, 0.0);
            }
            // The products of (10), by their sums.
            for (&from, &was) in &before {
                let mut terms =
                    each(p.iter().filter(|((s, _), _)| *s == from).map(|(_, &v)| v), 1.0);
                terms.push((was, -1.0));
                self.model.row(name("p_from", from.index()), terms, Comparison::Equal, 0.0);
            }
            for (&to, &there) in &y {
                let mut terms = each(p.iter().filter(|((_, s), _)| *s == to).map(|(_, &v)| v), 1.0);
                terms.push((there, -1.0));
                self.model.row(name("p_to", to.index()), terms, Comparison::Equal, 0.0);
            }
            // A change of state takes one of the actions that bring it about.
            for (&(from, to), &product) in &p {
                let actions = transitions.iter().filter(|(s, e, _)| (*s, e.target) == (from, to));
                let mut terms = each(actions.map(|(_, edge, _)| x[&edge.action]), -1.0);
                terms.push((product, 1.0));
                let name = Name::new("p_by", [from.index(), to.index(), step]);
                self.model.row(name, terms, Comparison::AtMost, 0.0);
            }
            self.transitions[step - 1] = transitions;
            self.y.push(y);
            self.x.push(x);
            self.model.check(self.joint.limits())?;
        }
        Ok(())
    }

    /// Equations (6), (7) and (11) to (16) for one observer, and the goal constraints; returns the
    /// expression of how many goals survive.
    fn observer(&mut self, i: usize) -> Result<Vec<(Variable, f64)>, LimitReached> {
        let symbols = self.symbols(i)?;
        let believed = self.believable(i, &symbols)?;
        let mut b: Of<StateId> = BTreeMap::new();
        for &state in &believed[0] {
            // (6): the initial belief.
            let variable = self.binary(Name::new("b", [i, state.index(), 0]));
            self.model.fix(variable, 1.0);
            b.insert(state, variable);
        }
        for step in 1..=self.horizon {
            b = self.update(i, step, &b, &symbols[step - 1], &believed[step])?;
        }
        self.survivors(i, &b)
    }

    /// The symbols of each step, with their variables: equation (11).
    fn symbols(&mut self, i: usize) -> Result<Vec<Of<Symbol>>, LimitReached> {
        let mut all = Vec::new();
        for step in 1..=self.horizon {
            let transitions = std::mem::take(&mut self.transitions[step - 1]);
            let mut q: BTreeMap<(Action, StateId), (Variable, Symbol)> = BTreeMap::new();
            let mut w: Of<Symbol> = BTreeMap::new();
            for &(_, edge, position) in &transitions {
                let symbol = self.joint.symbol(i, position);
                let (action, to) = (edge.action, edge.target);
                q.entry((action, to)).or_insert_with(|| {
                    let name = Name::new("q", [i, action.index(), to.index(), step]);
                    (self.binary(name), symbol)
                });
                w.entry(symbol)
                    .or_insert_with(|| self.binary(Name::new("w", [i, symbol.index(), step])));
            }
            for (&symbol, &seen) in &w {
                let products = q.values().filter(|(_, of)| *of == symbol).map(|(v, _)| *v);
                let mut terms = each(products, 1.0);
                terms.push((seen, -1.0));
                let name = Name::new("eq11", [i, symbol.index(), step]);
                self.model.row(name, terms, Comparison::Equal, 0.0);
            }
            // The products of (11), by their sums.
            for (&action, &taken) in &self.x[step - 1] {
                let products = q.iter().filter(|((a, _), _)| *a == action).map(|(_, (v, _))| *v);
                let mut terms = each(products, 1.0);
                terms.push((taken, -1.0));
                let name = Name::new("q_by", [i, action.index(), step]);
                self.model.row(name, terms, Comparison::Equal, 0.0);
            }
            for (&to, &there) in &self.y[step] {
                let products = q.iter().filter(|((_, s), _)| *s == to).map(|(_, (v, _))| *v);
                let mut terms = each(products, 1.0);
                terms.push((there, -1.0));
                let name = Name::new("q_to", [i, to.index(), step]);
                self.model.row(name, terms, Comparison::Equal, 0.0);
            }
            self.transitions[step - 1] = transitions;
            all.push(w);
            self.model.check(self.joint.limits())?;
        }
        Ok(all)
    }

    /// The states that can be believed after each step and can still lead to a candidate goal.
    fn believable(
        &mut self,
        i: usize,
        symbols: &[Of<Symbol>],
    ) -> Result<Vec<BTreeSet<StateId>>, LimitReached> {
        let profile = self.joint.initial().profile;
        let belief = self.joint.belief(profile, i);
        let mut layers: Vec<BTreeSet<StateId>> =
            vec![self.joint.beliefs(i).members(belief).iter().copied().collect()];
        for step in 1..=self.horizon {
            let mut next = BTreeSet::new();
            for &state in &layers[step - 1] {
                self.joint.states_mut().expand(state);
                for position in self.joint.states().edge_range(state) {
                    if symbols[step - 1].contains_key(&self.joint.symbol(i, position)) {
                        next.insert(self.joint.states().all_edges()[position].target);
                    }
                }
            }
            self.joint.limits().check_bytes(self.joint.bytes())?;
            layers.push(next);
        }
        let mut last = std::mem::take(&mut layers[self.horizon]);
        last.retain(|&state| !self.joint.goals_of_state(state).is_empty());
        layers[self.horizon] = last;
        for step in (1..=self.horizon).rev() {
            let mut here = std::mem::take(&mut layers[step - 1]);
            here.retain(|&state| {
                self.joint.states().edge_range(state).any(|position| {
                    let target = self.joint.states().all_edges()[position].target;
                    layers[step].contains(&target)
                        && symbols[step - 1].contains_key(&self.joint.symbol(i, position))
                })
            });
            layers[step - 1] = here;
        }
        Ok(layers)
    }

    /// Equations (12) to (16): the belief after a step.
    fn update(
        &mut self,
        i: usize,
        step: usize,
        before: &Of<StateId>,
        symbols: &Of<Symbol>,
        believed: &BTreeSet<StateId>,
    ) -> Result<Of<StateId>, LimitReached> {
        let mut b = BTreeMap::new();
        for &state in believed {
            let name = Name::new("b", [i, state.index(), step]);
            b.insert(state, self.binary(name));
        }
        let mut into: BTreeMap<StateId, Vec<Variable>> = BTreeMap::new();
        for (&from, &was) in before {
            for position in self.joint.states().edge_range(from) {
                let edge = self.joint.states().all_edges()[position];
                // Correction 2: the symbol of (a, Γ(s, a)).
                let symbol = self.joint.symbol(i, position);
                let (Some(&seen), Some(&then)) = (symbols.get(&symbol), b.get(&edge.target)) else {
                    continue;
                };
                let numbers = [i, from.index(), edge.action.index(), step];
                let h = self.binary(Name::new("h", numbers));
                into.entry(edge.target).or_default().push(h);
                let mut row = |equation, terms: Vec<(Variable, f64)>, right| {
                    self.model.row(Name::new(equation, numbers), terms, Comparison::AtMost, right);
                };
                row("eq12", vec![(was, 1.0), (seen, 1.0), (h, -1.0)], 1.0);
                row("eq13", vec![(h, 1.0), (was, -1.0)], 0.0);
                row("eq14", vec![(h, 1.0), (then, -1.0)], 0.0);
                row("eq15", vec![(h, 1.0), (seen, -1.0)], 0.0);
            }
            self.model.check(self.joint.limits())?;
        }
        for (&state, &then) in &b {
            let mut terms = each(into.remove(&state).unwrap_or_default(), -1.0);
            terms.push((then, 1.0));
            let name = Name::new("eq16", [i, state.index(), step]);
            self.model.row(name, terms, Comparison::AtMost, 0.0);
            if let Some(&there) = self.y[step].get(&state) {
                let terms = vec![(there, 1.0), (then, -1.0)];
                let name = Name::new("true_state", [i, state.index(), step]);
                self.model.row(name, terms, Comparison::AtMost, 0.0);
            }
        }
        Ok(b)
    }

    /// Equation (7) with its correction, and the goal constraints of the paper.
    fn survivors(
        &mut self,
        i: usize,
        b: &Of<StateId>,
    ) -> Result<Vec<(Variable, f64)>, LimitReached> {
        let goals = self.joint.problem().goals().len();
        let mut g = Vec::new();
        for goal in 0..goals {
            let survives = self.binary(Name::new("g", [i, goal]));
            g.push(survives);
            let mut states = Vec::new();
            for (&state, &believed) in b {
                if self.joint.goals_of_state(state).contains(goal) {
                    states.push((believed, -1.0));
                    let terms = vec![(believed, 1.0), (survives, -1.0)];
                    let name = Name::new("eq7", [i, goal, state.index()]);
                    self.model.row(name, terms, Comparison::AtMost, 0.0);
                }
            }
            // Correction 1.
            states.push((survives, 1.0));
            let name = Name::new("survives", [i, goal]);
            self.model.row(name, states, Comparison::AtMost, 0.0);
        }
        let here = |watched: &&crate::solver::Watched| watched.observer == i;
        let forced = self.bounds.required.iter().filter(here).map(|w| (w.goal, 1.0));
        let ruled_out = self.bounds.forbidden.iter().filter(here).map(|w| (w.goal, 0.0));
        for (number, (goal, value)) in forced.chain(ruled_out).enumerate() {
            let name = Name::new("goal", [i, number]);
            self.model.row(name, vec![(g[goal], 1.0)], Comparison::Equal, value);
        }
        let (bound, comparison) = match self.joint.problem().observers()[i].role {
            Role::Adversarial => (self.bounds.at_least, Comparison::AtLeast),
            Role::Cooperative => (self.bounds.at_most, Comparison::AtMost),
        };
        if let Some(bound) = bound {
            let terms = each(g.iter().copied(), 1.0);
            self.model.row(Name::new("survivors", [i]), terms, comparison, bound as f64);
        }
        self.model.check(self.joint.limits())?;
        Ok(each(g, 1.0))
    }
}
