//! One board: what is drawn inside of its frame, by the format of the document.

use crate::belief::StateCount;
use crate::domain::Document;
use crate::domain::grid::Cell;
use crate::problem::{Role, StateLabel};
use crate::report::{BeliefReport, Scene, Setting, StepReport};

use super::floor::Floor;
use super::palette::{Palette, Tone};
use super::svg::Svg;
use super::{cells, delivery, listing};

/// Whose board it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Owner {
    /// The agent's: where it is.
    Actor,
    /// An observer's: what it believes.
    Observer(usize),
}

/// What is drawn of a step on one board.
pub(super) struct BoardInput<'a> {
    pub scene: &'a Scene,
    pub document: &'a Document,
    /// All steps, for the agent's way.
    pub steps: &'a [StepReport],
    /// The one that is drawn.
    pub at: usize,
    /// Whether the agent stops with the last one.
    pub ended: bool,
    pub owner: Owner,
    pub tone: Tone,
    pub palette: &'a Palette,
    /// Whether boards of cells have the numbers of columns and rows at their edges.
    pub numbers: bool,
}

impl<'a> BoardInput<'a> {
    pub fn step(&self) -> &'a StepReport {
        &self.steps[self.at]
    }

    /// Whether the agent stops with this step.
    pub fn is_last(&self) -> bool {
        self.ended && self.at + 1 == self.steps.len()
    }

    /// The believed states that the report lists; none on the agent's board.
    pub fn belief(&self) -> &'a [StateLabel] {
        match self.owner {
            Owner::Actor => &[],
            Owner::Observer(observer) => {
                self.step().beliefs.get(observer).map_or(&[], Vec::as_slice)
            }
        }
    }

    /// What the believed states have in common, where the report says so.
    pub fn summary(&self) -> Option<&'a BeliefReport> {
        match self.owner {
            Owner::Actor => None,
            Owner::Observer(observer) => self.step().summaries.as_ref()?.get(observer),
        }
    }

    /// How many states the observer believes possible.
    pub fn believed_states(&self) -> StateCount {
        let listed = StateCount::Exact(self.belief().len() as u64);
        self.summary().map_or(listed, |summary| summary.states)
    }

    /// Whether a goal survives in the observer's belief.
    pub fn survives(&self, observer: usize, goal: &str) -> bool {
        let goals = self.step().goals.get(observer);
        goals.is_some_and(|goals| goals.iter().any(|name| name == goal))
    }

    /// The cells in which this observer has cameras.
    pub fn cameras(&self) -> &'a [Cell] {
        let Owner::Observer(observer) = self.owner else { return &[] };
        let name = self.scene.observers.get(observer).map_or("", |observer| observer.role);
        let role =
            if name == Role::Adversarial.name() { Role::Adversarial } else { Role::Cooperative };
        match self.document {
            Document::Gridworld(grid) => &grid.observers.of(role).cameras,
            Document::BoxPushing(pushing) => &pushing.observers.of(role).cameras,
            Document::RecyclingRobot(robot) => &robot.observers.of(role).cameras,
            _ => &[],
        }
    }

    /// Draws the inside of the board, [`SIDE`](super::SIDE) by `SIDE`.
    pub fn draw(&self, svg: &mut Svg) {
        let numbers = self.numbers;
        match &self.scene.setting {
            Setting::Gridworld { width, height, walls, start } => {
                let (width, height, charger) = (*width, *height, None);
                let floor = Floor { width, height, walls, charger, numbers };
                cells::draw(svg, self, &floor, *start);
            }
            Setting::BoxPushing { width, height, walls, start } => {
                let (width, height, charger) = (*width, *height, None);
                let floor = Floor { width, height, walls, charger, numbers };
                cells::draw(svg, self, &floor, start.robot);
            }
            Setting::RecyclingRobot { width, height, walls, charger, start, .. } => {
                let (width, height, charger) = (*width, *height, Some(*charger));
                let floor = Floor { width, height, walls, charger, numbers };
                cells::draw(svg, self, &floor, start.robot);
            }
            Setting::Delivery { factories, .. } => delivery::draw(svg, self, factories),
            Setting::Explicit => listing::draw(svg, self),
            #[cfg(feature = "full")]
            Setting::Pddl(_) => listing::draw(svg, self),
        }
    }

    /// A line about what the board can't draw; empty where it draws all there is.
    pub fn remark(&self) -> String {
        match &self.scene.setting {
            Setting::RecyclingRobot { battery_levels, .. } => {
                cells::battery(self, battery_levels.saturating_sub(1))
            }
            _ => String::new(),
        }
    }
}
