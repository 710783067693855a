//! `mo-copp picture`: draws the boards of a step, or of a whole plan, as SVG.

pub mod args;

use std::path::Path;

use mo_copp::picture::{Boards, PictureOptions, draw};
use mo_copp::problem::Problem;
use mo_copp::solver::OptionsError;

use super::error::CliError;
use super::{input, plan_text, print};
use args::PictureArgs;

/// Draws and writes; the exit code.
pub fn run(args: &PictureArgs) -> Result<u8, CliError> {
    args.out.as_deref().map_or(Ok(()), named_as_svg)?;
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
    match &args.out {
        None => print(&svg)?,
        Some(file) => std::fs::write(file, svg).map_err(|error| CliError::Write {
            file: file.display().to_string(),
            reason: error.to_string(),
        })?,
    }
    Ok(0)
}

/// Programs go by the end of a name: SVG under another one is a file that none of them opens. A name without an end says
/// nothing else.
fn named_as_svg(file: &Path) -> Result<(), CliError> {
    let Some(end) = file.extension().map(|end| end.to_string_lossy().to_lowercase()) else {
        return Ok(());
    };
    if end == "svg" {
        return Ok(());
    }
    let svg = file.with_extension("svg");
    let svg = svg.display().to_string();
    let expected = match programs_for(&end) {
        Some(others) => format!("the name of an SVG file, as {svg:?}, {others}"),
        None => format!("the name of an SVG file, as {svg:?}: no other format is written"),
    };
    Err(OptionsError::new("out", format!("{:?}", file.display().to_string()), expected).into())
}

/// What makes a picture of another format of an SVG; nothing for names that say no such format.
fn programs_for(end: &str) -> Option<String> {
    let format = end.to_uppercase();
    match end {
        "png" | "pdf" | "eps" => Some(format!(
            "of which other programs make {format}: rsvg-convert --zoom 2, or inkscape"
        )),
        "gif" | "apng" | "mp4" | "webm" | "mov" | "avi" | "mkv" | "ogv" => {
            Some(format!("which moves in a browser with --animate; this program makes no {format}"))
        }
        "jpg" | "jpeg" | "webp" | "avif" | "bmp" | "tif" | "tiff" => Some(format!(
            "of which other programs make {format}: ImageMagick (magick), from a PNG by rsvg-convert --zoom 2"
        )),
        _ => None,
    }
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
