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
//! | `h^i_{s,o,t}` | `i` holds `s` possible after step `t−1` and then sees `o`: the product `b^i_{s,t−1} · w^i_{o,t}` |
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
//! and so on), which is tighter than bounding each by its factors. The paper's `h^i_{s,a,t}` is such
//! a product as well: (12), (13) and (15) say that it is `b^i_{s,t−1} · w^i_{o,t}` for the symbol `o`
//! of `(a, Γ(s, a))`, so all actions with one symbol in a state share one variable, and
//! `Σ_o h^i_{s,o,t} = b^i_{s,t−1}` stands for (12) and (13). (7) is written for each state on its
//! own, which implies the printed sum; and the true state is believed (`y_{s,t} ≤ b^i_{s,t}`), as
//! the proof of the paper's first proposition says.

use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;

use super::Encoded;
use super::model::{Comparison, Kind, Model, Name, Variable};
use super::objective::maximise_difference;
use crate::limits::LimitReached;
use crate::problem::{JointSpace, Role};
use crate::solver::ground::dead_ends::StatesBySteps;
use crate::solver::{Bounds, Stats, Watched};
use crate::task::{Action, StateId};

/// What a variable or a row of a step is about: one number or two, by their positions.
type Key = (u32, u32);

/// Variables or rows of a step, in the order in which they were first needed.
type Of<T> = IndexMap<Key, T, FxBuildHasher>;

fn one(index: usize) -> Key {
    (index as u32, 0)
}

fn two(first: usize, second: usize) -> Key {
    (first as u32, second as u32)
}

/// A possible transition of the actor at a step; the position of its edge in the state space.
#[derive(Debug, Clone, Copy)]
struct Transition {
    from: StateId,
    action: Action,
    to: StateId,
    edge: usize,
}

struct Writer<'a> {
    joint: &'a mut JointSpace,
    bounds: &'a Bounds,
    model: Model,
    horizon: usize,
    transitions: Vec<Vec<Transition>>,
    y: Vec<Of<Variable>>,
    x: Vec<Of<Variable>>,
}

