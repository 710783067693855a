//! The paper's equations (3) to (17) as printed, with a switch for each correction, over every
//! state there is; written from the paper and solved directly with microlp. Slow and simple.

// The paper's names.
#![allow(clippy::many_single_char_names)]

use microlp::{ComparisonOp, OptimizationDirection, Variable};

use super::oracle::Wish;
use super::strips::Strips;
use super::table::{Table, members};

/// Which symbols `o` an equation is written for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Symbols {
    /// As printed: every one.
    All,
    /// The symbol of `(a, Γ(s, a))`.
    OfTransition,
    /// The equation is left out.
    None,
}

/// Which states an action may lead to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Post {
    /// As printed: every state that contains the add effects.
    ContainsAdds,
    /// `Γ(s, a)`.
    Successor,
}

/// The form of (10).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ten {
    /// As printed: `Σ y_{s,t−1} y_{s',t} = x_{a,t}`.
    Equality,
    /// `x_{a,t} ≤ Σ y_{s,t−1} y_{s',t}` and one state at a time.
    AtMost,
}

/// What is corrected.
#[derive(Debug, Clone, Copy)]
pub struct Form {
    /// Whether `g ≤ Σ b` stands beside (7).
    pub upper_bound_on_g: bool,
    pub symbols_of_12: Symbols,
    pub symbols_of_15: Symbols,
    pub post_of_10: Post,
    pub ten: Ten,
}

pub const CORRECTED: Form = Form {
    upper_bound_on_g: true,
    symbols_of_12: Symbols::OfTransition,
    symbols_of_15: Symbols::OfTransition,
    post_of_10: Post::Successor,
    ten: Ten::AtMost,
};

struct Writer<'a> {
    table: &'a Table,
    /// By action and state: whether the state contains the add effects.
    contains_adds: Vec<Vec<bool>>,
    form: Form,
    horizon: usize,
    program: microlp::Problem,
}

type Terms = Vec<(Variable, f64)>;

fn each(variables: impl IntoIterator<Item = Variable>, factor: f64) -> Terms {
    variables.into_iter().map(|variable| (variable, factor)).collect()
}

/// The greatest `|G_X| − |G_C|` by this form; none where it is infeasible.
pub fn solve(problem: &Strips, horizon: usize, wish: &Wish, form: Form) -> Option<i64> {
    let table = problem.table();
    let states = problem.states();
    let contains = |adds| states.iter().map(|state| state & adds == adds).collect();
    let contains_adds = problem.ops.iter().map(|op| contains(op.add & !op.del)).collect();
    let program = microlp::Problem::new(OptimizationDirection::Maximize);
    let mut writer = Writer { table: &table, contains_adds, form, horizon, program };
    writer.write(wish);
    match writer.program.solve() {
        Ok(solved) => Some(solved.into_solution().unwrap().objective().round() as i64),
        Err(microlp::Error::Infeasible) => None,
        Err(error) => panic!("{error}"),
    }
}

