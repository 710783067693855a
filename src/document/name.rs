//! Names that can be told apart by eye.
//!
//! Names and symbols are read by people, on a page and in a terminal. One that shows nothing, that
//! turns other text around, or that looks like another one makes any screen wrong, so documents are
//! refused that have such names. What looks alike is decided by a *skeleton*, as in Unicode
//! Technical Standard #39 (<https://www.unicode.org/reports/tr39/>): equal skeletons, equal looks.

use std::borrow::Cow;

use rustc_hash::FxHashMap;

use super::DocumentError;
use super::json::quoted;

/// Whether a sign has no shape of its own: the `Default_Ignorable_Code_Point`s of Unicode 16 (zero
/// width, direction, variation, tags), separators of lines, annotations, the empty braille pattern,
/// and signs for private use, which every screen shows as the same box.
///
/// ```
/// use mo_copp::document::is_hidden;
/// assert!(is_hidden('\u{200b}') && is_hidden('\u{202e}'));
/// assert!(!is_hidden('G') && !is_hidden('é') && !is_hidden(' '));
/// ```
pub fn is_hidden(sign: char) -> bool {
    matches!(
        sign,
        '\u{ad}'
            | '\u{34f}'
            | '\u{61c}'
            | '\u{115f}'..='\u{1160}'
            | '\u{17b4}'..='\u{17b5}'
            | '\u{180b}'..='\u{180f}'
            | '\u{200b}'..='\u{200f}'
            | '\u{2028}'..='\u{202e}'
            | '\u{2060}'..='\u{206f}'
            | '\u{2800}'
            | '\u{3164}'
            | '\u{e000}'..='\u{f8ff}'
            | '\u{fe00}'..='\u{fe0f}'
            | '\u{feff}'
            | '\u{ffa0}'
            | '\u{fff0}'..='\u{fffb}'
            | '\u{1bca0}'..='\u{1bca3}'
            | '\u{1d173}'..='\u{1d17a}'
            | '\u{e0000}'..='\u{e0fff}'
            | '\u{f0000}'..
    )
}

/// Whether a hidden sign does what its script or an emoji needs there: a joiner between two signs
/// beyond ASCII, a choice of text or emoji after one.
fn is_needed(before: Option<char>, sign: char, after: Option<char>) -> bool {
    let variation = |sign| matches!(sign, '\u{fe0e}' | '\u{fe0f}');
    let shown = |sign: char| !sign.is_ascii() && !is_hidden(sign);
    let after_shown = before.is_some_and(shown);
    match sign {
        '\u{200c}' | '\u{200d}' => {
            (after_shown || before.is_some_and(variation)) && after.is_some_and(shown)
        }
        // A digit in a key cap is the one emoji that begins in ASCII.
        sign => variation(sign) && (after_shown || after == Some('\u{20e3}')),
    }
}

/// A sign as people look it up.
fn code_point(sign: char) -> String {
    format!("U+{:04X}", u32::from(sign))
}

/// Checks a name or symbol that is shown: some sign of it must be seen, and no other be hidden.
/// Linear in its length.
///
/// # Errors
///
/// [`DocumentError::Invalid`] with the hidden sign as U+XXXX.
pub(super) fn check(path: &str, name: &str) -> Result<(), DocumentError> {
    if !name.is_ascii() {
        let mut before = None;
        let mut signs = name.chars().peekable();
        while let Some(sign) = signs.next() {
            if is_hidden(sign) && !is_needed(before, sign, signs.peek().copied()) {
                let found = format!("{} with the hidden sign {}", quoted(name), code_point(sign));
                let expected = "signs that can be seen";
                return Err(DocumentError::invalid(path, found, expected));
            }
            before = Some(sign);
        }
    }
    if name.chars().all(|sign| sign.is_whitespace() || sign.is_control() || is_hidden(sign)) {
        let signs: Vec<String> = name.chars().take(4).map(code_point).collect();
        let found = format!("a text that is blank when shown ({})", signs.join(" "));
        return Err(DocumentError::invalid(path, found, "a sign that can be seen"));
    }
    Ok(())
}

