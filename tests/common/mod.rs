//! What the tests share: problems as plain tables, oracles that follow the definitions and share
//! nothing with the crate, and generators.

pub mod atoms;
pub mod box_pushing;
pub mod check;
pub mod delivery;
pub mod dice;
pub mod floor;
pub mod gridworld;
pub mod oracle;
pub mod printed;
pub mod random;
pub mod recycling_robot;
pub mod strips;
pub mod table;

pub use check::{Judge, solve};
pub use dice::Dice;
pub use oracle::Wish;
pub use table::Table;

/// How many inputs a fuzz test tries: `usual`, or what `MO_COPP_FUZZ_CASES` says.
pub fn fuzz_cases(usual: u32) -> u32 {
    std::env::var("MO_COPP_FUZZ_CASES").map_or(usual, |cases| cases.parse().unwrap())
}
