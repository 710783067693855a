//! The sheet: boards side by side with their headings, goals and the line about the step.

use std::fmt::Write;

use crate::belief::StateCount;
use crate::domain::Document;
use crate::goal_difference::written;
use crate::report::{Scene, TraceReport};

use super::boards::{BoardInput, Owner};
use super::palette::{Palette, Theme, Tone};
use super::svg::{Anchor, Escaped, Number, Svg};
use super::{Boards, PictureError, PictureOptions, SIDE, goals};

const MARGIN: f64 = 24.0;
const GAP: f64 = 28.0;
/// The line about the step.
const TITLE: f64 = 72.0;
/// Heading and what was seen.
const HEADING: f64 = 62.0;
/// What the board can't draw.
const REMARK: f64 = 28.0;

/// A picture that is being laid out.
pub(super) struct Sheet<'a> {
    scene: &'a Scene,
    document: &'a Document,
    trace: &'a TraceReport,
    palette: &'static Palette,
    theme: Theme,
    owners: Vec<Owner>,
    captions: bool,
    ended: bool,
    numbers: bool,
}

impl<'a> Sheet<'a> {
    pub fn new(
        scene: &'a Scene,
        document: &'a Document,
        trace: &'a TraceReport,
        options: &PictureOptions,
    ) -> Self {
        let observers = (0..scene.observers.len()).map(Owner::Observer);
        let owners = match options.boards {
            Boards::All => std::iter::once(Owner::Actor).chain(observers).collect(),
            Boards::Actor => vec![Owner::Actor],
            Boards::Observer(observer) => vec![Owner::Observer(observer)],
        };
        let palette = Palette::of(options.theme);
        let theme = options.theme;
        let PictureOptions { captions, ended, numbers, .. } = *options;
        Self { scene, document, trace, palette, theme, owners, captions, ended, numbers }
    }

    /// One step.
    pub fn still(&self, step: usize) -> String {
        let mut svg = Svg::default();
        self.open(&mut svg, &self.describe(step));
        self.step(&mut svg, step);
        svg.raw("</svg>\n");
        svg.into_text()
    }

    /// All steps, each shown for some time; a reader without animation sees the last.
    pub fn animated(&self, milliseconds: u32, most: usize) -> Result<String, PictureError> {
        let count = self.trace.steps.len();
        let mut svg = Svg::default();
        self.open(&mut svg, &format!("{} steps. {}", count - 1, self.describe(count - 1)));
        let seconds = Number(f64::from(milliseconds) / 1000.0 * count as f64);
        for step in 0..count {
            let last = step + 1 == count;
            let resting = if last { "inline" } else { "none" };
            svg.raw(format_args!(r#"<g display="{resting}">"#));
            if count > 1 {
                let at = |step: usize| step as f64 / count as f64;
                let (values, times) = match step {
                    0 => ("inline;none".to_owned(), format!("0;{:.5}", at(1))),
                    _ if last => ("none;inline".to_owned(), format!("0;{:.5}", at(step))),
                    _ => (
                        "none;inline;none".to_owned(),
                        format!("0;{:.5};{:.5}", at(step), at(step + 1)),
                    ),
                };
                svg.raw(format_args!(
                    r#"<animate attributeName="display" calcMode="discrete" dur="{seconds}s" repeatCount="indefinite" values="{values}" keyTimes="{times}"/>"#
                ));
            }
            self.step(&mut svg, step);
            svg.raw("</g>");
            if svg.len() > most {
                let found = svg.len() / (step + 1) * count;
                return Err(PictureError::TooLarge { found, most });
            }
        }
        svg.raw("</svg>\n");
        Ok(svg.into_text())
    }

    fn size(&self) -> [f64; 2] {
        let boards = self.owners.len() as f64;
        let width = 2.0 * MARGIN + boards * SIDE + (boards - 1.0) * GAP;
        let mut height = 2.0 * MARGIN + SIDE;
        if self.captions {
            height +=
                TITLE + HEADING + self.remark_height() + goals::height(self.scene.goals.len());
        }
        [width, height]
    }

    fn remark_height(&self) -> f64 {
        let any = self.owners.iter().any(|&owner| !self.input(0, owner).remark().is_empty());
        if any { REMARK } else { 6.0 }
    }

    fn open(&self, svg: &mut Svg, description: &str) {
        let [width, height] = self.size().map(Number);
        svg.raw(format_args!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img" font-family="system-ui, -apple-system, 'Segoe UI', 'DejaVu Sans', sans-serif" data-theme="{}">"#,
            self.theme.name()
        ));
        svg.raw("<title>");
        svg.raw(Escaped(&format!("What each side believes: {}", self.names())));
        svg.raw("</title><desc>");
        svg.raw(Escaped(description));
        svg.raw("</desc>");
        svg.raw(format_args!(
            r#"<rect width="{width}" height="{height}" fill="{}"/>"#,
            self.palette.paper
        ));
    }

    fn names(&self) -> String {
        let names: Vec<&str> = self.scene.goals.iter().take(12).map(|goal| &*goal.name).collect();
        let more = if self.scene.goals.len() > names.len() { ", …" } else { "" };
        format!("candidate goals {}{more}", names.join(", "))
    }

    fn input(&self, at: usize, owner: Owner) -> BoardInput<'_> {
        BoardInput {
            scene: self.scene,
            document: self.document,
            steps: &self.trace.steps,
            at,
            ended: self.ended,
            numbers: self.numbers,
            owner,
            tone: self.tone(owner),
            palette: self.palette,
        }
    }