/// What an eye makes of a name: equal skeletons look alike. Canonical decomposition, without hidden
/// signs and controls, one space for white space between words, and Latin for the Greek and Cyrillic
/// letters that have the same shape in every font.
fn skeleton(name: &str) -> Cow<'_, str> {
    let plain = |name: &str| name.bytes().all(|byte| (b' '..=b'~').contains(&byte));
    if plain(name) && !name.starts_with(' ') && !name.ends_with(' ') && !name.contains("  ") {
        return Cow::Borrowed(name);
    }
    let mut shape = String::with_capacity(name.len());
    let mut space = false;
    for sign in decomposed(name).chars() {
        if sign.is_whitespace() {
            space = true;
        } else if !sign.is_control() && !is_hidden(sign) {
            if std::mem::take(&mut space) && !shape.is_empty() {
                shape.push(' ');
            }
            shape.push(same_shape(sign));
        }
    }
    Cow::Owned(shape)
}

/// Canonical decomposition (NFD).
#[cfg(not(target_arch = "wasm32"))]
fn decomposed(text: &str) -> String {
    use unicode_normalization::UnicodeNormalization;
    text.nfd().collect()
}

/// Canonical decomposition (NFD); every JavaScript engine brings the tables along.
#[cfg(target_arch = "wasm32")]
fn decomposed(text: &str) -> String {
    js_sys::JsString::from(text).normalize("NFD").into()
}

/// Compatibility composition (NFKC): as NFC, and letters of full width are as others.
#[cfg(all(feature = "full", not(target_arch = "wasm32")))]
fn composed(text: &str) -> String {
    use unicode_normalization::UnicodeNormalization;
    text.nfkc().collect()
}

/// Compatibility composition (NFKC), by the JavaScript engine.
#[cfg(all(feature = "full", target_arch = "wasm32"))]
fn composed(text: &str) -> String {
    js_sys::JsString::from(text).normalize("NFKC").into()
}

/// A name as it is compared where people type it: in compatibility composition, without hidden signs and controls, and with one
/// blank for white space between words. Capitals stay.
#[cfg(feature = "full")]
pub(crate) fn plain_name(name: &str) -> String {
    let shown = |sign: &char| sign.is_whitespace() || !(sign.is_control() || is_hidden(*sign));
    let shown: String = name.chars().filter(shown).collect();
    composed(&shown.split_whitespace().collect::<Vec<_>>().join(" "))
}

/// The Latin letter or ASCII sign of the same shape; the sign itself where there is none. An excerpt
/// of the table `confusables.txt` of Unicode Technical Standard #39.
fn same_shape(sign: char) -> char {
    const SHAPES: [(&str, &str); 3] = [
        ("ΑΒΕΖΗΙΚΜΝΟΡΤΥΧοϲϳϹͿ", "ABEZHIKMNOPTYXocjCJ"),
        ("АВЕКМНОРСТХЅІЈӀаеорсухѕіјԁԛԝһӏ", "ABEKMHOPCTXSIJIaeopcyxsijdqwhl"),
        ("‐‑․꞉", "--.:"),
    ];
    if sign.is_ascii() {
        return sign;
    }
    let pairs = SHAPES.iter().flat_map(|(from, to)| from.chars().zip(to.chars()));
    pairs.into_iter().find(|(from, _)| *from == sign).map_or(sign, |(_, to)| to)
}

/// Names by what an eye makes of them.
#[derive(Debug, Default)]
pub(crate) struct Names<'a>(FxHashMap<Cow<'a, str>, &'a str>);

impl<'a> Names<'a> {
    /// Adds a name, which is called `what` in a message.
    ///
    /// # Errors
    ///
    /// [`DocumentError::Invalid`] where it is there already, or looks like one that is.
    pub(crate) fn add(
        &mut self,
        name: &'a str,
        what: &str,
        path: impl Fn() -> String,
    ) -> Result<(), DocumentError> {
        self.add_as(skeleton(name), name, what, path)
    }

