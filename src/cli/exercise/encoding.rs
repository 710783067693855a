//! The text of a table: its encoding, and what spreadsheets put before its first line.

use std::borrow::Cow;

use encoding_rs::{Encoding, UTF_8, UTF_16BE, UTF_16LE, WINDOWS_1252};

/// The text of a file: in the encoding that its first bytes name, else in UTF-16 where every other byte is zero as a rule,
/// else in UTF-8, else as Windows writes western languages.
pub fn decode(bytes: &[u8]) -> Cow<'_, str> {
    let encoding = match Encoding::for_bom(bytes) {
        Some((named, _)) => named,
        None => wide(bytes).unwrap_or_else(|| {
            if std::str::from_utf8(bytes).is_ok() { UTF_8 } else { WINDOWS_1252 }
        }),
    };
    encoding.decode(bytes).0
}

/// UTF-16 without a mark of the order of its bytes: signs of western languages have a zero in each.
fn wide(bytes: &[u8]) -> Option<&'static Encoding> {
    let zeros =
        |first: usize| bytes.iter().skip(first).step_by(2).filter(|&&byte| byte == 0).count();
    let (high, low) = (zeros(0), zeros(1));
    let many = bytes.len() / 4;
    match high.max(low) {
        most if most == 0 || most < many => None,
        most if most == high => Some(UTF_16BE),
        _ => Some(UTF_16LE),
    }
}

/// The separator that a first line `sep=;` names, as spreadsheets write and read it, and the text after that line.
pub fn named_separator(text: &str) -> Option<(u8, &str)> {
    let end = text.find(['\r', '\n'])?;
    let line = text[..end].trim_matches('"');
    let sign = match line.split_at_checked(4) {
        Some((name, sign)) if name.eq_ignore_ascii_case("sep=") => sign,
        _ => return None,
    };
    let rest = &text[end..];
    let after = rest.strip_prefix("\r\n").unwrap_or(&rest[1..]);
    match sign.as_bytes() {
        [sign] if !sign.is_ascii_alphanumeric() && *sign != b'"' => Some((*sign, after)),
        _ => None,
    }
}

/// A text without control characters, but for tabs and line ends.
pub fn printable(text: &str) -> String {
    let is_shown = |sign: &char| !sign.is_control() || matches!(sign, '\t' | '\n' | '\r');
    text.chars().filter(is_shown).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn utf_16_without_its_mark_is_found() {
        let text = "name\tcode\nZo\u{eb}\t\u{4e2d}\n";
        let wide = |order: fn(u16) -> [u8; 2]| -> Vec<u8> {
            text.encode_utf16().flat_map(order).collect()
        };
        assert_eq!(decode(&wide(u16::to_le_bytes)), text);
        assert_eq!(decode(&wide(u16::to_be_bytes)), text);
        assert_eq!(decode(text.as_bytes()), text);
        assert_eq!(decode(b"a\0b,code\n1234567890"), "a\0b,code\n1234567890");
        assert_eq!(decode(b""), "");
    }

    #[test]
    fn the_line_that_names_the_separator_is_no_head() {
        assert_eq!(named_separator("sep=;\r\na;b"), Some((b';', "a;b")));
        assert_eq!(named_separator("\"SEP=|\"\na|b"), Some((b'|', "a|b")));
        assert_eq!(named_separator("sep=\t\ra"), Some((b'\t', "a")));
        for text in ["sep=;", "sep;code\n", "sep=ab\n", "sep=\n", "sep=a\n", "code\n", ""] {
            assert_eq!(named_separator(text), None, "{text}");
        }
    }

    #[test]
    fn control_characters_are_left_out() {
        assert_eq!(printable("a\0\u{1b}[1m\tb\r\n\u{85}"), "a[1m\tb\r\n");
    }
}