impl Writer<'_> {
    fn binary(&mut self) -> Variable {
        self.program.add_binary_var(0.0)
    }

    /// A grid of binaries.
    fn binaries(&mut self, rows: usize, columns: usize) -> Vec<Vec<Variable>> {
        (0..rows).map(|_| (0..columns).map(|_| self.binary()).collect()).collect()
    }

    fn row(&mut self, terms: Terms, comparison: ComparisonOp, right: f64) {
        self.program.add_constraint(terms, comparison, right);
    }

    fn fix(&mut self, variable: Variable, value: bool) {
        self.row(vec![(variable, 1.0)], ComparisonOp::Eq, f64::from(u8::from(value)));
    }

    /// The product of two binaries.
    fn product(&mut self, a: Variable, b: Variable) -> Variable {
        let product = self.binary();
        self.row(vec![(product, 1.0), (a, -1.0)], ComparisonOp::Le, 0.0);
        self.row(vec![(product, 1.0), (b, -1.0)], ComparisonOp::Le, 0.0);
        self.row(vec![(product, 1.0), (a, -1.0), (b, -1.0)], ComparisonOp::Ge, -1.0);
        product
    }

    /// `pre(a) ∈ s`.
    fn applicable(&self, action: usize, state: usize) -> bool {
        self.table.next[state][action].is_some()
    }

    fn leads(&self, state: usize, action: usize, target: usize) -> bool {
        self.table.next[state][action] == Some(target)
    }

    /// `s ∈ pre_a, s' ∈ post_a` of (10).
    fn in_post(&self, state: usize, action: usize, target: usize) -> bool {
        match self.form.post_of_10 {
            Post::Successor => self.leads(state, action, target),
            Post::ContainsAdds => {
                self.applicable(action, state) && self.contains_adds[action][target]
            }
        }
    }

    fn write(&mut self, wish: &Wish) {
        let table = self.table;
        let (states, actions) = (table.states.len(), table.actions.len());
        let y = self.binaries(self.horizon + 1, states);
        let x = self.binaries(self.horizon, actions);
        // (3)
        for (state, &there) in y[0].iter().enumerate() {
            self.fix(there, state == table.start);
        }
        let ends = members(table.goals[table.true_goal]).map(|state| y[self.horizon][state]);
        self.row(each(ends, 1.0), ComparisonOp::Eq, 1.0);
        for t in 0..self.horizon {
            self.actor(&x[t], &y[t], &y[t + 1]);
        }
        for watcher in 0..table.watchers.len() {
            self.observer(watcher, &x, &y, wish);
        }
    }

    /// (8) to (10) and (17) for a step from `before` to `after`.
    fn actor(&mut self, x: &[Variable], before: &[Variable], after: &[Variable]) {
        let (states, actions) = (before.len(), x.len());
        let (all_states, all_actions) = (0..states, 0..actions);
        // (8)
        for action in all_actions.clone() {
            let sources = all_states.clone().filter(|&s| self.applicable(action, s));
            let mut terms = each(sources.map(|s| before[s]), -1.0);
            terms.push((x[action], 1.0));
            self.row(terms, ComparisonOp::Le, 0.0);
        }
        // (9)
        for target in all_states.clone() {
            let by = all_actions
                .clone()
                .filter(|&a| all_states.clone().any(|s| self.leads(s, a, target)))
                .map(|a| x[a]);
            let from = all_states
                .clone()
                .filter(|&s| all_actions.clone().any(|a| self.leads(s, a, target)))
                .map(|s| before[s]);
            let mut terms = each(by.chain(from), 1.0);
            terms.push((after[target], -2.0));
            self.row(terms, ComparisonOp::Ge, 0.0);
        }
        // (10)
        for action in all_actions.clone() {
            let mut terms = vec![(x[action], -1.0)];
            for from in all_states.clone() {
                for to in all_states.clone() {
                    if self.in_post(from, action, to) {
                        terms.push((self.product(before[from], after[to]), 1.0));
                    }
                }
            }
            let comparison = match self.form.ten {
                Ten::Equality => ComparisonOp::Eq,
                Ten::AtMost => ComparisonOp::Ge,
            };
            self.row(terms, comparison, 0.0);
        }
        if self.form.ten == Ten::AtMost {
            self.row(each(after.iter().copied(), 1.0), ComparisonOp::Eq, 1.0);
        }
        // (17)
        self.row(each(x.iter().copied(), 1.0), ComparisonOp::Le, 1.0);
    }

    fn observer(&mut self, i: usize, x: &[Vec<Variable>], y: &[Vec<Variable>], wish: &Wish) {
        let table = self.table;
        let watcher = &table.watchers[i];
        let b = self.binaries(self.horizon + 1, table.states.len());
        let w = self.binaries(self.horizon, watcher.symbols.len());
        // (6)
        for (state, &believed) in b[0].iter().enumerate() {
            self.fix(believed, watcher.belief >> state & 1 == 1);
        }
        for t in 0..self.horizon {
            // (11)
            for (symbol, &seen) in w[t].iter().enumerate() {
                let mut terms = vec![(seen, -1.0)];
                for (action, &taken) in x[t].iter().enumerate() {
                    for (target, &there) in y[t + 1].iter().enumerate() {
                        if watcher.sensor[action][target] == symbol {
                            terms.push((self.product(taken, there), 1.0));
                        }
                    }
                }
                self.row(terms, ComparisonOp::Eq, 0.0);
            }
            self.update(i, &b[t], &b[t + 1], &w[t]);
        }
        // (7)
        let mut g = Vec::new();
        for &goal in &table.goals {
            let survives = self.binary();
            g.push(survives);
            let last = &b[self.horizon];
            let believed = || members(goal).map(|state| last[state]);
            let mut terms = each(believed(), -1.0);
            terms.push((survives, f64::from(goal.count_ones() + 1)));
            self.row(terms, ComparisonOp::Ge, 0.0);
            if self.form.upper_bound_on_g {
                let mut terms = each(believed(), 1.0);
                terms.push((survives, -1.0));
                self.row(terms, ComparisonOp::Ge, 0.0);
            }
        }
        // The objective, and the goal constraints.
        let adversarial = watcher.role == mo_copp::problem::Role::Adversarial;
        let count = self.program.add_var(if adversarial { 1.0 } else { -1.0 }, (0.0, 100.0));
        let mut terms = each(g.iter().copied(), 1.0);
        terms.push((count, -1.0));
        self.row(terms, ComparisonOp::Eq, 0.0);
        let bound = if adversarial { wish.k } else { wish.j };
        if let Some(bound) = bound {
            let comparison = if adversarial { ComparisonOp::Ge } else { ComparisonOp::Le };
            self.row(vec![(count, 1.0)], comparison, bound as f64);
        }
        for (list, value) in [(&wish.required, true), (&wish.forbidden, false)] {
            for &(_, goal) in list.iter().filter(|(watcher, _)| *watcher == i) {
                self.fix(g[goal], value);
            }
        }
    }

    /// (12) to (16).
    fn update(&mut self, i: usize, before: &[Variable], after: &[Variable], w: &[Variable]) {
        let table = self.table;
        let mut into: Vec<Terms> = after.iter().map(|&then| vec![(then, -1.0)]).collect();
        for (state, row) in table.next.iter().enumerate() {
            for (action, target) in row.iter().enumerate() {
                let &Some(target) = target else { continue };
                let h = self.binary();
                into[target].push((h, 1.0));
                let own = table.watchers[i].sensor[action][target];
                let chosen = |symbols| match symbols {
                    Symbols::All => w.to_vec(),
                    Symbols::OfTransition => vec![w[own]],
                    Symbols::None => Vec::new(),
                };
                for seen in chosen(self.form.symbols_of_12) {
                    let terms = vec![(before[state], 1.0), (seen, 1.0), (h, -1.0)];
                    self.row(terms, ComparisonOp::Le, 1.0);
                }
                self.row(vec![(h, 1.0), (before[state], -1.0)], ComparisonOp::Le, 0.0);
                self.row(vec![(h, 1.0), (after[target], -1.0)], ComparisonOp::Le, 0.0);
                for seen in chosen(self.form.symbols_of_15) {
                    self.row(vec![(h, 1.0), (seen, -1.0)], ComparisonOp::Le, 0.0);
                }
            }
        }
        for terms in into {
            self.row(terms, ComparisonOp::Ge, 0.0);
        }
    }
}