    /// Adds the name of an action. Blanks at its ends count: a plan is written with them.
    ///
    /// # Errors
    ///
    /// As [`add`](Self::add).
    pub(crate) fn add_action(
        &mut self,
        name: &'a str,
        path: impl Fn() -> String,
    ) -> Result<(), DocumentError> {
        let bare = name.trim_matches(' ');
        let shape = if bare == name {
            skeleton(name)
        } else {
            let (before, after) = name.split_once(bare).unwrap_or_default();
            Cow::Owned(format!("{before}{}{after}", skeleton(bare)))
        };
        self.add_as(shape, name, "the name", path)
    }

    fn add_as(
        &mut self,
        shape: Cow<'a, str>,
        name: &'a str,
        what: &str,
        path: impl Fn() -> String,
    ) -> Result<(), DocumentError> {
        match self.0.insert(shape, name) {
            None => Ok(()),
            Some(first) if first == name => {
                let found = format!("{what} {name:?} for the second time");
                Err(DocumentError::invalid(path(), found, "a name of its own"))
            }
            Some(first) => Err(alike(&path(), name, first)),
        }
    }

    /// Adds a symbol, which may be there already.
    ///
    /// # Errors
    ///
    /// [`DocumentError::Invalid`] where it looks like another one.
    pub(crate) fn add_symbol(
        &mut self,
        symbol: &'a str,
        path: impl Fn() -> String,
    ) -> Result<(), DocumentError> {
        match self.0.insert(skeleton(symbol), symbol) {
            Some(first) if first != symbol => Err(alike(&path(), symbol, first)),
            _ => Ok(()),
        }
    }
}

/// The error that two names look alike.
fn alike(path: &str, name: &str, first: &str) -> DocumentError {
    let mut signs = name.chars();
    let mut others = first.chars();
    let difference = loop {
        match (signs.next(), others.next()) {
            (Some(sign), Some(other)) if sign == other => {}
            (Some(sign), Some(other)) => {
                break format!("{} in place of {}", code_point(sign), code_point(other));
            }
            (Some(sign), None) => break format!("{} at its end", code_point(sign)),
            (None, Some(other)) => break format!("no {} at its end", code_point(other)),
            (None, None) => break "no difference".to_owned(),
        }
    };
    let found = format!("{}, which looks like {} ({difference})", quoted(name), quoted(first));
    DocumentError::invalid(path, found, "a name that can be told apart by eye")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_letter_of_another_script_has_its_latin_one() {
        for (from, to) in [("ΑΒΕ", "ABE"), ("Ӏ", "I"), ("ӏ", "l"), ("һ", "h"), ("Ϳ", "J")] {
            let shapes: String = from.chars().map(same_shape).collect();
            assert_eq!(shapes, to);
        }
    }

    #[test]
    fn skeletons() {
        for (name, shape) in [
            ("G1", "G1"),
            (" a  b ", "a b"),
            ("a\u{a0}b\t", "a b"),
            ("é", "e\u{301}"),
            ("G\u{200b}1\u{1b}", "G1"),
            ("Сafе", "Cafe"),
            ("x²", "x²"),
            ("目标", "目标"),
        ] {
            assert_eq!(skeleton(name), shape, "{name:?}");
        }
    }

    #[test]
    fn joiners_stay_where_scripts_and_emoji_need_them() {
        for name in [
            "می\u{200c}خواهم",
            "👩\u{200d}🚀",
            "❤\u{fe0f}\u{200d}🔥",
            "❤\u{fe0f}",
            "1\u{fe0f}\u{20e3}",
        ] {
            assert_eq!(check("x", name), Ok(()), "{name:?}");
        }
        for name in ["G\u{200d}1", "é\u{200d}", "\u{200d}é", "1\u{fe0f}", "é\u{200d}\u{200d}é"]
        {
            assert!(check("x", name).is_err(), "{name:?}");
        }
    }
}
