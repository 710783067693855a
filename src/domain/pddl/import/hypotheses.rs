//! Hypotheses: lines of atoms, in parentheses or between commas.

use rustc_hash::FxHashMap;

use super::{ImportError, ImportFile};
use crate::pddl::{MAX_DEPTH, PddlError};

/// The most lines with hypotheses. A document has fewer candidate goals.
const MAX_LINES: usize = 100_000;

/// A line of literals.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Line {
    /// Its number in the file, from 1.
    pub number: usize,
    /// Each literal in small letters, one blank between words.
    pub literals: Vec<String>,
    /// All of them as one condition.
    pub text: String,
    /// The column from which each character of the condition comes.
    columns: Vec<usize>,
}

/// A candidate goal.
#[derive(Debug)]
pub(super) struct Hypothesis {
    /// Its number among all, from 1.
    number: usize,
    pub line: Line,
    /// The position of an earlier one that says the same.
    pub same_as: Option<usize>,
}

impl Hypothesis {
    /// The name of the candidate goal.
    pub(super) fn name(&self) -> String {
        format!("G{}", self.number)
    }
}

impl Line {
    /// The literals in order, each once: lines with the same ones say the same.
    pub(super) fn literals(&self) -> Vec<&str> {
        let mut literals: Vec<&str> = self.literals.iter().map(String::as_str).collect();
        literals.sort_unstable();
        literals.dedup();
        literals
    }

    /// An error of PDDL in the condition, at its place in the file.
    pub(super) fn wrong(&self, file: &str, error: &PddlError) -> ImportError {
        let column = self.columns.get(error.column.saturating_sub(1));
        ImportError::Place {
            file: file.to_owned(),
            line: self.number,
            column: column.or(self.columns.last()).copied().unwrap_or(1),
            found: error.found.clone(),
            expected: error.expected.clone(),
        }
    }
}

/// The hypotheses of a file, and notes on those that are left out.
pub(super) fn hypotheses(file: &ImportFile) -> Result<(Vec<Hypothesis>, Vec<String>), ImportError> {
    let mut known: FxHashMap<Vec<String>, usize> = FxHashMap::default();
    let mut all: Vec<Hypothesis> = Vec::new();
    let mut notes = Vec::new();
    for line in lines(file)? {
        let key = line.literals().into_iter().map(str::to_owned).collect();
        let position = all.len();
        let first = *known.entry(key).or_insert(position);
        let same_as = (first < position).then_some(first);
        if let Some(first) = same_as {
            let earlier = all[first].line.number;
            notes.push(format!(
                "{}:{}: the hypothesis of line {earlier} for a second time is left out",
                file.name, line.number
            ));
        }
        all.push(Hypothesis { number: position + 1, line, same_as });
    }
    Ok((all, notes))
}

/// The lines of a file that hold anything. `;` begins a comment.
pub(super) fn lines(file: &ImportFile) -> Result<Vec<Line>, ImportError> {
    let text = file.text.trim_start_matches('\u{feff}');
    let mut found = Vec::new();
    for (number, line) in (1..).zip(text.split(['\n'])) {
        let line = line.split(';').next().unwrap_or_default();
        let wrong = |column: usize, what: String, expected: &str| ImportError::Place {
            file: file.name.clone(),
            line: number,
            column,
            found: what,
            expected: expected.to_owned(),
        };
        if line.trim().is_empty() {
            continue;
        }
        if found.len() == MAX_LINES {
            return Err(wrong(1, format!("more than {MAX_LINES} lines"), "at most that"));
        }
        let literals = if line.contains(['(', ')']) { listed(line) } else { Ok(bare(line)) };
        let literals =
            literals.map_err(|(column, what, expected)| wrong(column, what, expected))?;
        if literals.is_empty() {
            continue;
        }
        found.push(joined(number, literals));
    }
    Ok(found)
}

/// A literal with the column of each of its characters.
type Literal = Vec<(char, usize)>;

