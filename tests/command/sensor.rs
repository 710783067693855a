//! `mo-copp sensor`, `completions` and `manual`.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::mo_copp;

fn logistics() -> String {
    fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/examples/blocksworld.json")).unwrap()
}

#[test]
fn a_table_that_is_written_and_read_again_changes_no_symbol() {
    let document = logistics();
    let table = mo_copp(&document, &["sensor", "-", "--observer", "cooperative"]);
    assert_eq!(table.code, 0, "{}", table.err);
    assert!(table.out.starts_with("operator,symbol\n("), "{}", table.out);
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("table.csv");
    fs::write(&path, &table.out).unwrap();
    let path = path.to_str().unwrap();
    let args = ["sensor", "-", "--observer", "cooperative", "--table", path];
    let changed = mo_copp(&document, &args);
    assert_eq!(changed.code, 0, "{}", changed.err);
    let again = mo_copp(&changed.out, &["sensor", "-", "--observer", "cooperative"]);
    assert_eq!(again.out, table.out);
    let rows = table.out.lines().count() - 1;
    let read: Value = serde_json::from_str(&changed.out).unwrap();
    let listed = &read["observers"]["cooperative"]["sensor"]["table"];
    assert_eq!(listed.as_array().unwrap().len(), rows);
    // With a row less the rest needs a symbol.
    let less: String = table.out.lines().take(rows).map(|line| line.to_owned() + "\r\n").collect();
    fs::write(path, less).unwrap();
    let refused = mo_copp(&document, &args);
    assert_eq!(refused.code, 2);
    assert!(refused.err.contains("found no symbol for"), "{}", refused.err);
    let filled = mo_copp(&document, &[&args[..], &["--otherwise", "{name}"]].concat());
    assert_eq!(filled.code, 0, "{}", filled.err);
}

#[test]
fn the_exercise_of_a_document_is_kept() {
    let mut document: Value = serde_json::from_str(&logistics()).unwrap();
    document["exercise"] = serde_json::json!({"kind": "best", "title": "Towers"});
    let table = mo_copp(&document.to_string(), &["sensor", "-", "--observer", "adversarial"]);
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("kept.csv");
    fs::write(&path, &table.out).unwrap();
    let args = ["sensor", "-", "--observer", "adversarial", "--table", path.to_str().unwrap()];
    let changed = mo_copp(&document.to_string(), &args);
    assert_eq!(changed.code, 0, "{}", changed.err);
    let read: Value = serde_json::from_str(&changed.out).unwrap();
    assert_eq!(read["exercise"], document["exercise"]);
}

#[test]
fn tables_that_are_none() {
    let document = logistics();
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("bad.csv");
    for (text, expected) in [
        (
            "action,symbol\n",
            "bad.csv:1:1: found \"action,symbol\", expected the line operator,symbol",
        ),
        ("operator,symbol\n(a b)\n", "bad.csv:2:1: found 1 fields or no symbol"),
        ("operator,symbol\n(a b),x\n", "undeclared action \"a\""),
    ] {
        fs::write(&path, text).unwrap();
        let args = ["sensor", "-", "--observer", "adversarial", "--table", path.to_str().unwrap()];
        let ran = mo_copp(&document, &args);
        assert_eq!(ran.code, 2);
        assert!(ran.err.contains(expected), "{}", ran.err);
    }
    let ran = mo_copp(&document, &["sensor", "-", "--observer", "nobody"]);
    assert!(ran.err.contains("expected adversarial or cooperative"), "{}", ran.err);
    let grid = mo_copp("", &["generate", "gridworld", "--seed", "1"]).out;
    let ran = mo_copp(&grid, &["sensor", "-", "--observer", "adversarial"]);
    assert!(ran.err.contains("found a document of another format, expected pddl"), "{}", ran.err);
}

#[test]
fn completions_and_manual_know_every_command() {
    let commands = ["solve", "trace", "encode", "plan", "generate", "import", "sensor"];
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let ran = mo_copp("", &["completions", shell]);
        assert_eq!(ran.code, 0, "{}", ran.err);
        for command in commands {
            assert!(ran.out.contains(command), "{shell}: {command}");
        }
    }
    let page = mo_copp("", &["manual"]);
    assert!(page.out.starts_with(".ie") && page.out.contains(".SH SUBCOMMANDS"), "{}", page.out);
    for command in commands {
        let page = mo_copp("", &["manual", command]);
        assert_eq!(page.code, 0, "{}", page.err);
        assert!(page.out.contains(&format!("mo\\-copp\\-{command}")), "{}", page.out);
    }
    assert_eq!(mo_copp("", &["manual", "juggle"]).code, 2);
}
