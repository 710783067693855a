//! Search with samples of the enemies' beliefs.
//!
//! A goal that holds in a state of a sample survives in the belief, so what a plan achieves with samples it achieves at
//! least: a plan whose value meets an upper bound is proved the best although no enemy's belief was ever worked out. That
//! nothing was found proves nothing. Friends' beliefs, of which the opposite is asked, are followed as they are.

use std::sync::Arc;

use fixedbitset::FixedBitSet;

use super::estimates::Estimates;
use super::space::Space;
use crate::belief::Keep;
use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::{JointSpace, Problem, Role};
use crate::sensor::Symbol;
use crate::solver::Bounds;
use crate::solver::ground::goal_distances::{Combine, GoalDistances};
use crate::task::{StateId, StateSpace};
use crate::trace::Witness;

/// How many states of a belief are kept.
#[derive(Debug, Clone, Copy)]
pub(super) struct SampleSize {
    /// Spread over it evenly.
    pub spread: usize,
    /// Nearest to each goal.
    pub by_goal: usize,
}

/// Keeps the states nearest to each goal, and others that are spread evenly.
#[derive(Debug)]
struct Nearest {
    distances: GoalDistances,
    goals: usize,
    size: SampleSize,
}

impl Keep for Nearest {
    fn keep(&self, states: &StateSpace, found: &mut Vec<StateId>) {
        let SampleSize { spread, by_goal } = self.size;
        if found.len() <= by_goal * self.goals + spread {
            return;
        }
        let goals = self.distances.goals();
        let measured = |&state: &StateId| {
            (0..goals).map(|goal| self.distances.measured(states, state, goal)).collect()
        };
        let rows: Vec<Vec<u8>> = found.iter().map(measured).collect();
        let distance = |place: usize, goal: usize| rows[place][goal];
        let mut kept = FixedBitSet::with_capacity(found.len());
        let mut order: Vec<usize> = (0..found.len()).collect();
        for goal in 0..self.goals {
            let nearest = |&place: &usize| (distance(place, goal), place);
            order.select_nth_unstable_by_key(by_goal, nearest);
            kept.extend(order[..by_goal].iter().copied());
        }
        kept.extend((0..found.len()).step_by(found.len().div_ceil(spread)));
        let mut place = 0;
        found.retain(|_| {
            place += 1;
            kept.contains(place - 1)
        });
    }
}

/// The space with samples in place of the enemies' beliefs, and the estimates in it; none where that would be no use: no
/// enemy, or one for whom a goal must not survive.
pub(super) fn sampled(
    problem: &Arc<Problem>,
    bounds: &Bounds,
    limits: crate::limits::Limits,
    most: i64,
    size: SampleSize,
) -> Result<Option<(Space, Estimates)>, LimitReached> {
    let enemies = problem.observers().iter().enumerate();
    let enemies: Vec<usize> =
        enemies.filter(|(_, o)| o.role == Role::Adversarial).map(|(place, _)| place).collect();
    let forbidden = |w: &crate::solver::Watched| enemies.contains(&w.observer);
    if enemies.is_empty() || bounds.forbidden.iter().any(forbidden) {
        return Ok(None);
    }
    let mut joint = JointSpace::new(Arc::clone(problem), limits);
    let distances = GoalDistances::new(problem, Combine::Sum, 0);
    let keep = Arc::new(Nearest { distances, goals: problem.goals().len(), size });
    for &enemy in &enemies {
        joint.sample(enemy, Arc::clone(&keep) as Arc<dyn Keep>);
    }
    joint.initial();
    let estimates = Estimates::new(&mut joint, None, most)?;
    Ok(Some((Space::new(joint, bounds.clone()), estimates)))
}

/// For each goal that survives in an enemy's last sample on the way of a plan, a walk that shows it.
pub(super) fn witnesses(space: &mut Space, plan: &Plan) -> Vec<Witness> {
    let joint = &mut space.joint;
    let problem = Arc::clone(joint.problem());
    let root = joint.initial();
    let mut state = root.state;
    let mut edges = Vec::new();
    for &action in &plan.actions {
        joint.states_mut().expand(state);
        let taken = |edge: &usize| joint.states().all_edges()[*edge].action == action;
        let Some(edge) = joint.states().edge_range(state).find(taken) else { return Vec::new() };
        edges.push(edge);
        state = joint.states().all_edges()[edge].target;
    }
    let mut found = Vec::new();
    let enemies = problem.observers().iter().enumerate();
    for (enemy, _) in enemies.filter(|(_, observer)| observer.role == Role::Adversarial) {
        let seen: Vec<Symbol> = edges.iter().map(|&edge| joint.symbol(enemy, edge)).collect();
        let mut belief = joint.belief(root.profile, enemy);
        let mut samples = vec![joint.beliefs(enemy).list(belief).to_vec()];
        for &symbol in &seen {
            let Ok(next) = joint.update(enemy, belief, symbol) else { return found };
            belief = next;
            samples.push(joint.beliefs(enemy).list(belief).to_vec());
        }
        for goal in 0..problem.goals().len() {
            found.extend(walk_to(joint, enemy, goal, &seen, &samples));
        }
    }
    found
}

/// A walk through the samples of an enemy, after each symbol, to a state of the last one in which a goal holds.
fn walk_to(
    joint: &mut JointSpace,
    enemy: usize,
    goal: usize,
    seen: &[Symbol],
    samples: &[Vec<StateId>],
) -> Option<Witness> {
    let ends = samples.last()?.iter().copied();
    let mut at = ends.into_iter().find(|&end| joint.goals_of_state(end).contains(goal))?;
    let mut actions = Vec::with_capacity(seen.len());
    for (sample, &symbol) in samples.iter().zip(seen).rev() {
        let (before, action) = sample.iter().find_map(|&state| {
            let edge = joint.states().edge_range(state).find(|&edge| {
                joint.states().all_edges()[edge].target == at && joint.symbol(enemy, edge) == symbol
            })?;
            Some((state, joint.states().all_edges()[edge].action))
        })?;
        actions.push(action);
        at = before;
    }
    actions.reverse();
    Some(Witness { observer: enemy, goal, start: joint.states().state(at), actions })
}
