//! `mo-copp grade`: replays answer codes and writes a table with score and reason.

use std::collections::BTreeMap;

use mo_copp::exercise::code::canonical;
use mo_copp::exercise::{CodeError, Exercise, Graded, Variant, seed_of};

use super::args::GradeArgs;
use crate::cli::error::CliError;
use crate::cli::{input, print};

/// The columns that are added.
const ADDED: [&str; 6] = ["score", "reason", "seed", "answer", "attempts", "hints"];

/// Which columns of the table are read.
struct Columns {
    code: usize,
    seed: Option<usize>,
    student: Option<usize>,
}

/// Grades and prints; the exit code.
pub fn run(args: &GradeArgs) -> Result<u8, CliError> {
    let (exercise, _) = input::exercise(&args.exercise)?;
    let text = input::text(&args.codes)?;
    let place = |line: u64, reason: String| CliError::Read {
        file: format!("{}:{line}:1", args.codes.display()),
        reason,
    };
    let broken = |error: csv::Error| {
        place(error.position().map_or(1, csv::Position::line), error.to_string())
    };
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let head = reader.headers().map_err(broken)?.clone();
    let columns = columns(&head, args.student.as_deref()).map_err(|reason| place(1, reason))?;
    let mut writer = csv::Writer::from_writer(Vec::new());
    let failed = |error: csv::Error| CliError::Output(std::io::Error::other(error));
    writer.write_record(head.iter().chain(ADDED)).map_err(failed)?;
    // The line at which each code stood first.
    let mut first: BTreeMap<String, u64> = BTreeMap::new();
    let mut drawn = BTreeMap::new();
    for record in reader.records() {
        let record = record.map_err(broken)?;
        let line = record.position().map_or(0, csv::Position::line);
        let code = record.get(columns.code).unwrap_or_default();
        let seed = expected_seed(&columns, &record).map_err(|reason| place(line, reason))?;
        let mut added = row(&exercise, code, seed, &mut drawn);
        let same = canonical(code);
        if !same.is_empty() {
            let earlier = *first.entry(same).or_insert(line);
            if earlier != line {
                let and = if added[1].is_empty() { "" } else { "; " };
                added[1] = format!("{}{and}the same code as in line {earlier}", added[1]);
            }
        }
        writer.write_record(record.iter().map(str::to_owned).chain(added)).map_err(failed)?;
    }
    let bytes = writer.into_inner().map_err(|error| CliError::Output(error.into_error()))?;
    print(&String::from_utf8_lossy(&bytes))?;
    Ok(0)
}

fn columns(head: &csv::StringRecord, student: Option<&str>) -> Result<Columns, String> {
    let named =
        |wanted: &str| head.iter().position(|name| name.trim().eq_ignore_ascii_case(wanted.trim()));
    let found = || head.iter().collect::<Vec<_>>().join(",");
    let code =
        named("code").ok_or_else(|| format!("found {:?}, expected a column code", found()))?;
    let student = student.map(|name| {
        named(name).ok_or_else(|| format!("found {:?}, expected a column {name}", found()))
    });
    Ok(Columns { code, seed: named("seed"), student: student.transpose()? })
}

/// The seed that the code of a row must have, where the row tells.
fn expected_seed(columns: &Columns, record: &csv::StringRecord) -> Result<Option<u64>, String> {
    if let Some(student) = columns.student {
        return Ok(Some(seed_of(record.get(student).unwrap_or_default())));
    }
    let text = columns.seed.and_then(|column| record.get(column)).unwrap_or_default().trim();
    if text.is_empty() {
        return Ok(None);
    }
    let wrong = |_| format!("found the seed {text:?}, expected a whole number or nothing");
    text.parse().map(Some).map_err(wrong)
}

/// What is added to the row of a code.
fn row(
    exercise: &Exercise,
    code: &str,
    seed: Option<u64>,
    drawn: &mut BTreeMap<u64, Variant>,
) -> [String; ADDED.len()] {
    let empty = String::new;
    if code.trim().is_empty() {
        return ["0".to_owned(), "no answer".to_owned(), empty(), empty(), empty(), empty()];
    }
    match exercise.grade_with(code, seed, drawn) {
        Err(error) => {
            let found = match &error {
                CodeError::OtherSeed { found, .. } => found.to_string(),
                _ => empty(),
            };
            ["0".to_owned(), error.to_string(), found, empty(), empty(), empty()]
        }
        Ok(Graded { variant, answer, verdict, tally, .. }) => [
            verdict.score().to_string(),
            verdict.reason().to_owned(),
            variant.seed().to_string(),
            variant.form().to_json(&answer).to_string(),
            tally.attempts.to_string(),
            tally.hints.to_string(),
        ],
    }
}
