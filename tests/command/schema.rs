//! `mo-copp schema`: every document of the project is valid under it, changed ones are not.
//!
//! `MO_COPP_JSONSCHEMA_PYTHON` names a Python with the package jsonschema; `npm test` sets it.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

use crate::mo_copp;

const PYTHON: &str = "MO_COPP_JSONSCHEMA_PYTHON";

fn schema() -> Value {
    let ran = mo_copp("", &["schema"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    serde_json::from_str(&ran.out).unwrap()
}

#[test]
fn the_schema_knows_every_format_and_no_other_key() {
    let schema = schema();
    let formats: Vec<&str> = schema["oneOf"]
        .as_array()
        .unwrap()
        .iter()
        .map(|format| {
            assert_eq!(format["additionalProperties"], false);
            assert!(format["required"].as_array().unwrap().contains(&"format".into()));
            format["properties"]["format"]["const"].as_str().unwrap()
        })
        .collect();
    let expected = ["gridworld", "box-pushing", "recycling-robot", "delivery", "explicit", "pddl"];
    assert_eq!(formats, expected);
}

#[test]
fn an_independent_validator_takes_every_document_and_no_broken_one() {
    let Some(python) = std::env::var_os(PYTHON) else {
        // Past the harness, which shows what a test prints only where it fails.
        let why = "does not name a Python with the package jsonschema";
        writeln!(std::io::stderr(), "schema test skipped: {PYTHON} {why}").unwrap();
        return;
    };
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("schema.json");
    fs::write(&file, schema().to_string()).unwrap();
    let mut documents = Vec::new();
    for folder in ["examples", "examples/exercises", "www/problems"] {
        let entries = fs::read_dir(root.join(folder)).unwrap().map(|entry| entry.unwrap().path());
        documents.extend(entries.filter(|path| path.extension().is_some_and(|e| e == "json")));
    }
    assert!(documents.len() > 20);
    let script = root.join("tests/validate_schema.py");
    let output = Command::new(python).arg(script).arg(file).args(&documents).output().unwrap();
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{errors}");
}
