//! Ctrl-C and its kin: one flag that all work looks at, and work that cannot be cut.

use std::any::Any;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, OnceLock};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use super::LIMIT;
use super::error::CliError;

/// How often the flag is looked at.
const EVERY: Duration = Duration::from_millis(50);

/// Set once a signal asks the command to stop; a second wish ends it at once. Signals are heard
/// from the first call on.
pub fn stop() -> Arc<AtomicBool> {
    static STOP: OnceLock<Arc<AtomicBool>> = OnceLock::new();
    let stop = STOP.get_or_init(|| {
        let stop = Arc::new(AtomicBool::new(false));
        let on_signal = Arc::clone(&stop);
        let mut insistence = Insistence::default();
        // Without a handler a signal ends the process, which is no worse.
        let _ = ctrlc::set_handler(move || {
            on_signal.store(true, Ordering::SeqCst);
            if insistence.again() {
                std::process::exit(i32::from(LIMIT));
            }
        });
        stop
    });
    Arc::clone(stop)
}

/// Does work that cannot be cut, on a thread of its own; none where a signal comes before its end,
/// which leaves the work behind.
///
/// # Errors
///
/// [`CliError::Defect`] where the work panics.
pub fn unless_stopped<T: Send + 'static>(
    work: impl FnOnce() -> T + Send + 'static,
) -> Result<Option<T>, CliError> {
    let stop = stop();
    let (sender, receiver) = channel();
    let thread = thread::spawn(move || {
        // The receiver is gone once the work has been left behind.
        let _ = sender.send(work());
    });
    loop {
        match receiver.recv_timeout(EVERY) {
            Ok(done) => return Ok(Some(done)),
            Err(RecvTimeoutError::Timeout) if stop.load(Ordering::SeqCst) => return Ok(None),
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => return Err(defect(thread)),
        }
    }
}

/// What became of a thread that has ended without an answer.
pub fn defect(thread: JoinHandle<()>) -> CliError {
    let told = |panic: Box<dyn Any + Send>| match panic.downcast::<String>() {
        Ok(text) => *text,
        Err(panic) => panic.downcast_ref::<&str>().unwrap_or(&"a panic").to_string(),
    };
    let what = thread.join().map_or_else(told, |()| "a thread ended without an answer".to_owned());
    CliError::Defect { what }
}

/// Tells a second wish to stop from the same one heard twice: a scheduler that stops a process and
/// its group sends it two signals at once.
#[derive(Debug, Default)]
struct Insistence {
    first: Option<Instant>,
}

impl Insistence {
    /// What comes sooner after the first signal belongs to it.
    const APART: Duration = Duration::from_millis(500);

    /// Hears a signal; whether it is a wish of its own after the first.
    fn again(&mut self) -> bool {
        self.first.get_or_insert_with(Instant::now).elapsed() >= Self::APART
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::panic, clippy::unwrap_used)]

    use super::*;

    #[test]
    fn work_that_panics_is_a_defect() {
        let failed = unless_stopped(|| -> u8 { panic!("{} went wrong", "this") }).unwrap_err();
        let message = "a defect of this program, please report it: this went wrong";
        assert_eq!(failed.to_string(), message);
        let failed = unless_stopped(|| -> u8 { panic!("plain") }).unwrap_err();
        assert!(failed.to_string().ends_with(": plain"));
        assert_eq!(unless_stopped(|| 3).unwrap(), Some(3));
    }
}
