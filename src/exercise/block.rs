//! The block `exercise` of a document.

use serde::Serialize;

use super::kind::Kind;
use crate::document::DocumentError;
use crate::document::json::Json;
use crate::document::reader::{Fields, Reader};
use crate::domain::EXERCISE;

/// The most attempts that can be asked for.
const MAX_ATTEMPTS: u32 = 99;

/// The most hints.
const MAX_HINTS: usize = 20;

/// What may be drawn anew for a variant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Vary {
    /// Where the agent starts, and what the observers believe at first.
    Start,
    /// The cells of the goals.
    Goals,
    /// The walls.
    Walls,
    /// Which candidate goal is the true one.
    TrueGoal,
    /// The walk that the question is about.
    Plan,
}

impl Vary {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Start, Self::Goals, Self::Walls, Self::TrueGoal, Self::Plan];

    /// The name in documents.
    pub fn name(self) -> &'static str {
        match self {
            Self::Start => "start",
            Self::Goals => "goals",
            Self::Walls => "walls",
            Self::TrueGoal => "true_goal",
            Self::Plan => "plan",
        }
    }
}

/// What the question keeps to itself, beside the solvers and what they find, which no question shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Hidden {
    /// What the observers believe and which goals are possible.
    Beliefs,
}

impl Hidden {
    /// All of them.
    pub const ALL: [Self; 1] = [Self::Beliefs];

    /// The name in documents.
    pub fn name(self) -> &'static str {
        match self {
            Self::Beliefs => "beliefs",
        }
    }
}

/// What of the problem stays as the exercise has it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(untagged)]
pub enum Lock {
    /// All of it (`true`), or none (`false`): then it may be opened without the question.
    Whole(bool),
    /// It may be opened without the question, and these keys of its document stay as they are.
    Keys(Vec<String>),
}

impl Lock {
    fn read(lock: &Reader<'_>, document: &Fields<'_>) -> Result<Self, DocumentError> {
        if let Ok(whole) = lock.boolean() {
            return Ok(Self::Whole(whole));
        }
        if !matches!(lock.value(), Json::Array(_)) {
            return Err(lock.expected("true, false or a list of keys of the document"));
        }
        let names: Vec<&str> = document
            .all()
            .map(|(name, _)| name)
            .filter(|name| !["format", EXERCISE].contains(name))
            .collect();
        let keys = listed(&lock.list(|item| Ok(item.clone()))?, &names, |name| name)?;
        Ok(Self::Keys(keys.into_iter().map(str::to_owned).collect()))
    }
}

/// An exercise as its document has it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Block {
    /// The question.
    pub(super) kind: Kind,
    /// A name for the exercise.
    pub(super) title: Option<String>,
    /// What the author says before the question.
    pub(super) introduction: Option<String>,
    /// Hints, one after another.
    pub(super) hints: Vec<String>,
    /// How many answers may be tried; any number when left out.
    pub(super) attempts: Option<u32>,
    /// What is not shown; what would give the answer away when left out.
    pub(super) hide: Option<Vec<Hidden>>,
    /// What stays as it is.
    pub(super) lock: Lock,
    /// What differs from variant to variant.
    pub(super) vary: Vec<Vary>,
}

impl Block {
    /// What is not shown.
    pub(super) fn hidden(&self) -> Vec<Hidden> {
        self.hide.clone().unwrap_or_else(|| match self.kind.watching() {
            Some(_) => Hidden::ALL.to_vec(),
            None => Vec::new(),
        })
    }
}

/// The keys that any exercise may have.
pub(super) const KEYS: [&str; 8] =
    ["kind", "title", "introduction", "hints", "attempts", "hide", "lock", "vary"];

impl Block {
    /// Reads the block of a document's text; none where it has none.
    pub(super) fn read(text: &str) -> Result<Option<Self>, DocumentError> {
        let json = Json::parse(text)?;
        let entries = Reader::new(&json).entries()?;
        entries.optional(EXERCISE).map(|block| Self::of(&block, &entries)).transpose()
    }

    fn of(block: &Reader<'_>, document: &Fields<'_>) -> Result<Self, DocumentError> {
        let entries = block.entries()?;
        let kind = Kind::read(&entries)?;
        let known = [&KEYS[..], Kind::keys(kind.name())].concat();
        let fields = block.fields(&known)?;
        let text = |key: &str| {
            fields.optional(key).map(|reader| reader.text().map(str::to_owned)).transpose()
        };
        let list = |key: &str, most: usize| match fields.optional(key) {
            None => Ok(Vec::new()),
            Some(reader) => {
                let items = reader.list(|item| Ok(item.clone()))?;
                if items.len() > most {
                    let found = format!("a list of {}", items.len());
                    return Err(DocumentError::invalid(
                        reader.path(),
                        found,
                        format!("at most {most}"),
                    ));
                }
                Ok(items)
            }
        };
        let mut hints = Vec::new();
        for hint in list("hints", MAX_HINTS)? {
            hints.push(hint.text()?.to_owned());
        }
        let attempts = fields.optional("attempts").map(|reader| reader.integer(1..=MAX_ATTEMPTS));
        let lock =
            fields.optional("lock").map(|reader| Lock::read(&reader, document)).transpose()?;
        Ok(Self {
            kind,
            title: text("title")?,
            introduction: text("introduction")?,
            hints,
            attempts: attempts.transpose()?,
            hide: fields
                .optional("hide")
                .map(|_| listed(&list("hide", Hidden::ALL.len())?, &Hidden::ALL, Hidden::name))
                .transpose()?,
            lock: lock.unwrap_or(Lock::Whole(true)),
            vary: listed(&list("vary", Vary::ALL.len())?, &Vary::ALL, Vary::name)?,
        })
    }
}

/// Names out of a few, each at most once.
fn listed<'n, T: Copy + PartialEq>(
    items: &[Reader<'_>],
    all: &[T],
    name: impl Fn(T) -> &'n str,
) -> Result<Vec<T>, DocumentError> {
    let mut found = Vec::with_capacity(items.len());
    for item in items {
        let value = item.one_of(all, &name)?;
        if found.contains(&value) {
            let twice = format!("{} for the second time", name(value));
            return Err(DocumentError::invalid(item.path(), twice, "each name once"));
        }
        found.push(value);
    }
    Ok(found)
}
