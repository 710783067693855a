//! The file of a picture: its format, by the end of its name, and how it is written.

use std::fs::{self, File};
use std::io::Write;
use std::path::Path;

use mo_copp::solver::OptionsError;

use super::super::error::CliError;

/// A format that is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    Svg,
    Png,
}

impl Format {
    /// The format that a name says; programs go by its end. A name without an end says none, and is of an SVG, as is
    /// the standard output.
    pub fn new(file: Option<&Path>, animated: bool) -> Result<Self, OptionsError> {
        let Some(file) = file else { return Ok(Self::Svg) };
        let Some(end) = file.extension().map(|end| end.to_string_lossy().to_lowercase()) else {
            return Ok(Self::Svg);
        };
        match (&*end, animated) {
            ("svg", _) => return Ok(Self::Svg),
            ("png", false) => return Ok(Self::Png),
            _ => {}
        }
        let named = |end| format!("{:?}", file.with_extension(end).display().to_string());
        let expected = if animated || is_film(&end) {
            format!("the name of an SVG file, as {}, {}", named("svg"), moving(&end))
        } else {
            let (svg, png) = (named("svg"), named("png"));
            format!("the name of an SVG or PNG file, as {svg} or {png}{}", programs_for(&end))
        };
        Err(OptionsError::new("out", format!("{:?}", file.display().to_string()), expected))
    }
}

/// Formats of pictures that move.
fn is_film(end: &str) -> bool {
    matches!(end, "gif" | "apng" | "mp4" | "webm" | "mov" | "avi" | "mkv" | "ogv")
}

/// Why pictures that move are SVG.
fn moving(end: &str) -> String {
    if end == "png" {
        return "which moves in a browser: a PNG does not move, and shows one --step".to_owned();
    }
    let format = end.to_uppercase();
    format!("which moves in a browser with --animate; this program makes no {format}")
}

/// What makes a picture of another format.
fn programs_for(end: &str) -> String {
    let format = end.to_uppercase();
    match end {
        "pdf" | "eps" => {
            format!("; of an SVG other programs make {format}: rsvg-convert -f {end}, or inkscape")
        }
        "jpg" | "jpeg" | "webp" | "avif" | "bmp" | "tif" | "tiff" => {
            format!("; of a PNG other programs make {format}, as ImageMagick (magick) does")
        }
        _ => ": no other format is written".to_owned(),
    }
}

/// Writes a file; where that fails, no half of it is left.
pub fn write(file: &Path, bytes: &[u8]) -> Result<(), CliError> {
    let written = File::create(file).and_then(|mut new| {
        new.write_all(bytes).inspect_err(|_| {
            // A device or a link to one is not ours to remove.
            if fs::symlink_metadata(file).is_ok_and(|found| found.is_file()) {
                let _ = fs::remove_file(file);
            }
        })
    });
    written.map_err(|error| CliError::Write {
        file: file.display().to_string(),
        reason: error.to_string(),
    })
}
