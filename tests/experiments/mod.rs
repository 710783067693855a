//! The paper's experiments: statistics, records, shards and what is written of them.

mod output;
mod records;
mod runs;
mod shards;
mod statistics;
mod validity;

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use mo_copp::domain::generate::Domain;
use mo_copp::experiment::{
    ExperimentError, Figure, Header, Job, RecordFile, Setting, Shard, TestDomain, run,
};

/// Figure 3 on gridworlds, without the paper's encoding, which takes long.
pub fn fig3(problems: u32) -> Setting {
    let mut setting = Setting { problems, ..Setting::new(Figure::Fig3) };
    setting.domains.truncate(1);
    setting.limits.paper_nodes = None;
    setting
}

/// Figure 4 on a domain that takes no time.
pub fn fig4(problems: u32) -> Setting {
    let domain = TestDomain { domain: Domain::Delivery, title: "Delivery", horizon: 3 };
    Setting { problems, domains: vec![domain], ..Setting::new(Figure::Fig4) }
}

/// Figure 4 on Blocksworld.
pub fn blocks(problems: u32) -> Setting {
    let mut setting = Setting { problems, ..Setting::new(Figure::Fig4) };
    setting.domains.truncate(1);
    setting
}

/// An empty folder.
pub fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("experiments").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// The jobs of a part of a run.
pub fn jobs(setting: &Setting, shard: Shard) -> Vec<Job> {
    let mut jobs = setting.jobs();
    jobs.retain(|job| shard.holds(job));
    jobs
}

/// Opens the records of a part of a run.
pub fn open(path: &Path, setting: &Setting, shard: Shard) -> Result<RecordFile, ExperimentError> {
    RecordFile::open(path, &Header::new(setting, shard), setting, &jobs(setting, shard))
}

/// Does what is left of a part of a run; how many jobs that was.
pub fn work(path: &Path, setting: &Setting, shard: Shard, workers: usize) -> usize {
    let mut records = open(path, setting, shard).unwrap();
    let before = records.entries().len();
    let stop = AtomicBool::new(false);
    let jobs = jobs(setting, shard);
    assert!(run(setting, &jobs, workers, &mut records, &stop, &|_| ()).unwrap());
    assert_eq!(records.entries().len(), jobs.len());
    jobs.len() - before
}

/// The records of a file in the order of the jobs, without their seconds.
pub fn records(path: &Path, setting: &Setting, shard: Shard) -> Vec<serde_json::Value> {
    let file = open(path, setting, shard).unwrap();
    let without = |entry: &mo_copp::experiment::records::Entry| {
        let mut json: serde_json::Value = serde_json::from_str(&entry.line).unwrap();
        let seconds = json.as_object_mut().unwrap().remove("seconds");
        assert!(seconds.unwrap().as_f64().unwrap() >= 0.0);
        json
    };
    file.entries().values().map(without).collect()
}
