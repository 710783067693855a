//! The true goal, guessed from what an observer is told of a whole walk.
//!
//! The walk is not told, only its symbols. A question is fair where they leave one goal.

use serde::Serialize;

use super::{Question, Solved, Watching};
use crate::document::DocumentError;
use crate::document::reader::Fields;
use crate::exercise::answer::{Answer, Arity, Form};
use crate::exercise::belief_layers::POSSIBLE;
use crate::exercise::subject::Subject;
use crate::exercise::verdict::{Finding, Verdict};
use crate::exercise::{Difficulty, Unfit, words};

/// The question.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub(in crate::exercise) struct Guess {
    /// The walk and the observer.
    #[serde(flatten)]
    pub(super) watching: Watching,
}

impl Guess {
    pub(super) fn read(fields: &Fields<'_>) -> Result<Self, DocumentError> {
        Ok(Self { watching: Watching::read(fields)? })
    }
}

impl Question for Guess {
    fn text(&self, subject: &Subject) -> String {
        let who = self.watching.who(&subject.problem);
        let told = self.watching.layers(subject).map(|layers| layers.symbols());
        let ends = words::ends_in_goal(&subject.document);
        let told = told.unwrap_or_default().join(", ");
        format!("{ends} Of the walk {who} is told: {told}. Which goal is it?")
    }

    fn form(&self, subject: &Subject) -> Result<Form, Unfit> {
        Ok(Form::named(Arity::One, "goal", subject.goal_names()))
    }

    fn solve(&self, subject: &Subject, form: &Form) -> Result<Solved, Unfit> {
        let mut layers = self.watching.layers(subject)?;
        let count = form.choices.len();
        let possible: Vec<usize> = (0..count)
            .filter(|&goal| layers.possible(|words| subject.in_goal(goal, words)))
            .collect();
        let true_goal = subject.problem.true_goal();
        if !subject.ends_in_goal(&self.watching.plan) {
            return Err(Unfit::new(format!("the walk does not end in {}", subject.true_goal())));
        }
        if possible != [true_goal] {
            let text =
                format!("the symbols leave {} goals, of which none can be told", possible.len());
            return Err(Unfit::new(text));
        }
        let others = (0..count).filter(|&goal| goal != true_goal);
        let others: Vec<usize> =
            others.filter(|&goal| layers.reachable(|words| subject.in_goal(goal, words))).collect();
        let mut remarks = Vec::new();
        if others.is_empty() {
            remarks.push("no other goal is in reach of so many steps".to_owned());
        }
        let told = layers.told_last();
        let left = |goal| {
            let in_goal = |words: &[u64]| subject.in_goal(goal, words);
            told.as_ref().is_none_or(|states| layers.any(states, in_goal))
        };
        if !others.is_empty() && (0..count).filter(|&goal| left(goal)).count() == 1 {
            remarks.push("the last symbol leaves one goal".to_owned());
        }
        let difficulty = Difficulty { size: others.len(), steps: layers.steps() };
        let answer = form.answer([true_goal as u32]).ok_or_else(Unfit::too_large)?;
        Ok(Solved { answer, difficulty, remarks })
    }

    fn check(&self, subject: &Subject, answer: &Answer) -> Verdict {
        let goal = answer.choices().first().map_or(0, |&goal| goal as usize);
        if goal == subject.problem.true_goal() {
            return Verdict::right();
        }
        match self.watching.layers(subject) {
            Ok(mut layers) => {
                let name = &subject.problem.goals()[goal].name;
                Verdict::wrong([
                    layers.finding(name, POSSIBLE, |words| subject.in_goal(goal, words))
                ])
            }
            Err(unfit) => Verdict::wrong([Finding::plain(unfit.to_string())]),
        }
    }

    fn passes(&self, _: &Subject) -> u64 {
        self.watching.passes()
    }
}
