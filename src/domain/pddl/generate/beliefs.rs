//! Draws initial beliefs: states to which random walks from the initial state lead.

use std::sync::Arc;

use rand::{Rng, RngExt};

use super::below;
use crate::domain::pddl::{Pddl, PddlBelief, PddlObserver, PddlState};
use crate::task::{State, StateSpace, Task};

/// The longest walk: twice as long as most plans for a goal of the domains drawn here.
const LONGEST_WALK: u32 = 24;

/// Gives each observer a belief of its own: from 1 to `most` states, the initial one among them. So
/// either may begin in more doubt than the other.
pub(super) fn draw_beliefs(document: &mut Pddl, most: u32, random: &mut impl Rng) {
    // A document that was drawn makes a problem.
    let Ok(problem) = document.problem() else { return };
    let mut space = StateSpace::new(Arc::clone(problem.task()));
    let observers = &mut document.observers;
    for observer in [&mut observers.adversarial, &mut observers.cooperative] {
        let count = random.random_range(1..=most);
        draw_belief(observer, count, &mut space, random);
    }
}

/// A belief of up to `count` states: where two walks lead to one state, there are fewer.
fn draw_belief(
    observer: &mut PddlObserver,
    count: u32,
    space: &mut StateSpace,
    random: &mut impl Rng,
) {
    let task = Arc::clone(space.task());
    let start = space.intern(task.initial_state());
    let mut states = vec![start];
    for _ in 1..count {
        let mut state = start;
        for _ in 0..random.random_range(1..=LONGEST_WALK) {
            space.expand(state);
            let edges = space.edges(state);
            if !edges.is_empty() {
                state = edges[below(random, edges.len())].target;
            }
        }
        states.push(state);
    }
    states.sort_unstable();
    states.dedup();
    let changes = states.iter().map(|&state| changed(&task, space.words(state)));
    observer.initial_belief = Some(PddlBelief::States(changes.collect()));
}

/// A state as it differs from the initial one.
fn changed(task: &Task, words: &[u64]) -> PddlState {
    let missing = |of: &State, words: &[u64]| -> Vec<String> {
        let holds = |fact| task.layout().holds(words, fact);
        let facts = task.facts_of(of.words()).into_iter().filter(|&fact| !holds(fact));
        facts.map(|fact| task.fact_name(fact).to_owned()).collect()
    };
    let initial = task.initial_state();
    PddlState::Change {
        add: missing(&State::from_words(words.to_vec()), initial.words()),
        delete: missing(initial, words),
    }
}
