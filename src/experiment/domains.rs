//! The domains of the experiments, and what each asks for. A domain more is a line more.

use super::Figure;
use crate::domain::generate::Domain;

/// A domain as an experiment uses it: problems of the default size, which is the paper's.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TestDomain {
    /// Draws the problems.
    pub domain: Domain,
    /// How tables and figures call it.
    pub title: &'static str,
    /// The first horizon of the integer program and of the exact solver beside it.
    pub horizon: usize,
    /// Whether the exact solver is let loose on plans of all lengths.
    pub all_lengths: bool,
}

const fn row(domain: Domain, title: &'static str, horizon: usize, all_lengths: bool) -> TestDomain {
    TestDomain { domain, title, horizon, all_lengths }
}

const FIG3: &[TestDomain] = &[
    row(Domain::Gridworld, "Gridworld", 12, true),
    row(Domain::BoxPushing, "Box Pushing", 12, true),
    row(Domain::RecyclingRobot, "Recycling Robot", 10, true),
];

const FIG4: &[TestDomain] = &[
    row(Domain::Blocksworld, "Blocksworld", 12, true),
    // Breadth first, a million expansions do not even reach the true goal.
    row(Domain::Logistics, "Logistics", 12, false),
    row(Domain::Driverlog, "Driverlog", 12, true),
];

impl Figure {
    /// The domains of the experiment, in the paper's order.
    pub fn domains(self) -> &'static [TestDomain] {
        match self {
            Self::Fig3 => FIG3,
            Self::Fig4 => FIG4,
        }
    }

    /// Its domain of this name.
    pub fn domain_named(self, name: &str) -> Option<TestDomain> {
        self.domains().iter().find(|domain| domain.domain.name() == name).copied()
    }
}
