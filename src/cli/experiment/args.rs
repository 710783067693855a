//! The arguments of `mo-copp experiment`.

use std::path::PathBuf;

use clap::{Args, Subcommand};
use mo_copp::experiment::{Figure, InitialBeliefs, Setting, SettingLimits, Shard};

/// Repeat the paper's experiments.
#[derive(Debug, Args)]
#[command(after_help = "\
A run writes its records into the folder --out while it is at work; stopped, it goes on where it was when it is
started again in the same way. At its end it writes results.json, tables (Markdown and CSV) and figures (SVG).

Examples:
  mo-copp experiment fig3
  mo-copp experiment fig4 --problems 5 --domain blocksworld --out try
  mo-copp experiment fig3 --shard 2/8 --jobs 1 --out shared
  mo-copp experiment merge shared/records-*-of-8.jsonl --out shared

Exit codes: 0 all records are there, 2 bad input or usage, 3 stopped before the end.")]
pub struct ExperimentArgs {
    /// Which.
    #[command(subcommand)]
    pub command: ExperimentCommand,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum ExperimentCommand {
    /// Figure 3: baseline, integer program and search on three small domains.
    Fig3(RunArgs<PaperArgs>),
    /// Figure 4: the search against obfuscation alone and legibility alone on three IPC domains.
    Fig4(RunArgs<BeliefArgs>),
    /// Put the records of all shards together, and write tables and figures.
    Merge(MergeArgs),
}

/// What a run is about.
#[derive(Debug, Args)]
pub struct RunArgs<T: Args> {
    /// How many problems of each domain.
    #[arg(long, value_name = "N", default_value_t = 30)]
    pub problems: u32,
    /// The seed of the first problem of each domain; the others have the seeds that follow.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub seed: u64,
    /// This domain alone. May be given several times.
    #[arg(long, value_name = "DOMAIN")]
    pub domain: Vec<String>,
    /// The folder for records, tables and figures [default: results/FIGURE].
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// How many problems are solved at a time [default: one for each core].
    #[arg(long, value_name = "N")]
    pub jobs: Option<usize>,
    /// Part I of N of the run, for a scheduler; merge puts the parts together.
    #[arg(long, value_name = "I/N")]
    pub shard: Option<Shard>,
    /// Memory for states, beliefs and nodes of all solvers at work, counted by contents; the
    /// process takes up to three times as much.
    #[arg(long, value_name = "MIB", default_value_t = SettingLimits::default().memory_mib)]
    pub memory_limit: u64,
    /// Expansions of the exact solver where it looks at plans of many lengths.
    #[arg(long, value_name = "N", default_value_t = SettingLimits::default().exact_expansions)]
    pub exact_expansions: u64,
    /// Expansions of Algorithm 1, with both bounds or one.
    #[arg(long, value_name = "N", default_value_t = SettingLimits::default().search_expansions)]
    pub search_expansions: u64,
    /// A safety: stop each solver after so many seconds, looked at between two steps of its work.
    /// Where it is met, the answer depends on the machine.
    #[arg(long, value_name = "SECONDS")]
    pub time_limit: Option<u64>,
    /// The options that only one of the figures has.
    #[command(flatten)]
    pub extra: T,
}

/// The initial beliefs of Figure 4.
#[derive(Debug, Args)]
pub struct BeliefArgs {
    /// What the observers believe at first: known, the initial state alone; or drawn, from 1 to 8
    /// states for each observer by itself, so that the friend may begin in more doubt.
    #[arg(long, value_name = "known|drawn", value_parser = initial_beliefs, default_value = "known")]
    pub initial_beliefs: InitialBeliefs,
}

fn initial_beliefs(text: &str) -> Result<InitialBeliefs, String> {
    let named = InitialBeliefs::ALL.into_iter().find(|beliefs| beliefs.name() == text);
    named.ok_or_else(|| {
        format!(
            "found {text}, expected {}",
            InitialBeliefs::ALL.map(InitialBeliefs::name).join(" or ")
        )
    })
}

/// The paper's encoding in Figure 3.
#[derive(Debug, Args)]
pub struct PaperArgs {
    /// Leave out the integer program in the paper's encoding.
    #[arg(long)]
    pub no_paper: bool,
    /// Branch-and-bound nodes of the paper's encoding.
    #[arg(long, value_name = "N", default_value_t = SettingLimits::default().paper_nodes.unwrap_or_default())]
    pub paper_nodes: u64,
    /// Nonzero coefficients of the paper's encoding; larger programs are not tried.
    #[arg(long, value_name = "N", default_value_t = SettingLimits::default().paper_nonzeros)]
    pub paper_nonzeros: u64,
}

/// Put shards together.
#[derive(Debug, Args)]
pub struct MergeArgs {
    /// The files of records of all parts of a run.
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// The folder for records, tables and figures [default: results/FIGURE].
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

impl<T: Args> RunArgs<T> {
    /// What the run is about, the domains left out.
    pub fn setting(&self, figure: Figure) -> Setting {
        Setting {
            seed: self.seed,
            problems: self.problems,
            limits: SettingLimits {
                memory_mib: self.memory_limit,
                exact_expansions: self.exact_expansions,
                search_expansions: self.search_expansions,
                seconds: self.time_limit,
                ..SettingLimits::default()
            },
            ..Setting::new(figure)
        }
    }
}
