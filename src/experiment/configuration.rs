//! Configurations: solvers with the options that the experiments give them, each a row of the tables.

use super::{Figure, SettingLimits};
use crate::limits::Limits;
use crate::solver::{Encoding, Horizon, Options, Solver};

/// How far a horizon without a plan is raised at a time: the paper's step.
pub const HORIZON_STEP: usize = 2;

/// A solver with the options an experiment gives it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Configuration {
    /// A plan for the true goal, whatever anybody makes of it.
    Baseline,
    /// The integer program, in the belief-flow encoding.
    Ip,
    /// The integer program, in the paper's encoding.
    IpPaper,
    /// Algorithm 1 with k and j.
    Search,
    /// The portfolio of Algorithm 1 and exact search with k and j.
    Satisficing,
    /// The best plan of as many actions as the integer program takes.
    Exact,
    /// The best plan of up to the domain's horizon.
    ExactUpTo,
    /// The best plan of any length.
    ExactAny,
    /// Algorithm 1 with k alone.
    Obfuscate,
    /// Algorithm 1 with j alone.
    Legible,
}

/// What lengths of plans a configuration looks at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Lengths {
    /// All at once.
    Any,
    /// Exactly a horizon, raised while it has no plan.
    Exactly,
    /// All up to a horizon, raised while it has no plan.
    UpTo,
}

impl Configuration {
    /// The name in records and files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Baseline => "baseline",
            Self::Ip => "ip",
            Self::IpPaper => "ip-paper",
            Self::Search => "search",
            Self::Satisficing => "satisficing",
            Self::Exact => "exact",
            Self::ExactUpTo => "exact-up-to",
            Self::ExactAny => "exact-any",
            Self::Obfuscate => "obfuscate",
            Self::Legible => "legible",
        }
    }

    /// How tables and figures call it.
    pub fn title(self) -> &'static str {
        match self {
            Self::Baseline => "baseline",
            Self::Ip => "integer program",
            Self::IpPaper => "integer program, paper's encoding",
            Self::Search => "search",
            Self::Satisficing => "satisficing search",
            Self::Exact => "exact, horizon of the integer program",
            Self::ExactUpTo => "exact, up to the horizon",
            Self::ExactAny => "exact, all lengths",
            Self::Obfuscate => "obfuscation alone",
            Self::Legible => "legibility alone",
        }
    }

    /// Whether it stands for the optimum.
    pub fn is_exact(self) -> bool {
        matches!(self, Self::Exact | Self::ExactUpTo | Self::ExactAny)
    }

    /// Whether a run with these limits has this configuration.
    pub(super) fn takes_part(self, limits: &SettingLimits) -> bool {
        self != Self::IpPaper || limits.paper_nodes.is_some()
    }

    /// What lengths of plans it looks at.
    pub fn lengths(self) -> Lengths {
        match self {
            Self::Ip | Self::IpPaper | Self::Exact => Lengths::Exactly,
            Self::ExactUpTo => Lengths::UpTo,
            _ => Lengths::Any,
        }
    }

    /// The options of its solver; the memory limit and a first horizon are the run's to fill in.
    pub fn options(self, figure: Figure, limits: &SettingLimits) -> Options {
        let solver = match self {
            Self::Baseline => Solver::Baseline,
            Self::Ip | Self::IpPaper => Solver::Ip,
            Self::Search => Solver::Search,
            Self::Satisficing => Solver::Satisficing,
            Self::Exact | Self::ExactUpTo | Self::ExactAny => Solver::Exact,
            Self::Obfuscate => Solver::Obfuscate,
            Self::Legible => Solver::Legible,
        };
        let (k, j) = figure.bounds();
        let mut options = Options::new(solver);
        let both = matches!(self, Self::Search | Self::Satisficing);
        options.bounds.at_least = (both || self == Self::Obfuscate).then_some(k);
        options.bounds.at_most = (both || self == Self::Legible).then_some(j);
        if self == Self::IpPaper {
            options.encoding = Encoding::Paper;
            options.limits.nodes = limits.paper_nodes.unwrap_or(u64::MAX);
            options.limits.nonzeros = limits.paper_nonzeros;
        }
        match self {
            Self::ExactAny => options.limits.expansions = limits.exact_expansions,
            Self::Search | Self::Obfuscate | Self::Legible => {
                options.limits.expansions = limits.search_expansions;
            }
            _ => {}
        }
        options.horizon = match self.lengths() {
            Lengths::Any => Horizon::Any,
            Lengths::Exactly | Lengths::UpTo => Horizon::Auto,
        };
        if self.lengths() == Lengths::Exactly {
            options.horizon_step = HORIZON_STEP;
        }
        options.limits = Limits { bytes: limits.memory_mib << 20, ..options.limits };
        options
    }
}
