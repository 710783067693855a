//! What a run leaves in its folder: `results.json`, tables as CSV and Markdown, figures as SVG.

mod chart;
pub(super) mod csv;
mod figures;
pub(super) mod markdown;

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

pub use chart::{Bar, Chart, Colour, Group, Scale, Series};
pub use csv::{anova_csv, records_csv, relative_csv, summary_csv};
pub use figures::figures;
pub use markdown::markdown;

use super::records::Entries;
use super::{ExperimentError, Summary};

/// Writes everything that follows from the records of a whole run into a folder; the names of the
/// files.
///
/// # Errors
///
/// The folder cannot be written, or a figure cannot be drawn.
pub fn write(
    folder: &Path,
    summary: &Summary,
    entries: &Entries,
) -> Result<Vec<PathBuf>, ExperimentError> {
    // Only texts, numbers and lists: writing them cannot fail.
    let json = serde_json::to_string_pretty(summary).unwrap_or_default() + "\n";
    let mut files = vec![
        ("results.json".to_owned(), json),
        ("tables.md".to_owned(), markdown(summary)),
        ("summary.csv".to_owned(), summary_csv(summary)),
        ("anova.csv".to_owned(), anova_csv(summary)),
        ("records.csv".to_owned(), records_csv(entries)),
    ];
    if summary.domains.iter().any(|domain| !domain.relative.is_empty()) {
        files.push(("relative.csv".to_owned(), relative_csv(summary)));
    }
    files.extend(figures(summary)?);
    let mut written = Vec::new();
    for (name, text) in files {
        let path = folder.join(name);
        replace(&path, &text)?;
        written.push(path);
    }
    Ok(written)
}

/// Writes a file in one step: a reader sees the old one or the new one. Where that fails, nothing is
/// left of the new one.
pub(super) fn replace(path: &Path, text: &str) -> Result<(), ExperimentError> {
    let mut new = path.as_os_str().to_owned();
    new.push(".new");
    let new = PathBuf::from(new);
    let mut file = fs::File::create(&new).map_err(|error| ExperimentError::file(&new, error))?;
    let written = file.write_all(text.as_bytes()).and_then(|()| file.sync_all());
    let written = written.map_err(|error| ExperimentError::file(&new, error));
    let replaced = written
        .and_then(|()| fs::rename(&new, path).map_err(|error| ExperimentError::file(path, error)));
    if replaced.is_err() {
        let _ = fs::remove_file(&new);
    }
    replaced
}
