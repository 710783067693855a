//! Reads problems and the arguments that name parts of them.

use std::io::Read;
use std::path::Path;
use std::sync::Arc;

use mo_copp::document::DocumentError;
use mo_copp::domain::{Document, EXERCISE};
use mo_copp::exercise::Exercise;
use mo_copp::problem::Problem;
use mo_copp::solver::{Bounds, OptionsError, Watched};

use super::args::BoundsArgs;
use super::error::CliError;

/// The largest file that is read.
const MAX_BYTES: u64 = mo_copp::limits::MAX_TEXT_BYTES as u64;

/// The bytes of a file; `-` for the standard input.
pub fn bytes(path: &Path) -> Result<Vec<u8>, CliError> {
    let file = path.display().to_string();
    let failed =
        |reason: std::io::Error| CliError::Read { file: file.clone(), reason: reason.to_string() };
    let mut bytes = Vec::new();
    let read = if file == "-" {
        std::io::stdin().lock().take(MAX_BYTES + 1).read_to_end(&mut bytes)
    } else {
        let opened = std::fs::File::open(path).map_err(failed)?;
        opened.take(MAX_BYTES + 1).read_to_end(&mut bytes)
    };
    read.map_err(failed)?;
    if bytes.len() as u64 > MAX_BYTES {
        let reason = format!("found more than {} MiB, expected at most that", MAX_BYTES >> 20);
        return Err(CliError::Read { file, reason });
    }
    Ok(bytes)
}

/// A file as text; `-` for the standard input.
pub fn text(path: &Path) -> Result<String, CliError> {
    let file = path.display().to_string();
    let mut bytes = bytes(path)?;
    // Some editors begin a text with a mark of its encoding.
    if bytes.starts_with("\u{feff}".as_bytes()) {
        bytes.drain(.."\u{feff}".len());
    }
    String::from_utf8(bytes).map_err(|error| {
        let place = error.utf8_error().valid_up_to();
        let (before, rest) = error.as_bytes().split_at(place);
        let before = String::from_utf8_lossy(before);
        let line = before.split('\n').count();
        let column = before.rsplit('\n').next().unwrap_or_default().chars().count() + 1;
        let byte = rest.first().copied().unwrap_or_default();
        let reason = format!("found the byte 0x{byte:02X}, expected UTF-8 text");
        CliError::Read { file: format!("{file}:{line}:{column}"), reason }
    })
}

/// Two files as texts, of which one may be the standard input.
pub fn texts(one: &Path, other: &Path) -> Result<(String, String), CliError> {
    if one.as_os_str() == "-" && other.as_os_str() == "-" {
        let reason = "found it asked for twice, expected one file of the two".to_owned();
        return Err(CliError::Read { file: "-".to_owned(), reason });
    }
    Ok((text(one)?, text(other)?))
}

/// The problem of a document.
pub fn problem(path: &Path) -> Result<Arc<Problem>, CliError> {
    Ok(document(path)?.1)
}

/// A document and its problem.
pub fn document(path: &Path) -> Result<(Document, Arc<Problem>), CliError> {
    parsed(path, &text(path)?)
}

/// A document alone.
pub fn document_alone(path: &Path) -> Result<Document, CliError> {
    let text = text(path)?;
    Document::parse(&text).map_err(|error| placed(path, &text, error))
}

fn parsed(path: &Path, text: &str) -> Result<(Document, Arc<Problem>), CliError> {
    let wrong = |error: DocumentError| placed(path, text, error);
    let document = Document::parse(text).map_err(wrong)?;
    let problem = Arc::new(document.problem().map_err(wrong)?);
    Ok((document, problem))
}

/// A document with its problem, and the block `exercise` that it has.
pub fn document_and_exercise(
    path: &Path,
) -> Result<(Document, Arc<Problem>, Option<serde_json::Value>), CliError> {
    let text = text(path)?;
    let (document, problem) = parsed(path, &text)?;
    let whole: Option<serde_json::Value> = serde_json::from_str(&text).ok();
    let block = whole.and_then(|mut whole| whole.get_mut(EXERCISE).map(serde_json::Value::take));
    Ok((document, problem, block))
}

/// The exercise of a document, and the document's text.
pub fn exercise(path: &Path) -> Result<(Exercise, String), CliError> {
    let text = text(path)?;
    let exercise = Exercise::parse(&text).map_err(|error| placed(path, &text, error))?;
    Ok((exercise, text))
}

/// An error with its place in a file.
pub fn placed(path: &Path, text: &str, error: DocumentError) -> CliError {
    let place = error.place(text);
    // Editors and terminals follow this.
    let file = format!("{}:{}:{}", path.display(), place.line, place.column);
    match error {
        // It would say the place for a second time.
        DocumentError::Syntax { found, expected, .. } => {
            CliError::Read { file, reason: format!("found {found}, expected {expected}") }
        }
        error => CliError::Document { file, error },
    }
}

/// The bounds meant.
pub fn bounds(args: &BoundsArgs, problem: &Problem) -> Result<Bounds, CliError> {
    let all = |option, texts: &[String]| {
        texts.iter().map(|text| watched(option, text, problem)).collect::<Result<Vec<_>, _>>()
    };
    let mut bounds = Bounds::default()
        .with_required(all("require", &args.require)?)
        .with_forbidden(all("forbid", &args.forbid)?);
    (bounds.at_least, bounds.at_most) = (args.k, args.j);
    Ok(bounds)
}

/// `ROLE:GOAL`. The name of the goal may hold colons itself.
fn watched(option: &'static str, text: &str, problem: &Problem) -> Result<Watched, OptionsError> {
    let wrong = |expected: String| OptionsError::new(option, format!("{text:?}"), expected);
    let observers: Vec<&str> = problem.observers().iter().map(|o| o.name.as_str()).collect();
    let (observer, goal) = text
        .split_once(':')
        .ok_or_else(|| wrong(format!("ROLE:GOAL with a role of {}", observers.join(", "))))?;
    let observer = problem
        .observer_named(observer)
        .ok_or_else(|| wrong(format!("a role of {} before the colon", observers.join(", "))))?;
    let goals: Vec<&str> = problem.goals().iter().take(8).map(|goal| goal.name.as_str()).collect();
    let goal = problem
        .goal_named(goal)
        .ok_or_else(|| wrong(format!("a candidate goal after the colon: {}", goals.join(", "))))?;
    Ok(Watched { observer, goal })
}
