//! The paths that a file of Rust uses, from the root of the crate: by `use` in any of its forms, and in place.

use std::collections::{BTreeMap, BTreeSet};

/// The names of a path.
pub type Names = Vec<String>;

/// The words of code: names, `::`, and single signs. Comments, texts and characters are left out.
fn words(code: &str) -> Vec<String> {
    let letters: Vec<char> = code.chars().collect();
    let at = |place: usize| letters.get(place).copied().unwrap_or(' ');
    let is_name = |letter: char| letter.is_alphanumeric() || letter == '_';
    let (mut words, mut place) = (Vec::new(), 0);
    while place < letters.len() {
        let begin = place;
        let letter = letters[place];
        place += 1;
        match letter {
            '/' if at(place) == '/' => {
                while place < letters.len() && at(place) != '\n' {
                    place += 1;
                }
            }
            '"' => {
                while place < letters.len() && at(place) != '"' {
                    place += 1 + usize::from(at(place) == '\\');
                }
                place += 1;
            }
            // A raw text.
            'r' if at(place) == '"' || at(place) == '#' && matches!(at(place + 1), '"' | '#') => {
                let signs = letters[place..].iter().take_while(|sign| **sign == '#').count();
                let end: Vec<char> = format!("\"{}", "#".repeat(signs)).chars().collect();
                place += signs + 1;
                while place < letters.len() && !letters[place..].starts_with(&end) {
                    place += 1;
                }
                place += end.len();
            }
            // A character; of a lifetime the sign alone.
            '\'' if at(place) == '\\' => {
                place += 2;
                while place < letters.len() && at(place) != '\'' {
                    place += 1;
                }
                place += 1;
            }
            '\'' if at(place + 1) == '\'' => place += 2,
            ':' if at(place) == ':' => {
                place += 1;
                words.push("::".to_owned());
            }
            letter if is_name(letter) => {
                while is_name(at(place)) {
                    place += 1;
                }
                words.push(letters[begin..place].iter().collect());
            }
            letter if letter.is_whitespace() => {}
            letter => words.push(letter.to_string()),
        }
    }
    words
}

fn is_name(word: &str) -> bool {
    word.starts_with(|letter: char| letter.is_alphabetic() || letter == '_')
}

/// The words without items that are there for tests alone.
fn without_tests(words: &[String]) -> Vec<String> {
    let mark = ["#", "[", "cfg", "(", "test", ")", "]"];
    let (mut kept, mut place) = (Vec::new(), 0);
    while place < words.len() {
        if !words[place..].iter().take(mark.len()).eq(mark.iter()) {
            kept.push(words[place].clone());
            place += 1;
            continue;
        }
        // To the end of the item: a `;`, a `,`, or the brace that closes it.
        let mut depth = 0;
        place += mark.len();
        while place < words.len() {
            let word = words[place].as_str();
            place += 1;
            depth += i32::from(matches!(word, "{" | "(" | "["));
            depth -= i32::from(matches!(word, "}" | ")" | "]"));
            if depth == 0 && matches!(word, ";" | "," | "}") {
                break;
            }
        }
    }
    kept
}

/// Reads the tree of a `use` from `place` on: each path in it with the name that it has here. Returns where it ends.
fn tree(
    words: &[String],
    mut place: usize,
    before: &[String],
    found: &mut Vec<(Names, String)>,
) -> usize {
    let mut path = before.to_vec();
    while let Some(word) = words.get(place) {
        match word.as_str() {
            "::" => place += 1,
            "{" => {
                place += 1;
                while words.get(place).is_some_and(|word| word != "}") {
                    place = tree(words, place, &path, found);
                    place += usize::from(words.get(place).is_some_and(|word| word == ","));
                }
                return place + 1;
            }
            "as" => {
                found.push((path, words.get(place + 1).cloned().unwrap_or_default()));
                return place + 2;
            }
            "self" if !path.is_empty() => place += 1,
            word if word == "*" || is_name(word) => {
                path.push(word.to_owned());
                place += 1;
            }
            _ => break,
        }
    }
    let name = path.last().cloned().unwrap_or_default();
    found.push((path, name));
    place
}

