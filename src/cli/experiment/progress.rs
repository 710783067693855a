//! Shows how far an experiment is, and stops it on Ctrl-C.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};
use mo_copp::experiment::Event;
use mo_copp::experiment::series::SeriesJob;

use crate::cli::{LIMIT, interrupt};

/// How long solvers may take to stop after Ctrl-C before they are left behind: one step of an
/// integer program cannot be cut. Every record is in the file the moment it is made, so nothing is
/// lost.
const PATIENCE: Duration = Duration::from_secs(2);
/// How often the bar is drawn, and looked whether to stop.
const EVERY: Duration = Duration::from_millis(200);
/// So many names of jobs at work are shown.
const SHOWN: usize = 3;

/// Watches a run.
pub struct Watch {
    bar: ProgressBar,
    stop: Arc<AtomicBool>,
    at_work: Mutex<BTreeMap<usize, String>>,
}

impl Watch {
    /// A bar for so many jobs, of which some are done, and a handler of Ctrl-C.
    pub fn new(jobs: usize, done: usize) -> Self {
        let stop = interrupt::stop();
        let on_signal = Arc::clone(&stop);
        thread::spawn(move || {
            while !on_signal.load(Ordering::SeqCst) {
                thread::sleep(EVERY);
            }
            thread::sleep(PATIENCE);
            eprintln!("mo-copp: stopped; the same command goes on from there");
            std::process::exit(i32::from(LIMIT));
        });
        let bar = ProgressBar::new(jobs as u64).with_position(done as u64);
        let template = "{elapsed_precise} {bar:30} {pos}/{len} {eta_precise} left  {msg}";
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style);
        }
        // What was done before says nothing about how long the rest takes.
        bar.reset_eta();
        bar.enable_steady_tick(EVERY);
        Self { bar, stop, at_work: Mutex::new(BTreeMap::new()) }
    }

    /// Whether the run is to stop.
    pub fn stop(&self) -> &AtomicBool {
        &self.stop
    }

    /// Takes note of what a run tells.
    pub fn report<J: SeriesJob>(&self, event: &Event<'_, J>) {
        let mut at_work = self.at_work.lock().unwrap_or_else(PoisonError::into_inner);
        match *event {
            Event::Begun(job) => {
                at_work.insert(job.place(), job.name());
            }
            Event::Recorded(job) => {
                at_work.remove(&job.place());
                self.bar.inc(1);
            }
            Event::PutOff(job) => {
                at_work.remove(&job.place());
            }
        }
        let names: Vec<&str> = at_work.values().take(SHOWN).map(String::as_str).collect();
        self.bar.set_message(names.join(", "));
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}
