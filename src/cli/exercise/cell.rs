//! The one answer code in a cell of a table, with whatever forms, spreadsheets and people put around it.

use std::collections::BTreeSet;

use mo_copp::exercise::code::{canonical, is_like_code, is_of_signs, is_whole};

/// Words that are looked at together, where a code has blanks in it: a longer text has no code that is written so.
const MOST_WORDS: usize = 400;

/// What is in a cell.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Cell {
    /// Nothing, or a sign that stands for nothing.
    Empty,
    /// One thing that has the shape of a code, or a text that has none in it.
    Code(String),
    /// Several codes, or things of their shape: which of them is meant, nothing says.
    Several,
}

impl Cell {
    /// Reads a cell: the one code in it.
    pub fn read(text: &str) -> Self {
        if is_whole(text) {
            return Self::Code(text.to_owned());
        }
        let plain = without_markup(text);
        if says_nothing(&plain) {
            return Self::Empty;
        }
        let (mut whole, mut like) = (BTreeSet::new(), BTreeSet::new());
        for piece in plain.split(|sign: char| !is_of_signs(&sign.to_string())) {
            let words: Vec<&str> = piece.split_whitespace().collect();
            let codes = codes_of(&words);
            let is_inside = |word: &&str| codes.iter().any(|code| code.contains(&canonical(word)));
            like.extend(
                words.iter().copied().filter(|word| is_like_code(word) && !is_inside(word)),
            );
            whole.extend(codes);
        }
        let mut found = whole.iter().map(String::as_str).chain(like);
        match (found.next(), found.next()) {
            (Some(code), None) => Self::Code(code.to_owned()),
            // A code that was changed where its blanks are.
            (Some(_), Some(_)) if whole.is_empty() && is_like_code(text) => {
                Self::Code(text.to_owned())
            }
            (Some(_), Some(_)) => Self::Several,
            (None, _) => Self::Code(plain.trim().to_owned()),
        }
    }
}

/// The codes that some of these words make, one after another.
fn codes_of(words: &[&str]) -> BTreeSet<String> {
    let longest = if words.len() > MOST_WORDS { 1 } else { words.len() };
    let mut codes = BTreeSet::new();
    for begin in 0..words.len() {
        // The first sign of a code is that of its version.
        if !canonical(words[begin]).starts_with('0') {
            continue;
        }
        let mut joined = String::new();
        for word in words[begin..].iter().take(longest) {
            joined.push_str(&canonical(word));
            if is_whole(&joined) {
                codes.insert(joined.clone());
            }
        }
    }
    codes
}

/// Whether a text is empty, or says that nothing is there: `-`, `n/a`.
fn says_nothing(text: &str) -> bool {
    let bare = text.trim().trim_start_matches('#').to_ascii_lowercase();
    !text.chars().any(char::is_alphanumeric) || bare == "n/a" || bare == "na"
}

/// A text without the tags and the character references of HTML, each of which is a blank.
fn without_markup(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find(['<', '&']) {
        let (before, from) = rest.split_at(at);
        plain.push_str(before);
        let length = if from.starts_with('<') { tag(from) } else { reference(from) };
        plain.push_str(if length.is_some() { " " } else { &from[..1] });
        rest = &from[length.unwrap_or(1)..];
    }
    plain + rest
}

/// How long the tag is that a text begins with. The name of a tag begins with a letter, and a code with a digit.
fn tag(text: &str) -> Option<usize> {
    let name = text[1..].trim_start_matches('/');
    let end = text.find('>').filter(|_| name.starts_with(|sign: char| sign.is_ascii_alphabetic()));
    end.filter(|&end| !is_like_code(&text[1..end])).map(|end| end + 1)
}

/// How long the character reference is that a text begins with.
fn reference(text: &str) -> Option<usize> {
    const LONGEST: usize = 10;
    let end = text.find(';').filter(|&end| end <= LONGEST)?;
    let name = text[1..end].trim_start_matches('#');
    let is_name = !name.is_empty() && name.chars().all(|sign| sign.is_ascii_alphanumeric());
    is_name.then_some(end + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Codes of an exercise of the project, for different seeds.
    fn codes() -> [String; 2] {
        let text = std::fs::read_to_string("examples/exercises/01-possible-goals.json").unwrap();
        let exercise = mo_copp::exercise::Exercise::parse(&text).unwrap();
        [3, 4].map(|seed| {
            let variant = exercise.variant(seed).unwrap();
            exercise.code(&variant, variant.solution(), mo_copp::exercise::Tally::default())
        })
    }

    #[test]
    fn the_one_code_is_found_in_what_stands_around_it() {
        let [code, _] = codes();
        let expected = canonical(&code);
        let blanks = code.replace('-', " ");
        let (small, spaced) = (code.to_lowercase(), code.replace('-', "\u{2013}\n"));
        for text in [
            code.clone(),
            format!("=\"{code}\""),
            format!("'{code}"),
            format!("\"{code}\""),
            format!("\u{201e}{code}\u{201c}"),
            format!("{code}."),
            format!("code: {code}"),
            format!("Code {code}"),
            format!("code:{small}"),
            format!("My code is {blanks}, I think."),
            format!("<p>{code}</p>"),
            format!("<p dir=\"ltr\">{code}<br></p>"),
            format!("<{code}>"),
            format!("{code}&nbsp;"),
            format!("&lt;{}&gt;", code.replace('-', "&#8209;")),
            format!("{code}\n{code}"),
            format!("{spaced} (Ada)"),
        ] {
            let Cell::Code(found) = Cell::read(&text) else { panic!("{text}") };
            assert_eq!(canonical(&found), expected, "{text}");
        }
    }

    #[test]
    fn of_two_codes_none_is_chosen() {
        let [code, other] = codes();
        let edited = code.replacen('0', "9", 1);
        for text in [
            format!("{code}\n{other}"),
            format!("{code} or {other}"),
            format!("{edited}, {other}"),
            format!("{edited} {other}"),
        ] {
            assert_eq!(Cell::read(&text), Cell::Several, "{text}");
        }
    }

    #[test]
    fn what_stands_for_nothing_is_empty_and_other_texts_are_no_codes() {
        for text in ["", " ", "-", "\u{2013}", "n/a", "N/A", "#N/A", "&nbsp;", "<p></p>", "?", "&"]
        {
            assert_eq!(Cell::read(text), Cell::Empty, "{text}");
        }
        for text in ["done", "G1, G2", "4", "1 < 2 & 3 > 2; <", "a <b"] {
            let Cell::Code(found) = Cell::read(text) else { panic!("{text}") };
            assert!(!is_like_code(&found) && !is_whole(&found), "{text}");
        }
    }

    #[test]
    fn a_sign_within_a_code_is_not_passed_over() {
        let [code, _] = codes();
        for place in 1..code.len() {
            for sign in ["!", "=", "<p>", "u", "7", "&amp;"] {
                let Cell::Code(found) =
                    Cell::read(&format!("{}{sign}{}", &code[..place], &code[place..]))
                else {
                    continue;
                };
                assert!(!is_whole(&found) || sign.len() > 1, "{place} {sign}");
            }
        }
    }
}
