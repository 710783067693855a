//! Routes: the goals that a plan goes through on its way to the true one.
//!
//! A longer plan leaves more walks that look the same. The direct route comes first, then those through one of the nearest other
//! goals. Then there are round trips that come to the true goal, go to another one and come back, to the next one and come
//! back: what can be done only once, such as opening a door, is done by then, so a walk that went along has the time of the way
//! back to leave for a goal of its own. Each trip goes on from the one before, with which it shares all walks up to there.

use crate::solver::ground::thresholds::{FIRST_THROUGH_ONE, LONGEST_TRIP};

/// The routes to the true goal, each a list of goals that ends in it, through others in the order given.
pub(super) fn routes(
    others: &[usize],
    true_goal: usize,
) -> impl Iterator<Item = Vec<usize>> + use<> {
    let direct = std::iter::once(vec![true_goal]);
    let mut first: Vec<Vec<usize>> = others.iter().map(|goal| vec![*goal, true_goal]).collect();
    let rest = first.split_off(others.len().min(FIRST_THROUGH_ONE));
    let others = others.to_vec();
    let trips = (1..=others.len().min(LONGEST_TRIP)).map(move |size| {
        let there_and_back = others[..size].iter().flat_map(|goal| [*goal, true_goal]);
        std::iter::once(true_goal).chain(there_and_back).collect()
    });
    direct.chain(first).chain(trips).chain(rest)
}

/// The routes through two others.
pub(super) fn through_two(
    others: &[usize],
    true_goal: usize,
) -> impl Iterator<Item = Vec<usize>> + use<> {
    let others = others.to_vec();
    others.clone().into_iter().flat_map(move |one| {
        let second = others.clone().into_iter().filter(move |&two| two != one);
        second.map(move |two| vec![one, two, true_goal])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_direct_one_first_then_through_others_and_round_trips() {
        let first = routes(&[2, 0], 1);
        let all: Vec<Vec<usize>> = first.chain(through_two(&[2, 0], 1)).collect();
        let expected: [&[usize]; 7] =
            [&[1], &[2, 1], &[0, 1], &[1, 2, 1], &[1, 2, 1, 0, 1], &[2, 0, 1], &[0, 2, 1]];
        assert_eq!(all, expected);
    }
}
