//! Pictures as PNG, natively only: what [`draw`](super::draw) wrote, as pixels.
//!
//! Text is set in DejaVu Sans, which this program brings, so that a picture is the same wherever it is made. Only what
//! that font does not have, as names in Chinese, is set in a font of the machine; what none has is a box.
//!
//! ```
//! use mo_copp::domain::{Delivery, Document};
//! use mo_copp::picture::png::{SCALE, png};
//! use mo_copp::picture::{PictureOptions, draw};
//! use mo_copp::plan::Plan;
//! let document = Document::from(Delivery::figure_1());
//! let svg = draw(&document, &document.problem()?, &Plan::default(), &PictureOptions::step(0))?;
//! let picture = png(&svg, SCALE)?;
//! assert_eq!(&picture.bytes[1..4], b"PNG");
//! assert!(picture.boxes.is_empty());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod fonts;
mod runs;

use std::ops::RangeInclusive;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{self, Tree};
use thiserror::Error;

use fonts::Fonts;

/// Pixels for each unit of a picture, unless told otherwise: as large as the page makes them, sharp on a slide.
pub const SCALE: f64 = 2.0;

/// The scales there are.
pub const SCALES: RangeInclusive<f64> = 0.5..=8.0;

/// The most pixels of a picture. Each takes up to twelve bytes while the picture is made.
pub const MOST_PIXELS: u64 = 40_000_000;

/// A picture as PNG.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Png {
    /// The file.
    pub bytes: Vec<u8>,
    /// The characters that no font has, each once: boxes stand in their place.
    pub boxes: Vec<char>,
}

/// Why there is no PNG.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum PngError {
    /// A scale outside of [`SCALES`].
    #[error("scale: found {found}, expected a number from {} to {}", SCALES.start(), SCALES.end())]
    Scale {
        /// The scale asked for.
        found: f64,
    },
    /// A picture of more than [`MOST_PIXELS`].
    #[error(
        "scale: found {found}, expected at most {most}: the picture would have {width} by {height} pixels, more than {} million",
        MOST_PIXELS / 1_000_000
    )]
    TooLarge {
        /// The scale asked for.
        found: f64,
        /// The largest there is for this picture.
        most: f64,
        /// How wide it would be, in pixels.
        width: u64,
        /// How high it would be.
        height: u64,
    },
    /// A text that is no SVG.
    #[error("the SVG cannot be read: {reason}")]
    Svg {
        /// Why.
        reason: String,
    },
}

/// Makes a PNG of an SVG; `scale` is the pixels of each of its units. Of an animation it shows the last step.
///
/// Linear in the pixels.
///
/// # Errors
///
/// [`PngError`] for a scale that there is not, a picture that would be too large, or a text that is no SVG.
pub fn png(svg: &str, scale: f64) -> Result<Png, PngError> {
    if !SCALES.contains(&scale) {
        return Err(PngError::Scale { found: scale });
    }
    let mut fonts = Fonts::new();
    let (svg, boxes) = runs::set(svg, &mut fonts).map_err(|error| unreadable(&error))?;
    let tree = Tree::from_str(&svg, &options(fonts)).map_err(|error| unreadable(&error))?;
    let [width, height] = pixels(&tree, scale)?;
    let nothing = || unreadable(&"it has no size");
    let mut pixmap = Pixmap::new(width, height).ok_or_else(nothing)?;
    let size = tree.size();
    let [right, down] = [width as f32 / size.width(), height as f32 / size.height()];
    resvg::render(&tree, Transform::from_scale(right, down), &mut pixmap.as_mut());
    let bytes = pixmap.encode_png().map_err(|error| unreadable(&error))?;
    Ok(Png { bytes, boxes })
}

fn unreadable(reason: &impl ToString) -> PngError {
    PngError::Svg { reason: reason.to_string() }
}

fn options(fonts: Fonts) -> usvg::Options<'static> {
    let (fontdb, font_resolver) = fonts.into_resolver();
    usvg::Options { fontdb, font_resolver, ..usvg::Options::default() }
}

/// How many pixels wide and high a picture is.
fn pixels(tree: &Tree, scale: f64) -> Result<[u32; 2], PngError> {
    let size = [tree.size().width(), tree.size().height()].map(f64::from);
    let [width, height] = size.map(|side| (side * scale).round().max(1.0) as u64);
    if width.saturating_mul(height) > MOST_PIXELS {
        let most = (MOST_PIXELS as f64 / (size[0] * size[1])).sqrt();
        // Rounded down: what is said is what can be asked for.
        let most = (most * 10.0).floor() / 10.0;
        return Err(PngError::TooLarge { found: scale, most, width, height });
    }
    Ok([width as u32, height as u32])
}

#[cfg(test)]
mod tests {
    use resvg::tiny_skia::Pixmap;

    use super::*;

    fn svg(inside: &str) -> String {
        format!(
            r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 40 20" width="40" height="20"><rect width="40" height="20" fill="#123456"/>{inside}</svg>"##
        )
    }

    #[test]
    fn a_picture_has_the_pixels_of_its_scale() {
        for (scale, size) in [(0.5, (20, 10)), (1.26, (50, 25)), (2.0, (80, 40)), (8.0, (320, 160))]
        {
            let made = png(&svg(""), scale).unwrap();
            let pixmap = Pixmap::decode_png(&made.bytes).unwrap();
            assert_eq!((pixmap.width(), pixmap.height()), size);
            for pixel in pixmap.pixels() {
                let found = [pixel.red(), pixel.green(), pixel.blue(), pixel.alpha()];
                assert_eq!(found, [0x12, 0x34, 0x56, 0xff], "{scale}");
            }
        }
    }

    #[test]
    fn a_scale_has_bounds() {
        for found in [0.49, 8.01, -1.0, f64::INFINITY] {
            assert_eq!(png(&svg(""), found), Err(PngError::Scale { found }));
        }
        let said = png(&svg(""), f64::NAN).unwrap_err().to_string();
        assert_eq!(said, "scale: found NaN, expected a number from 0.5 to 8");
    }

    #[test]
    fn a_picture_has_at_most_so_many_pixels() {
        let wide = svg("").replace("\"40\"", "\"4000\"").replace("\"20\"", "\"3000\"");
        let found = png(&wide, 2.0).unwrap_err();
        let expected = "scale: found 2, expected at most 1.8: the picture would have 8000 by 6000 pixels, more than 40 million";
        assert_eq!(found.to_string(), expected);
        let PngError::TooLarge { most, .. } = found else { panic!("{found}") };
        let tree = Tree::from_str(&wide, &options(Fonts::new())).unwrap();
        assert_eq!(pixels(&tree, most), Ok([7200, 5400]));
    }

    #[test]
    fn what_is_no_svg_is_said() {
        for text in ["", "text", "<svg", "<html/>"] {
            assert!(matches!(png(text, 1.0), Err(PngError::Svg { .. })), "{text}");
        }
    }

    #[test]
    fn what_no_font_has_is_a_box() {
        // Not assigned: no font has it.
        let named = svg("<text x=\"1\" y=\"18\" font-size=\"18\" fill=\"#ffffff\">\u{378}</text>");
        let made = png(&named, 1.0).unwrap();
        assert_eq!(made.boxes, ['\u{378}']);
        assert_ne!(made.bytes, png(&svg(""), 1.0).unwrap().bytes);
    }
}
