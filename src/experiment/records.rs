//! A file of records: it only grows while a run is at work, so that a stopped run can go on.
//!
//! The first line is the header. A last line without its end was torn when the run was stopped and
//! is dropped; any other line that is no record of the run is an error.

use std::collections::BTreeMap;
use std::fs::{File, OpenOptions};
use std::io::{BufRead, BufReader, ErrorKind, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use fs4::{FileExt, TryLockError};
use serde::Serialize;
use serde::de::DeserializeOwned;

use super::series::{Series, SeriesHeader, SeriesJob, SeriesRecord};
use super::{ExperimentError, Record, Setting};

/// A record and the line it was read from, which is kept as it is.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry<R = Record> {
    /// The record.
    pub record: R,
    /// Its line, without the end.
    pub line: String,
    /// The number of the line, from 1.
    pub number: usize,
}

/// The records of a run by their places in it.
pub type Entries<R = Record> = BTreeMap<usize, Entry<R>>;

/// What a file of records says.
#[derive(Debug)]
pub struct Contents<H> {
    /// Its first line; none in a file that was stopped while it was written.
    pub header: Option<H>,
    /// The lines after it that are whole.
    pub lines: Vec<(usize, String)>,
    /// How many bytes of the file are whole lines.
    pub whole: u64,
    /// What stands behind them.
    pub torn: String,
}

/// Reads a file of records up to its last whole line.
///
/// # Errors
///
/// The file cannot be read, or does not begin as a file of records does.
pub fn read<H: DeserializeOwned>(path: &Path) -> Result<Contents<H>, ExperimentError> {
    let mut text = Vec::new();
    let read = File::open(path).and_then(|mut file| file.read_to_end(&mut text));
    read.map_err(|error| ExperimentError::file(path, error))?;
    contents(path, &text)
}

/// The experiment that a file of records says it belongs to, where its first line says one.
pub fn experiment(path: &Path) -> Option<String> {
    let mut line = String::new();
    BufReader::new(File::open(path).ok()?).read_line(&mut line).ok()?;
    let header: serde_json::Value = serde_json::from_str(&line).ok()?;
    Some(header.get("experiment")?.as_str()?.to_owned())
}

fn contents<H: DeserializeOwned>(
    path: &Path,
    bytes: &[u8],
) -> Result<Contents<H>, ExperimentError> {
    let whole = bytes.iter().rposition(|&byte| byte == b'\n').map_or(0, |end| end + 1);
    let torn = String::from_utf8_lossy(&bytes[whole..]).into_owned();
    let text = std::str::from_utf8(&bytes[..whole]).map_err(|error| {
        let line = bytes[..error.valid_up_to()].split(|&byte| byte == b'\n').count();
        wrong(path, line, "something else", "UTF-8 text")
    })?;
    let mut lines = (1..).zip(text.lines().map(str::to_owned));
    let header = match lines.next() {
        None => None,
        Some((number, line)) => Some(serde_json::from_str(&line).map_err(|error| {
            wrong(path, number, short(&line), format!("the header of a file of records ({error})"))
        })?),
    };
    Ok(Contents { header, lines: lines.collect(), whole: whole as u64, torn })
}

fn wrong(
    path: &Path,
    line: usize,
    found: impl Into<String>,
    expected: impl Into<String>,
) -> ExperimentError {
    ExperimentError::Line {
        file: path.display().to_string(),
        line,
        found: found.into(),
        expected: expected.into(),
    }
}

/// The beginning of a line, for a message.
fn short(line: &str) -> String {
    const SHOWN: usize = 60;
    let mut shown: String = line.chars().take(SHOWN).collect();
    if shown.len() < line.len() {
        shown.push('…');
    }
    format!("{shown:?}")
}

