//! The kinds of questions, one file each.

mod belief;
mod best;
mod guess;
mod placement;
mod possible_goals;
mod walk;
mod watching;

use std::fmt::Debug;

use serde::Serialize;

use super::answer::{Answer, Form};
use super::subject::Subject;
use super::verdict::Verdict;
use super::{Difficulty, Unfit};
use crate::document::DocumentError;
use crate::document::reader::Fields;
use crate::problem::Problem;

pub(super) use watching::Watching;

/// What a kind of question does.
pub(super) trait Question: Debug {
    /// The question in words.
    fn text(&self, subject: &Subject) -> String;
    /// What an answer is made of.
    fn form(&self, subject: &Subject) -> Result<Form, Unfit>;
    /// A right answer, how hard the question is, and what speaks against it.
    fn solve(&self, subject: &Subject, form: &Form) -> Result<Solved, Unfit>;
    /// What is said of an answer.
    fn check(&self, subject: &Subject, answer: &Answer) -> Verdict;
    /// How often the states of the problem are passed, about, until there is an answer.
    fn passes(&self, subject: &Subject) -> u64;
}

/// A right answer and what is known of the question by it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Solved {
    /// A right answer.
    pub(super) answer: Answer,
    /// How hard the question is.
    pub(super) difficulty: Difficulty,
    /// What makes the question trivial; nothing as a rule.
    pub(super) remarks: Vec<String>,
}

/// A question about a problem. In a document it is an object with the key `kind` beside those of its fields.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub(super) enum Kind {
    /// Which goals are possible for an observer after a walk.
    PossibleGoals(possible_goals::PossibleGoals),
    /// Where the agent can be for an observer after a walk.
    Belief(belief::Belief),
    /// A walk with a goal difference of at least x, or of at most n steps.
    Walk(walk::Walk),
    /// A walk with the best goal difference.
    Best(best::Best),
    /// A camera, a wall or a start, so that a goal is possible or not.
    Placement(placement::Placement),
    /// The true goal, from what an observer is told of a walk.
    Guess(guess::Guess),
}

/// The kinds by name, as documents have them.
pub(super) const KINDS: [&str; 6] =
    ["possible-goals", "belief", "walk", "best", "placement", "guess"];

impl Kind {
    /// Reads the fields of a kind. Keys that belong to no kind are those of the block.
    pub(super) fn read(fields: &Fields<'_>) -> Result<Self, DocumentError> {
        let expected = format!("one of {}", KINDS.join(", "));
        let kind = fields.required("kind", &expected)?;
        Ok(match kind.text()? {
            "possible-goals" => Self::PossibleGoals(possible_goals::PossibleGoals::read(fields)?),
            "belief" => Self::Belief(belief::Belief::read(fields)?),
            "walk" => Self::Walk(walk::Walk::read(fields)?),
            "best" => Self::Best(best::Best::read(fields)?),
            "placement" => Self::Placement(placement::Placement::read(fields)?),
            "guess" => Self::Guess(guess::Guess::read(fields)?),
            _ => return Err(kind.expected(expected)),
        })
    }

    /// The name in documents.
    pub(super) fn name(&self) -> &'static str {
        match self {
            Self::PossibleGoals(_) => KINDS[0],
            Self::Belief(_) => KINDS[1],
            Self::Walk(_) => KINDS[2],
            Self::Best(_) => KINDS[3],
            Self::Placement(_) => KINDS[4],
            Self::Guess(_) => KINDS[5],
        }
    }

    /// The keys that a kind has beside `kind`.
    pub(super) fn keys(name: &str) -> &'static [&'static str] {
        match name {
            "walk" => &["goal_difference", "at_most"],
            "best" => &["shortest"],
            "placement" => &["observer", "plan", "place", "goal", "possible"],
            _ => &["observer", "plan"],
        }
    }

    /// The walk that the question is about, and whose view of it; none where the answer is a walk.
    pub(super) fn watching(&self) -> Option<&Watching> {
        match self {
            Self::PossibleGoals(kind) => Some(&kind.watching),
            Self::Belief(kind) => Some(&kind.watching),
            Self::Placement(kind) => Some(&kind.watching),
            Self::Guess(kind) => Some(&kind.watching),
            Self::Walk(_) | Self::Best(_) => None,
        }
    }

    /// The same question about another walk.
    pub(super) fn with_plan(&self, plan: Vec<String>) -> Self {
        let mut kind = self.clone();
        match &mut kind {
            Self::PossibleGoals(kind) => kind.watching.plan = plan,
            Self::Belief(kind) => kind.watching.plan = plan,
            Self::Placement(kind) => kind.watching.plan = plan,
            Self::Guess(kind) => kind.watching.plan = plan,
            Self::Walk(_) | Self::Best(_) => {}
        }
        kind
    }

    /// What asks and checks.
    pub(super) fn question(&self) -> &dyn Question {
        match self {
            Self::PossibleGoals(kind) => kind,
            Self::Belief(kind) => kind,
            Self::Walk(kind) => kind,
            Self::Best(kind) => kind,
            Self::Placement(kind) => kind,
            Self::Guess(kind) => kind,
        }
    }

    /// What the page must show of a placement: `camera`, `wall` or `start`.
    pub(super) fn placed(&self) -> Option<&'static str> {
        match self {
            Self::Placement(kind) => Some(kind.place.name()),
            _ => None,
        }
    }

    /// Checks the names in the question against the problem.
    pub(super) fn refer(&self, problem: &Problem) -> Result<(), DocumentError> {
        if let Some(watching) = self.watching() {
            watching.refer(problem)?;
        }
        match self {
            Self::Placement(kind) => kind.refer(problem),
            _ => Ok(()),
        }
    }
}
