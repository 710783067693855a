//! The four ways to go.

use serde::Serialize;

/// One of the four ways to go.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub enum Direction {
    /// Up.
    North,
    /// Down.
    South,
    /// To the right.
    East,
    /// To the left.
    West,
}

impl Direction {
    /// All of them, in the order in which operators are made.
    pub const ALL: [Self; 4] = [Self::North, Self::South, Self::East, Self::West];

    /// The name in documents.
    pub fn name(self) -> &'static str {
        match self {
            Self::North => "north",
            Self::South => "south",
            Self::East => "east",
            Self::West => "west",
        }
    }

    /// The direction of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|direction| direction.name() == name)
    }

    /// Where somebody who faces this way faces after a quarter turn to the left.
    #[must_use]
    pub fn left(self) -> Self {
        match self {
            Self::North => Self::West,
            Self::West => Self::South,
            Self::South => Self::East,
            Self::East => Self::North,
        }
    }

    /// The same after a quarter turn to the right.
    #[must_use]
    pub fn right(self) -> Self {
        self.left().left().left()
    }

    /// What a step this way adds to column and row.
    pub(super) fn offset(self) -> (i32, i32) {
        match self {
            Self::North => (0, -1),
            Self::South => (0, 1),
            Self::East => (1, 0),
            Self::West => (-1, 0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_turns_lead_back_and_right_undoes_left() {
        for direction in Direction::ALL {
            assert_eq!(direction.left().right(), direction);
            assert_eq!(direction.left().left().left().left(), direction);
            assert_eq!(Direction::named(direction.name()), Some(direction));
        }
        assert_eq!(Direction::North.right(), Direction::East);
        assert_eq!(Direction::North.left(), Direction::West);
    }
}
