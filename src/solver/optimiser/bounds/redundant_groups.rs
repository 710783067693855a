//! Redundant groups: those that linear invariants can do without.
//!
//! Such a group follows from others, as a place is occupied that something stands on. Where its facts have no weight, each observer
//! knows as many sums that can change as before, and there are fewer sums to tell apart.

use super::elimination::Weights;
use super::invariants::{Facts, Invariants};
use crate::problem::Problem;
use crate::solver::ground::thresholds::WORK_OF_REDUNDANCY;

/// Groups are left out on trial.
struct Trial<'a> {
    problem: &'a Problem,
    facts: &'a Facts<'a>,
    /// How much is known where nothing is left out.
    all: Option<Vec<[usize; 2]>>,
    /// Multiplications of all eliminations.
    work: u64,
}

impl Trial<'_> {
    /// By enemy: how many sums it knows of those that can change, over each field.
    fn informative(&mut self, left_out: &[bool]) -> Option<Vec<[usize; 2]>> {
        let unchanging = self.facts.unchanging(left_out)?;
        let known = Invariants::known(self.problem, self.facts, left_out)?;
        self.work += unchanging.work + known.iter().map(|known| known.work).sum::<u64>();
        let more = |known: &Weights| {
            [0, 1].map(|field| unchanging.ranks[field].saturating_sub(known.ranks[field]))
        };
        Some(known.iter().map(more).collect())
    }

    /// Leaves out those of some groups that may be, half of them at a time: where all can be each of them can.
    fn leave_out(&mut self, groups: &[usize], left_out: &mut [bool]) {
        if groups.is_empty() || self.work > WORK_OF_REDUNDANCY {
            return;
        }
        let before = left_out.to_vec();
        for group in groups {
            for fact in self.facts.task.layout().facts_of_group(*group) {
                left_out[fact.index()] = true;
            }
        }
        if self.informative(left_out) == self.all {
            return;
        }
        left_out.copy_from_slice(&before);
        if groups.len() > 1 {
            let (first, second) = groups.split_at(groups.len() / 2);
            self.leave_out(first, left_out);
            self.leave_out(second, left_out);
        }
    }
}

/// Leaves out the facts of redundant groups, the smallest groups first; none where the elimination takes too long.
pub(super) fn leave_out(problem: &Problem, facts: &Facts<'_>, left_out: &mut [bool]) -> Option<()> {
    let mut trial = Trial { problem, facts, all: None, work: 0 };
    trial.all = Some(trial.informative(left_out)?);
    let mut groups: Vec<usize> = (0..facts.values.len()).collect();
    groups.sort_by_key(|&group| facts.values[group].len());
    trial.leave_out(&groups, left_out);
    Some(())
}
