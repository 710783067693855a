//! `mo-copp import`: makes documents of goal-recognition problems and of competition tasks.

mod archive;
pub mod task;
pub mod task_files;

use std::path::{Path, PathBuf};

use mo_copp::domain::Document;
use mo_copp::domain::pddl::import::{
    FILES, ImportFile, ImportOptions, Imported, hypothesis_count, import,
};
use mo_copp::plan::Plan;
use mo_copp::trace::trace;

use super::args::ImportArgs;
use super::error::CliError;
use super::{input, print};

/// Imports and prints or writes; the exit code.
pub fn run(args: &ImportArgs) -> Result<u8, CliError> {
    let options = ImportOptions {
        adversarial_sensor: args.adversarial_sensor.clone(),
        cooperative_sensor: args.cooperative_sensor.clone(),
        adversarial_groups: groups(&args.adversarial_group, "adversarial-group")?,
        cooperative_groups: groups(&args.cooperative_group, "cooperative-group")?,
        true_goal: args.true_goal,
    };
    if let Some(tasks) = task_files::given(&args.source, args.task.as_deref())? {
        return task::run(args, &tasks, &options);
    }
    goal_recognition(args, &options)
}

/// Imports a problem of the goal-recognition literature.
fn goal_recognition(args: &ImportArgs, options: &ImportOptions) -> Result<u8, CliError> {
    if args.candidates.is_some() || args.seed.is_some() {
        let option = if args.candidates.is_some() { "candidates" } else { "seed" };
        return Err(unfit(
            option,
            "a problem with hypotheses",
            "a task, as in DOMAIN.pddl TASK.pddl",
        ));
    }
    let files = files(&args.source)?;
    if args.all {
        return all(args, &files, options);
    }
    let imported = import(&files, options)?;
    note(&imported.notes);
    let text = Document::from(imported.document.clone()).to_json() + "\n";
    match &args.out {
        Some(out) => write(out, &text)?,
        None => print(&text)?,
    }
    if let Some(out) = &args.plan_out {
        plan(&imported, out)?;
    }
    Ok(0)
}

/// An option that does not fit what is imported.
fn unfit(option: &'static str, found: &str, expected: &str) -> CliError {
    mo_copp::solver::OptionsError::new(option, found, expected).into()
}

/// A document for each hypothesis: files in a folder, or one a line.
fn all(args: &ImportArgs, files: &[ImportFile], options: &ImportOptions) -> Result<u8, CliError> {
    let mut lines = String::new();
    let mut done = rustc_hash::FxHashSet::default();
    for number in 1..=hypothesis_count(files)? {
        let options = ImportOptions { true_goal: Some(number), ..options.clone() };
        let imported = import(files, &options)?;
        if number == 1 {
            note(&imported.notes);
        }
        let name = imported.document.true_goal.clone();
        // A hypothesis that stands there twice is one goal.
        if !done.insert(name.clone()) {
            continue;
        }
        let document = Document::from(imported.document);
        match &args.out {
            Some(folder) => {
                make(folder)?;
                write(&folder.join(format!("{name}.json")), &(document.to_json() + "\n"))?;
            }
            None => lines += &(serde_json::to_string(&document).unwrap_or_default() + "\n"),
        }
    }
    print(&lines)?;
    Ok(0)
}

fn note(notes: &[String]) {
    for note in notes {
        eprintln!("mo-copp: note: {}", super::visible(note));
    }
}

/// `NAME=OBJECT,OBJECT`, several times.
fn groups(texts: &[String], option: &'static str) -> Result<Vec<(String, Vec<String>)>, CliError> {
    let group = |text: &String| {
        let wrong = || {
            mo_copp::solver::OptionsError::new(option, format!("{text:?}"), "NAME=OBJECT,OBJECT…")
        };
        let (name, objects) = text.split_once('=').ok_or_else(wrong)?;
        let objects = objects.split(',').map(|object| object.trim().to_owned()).collect();
        Ok((name.trim().to_owned(), objects))
    };
    texts.iter().map(group).collect()
}

/// A folder with one of these is a goal-recognition problem: others may have a domain too.
const MARKS: [&str; 3] = ["template.pddl", "hyps.dat", "real_hyp.dat"];

/// Whether a folder holds a goal-recognition problem.
pub fn is_layout(folder: &Path) -> bool {
    MARKS.iter().any(|mark| named(folder, mark).is_some())
}

/// The file of a name in a folder, whatever its capitals.
pub fn named(folder: &Path, name: &str) -> Option<PathBuf> {
    let mut entries = std::fs::read_dir(folder).ok()?.flatten();
    let entry = entries.find(|entry| entry.file_name().eq_ignore_ascii_case(name))?;
    Some(entry.path())
}

/// The files of a folder or an archive.
pub fn files(source: &Path) -> Result<Vec<ImportFile>, CliError> {
    let shown = source.display().to_string();
    let failed = |reason: String| CliError::Read { file: shown.clone(), reason };
    if source.is_dir() {
        let mut found = Vec::new();
        let entries = std::fs::read_dir(source).map_err(|error| failed(error.to_string()))?;
        let mut paths = Vec::new();
        for entry in entries {
            paths.push(entry.map_err(|error| failed(error.to_string()))?.path());
        }
        paths.sort();
        for path in paths {
            let name = path.file_name().map(|name| name.to_string_lossy().into_owned());
            let wanted = |name: &String| FILES.iter().any(|file| name.eq_ignore_ascii_case(file));
            if name.as_ref().is_some_and(wanted) && path.is_file() {
                found.push(ImportFile {
                    name: path.display().to_string(),
                    text: input::text(&path)?,
                });
            }
        }
        if found.is_empty() {
            let expected = FILES.join(", ");
            return Err(failed(format!("found none of the files, expected {expected}")));
        }
        return Ok(found);
    }
    let bytes = input::bytes(source)?;
    archive::files(&bytes).map_err(failed)
}

/// Writes the observations where they are a whole plan for the true goal.
fn plan(imported: &Imported, out: &Path) -> Result<(), CliError> {
    let Some(names) = &imported.observations else {
        note(&["there is no obs.dat, so there is no plan to write".to_owned()]);
        return Ok(());
    };
    let problem = Document::from(imported.document.clone()).problem().map_err(|error| {
        CliError::Read { file: "the imported problem".to_owned(), reason: error.to_string() }
    })?;
    let traced = Plan::from_names(problem.task(), names).and_then(|plan| trace(&problem, &plan));
    match traced {
        Ok(trace) if trace.reaches_goal => {
            write(out, &names.iter().map(|name| name.clone() + "\n").collect::<String>())
        }
        Ok(_) => {
            note(&["the observations do not reach the true goal: no plan is written".to_owned()]);
            Ok(())
        }
        Err(error) => {
            note(&[format!("the observations are no whole plan ({error}): none is written")]);
            Ok(())
        }
    }
}

/// Makes a folder where there is none.
fn make(folder: &Path) -> Result<(), CliError> {
    std::fs::create_dir_all(folder).map_err(|error| CliError::Read {
        file: folder.display().to_string(),
        reason: error.to_string(),
    })
}

fn write(path: &Path, text: &str) -> Result<(), CliError> {
    std::fs::write(path, text).map_err(|error| CliError::Read {
        file: path.display().to_string(),
        reason: error.to_string(),
    })
}
