//! Every state that any observer or the actor can come to, with the transitions by symbol.
//!
//! Only bounds and estimates that look at states one by one need this. It is made within a budget,
//! when a search has run into what the cheaper bounds leave open.

use crate::limits::LimitReached;
use crate::problem::JointSpace;
use crate::solver::ground::thresholds::STATES_BETWEEN_CHECKS;
use crate::task::StateId;

/// A transition as an observer sees it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::solver::optimiser) struct Seen {
    pub symbol: u32,
    pub from: u32,
    pub to: u32,
}

/// The states of a space, all expanded.
#[derive(Debug)]
pub(in crate::solver::optimiser) struct Listing {
    pub states: usize,
    /// By goal: the states that satisfy it.
    pub by_goal: Vec<Vec<u32>>,
    /// Which states the actor can come to.
    pub reached: Vec<bool>,
}

impl Listing {
    /// Expands every state; none where there are more than `most`.
    pub(in crate::solver::optimiser) fn new(
        joint: &mut JointSpace,
        most: usize,
    ) -> Result<Option<Self>, LimitReached> {
        let start = joint.initial().state;
        let limits = *joint.limits();
        let mut next = 0;
        while next < joint.states().len() {
            if joint.states().len() > most {
                return Ok(None);
            }
            joint.states_mut().expand(StateId(next as u32));
            next += 1;
            if next.is_multiple_of(STATES_BETWEEN_CHECKS) {
                limits.check_bytes(joint.bytes())?;
            }
        }
        let states = joint.states().len();
        let mut by_goal = vec![Vec::new(); joint.problem().goals().len()];
        for state in 0..states as u32 {
            for goal in joint.goals_of_state(StateId(state)).iter() {
                by_goal[goal].push(state);
            }
        }
        let mut reached = vec![false; states];
        reached[start.index()] = true;
        let mut open = vec![start];
        while let Some(state) = open.pop() {
            for edge in joint.states().edges(state) {
                if !std::mem::replace(&mut reached[edge.target.index()], true) {
                    open.push(edge.target);
                }
            }
        }
        Ok(Some(Self { states, by_goal, reached }))
    }

    /// The transitions as one observer sees them, by symbol.
    #[allow(clippy::unused_self)] // Only a listed space has all its transitions.
    pub(in crate::solver::optimiser) fn seen_by(
        &self,
        joint: &mut JointSpace,
        observer: usize,
    ) -> Vec<Seen> {
        let mut seen = Vec::with_capacity(joint.states().edge_count());
        for state in 0..joint.states().len() as u32 {
            for edge in joint.states().edge_range(StateId(state)) {
                let symbol = joint.symbol(observer, edge).index() as u32;
                let to = joint.states().all_edges()[edge].target.0;
                seen.push(Seen { symbol, from: state, to });
            }
        }
        seen.sort_unstable();
        seen.dedup();
        seen
    }

    /// The fewest actions from each state to the nearest of some states; `u32::MAX` for none.
    #[allow(clippy::unused_self)]
    pub(in crate::solver::optimiser) fn distances(
        &self,
        joint: &JointSpace,
        targets: &[u32],
    ) -> Vec<u32> {
        let mut before: Vec<Vec<u32>> = vec![Vec::new(); self.states];
        for state in 0..self.states as u32 {
            for edge in joint.states().edges(StateId(state)) {
                before[edge.target.index()].push(state);
            }
        }
        let mut distances = vec![u32::MAX; self.states];
        let mut queue = targets.to_vec();
        for &target in targets {
            distances[target as usize] = 0;
        }
        let mut next = 0;
        while let Some(&state) = queue.get(next) {
            next += 1;
            for &source in &before[state as usize] {
                if distances[source as usize] == u32::MAX {
                    distances[source as usize] = distances[state as usize] + 1;
                    queue.push(source);
                }
            }
        }
        distances
    }
}
