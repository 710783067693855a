//! What a page needs to draw a document.

use serde::Serialize;

use crate::domain::Document;
use crate::domain::box_pushing::BoxState;
use crate::domain::delivery::Factory;
use crate::domain::grid::{Cell, GridGoal};
#[cfg(feature = "full")]
use crate::domain::pddl::Outline;
use crate::domain::recycling_robot::RobotState;
use crate::problem::{Goal, Problem, StateNaming};

/// A document as something to look at. Names are texts, never markup.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Scene {
    /// The candidate goals.
    pub goals: Vec<SceneGoal>,
    /// The name of the true one.
    pub true_goal: String,
    /// The observers.
    pub observers: Vec<SceneObserver>,
    /// What the format adds.
    #[serde(flatten)]
    pub setting: Setting,
}

/// A candidate goal.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SceneGoal {
    /// Its name.
    pub name: String,
    /// Its cell, in a grid.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cell: Option<Cell>,
    /// Its condition, in PDDL.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub condition: Option<String>,
    /// The facts that its condition asks for and that actions change, in PDDL.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub facts: Option<Vec<String>>,
}

/// An observer.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SceneObserver {
    /// Its name.
    pub name: String,
    /// `adversarial` or `cooperative`.
    pub role: &'static str,
}

/// What is drawn around the goals.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "format", rename_all = "kebab-case")]
pub enum Setting {
    /// A grid.
    Gridworld {
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
        /// Cells that nobody can enter.
        walls: Vec<Cell>,
        /// Where the agent starts.
        start: Cell,
    },
    /// A grid with a box.
    BoxPushing {
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
        /// Cells that nothing can enter.
        walls: Vec<Cell>,
        /// Where robot and box are at first, and where the robot looks.
        start: BoxState,
    },
    /// A grid with a charger, bins and a can.
    RecyclingRobot {
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
        /// Cells that nobody can enter.
        walls: Vec<Cell>,
        /// Where the battery can be charged.
        charger: Cell,
        /// How many levels the battery has, 0 among them.
        battery_levels: u32,
        /// Where robot and can are at first, and how full the battery is.
        start: RobotState,
    },
    /// Factories and packages.
    Delivery {
        /// The factories.
        factories: Vec<Factory>,
        /// How many packages are to be delivered.
        deliver: u32,
    },
    /// States without places.
    Explicit,
    /// Objects and predicates.
    #[cfg(feature = "full")]
    Pddl(Outline),
}

impl Scene {
    /// The scene of a document and the problem made of it.
    pub fn new(document: &Document, problem: &Problem) -> Self {
        let in_cells: &[GridGoal] = match document {
            Document::Gridworld(grid) => &grid.goals,
            Document::BoxPushing(pushing) => &pushing.goals,
            Document::RecyclingRobot(robot) => &robot.goals,
            Document::Delivery(_) | Document::Explicit(_) => &[],
            #[cfg(feature = "full")]
            Document::Pddl(_) => &[],
        };
        let task = problem.task();
        let facts = |goal: &Goal| match problem.naming() {
            StateNaming::FirstFacts { count } => {
                let told = goal.condition.iter().filter(|fact| fact.index() < *count);
                Some(told.map(|&fact| task.fact_name(fact).to_owned()).collect())
            }
            _ => None,
        };
        let goal = |(index, goal): (usize, &Goal)| SceneGoal {
            name: goal.name.clone(),
            cell: in_cells.get(index).map(|goal| goal.cell),
            condition: condition(document, index),
            facts: facts(goal),
        };
        let setting = match document {
            Document::Gridworld(grid) => Setting::Gridworld {
                width: grid.width,
                height: grid.height,
                walls: grid.walls.clone(),
                start: grid.start,
            },
            Document::BoxPushing(pushing) => Setting::BoxPushing {
                width: pushing.width,
                height: pushing.height,
                walls: pushing.walls.clone(),
                start: pushing.start,
            },
            Document::RecyclingRobot(robot) => Setting::RecyclingRobot {
                width: robot.width,
                height: robot.height,
                walls: robot.walls.clone(),
                charger: robot.charger,
                battery_levels: robot.battery_levels,
                start: robot.start,
            },
            Document::Delivery(delivery) => Setting::Delivery {
                factories: delivery.factories.clone(),
                deliver: delivery.deliver,
            },
            Document::Explicit(_) => Setting::Explicit,
            // A document of which a problem was made can be read.
            #[cfg(feature = "full")]
            Document::Pddl(pddl) => pddl.outline().map_or(Setting::Explicit, Setting::Pddl),
        };
        Self {
            goals: problem.goals().iter().enumerate().map(goal).collect(),
            true_goal: problem.goals()[problem.true_goal()].name.clone(),
            observers: problem
                .observers()
                .iter()
                .map(|o| SceneObserver { name: o.name.clone(), role: o.role.name() })
                .collect(),
            setting,
        }
    }
}

/// The condition of a goal, where the document has it in PDDL.
#[cfg(feature = "full")]
fn condition(document: &Document, goal: usize) -> Option<String> {
    match document {
        Document::Pddl(pddl) => pddl.goals.get(goal).map(|goal| goal.condition.clone()),
        _ => None,
    }
}

#[cfg(not(feature = "full"))]
fn condition(_: &Document, _: usize) -> Option<String> {
    None
}
