//! Series: what experiments have in common, whatever is solved and written down.
//!
//! A series lists its jobs; each leaves a record in a file whose first line, the header, says what series
//! it belongs to. [`RecordFile`](super::RecordFile), [`run`](super::run()) and [`merge`](super::merge())
//! work on any series.

use std::fmt::Debug;
use std::sync::atomic::AtomicBool;

use serde::Serialize;
use serde::de::DeserializeOwned;

use super::{ExperimentError, Shard};
use crate::limits::LimitReached;
use crate::solver::Outcome;

/// Whether the solver, or a part of it, met the memory limit: with more memory the answer or its work may be another.
pub(super) fn met_memory_limit(outcome: &Outcome) -> bool {
    outcome.stats.memory_stops > 0 || matches!(outcome.limit, Some(LimitReached::Memory { .. }))
}

/// One problem for one solver.
pub trait SeriesJob: Sync {
    /// Its place in the records of a whole run.
    fn place(&self) -> usize;

    /// Its place in an order in which what takes about as long stands together: jobs are dealt out to
    /// shards by it.
    fn deal(&self) -> usize;

    /// What tells it from all others, in words.
    fn name(&self) -> String;
}

/// The first line of a file of records.
pub trait SeriesHeader: Serialize + DeserializeOwned + Clone + Debug {
    /// The part of the run.
    fn shard(&self) -> Shard;

    /// The header of another part.
    #[must_use]
    fn with_shard(&self, shard: Shard) -> Self;

    /// The first field in which it differs from another: its name, what is here, what is there.
    fn difference(&self, other: &Self) -> Option<(&'static str, String, String)>;
}

/// What a job leaves behind.
pub trait SeriesRecord: Serialize + DeserializeOwned + Clone + Debug + PartialEq + Send {
    /// The name of its job.
    fn job_name(&self) -> String;

    /// The record as a line.
    fn line(&self) -> String {
        // Only texts, numbers and lists: writing them cannot fail.
        serde_json::to_string(self).unwrap_or_default()
    }
}

/// What a run is about.
pub trait Series: Sized {
    /// One problem for one solver.
    type Job: SeriesJob;
    /// The first line of a file of records.
    type Header: SeriesHeader;
    /// What a job leaves behind.
    type Record: SeriesRecord;

    /// All jobs, in the order of the records.
    fn jobs(&self) -> Vec<Self::Job>;

    /// The header of a part of the run.
    fn header(&self, shard: Shard) -> Self::Header;

    /// The run that a header belongs to.
    ///
    /// # Errors
    ///
    /// What was found and what was expected, where this program knows no such run.
    fn of_header(header: &Self::Header) -> Result<Self, (String, String)>;

    /// Checks the record of a job.
    ///
    /// # Errors
    ///
    /// What was found beside the job's name, and what is expected.
    fn check(&self, record: &Self::Record, job: &Self::Job) -> Result<(), (String, String)>;
}

/// How an attempt ended.
#[derive(Debug)]
pub enum Ended<R> {
    /// With an answer.
    Answered(Box<R>),
    /// It would take more memory than it was given.
    MoreMemory,
    /// Somebody asked for the run to stop.
    Stopped,
}

/// What does the jobs of a series.
pub trait Attempt<S: Series>: Sync {
    /// MiB of states, beliefs and nodes that all jobs at work share.
    fn memory_mib(&self) -> u64;

    /// Does a job within this many bytes of states, beliefs and nodes.
    ///
    /// # Errors
    ///
    /// Why the whole run cannot go on.
    fn attempt(
        &self,
        job: &S::Job,
        bytes: u64,
        stop: &AtomicBool,
    ) -> Result<Ended<S::Record>, ExperimentError>;
}