/// Writes the model; none when the actor has no plan of this length.
///
/// # Errors
///
/// The memory limit, or the limit on the size of a model.
pub(super) fn encode(
    joint: &mut JointSpace,
    bounds: &Bounds,
    horizon: usize,
) -> Result<Option<Encoded>, LimitReached> {
    let live = StatesBySteps::new(joint, horizon)?;
    let start = joint.initial().state;
    if !live.contains(0, start) {
        return Ok(None);
    }
    let mut transitions = Vec::new();
    let mut layer = vec![start];
    for step in 1..=horizon {
        let mut here = Vec::new();
        for &from in &layer {
            joint.states_mut().expand(from);
            for edge in joint.states().edge_range(from) {
                let taken = joint.states().all_edges()[edge];
                if live.contains(step, taken.target) {
                    here.push(Transition { from, action: taken.action, to: taken.target, edge });
                }
            }
        }
        layer = distinct(here.iter().map(|transition| transition.to));
        transitions.push(here);
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
    let choice = |(&(action, _), &v): (&Key, &Variable)| (Action::new(action as usize), vec![v]);
    let choices = x.iter().map(|of| of.iter().map(choice).collect()).collect();
    Ok(Some(Encoded { model, choices, spaces: Stats::default() }))
}

/// States in order, each once.
fn distinct(states: impl Iterator<Item = StateId>) -> Vec<StateId> {
    let mut states: Vec<StateId> = states.collect();
    states.sort_unstable();
    states.dedup();
    states
}

/// Rows under construction: the terms of each, and the variables already in it.
#[derive(Debug, Default)]
struct Rows {
    terms: Of<Vec<(Variable, f64)>>,
}

impl Rows {
    fn add(&mut self, row: Key, variable: Variable, coefficient: f64) {
        self.terms.entry(row).or_default().push((variable, coefficient));
    }

    /// Writes the rows; a variable that several transitions put into a row counts once.
    fn write(
        self,
        model: &mut Model,
        name: impl Fn(Key) -> Name,
        comparison: Comparison,
        right: f64,
    ) {
        for (key, mut terms) in self.terms {
            terms.sort_unstable_by_key(|(variable, _)| *variable);
            terms.dedup_by_key(|(variable, _)| *variable);
            model.row(name(key), terms, comparison, right);
        }
    }
}

impl Writer<'_> {
    fn binary(&mut self, name: Name) -> Variable {
        self.model.add(name, Kind::Binary)
    }

    /// Equations (3), (8) to (10) and (17).
    fn actor(&mut self) -> Result<(), LimitReached> {
        self.model.note("the paper's encoding: x_a_t action, y_s_t state, w_i_o_t symbol,");
        self.model
            .note("b_i_s_t believed state, h_i_s_o_t believed before symbol o, g_i_G survivor,");
        self.model.note("p and q products of binaries; row c14 is of equation (14), and so on");
        let start = self.joint.initial().state;
        // (3): the initial state; a state with the true goal in the end is all that is live.
        let first = self.binary(Name::new("y", [start.index(), 0]));
        self.model.fix(first, 1.0);
        self.y.push(Of::from_iter([(one(start.index()), first)]));
        for step in 1..=self.horizon {
            let transitions = std::mem::take(&mut self.transitions[step - 1]);
            self.actor_step(step, &transitions);
            self.transitions[step - 1] = transitions;
            self.model.check(self.joint.limits())?;
        }
        Ok(())
    }

    fn actor_step(&mut self, step: usize, transitions: &[Transition]) {
        let (mut x, mut y) = (Of::default(), Of::default());
        let mut p: Of<Variable> = Of::default();
        for t in transitions {
            let (from, action, to) = (t.from.index(), t.action.index(), t.to.index());
            y.entry(one(to)).or_insert_with(|| self.binary(Name::new("y", [to, step])));
            x.entry(one(action)).or_insert_with(|| self.binary(Name::new("x", [action, step])));
            p.entry(two(from, to)).or_insert_with(|| self.binary(Name::new("p", [from, to, step])));
        }
        let [mut eq8, mut eq9, mut eq10] = [Rows::default(), Rows::default(), Rows::default()];
        let [mut p_from, mut p_to, mut p_by] = [Rows::default(), Rows::default(), Rows::default()];
        for t in transitions {
            let (from, to) = (one(t.from.index()), one(t.to.index()));
            let (action, change) = (one(t.action.index()), two(t.from.index(), t.to.index()));
            let was = self.y[step - 1][&from];
            let (there, taken, product) = (y[&to], x[&action], p[&change]);
            eq8.add(action, taken, 1.0);
            eq8.add(action, was, -1.0);
            eq9.add(to, taken, 1.0);
            eq9.add(to, was, 1.0);
            eq9.add(to, there, -2.0);
            eq10.add(action, taken, 1.0);
            eq10.add(action, product, -1.0);
            // The products of (10), by their sums.
            p_from.add(from, product, 1.0);
            p_from.add(from, was, -1.0);
            p_to.add(to, product, 1.0);
            p_to.add(to, there, -1.0);
            // A change of state takes one of the actions that bring it about.
            p_by.add(change, product, 1.0);
            p_by.add(change, taken, -1.0);
        }
        let model = &mut self.model;
        let all = |of: &Of<Variable>| of.values().map(|&variable| (variable, 1.0)).collect();
        model.row(Name::new("one_state", [step]), all(&y), Comparison::Equal, 1.0);
        // (17), as an equality since a plan has exactly T actions.
        model.row(Name::new("c17", [step]), all(&x), Comparison::Equal, 1.0);
        let name = |letter| move |key: Key| Name::new(letter, [key.0 as usize, step]);
        eq8.write(model, name("c8"), Comparison::AtMost, 0.0);
        eq9.write(model, name("c9"), Comparison::AtLeast, 0.0);
        eq10.write(model, name("c10"), Comparison::AtMost, 0.0);
        p_from.write(model, name("p_from"), Comparison::Equal, 0.0);
        p_to.write(model, name("p_to"), Comparison::Equal, 0.0);
        let change = |key: Key| Name::new("p_by", [key.0 as usize, key.1 as usize, step]);
        p_by.write(model, change, Comparison::AtMost, 0.0);
        self.y.push(y);
        self.x.push(x);
    }

    /// Equations (6), (7) and (11) to (16) for one observer, and the goal constraints; returns the
    /// expression of how many goals survive.
    fn observer(&mut self, i: usize) -> Result<Vec<(Variable, f64)>, LimitReached> {
        let symbols: Vec<Of<Variable>> =
            (1..=self.horizon).map(|step| self.symbols(i, step)).collect();
        let believed = self.believable(i, &symbols)?;
        let mut b = Of::default();
        for state in &believed[0] {
            // (6): the initial belief.
            let variable = self.binary(Name::new("b", [i, state.index(), 0]));
            self.model.fix(variable, 1.0);
            b.insert(one(state.index()), variable);
        }
        for step in 1..=self.horizon {
            b = self.update(i, step, &b, &symbols[step - 1], &believed[step]);
            self.model.check(self.joint.limits())?;
        }
        Ok(self.survivors(i, &b))
    }

    /// The symbols of a step, with their variables: equation (11).
    fn symbols(&mut self, i: usize, step: usize) -> Of<Variable> {
        let transitions = std::mem::take(&mut self.transitions[step - 1]);
        let mut w = Of::default();
        let [mut eq11, mut q_by, mut q_to] = [Rows::default(), Rows::default(), Rows::default()];
        let mut q: Of<Variable> = Of::default();
        for t in &transitions {
            let (action, to) = (t.action.index(), t.to.index());
            let symbol = self.joint.symbol(i, t.edge).index();
            let product = *q
                .entry(two(action, to))
                .or_insert_with(|| self.binary(Name::new("q", [i, action, to, step])));
            let seen = *w
                .entry(one(symbol))
                .or_insert_with(|| self.binary(Name::new("w", [i, symbol, step])));
            eq11.add(one(symbol), product, 1.0);
            eq11.add(one(symbol), seen, -1.0);
            // The products of (11), by their sums.
            q_by.add(one(action), product, 1.0);
            q_by.add(one(action), self.x[step - 1][&one(action)], -1.0);
            q_to.add(one(to), product, 1.0);
            q_to.add(one(to), self.y[step][&one(to)], -1.0);
        }
        let name = |letter| move |key: Key| Name::new(letter, [i, key.0 as usize, step]);
        eq11.write(&mut self.model, name("c11"), Comparison::Equal, 0.0);
        q_by.write(&mut self.model, name("q_by"), Comparison::Equal, 0.0);
        q_to.write(&mut self.model, name("q_to"), Comparison::Equal, 0.0);
        self.transitions[step - 1] = transitions;
        w
    }

    /// The states that can be believed after each step and can still lead to a candidate goal.
    fn believable(
        &mut self,
        i: usize,
        symbols: &[Of<Variable>],
    ) -> Result<Vec<Vec<StateId>>, LimitReached> {
        let profile = self.joint.initial().profile;
        let belief = self.joint.belief(profile, i);
        let mut layers = vec![self.joint.beliefs(i).list(belief).to_vec()];
        for symbols in symbols {
            let mut next = Vec::new();
            for &state in layers.last().into_iter().flatten() {
                self.joint.states_mut().expand(state);
                for edge in self.joint.states().edge_range(state) {
                    if symbols.contains_key(&one(self.joint.symbol(i, edge).index())) {
                        next.push(self.joint.states().all_edges()[edge].target);
                    }
                }
            }
            self.joint.limits().check_bytes(self.joint.bytes())?;
            layers.push(distinct(next.into_iter()));
        }
        layers[self.horizon].retain(|&state| !self.joint.goals_of_state(state).is_empty());
        for step in (0..self.horizon).rev() {
            let (before, after) = layers.split_at_mut(step + 1);
            before[step].retain(|&state| {
                self.joint.states().edge_range(state).any(|edge| {
                    let target = self.joint.states().all_edges()[edge].target;
                    after[0].binary_search(&target).is_ok()
                        && symbols[step].contains_key(&one(self.joint.symbol(i, edge).index()))
                })
            });
        }
        Ok(layers)
    }

    /// Equations (12) to (16): the belief after a step.
    fn update(
        &mut self,
        i: usize,
        step: usize,
        before: &Of<Variable>,
        symbols: &Of<Variable>,
        believed: &[StateId],
    ) -> Of<Variable> {
        let mut b = Of::default();
        let mut eq16 = Rows::default();
        for state in believed {
            let then = self.binary(Name::new("b", [i, state.index(), step]));
            eq16.add(one(state.index()), then, 1.0);
            b.insert(one(state.index()), then);
        }
        let name = |letter| move |key: Key| Name::new(letter, [i, key.0 as usize, step]);
        let pair =
            |letter| move |key: Key| Name::new(letter, [i, key.0 as usize, key.1 as usize, step]);
        let mut eq14 = Rows::default();
        let mut eq15 = Rows::default();
        let mut sums = Rows::default();
        for (&from, &was) in before {
            let mut h: Of<Variable> = Of::default();
            for (&symbol, &seen) in symbols {
                let key = (from.0, symbol.0);
                let product = self.binary(pair("h")(key));
                h.insert(symbol, product);
                eq15.add(key, product, 1.0);
                eq15.add(key, seen, -1.0);
                // (12) and (13), by the sum of the products.
                sums.add(from, product, 1.0);
                sums.add(from, was, -1.0);
            }
            for position in self.joint.states().edge_range(StateId(from.0)) {
                let to = self.joint.states().all_edges()[position].target;
                // Correction 2: the symbol of (a, Γ(s, a)).
                let symbol = one(self.joint.symbol(i, position).index());
                if let (Some(&product), Some(&then)) = (h.get(&symbol), b.get(&one(to.index()))) {
                    let key = (eq14.terms.len() as u32, 0);
                    eq14.add(key, product, 1.0);
                    eq14.add(key, then, -1.0);
                    eq16.add(one(to.index()), product, -1.0);
                }
            }
        }
        sums.write(&mut self.model, name("c13"), Comparison::Equal, 0.0);
        eq14.write(&mut self.model, name("c14"), Comparison::AtMost, 0.0);
        eq15.write(&mut self.model, pair("c15"), Comparison::AtMost, 0.0);
        eq16.write(&mut self.model, name("c16"), Comparison::AtMost, 0.0);
        for (&state, &then) in &b {
            if let Some(&there) = self.y[step].get(&state) {
                let terms = vec![(there, 1.0), (then, -1.0)];
                self.model.row(name("true_state")(state), terms, Comparison::AtMost, 0.0);
            }
        }
        b
    }

    /// Equation (7) with its correction, and the goal constraints of the paper.
    fn survivors(&mut self, i: usize, b: &Of<Variable>) -> Vec<(Variable, f64)> {
        let goals = self.joint.problem().goals().len();
        let mut g = Vec::new();
        for goal in 0..goals {
            let survives = self.binary(Name::new("g", [i, goal]));
            // Correction 1.
            let mut states = vec![(survives, 1.0)];
            for (&state, &believed) in b {
                if self.joint.goals_of_state(StateId(state.0)).contains(goal) {
                    states.push((believed, -1.0));
                    let terms = vec![(believed, 1.0), (survives, -1.0)];
                    let name = Name::new("c7", [i, goal, state.0 as usize]);
                    self.model.row(name, terms, Comparison::AtMost, 0.0);
                }
            }
            let name = Name::new("survives", [i, goal]);
            self.model.row(name, states, Comparison::AtMost, 0.0);
            g.push((survives, 1.0));
        }
        let here = |watched: &&Watched| watched.observer == i;
        let forced = self.bounds.required.iter().filter(here).map(|w| (w.goal, 1.0));
        let ruled_out = self.bounds.forbidden.iter().filter(here).map(|w| (w.goal, 0.0));
        for (number, (goal, value)) in forced.chain(ruled_out).enumerate() {
            let name = Name::new("goal", [i, number]);
            self.model.row(name, vec![g[goal]], Comparison::Equal, value);
        }
        let (bound, comparison) = match self.joint.problem().observers()[i].role {
            Role::Adversarial => (self.bounds.at_least, Comparison::AtLeast),
            Role::Cooperative => (self.bounds.at_most, Comparison::AtMost),
        };
        if let Some(bound) = bound {
            let name = Name::new("survivors", [i]);
            self.model.row(name, g.clone(), comparison, bound as f64);
        }
        g
    }
}
