//! An order of the groups of facts in which those that operators touch together are near each other.
//!
//! Decision diagrams over states need it: what is far apart has to be remembered on all levels between. Each operator draws
//! its groups to their centre, again and again, and the order with the least sum of spans is kept (FORCE: Aloul,
//! Markov and Sakallah 2003, doi:10.1145/764808.764839). The first order is that of the layout.

use super::Operator;
use super::fact::Layout;

/// A permutation of the groups, both ways.
#[derive(Debug, Clone)]
pub struct GroupOrder {
    groups: Vec<u32>,
    places: Vec<u32>,
}

/// How often the groups are drawn together; after about a logarithm of their number little changes.
const ROUNDS: usize = 60;

/// The most groups that all operators touch together, each operator counted for itself; operators beyond that do not count.
const MOST_TOUCHED: usize = 500_000;

impl GroupOrder {
    /// Linear in the groups that the operators touch.
    pub(super) fn new(layout: &Layout, operators: &[Operator]) -> Self {
        let count = layout.group_count();
        let mut touched = 0;
        let mut edges: Vec<Vec<usize>> = Vec::new();
        for operator in operators {
            let facts = operator.preconditions.iter().chain(&operator.add).chain(&operator.delete);
            let mut edge: Vec<usize> = facts.map(|fact| layout.group(*fact)).collect();
            edge.sort_unstable();
            edge.dedup();
            touched += edge.len();
            if touched > MOST_TOUCHED {
                break;
            }
            edges.push(edge);
        }
        edges.sort_unstable();
        edges.dedup();
        let mut places: Vec<u32> = (0..count as u32).collect();
        let mut best = (span(&edges, &places), places.clone());
        let mut order: Vec<usize> = (0..count).collect();
        for _ in 0..ROUNDS {
            let mut centres = vec![(0.0, 0_u32); count];
            for edge in &edges {
                let sum: f64 = edge.iter().map(|&group| f64::from(places[group])).sum();
                for &group in edge {
                    centres[group].0 += sum / edge.len() as f64;
                    centres[group].1 += 1;
                }
            }
            let wanted = |group: usize| match centres[group] {
                (_, 0) => f64::from(places[group]),
                (sum, edges) => sum / f64::from(edges),
            };
            let by_centre = |a: &usize, b: &usize| {
                wanted(*a).total_cmp(&wanted(*b)).then(places[*a].cmp(&places[*b]))
            };
            order.sort_by(by_centre);
            for (place, &group) in (0..).zip(&order) {
                places[group] = place;
            }
            let found = span(&edges, &places);
            if found < best.0 {
                best = (found, places.clone());
            }
        }
        let places = best.1;
        let mut groups = vec![0; count];
        for (group, &place) in (0..).zip(&places) {
            groups[place as usize] = group;
        }
        Self { groups, places }
    }

    /// The group at a place.
    pub(crate) fn group(&self, place: usize) -> usize {
        self.groups[place] as usize
    }

    /// The place of a group.
    pub(crate) fn place(&self, group: usize) -> usize {
        self.places[group] as usize
    }
}

/// How far the groups of each operator are apart, summed.
fn span(edges: &[Vec<usize>], places: &[u32]) -> u64 {
    let of = |edge: &Vec<usize>| {
        let places = || edge.iter().map(|&group| places[group]);
        u64::from(places().max().unwrap_or(0) - places().min().unwrap_or(0))
    };
    edges.iter().map(of).sum()
}

#[cfg(test)]
mod tests {
    use crate::common::Dice;
    use crate::common::random;
    use crate::domain::generate::Domain;
    use crate::task::Task;

    fn check(task: &Task) {
        let order = task.group_order();
        for group in 0..task.layout().group_count() {
            assert_eq!(order.group(order.place(group)), group);
        }
    }

    #[test]
    fn every_group_has_a_place() {
        let mut dice = Dice::new(16);
        for _ in 0..500 {
            check(random::strips(&mut dice).judge().problem.task());
        }
        for domain in Domain::ALL {
            check(domain.draw(1).unwrap().document.problem().unwrap().task());
        }
    }

    /// Operators that each touch two of a row of facts, which are numbered at random: neighbours end up near each other.
    #[test]
    fn a_row_is_unwound() {
        let mut dice = Dice::new(17);
        let mut numbers: Vec<usize> = (0..40).collect();
        for place in (1..numbers.len()).rev() {
            numbers.swap(place, dice.below(place + 1));
        }
        let mut builder = crate::task::TaskBuilder::default();
        let facts: Vec<_> = (0..40).map(|number| builder.fact(format!("f{number}"))).collect();
        for (name, pair) in numbers.windows(2).enumerate() {
            let (from, to) = (facts[pair[0]], facts[pair[1]]);
            builder.operator(&format!("a{name}"), &[from], &[to], &[from]);
        }
        let task = builder.build(&[facts[0]], &[facts[1]]).unwrap();
        let order = task.group_order();
        let place = |number: usize| order.place(task.layout().group(facts[number]));
        let apart = numbers.windows(2).map(|pair| place(pair[0]).abs_diff(place(pair[1])));
        let apart = apart.sum::<usize>();
        assert!(2 * apart < 39 * 41 / 3, "{apart}, at random about {}", 39 * 41 / 3);
    }
}