/// The path from the root of the crate; none where it begins with a name that is not of the crate.
fn resolved(path: &[String], module: &[String], named: &BTreeMap<String, Names>) -> Option<Names> {
    let (first, mut rest) = path.split_first()?;
    let mut whole = match first.as_str() {
        "crate" | "mo_copp" => Vec::new(),
        "self" => module.to_vec(),
        "super" => module.split_last()?.1.to_vec(),
        name => named.get(name)?.clone(),
    };
    while rest.first().is_some_and(|name| name == "super") {
        whole.pop();
        rest = &rest[1..];
    }
    whole.extend_from_slice(rest);
    Some(whole)
}

/// The paths from the root of the crate that the code of a module uses; one that ends with `*` stands for all names there.
/// What is there for tests alone does not count.
pub fn paths(code: &str, module: &[String]) -> BTreeSet<Names> {
    let words = without_tests(&words(code));
    let (mut imported, mut others) = (Vec::new(), Vec::new());
    let mut place = 0;
    while place < words.len() {
        if words[place] == "use" {
            place = tree(&words, place + 1, &[], &mut imported);
            continue;
        }
        let begins = is_name(&words[place])
            && place
                .checked_sub(1)
                .is_none_or(|before| !matches!(words[before].as_str(), "::" | "."));
        let mut path = vec![words[place].clone()];
        place += 1;
        while begins
            && words.get(place).is_some_and(|word| word == "::")
            && words.get(place + 1).is_some_and(|word| is_name(word))
        {
            path.push(words[place + 1].clone());
            place += 2;
        }
        if path.len() > 1 {
            others.push(path);
        }
    }
    let mut named = BTreeMap::new();
    let mut found = BTreeSet::new();
    for (path, name) in imported {
        if let Some(whole) = resolved(&path, module, &named) {
            named.insert(name, whole.clone());
            found.insert(whole);
        }
    }
    found.extend(others.iter().filter_map(|path| resolved(path, module, &named)));
    found
}

#[cfg(test)]
mod tests {
    use super::{Names, paths};

    fn names(path: &str) -> Names {
        path.split("::").map(str::to_owned).collect()
    }

    fn used(code: &str) -> Vec<String> {
        let module = names("solver::optimiser::search");
        paths(code, &module).iter().map(|path| path.join("::")).collect()
    }

    #[test]
    fn every_form_of_use_is_seen() {
        let cases: [(&str, &[&str]); 14] = [
            ("use crate::plan::Plan;", &["plan::Plan"]),
            ("use mo_copp::plan;", &["plan"]),
            (
                "use crate::{solver::explorer::X, task::{self, State}};",
                &["solver::explorer::X", "task", "task::State"],
            ),
            ("use crate::{\n    plan::{Plan, next},\n};", &["plan::Plan", "plan::next"]),
            (
                "use crate::solver; fn f() { solver::explorer::go() }",
                &["solver", "solver::explorer::go"],
            ),
            ("use crate::solver as s; type T = s::ip::T;", &["solver", "solver::ip::T"]),
            ("use super::*;", &["solver::optimiser::*"]),
            ("use super::super::*;", &["solver::*"]),
            ("use super::super::{ip::A, baseline};", &["solver::baseline", "solver::ip::A"]),
            ("use self::bounds::B;", &["solver::optimiser::search::bounds::B"]),
            (
                "fn f(x: &crate::plan::Plan<'_>) -> super::queue::Q { x }",
                &["plan::Plan", "solver::optimiser::queue::Q"],
            ),
            ("// use crate::ip;\nconst T: &str = \"use crate::ip;\"; const C: char = '\"';", &[]),
            (
                "#[cfg(test)]\nmod tests { use crate::ip::X; }\nuse crate::plan::Plan;",
                &["plan::Plan"],
            ),
            ("#[cfg(test)]\nmod tests;\nuse crate::plan::Plan;", &["plan::Plan"]),
        ];
        for (code, expected) in cases {
            assert_eq!(used(code), expected, "{code}");
        }
    }
}
