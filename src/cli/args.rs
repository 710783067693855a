//! The arguments.

use std::path::PathBuf;

use super::exercise::args::{ExerciseArgs, GradeArgs};
use super::experiment::args::ExperimentArgs;
use super::picture::args::PictureArgs;
use clap::{Args, Parser, Subcommand};
use mo_copp::domain::generate::Domain;
use mo_copp::limits::Limits;
use mo_copp::solver::{Encoding, Horizon, MAX_HORIZON, Solver};

/// Plans that a friend understands and an enemy does not.
#[derive(Debug, Parser)]
#[command(name = "mo-copp", version, about, max_term_width = 100)]
#[command(after_help = "\
Examples:
  mo-copp generate gridworld --seed 1 > grid.json
  mo-copp solve grid.json --solver exact
  mo-copp solve grid.json --solver ip --horizon 12 --json
  mo-copp solve grid.json --solver satisficing --k 2 --j 2
  mo-copp trace grid.json --plan north,north,east
  mo-copp plan domain.pddl task.pddl
  mo-copp experiment fig3 --problems 5

Exit codes: 0 a plan, 1 there is none, 2 bad input or usage, 3 a limit was met and no plan found.")]
pub struct CommandLine {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Find a plan: the best one, or one that keeps bounds.
    Solve(SolveArgs),
    /// Replay a plan and show what each observer makes of it.
    Trace(TraceArgs),
    /// Print the integer program in LP format, for any other solver.
    Encode(EncodeArgs),
    /// Find a plan for a task in PDDL that nobody watches.
    Plan(PlanArgs),
    /// Draw the boards of a step as SVG or PNG, or of a whole plan as SVG.
    Picture(PictureArgs),
    /// Print a random problem document.
    Generate(GenerateArgs),
    /// Make a document of a goal-recognition problem or a competition task.
    Import(ImportArgs),
    /// Print what an observer of a PDDL document sees as a table in CSV, or put such a table into the document.
    Sensor(SensorArgs),
    /// Print the JSON Schema of problem documents, for editors and other programs.
    Schema,
    /// Print a script that completes the command in a shell.
    Completions(CompletionsArgs),
    /// Print the manual page of the command, or of one of its commands.
    Manual(ManualArgs),
    /// Show an exercise or a variant of it, check an answer.
    Exercise(ExerciseArgs),
    /// Grade the answer codes of a course: a table with score and reason for each.
    Grade(GradeArgs),
    /// Repeat the paper's experiments: records, tables, figures.
    Experiment(ExperimentArgs),
}

/// Sensors as tables.
#[derive(Debug, Args)]
#[command(after_help = "\
The table has a first line operator,symbol and then one line for each operator.

Examples:
  mo-copp sensor blocks.json --observer adversarial > table.csv
  mo-copp sensor blocks.json --observer adversarial --table table.csv > other.json")]
pub struct SensorArgs {
    /// A pddl document, or - for the standard input.
    #[arg(value_name = "PROBLEM")]
    pub problem: PathBuf,
    /// Whose sensor: adversarial or cooperative.
    #[arg(long, value_name = "ROLE")]
    pub observer: String,
    /// A table in CSV that becomes the observer's sensor. The document with it is printed.
    #[arg(long, value_name = "FILE")]
    pub table: Option<PathBuf>,
    /// The template of symbols for operators that are not in the table.
    #[arg(long, value_name = "TEMPLATE", requires = "table")]
    pub otherwise: Option<String>,
}

/// Completions.
#[derive(Debug, Args)]
pub struct CompletionsArgs {
    /// The shell.
    pub shell: clap_complete::Shell,
}

/// The manual.
#[derive(Debug, Args)]
pub struct ManualArgs {
    /// One of the commands, as in solve; the whole command when left out.
    pub command: Option<String>,
}

/// Make a document of a goal-recognition problem or a competition task.
#[derive(Debug, Args)]
#[command(after_help = "\
FOLDER or ARCHIVE (.tar.bz2, .tar.gz, .tar, .zip) holds domain.pddl, template.pddl, hyps.dat, real_hyp.dat
and perhaps obs.dat, as in the goal-recognition literature.

A competition task has one goal, which becomes the true one, G1. G2, G3, … are the same goal with its objects in each
other's places, those of one type among themselves. A FOLDER with tasks gives a document for each of them: one a
line, or a file for each in the folder --out. The domain of a task in a folder is domain.pddl beside it, or
domain02.pddl for p02.pddl.

