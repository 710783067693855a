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
}

const fn row(domain: Domain, title: &'static str, horizon: usize) -> TestDomain {
    TestDomain { domain, title, horizon }
}

const FIG3: &[TestDomain] = &[
    row(Domain::Gridworld, "Gridworld", 12),
    row(Domain::BoxPushing, "Box Pushing", 12),
    row(Domain::RecyclingRobot, "Recycling Robot", 10),
];

const FIG4: &[TestDomain] = &[
    row(Domain::Blocksworld, "Blocksworld", 12),
    row(Domain::Logistics, "Logistics", 12),
    row(Domain::Driverlog, "Driverlog", 12),
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
