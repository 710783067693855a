//! The template of a problem: its goal is a hypothesis.

use super::{ImportError, ImportFile, tidy};

const MARK: &str = "<hypothesis>";

const EXPECTED: &str = "(:goal (and <HYPOTHESIS>))";

/// A template, read.
#[derive(Debug)]
pub(super) struct Template {
    /// The problem without its goal. Everything else stands where it stood.
    pub problem: String,
    /// The goal before and after the hypothesis, where there is more in it than that.
    around: Option<(String, String)>,
}

impl Template {
    /// Takes the goal out of the problem.
    pub(super) fn read(file: &ImportFile) -> Result<Self, ImportError> {
        let text = tidy(&file.text);
        let small = text.to_ascii_lowercase();
        let wrong = |offset: usize, found: &str, expected: &str| {
            let before = &text[..offset];
            let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
            ImportError::Place {
                file: file.name.clone(),
                line: before.matches('\n').count() + 1,
                column: before[line_start..].chars().count() + 1,
                found: found.to_owned(),
                expected: expected.to_owned(),
            }
        };
        // What stands in a comment is no part of the problem.
        let code = |offset: usize| {
            let line = small[..offset].rfind('\n').map_or(0, |newline| newline + 1);
            !small[line..offset].contains(';')
        };
        let mut marks = small.match_indices(MARK).map(|(at, _)| at).filter(|&at| code(at));
        let goals = small.match_indices(":goal").map(|(at, _)| at);
        let goal = goals.filter(|&at| code(at)).last();
        let Some(mark) = marks.next() else {
            let at = goal.unwrap_or(text.len());
            let found = if goal.is_some() { "a goal without <HYPOTHESIS>" } else { "no goal" };
            return Err(wrong(at, found, EXPECTED));
        };
        if let Some(second) = marks.next() {
            return Err(wrong(second, "<HYPOTHESIS> for the second time", "one"));
        }
        let goal = goal.filter(|&goal| goal < mark);
        let Some(goal) = goal else {
            return Err(wrong(mark, "<HYPOTHESIS> outside of a goal", EXPECTED));
        };
        let begin = text[..goal].trim_end();
        let Some(begin) = begin.strip_suffix('(').map(str::len) else {
            return Err(wrong(goal, ":goal without a parenthesis before it", EXPECTED));
        };
        let Some(end) = closing(&text, begin) else {
            return Err(wrong(text.len(), "the end of the text", "\")\" for that of the goal"));
        };
        if end < mark {
            return Err(wrong(mark, "<HYPOTHESIS> outside of the goal", EXPECTED));
        }
        let inner = &text[goal + ":goal".len()..end];
        let bare: String = inner.to_ascii_lowercase().split_whitespace().collect();
        let around = if bare == format!("(and{MARK})") || bare == MARK {
            None
        } else {
            let offset = mark - (goal + ":goal".len());
            Some((
                inner[..offset].trim().to_owned(),
                inner[offset + MARK.len()..].trim().to_owned(),
            ))
        };
        // Line ends stay, so that errors have the places of the file.
        let blank: String =
            text[begin..=end].chars().filter(|character| *character == '\n').collect();
        let problem = format!("{}{blank}{}", &text[..begin], &text[end + 1..]);
        Ok(Self { problem, around })
    }

    /// The condition of a hypothesis.
    pub(super) fn condition(&self, hypothesis: &str) -> String {
        match &self.around {
            None => hypothesis.to_owned(),
            Some((before, after)) => {
                let whole = format!("{before} {hypothesis} {after}");
                whole.split_whitespace().collect::<Vec<_>>().join(" ")
            }
        }
    }
}

/// The parenthesis that closes the one at `begin`.
fn closing(text: &str, begin: usize) -> Option<usize> {
    let mut depth = 0_usize;
    let mut comment = false;
    for (at, byte) in text.bytes().enumerate().skip(begin) {
        match byte {
            b'\n' => comment = false,
            _ if comment => {}
            b';' => comment = true,
            b'(' => depth += 1,
            b')' => {
                depth -= 1;
                if depth == 0 {
                    return Some(at);
                }
            }
            _ => {}
        }
    }
    None
}
