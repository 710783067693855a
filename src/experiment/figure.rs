//! The two experiments of the paper's section "Empirical Evaluation", named after its figures.

use super::Configuration;

/// An experiment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Figure {
    /// Figure 3: the baseline, the integer program and the search on three small domains.
    Fig3,
    /// Figure 4: the search against obfuscation alone and legibility alone on three IPC domains.
    Fig4,
}

impl Figure {
    /// Both of them.
    pub const ALL: [Self; 2] = [Self::Fig3, Self::Fig4];

    /// The name on the command line and in records.
    pub fn name(self) -> &'static str {
        match self {
            Self::Fig3 => "fig3",
            Self::Fig4 => "fig4",
        }
    }

    /// The experiment of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|figure| figure.name() == name)
    }

    /// The solvers, in the order of tables. The exact ones, the portfolio and the second encoding
    /// are ours.
    pub fn configurations(self) -> &'static [Configuration] {
        match self {
            Self::Fig3 => &[
                Configuration::Baseline,
                Configuration::Ip,
                Configuration::Search,
                Configuration::Satisficing,
                Configuration::Exact,
                Configuration::ExactAny,
                Configuration::IpPaper,
            ],
            Self::Fig4 => &[
                Configuration::Search,
                Configuration::Obfuscate,
                Configuration::Legible,
                Configuration::Satisficing,
                Configuration::ExactUpTo,
                Configuration::ExactAny,
            ],
        }
    }

    /// The three that the paper compares, and that the analysis of variance is about.
    pub fn compared(self) -> [Configuration; 3] {
        match self {
            Self::Fig3 => [Configuration::Baseline, Configuration::Ip, Configuration::Search],
            Self::Fig4 => [Configuration::Search, Configuration::Obfuscate, Configuration::Legible],
        }
    }

    /// k and j of the search: at least k goals are left to the enemy, at most j to the friend.
    pub fn bounds(self) -> (usize, usize) {
        match self {
            Self::Fig3 => (2, 2),
            Self::Fig4 => (3, 3),
        }
    }
}