/// Takes the lines of a file as records of a run.
///
/// # Errors
///
/// A line is no record of these jobs, or the second one of its job.
pub fn entries<S: Series>(
    path: &Path,
    series: &S,
    jobs: &[S::Job],
    lines: Vec<(usize, String)>,
) -> Result<Entries<S::Record>, ExperimentError> {
    let known: BTreeMap<String, &S::Job> = jobs.iter().map(|job| (job.name(), job)).collect();
    let mut entries = Entries::new();
    for (number, line) in lines {
        let record: S::Record = serde_json::from_str(&line)
            .map_err(|error| wrong(path, number, short(&line), format!("a record ({error})")))?;
        let found = record.job_name();
        let job = known.get(&found);
        let job = job.ok_or_else(|| wrong(path, number, found.clone(), "a record of this part"))?;
        series.check(&record, job).map_err(|(beside, expected)| {
            wrong(path, number, format!("{found}{beside}"), expected)
        })?;
        if let Some(first) = entries.get(&job.place()) {
            let expected = format!("each record once; this one is on line {}", first.number);
            return Err(wrong(path, number, found, expected));
        }
        entries.insert(job.place(), Entry { record, line, number });
    }
    Ok(entries)
}

/// The file a run writes.
#[derive(Debug)]
pub struct RecordFile<S: Series = Setting> {
    path: PathBuf,
    file: File,
    entries: Entries<S::Record>,
}

impl<S: Series> RecordFile<S> {
    /// Opens the file of a run, or makes it. What is in it already is not done again.
    ///
    /// # Errors
    ///
    /// Another run is writing the file, it belongs to another run, or it cannot be written.
    pub fn open(
        path: &Path,
        header: &S::Header,
        series: &S,
        jobs: &[S::Job],
    ) -> Result<Self, ExperimentError> {
        let failed = |error| ExperimentError::file(path, error);
        let mut options = OpenOptions::new();
        options.read(true).write(true).create(true).truncate(false);
        let mut file = options.open(path).map_err(failed)?;
        match FileExt::try_lock(&file) {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => {
                return Err(ExperimentError::InUse { file: path.display().to_string() });
            }
            // Some file systems know no locks; nothing else depends on them.
            Err(TryLockError::Error(error)) if error.kind() == ErrorKind::Unsupported => {}
            Err(TryLockError::Error(error)) => return Err(failed(error)),
        }
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(failed)?;
        let contents = contents::<S::Header>(path, &bytes)?;
        let first = serde_json::to_string(header).unwrap_or_default();
        let entries = match &contents.header {
            Some(found) => {
                if let Some((field, found, expected)) = found.difference(header) {
                    let expected =
                        format!("{field} {expected}; to begin another run choose another --out");
                    return Err(wrong(path, 1, format!("{field} {found}"), expected));
                }
                entries(path, series, jobs, contents.lines)?
            }
            None if first.starts_with(&contents.torn) => Entries::new(),
            None => {
                let expected = "the header of a file of records";
                return Err(wrong(path, 1, short(&contents.torn), expected));
            }
        };
        file.set_len(contents.whole).map_err(failed)?;
        file.seek(SeekFrom::End(0)).map_err(failed)?;
        let mut opened = Self { path: path.to_owned(), file, entries };
        if contents.header.is_none() {
            opened.write(&first)?;
        }
        Ok(opened)
    }

    /// The records so far.
    pub fn entries(&self) -> &Entries<S::Record> {
        &self.entries
    }

    /// Where they are.
    pub fn path(&self) -> &Path {
        &self.path
    }

    fn write(&mut self, line: &str) -> Result<(), ExperimentError> {
        let line = format!("{line}\n");
        let written = self.file.write_all(line.as_bytes()).and_then(|()| self.file.flush());
        written.map_err(|error| ExperimentError::file(&self.path, error))
    }

    /// Adds the record of a job at the end.
    ///
    /// # Errors
    ///
    /// The file cannot be written.
    pub fn add(&mut self, job: &S::Job, record: S::Record) -> Result<(), ExperimentError> {
        let line = record.line();
        self.write(&line)?;
        let number = self.entries.len() + 2;
        self.entries.insert(job.place(), Entry { record, line, number });
        Ok(())
    }
}

/// Writes a file of records in the order of the jobs, in one step: a reader sees the old file or the
/// new one.
///
/// # Errors
///
/// The file cannot be written.
pub fn write_sorted<R>(
    path: &Path,
    header: &impl Serialize,
    entries: &Entries<R>,
) -> Result<(), ExperimentError> {
    let mut text = serde_json::to_string(header).unwrap_or_default() + "\n";
    for entry in entries.values() {
        text += &entry.line;
        text.push('\n');
    }
    super::output::replace(path, &text)
}
