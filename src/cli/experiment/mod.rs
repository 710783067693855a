//! `mo-copp experiment`: runs the paper's experiments, and merges their shards.

pub mod args;
mod progress;

use std::path::{Path, PathBuf};

use mo_copp::experiment::records::{Entries, write_sorted};
use mo_copp::experiment::{
    ExperimentError, Figure, Header, InitialBeliefs, RecordFile, Setting, Shard, Summary, merge,
    output, run,
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
        ExperimentCommand::Merge(args) => merge_shards(args),
    }
}

/// The folder of a run: unless told otherwise one for each figure, and one for drawn beliefs.
fn folder(out: Option<&PathBuf>, setting: &Setting) -> Result<PathBuf, ExperimentError> {
    let name = match setting.beliefs {
        InitialBeliefs::Known => setting.figure.name().to_owned(),
        InitialBeliefs::Drawn => format!("{}-drawn-beliefs", setting.figure.name()),
    };
    let folder = out.cloned().unwrap_or_else(|| Path::new("results").join(name));
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
    let workers = match args.jobs {
        Some(0) => {
            let expected = "a whole number from 1";
            return Err(ExperimentError::choice("jobs", "0", expected).into());
        }
        Some(jobs) => jobs,
        None => std::thread::available_parallelism().map_or(1, usize::from),
    };
    let folder = folder(args.out.as_ref(), &setting)?;
    let shard = args.shard.unwrap_or(Shard::WHOLE);
    let path = folder.join(match args.shard {
        None => "records.jsonl".to_owned(),
        Some(Shard { number, of }) => format!("records-{number}-of-{of}.jsonl"),
    });
    let mut jobs = setting.jobs();
    jobs.retain(|job| shard.holds(job));
    let header = Header::new(&setting, shard);
    let mut records = RecordFile::open(&path, &header, &setting, &jobs)?;
    let watch = Watch::new(jobs.len(), records.entries().len());
    let complete =
        run(&setting, &jobs, workers, &mut records, watch.stop(), &|event| watch.report(event))?;
    watch.finish();
    let entries = records.entries().clone();
    drop(records);
    if !complete {
        let (done, all) = (entries.len(), jobs.len());
        note(&format!("stopped with {done} of {all} records in {}", path.display()));
        note("the same command goes on from there");
        return Ok(LIMIT);
    }
    write_sorted(&path, &header, &entries)?;
    if args.shard.is_some() {
        note(&format!("shard {shard} is complete: {}", path.display()));
        return Ok(0);
    }
    conclude(&folder, &setting, &entries)
}

fn merge_shards(args: &MergeArgs) -> Result<u8, CliError> {
    let (setting, entries) = merge(&args.files)?;
    let folder = folder(args.out.as_ref(), &setting)?;
    let path = folder.join("records.jsonl");
    write_sorted(&path, &Header::new(&setting, Shard::WHOLE), &entries)?;
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
