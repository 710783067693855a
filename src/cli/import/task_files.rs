//! Competition tasks among files: which domain belongs to which task.

use std::fs;
use std::path::{Path, PathBuf};

use crate::cli::error::CliError;

/// The end of the names of PDDL files.
const PDDL: &str = ".pddl";

/// What the names of domains begin or end with.
const DOMAIN: &str = "domain";

/// A task with its domain.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TaskFiles {
    /// The file with the domain.
    pub domain: PathBuf,
    /// The file with the task.
    pub task: PathBuf,
}

/// The name of a PDDL file without its end, in small letters.
fn stem(path: &Path) -> Option<String> {
    let name = path.file_name()?.to_string_lossy().to_ascii_lowercase();
    name.strip_suffix(PDDL).map(str::to_owned)
}

fn is_domain(stem: &str) -> bool {
    stem.starts_with(DOMAIN) || stem.ends_with(DOMAIN)
}

/// The first number in a name.
fn number(stem: &str) -> Option<u64> {
    let digits = stem.trim_start_matches(|character: char| !character.is_ascii_digit());
    let end = digits.find(|character: char| !character.is_ascii_digit()).unwrap_or(digits.len());
    digits[..end].parse().ok()
}

/// The PDDL files of a folder with the stems of their names, by name; none where it cannot be listed.
fn listed(folder: &Path) -> Vec<(String, PathBuf)> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let paths = entries.map(|entry| entry.path()).filter(|path| path.is_file());
    let mut found: Vec<_> = paths.filter_map(|path| Some((stem(&path)?, path))).collect();
    found.sort();
    found
}

/// The domain among these files for a task: one whose name has the task's number, or else one without a number.
fn domain_among(files: &[(String, PathBuf)], task: &str) -> Option<PathBuf> {
    let wanted = number(task);
    let domains = || files.iter().filter(|(stem, _)| is_domain(stem));
    let own = domains().find(|(stem, _)| wanted.is_some() && number(stem) == wanted);
    let general = || domains().find(|(stem, _)| number(stem).is_none());
    own.or_else(general).map(|(_, path)| path.clone())
}

/// The task in a file, with the domain beside it; none where the file is no task or has no domain beside it.
pub fn task(path: &Path) -> Option<TaskFiles> {
    let stem = stem(path).filter(|stem| !is_domain(stem))?;
    // The parent of a bare name is empty.
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let domain = domain_among(&listed(folder.unwrap_or(Path::new("."))), &stem)?;
    Some(TaskFiles { domain, task: path.to_owned() })
}

/// The tasks of a folder, by name.
fn tasks(folder: &Path) -> Vec<TaskFiles> {
    let files = listed(folder);
    let tasks = files.iter().filter(|(stem, _)| !is_domain(stem));
    let with_domain = |(stem, path): &(String, PathBuf)| {
        Some(TaskFiles { domain: domain_among(&files, stem)?, task: path.clone() })
    };
    tasks.filter_map(with_domain).collect()
}

/// What the arguments name: a domain and a task, a task with its domain beside it, or all tasks of a folder. None where
/// they name something else.
///
/// # Errors
///
/// A task without a domain beside it.
pub fn given(source: &Path, task_file: Option<&Path>) -> Result<Option<Vec<TaskFiles>>, CliError> {
    if let Some(file) = task_file {
        return Ok(Some(vec![TaskFiles { domain: source.to_owned(), task: file.to_owned() }]));
    }
    if source.is_dir() {
        let found = if super::is_layout(source) { Vec::new() } else { tasks(source) };
        return Ok((!found.is_empty()).then_some(found));
    }
    if stem(source).is_none() {
        return Ok(None);
    }
    let missing = || CliError::Read {
        file: source.display().to_string(),
        reason: "found no task with a domain beside it, expected DOMAIN.pddl TASK.pddl".to_owned(),
    };
    Ok(Some(vec![task(source).ok_or_else(missing)?]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn domain(names: &[&str], task: &str) -> Option<String> {
        let files: Vec<(String, PathBuf)> =
            names.iter().map(|name| ((*name).to_owned(), PathBuf::from(name))).collect();
        domain_among(&files, task).map(|path| path.display().to_string())
    }

    #[test]
    fn a_domain_of_the_number_goes_before_the_general_one() {
        let names = ["domain", "domain02", "p03-domain", "domain_p04", "p01", "p02", "p11"];
        for (task, expected) in [
            ("p01", "domain"),
            ("p02", "domain02"),
            ("instance-2", "domain02"),
            ("p03-large", "p03-domain"),
            ("task4", "domain_p04"),
            ("p20", "domain"),
            ("task", "domain"),
        ] {
            assert_eq!(domain(&names, task).as_deref(), Some(expected), "{task}");
        }
        assert_eq!(domain(&["domain02", "p01"], "p01"), None);
        assert_eq!(domain(&["domain-strips", "p01"], "p01").as_deref(), Some("domain-strips"));
        assert_eq!(domain(&["p01", "p02"], "p01"), None);
    }

    #[test]
    fn names_of_pddl_files_and_numbers_in_them() {
        assert_eq!(stem(Path::new("a/P01.PDDL")).as_deref(), Some("p01"));
        assert_eq!(stem(Path::new("a/p01.pddl.txt")), None);
        assert_eq!((number("p01-12"), number("probe"), number("7")), (Some(1), None, Some(7)));
        assert_eq!(number("p99999999999999999999999"), None);
    }
}
