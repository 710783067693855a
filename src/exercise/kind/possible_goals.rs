//! Which goals are possible for an observer after a walk: the goals that survive in its belief.

use serde::Serialize;

use super::{Question, Solved, Watching};
use crate::document::DocumentError;
use crate::document::reader::Fields;
use crate::exercise::answer::{Answer, Arity, Form};
use crate::exercise::belief_layers::POSSIBLE;
use crate::exercise::subject::Subject;
use crate::exercise::verdict::{Finding, Verdict};
use crate::exercise::{Difficulty, Unfit};

/// The question.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub(in crate::exercise) struct PossibleGoals {
    /// The walk and the observer.
    #[serde(flatten)]
    pub(super) watching: Watching,
}

impl PossibleGoals {
    pub(super) fn read(fields: &Fields<'_>) -> Result<Self, DocumentError> {
        Ok(Self { watching: Watching::read(fields)? })
    }
}

impl Question for PossibleGoals {
    fn text(&self, subject: &Subject) -> String {
        let who = self.watching.who(&subject.problem);
        format!("{}: which goals are possible for {who}?", self.watching.walk())
    }

    fn form(&self, subject: &Subject) -> Result<Form, Unfit> {
        Ok(Form::named(Arity::Set, "goal", subject.goal_names()))
    }

    fn solve(&self, subject: &Subject, form: &Form) -> Result<Solved, Unfit> {
        let layers = self.watching.layers(subject)?;
        let count = form.choices.len();
        let possible: Vec<u32> = (0..count as u32)
            .filter(|&goal| layers.possible(|words| subject.in_goal(goal as usize, words)))
            .collect();
        let mut remarks = Vec::new();
        if possible.is_empty() {
            remarks.push("no goal is possible".to_owned());
        }
        if possible.len() == count {
            remarks.push("every goal is possible".to_owned());
        }
        let difficulty = Difficulty { size: possible.len(), steps: layers.steps() };
        let answer = form.answer(possible).ok_or_else(Unfit::too_large)?;
        Ok(Solved { answer, difficulty, remarks })
    }

    fn check(&self, subject: &Subject, answer: &Answer) -> Verdict {
        let mut layers = match self.watching.layers(subject) {
            Ok(layers) => layers,
            Err(unfit) => return Verdict::wrong([Finding::plain(unfit.to_string())]),
        };
        for (goal, name) in subject.goal_names().enumerate() {
            let holds = |words: &[u64]| subject.in_goal(goal, words);
            if layers.possible(holds) != answer.choices().contains(&(goal as u32)) {
                return Verdict::wrong([layers.finding(name, POSSIBLE, holds)]);
            }
        }
        Verdict::right()
    }

    fn passes(&self, _: &Subject) -> u64 {
        self.watching.passes()
    }
}
