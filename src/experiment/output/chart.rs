//! Bar charts with error bars as SVG, drawn by plotters.
//!
//! A chart has a ground of its own and changes colours with the reader's scheme, so that it can be
//! read on a light page and on a dark one.

use std::error::Error;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

const SIZE: (u32, u32) = (720, 400);
const TITLE_AT: (i32, i32) = (16, 14);
const LEGEND_AT: (i32, i32) = (16, 48);
/// How far the rows of the legend are apart, and what is below the last one.
const LEGEND_ROW: i32 = 22;
const BELOW_LEGEND: i32 = 16;
/// Side of a legend's square, and the room to the text and to the next entry.
const SQUARE: i32 = 12;
const GAP: i32 = 6;
const BETWEEN: i32 = 20;
/// Width of a letter of the legend, on average and rounded up: fonts differ between machines.
const LETTER: f64 = 7.6;

const GROUND: RGBColor = RGBColor(0xff, 0xff, 0xfe);
const INK: RGBColor = RGBColor(0x1b, 0x1f, 0x24);
const FAINT: RGBColor = RGBColor(0xd5, 0xd9, 0xde);
/// What is written over these colours where the reader's scheme is dark.
const DARK: [(RGBColor, &str); 3] = [(GROUND, "#15191e"), (INK, "#e8ebef"), (FAINT, "#3a414a")];

const FONT: &str = "system-ui, sans-serif";
const TITLE_SIZE: i32 = 21;
const TEXT_SIZE: i32 = 16;
/// The part of a group's width that its bars take.
const FILLED: f64 = 0.8;
/// Half the width of the end of an error bar, as a part of its bar's width.
const CAP: f64 = 0.18;
/// How much higher than the highest bar the chart is.
const HEADROOM: f64 = 1.08;
/// About how many lines go across.
const LINES: usize = 6;

/// How heights are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// In proportion, from 0.
    Linear,
    /// Seconds by their logarithm.
    Logarithmic,
}

/// Colours of bars. Each stands out from both grounds (after Okabe and Ito).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Colour {
    /// For what is plain.
    Grey,
    /// The first of three.
    Blue,
    /// What the chart is about.
    Orange,
    /// An optimum.
    Green,
    /// Another optimum.
    Purple,
}

impl Colour {
    fn rgb(self) -> RGBColor {
        match self {
            Self::Grey => RGBColor(0x8a, 0x8f, 0x98),
            Self::Blue => RGBColor(0x1f, 0x77, 0xc4),
            Self::Orange => RGBColor(0xd9, 0x6f, 0x0e),
            Self::Green => RGBColor(0x1d, 0x8a, 0x62),
            Self::Purple => RGBColor(0xb0, 0x5a, 0xb4),
        }
    }
}

/// Bars of one colour, one in each group.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Series {
    /// What stands in the legend.
    pub label: String,
    /// Their colour.
    pub colour: Colour,
}

/// A bar.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bar {
    /// How high it is.
    pub height: f64,
    /// How far the error bar goes up and down from there.
    pub error: Option<f64>,
}

/// Bars that stand together, one for each series.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// What stands below them.
    pub label: String,
    /// The bars; none where there is nothing to show.
    pub bars: Vec<Option<Bar>>,
}

/// A bar chart.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// What stands above it.
    pub title: String,
    /// What stands along the vertical axis.
    pub axis: String,
    /// How heights are drawn.
    pub scale: Scale,
    /// The bars of each group from left to right.
    pub series: Vec<Series>,
    /// The groups from left to right.
    pub groups: Vec<Group>,
}

impl Chart {
    /// Where a height is on the axis, which has a bottom.
    fn place(&self, height: f64, bottom: f64) -> f64 {
        match self.scale {
            Scale::Linear => height,
            Scale::Logarithmic if height > 0.0 => height.log10().max(bottom),
            Scale::Logarithmic => bottom,
        }
    }

