//! Guards around each input: no panic, bounded time, bounded memory.
//!
//! The input stands in a file before it is tried, so that one that ends the process is there afterwards.

use std::alloc::System;
use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use cap::Cap;

/// All that one input may take, the process included.
const MOST_BYTES: usize = 1 << 30;

/// Seconds of the clock for one input; the machine may have other work.
const MOST_SECONDS: u64 = 60;

#[global_allocator]
static ALLOCATOR: Cap<System> = Cap::new(System, usize::MAX);

pub struct Guard {
    begun: Instant,
    /// Milliseconds since `begun` at which the present input was begun; `IDLE` between inputs.
    since: Arc<AtomicU64>,
    file: Arc<Mutex<PathBuf>>,
}

const IDLE: u64 = u64::MAX;

impl Guard {
    pub fn start() -> Self {
        ALLOCATOR.set_limit(MOST_BYTES).expect("less is in use by now");
        let begun = Instant::now();
        let since = Arc::new(AtomicU64::new(IDLE));
        let file = Arc::new(Mutex::new(PathBuf::new()));
        let (watched, named) = (Arc::clone(&since), Arc::clone(&file));
        std::thread::spawn(move || {
            loop {
                std::thread::sleep(Duration::from_secs(1));
                let since = watched.load(Ordering::SeqCst);
                let now = begun.elapsed().as_millis() as u64;
                if since != IDLE && now.saturating_sub(since) > MOST_SECONDS * 1000 {
                    eprintln!("more than {MOST_SECONDS} s: {}", named.lock().unwrap().display());
                    std::process::exit(1);
                }
            }
        });
        let named = Arc::clone(&file);
        let usual = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |panic| {
            usual(panic);
            if let Ok(file) = named.try_lock() {
                eprintln!("the input is in {}", file.display());
            }
        }));
        Self { begun, since, file }
    }

    /// Runs the work on an input under the guards.
    pub fn watched(&self, target: &str, input: &str, work: impl FnOnce() -> String) -> String {
        let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("target/fuzz");
        let path = folder.join(format!("{target}.input"));
        if !path.exists() {
            std::fs::create_dir_all(&folder).unwrap();
        }
        std::fs::write(&path, input).unwrap();
        *self.file.lock().unwrap() = path;
        self.since.store(self.begun.elapsed().as_millis() as u64, Ordering::SeqCst);
        let answer = work();
        self.since.store(IDLE, Ordering::SeqCst);
        answer
    }
}
