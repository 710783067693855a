//! The two observers of a document, and what every format checks of goals.

use serde::Serialize;

use crate::document::reader::{Fields, Reader};
use crate::document::{DocumentError, Names};
use crate::problem::{MAX_GOALS, ProblemError, Role};

/// Something for each of the two observers.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub struct Observers<T> {
    /// The enemy's.
    pub adversarial: T,
    /// The friend's.
    pub cooperative: T,
}

impl<T> Observers<T> {
    /// Reads the `observers` of a document.
    pub(super) fn read<'a>(
        document: &Fields<'a>,
        mut read: impl FnMut(&Reader<'a>) -> Result<T, DocumentError>,
    ) -> Result<Self, DocumentError> {
        let expected = "an object with adversarial and cooperative";
        let fields =
            document.required("observers", expected)?.fields(&["adversarial", "cooperative"])?;
        Ok(Self {
            adversarial: read(&fields.required("adversarial", "an observer")?)?,
            cooperative: read(&fields.required("cooperative", "an observer")?)?,
        })
    }

    /// The value of this role.
    pub fn of(&self, role: Role) -> &T {
        match role {
            Role::Adversarial => &self.adversarial,
            Role::Cooperative => &self.cooperative,
        }
    }

    /// Role and value, the enemy first.
    pub fn iter(&self) -> impl Iterator<Item = (Role, &T)> {
        [(Role::Adversarial, &self.adversarial), (Role::Cooperative, &self.cooperative)].into_iter()
    }
}

/// The position of the true goal, once the goals' names have been checked.
pub(super) fn true_goal(names: &[&str], true_goal: &str) -> Result<usize, DocumentError> {
    if !(2..=MAX_GOALS).contains(&names.len()) {
        let found = format!("{} candidate goals", names.len());
        return Err(DocumentError::invalid("goals", found, format!("2 to {MAX_GOALS}")));
    }
    let mut known = Names::default();
    for (index, name) in names.iter().enumerate() {
        known.add(name, "the goal name", || format!("goals[{index}].name"))?;
    }
    names.iter().position(|name| *name == true_goal).ok_or_else(|| {
        let expected = format!("the name of a candidate goal: {}", listed(names));
        DocumentError::invalid("true_goal", format!("{true_goal:?}"), expected)
    })
}

/// Names for a message, the first few of many.
pub(super) fn listed(names: &[&str]) -> String {
    const SHOWN: usize = 8;
    if names.is_empty() {
        return "(none)".to_owned();
    }
    let mut shown: Vec<&str> = names.iter().take(SHOWN).copied().collect();
    if names.len() > SHOWN {
        shown.push("…");
    }
    shown.join(", ")
}

/// What a domain has already checked cannot go wrong; should it, the message still gets out.
pub(super) fn unexpected(error: &ProblemError) -> DocumentError {
    DocumentError::invalid("document", error.to_string(), "a well-formed problem")
}
