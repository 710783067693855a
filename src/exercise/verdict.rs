//! Verdicts: whether an answer is right, and what is wrong with it in the terms of the problem.

use serde::Serialize;

use crate::problem::StateLabel;

/// What is said of an answer.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Verdict {
    /// Whether the answer is right.
    pub right: bool,
    /// What is wrong with it, the first thing first; empty where it is right.
    pub findings: Vec<Finding>,
}

/// Something that is wrong with an answer.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Finding {
    /// What it is.
    pub text: String,
    /// A walk that shows it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub counterexample: Option<Counterexample>,
}

/// A walk that contradicts an answer. It may begin in any state that the observer believes at first.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Counterexample {
    /// Whose symbols these are.
    pub observer: String,
    /// Where it begins.
    pub start: StateLabel,
    /// The actions.
    pub actions: Vec<String>,
    /// The symbol of each action.
    pub symbols: Vec<String>,
    /// Where it ends.
    pub end: StateLabel,
    /// The first step, from 1, at which a symbol differs from what the observer was told; none where all are the same.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub differs: Option<usize>,
}

impl Verdict {
    /// The answer is right.
    pub(super) fn right() -> Self {
        Self { right: true, findings: Vec::new() }
    }

    /// The answer is wrong; at least one thing is said of it.
    pub(super) fn wrong(findings: impl IntoIterator<Item = Finding>) -> Self {
        Self { right: false, findings: findings.into_iter().collect() }
    }

    /// 1 where the answer is right, 0 elsewhere.
    pub fn score(&self) -> u8 {
        u8::from(self.right)
    }

    /// The first thing that is wrong.
    pub fn reason(&self) -> &str {
        self.findings.first().map_or("", |finding| &finding.text)
    }
}

impl Finding {
    /// Something that no walk shows.
    pub(super) fn plain(text: impl Into<String>) -> Self {
        Self { text: text.into(), counterexample: None }
    }
}
