//! Walks that are drawn for variants.

use std::sync::Arc;

use rand::{Rng, RngExt};

use super::belief_layers::MAX_STATES;
use super::dice::below;
use crate::problem::Problem;
use crate::task::{Edge, Fact, StateId, StateSpace};

/// A walk of `steps` steps. Every second one ends in a candidate goal, where a walk of this length can: of the others few do
/// where goals take more than going somewhere.
pub(super) fn walk_of(
    problem: &Problem,
    steps: usize,
    random: &mut impl Rng,
) -> Option<Vec<String>> {
    if random.random_range(0..2_u32) == 0 {
        let goal = below(random, problem.goals().len())?;
        if let Some(walk) = walk_into(problem, goal, steps, random) {
            return Some(walk);
        }
    }
    random_walk(problem, steps, random)
}

/// A walk of `steps` steps that goes straight back only where nothing else is possible.
fn random_walk(problem: &Problem, steps: usize, random: &mut impl Rng) -> Option<Vec<String>> {
    let task = problem.task();
    let mut space = StateSpace::new(Arc::clone(task));
    let mut at = space.intern(task.initial_state());
    let mut before = at;
    let mut names = Vec::with_capacity(steps);
    for _ in 0..steps {
        space.expand(at);
        let edge = drawn(space.edges(at).iter(), before, random)?;
        names.push(task.action_name(edge.action).to_owned());
        (before, at) = (at, edge.target);
    }
    Some(names)
}

/// A walk of `steps` steps that ends in a goal: each step leads to where the goal stays in reach.
fn walk_into(
    problem: &Problem,
    goal: usize,
    steps: usize,
    random: &mut impl Rng,
) -> Option<Vec<String>> {
    let task = problem.task();
    let space = explored(problem)?;
    let distances = goal_distances(&space, &problem.goals()[goal].condition);
    let mut at = StateId(0);
    let mut before = at;
    let mut names = Vec::with_capacity(steps);
    for left in (0..steps).rev() {
        let in_reach = |target: StateId| distances[target.index()].is_some_and(|far| far <= left);
        let edges = space.edges(at).iter().filter(|edge| in_reach(edge.target));
        let edge = drawn(edges, before, random)?;
        names.push(task.action_name(edge.action).to_owned());
        (before, at) = (at, edge.target);
    }
    Some(names)
}

/// One of some transitions; one that leads straight back only where all do.
fn drawn<'e>(
    edges: impl Iterator<Item = &'e Edge>,
    before: StateId,
    random: &mut impl Rng,
) -> Option<&'e Edge> {
    let edges: Vec<&Edge> = edges.collect();
    let onward: Vec<&Edge> = edges.iter().copied().filter(|edge| edge.target != before).collect();
    let edges = if onward.is_empty() { edges } else { onward };
    Some(edges[below(random, edges.len())?])
}

/// A walk to the true goal: up to two steps anywhere, then a shortest one.
pub(super) fn walk_to_goal(problem: &Problem, random: &mut impl Rng) -> Option<Vec<String>> {
    let task = problem.task();
    let space = explored(problem)?;
    let distances = goal_distances(&space, task.goal());
    let mut at = StateId(0);
    let mut names = Vec::new();
    let aside = random.random_range(0..3_u32);
    while names.len() < MAX_STATES {
        let here = distances[at.index()]?;
        let wandering = (names.len() as u32) < aside;
        if here == 0 && !wandering {
            return Some(names);
        }
        let nearer = |target: StateId| distances[target.index()] == here.checked_sub(1);
        let edges: Vec<_> =
            space.edges(at).iter().filter(|edge| wandering || nearer(edge.target)).collect();
        let edge = edges[below(random, edges.len())?];
        names.push(task.action_name(edge.action).to_owned());
        at = edge.target;
    }
    None
}

/// All states that walks lead to, each with what follows it; none where they are too many.
pub(super) fn explored(problem: &Problem) -> Option<StateSpace> {
    let task = problem.task();
    let mut space = StateSpace::new(Arc::clone(task));
    let mut next = Some(space.intern(task.initial_state()));
    while let Some(state) = next {
        space.expand(state);
        if space.len() > MAX_STATES {
            return None;
        }
        next = space.after(state);
    }
    Some(space)
}

/// The steps from each state to a goal, in a space that is expanded in full.
fn goal_distances(space: &StateSpace, goal: &[Fact]) -> Vec<Option<usize>> {
    let task = space.task();
    let mut before: Vec<Vec<usize>> = vec![Vec::new(); space.len()];
    let mut distances = vec![None; space.len()];
    let mut queue = Vec::new();
    for (index, distance) in distances.iter_mut().enumerate() {
        let state = StateId(index as u32);
        for edge in space.edges(state) {
            before[edge.target.index()].push(index);
        }
        if task.satisfies(space.words(state), goal) {
            *distance = Some(0);
            queue.push(index);
        }
    }
    let mut done = 0;
    while let Some(&state) = queue.get(done) {
        done += 1;
        let next = distances[state].map(|steps| steps + 1);
        for &earlier in &before[state] {
            if distances[earlier].is_none() {
                distances[earlier] = next;
                queue.push(earlier);
            }
        }
    }
    distances
}
