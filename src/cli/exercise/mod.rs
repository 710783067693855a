//! `mo-copp exercise`: shows an exercise or a variant of it, and checks an answer.

pub mod args;
mod cell;
mod code_table;
mod encoding;
pub mod grade;
mod records;

use std::fmt::Write;

use mo_copp::exercise::{Exercise, Tally, Variant};
use mo_copp::report::{ExerciseReport, VerdictReport};

use super::error::CliError;
use super::{NO_PLAN, input, note, print, print_json, visible};
use args::{CheckArgs, ExerciseArgs, ExerciseCommand, SeedArgs, ShowArgs, VariantArgs};

/// Does what is asked; the exit code.
pub fn run(args: &ExerciseArgs) -> Result<u8, CliError> {
    match &args.what {
        ExerciseCommand::Show(args) => show(args),
        ExerciseCommand::Variant(args) => variant(args),
        ExerciseCommand::Check(args) => check(args),
    }
}

fn read(which: &SeedArgs) -> Result<(Exercise, Variant, String), CliError> {
    let (exercise, text) = input::exercise(&which.exercise)?;
    let variant = exercise.variant(which.seed())?;
    Ok((exercise, variant, text))
}

fn show(args: &ShowArgs) -> Result<u8, CliError> {
    let (exercise, variant, text) = read(&args.which)?;
    let mut report = ExerciseReport::new(&exercise, &variant);
    // The document's own question is looked at by its author.
    if variant.seed() == 0 {
        let placed = |error| input::placed(&args.which.exercise, &text, error);
        report = report.with_sample(exercise.sample().map_err(placed)?.as_ref());
    }
    for remark in report.sample.iter().flat_map(|sample| &sample.remarks) {
        note(&format!("note: {remark}"));
    }
    if args.solution {
        report = report.with_solution(&variant);
    }
    if args.json {
        print_json(&report)?;
        return Ok(0);
    }
    // Writing to a text cannot fail.
    let mut text = String::new();
    for line in [&report.title, &report.introduction].into_iter().flatten() {
        let _ = writeln!(text, "{line}");
    }
    let _ = writeln!(text, "{}", report.question);
    let _ = writeln!(text, "kind: {}, seed: {}", report.kind, report.seed);
    if let Some(solution) = &report.solution {
        let answer = variant.form().in_words(variant.solution());
        let _ = writeln!(text, "solution: {answer}");
        let _ = writeln!(text, "difficulty: size {}, steps {}", solution.size, solution.steps);
        for remark in &solution.remarks {
            let _ = writeln!(text, "trivial: {remark}");
        }
    }
    print(&visible(&text))?;
    Ok(0)
}

fn variant(args: &VariantArgs) -> Result<u8, CliError> {
    let (exercise, variant, text) = read(&args.which)?;
    let document = exercise.written(&variant, &text);
    print(&format!("{document:#}\n"))?;
    Ok(0)
}

fn check(args: &CheckArgs) -> Result<u8, CliError> {
    let (exercise, variant, _) = read(&args.which)?;
    let wrong = |error| CliError::Document { file: "--answer".to_owned(), error };
    let answer = variant.form().read(&args.answer).map_err(wrong)?;
    let tally = Tally { attempts: 1, hints: 0 };
    let report = VerdictReport::new(&exercise, &variant, &answer, tally);
    let code = if report.right { 0 } else { NO_PLAN };
    if args.json {
        print_json(&report)?;
        return Ok(code);
    }
    let mut text = String::new();
    let _ = writeln!(text, "{}", if report.right { "right" } else { "wrong" });
    for finding in &report.findings {
        let _ = writeln!(text, "{}", finding.text);
    }
    let _ = writeln!(text, "code: {}", report.code);
    print(&visible(&text))?;
    Ok(code)
}
