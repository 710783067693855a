//! Draws random problems of the paper's three larger domains as `pddl` documents.
//!
//! The paper gives their sizes (5 blocks; goals of 4 facts; 5 candidate goals), the enemy's sensor
//! (lifted action names) and an example of the friend's (of four blocks a, b, c, d the symbol
//! `stack-a-b` stands for stacking a or b on any block). What it leaves open and what was chosen is
//! in `docs/domains.md`. Every goal drawn can be reached by construction, so nothing is redrawn.

mod beliefs;
mod blocksworld;
mod driverlog;
mod logistics;

use rand::{Rng, RngExt};

pub use blocksworld::BlocksworldShape;
pub use driverlog::DriverlogShape;
pub use logistics::LogisticsShape;

use super::{Pddl, PddlGoal, PddlObserver, PddlSensor, PddlText};
use crate::domain::Observers;

/// The most states that can be drawn for an initial belief.
const MAX_BELIEF: u32 = 10_000;

/// A drawn problem before it is written down.
struct Draft {
    /// The name of the domain.
    domain: &'static str,
    /// The domain in PDDL.
    text: &'static str,
    seed: u64,
    /// Lines of the `:objects`, types included.
    objects: Vec<String>,
    /// Lines of the `:init`.
    init: Vec<String>,
    /// The facts of each candidate goal; the first is the true one.
    goals: Vec<Vec<String>>,
    /// Objects that look alike to the friend.
    groups: Vec<(String, Vec<String>)>,
}

impl Draft {
    /// The document, with the paper's two sensors and initial beliefs of at most `belief` states;
    /// observers with one state know the initial one.
    fn document(self, belief: u32, random: &mut impl Rng) -> Pddl {
        let Self { domain, text, seed, objects, init, goals, groups } = self;
        let section = |lines: Vec<String>| lines.join("\n    ");
        let problem = format!(
            "(define (problem {domain}-{seed})\n  (:domain {domain})\n  (:objects\n    {})\n  (:init\n    {}))",
            section(objects),
            section(init),
        );
        let goal = |(index, facts): (usize, Vec<String>)| PddlGoal {
            name: format!("G{}", index + 1),
            condition: format!("(and {})", facts.join(" ")),
        };
        let observer = |groups, sensor| PddlObserver { initial_belief: None, groups, sensor };
        let mut document = Pddl {
            domain: PddlText::new(text.trim_end()),
            problem: PddlText::new(problem),
            goals: goals.into_iter().enumerate().map(goal).collect(),
            true_goal: "G1".to_owned(),
            observers: Observers {
                adversarial: observer(Vec::new(), PddlSensor::names()),
                cooperative: observer(groups, PddlSensor::names_with_groups()),
            },
        };
        if belief > 1 {
            beliefs::draw_beliefs(&mut document, belief, random);
        }
        document
    }
}

/// Two halves of some objects, each with the name under which its objects look alike; a half of one
/// object needs none.
fn halves(names: &[String]) -> Vec<(String, Vec<String>)> {
    let (first, second) = names.split_at(names.len() / 2);
    let group = |half: &[String]| (half.len() > 1).then(|| (half.join("-"), half.to_vec()));
    [first, second].into_iter().filter_map(group).collect()
}

/// `prefix1`, `prefix2`, ….
fn numbered(prefix: &str, count: u32) -> Vec<String> {
    (1..=count).map(|number| format!("{prefix}{number}")).collect()
}

/// A number below `count`.
fn below(random: &mut impl Rng, count: usize) -> usize {
    random.random_range(0..count as u32) as usize
}

/// A number below `count` that is not `taken`.
fn other_than(random: &mut impl Rng, count: usize, taken: usize) -> usize {
    let number = below(random, count - 1);
    number + usize::from(number >= taken)
}

/// Draws until there are `count` more that differ from each other and from those at hand.
fn distinct<T: PartialEq>(count: u32, at_hand: Vec<T>, mut draw: impl FnMut() -> T) -> Vec<T> {
    let begin = at_hand.len();
    let mut drawn = at_hand;
    while drawn.len() < begin + count as usize {
        let next = draw();
        if !drawn.contains(&next) {
            drawn.push(next);
        }
    }
    drawn.split_off(begin)
}
