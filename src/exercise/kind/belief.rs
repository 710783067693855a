//! Where the agent can be for an observer after a walk: the observer's belief.

use serde::Serialize;

use super::{Question, Solved, Watching};
use crate::document::DocumentError;
use crate::document::reader::Fields;
use crate::exercise::answer::{Answer, Arity, Form, MAX_ANSWER, MAX_CHOICES};
use crate::exercise::belief_layers::BELIEVED;
use crate::exercise::subject::Subject;
use crate::exercise::verdict::{Finding, Verdict};
use crate::exercise::{Difficulty, Unfit, words};
use crate::problem::StateLabel;
use crate::task::StateSpace;

/// The question.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub(in crate::exercise) struct Belief {
    /// The walk and the observer.
    #[serde(flatten)]
    pub(super) watching: Watching,
}

impl Belief {
    pub(super) fn read(fields: &Fields<'_>) -> Result<Self, DocumentError> {
        Ok(Self { watching: Watching::read(fields)? })
    }

    /// All states that some walk from a state believed at first leads to, in order of the packed states.
    fn states(&self, subject: &Subject) -> Result<Vec<Vec<u64>>, Unfit> {
        let problem = &subject.problem;
        let mut space = StateSpace::new(problem.task().clone());
        let mut next = None;
        let believed = &problem.observers()[self.watching.observer(problem)].initial_belief;
        for state in believed.listed().ok_or_else(Unfit::too_large)? {
            let state = space.intern(state);
            next.get_or_insert(state);
        }
        let mut states = Vec::new();
        while let Some(state) = next {
            space.expand(state);
            states.push(space.words(state).to_vec());
            if space.len() > MAX_CHOICES {
                return Err(Unfit::too_large());
            }
            next = space.after(state);
        }
        states.sort_unstable();
        Ok(states)
    }
}

impl Question for Belief {
    fn text(&self, subject: &Subject) -> String {
        let who = self.watching.who(&subject.problem);
        let asked = words::asks_for_belief(&subject.document, who);
        format!("{}: {asked}", self.watching.walk())
    }

    fn form(&self, subject: &Subject) -> Result<Form, Unfit> {
        let states = self.states(subject)?;
        let choices = states.iter().map(|words| subject.problem.label(words)).collect();
        Ok(Form { arity: Arity::Set, choice: "state", choices })
    }

    fn solve(&self, subject: &Subject, form: &Form) -> Result<Solved, Unfit> {
        let states = self.states(subject)?;
        let layers = self.watching.layers(subject)?;
        let mut believed = Vec::new();
        for words in layers.believed(layers.steps()) {
            let place = states.iter().position(|known| known == words);
            believed.push(place.ok_or_else(Unfit::too_large)? as u32);
        }
        if believed.len() > MAX_ANSWER {
            return Err(Unfit::too_large());
        }
        let mut remarks = Vec::new();
        if believed.len() == 1 {
            remarks.push("only one state is believed".to_owned());
        }
        if believed.len() == states.len() {
            remarks.push("every state is believed".to_owned());
        }
        let difficulty = Difficulty { size: believed.len(), steps: layers.steps() };
        let answer = form.answer(believed).ok_or_else(Unfit::too_large)?;
        Ok(Solved { answer, difficulty, remarks })
    }

    fn check(&self, subject: &Subject, answer: &Answer) -> Verdict {
        let (states, layers) = (self.states(subject), self.watching.layers(subject));
        let (states, mut layers) = match (states, layers) {
            (Ok(states), Ok(layers)) => (states, layers),
            (Err(unfit), _) | (_, Err(unfit)) => {
                return Verdict::wrong([Finding::plain(unfit.to_string())]);
            }
        };
        // What was taken for believed and is not comes before what is missing.
        for chosen in [true, false] {
            for (place, state) in states.iter().enumerate() {
                let holds = |words: &[u64]| words == &state[..];
                let is_chosen = answer.choices().contains(&(place as u32));
                if is_chosen == chosen && layers.possible(holds) != chosen {
                    let label = subject.problem.label(state);
                    // A cell's name is words, and begins a sentence here.
                    let name = match label {
                        StateLabel::Cell(..) => label.to_string().replacen('c', "C", 1),
                        _ => label.to_string(),
                    };
                    return Verdict::wrong([layers.finding(&name, BELIEVED, holds)]);
                }
            }
        }
        Verdict::right()
    }

    fn passes(&self, _: &Subject) -> u64 {
        self.watching.passes()
    }
}
