//! Errors stand at their place in the text, in lines and columns.

use mo_copp::document::{DocumentError, Place};
use mo_copp::domain::Document;
use proptest::prelude::*;

use super::fuzz::{base, runner};

/// The place of the error of a text, and what stands there.
fn marked(text: &str) -> (String, Place) {
    let made = Document::parse(text).and_then(|document| document.problem());
    let place = made.err().map(|error| error.place(text)).expect("an error");
    (stretch(text, place), place)
}

/// What stands at a place; panics where it is not inside of the text.
fn stretch(text: &str, Place { line, column, length }: Place) -> String {
    let line: Vec<char> = text.split('\n').nth(line - 1).unwrap().chars().collect();
    line[column - 1..column - 1 + length].iter().collect()
}

const GRID: &str = r#"{
  "format": "gridworld", "width": 4, "height": 3,
  "start": [0, 2],
  "goals": [
    {"name": "Zürich 🏔 \"[1].cell\"", "cell": [3, 0]},
    {"name": "b", "cell": [0, 0]}
  ],
  "true_goal": "b",
  "observers": {
    "adversarial": {"sensor": {"north": "n", "south": "n", "east": "n", "west": "n"}},
    "cooperative": {"sensor": {"north": "n", "south": "n", "east": "n", "west": "n"}}
  }
}"#;

#[test]
fn values_and_keys_are_found() {
    let table = [
        // A value, whatever brackets and quotation marks stand in texts before it.
        ("\"cell\": [0, 0]", "\"cell\": [9, 0]", "[9, 0]", 6, 27),
        ("[3, 0]", "[3]", "[3]", 5, 47),
        ("\"true_goal\": \"b\"", "\"true_goal\": \"c\"", "\"c\"", 8, 16),
        // A missing key: the object that lacks it, which goes on in further lines.
        ("\"start\": [0, 2],", "", "{", 1, 1),
        (", \"cell\": [0, 0]", "", "{\"name\": \"b\"}", 6, 5),
        // A key that nobody knows, also written with an escape, and one given twice.
        ("\"height\": 3", "\"height\": 3, \"depth\": 2", "\"depth\"", 2, 51),
        ("\"sensor\"", "\"sensor\": {}, \"\\u0073ensors\"", "\"\\u0073ensors\"", 10, 35),
        ("\"height\"", "\"width\"", "\"", 2, 44),
        // No JSON: characters are counted, not bytes.
        ("\"cell\": [3, 0]", "\"cell\": oops", "o", 5, 47),
        // The end of the text is where more should be.
        ("\n}", "", "", 12, 4),
    ];
    for (old, new, expected, line, column) in table {
        let text = GRID.replacen(old, new, 1);
        assert_ne!(text, GRID, "{old}");
        let (found, place) = marked(&text);
        assert_eq!((found.as_str(), place.line, place.column), (expected, line, column), "{new}");
    }
}

#[test]
fn a_name_with_dots_and_brackets_is_followed() {
    let text = r#"{"a": {"b": 1}, "a.b": 2, "a.b[0]": {"c]": [true, "x"]}}"#;
    let place = |path: &str| stretch(text, DocumentError::invalid(path, "", "").place(text));
    assert_eq!(place("a.b[0].c][1]"), "\"x\"");
    assert_eq!(place("a.b[0].c][2]"), "[true, \"x\"]");
    assert_eq!(place("a.b"), "1");
    assert_eq!(place("document"), text);
    assert_eq!(place("nothing.of.that"), text);
}

/// A PDDL document whose domain is a list of lines or one text; the rest is read before them.
fn with_domain(domain: &str) -> String {
    format!(
        r#"{{"format": "pddl", "true_goal": "a", "goals": [{{"name": "a", "condition": "(p)"}}, {{"name": "b", "condition": "(p)"}}],
"observers": {{"adversarial": {{"sensor": "x"}}, "cooperative": {{"sensor": "x"}}}},
"problem": "(define (problem q) (:domain d) (:init))",
"domain": {domain}}}"#
    )
}

#[test]
fn pddl_is_found_inside_of_its_texts() {
    let table = [
        ("[\"(define (domain d)\",\n\"  (:predicates (p))\",\n\" (:axiom))\"]", "(", 6, 3),
        ("\"(define (domain d)\\n (:types a - \\\"b))\"", "\\\"b", 4, 45),
        ("\"(define (domain d)\\n ; 🏔 \\ud83c\\udfd4\\n(:predicates (p - q)))\"", "-", 4, 67),
        // The end of the text, where something is missing.
        ("[\"(define (domain d)\",\n\"(:predicates (p))\"]", "", 5, 19),
        ("\"(define (domain d)\\n\"", "", 4, 32),
    ];
    for (domain, expected, line, column) in table {
        let text = with_domain(domain);
        let (found, place) = marked(&text);
        assert_eq!(
            (found.as_str(), place.line, place.column),
            (expected, line, column),
            "{domain}"
        );
    }
}

/// Whatever is done to a document, the place of its error is inside of the text.
#[test]
fn every_place_is_inside_of_the_text() {
    let edit = (any::<prop::sample::Index>(), 0..5_u8, any::<char>());
    let strategy = (base(), prop::collection::vec(edit, 1..4));
    let errors = std::cell::Cell::new(0);
    runner(6, 10_000)
        .run(&strategy, |(base, edits)| {
            let mut characters: Vec<char> = base.chars().collect();
            for (place, kind, character) in edits {
                let place = place.index(characters.len());
                match kind {
                    0 => drop(characters.remove(place)),
                    1 => characters.insert(place, characters[place]),
                    2 => characters[place] = character,
                    3 => characters.insert(place, '\n'),
                    _ => characters.truncate(place.max(9)),
                }
            }
            let text: String = characters.iter().collect();
            if let Err(error) = Document::parse(&text).and_then(|document| document.problem()) {
                stretch(&text, error.place(&text));
                errors.set(errors.get() + 1);
            }
            Ok(())
        })
        .unwrap();
    assert!(errors.get() > 4000, "{}", errors.get());
}

/// Also of errors that do not belong to the text, as when it was changed meanwhile.
#[test]
fn places_in_other_texts_are_inside_of_them() {
    let piece = prop::sample::select(vec![
        "{", "}", "[", "]", ",", ":", "\"a\"", "\"a.b\"", "\"\\u00", "\\ud83c", "\"", "\\", "é",
        "🏔", "1", "\n", " ", "null",
    ]);
    let step = prop::sample::select(vec!["a", ".a", ".b", "[0]", "[1]", "[", "", ".", "é"]);
    let texts = prop::collection::vec(piece, 0..30);
    let paths = prop::collection::vec(step, 0..5);
    runner(7, 20_000)
        .run(
            &(texts, paths, 0..5_usize, 0..9_usize, 0..4_u8),
            |(pieces, steps, line, column, kind)| {
                let (text, path) = (pieces.concat(), steps.concat());
                let (found, expected) = (String::new(), String::new());
                let error = match kind {
                    0 => DocumentError::Syntax { line, column, found, expected },
                    1 => DocumentError::Pddl { path, line, column, found, expected },
                    2 => DocumentError::UnknownKey { path, key: "a".to_owned(), known: expected },
                    _ => DocumentError::Invalid { path, found, expected },
                };
                stretch(&text, error.place(&text));
                Ok(())
            },
        )
        .unwrap();
}
