//! Reads over the text of JSON without making values of it: where a value ends, what stands in it.
//!
//! Made for text that a reader has taken already. Of any other it makes what it can, inside of the
//! text and without an error.

use std::ops::Range;

/// After the white space at `at`.
pub(super) fn space_end(text: &str, at: usize) -> usize {
    let rest = &text.as_bytes()[at..];
    at + rest.iter().take_while(|byte| byte.is_ascii_whitespace()).count()
}

/// After the value that begins at `at`, or the end of the text.
pub(super) fn value_end(text: &str, at: usize) -> usize {
    let bytes = text.as_bytes();
    let mut depth = 0_usize;
    let mut next = at;
    while let Some(byte) = bytes.get(next) {
        match byte {
            b'"' => next = string_end(text, next),
            b'{' | b'[' => {
                depth += 1;
                next += 1;
            }
            b'}' | b']' if depth > 0 => {
                depth -= 1;
                next += 1;
            }
            _ if depth > 0 => {
                next += 1;
                continue;
            }
            b'}' | b']' | b',' | b':' => return next,
            _ if byte.is_ascii_whitespace() => return next,
            _ => {
                next += 1;
                continue;
            }
        }
        if depth == 0 {
            return next;
        }
    }
    next
}

/// After the text in quotation marks that begins at `at`, or the end of the text.
fn string_end(text: &str, at: usize) -> usize {
    let bytes = text.as_bytes();
    let mut next = at + 1;
    while let Some(byte) = bytes.get(next) {
        match byte {
            b'"' => return next + 1,
            b'\\' => next += 2,
            _ => next += 1,
        }
    }
    text.len()
}

/// The values of the list that begins at `at`.
pub(super) fn items(text: &str, at: usize) -> impl Iterator<Item = Range<usize>> + '_ {
    let mut next = at + 1;
    std::iter::from_fn(move || {
        let begin = space_end(text, next);
        let end = value_end(text, begin);
        if end == begin {
            return None;
        }
        next = separator_end(text, end);
        Some(begin..end)
    })
}

/// The keys of the object that begins at `at`, and where their values begin.
pub(super) fn entries(text: &str, at: usize) -> impl Iterator<Item = (Range<usize>, usize)> + '_ {
    let mut next = at + 1;
    std::iter::from_fn(move || {
        let begin = space_end(text, next);
        let end = value_end(text, begin);
        if end == begin {
            return None;
        }
        let value = separator_end(text, end);
        next = separator_end(text, value_end(text, value));
        Some((begin..end, value))
    })
}

/// After white space, a comma or colon, and more white space.
fn separator_end(text: &str, at: usize) -> usize {
    let at = space_end(text, at);
    let mark = matches!(text.as_bytes().get(at), Some(b',' | b':'));
    space_end(text, at + usize::from(mark))
}

/// What is meant by the text in quotation marks at `string`, and where each character of it stands.
pub(super) fn characters(
    text: &str,
    string: Range<usize>,
) -> impl Iterator<Item = (Range<usize>, char)> + '_ {
    let end = string.end;
    let mut next = string.start + 1;
    std::iter::from_fn(move || {
        let begin = next;
        let rest = text.get(begin..end)?;
        let first = rest.chars().next()?;
        if first == '"' {
            return None;
        }
        let (meant, length) = if first == '\\' { escaped(rest) } else { (first, first.len_utf8()) };
        // Half an escape is no JSON; it is passed by its first byte.
        next = begin + if rest.is_char_boundary(length) { length } else { 1 };
        Some((begin..next, meant))
    })
}

/// The character that the escape at the beginning stands for, and how many bytes that takes.
fn escaped(rest: &str) -> (char, usize) {
    let plain = |meant| (meant, 2);
    match rest[1..].chars().next() {
        Some('n') => plain('\n'),
        Some('t') => plain('\t'),
        Some('r') => plain('\r'),
        Some('b') => plain('\u{8}'),
        Some('f') => plain('\u{c}'),
        Some('u') => {
            let unit = |at| rest.get(at..at + 4).and_then(|hex| u16::from_str_radix(hex, 16).ok());
            let second = if rest.get(6..8) == Some("\\u") { unit(8) } else { None };
            let units = [unit(2).unwrap_or_default(), second.unwrap_or_default()];
            match char::decode_utf16(units).next() {
                Some(Ok(meant)) => (meant, if meant.len_utf16() == 2 { 12 } else { 6 }),
                _ => (char::REPLACEMENT_CHARACTER, 6),
            }
        }
        Some(other) => (other, 1 + other.len_utf8()),
        None => plain(char::REPLACEMENT_CHARACTER),
    }
}
