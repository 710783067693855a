//! The arguments of `mo-copp picture`.

use std::path::PathBuf;

use clap::Args;
use mo_copp::picture::Theme;
use mo_copp::picture::png::SCALES;

/// Draw the boards.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true)]
#[command(after_help = "\
Examples:
  mo-copp picture grid.json --plan north,north,east --step 2 -o step.svg
  mo-copp picture grid.json --plan north,north,east -o end.png --scale 4
  mo-copp picture grid.json --plan-file plan.txt --animate -o walk.svg
  mo-copp picture grid.json --plan north --board adversarial --no-captions --theme dark > enemy.svg")]
pub struct PictureArgs {
    /// The problem document; - for the standard input.
    pub problem: PathBuf,
    /// The actions, with commas between them; without a plan the start is drawn.
    #[arg(long, value_name = "A,B,C", conflicts_with = "plan_file")]
    pub plan: Option<String>,
    /// A file with one action a line; - for the standard input.
    #[arg(long, value_name = "FILE")]
    pub plan_file: Option<PathBuf>,
    /// The step to draw, 0 for the start; left out: the last.
    #[arg(long, value_name = "N", conflicts_with = "animate")]
    pub step: Option<usize>,
    /// All steps, one after another, without end.
    #[arg(long)]
    pub animate: bool,
    /// How long an animation shows each step, in milliseconds.
    #[arg(long, value_name = "MS", default_value_t = 1000, requires = "animate")]
    pub milliseconds: u32,
    /// The boards: all, actor, or an observer by its role.
    #[arg(long, value_name = "BOARD", default_value = "all")]
    pub board: String,
    /// The boards alone, without headings, goals and the line about the step.
    #[arg(long)]
    pub no_captions: bool,
    /// The numbers of columns and rows at the edges of boards with cells, from 0.
    #[arg(long)]
    pub numbers: bool,
    /// Light or dark.
    #[arg(long, value_parser = theme, value_name = "light|dark", default_value = "light")]
    pub theme: Theme,
    /// The pixels of a PNG for each unit of the picture, from 0.5 to 8 [default: 2].
    #[arg(long, value_parser = scale, value_name = "N")]
    pub scale: Option<f64>,
    /// The file to write, an SVG or by the end .png of its name a PNG; left out, or -: SVG on the standard output.
    #[arg(short, long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

fn theme(name: &str) -> Result<Theme, String> {
    Theme::named(name).ok_or_else(|| "expected light or dark".to_owned())
}

fn scale(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|scale| SCALES.contains(scale));
    number.ok_or_else(|| format!("expected a number from {} to {}", SCALES.start(), SCALES.end()))
}
