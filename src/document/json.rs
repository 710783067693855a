//! A JSON value in which no key of an object is lost.

use std::cell::Cell;
use std::fmt;

use rustc_hash::FxHashSet;
use serde::de::{DeserializeSeed, Deserializer, Error as _, MapAccess, SeqAccess, Visitor};

use super::DocumentError;
use super::syntax::{TOO_MANY, TWICE, explained};
use crate::limits::{MAX_VALUES, excess_of_text};

/// A JSON value. Values take no more room than they need: a document may hold millions.
#[derive(Debug, Clone, PartialEq)]
pub enum Json {
    /// `null`
    Null,
    /// `true` or `false`
    Bool(bool),
    /// A whole number.
    Integer(i64),
    /// A whole number that is too large for [`Json::Integer`].
    Large(u64),
    /// Any other number.
    Float(f64),
    /// Text.
    Text(Box<str>),
    /// A list.
    Array(Box<[Json]>),
    /// Keys and values, in the order of the document.
    Object(Box<[(Box<str>, Json)]>),
}

impl Json {
    /// Reads a text. Values are counted while they are read, so that memory is bounded before there
    /// is too little of it.
    ///
    /// # Errors
    ///
    /// [`DocumentError::Invalid`] where the text is longer than [`MAX_TEXT_BYTES`](crate::limits::MAX_TEXT_BYTES),
    /// [`DocumentError::Syntax`] with line and column elsewhere; a key given twice and more than
    /// [`MAX_VALUES`] values are such errors.
    pub fn parse(text: &str) -> Result<Self, DocumentError> {
        if let Some((found, expected)) = excess_of_text(text) {
            return Err(DocumentError::invalid("document", found, expected));
        }
        let mut reader = serde_json::Deserializer::from_str(text);
        let read = Values { left: &Cell::new(MAX_VALUES) }.deserialize(&mut reader);
        let whole = read.and_then(|json| reader.end().map(|()| json));
        whole.map_err(|error| explained(text, &error))
    }

    /// The same without a key, where the value is an object.
    pub fn without(self, key: &str) -> Self {
        match self {
            Self::Object(entries) if entries.iter().any(|(known, _)| **known == *key) => {
                let entries = entries.into_vec().into_iter();
                Self::Object(entries.filter(|(known, _)| **known != *key).collect())
            }
            other => other,
        }
    }
}

/// As compact JSON, cut off where it gets long.
impl fmt::Display for Json {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const SHOWN: usize = 4;
        match self {
            Self::Null => f.write_str("null"),
            Self::Bool(value) => write!(f, "{value}"),
            Self::Integer(value) => write!(f, "{value}"),
            Self::Large(value) => write!(f, "{value}"),
            // A whole number written as 8.0 must not look like 8, nor 1e300 take 301 digits.
            Self::Float(value) => write!(f, "{value:?}"),
            Self::Text(text) => write!(f, "{}", quoted(text)),
            Self::Array(items) => {
                f.write_str("[")?;
                for (index, item) in items.iter().take(SHOWN).enumerate() {
                    if index > 0 {
                        f.write_str(", ")?;
                    }
                    match item {
                        Self::Array(_) | Self::Object(_) if index > 0 => f.write_str("…")?,
                        _ => write!(f, "{item}")?,
                    }
                }
                f.write_str(if items.len() > SHOWN { ", …]" } else { "]" })
            }
            Self::Object(entries) if entries.is_empty() => f.write_str("{}"),
            Self::Object(entries) => write!(f, "{{{}: …}}", quoted(&entries[0].0)),
        }
    }
}

/// A text in quotation marks, cut off where it gets long.
pub fn quoted(text: &str) -> String {
    const SHOWN: usize = 40;
    if text.chars().count() <= SHOWN {
        return format!("{text:?}");
    }
    let begin: String = text.chars().take(SHOWN).collect();
    format!("{:?}", begin + "…")
}

/// Reads values, as long as some are left.
#[derive(Clone, Copy)]
struct Values<'c> {
    left: &'c Cell<usize>,
}

impl<'de> DeserializeSeed<'de> for Values<'_> {
    type Value = Json;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Json, D::Error> {
        let Some(left) = self.left.get().checked_sub(1) else {
            return Err(D::Error::custom(TOO_MANY));
        };
        self.left.set(left);
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Values<'_> {
    type Value = Json;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a JSON value")
    }

    fn visit_unit<E>(self) -> Result<Json, E> {
        Ok(Json::Null)
    }

    fn visit_bool<E>(self, value: bool) -> Result<Json, E> {
        Ok(Json::Bool(value))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Json, E> {
        Ok(Json::Integer(value))
    }

    fn visit_u64<E>(self, value: u64) -> Result<Json, E> {
        Ok(i64::try_from(value).map_or(Json::Large(value), Json::Integer))
    }

    fn visit_f64<E>(self, value: f64) -> Result<Json, E> {
        Ok(Json::Float(value))
    }

    fn visit_str<E>(self, value: &str) -> Result<Json, E> {
        Ok(Json::Text(value.into()))
    }

    fn visit_string<E>(self, value: String) -> Result<Json, E> {
        Ok(Json::Text(value.into()))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Json, A::Error> {
        let mut array = Vec::new();
        while let Some(item) = items.next_element_seed(self)? {
            array.push(item);
        }
        Ok(Json::Array(array.into()))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Json, A::Error> {
        let mut object: Vec<(Box<str>, Json)> = Vec::new();
        let mut seen = FxHashSet::default();
        while let Some(key) = entries.next_key::<Box<str>>()? {
            if !seen.insert(key.clone()) {
                let (before, after) = TWICE;
                return Err(A::Error::custom(format!("{before}{}{after}", quoted(&key))));
            }
            object.push((key, entries.next_value_seed(self)?));
        }
        Ok(Json::Object(object.into()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_given_twice_is_refused_with_its_place() {
        let error = Json::parse("{\"a\": 1,\n \"a\": 2}").unwrap_err().to_string();
        assert_eq!(
            error,
            "line 2, column 4: found the key \"a\" for the second time, expected each key once"
        );
    }

    #[test]
    fn a_value_is_three_words() {
        assert!(size_of::<Json>() <= 24);
    }

    #[test]
    fn broken_text_has_a_place() {
        let error = Json::parse("{\"a\": }").unwrap_err().to_string();
        assert!(error.starts_with("line 1, column 7: found “}”, expected a value"), "{error}");
        assert!(Json::parse(&"[".repeat(100_000)).is_err());
    }
}
