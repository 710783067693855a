//! `mo-copp experiment`: runs the paper's experiments and benchmarks, and merges their shards.

pub mod args;
mod benchmarks;
mod child;
mod find;
mod progress;

use std::path::{Path, PathBuf};

use mo_copp::experiment::benchmarks::{BENCHMARKS, Benchmarks};
use mo_copp::experiment::records::{Entries, experiment, write_sorted};
use mo_copp::experiment::series::{Attempt, Series};
use mo_copp::experiment::{
    ExperimentError, Figure, InitialBeliefs, RecordFile, Setting, Shard, Summary, merge, output,
    run,
};

use super::error::CliError;
use super::{LIMIT, note, print};
use args::{ExperimentArgs, ExperimentCommand, MergeArgs, RunArgs};
use progress::Watch;

/// Runs or merges; the exit code.
pub fn run_command(args: &ExperimentArgs) -> Result<u8, CliError> {
    match &args.command {
        ExperimentCommand::Fig3(args) => {
            let mut setting = args.setting(Figure::Fig3);
            setting.limits.paper_nodes = (!args.extra.no_paper).then_some(args.extra.paper_nodes);
            setting.limits.paper_nonzeros = args.extra.paper_nonzeros;
            figure(args, setting)
        }
        ExperimentCommand::Fig4(args) => {
            let mut setting = args.setting(Figure::Fig4);
            setting.beliefs = args.extra.initial_beliefs;
            figure(args, setting)
        }
        ExperimentCommand::Benchmarks(args) => benchmarks::run(args),
        ExperimentCommand::Merge(args) => merge_shards(args),
    }
}

/// The folder of a run: unless told otherwise one for each figure, and one for drawn beliefs.
fn folder(out: Option<&PathBuf>, setting: &Setting) -> Result<PathBuf, ExperimentError> {
    let name = match setting.beliefs {
        InitialBeliefs::Known => setting.figure.name().to_owned(),
        InitialBeliefs::Drawn => format!("{}-drawn-beliefs", setting.figure.name()),
    };
    made(out.cloned().unwrap_or_else(|| Path::new("results").join(name)))
}

/// A folder, made where it is not there.
fn made(folder: PathBuf) -> Result<PathBuf, ExperimentError> {
    std::fs::create_dir_all(&folder)
        .map_err(|error| ExperimentError::File { file: folder.display().to_string(), error })?;
    Ok(folder)
}

fn figure<T: clap::Args>(args: &RunArgs<T>, mut setting: Setting) -> Result<u8, CliError> {
    let figure = setting.figure;
    if !args.domain.is_empty() {
        let named = |name: &String| {
            figure.domain_named(name).ok_or_else(|| {
                let names: Vec<_> = figure.domains().iter().map(|d| d.domain.name()).collect();
                let expected = format!("one of {}", names.join(", "));
                ExperimentError::choice("domain", name, expected)
            })
        };
        setting.domains = args.domain.iter().map(named).collect::<Result<_, _>>()?;
    }
    setting.check()?;
    let jobs =
        args.jobs.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, usize::from));
    let folder = folder(args.out.as_ref(), &setting)?;
    match part(&setting, &setting, &folder, args.shard, jobs)? {
        Part::Whole(entries) => conclude(&folder, &setting, &entries),
        Part::Done(code) => Ok(code),
    }
}

/// What a run comes to.
enum Part<R> {
    /// All records of the whole series.
    Whole(Entries<R>),
    /// A part of them, with the exit code.
    Done(u8),
}

/// Does the jobs of a series that have no record yet, or those of a shard of it, several at a time.
fn part<S: Series>(
    series: &S,
    solving: &impl Attempt<S>,
    folder: &Path,
    shard: Option<Shard>,
    workers: usize,
) -> Result<Part<S::Record>, CliError> {
    if workers == 0 {
        return Err(ExperimentError::choice("jobs", "0", "a whole number from 1").into());
    }
    let name = match shard {
        None => "records.jsonl".to_owned(),
        Some(Shard { number, of }) => format!("records-{number}-of-{of}.jsonl"),
    };
    let path = folder.join(name);
    let held = shard.unwrap_or(Shard::WHOLE);
    let mut jobs = series.jobs();
    jobs.retain(|job| held.holds(job));
    let header = series.header(held);
    let mut records = RecordFile::open(&path, &header, series, &jobs)?;
    let watch = Watch::new(jobs.len(), records.entries().len());
    let complete =
        run(solving, &jobs, workers, &mut records, watch.stop(), &|event| watch.report(&event))?;
    watch.finish();
    let entries = records.entries().clone();
    drop(records);
    if !complete {
        let (done, all) = (entries.len(), jobs.len());
        note(&format!("stopped with {done} of {all} records in {}", path.display()));
        note("the same command goes on from there");
        return Ok(Part::Done(LIMIT));
    }
    write_sorted(&path, &header, &entries)?;
    if let Some(shard) = shard {
        note(&format!("shard {shard} is complete: {}", path.display()));
        return Ok(Part::Done(0));
    }
    Ok(Part::Whole(entries))
}

fn merge_shards(args: &MergeArgs) -> Result<u8, CliError> {
    let first = args.files.first().and_then(|path| experiment(path));
    if first.is_some_and(|experiment| experiment == BENCHMARKS) {
        let (run, entries) = merge::<Benchmarks>(&args.files)?;
        let out = args.out.clone().unwrap_or_else(|| Path::new("results").join(BENCHMARKS));
        let folder = made(out)?;
        write_sorted(&folder.join("records.jsonl"), &run.header(Shard::WHOLE), &entries)?;
        return benchmarks::conclude(&folder, &run, &entries);
    }
    let (setting, entries) = merge::<Setting>(&args.files)?;
    let folder = folder(args.out.as_ref(), &setting)?;
    write_sorted(&folder.join("records.jsonl"), &setting.header(Shard::WHOLE), &entries)?;
    conclude(&folder, &setting, &entries)
}

/// Writes what follows from all records, and prints the tables.
fn conclude(folder: &Path, setting: &Setting, entries: &Entries) -> Result<u8, CliError> {
    let summary = Summary::new(setting, entries);
    output::write(folder, &summary, entries)?;
    print(&output::markdown(&summary))?;
    note(&format!("records, tables and figures are in {}", folder.display()));
    Ok(0)
}
