//! A plan for who stops an exact search before it has met one.

use super::pairs::allowed;
use crate::plan::Plan;
use crate::problem::JointSpace;
use crate::solver::Bounds;
use crate::solver::live::Live;
use crate::solver::outcome::ParetoPoint;

/// No more believed states than this are gone through: who stops does not want to wait.
const MOST_STATES: usize = 4_000_000;

/// A shortest way to the true goal, where that keeps the bounds and memory lasts.
pub(super) fn shortest_way(
    joint: &mut JointSpace,
    live: &Live,
    bounds: &Bounds,
) -> Option<ParetoPoint> {
    let mut node = joint.initial();
    let mut plan = Plan::default();
    let mut room = MOST_STATES;
    while !joint.is_goal(node.state) {
        // Where distances are not known, all are 0.
        let left = live.distance(node.state)?.checked_sub(1)?;
        for observer in 0..joint.problem().observers().len() {
            let members = joint.beliefs(observer).members(joint.belief(node.profile, observer));
            room = room.checked_sub(members.len())?;
        }
        let mut found = Vec::new();
        joint.expand(node, |state| live.distance(state) == Some(left), &mut found).ok()?;
        let &(action, next) = found.first()?;
        plan.actions.push(action);
        node = next;
    }
    let counts = joint.counts(node.profile);
    allowed(joint, bounds, node.profile, counts).then_some(ParetoPoint { counts, plan })
}
