//! `mo-copp experiment benchmarks`: solvers on every problem below a folder.

use std::path::Path;

use mo_copp::domain::Document;
use mo_copp::domain::pddl::import::{CandidateOptions, ImportOptions, import};
use mo_copp::experiment::benchmarks::{
    Benchmark, BenchmarkRecord, BenchmarkRun, BenchmarkSummary, Benchmarks, tables, write,
};
use mo_copp::experiment::records::Entries;
use mo_copp::experiment::series::{Attempt, Ended, Series, SeriesRecord};

use super::args::BenchmarkArgs;
use super::child::Children;
use super::find::{Kind, find, kind, place};
use super::{Part, made, part};
use crate::cli::error::CliError;
use crate::cli::import::{files, task};
use crate::cli::{LIMIT, input, interrupt, note, print};

/// Runs; the exit code.
pub fn run(args: &BenchmarkArgs) -> Result<u8, CliError> {
    let mut benchmarks = args.benchmarks();
    if let Some(path) = &args.child {
        return child(args, benchmarks, path);
    }
    benchmarks.problems = find(&args.folder)?;
    benchmarks.check()?;
    let folder = made(args.out.clone())?;
    let solving = Children { benchmarks: &benchmarks, folder: &args.folder };
    match part(&benchmarks, &solving, &folder, args.shard, args.jobs)? {
        Part::Whole(entries) => conclude(&folder, &benchmarks, &entries),
        Part::Done(code) => Ok(code),
    }
}

/// Does one job and prints its record, or null where it needs more memory.
fn child(args: &BenchmarkArgs, mut benchmarks: Benchmarks, path: &str) -> Result<u8, CliError> {
    let (domain, digest) = (args.child_domain.clone().unwrap_or_default(), String::new());
    benchmarks.problems = vec![Benchmark { path: path.to_owned(), domain, digest }];
    let options = ImportOptions {
        adversarial_sensor: benchmarks.adversarial_sensor.clone(),
        cooperative_sensor: benchmarks.cooperative_sensor.clone(),
        ..ImportOptions::default()
    };
    let read = |path: &str| read(&args.folder, path, &options, args.candidates());
    let solving = BenchmarkRun { benchmarks: &benchmarks, read };
    let bytes = args.child_bytes.unwrap_or_else(|| solving.memory_mib() << 20);
    let stop = interrupt::stop();
    let mut jobs = benchmarks.jobs();
    jobs.truncate(1);
    for job in jobs {
        let line = match solving.attempt(&job, bytes, &stop)? {
            Ended::Answered(record) => record.line(),
            Ended::MoreMemory => "null".to_owned(),
            Ended::Stopped => return Ok(LIMIT),
        };
        print(&(line + "\n"))?;
    }
    Ok(0)
}

/// Writes what follows from all records, and prints the tables.
pub fn conclude(
    folder: &Path,
    run: &Benchmarks,
    entries: &Entries<BenchmarkRecord>,
) -> Result<u8, CliError> {
    write(folder, run, entries)?;
    print(&tables(run, &BenchmarkSummary::new(run, entries)))?;
    note(&format!("records and tables are in {}", folder.display()));
    Ok(0)
}

/// The document of a problem; why not, with names as they are below the folder.
fn read(
    folder: &Path,
    path: &str,
    options: &ImportOptions,
    candidates: CandidateOptions,
) -> Result<Document, String> {
    let place = place(folder, path);
    let read = || match kind(&place) {
        Some(Kind::Document) => input::document_alone(&place),
        Some(Kind::Task(files)) => Ok(task::read(&files, options, candidates)?.document.into()),
        _ => Ok(import(&files(&place)?, options)?.document.into()),
    };
    // The domain of a task is in the folder of the task.
    let shown = |place: &Path| place.display().to_string();
    let of_parent = |error: String| match (place.parent(), path.rsplit_once('/')) {
        (Some(parent), Some((above, _))) => error.replace(&shown(parent), above),
        _ => error,
    };
    let below = |error: CliError| of_parent(error.to_string().replace(&shown(&place), path));
    read().map_err(below)
}
