//! The order in which a search takes up its nodes.
//!
//! Any order is sound: the proof is that the best value meets a bound, or that nothing is left.

use super::search::Met;
use super::space::{Actor, Space};
use crate::problem::Role;
use crate::solver::ground::thresholds::{WEIGHT_OF_THREAT, WEIGHT_OF_VALUE};

/// Steps since the value last rose + 6·(best value possible − value) + h + 2·threats.
///
/// h is the distance of the true goal from where the actor may be, and half the sum of the smallest
/// distances of other goals in an enemy's belief; threats are the goals at least as near in a
/// friend's belief as the true one. Steps count from the last rise only, so that a search that has
/// come far goes on from there.
pub(super) fn promise(space: &mut Space, actor: Actor, met: &Met, most: i64) -> Option<u32> {
    let distance = space.distance(actor, met.node)?;
    let problem = std::sync::Arc::clone(space.problem());
    let true_goal = problem.true_goal();
    let (mut ahead, mut threats) = (0_u32, 0_u32);
    let wanted = (problem.goals().len() - 1).min(most.max(0) as usize);
    for (observer, watched) in problem.observers().iter().enumerate() {
        let row = space.distances_of_belief(observer, met.node.profile);
        let others = row.iter().enumerate().filter(|(goal, _)| *goal != true_goal);
        match watched.role {
            Role::Adversarial => {
                let mut counts = [0_u32; 256];
                for (_, distance) in others {
                    counts[usize::from(*distance)] += 1;
                }
                ahead = ahead.max(sum_of_least(&counts, wanted as u32));
            }
            Role::Cooperative => {
                let near = others.filter(|(_, distance)| **distance <= row[true_goal]);
                threats = threats.max(near.count() as u32);
            }
        }
    }
    let missing = (WEIGHT_OF_VALUE * (most - met.merit).max(0)) as u32;
    Some(met.since + missing + distance + ahead / 2 + WEIGHT_OF_THREAT * threats)
}

/// The sum of the `wanted` smallest of some distances, each counted.
fn sum_of_least(counts: &[u32; 256], mut wanted: u32) -> u32 {
    let mut sum = 0;
    for (distance, count) in counts.iter().enumerate() {
        let taken = wanted.min(*count);
        sum += taken * distance as u32;
        wanted -= taken;
        if wanted == 0 {
            break;
        }
    }
    sum
}
