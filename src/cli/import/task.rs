//! Documents of competition tasks.

use std::path::Path;

use mo_copp::domain::Document;
use mo_copp::domain::pddl::import::{
    CandidateOptions, ImportFile, ImportOptions, Imported, import_task,
};

use super::task_files::TaskFiles;
use super::{make, note, unfit, write};
use crate::cli::args::ImportArgs;
use crate::cli::error::CliError;
use crate::cli::{BAD_INPUT, input, print};

/// Imports tasks and prints or writes; the exit code.
pub fn run(
    args: &ImportArgs,
    tasks: &[TaskFiles],
    options: &ImportOptions,
) -> Result<u8, CliError> {
    let for_hypotheses = [
        ("true-goal", args.true_goal.is_some()),
        ("all", args.all),
        ("plan-out", args.plan_out.is_some()),
    ];
    if let Some((option, _)) = for_hypotheses.iter().find(|(_, given)| *given) {
        return Err(unfit(option, "a task", "a problem with hypotheses (hyps.dat)"));
    }
    let default = CandidateOptions::default();
    let candidates = CandidateOptions {
        candidates: args.candidates.unwrap_or(default.candidates),
        seed: args.seed.unwrap_or(default.seed),
    };
    let document = |files: &TaskFiles| {
        let imported = read(files, options, candidates)?;
        note(&imported.notes);
        Ok::<_, CliError>(Document::from(imported.document))
    };
    // One that is named is a document; those of a folder are several, however many there are.
    if !args.source.is_dir() {
        let Some(files) = tasks.first() else { return Ok(0) };
        let text = document(files)?.to_json() + "\n";
        match &args.out {
            Some(out) => write(out, &text)?,
            None => print(&text)?,
        }
        return Ok(0);
    }
    let mut code = 0;
    for files in tasks {
        // The others are imported all the same.
        let document = match document(files) {
            Ok(document) => document,
            Err(error) => {
                note(&[error.to_string()]);
                code = BAD_INPUT;
                continue;
            }
        };
        match &args.out {
            Some(folder) => {
                make(folder)?;
                let name = files.task.with_extension("json");
                let name = name.file_name().unwrap_or_default();
                write(&folder.join(name), &(document.to_json() + "\n"))?;
            }
            None => print(&(serde_json::to_string(&document).unwrap_or_default() + "\n"))?,
        }
    }
    Ok(code)
}

/// Reads and imports a task.
///
/// # Errors
///
/// What cannot be read, with its place.
pub fn read(
    files: &TaskFiles,
    options: &ImportOptions,
    candidates: CandidateOptions,
) -> Result<Imported, CliError> {
    let (domain, task) = input::texts(&files.domain, &files.task)?;
    let file = |path: &Path, text| ImportFile { name: path.display().to_string(), text };
    let (domain, task) = (file(&files.domain, domain), file(&files.task, task));
    Ok(import_task(&domain, &task, options, candidates)?)
}