    /// From where to where the axis goes, and about how many lines go across.
    fn axis_range(&self) -> (std::ops::Range<f64>, usize) {
        let bars = || self.groups.iter().flat_map(|group| group.bars.iter().flatten());
        let tops = bars().map(|bar| bar.height + bar.error.unwrap_or(0.0));
        let greatest = tops.fold(0.0, f64::max);
        match self.scale {
            Scale::Linear => {
                let bottoms = bars().map(|bar| bar.height - bar.error.unwrap_or(0.0));
                let least = bottoms.fold(0.0, f64::min);
                let top = if greatest > 0.0 || least < 0.0 { greatest * HEADROOM } else { 1.0 };
                (least * HEADROOM..top, LINES)
            }
            Scale::Logarithmic => {
                let heights = bars().map(|bar| bar.height).filter(|height| *height > 0.0);
                let least = heights.fold(1.0, f64::min);
                let (low, high) = (least.log10().floor(), greatest.max(least).log10().ceil());
                let high = high.max(low + 1.0);
                // One line for each power of ten.
                (low..high, (high - low) as usize + 1)
            }
        }
    }

    /// What a line across is called.
    fn line_label(&self, place: f64) -> String {
        match self.scale {
            Scale::Linear => {
                let text = format!("{place:.2}");
                let text = text.trim_end_matches('0').trim_end_matches('.');
                if text == "-0" { "0".to_owned() } else { text.to_owned() }
            }
            Scale::Logarithmic => {
                let microseconds = 10_f64.powf(place + 6.0).round();
                if microseconds < 1e3 {
                    format!("{microseconds} µs")
                } else if microseconds < 1e6 {
                    format!("{} ms", microseconds / 1e3)
                } else {
                    format!("{} s", microseconds / 1e6)
                }
            }
        }
    }

    /// What is to be read in the chart, for those who cannot see it.
    fn description(&self) -> String {
        let mut parts = Vec::new();
        for group in &self.groups {
            for (series, bar) in self.series.iter().zip(&group.bars) {
                let Some(bar) = bar else { continue };
                let error = bar.error.map(|error| format!(" ± {error:.3}")).unwrap_or_default();
                let label = &series.label;
                parts.push(format!("{}, {label}: {:.3}{error}", group.label, bar.height));
            }
        }
        parts.join("; ")
    }

    /// The chart as SVG text.
    ///
    /// # Errors
    ///
    /// Why it cannot be drawn.
    pub fn svg(&self) -> Result<String, String> {
        let mut svg = String::new();
        self.draw(&mut svg).map_err(|error| error.to_string())?;
        Ok(self.dress(&svg))
    }

    fn draw(&self, svg: &mut String) -> Result<(), Box<dyn Error>> {
        let places = self.legend();
        let head = places.last().map_or(LEGEND_AT.1, |place| place.1) + SQUARE + BELOW_LEGEND;
        let root = SVGBackend::with_string(svg, SIZE).into_drawing_area();
        root.fill(&GROUND)?;
        let (head, body) = root.split_vertically(head);
        head.draw_text(&self.title, &text(TITLE_SIZE), TITLE_AT)?;
        for (series, (x, y)) in self.series.iter().zip(places) {
            let square = [(x, y), (x + SQUARE, y + SQUARE)];
            head.draw(&Rectangle::new(square, series.colour.rgb().filled()))?;
            let style = text(TEXT_SIZE).pos(Pos::new(HPos::Left, VPos::Center));
            head.draw_text(&series.label, &style, (x + SQUARE + GAP, y + SQUARE / 2))?;
        }
        self.draw_bars(&body)?;
        root.present()?;
        Ok(())
    }

    /// Where the squares of the legend are: from left to right, in as many rows as it takes.
    fn legend(&self) -> Vec<(i32, i32)> {
        let (mut x, mut y) = LEGEND_AT;
        let mut places = Vec::new();
        for series in &self.series {
            let width = (series.label.chars().count() as f64 * LETTER) as i32 + SQUARE + GAP;
            if x + width > SIZE.0 as i32 && x > LEGEND_AT.0 {
                (x, y) = (LEGEND_AT.0, y + LEGEND_ROW);
            }
            places.push((x, y));
            x += width + BETWEEN;
        }
        places
    }

