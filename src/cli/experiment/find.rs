//! Finds the problems below a folder.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use mo_copp::domain::pddl::import::FILES;
use mo_copp::experiment::benchmarks::Benchmark;
use sha2::{Digest, Sha256};

use crate::cli::error::CliError;
use crate::cli::import::task_files::{self, TaskFiles};
use crate::cli::import::{is_layout, named};
use crate::cli::input;

/// What a problem is written in.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Kind {
    /// A folder in Ramírez and Geffner's layout.
    Folder,
    /// An archive of one.
    Archive,
    /// A competition task with its domain beside it.
    Task(TaskFiles),
    /// A document of ours.
    Document,
}

/// The ends of names of archives.
const ARCHIVES: [&str; 6] = [".tar", ".tar.gz", ".tgz", ".tar.bz2", ".tbz2", ".zip"];

/// The ends of names of documents.
const DOCUMENTS: [&str; 1] = [".json"];

/// How much of a digest is kept, in bytes.
const DIGEST_BYTES: usize = 8;

/// The path of a problem that is the folder itself.
const ITSELF: &str = ".";

/// Where a problem is.
pub fn place(folder: &Path, path: &str) -> PathBuf {
    if path == ITSELF { folder.to_owned() } else { folder.join(path) }
}

/// What kind of problem is there; none where there is none.
pub fn kind(place: &Path) -> Option<Kind> {
    if place.is_dir() {
        return is_layout(place).then_some(Kind::Folder);
    }
    let name = place.file_name()?.to_string_lossy().to_ascii_lowercase();
    if ARCHIVES.iter().any(|end| name.ends_with(end)) {
        return Some(Kind::Archive);
    }
    if DOCUMENTS.iter().any(|end| name.ends_with(end)) {
        return Some(Kind::Document);
    }
    // The template of a goal-recognition problem is no task.
    let files = task_files::task(place).filter(|_| !place.parent().is_some_and(is_layout))?;
    Some(Kind::Task(files))
}

/// All problems below a folder, by their paths. Hidden files and links to folders are passed over; a
/// folder that cannot be listed counts as a problem that cannot be read.
///
/// # Errors
///
/// The folder cannot be listed, or holds no problem.
pub fn find(folder: &Path) -> Result<Vec<Benchmark>, CliError> {
    let failed = |reason: String| CliError::Read { file: folder.display().to_string(), reason };
    fs::read_dir(folder).map_err(|error| failed(error.to_string()))?;
    let whole = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    let own = whole.file_name().map_or_else(String::new, |name| name.to_string_lossy().into());
    let mut found = BTreeMap::new();
    let mut left = vec![(folder.to_owned(), Vec::<String>::new())];
    while let Some((place, parts)) = left.pop() {
        let path = if parts.is_empty() { ITSELF.to_owned() } else { parts.join("/") };
        let listed = place.is_dir().then(|| fs::read_dir(&place));
        let kind = kind(&place);
        if kind.is_some() || matches!(listed, Some(Err(_))) {
            let domain = if parts.len() > 1 { parts[0].clone() } else { own.clone() };
            let digest = digest(&place, kind.as_ref());
            found.insert(path.clone(), Benchmark { path, domain, digest });
        }
        let Some(Ok(entries)) = listed else { continue };
        for entry in entries.flatten() {
            let name = entry.file_name().to_string_lossy().into_owned();
            let link = entry.file_type().is_ok_and(|kind| kind.is_symlink());
            if name.starts_with('.') || link && entry.path().is_dir() {
                continue;
            }
            left.push((entry.path(), [parts.clone(), vec![name]].concat()));
        }
    }
    if found.is_empty() {
        let reason = "found no problem below it, expected a folder with template.pddl or hyps.dat, a \
                      task with its domain.pddl beside it, an archive or a document (.json)";
        return Err(failed(reason.to_owned()));
    }
    Ok(found.into_values().collect())
}

/// A digest of what the files of a problem hold; files that cannot be read count as empty.
fn digest(place: &Path, kind: Option<&Kind>) -> String {
    let mut digest = Sha256::new();
    let files: Vec<PathBuf> = match kind {
        Some(Kind::Task(TaskFiles { domain, task })) => vec![domain.clone(), task.clone()],
        _ if place.is_dir() => FILES.iter().filter_map(|name| named(place, name)).collect(),
        _ => vec![place.to_owned()],
    };
    for file in files {
        let bytes = input::bytes(&file).unwrap_or_default();
        digest.update((bytes.len() as u64).to_le_bytes());
        digest.update(&bytes);
    }
    let bytes = digest.finalize();
    data_encoding::HEXLOWER.encode(&bytes[..DIGEST_BYTES])
}
