//! Why a text is not JSON, said for people: the place, what stands there, and what should.
//!
//! `serde_json` finds the place and knows the rule that was broken; its words are a parser's.

use serde_json::Error;

use super::DocumentError;
use crate::limits::MAX_VALUES;

/// Longer excerpts are cut off.
const SHOWN: usize = 20;

/// How `Json` says that a key is given twice: before and after the key.
pub(super) const TWICE: (&str, &str) = ("the key ", " is given twice");

/// How `Json` says that there are more values than it takes.
pub(super) const TOO_MANY: &str = "too many values";

/// What is wrong with `text`, which `serde_json` refused.
pub(super) fn explained(text: &str, error: &Error) -> DocumentError {
    let place = Place::new(text, error);
    let message = error.to_string();
    let rule = message.split(" at line ").next().unwrap_or(&message);
    let (found, expected) = words(rule, &place);
    DocumentError::Syntax { line: place.line, column: place.column, found, expected }
}

fn words(rule: &str, place: &Place<'_>) -> (String, String) {
    let at = |expected: &str| (place.found(), expected.to_owned());
    let instead = |found: &str, expected: &str| (found.to_owned(), expected.to_owned());
    match rule {
        "EOF while parsing a list" | "expected `,` or `]`" => at("a comma or “]”"),
        "EOF while parsing an object" | "expected `,` or `}`" => at("a comma or “}”"),
        "EOF while parsing a string" => at("a double quote that ends the text begun before"),
        "EOF while parsing a value" if place.after_comma() => at("another entry after the comma"),
        "EOF while parsing a value" | "expected value" | "expected ident" => {
            at("a value: a text in double quotes, a number, a list, an object, true, false or null")
        }
        "expected `:`" => at("a colon between key and value"),
        "expected `\"`" | "key must be a string" => at("a key in double quotes"),
        "trailing comma" => {
            instead(&format!("{} after a comma", place.found()), "another entry, or no comma")
        }
        "trailing characters" => {
            instead(&format!("{} after the document", place.found()), "the end of the text")
        }
        "invalid number" => at("a number such as 3 or 0.5"),
        "number out of range" => instead("a number that is too large", "one below 10 to the 308th"),
        "invalid escape" => instead(
            "a backslash that means nothing here",
            "one of \\\" \\\\ \\/ \\b \\f \\n \\r \\t or \\u with four digits",
        ),
        "recursion limit exceeded" => {
            instead("lists and objects too deep inside of each other", "at most 127 levels")
        }
        TOO_MANY => instead(&format!("more than {MAX_VALUES} values"), "at most that"),
        _ if rule.contains("control character") => instead(
            "a line break or a tab inside of a text in double quotes",
            "the double quote that ends it, or \\n and \\t",
        ),
        // What is left of `serde_json`'s own rules is about `\u` and its digits.
        _ => match rule.strip_prefix(TWICE.0).and_then(|rest| rest.strip_suffix(TWICE.1)) {
            Some(key) => (format!("the key {key} for the second time"), "each key once".to_owned()),
            None => instead("half of a character, written with \\u", "a whole character"),
        },
    }
}

/// Where a text is broken.
struct Place<'t> {
    /// From 1.
    line: usize,
    /// In characters, from 1.
    column: usize,
    text: &'t str,
    /// The byte of `text`; its length at the end.
    at: usize,
}

impl<'t> Place<'t> {
    /// `serde_json` counts bytes, up to and with the one that does not fit; at the end of the text there is none.
    fn new(text: &'t str, error: &Error) -> Self {
        let lines_before = text.split_inclusive('\n').take(error.line().saturating_sub(1));
        let past = lines_before.map(str::len).sum::<usize>() + error.column();
        let wrong = if error.is_eof() { text.len() } else { past.saturating_sub(1) };
        let at = (0..=wrong.min(text.len())).rev().find(|&at| text.is_char_boundary(at));
        let at = at.unwrap_or(0);
        let line_start = text[..at].rfind('\n').map_or(0, |end| end + 1);
        let line = text[..at].matches('\n').count() + 1;
        Self { line, column: text[line_start..at].chars().count() + 1, text, at }
    }

    fn after_comma(&self) -> bool {
        self.text[..self.at].trim_end().ends_with(',')
    }

    /// What stands there: a word, the beginning of a quotation, or a sign.
    fn found(&self) -> String {
        let rest = &self.text[self.at..];
        let excerpt = match rest.chars().next() {
            None => return "the end of the text".to_owned(),
            Some('\n' | '\r') => return "the end of the line".to_owned(),
            Some(quote @ ('"' | '\'')) => rest[1..]
                .split_inclusive([quote, '\n'])
                .next()
                .map_or(rest, |inner| &rest[..=inner.trim_end().len()]),
            Some(sign) if !in_word(sign) => &rest[..sign.len_utf8()],
            Some(_) => {
                let before = &self.text[..self.at];
                let start = before.trim_end_matches(in_word).len();
                let word = &self.text[start..];
                word.split(|sign| !in_word(sign)).next().unwrap_or(word)
            }
        };
        let shown: String = excerpt.chars().take(SHOWN).collect();
        format!("“{shown}{}”", if shown.len() < excerpt.len() { "…" } else { "" })
    }
}

fn in_word(sign: char) -> bool {
    sign.is_alphanumeric() || matches!(sign, '_' | '-' | '+' | '.')
}
