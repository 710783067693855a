//! Walks a JSON value and remembers where it is.

use super::DocumentError;
use super::json::Json;
use super::name;

/// A value and its place in the document.
#[derive(Debug, Clone)]
pub struct Reader<'a> {
    value: &'a Json,
    path: String,
    /// What the whole is called.
    whole: &'static str,
}

/// An object whose keys have been checked.
#[derive(Debug, Clone)]
pub struct Fields<'a> {
    entries: &'a [(Box<str>, Json)],
    path: String,
    whole: &'static str,
}

impl<'a> Reader<'a> {
    /// The whole document.
    pub fn new(value: &'a Json) -> Self {
        Self::of("document", value)
    }

    /// The whole of something else, which its messages call `whole`.
    pub fn of(whole: &'static str, value: &'a Json) -> Self {
        Self { value, path: String::new(), whole }
    }

    /// Where this value stands, as in `goals[1].cell`.
    pub fn path(&self) -> &str {
        if self.path.is_empty() { self.whole } else { &self.path }
    }

    /// The value itself.
    pub fn value(&self) -> &'a Json {
        self.value
    }

    /// The error that something else was expected here.
    pub fn expected(&self, expected: impl Into<String>) -> DocumentError {
        DocumentError::invalid(self.path(), self.value.to_string(), expected)
    }

    /// An object with any keys.
    ///
    /// # Errors
    ///
    /// The value is no object.
    pub fn entries(&self) -> Result<Fields<'a>, DocumentError> {
        match self.value {
            Json::Object(entries) => {
                Ok(Fields { entries, path: self.path.clone(), whole: self.whole })
            }
            _ => Err(self.expected("an object")),
        }
    }

    /// An object that has no keys but these.
    ///
    /// # Errors
    ///
    /// The value is no object, or it has another key.
    pub fn fields(&self, known: &[&str]) -> Result<Fields<'a>, DocumentError> {
        let fields = self.entries()?;
        match fields.entries.iter().find(|(key, _)| !known.contains(&&**key)) {
            None => Ok(fields),
            Some((key, _)) => Err(DocumentError::UnknownKey {
                path: self.path().to_owned(),
                key: key.to_string(),
                known: known.join(", "),
            }),
        }
    }

    /// The items of a list of `N`; none where the value is something else.
    pub fn array<const N: usize>(&self) -> Option<[Reader<'a>; N]> {
        let Json::Array(items) = self.value else { return None };
        let items: &'a [Json; N] = (**items).try_into().ok()?;
        let item = |i: usize| Reader {
            value: &items[i],
            path: format!("{}[{i}]", self.path),
            whole: self.whole,
        };
        Some(std::array::from_fn(item))
    }

    /// Reads each item of a list.
    ///
    /// # Errors
    ///
    /// The value is no list, or an item does not fit.
    pub fn list<T>(
        &self,
        mut read: impl FnMut(&Reader<'a>) -> Result<T, DocumentError>,
    ) -> Result<Vec<T>, DocumentError> {
        let Json::Array(items) = self.value else { return Err(self.expected("a list")) };
        // One item at a time, into a list that need not grow: a place for each of a million items
        // would take far more memory than the items.
        let mut list = Vec::with_capacity(items.len());
        for (index, value) in items.iter().enumerate() {
            list.push(read(&Reader {
                value,
                path: format!("{}[{index}]", self.path),
                whole: self.whole,
            })?);
        }
        Ok(list)
    }

    /// A text that is not empty.
    ///
    /// # Errors
    ///
    /// The value is something else.
    pub fn text(&self) -> Result<&'a str, DocumentError> {
        match self.value {
            Json::Text(text) if !text.is_empty() => Ok(text),
            _ => Err(self.expected("a text that is not empty")),
        }
    }

    /// A name or a symbol, which is shown to people: a text that can be seen as it is.
    ///
    /// # Errors
    ///
    /// The value is something else, is blank when shown, or holds a sign that is hidden (see
    /// [`is_hidden`](super::is_hidden)).
    pub fn name(&self) -> Result<&'a str, DocumentError> {
        let name = self.text()?;
        name::check(self.path(), name).map(|()| name)
    }

    /// `true` or `false`.
    ///
    /// # Errors
    ///
    /// The value is something else.
    pub fn boolean(&self) -> Result<bool, DocumentError> {
        match self.value {
            Json::Bool(value) => Ok(*value),
            _ => Err(self.expected("true or false")),
        }
    }

    /// A text of a few that are known.
    ///
    /// # Errors
    ///
    /// The value is no text, or none of these.
    pub fn one_of<'n, T: Copy>(
        &self,
        all: &[T],
        name: impl Fn(T) -> &'n str,
    ) -> Result<T, DocumentError> {
        let known = |text: &str| all.iter().copied().find(|&value| name(value) == text);
        self.text().ok().and_then(known).ok_or_else(|| {
            let names: Vec<&str> = all.iter().map(|&value| name(value)).collect();
            self.expected(format!("one of {}", names.join(", ")))
        })
    }

    /// A whole number in a range.
    ///
    /// # Errors
    ///
    /// The value is no whole number, or outside the range.
    pub fn integer(&self, range: std::ops::RangeInclusive<u32>) -> Result<u32, DocumentError> {
        let number = match self.value {
            Json::Integer(value) => u32::try_from(*value).ok(),
            _ => None,
        };
        number.filter(|value| range.contains(value)).ok_or_else(|| {
            self.expected(format!("a whole number from {} to {}", range.start(), range.end()))
        })
    }
}

impl<'a> Fields<'a> {
    fn path_of(&self, key: &str) -> String {
        if self.path.is_empty() { key.to_owned() } else { format!("{}.{key}", self.path) }
    }

    /// The value of a key, where it is there.
    pub fn optional(&self, key: &str) -> Option<Reader<'a>> {
        let (_, value) = self.entries.iter().find(|(known, _)| **known == *key)?;
        Some(Reader { value, path: self.path_of(key), whole: self.whole })
    }

    /// The value of a key.
    ///
    /// # Errors
    ///
    /// The key is missing.
    pub fn required(&self, key: &str, expected: &str) -> Result<Reader<'a>, DocumentError> {
        let missing = || DocumentError::invalid(self.path_of(key), "nothing", expected);
        self.optional(key).ok_or_else(missing)
    }

    /// All keys, which are names, and values.
    ///
    /// # Errors
    ///
    /// A key is blank when shown, or holds a sign that is hidden.
    pub fn named(&self) -> Result<impl Iterator<Item = (&'a str, Reader<'a>)> + '_, DocumentError> {
        for (key, _) in self.entries {
            name::check(if self.path.is_empty() { self.whole } else { &self.path }, key)?;
        }
        Ok(self.all())
    }

    /// All keys and values.
    pub fn all(&self) -> impl Iterator<Item = (&'a str, Reader<'a>)> + '_ {
        let reader = |(key, value): &'a (Box<str>, Json)| {
            (&**key, Reader { value, path: self.path_of(key), whole: self.whole })
        };
        self.entries.iter().map(reader)
    }
}
