//! The domains of which problems can be drawn, by name.

use super::box_pushing::BoxPushingShape;
use super::delivery::DeliveryShape;
use super::generate::{Drawn, GenerateError};
use super::gridworld::GridworldShape;
use super::pddl::generate::{BlocksworldShape, DriverlogShape, LogisticsShape};
use super::recycling_robot::RecyclingRobotShape;

/// The domains of which problems can be drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Domain {
    /// Cells, walls and moves.
    Gridworld,
    /// A robot that turns, moves and pushes a box.
    BoxPushing,
    /// A robot with a battery, a can and bins.
    RecyclingRobot,
    /// Factories, packages and a truck.
    Delivery,
    /// Towers of blocks.
    Blocksworld,
    /// Packages, trucks and airplanes.
    Logistics,
    /// Packages, trucks and their drivers.
    Driverlog,
}

impl Domain {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::Gridworld,
        Self::BoxPushing,
        Self::RecyclingRobot,
        Self::Delivery,
        Self::Blocksworld,
        Self::Logistics,
        Self::Driverlog,
    ];

    /// The name. The last three have documents of the format `pddl`, the others one of this name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Gridworld => "gridworld",
            Self::BoxPushing => "box-pushing",
            Self::RecyclingRobot => "recycling-robot",
            Self::Delivery => "delivery",
            Self::Blocksworld => "blocksworld",
            Self::Logistics => "logistics",
            Self::Driverlog => "driverlog",
        }
    }

    /// The domain of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|domain| domain.name() == name)
    }

    /// Draws a problem of the default size: the paper's, where the paper gives one.
    ///
    /// # Errors
    ///
    /// [`GenerateError::Unsolvable`] where no draw has a true goal that can be reached.
    ///
    /// ```
    /// use mo_copp::domain::generate::Domain;
    /// for domain in Domain::ALL {
    ///     let drawn = domain.draw(7)?;
    ///     assert_eq!(drawn, domain.draw(7)?);
    ///     assert!(drawn.document.problem().is_ok());
    /// }
    /// # Ok::<(), mo_copp::domain::generate::GenerateError>(())
    /// ```
    pub fn draw(self, seed: u64) -> Result<Drawn, GenerateError> {
        match self {
            Self::Blocksworld | Self::Logistics | Self::Driverlog => {
                self.draw_with_beliefs(seed, 1)
            }
            Self::Gridworld => GridworldShape::default().generate(seed).map(Drawn::any),
            Self::BoxPushing => BoxPushingShape::default().generate(seed).map(Drawn::any),
            Self::RecyclingRobot => RecyclingRobotShape::default().generate(seed).map(Drawn::any),
            Self::Delivery => DeliveryShape::default().generate(seed).map(Drawn::any),
        }
    }

    /// The same with initial beliefs of at most `belief` states, drawn for each observer by itself.
    /// The domains that are not in PDDL have their own beliefs, and ignore the number.
    ///
    /// # Errors
    ///
    /// As [`draw`](Self::draw), and a number of states that makes no sense.
    pub fn draw_with_beliefs(self, seed: u64, belief: u32) -> Result<Drawn, GenerateError> {
        match self {
            Self::Blocksworld => {
                let shape = BlocksworldShape { belief, ..BlocksworldShape::default() };
                shape.generate(seed).map(Drawn::any)
            }
            Self::Logistics => {
                let shape = LogisticsShape { belief, ..LogisticsShape::default() };
                shape.generate(seed).map(Drawn::any)
            }
            Self::Driverlog => {
                let shape = DriverlogShape { belief, ..DriverlogShape::default() };
                shape.generate(seed).map(Drawn::any)
            }
            Self::Gridworld | Self::BoxPushing | Self::RecyclingRobot | Self::Delivery => {
                self.draw(seed)
            }
        }
    }
}