    fn tone(&self, owner: Owner) -> Tone {
        match owner {
            Owner::Actor => self.palette.actor,
            Owner::Observer(observer) => match self.role(observer) {
                "adversarial" => self.palette.enemy,
                _ => self.palette.friend,
            },
        }
    }

    fn role(&self, observer: usize) -> &'static str {
        self.scene.observers.get(observer).map_or("", |observer| observer.role)
    }

    /// The name of an observer in plain words.
    fn called(&self, observer: usize) -> &'static str {
        if self.role(observer) == "adversarial" { "enemy" } else { "friend" }
    }

    fn step(&self, svg: &mut Svg, at: usize) {
        let palette = self.palette;
        let [width, _] = self.size();
        let mut top = MARGIN;
        if self.captions {
            let look = format!(r#"fill="{}" font-weight="600""#, palette.ink);
            let room = width - 2.0 * MARGIN;
            svg.fitted([MARGIN, top + 22.0], 24.0, Anchor::Start, room, &self.done(at), look);
            let muted = format!(r#"fill="{}""#, palette.ink);
            let counts = self.counts(at);
            svg.fitted([MARGIN, top + 49.0], 18.0, Anchor::Start, room, &counts, muted);
            top += TITLE;
        }
        for (place, &owner) in self.owners.iter().enumerate() {
            let input = self.input(at, owner);
            let x = Number(MARGIN + place as f64 * (SIDE + GAP));
            svg.raw(format_args!(r#"<g transform="translate({x} {})">"#, Number(top)));
            let mut down = 0.0;
            if self.captions {
                self.heading(svg, &input);
                down += HEADING;
            }
            svg.raw(format_args!(r#"<g transform="translate(0 {})">"#, Number(down)));
            input.draw(svg);
            svg.raw("</g>");
            down += SIDE;
            if self.captions {
                let remark = input.remark();
                if !remark.is_empty() {
                    let look = format!(r#"fill="{}""#, palette.muted);
                    svg.fitted([0.0, down + 22.0], 18.0, Anchor::Start, SIDE, &remark, look);
                }
                down += self.remark_height();
                svg.raw(format_args!(r#"<g transform="translate(0 {})">"#, Number(down)));
                goals::draw(svg, &input);
                svg.raw("</g>");
            }
            svg.raw("</g>");
        }
    }

    fn heading(&self, svg: &mut Svg, input: &BoardInput<'_>) {
        let (title, below) = match input.owner {
            Owner::Actor => (
                "The agent".to_owned(),
                match &input.step().action {
                    None => "at the start".to_owned(),
                    Some(action) => action.clone(),
                },
            ),
            Owner::Observer(observer) => {
                let states = input.believed_states();
                let plural = if states == StateCount::Exact(1) { "" } else { "s" };
                let seen = match input.step().symbols.get(observer) {
                    Some(Some(symbol)) => format!("saw {symbol}; "),
                    _ => String::new(),
                };
                let title = format!("What the {} believes", self.called(observer));
                (title, format!("{seen}{states} state{plural} possible"))
            }
        };
        let strong = format!(r#"fill="{}" font-weight="600""#, input.tone.strong);
        svg.fitted([0.0, 22.0], 22.0, Anchor::Start, SIDE, &title, strong);
        let muted = format!(r#"fill="{}""#, self.palette.muted);
        svg.fitted([0.0, 46.0], 18.0, Anchor::Start, SIDE, &below, muted);
    }

    /// What was done.
    fn done(&self, at: usize) -> String {
        let last = self.trace.steps.len() - 1;
        let step = &self.trace.steps[at];
        match &step.action {
            None if !self.ended => "Start".to_owned(),
            Some(action) if !self.ended => format!("Step {at}: {action}"),
            None => format!("Start, {last} step{} to go", if last == 1 { "" } else { "s" }),
            Some(action) => format!("Step {at} of {last}: {action}"),
        }
    }

    /// How many goals are possible for each side, and at the true goal the goal difference.
    fn counts(&self, at: usize) -> String {
        let step = &self.trace.steps[at];
        let all = self.scene.goals.len();
        let side = |observer: usize| {
            let possible = step.goals.get(observer).map_or(0, Vec::len);
            format!("{} of {all} for the {}", possible, self.called(observer))
        };
        let sides: Vec<String> = (0..self.scene.observers.len()).map(side).collect();
        let mut text = format!("Possible goals: {}.", sides.join(", "));
        if self.ended && at + 1 == self.trace.steps.len() && self.trace.valid {
            // Writing to a text cannot fail.
            let _ = write!(text, " Goal difference {}.", written(step.goal_difference, all));
        }
        text
    }

    /// The step in words, for readers who don't see the picture.
    fn describe(&self, at: usize) -> String {
        let step = &self.trace.steps[at];
        let mut text = format!("{}. {}", self.done(at), self.counts(at));
        for (observer, seen) in self.scene.observers.iter().enumerate() {
            let names = step.goals.get(observer).map(|goals| goals.join(", "));
            let names = names.filter(|names| !names.is_empty());
            let states = self.input(at, Owner::Observer(observer)).believed_states();
            let side = if seen.role == "adversarial" { "enemy" } else { "friend" };
            let _ = write!(
                text,
                " The {side} believes {states} state{} possible, with the goals {}.",
                if states == StateCount::Exact(1) { "" } else { "s" },
                names.as_deref().unwrap_or("of none")
            );
        }
        text
    }
}