    fn draw_bars(&self, body: &DrawingArea<SVGBackend<'_>, Shift>) -> Result<(), Box<dyn Error>> {
        let (range, lines) = self.axis_range();
        let bottom = range.start;
        let count = self.groups.len().max(1) as f64;
        let mut chart = ChartBuilder::on(body)
            .margin_left(10)
            .margin_right(16)
            .margin_bottom(8)
            .x_label_area_size(32)
            .y_label_area_size(72)
            .build_cartesian_2d(0.0..count, range)?;
        chart
            .configure_mesh()
            .disable_x_mesh()
            .x_labels(0)
            .y_labels(lines)
            .light_line_style(TRANSPARENT)
            .bold_line_style(FAINT)
            .axis_style(INK)
            .label_style(text(TEXT_SIZE))
            .y_label_formatter(&|place| self.line_label(*place))
            .y_desc(&self.axis)
            .axis_desc_style(text(TEXT_SIZE))
            .draw()?;
        let base = if self.scale == Scale::Linear { 0.0 } else { bottom };
        let width = FILLED / self.series.len().max(1) as f64;
        for (number, group) in self.groups.iter().enumerate() {
            let style = text(TEXT_SIZE).pos(Pos::new(HPos::Center, VPos::Top));
            let label = Text::new(group.label.clone(), (0, 10), style);
            chart.draw_series([EmptyElement::at((number as f64 + 0.5, bottom)) + label])?;
            for (place, (bar, series)) in group.bars.iter().zip(&self.series).enumerate() {
                let Some(bar) = bar else { continue };
                let left = number as f64 + (1.0 - FILLED) / 2.0 + place as f64 * width;
                let height = self.place(bar.height, bottom);
                let edge = width * (1.0 - FILLED) / 2.0;
                let corners = [(left + edge, base), (left + width - edge, height)];
                chart.draw_series([Rectangle::new(corners, series.colour.rgb().filled())])?;
                let Some(error) = bar.error else { continue };
                let low = self.place(bar.height - error, bottom);
                let high = self.place(bar.height + error, bottom);
                let (middle, cap) = (left + width / 2.0, width * CAP);
                let mut paths = vec![[(middle, low), (middle, high)]];
                // A logarithm may go down further than the chart: no end is drawn there.
                let ends = [low, high].into_iter().filter(|end| *end > bottom);
                paths.extend(ends.map(|end| [(middle - cap, end), (middle + cap, end)]));
                let stroke = INK.stroke_width(2);
                chart.draw_series(paths.into_iter().map(|path| PathElement::new(path, stroke)))?;
            }
        }
        chart.draw_series([PathElement::new([(0.0, base), (count, base)], INK)])?;
        Ok(())
    }

    /// Adds names for screen readers and the colours of the dark scheme.
    fn dress(&self, svg: &str) -> String {
        let Some((start, rest)) = svg.split_once('>') else { return svg.to_owned() };
        let style = DARK.map(|(RGBColor(red, green, blue), dark)| {
            let light = format!("#{red:02X}{green:02X}{blue:02X}");
            format!("[fill=\"{light}\"]{{fill:{dark}}}[stroke=\"{light}\"]{{stroke:{dark}}}")
        });
        let style = style.concat();
        let (title, description) = (escaped(&self.title), escaped(&self.description()));
        format!(
            "{start} role=\"img\">\n<title>{title}</title>\n<desc>{description}</desc>\n\
             <style>@media (prefers-color-scheme:dark){{{style}}}</style>{rest}"
        )
    }
}

/// Letters of a size.
fn text(size: i32) -> TextStyle<'static> {
    (FONT, size).into_font().color(&INK)
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
