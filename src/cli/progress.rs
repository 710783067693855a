//! Runs a solver with progress on a terminal, and stops it on Ctrl-C with the best plan kept.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};
use mo_copp::problem::Problem;
use mo_copp::solver::{Options, Outcome, Progress, Solver, abandoned, solve};

use super::error::CliError;

/// Work that takes no longer than this shows no progress.
const QUIET: Duration = Duration::from_secs(1);
/// How often progress is shown.
const EVERY: Duration = Duration::from_millis(100);
/// So many slices are told of at once.
const FIRST_SLICES: u64 = 2;
/// How long a solver may take to stop after Ctrl-C before it is left behind: one step of the
/// integer program cannot be cut.
const PATIENCE: Duration = Duration::from_secs(2);

enum Message {
    Progress(Progress),
    Done(Result<Outcome, mo_copp::solver::SolveError>),
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
    let stop = Arc::new(AtomicBool::new(false));
    let on_signal = Arc::clone(&stop);
    // Without a handler Ctrl-C ends the process, which is no worse.
    let _ = ctrlc::set_handler(move || {
        if on_signal.swap(true, Ordering::SeqCst) {
            // Asked twice: whoever it is does not want to wait for the best plan.
            std::process::exit(i32::from(super::LIMIT));
        }
    });
    let (sender, receiver) = channel();
    {
        let (problem, options, stop) = (Arc::clone(problem), options.clone(), Arc::clone(&stop));
        thread::spawn(move || {
            let mut told = Instant::now();
            let mut slices = 0_u64;
            let outcome = solve(problem, options, |run| {
                slices += 1;
                // The first plan comes early; what follows may take long.
                if slices <= FIRST_SLICES || told.elapsed() >= EVERY {
                    told = Instant::now();
                    // Nobody listens any more when the run has been left behind.
                    let _ = sender.send(Message::Progress(run.progress()));
                }
                if stop.load(Ordering::SeqCst) {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            });
            let _ = sender.send(Message::Done(outcome));
        });
    }
    let bar = ProgressBar::new_spinner();
    if let Ok(style) = ProgressStyle::with_template("{spinner} {elapsed} {msg} (Ctrl-C stops)") {
        bar.set_style(style);
    }
    let mut last: Option<Progress> = None;
    let mut stopped: Option<Instant> = None;
    let outcome = loop {
        match receiver.recv_timeout(EVERY) {
            Ok(Message::Done(outcome)) => break outcome?,
            Ok(Message::Progress(progress)) => {
                bar.set_message(line(&progress));
                last = Some(progress);
            }
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => {
                break abandoned(problem, options, last.as_ref())?;
            }
        }
        if begin.elapsed() >= QUIET {
            bar.tick();
        }
        if stop.load(Ordering::SeqCst) {
            let since = *stopped.get_or_insert_with(Instant::now);
            bar.set_message("stopping with the best plan found; again to end at once");
            if since.elapsed() >= PATIENCE {
                break abandoned(problem, options, last.as_ref())?;
            }
        }
    };
    bar.finish_and_clear();
    Ok(Solved { outcome, seconds: begin.elapsed().as_secs_f64(), stop })
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