Examples:
  mo-copp import block-words_p01 > blocks.json
  mo-copp import problem.tar.bz2 --true-goal 3 --out blocks.json --plan-out plan.txt
  mo-copp import problem.zip --all --out documents
  mo-copp import domain.pddl p07.pddl --candidates 5 --seed 1 --out p07.json
  mo-copp import logistics --out documents")]
pub struct ImportArgs {
    /// A folder or an archive with the files of one problem, the domain of a task, or a folder with tasks.
    #[arg(value_name = "FOLDER|ARCHIVE|DOMAIN.pddl")]
    pub source: PathBuf,
    /// A competition task.
    #[arg(value_name = "TASK.pddl")]
    pub task: Option<PathBuf>,
    /// How many candidate goals a task has [default: 5].
    #[arg(long, value_name = "N")]
    pub candidates: Option<usize>,
    /// The seed of those that are not the goal of the task [default: 1].
    #[arg(long, value_name = "S")]
    pub seed: Option<u64>,
    /// What the enemy sees of each action: a template of symbols.
    #[arg(long, value_name = "TEMPLATE", default_value = "{name}")]
    pub adversarial_sensor: String,
    /// What the friend sees of each action.
    #[arg(long, value_name = "TEMPLATE", default_value = "{name} {1}")]
    pub cooperative_sensor: String,
    /// Objects that look alike to the enemy, as in box=a,b. May be given several times.
    #[arg(long, value_name = "NAME=OBJECTS")]
    pub adversarial_group: Vec<String>,
    /// Objects that look alike to the friend. May be given several times.
    #[arg(long, value_name = "NAME=OBJECTS")]
    pub cooperative_group: Vec<String>,
    /// The true goal: the hypothesis of this number in hyps.dat, from 1. That of the problem when left out.
    #[arg(long, value_name = "N", conflicts_with = "all")]
    pub true_goal: Option<usize>,
    /// One document for each hypothesis as true goal: one a line, or files G1.json, G2.json, … in the folder --out.
    #[arg(long)]
    pub all: bool,
    /// Where to write the document, instead of the standard output; with --all or a folder of tasks a folder.
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Where to write the actions of obs.dat as a plan for trace --plan-file, if they are a whole plan for the true goal.
    #[arg(long, value_name = "FILE", conflicts_with = "all")]
    pub plan_out: Option<PathBuf>,
}

/// What the plan must achieve.
#[derive(Debug, Args)]
pub struct BoundsArgs {
    /// At least K candidate goals are possible for the enemy at the end.
    #[arg(long, value_name = "K")]
    pub k: Option<usize>,
    /// At most J candidate goals are possible for the friend at the end.
    #[arg(long, value_name = "J")]
    pub j: Option<usize>,
    /// This goal is possible for this observer at the end, as in adversarial:G2. May be given several times.
    #[arg(long, value_name = "ROLE:GOAL")]
    pub require: Vec<String>,
    /// This goal is not possible for this observer at the end. May be given several times.
    #[arg(long, value_name = "ROLE:GOAL")]
    pub forbid: Vec<String>,
}

/// Find a plan.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true)]
#[command(after_help = "\
Solvers:
  exact        the best goal difference of all plans (of T actions with --horizon T), proved
  ip           the same for T actions, by integer programming
  satisficing  a plan that keeps the bounds --k and --j, or the proof that there is none:
               Algorithm 1 for 2,000 nodes, then exact search
  search       the same by Algorithm 1 of the paper alone
  baseline     a plan for the true goal alone
  obfuscate    Algorithm 1 with --k alone
  legible      Algorithm 1 with --j alone

Examples:
  mo-copp solve grid.json --solver exact --pairs
  mo-copp solve grid.json --solver exact --lengths 30
  mo-copp solve grid.json --solver ip --encoding paper --horizon 6
  mo-copp solve grid.json --solver ip --horizon 12 --horizon-step 2
  mo-copp solve grid.json --solver exact --require adversarial:G2 --forbid cooperative:G3
  cat grid.json | mo-copp solve - --solver satisficing --k 2 --j 2 --json")]
