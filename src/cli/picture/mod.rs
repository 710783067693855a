//! `mo-copp picture`: draws the boards of a step, or of a whole plan, as SVG or PNG.

pub mod args;
mod file;

use mo_copp::picture::png::{SCALE, png};
use mo_copp::picture::{Boards, PictureOptions, draw};
use mo_copp::problem::Problem;
use mo_copp::solver::OptionsError;

use super::error::CliError;
use super::{input, note, plan_text, print};
use args::PictureArgs;
use file::Format;

/// Draws and writes; the exit code.
pub fn run(args: &PictureArgs) -> Result<u8, CliError> {
    let out = args.out.as_deref().filter(|out| out.as_os_str() != "-");
    let format = Format::new(out, args.animate)?;
    if let (Format::Svg, Some(scale)) = (format, args.scale) {
        let expected = "a PNG, as with -o step.png: an SVG is as large as it is shown";
        return Err(OptionsError::new("scale", scale.to_string(), expected).into());
    }
    let (document, problem) = input::document(&args.problem)?;
    let plan = plan_text::plan(&problem, args.plan.as_deref(), args.plan_file.as_deref())?;
    let mut options = if args.animate {
        PictureOptions::animated(args.milliseconds)
    } else {
        PictureOptions::step(args.step.unwrap_or(plan.len()))
    };
    options.boards = boards(&args.board, &problem)?;
    options.captions = !args.no_captions;
    options.numbers = args.numbers;
    options.theme = args.theme;
    let svg = draw(&document, &problem, &plan, &options)?;
    match (out, format) {
        (None, _) => print(&svg)?,
        (Some(out), Format::Svg) => file::write(out, svg.as_bytes())?,
        (Some(out), Format::Png) => {
            let picture = png(&svg, args.scale.unwrap_or(SCALE))?;
            file::write(out, &picture.bytes)?;
            if !picture.boxes.is_empty() {
                note(&without_form(&picture.boxes));
            }
        }
    }
    Ok(0)
}

/// What is said of characters that no font has.
fn without_form(characters: &[char]) -> String {
    const MOST: usize = 12;
    let shown: Vec<String> = characters.iter().take(MOST).map(char::to_string).collect();
    let more = characters.len() - shown.len();
    let more = if more == 0 { String::new() } else { format!(" and {more} more") };
    format!("no font has {}{more}: a box stands in the place of each", shown.join(" "))
}

/// `all`, `actor` or the name of an observer.
fn boards(name: &str, problem: &Problem) -> Result<Boards, CliError> {
    match name {
        "all" => Ok(Boards::All),
        "actor" => Ok(Boards::Actor),
        name => problem.observer_named(name).map(Boards::Observer).ok_or_else(|| {
            let observers = problem.observers().iter().map(|observer| observer.name.as_str());
            let names: Vec<&str> = ["all", "actor"].into_iter().chain(observers).collect();
            let expected = format!("one of {}", names.join(", "));
            OptionsError::new("board", format!("{name:?}"), expected).into()
        }),
    }
}
