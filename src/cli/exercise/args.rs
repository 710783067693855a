//! The arguments of `mo-copp exercise` and `mo-copp grade`.

use std::path::PathBuf;

use clap::{Args, Subcommand};

/// Show an exercise, a variant of it, or what is wrong with an answer.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  mo-copp exercise show exercise.json --solution
  mo-copp exercise variant exercise.json --student \"Ada Lovelace\" > ada.json
  mo-copp exercise check exercise.json --seed 7 --answer G1,G3
  mo-copp exercise check exercise.json --answer 'column 2, row 3' --json")]
pub struct ExerciseArgs {
    /// What to do.
    #[command(subcommand)]
    pub what: ExerciseCommand,
}

/// What to do with an exercise.
#[derive(Debug, Subcommand)]
pub enum ExerciseCommand {
    /// Print the question, and its solution where it is asked for; of seed 0 also what is wrong with its variants.
    Show(ShowArgs),
    /// Print the document of a variant: its problem, with its question as an exercise that does not vary.
    Variant(VariantArgs),
    /// Check an answer: what is wrong with it, and its code. The exit code is 1 where it is wrong.
    Check(CheckArgs),
}

/// Which variant.
#[derive(Debug, Args)]
pub struct SeedArgs {
    /// A document with an exercise; - for the standard input.
    #[arg(value_name = "EXERCISE")]
    pub exercise: PathBuf,
    /// The seed of the variant; 0 is the document's own question.
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u64,
    /// The seed that belongs to a name, in place of a number.
    #[arg(long, value_name = "NAME", conflicts_with = "seed")]
    pub student: Option<String>,
}

impl SeedArgs {
    /// The seed meant.
    pub fn seed(&self) -> u64 {
        self.student.as_deref().map_or(self.seed, mo_copp::exercise::seed_of)
    }
}

/// Print the question.
#[derive(Debug, Args)]
pub struct ShowArgs {
    /// Which variant.
    #[command(flatten)]
    pub which: SeedArgs,
    /// A right answer, and what is known of the difficulty.
    #[arg(long)]
    pub solution: bool,
    /// One JSON object instead of text.
    #[arg(long)]
    pub json: bool,
}

/// Print a variant: to be looked at or printed. It is an exercise of its own: its answer codes are graded with its file.
#[derive(Debug, Args)]
pub struct VariantArgs {
    /// Which variant.
    #[command(flatten)]
    pub which: SeedArgs,
}

/// Check an answer.
#[derive(Debug, Args)]
pub struct CheckArgs {
    /// Which variant.
    #[command(flatten)]
    pub which: SeedArgs,
    /// The answer: names with commas between them, cells with semicolons, or JSON.
    #[arg(long, value_name = "ANSWER", allow_hyphen_values = true)]
    pub answer: String,
    /// One JSON object instead of text.
    #[arg(long)]
    pub json: bool,
}

/// Grade answer codes.
#[derive(Debug, Args)]
#[command(after_help = "\
CODES is a table in CSV, as a form or a course system exports it, with a column named code, or one that alone has codes in
it, or the one that --code names. With a column named seed each code must be of the seed in its row. Each answer is checked
again; what a code says of a score is not read at all. The table that is printed has the columns of CODES and then: score, reason, seed, answer, attempts, hints. Where CODES has
a column of such a name, the one that is added is called graded score, graded seed and so on. A code proves which answer
was given to which question. It does not prove who gave it, nor the attempts and hints that it tells.

Examples:
  mo-copp grade exercise.json codes.csv > marks.csv
  mo-copp grade exercise.json codes.csv --student name > marks.csv")]
pub struct GradeArgs {
    /// A document with an exercise.
    #[arg(value_name = "EXERCISE")]
    pub exercise: PathBuf,
    /// The codes in CSV; - for the standard input.
    #[arg(value_name = "CODES")]
    pub codes: PathBuf,
    /// The column with the codes.
    #[arg(long, value_name = "COLUMN")]
    pub code: Option<String>,
    /// The column with the name to which the seed must belong, as exercise --student gives it.
    #[arg(long, value_name = "COLUMN")]
    pub student: Option<String>,
}
