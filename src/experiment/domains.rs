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
    /// Whether the exact solver can prove an optimum at such a horizon.
    pub exact: bool,
}

const FIG3: &[TestDomain] =
    &[TestDomain { domain: Domain::Gridworld, title: "Gridworld", horizon: 12, exact: true }];

const FIG4: &[TestDomain] = &[
    TestDomain { domain: Domain::Blocksworld, title: "Blocksworld", horizon: 12, exact: true },
    TestDomain { domain: Domain::Logistics, title: "Logistics", horizon: 12, exact: false },
    TestDomain { domain: Domain::Driverlog, title: "Driverlog", horizon: 12, exact: false },
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
