//! Upper bounds on all plans: each a part of its own, behind one trait.
//!
//! A bound says what no plan that keeps what is asked can pass, `|G_X| − |G_C|` at the most, or that
//! there is no such plan at all. A new bound is a new file that implements [`Bound`], and a place in
//! [`all`].
//!
//! | bound | says | takes |
//! |---|---|---|
//! | [`trivial`] | every goal survives for the enemies, the true one alone for the friends | nothing |
//! | [`invariants`] | what linear invariants over facts leave possible | elimination over facts; lists no state |
//! | [`classes`] | what observable classes and blocks always believed together leave possible | a pass over all states |
//! | [`pairs`] | what pairs of states, looked at alone, leave possible | tables over pairs of states |

pub(super) mod classes;
mod elimination;
pub(super) mod invariants;
mod known_values;
pub(super) mod listing;
mod matrix;
mod mutual_exclusion;
mod pair_tables;
pub(super) mod pairs;
mod redundant_groups;
mod triple_exclusion;
pub(super) mod trivial;

use std::sync::Arc;

use super::space::Space;
use crate::limits::LimitReached;
use crate::problem::{JointSpace, Problem};
use crate::solver::Options;
use crate::solver::ground::thresholds::STATES_OF_CLASSES;

/// What a bound says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Most {
    /// No plan is worth more than this `|G_X| − |G_C|`.
    Value(i64),
    /// No plan keeps what is asked.
    Infeasible,
    /// Nothing: the bound would take more than it may.
    Unaffordable,
}

/// An upper bound on all plans from the initial state.
pub(super) trait Bound {
    /// The name in reports.
    fn name(&self) -> &'static str;

    /// What it says of a problem.
    ///
    /// # Errors
    ///
    /// The memory limit.
    fn most(&mut self, space: &mut Space) -> Result<Most, LimitReached>;
}

/// What one of the bounds says of a problem, for [`upper_bounds`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum UpperBound {
    /// No plan has a greater goal difference.
    AtMost(f64),
    /// No plan keeps what is asked.
    Infeasible,
    /// Nothing: it would take too much memory or time for this problem.
    Unaffordable,
}

/// What each upper bound of the exact solver says of the plans of all lengths that keep the bounds
/// asked for, with the bound's name. The least of them is what the solver stops at.
///
/// # Errors
///
/// The memory limit.
///
/// ```
/// use std::sync::Arc;
/// use mo_copp::{domain::Delivery, solver::{upper_bounds, Options, Solver, UpperBound}};
/// let problem = Arc::new(Delivery::figure_1().problem()?);
/// for (name, bound) in upper_bounds(&problem, &Options::new(Solver::Exact))? {
///     // The best plan of Figure 1 has a goal difference of 1.
///     assert!(bound == UpperBound::AtMost(1.0), "{name}");
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn upper_bounds(
    problem: &Arc<Problem>,
    options: &Options,
) -> Result<Vec<(&'static str, UpperBound)>, LimitReached> {
    let most = problem.goals().len() as f64 - 1.0;
    let mut found = Vec::new();
    for mut bound in all() {
        let mut joint = JointSpace::new(Arc::clone(problem), options.limits);
        joint.initial();
        let mut space = Space::new(joint, options.heeded_bounds());
        let says = match bound.most(&mut space)? {
            Most::Value(value) => UpperBound::AtMost(value as f64 / most),
            Most::Infeasible => UpperBound::Infeasible,
            Most::Unaffordable => UpperBound::Unaffordable,
        };
        found.push((bound.name(), says));
    }
    Ok(found)
}

/// The bounds in the order in which they are asked, the cheapest first.
fn all() -> [Box<dyn Bound>; 4] {
    [
        Box::new(trivial::Trivial),
        Box::new(invariants::Invariants),
        Box::new(classes::Classes { most_states: STATES_OF_CLASSES }),
        Box::new(pairs::PairBound),
    ]
}
