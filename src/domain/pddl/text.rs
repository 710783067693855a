//! PDDL text inside of JSON: one text, or a list of its lines, which people can read.

use serde::{Serialize, Serializer};

use crate::document::DocumentError;
use crate::document::json::Json;
use crate::document::reader::Reader;

/// A PDDL text. As JSON a text of several lines is written as the list of its lines.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PddlText(String);

impl PddlText {
    /// A text.
    pub fn new(text: impl Into<String>) -> Self {
        Self(text.into())
    }

    /// The text, with a line end after each line but the last.
    pub fn as_str(&self) -> &str {
        &self.0
    }

    /// Reads a text or a list of lines.
    pub(super) fn read(reader: &Reader<'_>) -> Result<Self, DocumentError> {
        let expected = || reader.expected("a text in PDDL, or the list of its lines");
        match reader.value() {
            Json::Text(text) => Ok(Self(text.to_string())),
            Json::Array(_) => {
                let mut lines = reader
                    .list(|line| match line.value() {
                        Json::Text(line) => Ok(&**line),
                        _ => Err(line.expected("a line of PDDL")),
                    })?
                    .into_iter();
                let first = lines.next().ok_or_else(expected)?.to_owned();
                Ok(Self(lines.fold(first, |text, line| text + "\n" + line)))
            }
            _ => Err(expected()),
        }
    }
}

impl Serialize for PddlText {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if self.0.contains('\n') {
            serializer.collect_seq(self.0.split('\n'))
        } else {
            serializer.serialize_str(&self.0)
        }
    }
}

#[cfg(not(target_arch = "wasm32"))]
impl schemars::JsonSchema for PddlText {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "PddlText".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({"anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}, "minItems": 1}]})
    }
}
