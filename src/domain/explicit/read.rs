//! Reads an `explicit` document.

use super::{Explicit, ExplicitGoal, ExplicitObserver};
use crate::document::DocumentError;
use crate::document::reader::Reader;
use crate::domain::Observers;

const KEYS: [&str; 8] = [
    "format",
    "states",
    "actions",
    "transitions",
    "initial_state",
    "goals",
    "true_goal",
    "observers",
];

impl Explicit {
    /// Reads keys and types; whether the parts fit together is asked by
    /// [`problem`](Self::problem).
    ///
    /// # Errors
    ///
    /// [`DocumentError`] with the place.
    pub(in crate::domain) fn read(document: &Reader<'_>) -> Result<Self, DocumentError> {
        let fields = document.fields(&KEYS)?;
        Ok(Self {
            states: names(&fields.required("states", "a list of state names")?)?,
            actions: names(&fields.required("actions", "a list of action names")?)?,
            transitions: fields
                .required("transitions", "a list of [state, action, state]")?
                .list(|item| triple(item, "[state, action, resulting state]"))?,
            initial_state: name(&fields.required("initial_state", "a state")?)?,
            goals: fields.required("goals", "a list of goals")?.list(goal)?,
            true_goal: name(&fields.required("true_goal", "the name of a goal")?)?,
            observers: Observers::read(&fields, observer)?,
        })
    }
}

fn name(reader: &Reader<'_>) -> Result<String, DocumentError> {
    reader.name().map(str::to_owned)
}

fn names(reader: &Reader<'_>) -> Result<Vec<String>, DocumentError> {
    reader.list(name)
}

fn triple(reader: &Reader<'_>, expected: &str) -> Result<[String; 3], DocumentError> {
    let wrong = || reader.expected(expected);
    let items = reader.array().ok_or_else(wrong)?;
    if items.iter().any(|item| item.text().is_err()) {
        return Err(wrong());
    }
    let [one, two, three] = items.each_ref().map(name);
    Ok([one?, two?, three?])
}

fn goal(reader: &Reader<'_>) -> Result<ExplicitGoal, DocumentError> {
    let fields = reader.fields(&["name", "states"])?;
    Ok(ExplicitGoal {
        name: name(&fields.required("name", "the goal's name")?)?,
        states: names(&fields.required("states", "a list of states")?)?,
    })
}

fn observer(reader: &Reader<'_>) -> Result<ExplicitObserver, DocumentError> {
    let fields = reader.fields(&["initial_belief", "sensor"])?;
    Ok(ExplicitObserver {
        initial_belief: fields.optional("initial_belief").map(|r| names(&r)).transpose()?,
        sensor: fields
            .required("sensor", "a list of [action, resulting state, symbol]")?
            .list(|item| triple(item, "[action, resulting state, symbol]"))?,
    })
}