pub struct SolveArgs {
    /// The problem document; - for the standard input.
    pub problem: PathBuf,
    /// Who solves it.
    #[arg(long, value_parser = solver, value_name = "SOLVER", default_value = "exact")]
    pub solver: Solver,
    /// Which integer program.
    #[arg(long, value_parser = encoding, value_name = "ENCODING", default_value = "belief-flow")]
    pub encoding: Encoding,
    /// The number of actions of the plan, or any. Left out: any, but for the integer program, which
    /// starts from the length of a shortest plan.
    #[arg(long, value_parser = horizon, value_name = "T|any")]
    pub horizon: Option<Horizon>,
    /// While the horizon has no plan, raise it by S. For exact and ip.
    #[arg(long, value_name = "S", default_value_t = 0)]
    pub horizon_step: usize,
    /// How far to raise the horizon.
    #[arg(long, value_name = "T", default_value_t = 100)]
    pub horizon_limit: usize,
    /// What the plan must achieve.
    #[command(flatten)]
    pub bounds: BoundsArgs,
    /// Every reachable pair of counts of possible goals with a plan for each, and the Pareto front of them;
    /// where a limit comes first, those found until then. For exact.
    #[arg(long)]
    pub pairs: bool,
    /// The old name of --pairs: the JSON has the pairs under the key pareto.
    #[arg(long)]
    pub pareto: bool,
    /// The best plan of every length from 0 to L. For exact, without a horizon.
    #[arg(long, value_name = "L")]
    pub lengths: Option<usize>,
    /// The most that a plan may cost: its cost where the problem's PDDL has costs, elsewhere the number
    /// of its actions. For all solvers.
    #[arg(long, value_name = "N")]
    pub cost_limit: Option<u64>,
    /// One JSON object instead of text.
    #[arg(long)]
    pub json: bool,
    /// Where to stop.
    #[command(flatten)]
    pub limits: LimitArgs,
}

/// Where a search stops.
#[derive(Debug, Args)]
pub struct SearchLimitArgs {
    /// Memory for states, beliefs and nodes, counted by contents; the process takes up to three
    /// times as much.
    #[arg(long = "memory-limit", value_name = "MIB", default_value_t = 640)]
    pub memory: u64,
    /// Expansions of the exact solver or of a search.
    #[arg(long = "expansion-limit", value_name = "N")]
    pub expansions: Option<u64>,
}

impl SearchLimitArgs {
    /// The limits meant.
    pub fn limits(&self) -> Limits {
        Limits::default()
            .with_bytes(self.memory.saturating_mul(1 << 20))
            .with_expansions(self.expansions.unwrap_or(u64::MAX))
    }
}

/// Where to stop.
#[derive(Debug, Args)]
pub struct LimitArgs {
    /// Where a search stops.
    #[command(flatten)]
    pub search: SearchLimitArgs,
    /// Branch-and-bound nodes of the integer program.
    #[arg(long = "node-limit", value_name = "N")]
    pub nodes: Option<u64>,
}

/// Replay a plan.
#[derive(Debug, Args)]
#[command(after_help = "\
The exit code is 1 when the plan does not end in the true goal, or costs more than --cost-limit.

Examples:
  mo-copp trace grid.json --plan north,north,east
  mo-copp trace grid.json --plan-file plan.txt --json")]
pub struct TraceArgs {
    /// The problem document; - for the standard input.
    pub problem: PathBuf,
    /// The actions, with commas between them.
    #[arg(long, value_name = "A,B,C", conflicts_with = "plan_file")]
    pub plan: Option<String>,
    /// A file with one action a line; - for the standard input.
    #[arg(long, value_name = "FILE", required_unless_present = "plan")]
    pub plan_file: Option<PathBuf>,
    /// The most that the plan may cost, or its number of actions where the problem has no costs.
    #[arg(long, value_name = "N")]
    pub cost_limit: Option<u64>,
    /// One JSON object instead of text.
    #[arg(long)]
    pub json: bool,
}

/// Print the integer program.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true)]
#[command(after_help = "\
Examples:
  mo-copp encode grid.json --encoding belief-flow --horizon 12 > grid.lp
  highs grid.lp")]
pub struct EncodeArgs {
    /// The problem document; - for the standard input.
    pub problem: PathBuf,
    /// Which integer program.
    #[arg(long, value_parser = encoding, value_name = "ENCODING", default_value = "belief-flow")]
    pub encoding: Encoding,
    /// The number of actions of the plan.
    #[arg(long, value_name = "T")]
    pub horizon: usize,
    /// The most that the plan may cost.
    #[arg(long, value_name = "N")]
    pub cost_limit: Option<u64>,
    /// What the plan must achieve.
    #[command(flatten)]
    pub bounds: BoundsArgs,
}

