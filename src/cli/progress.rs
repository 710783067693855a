//! Runs a solver with progress on a terminal, and stops it on Ctrl-C with the best plan kept.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};
use mo_copp::problem::Problem;
use mo_copp::solver::{Options, Outcome, Progress, Solver, abandoned, solve};

use super::error::CliError;
use super::interrupt;

/// Work that takes no longer than this shows no progress.
const QUIET: Duration = Duration::from_secs(1);
/// How often progress is shown.
const EVERY: Duration = Duration::from_millis(100);
/// So many slices are told of at once.
const FIRST_SLICES: u64 = 2;
/// How long a solver may take to stop after Ctrl-C before it is left behind: one step of the
/// integer program cannot be cut.
const PATIENCE: Duration = Duration::from_secs(2);

enum Message<P, T> {
    Progress(P),
    Done(T),
}

/// Where work says how far it is, and hears whether to stop.
pub struct Watcher<P, T> {
    sender: Sender<Message<P, T>>,
    stop: Arc<AtomicBool>,
    told: Instant,
    slices: u64,
}

impl<P, T> Watcher<P, T> {
    /// After each slice of work.
    pub fn slice(&mut self, progress: impl FnOnce() -> P) -> ControlFlow<()> {
        self.slices += 1;
        // The first plan comes early; what follows may take long.
        if self.slices <= FIRST_SLICES || self.told.elapsed() >= EVERY {
            self.told = Instant::now();
            // The receiver is gone once the work has been left behind.
            let _ = self.sender.send(Message::Progress(progress()));
        }
        if self.stop.load(Ordering::SeqCst) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }
}

/// Does work on a thread of its own and shows how far it is. On Ctrl-C the work is asked to stop;
/// where it does not for long, `abandoned` makes the answer of what was last heard of it. Also
/// returned is what is set once a signal asks to stop.
///
/// # Errors
///
/// [`CliError::Defect`] where the work panics.
pub fn watched<P: Send + 'static, T: Send + 'static>(
    work: impl FnOnce(&mut Watcher<P, T>) -> T + Send + 'static,
    line: impl Fn(&P) -> String,
    abandoned: impl FnOnce(Option<&P>) -> T,
) -> Result<(T, Arc<AtomicBool>), CliError> {
    let begin = Instant::now();
    let stop = interrupt::stop();
    let (sender, receiver) = channel();
    let mut watcher = Watcher { sender, stop: Arc::clone(&stop), told: begin, slices: 0 };
    let thread = thread::spawn(move || {
        let done = work(&mut watcher);
        let _ = watcher.sender.send(Message::Done(done));
    });
    let bar = ProgressBar::new_spinner();
    if let Ok(style) = ProgressStyle::with_template("{spinner} {elapsed} {msg} (Ctrl-C stops)") {
        bar.set_style(style);
    }
    let mut last: Option<P> = None;
    let mut stopped: Option<Instant> = None;
    let done = loop {
        match receiver.recv_timeout(EVERY) {
            Ok(Message::Done(done)) => break done,
            Ok(Message::Progress(progress)) => {
                bar.set_message(line(&progress));
                last = Some(progress);
            }
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => {
                bar.finish_and_clear();
                return Err(interrupt::defect(thread));
            }
        }
        if begin.elapsed() >= QUIET {
            bar.tick();
        }
        if stop.load(Ordering::SeqCst) {
            let since = *stopped.get_or_insert_with(Instant::now);
            bar.set_message("stopping with the best plan found; again to end at once");
            if since.elapsed() >= PATIENCE {
                break abandoned(last.as_ref());
            }
        }
    };
    bar.finish_and_clear();
    Ok((done, stop))
}

/// What came of it.
pub struct Solved {
    /// The outcome.
    pub outcome: Outcome,
    /// The seconds it took.
    pub seconds: f64,
    /// Set once somebody wants to stop.
    pub stop: Arc<AtomicBool>,
}

/// Solves a problem.
pub fn solve_watched(problem: &Arc<Problem>, options: &Options) -> Result<Solved, CliError> {
    let begin = Instant::now();
    let (asked, wanted) = (Arc::clone(problem), options.clone());
    let (outcome, stop) = watched(
        move |watcher| solve(asked, wanted, |run| watcher.slice(|| run.progress())),
        line,
        |last| abandoned(problem, options, last),
    )?;
    Ok(Solved { outcome: outcome?, seconds: begin.elapsed().as_secs_f64(), stop })
}

fn line(progress: &Progress) -> String {
    let unit = if progress.solver == Solver::Ip { "nodes" } else { "expansions" };
    let mut parts = vec![format!("{} {unit}", progress.done)];
    parts.extend(progress.horizon.map(|horizon| format!("{horizon} actions")));
    parts.extend(progress.goal_difference.map(|best| format!("best found {best:.3}")));
    parts.extend(progress.bound.map(|bound| format!("at most {bound:.3}")));
    parts.extend(progress.gap().map(|gap| format!("gap {gap:.3}")));
    parts.join(", ")
}

#[cfg(test)]
mod tests {
    #![allow(clippy::panic, clippy::unwrap_used)]

    use super::*;

    #[test]
    fn a_solver_that_panics_is_a_defect_and_was_not_stopped() {
        let work = |watcher: &mut Watcher<u8, u8>| -> u8 {
            let _ = watcher.slice(|| 1);
            panic!("out of order")
        };
        let failed = watched(work, u8::to_string, |_| 7).unwrap_err();
        assert!(failed.to_string().starts_with("a defect of this program"), "{failed}");
        assert!(failed.to_string().ends_with("out of order"), "{failed}");
    }
}
