//! The arguments of `mo-copp experiment`.

use std::path::PathBuf;

use clap::{Args, Subcommand};
use mo_copp::domain::pddl::import::{CandidateOptions, ImportOptions};
use mo_copp::experiment::benchmarks::{BenchmarkLimits, Benchmarks};
use mo_copp::experiment::{Figure, InitialBeliefs, Setting, SettingLimits, Shard};
use mo_copp::solver::Solver;

/// Repeat the paper's experiments, or run solvers on other people's problems.
#[derive(Debug, Args)]
#[command(after_help = "\
A run writes its records into the folder --out while it is at work; stopped, it goes on where it was when it is
started again in the same way. At its end it writes results.json, tables (Markdown and CSV) and figures (SVG).

Examples:
  mo-copp experiment fig3
  mo-copp experiment fig4 --problems 5 --domain blocksworld --out try
  mo-copp experiment fig3 --shard 2/8 --jobs 1 --out shared
  mo-copp experiment benchmarks goal-recognition --time-limit 20
  mo-copp experiment benchmarks competition --candidates 5 --seed 1 --out tasks
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
    /// Solvers on every goal-recognition problem, competition task and document below a folder.
    Benchmarks(BenchmarkArgs),
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

/// Solvers on other people's problems.
#[derive(Debug, Args)]
#[command(after_help = "\
A problem is a folder with template.pddl or hyps.dat in it (Ramírez and Geffner's layout), an archive of one
(.tar, .tar.gz, .tgz, .tar.bz2, .tbz2, .zip), a competition task (.pddl) with its domain beside it (domain.pddl, or domain02.pddl
for p02.pddl) or a document (.json), anywhere below FOLDER; links to folders are not followed. The candidate goals of a task are
its goal and others in which the objects of the goal change places, as import makes them.
Its domain is the folder directly below FOLDER that it is in. One that cannot be read has records with the reason.")]
pub struct BenchmarkArgs {
    /// The folder with the problems.
    #[arg(value_name = "FOLDER")]
    pub folder: PathBuf,
    /// This solver. May be given several times [default: satisficing, search, exact, baseline].
    #[arg(long, value_name = "SOLVER", value_parser = crate::cli::args::solver)]
    pub solver: Vec<Solver>,
    /// At least N goals are left to the enemy [default: half of them, at least 2].
    #[arg(long, value_name = "N")]
    pub k: Option<usize>,
    /// At most N goals are left to the friend [default: half of them, at least 2].
    #[arg(long, value_name = "N")]
    pub j: Option<usize>,
    /// The symbol that the enemy sees of each action of an imported problem, as a template.
    #[arg(long, value_name = "TEMPLATE", default_value_t = ImportOptions::default().adversarial_sensor)]
    pub adversarial_sensor: String,
    /// The symbol that the friend sees.
    #[arg(long, value_name = "TEMPLATE", default_value_t = ImportOptions::default().cooperative_sensor)]
    pub cooperative_sensor: String,
    /// How many candidate goals a competition task has.
    #[arg(long, value_name = "N", default_value_t = CandidateOptions::default().candidates)]
    pub candidates: usize,
    /// The seed of those that are not the goal of the task.
    #[arg(long, value_name = "S", default_value_t = CandidateOptions::default().seed)]
    pub seed: u64,
    /// The folder for records and tables.
    #[arg(long, value_name = "DIR", default_value = "results/benchmarks")]
    pub out: PathBuf,
    /// How many problems are solved at a time. More than one make each other slower.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub jobs: usize,
    /// Part I of N of the run, for a scheduler; merge puts the parts together.
    #[arg(long, value_name = "I/N")]
    pub shard: Option<Shard>,
    /// Memory for states, beliefs and nodes of all solvers at work, counted by contents; the
    /// process takes up to three times as much.
    #[arg(long, value_name = "MIB", default_value_t = BenchmarkLimits::default().memory_mib)]
    pub memory_limit: u64,
    /// Expansions of each solver on each problem [default: no limit].
    #[arg(long, value_name = "N")]
    pub expansions: Option<u64>,
    /// Stop each solver after this many seconds of work, looked at between two steps; none for no limit.
    /// One that does not stop is ended 5 s later, reading included. Where the limit is met, the record
    /// says so and depends on the machine.
    #[arg(long, value_name = "SECONDS", default_value_t = TimeLimit(BenchmarkLimits::default().seconds))]
    pub time_limit: TimeLimit,
    /// Does this one problem with the first solver and prints its record: a run does each job in a
    /// process of its own.
    #[arg(long, hide = true)]
    pub child: Option<String>,
    /// The domain of that problem.
    #[arg(long, hide = true)]
    pub child_domain: Option<String>,
    /// The bytes of states, beliefs and nodes that it may take.
    #[arg(long, hide = true)]
    pub child_bytes: Option<u64>,
}

/// Seconds, or none.
#[derive(Debug, Clone, Copy)]
pub struct TimeLimit(pub Option<u64>);

impl std::fmt::Display for TimeLimit {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.0 {
            Some(seconds) => seconds.fmt(f),
            None => "none".fmt(f),
        }
    }
}

impl std::str::FromStr for TimeLimit {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.parse() {
            Ok(seconds) => Ok(Self(Some(seconds))),
            Err(_) if text == "none" => Ok(Self(None)),
            Err(_) => Err(format!("found {text}, expected a whole number of seconds, or none")),
        }
    }
}

impl BenchmarkArgs {
    /// The candidate goals of tasks.
    pub fn candidates(&self) -> CandidateOptions {
        CandidateOptions { candidates: self.candidates, seed: self.seed }
    }

    /// What the run is about, its problems left out.
    pub fn benchmarks(&self) -> Benchmarks {
        let solvers = match self.solver.as_slice() {
            [] => Benchmarks::SOLVERS.to_vec(),
            solvers => solvers.to_vec(),
        };
        Benchmarks {
            problems: Vec::new(),
            solvers,
            k: self.k,
            j: self.j,
            adversarial_sensor: self.adversarial_sensor.clone(),
            cooperative_sensor: self.cooperative_sensor.clone(),
            tasks: self.candidates(),
            limits: BenchmarkLimits {
                memory_mib: self.memory_limit,
                expansions: self.expansions,
                seconds: self.time_limit.0,
            },
        }
    }
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