/// Find a plan for a task in PDDL.
#[derive(Debug, Args)]
#[command(after_help = "\
Greedy best-first search with the set-additive heuristic: the first plan found, one operator a line.
Read are STRIPS domains with types, equality and negative preconditions.

Examples:
  mo-copp plan domain.pddl task.pddl
  mo-copp plan domain.pddl task.pddl --json")]
pub struct PlanArgs {
    /// The domain; - for the standard input.
    pub domain: PathBuf,
    /// The task; - for the standard input.
    pub task: PathBuf,
    /// One JSON object instead of text.
    #[arg(long)]
    pub json: bool,
    /// Where to stop.
    #[command(flatten)]
    pub limits: SearchLimitArgs,
}

/// Print a random problem.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true)]
#[command(after_help = "\
The same seed gives the same document everywhere.

Examples:
  mo-copp generate gridworld --seed 7 --width 6 --height 6 --walls 5
  mo-copp generate recycling-robot --seed 7 --battery-levels 7
  mo-copp generate delivery --seed 7 --packages 5
  mo-copp generate blocksworld --seed 7 --blocks 4")]
pub struct GenerateArgs {
    /// What kind of problem: gridworld, box-pushing, recycling-robot, delivery, blocksworld,
    /// logistics or driverlog.
    #[arg(value_parser = domain, value_name = "DOMAIN")]
    pub domain: Domain,
    /// The seed of the random numbers.
    #[arg(long, value_name = "N")]
    pub seed: u64,
    /// Columns of a grid [default: the paper's].
    #[arg(long, value_name = "N")]
    pub width: Option<u32>,
    /// Rows of a grid [default: the paper's].
    #[arg(long, value_name = "N")]
    pub height: Option<u32>,
    /// Candidate goals [default: 3, in the domains in PDDL 5].
    #[arg(long, value_name = "N")]
    pub goals: Option<u32>,
    /// Walls in a grid [default: 0].
    #[arg(long, value_name = "N")]
    pub walls: Option<u32>,
    /// States in each initial belief [default: 11 cells of a gridworld, 4 ways a robot with a box
    /// could look, 4 cells of a recycling robot, 1 state in PDDL]. In the domains in PDDL each
    /// observer has from 1 to N, drawn for itself.
    #[arg(long, value_name = "N")]
    pub belief: Option<u32>,
    /// Levels of a recycling robot's battery [default: 5].
    #[arg(long, value_name = "N")]
    pub battery_levels: Option<u32>,
    /// Factories of a delivery [default: 3].
    #[arg(long, value_name = "N")]
    pub factories: Option<u32>,
    /// Packages of a delivery [default: 6], logistics [6] or driverlog [2].
    #[arg(long, value_name = "N")]
    pub packages: Option<u32>,
    /// How many packages to deliver [default: 2].
    #[arg(long, value_name = "N")]
    pub deliver: Option<u32>,
    /// Blocks of a blocksworld [default: 5].
    #[arg(long, value_name = "N")]
    pub blocks: Option<u32>,
}

fn named<T: Copy>(
    text: &str,
    all: &[T],
    name: impl Fn(T) -> &'static str,
    found: Option<T>,
) -> Result<T, String> {
    let names: Vec<&str> = all.iter().map(|&value| name(value)).collect();
    found.ok_or_else(|| format!("found {text}, expected one of {}", names.join(", ")))
}

pub fn solver(text: &str) -> Result<Solver, String> {
    named(text, &Solver::ALL, Solver::name, Solver::named(text))
}

fn domain(text: &str) -> Result<Domain, String> {
    named(text, &Domain::ALL, Domain::name, Domain::named(text))
}

fn encoding(text: &str) -> Result<Encoding, String> {
    named(text, &Encoding::ALL, Encoding::name, Encoding::named(text))
}

fn horizon(text: &str) -> Result<Horizon, String> {
    if text == "any" {
        return Ok(Horizon::Any);
    }
    let steps = text.parse().ok().filter(|steps| *steps <= MAX_HORIZON);
    let expected =
        || format!("found {text}, expected a whole number from 0 to {MAX_HORIZON}, or any");
    steps.map(Horizon::Steps).ok_or_else(expected)
}
