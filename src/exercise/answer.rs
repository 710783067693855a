//! Answers: choices among what a question offers.

use serde::Serialize;
use serde_json::Value;

use crate::document::DocumentError;
use crate::document::json::Json;
use crate::problem::StateLabel;

/// The most choices of an answer: steps of a walk, goals or states of a set.
pub const MAX_ANSWER: usize = 1000;

/// The most choices that a question offers.
pub const MAX_CHOICES: usize = 4096;

/// How many choices an answer is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Arity {
    /// One choice.
    One,
    /// Any number of different choices, whose order does not count.
    Set,
    /// Choices one after another, each as often as wanted.
    Sequence,
}

/// What an answer is made of.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct Form {
    /// How many choices are made.
    pub arity: Arity,
    /// A word for a choice: `goal`, `state`, `action` or `cell`.
    pub choice: &'static str,
    /// The choices, by name, cell or state.
    pub choices: Vec<StateLabel>,
}

/// An answer: positions among the choices of a [`Form`], those of a set in order.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Answer(Vec<u32>);

impl Answer {
    /// The positions of the choices.
    pub fn choices(&self) -> &[u32] {
        &self.0
    }
}

impl Form {
    /// A form of names.
    pub(super) fn named<'n>(
        arity: Arity,
        choice: &'static str,
        names: impl IntoIterator<Item = &'n str>,
    ) -> Self {
        let choices = names.into_iter().map(|name| StateLabel::Name(name.into())).collect();
        Self { arity, choice, choices }
    }

    /// The answer of these positions; none where they do not fit the form.
    pub fn answer(&self, choices: impl IntoIterator<Item = u32>) -> Option<Answer> {
        let mut choices: Vec<u32> = choices.into_iter().collect();
        let known = |choice: &u32| (*choice as usize) < self.choices.len();
        if choices.len() > MAX_ANSWER || !choices.iter().all(known) {
            return None;
        }
        match self.arity {
            Arity::One if choices.len() != 1 => return None,
            Arity::Set => {
                choices.sort_unstable();
                choices.dedup();
            }
            Arity::One | Arity::Sequence => {}
        }
        Some(Answer(choices))
    }

    /// The labels of an answer's choices.
    pub fn labels(&self, answer: &Answer) -> Vec<&StateLabel> {
        answer.0.iter().filter_map(|&choice| self.choices.get(choice as usize)).collect()
    }

    /// An answer as JSON: a choice, or a list of choices.
    pub fn to_json(&self, answer: &Answer) -> Value {
        let value = |label: &StateLabel| serde_json::to_value(label).unwrap_or_default();
        let mut values: Vec<Value> = self.labels(answer).into_iter().map(value).collect();
        match (self.arity, values.pop()) {
            (Arity::One, last) => last.unwrap_or_default(),
            (_, last) => {
                values.extend(last);
                Value::Array(values)
            }
        }
    }

    /// Reads an answer: in JSON, or names with commas between them.
    ///
    /// # Errors
    ///
    /// [`DocumentError`] with the place in the answer, what stands there and what would do.
    pub fn read(&self, text: &str) -> Result<Answer, DocumentError> {
        let bare = text.trim();
        if !bare.starts_with(['[', '{', '"']) {
            let names = bare.split(',').map(str::trim).filter(|name| !name.is_empty());
            let names: Vec<Value> = names.map(Value::from).collect();
            return self.of_values(&names, &|index| format!("answer[{index}]"));
        }
        // Items with commas between them are a list, as names are.
        let items =
            || serde_json::from_str(&format!("[{bare}]")).ok().filter(|_| bare.starts_with('['));
        let value: Value = match serde_json::from_str(bare) {
            Ok(value) => value,
            Err(_) => match items() {
                Some(list) => list,
                // For what is said of a text that is no JSON.
                None => Json::parse(bare).map(|_| Value::default())?,
            },
        };
        match (&value, self.arity) {
            (Value::Array(values), Arity::Set | Arity::Sequence) => {
                self.of_values(values, &|index| format!("answer[{index}]"))
            }
            (single, _) => self.of_values(std::slice::from_ref(single), &|_| "answer".to_owned()),
        }
    }

    fn of_values(
        &self,
        values: &[Value],
        path: &dyn Fn(usize) -> String,
    ) -> Result<Answer, DocumentError> {
        let known: Vec<Value> = self
            .choices
            .iter()
            .map(|label| serde_json::to_value(label).unwrap_or_default())
            .collect();
        let mut choices = Vec::with_capacity(values.len());
        for (index, value) in values.iter().enumerate() {
            let place = known.iter().position(|known| known == value).ok_or_else(|| {
                DocumentError::invalid(path(index), value.to_string(), self.expected())
            })?;
            choices.push(place as u32);
        }
        let count = choices.len();
        self.answer(choices).ok_or_else(|| {
            let most = match self.arity {
                Arity::One => format!("one {}", self.choice),
                Arity::Set | Arity::Sequence => format!("at most {MAX_ANSWER}"),
            };
            DocumentError::invalid("answer", format!("{count} choices"), most)
        })
    }

    /// The first few choices, for a message.
    fn expected(&self) -> String {
        const SHOWN: usize = 8;
        let mut shown: Vec<String> =
            self.choices.iter().take(SHOWN).map(ToString::to_string).collect();
        if self.choices.len() > SHOWN {
            shown.push("…".to_owned());
        }
        format!("a {} of {}", self.choice, shown.join(", "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn goals(arity: Arity) -> Form {
        Form::named(arity, "goal", ["G1", "G2", "G3"])
    }

    #[test]
    fn answers_are_read_in_json_and_as_names() {
        let form = goals(Arity::Set);
        let answer = form.read(r#"["G3", "G1", "G3"]"#).unwrap();
        assert_eq!(answer.choices(), [0, 2]);
        assert_eq!(form.read("G3, G1").unwrap(), answer);
        assert_eq!(form.to_json(&answer).to_string(), r#"["G1","G3"]"#);
        assert_eq!(form.read("").unwrap().choices(), [0; 0]);
        let walk = Form::named(Arity::Sequence, "action", ["north", "east"]);
        assert_eq!(walk.read("east,north,east").unwrap().choices(), [1, 0, 1]);
        assert_eq!(goals(Arity::One).read(r#""G2""#).unwrap().choices(), [1]);
        let cells =
            Form { arity: Arity::One, choice: "cell", choices: vec![StateLabel::Cell(1, 2)] };
        assert_eq!(cells.read("[1, 2]").unwrap().choices(), [0]);
        let set = Form { arity: Arity::Set, ..cells.clone() };
        assert_eq!(set.read("[1, 2], [1, 2]").unwrap().choices(), [0]);
        assert_eq!(set.read("[[1, 2]]").unwrap().choices(), [0]);
        assert_eq!(cells.to_json(&cells.answer([0]).unwrap()).to_string(), "[1,2]");
    }

    #[test]
    fn what_is_no_answer_is_refused_with_its_place() {
        let says = |form: &Form, text: &str| form.read(text).unwrap_err().to_string();
        assert_eq!(
            says(&goals(Arity::Set), r#"["G1", "G9"]"#),
            r#"answer[1]: found "G9", expected a goal of G1, G2, G3"#
        );
        assert_eq!(says(&goals(Arity::One), "G1,G2"), "answer: found 2 choices, expected one goal");
        assert!(says(&goals(Arity::One), "[\"G1\"").starts_with("line 1, column"));
        let walk = Form::named(Arity::Sequence, "action", ["a"]);
        let long = vec!["a"; MAX_ANSWER + 1].join(",");
        assert_eq!(says(&walk, &long), "answer: found 1001 choices, expected at most 1000");
    }
}
