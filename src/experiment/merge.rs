//! Puts the parts of a run together again.

use std::path::PathBuf;

use super::records::{Entries, entries, read};
use super::series::{Series, SeriesHeader, SeriesJob};
use super::{ExperimentError, Shard};

/// Reads the files of all parts of a run: what it is about, and all its records.
///
/// # Errors
///
/// A file is no file of records, belongs to another run than the first one, holds a record of
/// another part or one that another file holds too, or a record is missing.
pub fn merge<S: Series>(files: &[PathBuf]) -> Result<(S, Entries<S::Record>), ExperimentError> {
    let mut all = Entries::new();
    let mut first: Option<(S::Header, S)> = None;
    let mut parts: Vec<Shard> = Vec::new();
    for path in files {
        let wrong = |line, found: String, expected: String| {
            let file = path.display().to_string();
            ExperimentError::Line { file, line, found, expected }
        };
        let contents = read::<S::Header>(path)?;
        let header = contents.header.ok_or_else(|| {
            wrong(1, "no whole line".to_owned(), "the header of a file of records".to_owned())
        })?;
        let shard = header.shard();
        if let Some((known, _)) = &first {
            let number = shard.number;
            let known = known.with_shard(Shard { number, ..known.shard() });
            if let Some((field, found, expected)) = header.difference(&known) {
                let expected = format!("{field} {expected}, as in {}", files[0].display());
                return Err(wrong(1, format!("{field} {found}"), expected));
            }
            if parts.contains(&shard) {
                let expected = "each part once".to_owned();
                return Err(wrong(1, format!("shard {shard} for the second time"), expected));
            }
        } else {
            let setting =
                S::of_header(&header).map_err(|(found, expected)| wrong(1, found, expected))?;
            first = Some((header, setting));
        }
        parts.push(shard);
        let Some((_, setting)) = &first else { continue };
        let mut jobs = setting.jobs();
        jobs.retain(|job| shard.holds(job));
        // Each part has its own jobs, so none of these can be there yet.
        all.extend(entries::<S>(path, setting, &jobs, contents.lines)?);
    }
    let Some((header, setting)) = first else {
        return Err(ExperimentError::choice("files", "none", "the records of every part"));
    };
    let jobs = setting.jobs();
    let mut missing = jobs.iter().filter(|job| !all.contains_key(&job.place()));
    if let Some(job) = missing.next() {
        let of = header.shard().of;
        let holds = |number: &u32| Shard { number: *number, of }.holds(job);
        let number = (1..=of).find(holds).unwrap_or(of);
        return Err(ExperimentError::Incomplete {
            missing: missing.count() + 1,
            all: jobs.len(),
            first: format!("{} of shard {number}/{of}", job.name()),
        });
    }
    Ok((setting, all))
}
