//! The schedule: what the optimiser tries, and after how many expansions.

use super::bounds::Bound;
use super::bounds::classes::Classes;
use super::bounds::invariants::Invariants;
use super::dominance::Policy;
use super::sampling::SampleSize;
use super::search::Search;
use crate::solver::ground::thresholds::{
    EXPANSIONS_BEFORE_ALL_CLASSES, EXPANSIONS_BEFORE_CLASSES, EXPANSIONS_BEFORE_INVARIANTS,
    EXPANSIONS_BEFORE_PAIRS, EXPANSIONS_BEFORE_PAIRS_SHORTEN, STATES_OF_A_SAMPLE,
    STATES_OF_A_SAMPLE_BY_GOAL, STATES_OF_A_SMALL_SPACE, STATES_OF_CLASSES,
};

/// The search at work.
#[derive(Debug)]
pub(super) enum Stage {
    /// Looks for good plans in the order of promise.
    Find(Search),
    /// The same with samples of the enemies' beliefs, where beliefs have outgrown their lists.
    Sample(Search),
    /// Looks for a plan that is worth more than the best one, with tables over pairs of states: first
    /// with each observer alone, by position, which mostly shows that there is none; then with all.
    Prove(Search, Option<usize>),
    /// Looks for a shortest plan of the best value.
    Shorten(Search),
}

impl Stage {
    pub(super) fn search(&self) -> &Search {
        match self {
            Self::Find(search)
            | Self::Sample(search)
            | Self::Prove(search, _)
            | Self::Shorten(search) => search,
        }
    }
}

/// What is asked while the first search is at work, after so many expansions.
#[derive(Debug, Clone, Copy)]
pub(super) enum Question {
    Bound(fn() -> Box<dyn Bound>),
    Pairs,
}

/// What is tried when. Nothing in it changes what is proved.
#[derive(Debug, Clone, Copy)]
pub(super) struct Schedule {
    /// In the order of the expansions of the first search after which they are asked.
    pub questions: [(u64, Question); 4],
    /// Expansions of the search for a shortest plan before tables of pairs are made for it.
    pub pairs_to_shorten: u64,
    /// Whether dominated nodes are left out.
    pub dominance: Policy,
    /// What is kept of an enemy's belief that is sampled.
    pub sample: SampleSize,
}

impl Default for Schedule {
    fn default() -> Self {
        let small = || Box::new(Classes { most_states: STATES_OF_A_SMALL_SPACE }) as Box<dyn Bound>;
        let large = || Box::new(Classes { most_states: STATES_OF_CLASSES }) as Box<dyn Bound>;
        Self {
            questions: [
                (EXPANSIONS_BEFORE_CLASSES, Question::Bound(small)),
                (EXPANSIONS_BEFORE_PAIRS, Question::Pairs),
                (EXPANSIONS_BEFORE_INVARIANTS, Question::Bound(|| Box::new(Invariants))),
                (EXPANSIONS_BEFORE_ALL_CLASSES, Question::Bound(large)),
            ],
            pairs_to_shorten: EXPANSIONS_BEFORE_PAIRS_SHORTEN,
            dominance: Policy::Sound,
            sample: SampleSize { spread: STATES_OF_A_SAMPLE, by_goal: STATES_OF_A_SAMPLE_BY_GOAL },
        }
    }
}
