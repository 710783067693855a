//! Files of records: going on after a stop anywhere, and what is refused.

use std::path::Path;

use mo_copp::experiment::{ExperimentError, Shard};

use super::{fig3, folder, open, records, work};

const WHOLE: Shard = Shard::WHOLE;

#[test]
fn a_file_torn_at_any_byte_of_its_last_line_is_completed() {
    let setting = fig3(1);
    let folder = folder("torn");
    let whole = folder.join("whole.jsonl");
    work(&whole, &setting, WHOLE, 1);
    let expected = records(&whole, &setting, WHOLE);
    let bytes = std::fs::read(&whole).unwrap();
    let last = bytes[..bytes.len() - 1].iter().rposition(|&byte| byte == b'\n').unwrap() + 1;
    let path = folder.join("torn.jsonl");
    for end in last..=bytes.len() {
        std::fs::write(&path, &bytes[..end]).unwrap();
        let done = work(&path, &setting, WHOLE, 1);
        assert_eq!(done, usize::from(end < bytes.len()), "cut at byte {end}");
        assert_eq!(records(&path, &setting, WHOLE), expected, "cut at byte {end}");
    }
}

#[test]
fn a_file_torn_in_its_header_is_begun_again() {
    let setting = fig3(1);
    let folder = folder("torn-header");
    let whole = folder.join("whole.jsonl");
    drop(open(&whole, &setting, WHOLE).unwrap());
    let bytes = std::fs::read(&whole).unwrap();
    let path = folder.join("torn.jsonl");
    for end in 0..=bytes.len() {
        std::fs::write(&path, &bytes[..end]).unwrap();
        assert_eq!(open(&path, &setting, WHOLE).unwrap().entries().len(), 0);
        assert_eq!(std::fs::read(&path).unwrap(), bytes, "cut at byte {end}");
    }
}

/// What opening a file with this text says.
fn refused(path: &Path, text: impl AsRef<[u8]>) -> String {
    let text = text.as_ref();
    std::fs::write(path, text).unwrap();
    let error = open(path, &fig3(1), WHOLE).unwrap_err();
    assert_eq!(std::fs::read(path).unwrap(), text, "a file that is refused is left as it is");
    error.to_string().replace(&path.display().to_string(), "FILE")
}

#[test]
fn what_is_no_file_of_this_run_is_refused_and_left_as_it_is() {
    let setting = fig3(1);
    let folder = folder("refused");
    let path = folder.join("records.jsonl");
    work(&path, &setting, WHOLE, 1);
    let good = std::fs::read_to_string(&path).unwrap();
    let (header, rest) = good.split_once('\n').unwrap();
    let first = rest.lines().next().unwrap();
    for (text, message) in [
        ("a letter".to_owned(), r#"FILE, line 1: found "a letter", expected the header"#),
        ("{}\n".to_owned(), r#"FILE, line 1: found "{}", expected the header"#),
        (format!("{header}\n{{\n{first}\n"), r#"FILE, line 2: found "{", expected a record ("#),
        (
            format!("{header}\n{first}\n{first}\n"),
            "FILE, line 3: found gridworld 1 baseline, \
            expected each record once; this one is on line 2",
        ),
        (
            good.replace("\"seed\":1,\"redraws\"", "\"seed\":2,\"redraws\""),
            "FILE, line 2: found gridworld 1 baseline of seed 2, expected seed 1",
        ),
        (
            good.replace("\"baseline\"", "\"luck\""),
            "FILE, line 2: found gridworld 1 luck, expected a record of this part",
        ),
        (
            good.replace("\"status\":\"solved\"", "\"status\":\"limit\""),
            "FILE, line 2: found gridworld 1 baseline, expected status limit without a plan",
        ),
        (
            good.replace("\"status\":\"solved\"", "\"status\":\"fine\""),
            "FILE, line 2: found \
            gridworld 1 baseline, expected a status of optimal, solved, feasible, infeasible or \
            limit",
        ),
        (good.replace("\"seconds\":0", "\"hours\":0"), "FILE, line 2: found"),
    ] {
        let said = refused(&path, &text);
        assert!(said.starts_with(message), "{said}\n{message}");
    }
    let said = refused(&path, [good.as_bytes(), b"\xff\n"].concat());
    assert!(said.ends_with(": found something else, expected UTF-8 text"), "{said}");
    for (from, to, message) in [
        ("\"seed\":1,\"problems\"", "\"seed\":7,\"problems\"", "found seed 7, expected seed 1;"),
        ("\"problems\":1", "\"problems\":2", "found problems 2, expected problems 1;"),
        ("fig3", "fig4", "found experiment fig4, expected experiment fig3;"),
        ("\"memory_mib\":640", "\"memory_mib\":64", "found memory limit 64, expected memory limit"),
        ("\"shard\":\"1/1\"", "\"shard\":\"1/2\"", "found shard 1/2, expected shard 1/1;"),
        ("\"shard\":\"1/1\"", "\"shard\":\"2/1\"", "expected the header"),
        ("\"version\":\"", "\"version\":\"9.", "found version 9."),
    ] {
        assert!(header.contains(from), "{from}");
        let said = refused(&path, format!("{}\n", header.replace(from, to)));
        assert!(said.starts_with("FILE, line 1: ") && said.contains(message), "{said}");
    }
}

#[test]
fn two_runs_do_not_write_the_same_file() {
    let setting = fig3(1);
    let path = folder("in-use").join("records.jsonl");
    let first = open(&path, &setting, WHOLE).unwrap();
    let error = open(&path, &setting, WHOLE).unwrap_err();
    assert!(matches!(error, ExperimentError::InUse { .. }), "{error}");
    drop(first);
    open(&path, &setting, WHOLE).unwrap();
}

#[test]
fn a_file_that_cannot_be_made_is_named() {
    let path = folder("nowhere").join("missing").join("records.jsonl");
    let error = open(&path, &fig3(1), WHOLE).unwrap_err().to_string();
    assert!(error.contains("missing") && error.contains("records.jsonl"), "{error}");
}
