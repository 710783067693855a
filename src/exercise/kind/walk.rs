//! A walk to the true goal with a goal difference of at least x, or of at most n steps, or both.

use serde::{Serialize, Serializer};

use super::{Question, Solved};
use crate::document::DocumentError;
use crate::document::json::Json;
use crate::document::reader::Fields;
use crate::exercise::answer::{Answer, Arity, Form, MAX_ANSWER};
use crate::exercise::subject::Subject;
use crate::exercise::verdict::{Finding, Verdict};
use crate::exercise::{Difficulty, Unfit};
use crate::goal_difference::nearest;

/// Numbers of goals are whole, so two goal differences that are nearer than this are one.
const SAME: f64 = 1e-9;

/// The question.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(in crate::exercise) struct Walk {
    /// The goal difference that the walk must have at least.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) goal_difference: Option<AtLeast>,
    /// The most steps.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) at_most: Option<u32>,
}

/// A goal difference that must be reached.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::exercise) struct AtLeast(f64);

impl Serialize for AtLeast {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.0.serialize(serializer)
    }
}

impl Walk {
    pub(super) fn read(fields: &Fields<'_>) -> Result<Self, DocumentError> {
        let goal_difference = fields.optional("goal_difference").map(|reader| {
            let number = match reader.value() {
                Json::Integer(number) => Some(*number as f64),
                Json::Float(number) => Some(*number),
                _ => None,
            };
            let number = number.filter(|number| (-1.0..=1.0).contains(number));
            number.map(AtLeast).ok_or_else(|| reader.expected("a number from -1 to 1"))
        });
        let at_most = fields.optional("at_most").map(|r| r.integer(1..=MAX_ANSWER as u32));
        let walk =
            Self { goal_difference: goal_difference.transpose()?, at_most: at_most.transpose()? };
        if walk.goal_difference.is_none() && walk.at_most.is_none() {
            let expected =
                "the goal difference that the walk must have, or at_most, its most steps";
            fields.required("goal_difference", expected)?;
        }
        Ok(walk)
    }
}

impl Walk {
    /// The goal difference that the walk must have at least, where the document may have rounded it.
    fn least(&self, subject: &Subject) -> Option<f64> {
        let goals = subject.problem.goals().len();
        self.goal_difference.map(|AtLeast(least)| nearest(least, goals))
    }
}

impl Question for Walk {
    fn text(&self, subject: &Subject) -> String {
        let difference = self.least(subject).map(|least| {
            format!(" with a goal difference of at least {}", subject.difference(least))
        });
        let steps = self.at_most.map(|most| format!(" of at most {most} steps"));
        let and = if difference.is_some() && steps.is_some() { "," } else { "" };
        format!(
            "Give a walk to {}{}{and}{}.",
            subject.true_goal(),
            steps.unwrap_or_default(),
            difference.unwrap_or_default()
        )
    }

    fn form(&self, subject: &Subject) -> Result<Form, Unfit> {
        Ok(Form::named(Arity::Sequence, "action", subject.action_names()))
    }

    fn solve(&self, subject: &Subject, form: &Form) -> Result<Solved, Unfit> {
        let shortest = subject.shortest()?;
        let most = self.at_most.map(|most| most as usize);
        let least = self.least(subject);
        let plan = match least {
            None => Some(subject.best_of_length(shortest)?.plan),
            Some(least) => {
                subject.shortest_with(|value| value >= least - SAME, most)?.map(|best| best.plan)
            }
        };
        let plan = plan.filter(|plan| most.is_none_or(|most| plan.len() <= most));
        let plan = plan.ok_or_else(|| Unfit::new("no walk answers the question".to_owned()))?;
        let mut remarks = Vec::new();
        let trivial = match least {
            Some(least) => {
                let best = subject.best_of_length(shortest)?.value;
                (best >= least - SAME).then_some("a shortest walk answers it")
            }
            None => (shortest < 2).then_some("one step answers it"),
        };
        remarks.extend(trivial.map(str::to_owned));
        let difficulty = Difficulty { size: plan.len() - shortest, steps: plan.len() };
        Ok(Solved { answer: Subject::answer(form, &plan)?, difficulty, remarks })
    }

    fn check(&self, subject: &Subject, answer: &Answer) -> Verdict {
        let walked = match subject.walked(answer) {
            Ok(walked) => walked,
            Err(verdict) => return verdict,
        };
        if let Some(most) = self.at_most.filter(|&most| walked.plan.len() > most as usize) {
            let text =
                format!("The walk has {} steps; at most {most} are asked for.", walked.plan.len());
            return Verdict::wrong([Finding::plain(text)]);
        }
        match self.least(subject) {
            Some(least) if walked.goal_difference < least - SAME => {
                let first = Finding::plain(format!(
                    "The walk has goal difference {}; at least {} is asked for.",
                    subject.difference(walked.goal_difference),
                    subject.difference(least)
                ));
                Verdict::wrong(std::iter::once(first).chain(subject.shortfall(&walked)))
            }
            _ => Verdict::right(),
        }
    }

    fn passes(&self, subject: &Subject) -> u64 {
        let shortest = if self.goal_difference.is_none() { subject.shortest().ok() } else { None };
        subject.expansions(shortest)
    }
}
