//! Benchmarks in processes of their own: what does not stop in time is ended, what breaks down is told
//! of, and its memory is free afterwards.

use std::io::Read;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use mo_copp::experiment::ExperimentError;
use mo_copp::experiment::benchmarks::{
    BenchmarkJob, BenchmarkRecord, Benchmarks, NoOutcome, time_limit,
};
use mo_copp::experiment::series::{Attempt, Ended};

use crate::cli::LIMIT;

/// How long a solver may take to stop after its time: one step of its work cannot be cut.
const PATIENCE: Duration = Duration::from_secs(5);

/// How often a process is looked at.
const EVERY: Duration = Duration::from_millis(5);

/// How long a signal takes to reach all processes at most.
const SOON: Duration = Duration::from_secs(1);

/// Benchmarks below a folder.
#[derive(Debug)]
pub struct Children<'a> {
    /// What the run is about.
    pub benchmarks: &'a Benchmarks,
    /// Where the problems are.
    pub folder: &'a Path,
}

/// How a process ended.
#[derive(Debug)]
enum End {
    /// By itself.
    Exit(ExitStatus),
    /// It took too long.
    Late,
    /// Somebody asked for the run to stop.
    Stopped,
}

impl Children<'_> {
    /// The command for a job.
    fn command(&self, job: &BenchmarkJob, bytes: u64) -> std::io::Result<Command> {
        let Benchmarks { k, j, adversarial_sensor, cooperative_sensor, tasks, limits, .. } =
            self.benchmarks;
        let mut command = Command::new(std::env::current_exe()?);
        let option = |name: &str, value: &dyn std::fmt::Display| format!("--{name}={value}");
        command.args(["experiment", "benchmarks"]);
        command.arg(option("child", &job.problem.path));
        command.arg(option("child-domain", &job.problem.domain));
        command.arg(option("child-bytes", &bytes));
        command.arg(option("solver", &job.solver.name()));
        command.args(k.map(|k| option("k", &k)));
        command.args(j.map(|j| option("j", &j)));
        command.arg(option("adversarial-sensor", adversarial_sensor));
        command.arg(option("cooperative-sensor", cooperative_sensor));
        command.arg(option("candidates", &tasks.candidates));
        command.arg(option("seed", &tasks.seed));
        command.arg(option("memory-limit", &limits.memory_mib));
        command.args(limits.expansions.map(|expansions| option("expansions", &expansions)));
        let seconds = limits.seconds.map_or_else(|| "none".to_owned(), |n| n.to_string());
        command.arg(option("time-limit", &seconds));
        command.arg("--").arg(self.folder);
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        Ok(command)
    }

    /// How the process of a job ended, and what it printed.
    fn done(
        &self,
        job: &BenchmarkJob,
        bytes: u64,
        stop: &AtomicBool,
    ) -> std::io::Result<(End, String, String)> {
        let mut child = self.command(job, bytes)?.spawn()?;
        let (out, err) = (reader(child.stdout.take()), reader(child.stderr.take()));
        let longest = self.benchmarks.limits.seconds;
        let longest = longest.map(|seconds| Duration::from_secs(seconds).saturating_add(PATIENCE));
        let end = wait(&mut child, longest, stop)?;
        let read = |thread: thread::JoinHandle<String>| thread.join().unwrap_or_default();
        Ok((end, read(out), read(err)))
    }
}

/// Waits for a process, and ends it where it takes longer than it may or the run is to stop.
fn wait(child: &mut Child, longest: Option<Duration>, stop: &AtomicBool) -> std::io::Result<End> {
    let begin = Instant::now();
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(End::Exit(status));
        }
        let stopped = stop.load(Ordering::SeqCst);
        if stopped || longest.is_some_and(|longest| begin.elapsed() >= longest) {
            // One that has just ended by itself cannot be ended.
            let _ = child.kill();
            child.wait()?;
            return Ok(if stopped { End::Stopped } else { End::Late });
        }
        thread::sleep(EVERY);
    }
}

/// Whether the run is to stop, at once or soon.
fn heard(stop: &AtomicBool) -> bool {
    let begin = Instant::now();
    while !stop.load(Ordering::SeqCst) && begin.elapsed() < SOON {
        thread::sleep(EVERY);
    }
    stop.load(Ordering::SeqCst)
}

/// Reads what a process prints, on a thread of its own: a full pipe would stop the process.
fn reader(from: Option<impl Read + Send + 'static>) -> thread::JoinHandle<String> {
    thread::spawn(move || {
        let mut bytes = Vec::new();
        // What was read until an error came is all there is.
        let _ = from.map(|mut from| from.read_to_end(&mut bytes));
        String::from_utf8_lossy(&bytes).into_owned()
    })
}

impl Attempt<Benchmarks> for Children<'_> {
    fn memory_mib(&self) -> u64 {
        self.benchmarks.limits.memory_mib
    }

    fn attempt(
        &self,
        job: &BenchmarkJob,
        bytes: u64,
        stop: &AtomicBool,
    ) -> Result<Ended<BenchmarkRecord>, ExperimentError> {
        let begin = Instant::now();
        let failed = |error| ExperimentError::File { file: "mo-copp".to_owned(), error };
        let (end, out, err) = self.done(job, bytes, stop).map_err(failed)?;
        let status = match end {
            End::Stopped => return Ok(Ended::Stopped),
            _ if stop.load(Ordering::SeqCst) => return Ok(Ended::Stopped),
            End::Late => None,
            // A signal to all processes of a terminal may reach this one later.
            End::Exit(status) if status.code() == Some(i32::from(LIMIT)) && heard(stop) => {
                return Ok(Ended::Stopped);
            }
            End::Exit(status) => Some(status),
        };
        let why = match (status, serde_json::from_str::<Option<BenchmarkRecord>>(&out)) {
            (None, _) => {
                NoOutcome::Ended(time_limit(self.benchmarks.limits.seconds.unwrap_or_default()))
            }
            (Some(_), Ok(Some(record))) => return Ok(Ended::Answered(Box::new(record))),
            (Some(_), Ok(None)) => return Ok(Ended::MoreMemory),
            (Some(status), Err(_)) => {
                let said = err.lines().find(|line| !line.trim().is_empty()).unwrap_or_default();
                NoOutcome::Failed(format!("{status}: {said}"))
            }
        };
        let times = (0.0, begin.elapsed().as_secs_f64());
        Ok(Ended::Answered(Box::new(BenchmarkRecord::without(job, why, times))))
    }
}

#[cfg(all(test, unix))]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    fn ended(command: &str, longest: Option<Duration>, stop: bool) -> End {
        let mut child = Command::new("sh").args(["-c", command]).spawn().unwrap();
        let begin = Instant::now();
        let end = wait(&mut child, longest, &AtomicBool::new(stop)).unwrap();
        assert!(begin.elapsed() < Duration::from_secs(50), "the process was waited for");
        assert!(child.try_wait().unwrap().is_some(), "the process is gone");
        end
    }

    #[test]
    fn a_process_that_is_late_is_ended() {
        let soon = Some(Duration::from_millis(50));
        assert!(matches!(ended("exec sleep 60", soon, false), End::Late));
        assert!(matches!(ended("exec sleep 60", None, true), End::Stopped));
        let End::Exit(status) = ended("exit 7", None, false) else { unreachable!() };
        assert_eq!(status.code(), Some(7));
    }
}
