//! Routes: the goals that a plan goes through on its way to the true one.
//!
//! A longer plan leaves more walks that look the same. The direct route comes first, then those through one other goal, then
//! those through two.

/// The routes of a problem with this number of goals, each a list of goals that ends in the true one.
pub(super) fn routes(goals: usize, true_goal: usize) -> impl Iterator<Item = Vec<usize>> {
    let others = move || (0..goals).filter(move |&goal| goal != true_goal);
    let direct = std::iter::once(vec![true_goal]);
    let through_one = others().map(move |goal| vec![goal, true_goal]);
    let through_two = others().flat_map(move |one| {
        let second = (0..goals).filter(move |&two| two != one);
        second.map(move |two| vec![one, two, true_goal]).filter(move |route| route[1] != route[2])
    });
    direct.chain(through_one).chain(through_two)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_direct_one_first_then_through_one_and_two() {
        let all: Vec<Vec<usize>> = routes(3, 1).collect();
        let expected: [&[usize]; 5] = [&[1], &[0, 1], &[2, 1], &[0, 2, 1], &[2, 0, 1]];
        assert_eq!(all, expected);
    }
}
