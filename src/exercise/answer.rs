//! Answers: choices among what a question offers.

use std::collections::BTreeMap;

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

    /// An answer as people read it; [`read`](Form::read) reads it back.
    pub fn in_words(&self, answer: &Answer) -> String {
        StateLabel::list(self.labels(answer))
    }

    /// Reads an answer: in JSON, or in words: names with commas between them, cells and states with semicolons.
    ///
    /// # Errors
    ///
    /// [`DocumentError`] with the place in the answer, what stands there and what would do.
    pub fn read(&self, text: &str) -> Result<Answer, DocumentError> {
        let bare = text.trim();
        let (values, are_known) = self.values(bare);
        // States may have brackets in words as well.
        if are_known || !bare.starts_with(['[', '{', '"']) {
            return self.of_values(&values, &|index| format!("answer[{index}]"));
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

    /// What the words of an answer stand for, and whether all of them are choices.
    fn values(&self, words: &str) -> (Vec<Value>, bool) {
        let separator = self.choices.first().map_or(",", |choice| choice.separator().trim());
        let plain = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        // PDDL minds no capitals, and its actions are known without their parentheses.
        let is_pddl =
            self.choices.first().is_some_and(|choice| choice.to_string().starts_with('('));
        let plain = |text: &str| match plain(text) {
            text if is_pddl => text.trim_matches(['(', ')', ' ']).to_lowercase(),
            text => text,
        };
        let known: BTreeMap<String, &StateLabel> =
            self.choices.iter().map(|choice| (plain(&choice.to_string()), choice)).collect();
        let texts = words.split(separator).map(plain).filter(|text| !text.is_empty());
        let mut are_known = true;
        let values = texts.map(|text| match known.get(&text) {
            Some(choice) => serde_json::to_value(choice).unwrap_or_default(),
            None => {
                are_known = false;
                Value::from(text)
            }
        });
        (values.collect(), are_known)
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
        let mut shown = StateLabel::list(self.choices.iter().take(SHOWN));
        if self.choices.len() > SHOWN {
            shown.push_str(self.choices[0].separator());
            shown.push('…');
        }
        let a = if self.choice == "action" { "an" } else { "a" };
        format!("{a} {} of {shown}", self.choice)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::Value as StateValue;

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
        assert_eq!(cells.read("column 1,  row 2").unwrap().choices(), [0]);
        assert_eq!(set.in_words(&set.answer([0]).unwrap()), "column 1, row 2");
        let facts = StateLabel::Facts(vec!["at a".into(), "has b".into()]);
        let facts = Form { arity: Arity::Set, choice: "state", choices: vec![facts] };
        assert_eq!(
            facts.read(&facts.in_words(&facts.answer([0]).unwrap())).unwrap().choices(),
            [0]
        );
        let robot = |row| {
            StateLabel::Parts(vec![
                ("robot", StateValue::Cell(0, row)),
                ("battery", StateValue::Number(2)),
            ])
        };
        let robots = Form { arity: Arity::Set, choice: "state", choices: vec![robot(0), robot(1)] };
        let words = robots.in_words(&robots.answer([0, 1]).unwrap());
        assert_eq!(
            words,
            "{robot column 0, row 0 · battery 2}; {robot column 0, row 1 · battery 2}"
        );
        assert_eq!(robots.read(&words).unwrap().choices(), [0, 1]);
        assert_eq!(
            cells.read("row 1").unwrap_err().to_string(),
            "answer[0]: found \"row 1\", expected a cell of column 1, row 2"
        );
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
