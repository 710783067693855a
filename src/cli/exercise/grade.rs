//! `mo-copp grade`: replays answer codes and writes a table with score and reason.

use std::collections::BTreeMap;

use mo_copp::exercise::code::{canonical, is_like_code};
use mo_copp::exercise::{CodeError, Exercise, Graded, Tally, Variant, seed_of};

use super::args::GradeArgs;
use super::cell::Cell;
use super::code_table::{CodeTable, is_same};
use crate::cli::error::CliError;
use crate::cli::{input, print};

/// The columns that are added.
const ADDED: [&str; 6] = ["score", "reason", "seed", "answer", "attempts", "hints"];

/// Grades and prints; the exit code.
pub fn run(args: &GradeArgs) -> Result<u8, CliError> {
    let (exercise, _) = input::exercise(&args.exercise)?;
    let place = |(line, reason): (u64, String)| CliError::Read {
        file: format!("{}:{line}:1", args.codes.display()),
        reason,
    };
    let table =
        CodeTable::read(&input::bytes(&args.codes)?, args.code.as_deref()).map_err(place)?;
    let student =
        args.student.as_deref().map(|name| table.column(name)).transpose().map_err(place)?;
    let mut writer = csv::WriterBuilder::new().delimiter(table.separator).from_writer(Vec::new());
    let failed = |error: csv::Error| CliError::Output(std::io::Error::other(error));
    let head = table.head.iter().cloned().chain(ADDED.map(|name| free_name(name, &table.head)));
    writer.write_record(head).map_err(failed)?;
    // The line at which each code stood first.
    let mut first: BTreeMap<String, u64> = BTreeMap::new();
    let mut drawn = BTreeMap::new();
    // Where nothing varies, all have one question: seeds say nothing, and equal answers have equal codes.
    let varies = !exercise.vary().is_empty();
    for row in &table.rows {
        let seed = match (&row.broken, student) {
            (Some(reason), _) => Err(reason.clone()),
            (None, _) if !varies => Ok(None),
            (None, Some(column)) => Ok(Some(seed_of(&row.fields[column]))),
            (None, None) => table.seed(row),
        };
        let cell = Cell::read(table.code(row));
        let mut added = match seed {
            Ok(seed) => graded(&exercise, &cell, seed, &mut drawn),
            Err(reason) => not_graded(reason),
        };
        let same = match &cell {
            Cell::Code(code) if varies && is_like_code(code) => Some(canonical(code)),
            _ => None,
        };
        if let (Some(same), None) = (same, &row.broken) {
            let earlier = *first.entry(same).or_insert(row.line);
            if earlier != row.line {
                added[1] = joined(&added[1], &format!("the same code as in line {earlier}"));
            }
        }
        if let Some(remark) = &row.remark {
            added[1] = joined(&added[1], remark);
        }
        writer.write_record(row.fields.iter().chain(&added)).map_err(failed)?;
    }
    let bytes = writer.into_inner().map_err(|error| CliError::Output(error.into_error()))?;
    print(&String::from_utf8_lossy(&bytes))?;
    Ok(0)
}

/// The name of a column that is added: another one where the table has a column of that name.
fn free_name(name: &str, head: &[String]) -> String {
    let is_free = |wanted: &String| !head.iter().any(|known| is_same(known, wanted));
    let numbered = (2..).map(|number: u64| format!("graded {name} {number}"));
    let mut names = [name.to_owned(), format!("graded {name}")].into_iter().chain(numbered);
    names.find(is_free).unwrap_or_default()
}

/// Two reasons, one after the other.
fn joined(reason: &str, further: &str) -> String {
    let and = if reason.is_empty() { "" } else { "; " };
    format!("{reason}{and}{further}")
}

/// What is remarked of a code that tells more attempts or hints than the exercise has. The answer keeps its score: a code
/// proves neither.
fn too_many(exercise: &Exercise, tally: Tally) -> impl Iterator<Item = String> {
    let hints = exercise.hints().len() as u32;
    let remark = |word: &str, told: u32, most: u32| {
        let s = if told == 1 { "" } else { "s" };
        (told > most)
            .then(|| format!("the code tells of {told} {word}{s}, the exercise has {most}"))
    };
    let attempts = exercise.attempts().and_then(|most| remark("attempt", tally.attempts, most));
    attempts.into_iter().chain(remark("hint", tally.hints, hints))
}

/// What is added to a row that has no answer, or none that can be checked.
fn not_graded(reason: String) -> [String; ADDED.len()] {
    ["0".to_owned(), reason, String::new(), String::new(), String::new(), String::new()]
}

/// What is added to the row of a code.
fn graded(
    exercise: &Exercise,
    cell: &Cell,
    seed: Option<u64>,
    drawn: &mut BTreeMap<u64, Variant>,
) -> [String; ADDED.len()] {
    let code = match cell {
        Cell::Code(code) => code,
        Cell::Empty => return not_graded("no answer".to_owned()),
        Cell::Several => {
            return not_graded("more than one code, of which none is chosen".to_owned());
        }
    };
    match exercise.grade_with(code, seed, drawn) {
        Err(error) => {
            let mut added = not_graded(error.to_string());
            if let CodeError::OtherSeed { found, .. } = error {
                added[2] = found.to_string();
            }
            added
        }
        Ok(Graded { variant, answer, verdict, tally, .. }) => [
            verdict.score().to_string(),
            too_many(exercise, tally)
                .fold(verdict.reason().to_owned(), |reason, further| joined(&reason, &further)),
            variant.seed().to_string(),
            variant.form().in_words(&answer),
            tally.attempts.to_string(),
            tally.hints.to_string(),
        ],
    }
}
