//! Greedy completion: a plan for a search that is stopped before it has met one.

use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::{JointSpace, Node};
use crate::solver::ground::thresholds::STATES_OF_A_COMPLETION;
use crate::task::StateId;

use super::dead_ends::TrueGoalDistances;
use super::final_beliefs::allowed;
use crate::solver::Bounds;
use crate::solver::outcome::ReachablePair;

/// Goes on from the node at the end of `plan` for `left` actions, each the first one into a state
/// that `leads` wants, given how many actions are then left. None where the plan so found misses the true goal or breaks
/// the bounds, where there is no such state, or where `room` for believed states does not last.
///
/// # Errors
///
/// The memory limit.
pub(in crate::solver) fn complete(
    joint: &mut JointSpace,
    bounds: &Bounds,
    (mut node, mut plan): (Node, Plan),
    left: usize,
    leads: impl Fn(usize, StateId) -> bool,
    room: &mut usize,
) -> Result<Option<ReachablePair>, LimitReached> {
    let mut found = Vec::new();
    for left in (0..left).rev() {
        joint.states_mut().expand(node.state);
        let mut edges = joint.states().edges(node.state).iter();
        let first = edges.find(|edge| leads(left, edge.target));
        let Some(target) = first.map(|edge| edge.target) else { return Ok(None) };
        for observer in 0..joint.problem().observers().len() {
            let belief = joint.belief(node.profile, observer);
            *room = room.saturating_sub(joint.beliefs(observer).list(belief).len());
        }
        if *room == 0 {
            return Ok(None);
        }
        joint.expand(node, |state| state == target, &mut found)?;
        let Some(&(action, next)) = found.first() else { return Ok(None) };
        plan.actions.push(action);
        node = next;
    }
    // Where distances are not known, what seemed to lead there may not have.
    if !joint.is_goal(node.state) {
        return Ok(None);
    }
    let counts = joint.counts(node.profile);
    let fits = allowed(joint, bounds, node.profile, counts);
    Ok(fits.then_some(ReachablePair { counts, plan }))
}

/// A shortest plan for the true goal, where it keeps the bounds and memory lasts.
pub(in crate::solver) fn shortest(
    joint: &mut JointSpace,
    distances: &TrueGoalDistances,
    bounds: &Bounds,
) -> Option<ReachablePair> {
    let root = joint.initial();
    // Where distances are not known, all are 0.
    let left = distances.distance(root.state)?;
    let leads = |left, state| distances.distance(state) == Some(left);
    let from = (root, Plan::default());
    let point =
        complete(joint, bounds, from, left, leads, &mut { STATES_OF_A_COMPLETION }).ok()??;
    Some(point)
}
