//! Recycling Robot: a robot with a battery puts a can into a bin (after Sutton and Barto 2018,
//! "Reinforcement Learning: An Introduction", example 3.3), in the paper's setting on a grid.
//!
//! A move to the north, south, east or west takes the battery down one level; with an empty battery
//! there is none, and off the grid or into a wall it changes nothing. `pick-up` takes the can where
//! the robot stands, `drop` puts it down there, `charge` fills the battery where the charger is, and
//! `stay` changes nothing; none of them takes charge. A goal says in which cell the can must lie:
//! there is a bin. Cells, walls and observers are those of [`grid`](super::grid).

mod build;
mod generate;
mod reach;
mod read;

use serde::{Serialize, Serializer};

pub use generate::RecyclingRobotShape;

use super::Observers;
use super::grid::{Cell, GridGoal, GridObserver, Symbols};

/// The longest side of a grid.
pub const MAX_SIDE: u32 = 32;

/// The most levels a battery may have.
pub const MAX_LEVELS: u32 = 32;

/// Takes the can.
const PICK_UP: &str = "pick-up";
/// Puts it down.
const DROP: &str = "drop";
/// Fills the battery.
const CHARGE: &str = "charge";
/// Changes nothing.
const STAY: &str = "stay";

/// The actions, in the order of the paper.
pub(super) const ACTIONS: [&str; 8] =
    ["north", "south", "east", "west", PICK_UP, DROP, CHARGE, STAY];

/// A `recycling-robot` document.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub struct RecyclingRobot {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Cells that the robot cannot enter.
    #[cfg_attr(not(target_arch = "wasm32"), schemars(default))]
    pub walls: Vec<Cell>,
    /// Where the battery can be charged.
    pub charger: Cell,
    /// How many levels the battery has: 0, when it is empty, to one less than this, when it is
    /// full.
    pub battery_levels: u32,
    /// How it begins.
    pub start: RobotState,
    /// The candidate goals: the can lies in the cell.
    pub goals: Vec<GridGoal>,
    /// The name of the true one.
    pub true_goal: String,
    /// What the two observers believe and see.
    pub observers: Observers<GridObserver<RobotState>>,
}

/// A state.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub struct RobotState {
    /// Where the robot stands.
    pub robot: Cell,
    /// The level of its battery.
    pub battery: u32,
    /// Where the can is.
    pub can: Can,
}

/// Where the can is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Can {
    /// In a cell.
    At(Cell),
    /// In the robot's gripper.
    Held,
}

/// What documents say of a can in the gripper.
const HELD: &str = "held";

impl Serialize for Can {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::At(cell) => cell.serialize(serializer),
            Self::Held => HELD.serialize(serializer),
        }
    }
}

impl RecyclingRobot {
    /// The paper's sensors: the enemy tells the two axes, the gripper and the rest apart; the friend
    /// tells moves to the north or east, those to the south or west, charging and picking up, and
    /// the rest apart.
    pub fn paper_sensors() -> Observers<Symbols> {
        let of = |[north, south, east, west, pick_up, drop, charge, stay]: [&str; 8]| {
            Symbols::new([
                ("north", north),
                ("south", south),
                ("east", east),
                ("west", west),
                (PICK_UP, pick_up),
                (DROP, drop),
                (CHARGE, charge),
                (STAY, stay),
            ])
        };
        let (axes, gripper) = (["vertical", "horizontal"], "using-gripper");
        let (sides, picking, dropping) =
            (["north-east", "south-west"], "charging-picking", "staying-dropping");
        Observers {
            adversarial: of([
                axes[0], axes[0], axes[1], axes[1], gripper, gripper, "charging", "charging",
            ]),
            cooperative: of([
                sides[0], sides[1], sides[0], sides[1], picking, dropping, picking, dropping,
            ]),
        }
    }
}

#[cfg(not(target_arch = "wasm32"))]
impl schemars::JsonSchema for Can {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Can".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({"anyOf": [{"const": HELD}, {"type": "array", "items": {"type": "integer", "minimum": 0}, "minItems": 2, "maxItems": 2}]})
    }
}
