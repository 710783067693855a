//! A walk to the true goal with the best goal difference that any walk has.

use serde::Serialize;

use super::{Question, Solved};
use crate::document::DocumentError;
use crate::document::reader::Fields;
use crate::exercise::answer::{Answer, Arity, Form};
use crate::exercise::subject::Subject;
use crate::exercise::verdict::{Finding, Verdict};
use crate::exercise::{Difficulty, Unfit};

/// Numbers of goals are whole, so two goal differences that are nearer than this are one.
const SAME: f64 = 1e-9;

/// The question.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub(in crate::exercise) struct Best {
    /// Whether the walk must be a shortest one of the best.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub(super) shortest: bool,
}

impl Best {
    pub(super) fn read(fields: &Fields<'_>) -> Result<Self, DocumentError> {
        let shortest = fields.optional("shortest").map(|r| r.boolean()).transpose()?;
        Ok(Self { shortest: shortest.unwrap_or(false) })
    }
}

impl Question for Best {
    fn text(&self, subject: &Subject) -> String {
        let which = if self.shortest { "a shortest walk" } else { "a walk" };
        format!("Find {which} to {} with the best goal difference.", subject.true_goal())
    }

    fn form(&self, subject: &Subject) -> Result<Form, Unfit> {
        Ok(Form::named(Arity::Sequence, "action", subject.action_names()))
    }

    fn solve(&self, subject: &Subject, form: &Form) -> Result<Solved, Unfit> {
        let shortest = subject.shortest()?;
        let best = subject.best()?;
        let mut remarks = Vec::new();
        if subject.best_of_length(shortest)?.value >= best.value - SAME {
            remarks.push("a shortest walk answers it".to_owned());
        }
        let difficulty = Difficulty { size: best.plan.len() - shortest, steps: best.plan.len() };
        Ok(Solved { answer: Subject::answer(form, &best.plan)?, difficulty, remarks })
    }

    fn check(&self, subject: &Subject, answer: &Answer) -> Verdict {
        let walked = match subject.walked(answer) {
            Ok(walked) => walked,
            Err(verdict) => return verdict,
        };
        let best = match subject.best() {
            Ok(best) => best,
            Err(unfit) => return Verdict::wrong([Finding::plain(unfit.to_string())]),
        };
        if walked.goal_difference < best.value - SAME {
            let first = Finding::plain(format!(
                "The walk has goal difference {}; there is a better one.",
                subject.difference(walked.goal_difference)
            ));
            return Verdict::wrong(std::iter::once(first).chain(subject.shortfall(&walked)));
        }
        if self.shortest && walked.plan.len() > best.plan.len() {
            let text = format!(
                "The walk has the best goal difference, but {} steps; there is a shorter one.",
                walked.plan.len()
            );
            return Verdict::wrong([Finding::plain(text)]);
        }
        Verdict::right()
    }

    fn passes(&self, subject: &Subject) -> u64 {
        subject.expansions(None)
    }
}
