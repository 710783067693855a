//! SVG text: elements one after another, with names of a document escaped.

use std::fmt::{Display, Write};

/// A piece of SVG that grows.
#[derive(Debug, Default)]
pub(super) struct Svg(String);

/// How a line of text stands to its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// The mean width of a letter, as a part of the font's size: what fits is told by it, since nothing here can
/// measure the reader's font.
const LETTER: f64 = 0.56;

impl Svg {
    /// The text.
    pub fn into_text(self) -> String {
        self.0
    }

    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Adds markup as it is: never a name of a document.
    pub fn raw(&mut self, markup: impl Display) {
        // Writing to a text cannot fail.
        let _ = write!(self.0, "{markup}");
    }

    /// A rectangle; `more` are further attributes, written by this program.
    pub fn rect(&mut self, [x, y, width, height]: [f64; 4], more: impl Display) {
        let (x, y, width, height) = (Number(x), Number(y), Number(width), Number(height));
        self.raw(format_args!(
            r#"<rect x="{x}" y="{y}" width="{width}" height="{height}" {more}/>"#
        ));
    }

    /// A circle.
    pub fn circle(&mut self, [x, y]: [f64; 2], radius: f64, more: impl Display) {
        let (x, y, radius) = (Number(x), Number(y), Number(radius));
        self.raw(format_args!(r#"<circle cx="{x}" cy="{y}" r="{radius}" {more}/>"#));
    }

    /// A line of text of this size.
    pub fn text(
        &mut self,
        [x, y]: [f64; 2],
        size: f64,
        anchor: Anchor,
        text: &str,
        more: impl Display,
    ) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let (x, y, size) = (Number(x), Number(y), Number(size));
        self.raw(format_args!(
            r#"<text x="{x}" y="{y}" font-size="{size}" text-anchor="{anchor}" {more}>"#
        ));
        self.raw(Escaped(text));
        self.raw("</text>");
    }

    /// A line of text that is shortened where it would be wider than `width`; the whole stands in its title.
    pub fn fitted(
        &mut self,
        at: [f64; 2],
        size: f64,
        anchor: Anchor,
        width: f64,
        text: &str,
        more: impl Display,
    ) {
        let short = fitting(text, size, width);
        if short == text {
            self.text(at, size, anchor, text, more);
        } else {
            self.raw("<g><title>");
            self.raw(Escaped(text));
            self.raw("</title>");
            self.text(at, size, anchor, &short, more);
            self.raw("</g>");
        }
    }
}

/// As much of a text as fits, with … for the rest.
pub(super) fn fitting(text: &str, size: f64, width: f64) -> String {
    let most = (width / (size * LETTER)).floor().max(1.0) as usize;
    if text.chars().count() <= most {
        return text.to_owned();
    }
    let kept: String = text.chars().take(most.saturating_sub(1)).collect();
    format!("{}…", kept.trim_end())
}

/// A text as SVG holds it: markup is escaped, and characters that XML forbids are replaced.
pub(super) struct Escaped<'a>(pub &'a str);

impl Display for Escaped<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for character in self.0.chars() {
            match character {
                '&' => f.write_str("&amp;")?,
                '<' => f.write_str("&lt;")?,
                '>' => f.write_str("&gt;")?,
                '"' => f.write_str("&quot;")?,
                '\t' | '\n' | '\r' => f.write_char(' ')?,
                '\u{0}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => f.write_char('\u{fffd}')?,
                _ => f.write_char(character)?,
            }
        }
        Ok(())
    }
}

/// A number with at most two digits behind the point, the same on every platform.
pub(super) struct Number(pub f64);

impl Display for Number {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let hundredths = (self.0 * 100.0).round() as i64;
        let (whole, rest) = (hundredths.unsigned_abs() / 100, hundredths.unsigned_abs() % 100);
        if hundredths < 0 {
            f.write_char('-')?;
        }
        match rest {
            0 => write!(f, "{whole}"),
            rest if rest % 10 == 0 => write!(f, "{whole}.{}", rest / 10),
            rest => write!(f, "{whole}.{rest:02}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_signed() {
        let shown = |number: f64| Number(number).to_string();
        assert_eq!(shown(3.0), "3");
        assert_eq!(shown(-0.5), "-0.5");
        assert_eq!(shown(1.055_1), "1.06");
        assert_eq!(shown(-2.05), "-2.05");
        assert_eq!(shown(0.001), "0");
    }

    #[test]
    fn names_are_no_markup() {
        assert_eq!(Escaped("<b>&\"\u{1}\n").to_string(), "&lt;b&gt;&amp;&quot;\u{fffd} ");
    }

    #[test]
    fn long_texts_end_with_an_ellipsis() {
        assert_eq!(fitting("abc", 10.0, 100.0), "abc");
        assert_eq!(fitting("abcdefghij", 10.0, 30.0), "abcd…");
    }
}
