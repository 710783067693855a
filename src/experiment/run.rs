//! Runs the jobs of an experiment on several threads.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread;

use super::records::RecordFile;
use super::series::{Attempt, Ended, Series, SeriesJob};
use super::{ExperimentError, Job};

/// What happens while a run is at work.
#[derive(Debug, Clone, Copy)]
pub enum Event<'a, J = Job> {
    /// A job is begun.
    Begun(&'a J),
    /// A job has its record.
    Recorded(&'a J),
    /// A job has to wait until fewer jobs share the memory.
    PutOff(&'a J),
}

/// Does the jobs that have no record yet, `workers` at a time; true when all of them have one,
/// false when the run was stopped before.
///
/// The memory limit of the series is for the whole process: each job gets its share, and one that
/// needs more is done again with fewer at its side, the last ones alone. So a job stops at the same
/// limit, and leaves the same record, however many there are at a time.
///
/// # Errors
///
/// A problem cannot be drawn, a solver breaks down, or the records cannot be written.
pub fn run<S: Series>(
    solving: &impl Attempt<S>,
    jobs: &[S::Job],
    workers: usize,
    records: &mut RecordFile<S>,
    stop: &AtomicBool,
    report: &(dyn Fn(Event<'_, S::Job>) + Sync),
) -> Result<bool, ExperimentError> {
    let done = records.entries();
    let mut waiting: Vec<&S::Job> =
        jobs.iter().filter(|job| !done.contains_key(&job.place())).collect();
    let mut workers = workers.max(1);
    let records = Mutex::new(records);
    while !waiting.is_empty() {
        let bytes = (solving.memory_mib() << 20) / workers as u64;
        let jobs = std::mem::take(&mut waiting);
        let round = Round { solving, jobs: &jobs, bytes, records: &records, stop, report };
        let Some(put_off) = round.run(workers)? else { return Ok(false) };
        waiting = put_off.into_iter().map(|index| jobs[index]).collect();
        workers = (workers / 2).max(1);
    }
    Ok(true)
}

/// Jobs that share the memory in equal parts.
struct Round<'a, 'f, S: Series, A> {
    solving: &'a A,
    jobs: &'a [&'a S::Job],
    bytes: u64,
    records: &'a Mutex<&'f mut RecordFile<S>>,
    stop: &'a AtomicBool,
    report: &'a (dyn Fn(Event<'_, S::Job>) + Sync),
}

impl<S: Series, A: Attempt<S>> Round<'_, '_, S, A> {
    /// The places of the jobs that need more memory; none when the run was stopped.
    fn run(&self, workers: usize) -> Result<Option<Vec<usize>>, ExperimentError> {
        let next = AtomicUsize::new(0);
        let failed = AtomicBool::new(false);
        let results: Vec<Result<Vec<usize>, ExperimentError>> = thread::scope(|scope| {
            let work = || {
                let mut put_off = Vec::new();
                while !self.stop.load(Ordering::SeqCst) && !failed.load(Ordering::SeqCst) {
                    let index = next.fetch_add(1, Ordering::SeqCst);
                    let Some(job) = self.jobs.get(index) else { break };
                    match self.one(job) {
                        Ok(true) => {}
                        Ok(false) => put_off.push(index),
                        Err(error) => {
                            failed.store(true, Ordering::SeqCst);
                            return Err(error);
                        }
                    }
                }
                Ok(put_off)
            };
            let threads: Vec<_> =
                (0..workers.min(self.jobs.len())).map(|_| scope.spawn(work)).collect();
            let join = |thread: thread::ScopedJoinHandle<'_, _>| match thread.join() {
                Ok(result) => result,
                Err(panic) => std::panic::resume_unwind(panic),
            };
            threads.into_iter().map(join).collect()
        });
        let mut put_off = Vec::new();
        for result in results {
            put_off.extend(result?);
        }
        if self.stop.load(Ordering::SeqCst) {
            return Ok(None);
        }
        put_off.sort_unstable();
        Ok(Some(put_off))
    }

    /// Whether the job needs no more memory than there is.
    fn one(&self, job: &S::Job) -> Result<bool, ExperimentError> {
        (self.report)(Event::Begun(job));
        match self.solving.attempt(job, self.bytes, self.stop)? {
            Ended::Answered(record) => {
                // A thread that panics ends the run, so nobody meets what it left behind.
                let mut records = match self.records.lock() {
                    Ok(records) => records,
                    Err(poisoned) => poisoned.into_inner(),
                };
                records.add(job, *record)?;
                drop(records);
                (self.report)(Event::Recorded(job));
            }
            Ended::MoreMemory => {
                (self.report)(Event::PutOff(job));
                return Ok(false);
            }
            Ended::Stopped => {}
        }
        Ok(true)
    }
}
