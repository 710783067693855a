//! The command line. It reads arguments, calls the library and prints; nothing else.
//!
//! Exit codes: 0 a plan, 1 there is none, 2 bad input or usage, 3 a limit was met and no
//! plan found, 101 a defect of the program.

mod args;
mod encode;
mod error;
mod exercise;
mod experiment;
mod generate;
mod import;
mod input;
mod interrupt;
mod manual;
mod picture;
mod plan;
mod plan_text;
mod progress;
mod remedy;
mod sensor;
mod solve;
mod trace;
mod usage;

use std::io::{ErrorKind, Write};
use std::process::ExitCode;

use mo_copp::document::is_hidden;
use mo_copp::plan::PlanError;

use args::Command;
use error::CliError;

/// There is no plan.
const NO_PLAN: u8 = 1;
/// Something was asked for wrongly.
const BAD_INPUT: u8 = 2;
/// A limit was met and no plan found.
const LIMIT: u8 = 3;
/// The program is at fault: what Rust programs end with that panic.
const DEFECT: u8 = 101;

/// Runs the command; the exit code says how it went.
pub fn main() -> ExitCode {
    let done = match usage::command_line().command {
        Command::Solve(args) => solve::run(&args),
        Command::Trace(args) => unless_stopped(move || trace::run(&args)),
        Command::Encode(args) => unless_stopped(move || encode::run(&args)),
        Command::Picture(args) => unless_stopped(move || picture::run(&args)),
        Command::Plan(args) => plan::run(&args),
        Command::Generate(args) => unless_stopped(move || generate::run(&args)),
        Command::Import(args) => unless_stopped(move || import::run(&args)),
        Command::Sensor(args) => unless_stopped(move || sensor::run(&args)),
        Command::Schema => manual::schema(),
        Command::Completions(args) => manual::completions(&args),
        Command::Manual(args) => manual::run(&args),
        Command::Exercise(args) => unless_stopped(move || exercise::run(&args)),
        Command::Grade(args) => unless_stopped(move || exercise::grade::run(&args)),
        Command::Experiment(args) => experiment::run_command(&args),
    };
    match done {
        Ok(code) => ExitCode::from(code),
        Err(CliError::Plan(
            error @ (PlanError::TooManyStates { .. } | PlanError::TooLarge { .. }),
        )) => {
            let _ = writeln!(std::io::stderr(), "mo-copp: {error}");
            ExitCode::from(LIMIT)
        }
        Err(error) => {
            let code = match error {
                CliError::Stopped => LIMIT,
                CliError::Defect { .. } => DEFECT,
                _ => BAD_INPUT,
            };
            // Where not even this can be printed, the exit code is all there is.
            let _ = writeln!(std::io::stderr(), "mo-copp: {}", visible(&error.to_string()));
            ExitCode::from(code)
        }
    }
}

/// Work that has no answer before its end.
fn unless_stopped(
    work: impl FnOnce() -> Result<u8, CliError> + Send + 'static,
) -> Result<u8, CliError> {
    interrupt::unless_stopped(work)?.unwrap_or(Err(CliError::Stopped))
}

/// Tells something beside the output.
fn note(text: &str) {
    eprintln!("mo-copp: {}", visible(text));
}

/// A text for a terminal: names of files may hold anything, so control characters and signs that
/// are hidden or turn text around are written out.
fn visible(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for character in text.chars() {
        if (character.is_control() && character != '\n') || is_hidden(character) {
            shown.extend(character.escape_default());
        } else {
            shown.push(character);
        }
    }
    shown
}

/// Prints a text to the standard output.
fn print(text: &str) -> Result<(), CliError> {
    let mut output = std::io::stdout().lock();
    read_or_not(output.write_all(text.as_bytes()).and_then(|()| output.flush()))
}

/// Prints an object as it is written, for what would be a very long text.
fn print_json(report: &impl serde::Serialize) -> Result<(), CliError> {
    let mut output = std::io::BufWriter::new(std::io::stdout().lock());
    let written = serde_json::to_writer(&mut output, report).map_err(std::io::Error::from);
    read_or_not(written.and_then(|()| writeln!(output)).and_then(|()| output.flush()))
}

fn read_or_not(written: std::io::Result<()>) -> Result<(), CliError> {
    match written {
        // Whoever read our output has had enough of it; the exit code still says how it went.
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        written => written.map_err(CliError::Output),
    }
}
