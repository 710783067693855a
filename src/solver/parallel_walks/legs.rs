//! Legs: walks of the actor from a state to a goal, by greedy best-first search.

use std::collections::{BTreeMap, VecDeque};

use rustc_hash::FxHashMap;

use super::estimates::GoalEstimates;
use crate::heuristic::UNREACHABLE;
use crate::problem::JointSpace;
use crate::task::StateId;

/// States expanded for a leg, at most: some seconds. A task that takes more is one for the classical planners.
const MOST_EXPANSIONS: usize = 150_000;

/// Expansions without a smaller value after which the newest of equal states takes every second turn.
const PATIENCE: usize = 1_000;

/// The transitions of a walk from a state to one in which a goal holds; none where none was found.
pub(super) fn leg(
    joint: &mut JointSpace,
    estimates: &mut GoalEstimates,
    from: StateId,
    goal: usize,
) -> Option<Vec<usize>> {
    let mut open: BTreeMap<u32, VecDeque<StateId>> = BTreeMap::new();
    // The transition that led to a state, and the state before.
    let mut met: FxHashMap<StateId, Option<(usize, StateId)>> = FxHashMap::default();
    let value = estimates.of_state(joint, from, goal);
    met.insert(from, None);
    open.entry(value).or_default().push_back(from);
    let mut least = (value, 0);
    let mut end = (value == 0).then_some(from);
    for expansions in 0..MOST_EXPANSIONS {
        if end.is_some() {
            break;
        }
        let mut first = open.first_entry()?;
        let value = *first.key();
        if value == UNREACHABLE {
            return None;
        }
        if value < least.0 {
            least = (value, expansions);
        }
        let newest = expansions - least.1 >= PATIENCE && expansions % 2 == 1;
        let states = first.get_mut();
        let state = if newest { states.pop_back() } else { states.pop_front() };
        if states.is_empty() {
            first.remove();
        }
        let state = state?;
        joint.states_mut().expand(state);
        for edge in joint.states().edge_range(state) {
            let target = joint.states().all_edges()[edge].target;
            if met.contains_key(&target) {
                continue;
            }
            met.insert(target, Some((edge, state)));
            let value = estimates.of_state(joint, target, goal);
            if value == 0 {
                end = Some(target);
                break;
            }
            open.entry(value).or_default().push_back(target);
        }
    }
    let mut edges = Vec::new();
    let mut at = end?;
    while let Some((edge, before)) = met[&at] {
        edges.push(edge);
        at = before;
    }
    edges.reverse();
    Some(edges)
}
