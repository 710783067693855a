//! Where in its text an error of a document stands.
//!
//! Errors name the place as a path of keys, which a person can follow, or as line and column. Here
//! both become line and column of the whole text, which an editor can show. The text is looked
//! through only then: a document without errors pays nothing.

use std::ops::Range;

use super::DocumentError;
use super::scan::{characters, entries, items, space_end, value_end};

/// A stretch of one line. Columns and lengths count characters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Place {
    /// The line, from 1.
    pub line: usize,
    /// The first column, from 1.
    pub column: usize,
    /// How many characters; 0 where something is missing.
    pub length: usize,
}

impl DocumentError {
    /// Where in `text`, from which the document was read, the error stands: at the value that does
    /// not fit, where a key is missing at the object that lacks it. What takes several lines ends
    /// with the first. In a text that is not the document's own it is some place inside of it.
    ///
    /// Linear in the length of the text.
    ///
    /// ```
    /// use mo_copp::document::Place;
    /// use mo_copp::domain::Document;
    /// let text = "{\"format\": \"gridworld\",\n \"width\": 4,\n \"height\": -3}";
    /// let error = Document::parse(text).unwrap_err();
    /// assert_eq!(error.place(text), Place { line: 3, column: 12, length: 2 });
    /// ```
    pub fn place(&self, text: &str) -> Place {
        match self {
            Self::Syntax { line, column, .. } => at_line(text, *line, *column),
            Self::Pddl { path, line, column, .. } => {
                let value = value_at(text, path);
                Place::of(text, within(text, &value, (*line, *column)).unwrap_or(value))
            }
            Self::UnknownKey { path, key, .. } => {
                let object = value_at(text, path);
                let found = keys(text, object.start).find(|(name, _)| is(text, name, key));
                Place::of(text, found.map_or(object, |(name, _)| name))
            }
            Self::Invalid { path, .. } => Place::of(text, value_at(text, path)),
            Self::NeedsFullCore => Place::of(text, value_at(text, "document")),
        }
    }
}

impl Place {
    /// Bytes of a text; what is in a further line is left out.
    fn of(text: &str, bytes: Range<usize>) -> Self {
        let before = &text[..bytes.start];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let stretch = text[bytes].lines().next().unwrap_or_default();
        Self {
            line: before.bytes().filter(|&byte| byte == b'\n').count() + 1,
            column: before[line_start..].chars().count() + 1,
            length: stretch.chars().count(),
        }
    }
}

/// One character at a line and a column, as far as the text has them.
fn at_line(text: &str, line: usize, column: usize) -> Place {
    let number = line.clamp(1, text.split('\n').count());
    let length = text.split('\n').nth(number - 1).unwrap_or_default().chars().count();
    let column = column.clamp(1, length + 1);
    Place { line: number, column, length: usize::from(column <= length) }
}

/// The value at a path; where there is none, the deepest on the way to it.
fn value_at(text: &str, path: &str) -> Range<usize> {
    let path = if path == "document" { "" } else { path };
    find(text, space_end(text, 0), path, true).1
}

/// What of the path was left over at the deepest value, and that value.
///
/// A name may hold dots and brackets itself, so every key that fits is tried. No value is looked at
/// twice: there is one way to it.
fn find(text: &str, at: usize, path: &str, whole: bool) -> (usize, Range<usize>) {
    let mut best = (path.len(), at..value_end(text, at));
    if path.is_empty() {
        return best;
    }
    let mut follow = |value, rest: &str| {
        let found = find(text, value, rest, false);
        if found.0 < best.0 {
            best = found;
        }
    };
    match text.as_bytes().get(at) {
        Some(b'{') => {
            let Some(names) = (if whole { Some(path) } else { path.strip_prefix('.') }) else {
                return best;
            };
            for (name, value) in keys(text, at) {
                if let Some(rest) = without(text, &name, names)
                    && (rest.is_empty() || rest.starts_with(['.', '[']))
                {
                    follow(value, rest);
                }
            }
        }
        Some(b'[') => {
            let index = path.strip_prefix('[').and_then(|path| path.split_once(']'));
            let Some((index, rest)) = index else { return best };
            let item = index.parse().ok().and_then(|index| items(text, at).nth(index));
            if let Some(item) = item {
                follow(item.start, rest);
            }
        }
        _ => {}
    }
    best
}

/// Keys in quotation marks, and where their values begin; none where there is no object.
fn keys(text: &str, at: usize) -> impl Iterator<Item = (Range<usize>, usize)> + '_ {
    let object = text.as_bytes().get(at) == Some(&b'{');
    let quoted = |entry: &(Range<usize>, usize)| text[entry.0.clone()].starts_with('"');
    object.then(|| entries(text, at)).into_iter().flatten().take_while(quoted)
}

/// What comes in `path` after the key at `name`, where it begins with that.
fn without<'a>(text: &str, name: &Range<usize>, path: &'a str) -> Option<&'a str> {
    characters(text, name.clone())
        .try_fold(path, |rest, (_, character)| rest.strip_prefix(character))
}

fn is(text: &str, name: &Range<usize>, key: &str) -> bool {
    without(text, name, key) == Some("")
}

/// The word at a line and a column of the text that a string, or a list of lines, stands for.
fn within(text: &str, value: &Range<usize>, wanted: (usize, usize)) -> Option<Range<usize>> {
    let lines: Vec<Range<usize>> = match text.as_bytes().get(value.start)? {
        b'"' => vec![value.clone()],
        b'[' => {
            items(text, value.start).filter(|item| text[item.clone()].starts_with('"')).collect()
        }
        _ => return None,
    };
    let (mut line, mut column) = (1, 1);
    for string in lines {
        let mut found: Option<Range<usize>> = None;
        let mut end = string.start + 1;
        for (bytes, character) in characters(text, string) {
            end = bytes.end;
            match &mut found {
                Some(word) if ends_word(character) => return Some(word.clone()),
                Some(word) => word.end = bytes.end,
                None if (line, column) == wanted && character == '\n' => {
                    return Some(bytes.start..bytes.start);
                }
                None if (line, column) == wanted && ends_word(character) => return Some(bytes),
                None if (line, column) == wanted => found = Some(bytes),
                None => {}
            }
            (line, column) = if character == '\n' { (line + 1, 1) } else { (line, column + 1) };
        }
        // Something is missing where the line ends.
        let missing = (line == wanted.0).then_some(end..end);
        if let Some(place) = found.or(missing) {
            return Some(place);
        }
        (line, column) = (line + 1, 1);
    }
    None
}

fn ends_word(character: char) -> bool {
    character.is_whitespace() || matches!(character, '(' | ')')
}