type Wrong = (usize, String, &'static str);

/// Atoms between commas, without parentheses.
fn bare(line: &str) -> Vec<Literal> {
    let mut all = Vec::new();
    let mut words: Literal = Vec::new();
    let mut close = |words: &mut Literal| {
        while words.last().is_some_and(|(character, _)| *character == ' ') {
            words.pop();
        }
        if let (Some(&(_, first)), Some(&(_, last))) = (words.first(), words.last()) {
            words.insert(0, ('(', first));
            words.push((')', last));
            all.push(std::mem::take(words));
        }
        words.clear();
    };
    for (column, character) in (1..).zip(line.chars()) {
        match character {
            ',' => close(&mut words),
            _ if character.is_whitespace() => {
                if words.last().is_some_and(|(last, _)| *last != ' ') {
                    words.push((' ', column));
                }
            }
            _ => words.push((character.to_ascii_lowercase(), column)),
        }
    }
    close(&mut words);
    all
}

/// Expressions one after the other, with commas or without; `(and …)` stands for what it holds.
fn listed(line: &str) -> Result<Vec<Literal>, Wrong> {
    let mut all: Vec<Literal> = Vec::new();
    let mut literal: Literal = Vec::new();
    let mut depth = 0_usize;
    // How many parentheses belong to an `and` around everything.
    let mut around = 0;
    let characters: Vec<(usize, char)> = (1..).zip(line.chars()).collect();
    let mut at = 0;
    while let Some(&(column, character)) = characters.get(at) {
        at += 1;
        match character {
            '(' => {
                let word: String = characters[at..]
                    .iter()
                    .map(|(_, character)| *character)
                    .skip_while(|character| character.is_whitespace())
                    .take_while(|character| character.is_alphanumeric())
                    .collect();
                if depth == around && word.eq_ignore_ascii_case("and") {
                    around += 1;
                    depth += 1;
                    at +=
                        characters[at..].iter().take_while(|(_, c)| c.is_whitespace()).count() + 3;
                    continue;
                }
                depth += 1;
                if depth > MAX_DEPTH {
                    let found = format!("parentheses nested more than {MAX_DEPTH} deep");
                    return Err((column, found, "at most that"));
                }
                literal.push(('(', column));
            }
            ')' => {
                if depth == 0 {
                    return Err((
                        column,
                        "\")\"".to_owned(),
                        "a parenthesis only where one is open",
                    ));
                }
                depth -= 1;
                if depth < around {
                    around -= 1;
                    continue;
                }
                if literal.last().is_some_and(|(last, _)| *last == ' ') {
                    literal.pop();
                }
                literal.push((')', column));
                if depth == around {
                    all.push(std::mem::take(&mut literal));
                }
            }
            ',' | ' ' | '\t' | '\r' => {
                if literal.last().is_some_and(|(last, _)| !matches!(last, ' ' | '(')) {
                    literal.push((' ', column));
                }
            }
            _ if character.is_whitespace() => {}
            _ if depth == around => {
                let found = format!("{character:?} between atoms");
                return Err((column, found, "atoms in parentheses, as in (on a b), (clear c)"));
            }
            _ => literal.push((character.to_ascii_lowercase(), column)),
        }
    }
    if depth > 0 {
        let expected = "\")\" for each \"(\" of the line";
        return Err((characters.len() + 1, "the end of the line".to_owned(), expected));
    }
    Ok(all)
}

/// The line of these literals.
fn joined(number: usize, literals: Vec<Literal>) -> Line {
    let texts: Vec<String> = literals
        .iter()
        .map(|literal| literal.iter().map(|(character, _)| *character).collect())
        .collect();
    let (first, last) = match (literals.first(), literals.last()) {
        (Some(first), Some(last)) => (
            first.first().map_or(1, |(_, column)| *column),
            last.last().map_or(1, |(_, column)| *column),
        ),
        _ => (1, 1),
    };
    let mut all: Literal = Vec::new();
    let several = literals.len() > 1;
    if several {
        all.extend("(and".chars().map(|character| (character, first)));
    }
    for literal in literals {
        if several {
            let column = literal.first().map_or(1, |(_, column)| *column);
            all.push((' ', column));
        }
        all.extend(literal);
    }
    if several {
        all.push((')', last));
    }
    let (text, columns) = all.into_iter().unzip();
    Line { number, literals: texts, text, columns }
}
