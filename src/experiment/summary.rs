//! What the records of a run come to: means, deviations, statuses and the analysis of variance.

use serde::Serialize;

use super::record::Record;
use super::records::Entries;
use super::statistics::{Anova, Spread};
use super::{Configuration, Figure, InitialBeliefs, Setting, SettingLimits};

/// A measure of a solver's answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measure {
    /// The goal difference of the plan.
    GoalDifference,
    /// The number of its actions.
    Length,
    /// Seconds on the clock.
    Seconds,
}

impl Measure {
    /// All of them, in the paper's order.
    pub const ALL: [Self; 3] = [Self::GoalDifference, Self::Length, Self::Seconds];

    /// The name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::GoalDifference => "goal_difference",
            Self::Length => "length",
            Self::Seconds => "seconds",
        }
    }

    /// How tables and figures call it.
    pub fn title(self) -> &'static str {
        match self {
            Self::GoalDifference => "goal difference",
            Self::Length => "plan length",
            Self::Seconds => "run time",
        }
    }

    /// Its value in a record. The goal difference and the length are those of the plan; seconds
    /// count where there is an answer, a plan or the proof that there is none.
    pub fn of(self, record: &Record) -> Option<f64> {
        match self {
            Self::GoalDifference => record.goal_difference,
            Self::Length => record.length.map(|length| length as f64),
            Self::Seconds => (record.status != "limit").then_some(record.seconds),
        }
    }
}

/// How many records have each status.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Statuses {
    /// A plan, proved best.
    pub optimal: usize,
    /// A plan that keeps the bounds.
    pub solved: usize,
    /// A plan, but a limit came before the proof.
    pub feasible: usize,
    /// Proved: no plan keeps the bounds.
    pub infeasible: usize,
    /// No plan found and nothing proved.
    pub limit: usize,
}

impl Statuses {
    fn count(&mut self, status: &str) {
        let counter = match status {
            "optimal" => &mut self.optimal,
            "solved" => &mut self.solved,
            "feasible" => &mut self.feasible,
            "infeasible" => &mut self.infeasible,
            _ => &mut self.limit,
        };
        *counter += 1;
    }

    /// Name and number of those that occur.
    pub fn named(&self) -> Vec<(&'static str, usize)> {
        let all = [
            ("optimal", self.optimal),
            ("solved", self.solved),
            ("feasible", self.feasible),
            ("infeasible", self.infeasible),
            ("limit", self.limit),
        ];
        all.into_iter().filter(|(_, count)| *count > 0).collect()
    }
}

/// A solver on a domain.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SolverSummary {
    /// Its name in records.
    pub solver: &'static str,
    /// Its name in tables.
    pub title: &'static str,
    /// How sure its answers are.
    pub statuses: Statuses,
    /// Of its plans.
    pub goal_difference: Option<Spread>,
    /// Of its plans.
    pub length: Option<Spread>,
    /// Of its answers.
    pub seconds: Option<Spread>,
    #[serde(skip)]
    configuration: Configuration,
}

impl SolverSummary {
    /// The spread of a measure.
    pub fn spread(&self, measure: Measure) -> Option<Spread> {
        match measure {
            Measure::GoalDifference => self.goal_difference,
            Measure::Length => self.length,
            Measure::Seconds => self.seconds,
        }
    }
}

/// The analysis of variance for a measure.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AnovaSummary {
    /// The measure.
    pub measure: &'static str,
    /// The solvers that are the groups.
    pub groups: Vec<&'static str>,
    /// Its result, where there is one.
    pub anova: Option<Anova>,
}

/// The goal difference of a solver relative to that of the search, as in Figure 4(b) of the paper.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Relative {
    /// The solver.
    pub solver: &'static str,
    /// Its name in tables.
    pub title: &'static str,
    /// On how many problems both have a plan.
    pub n: usize,
    /// Its mean goal difference on these.
    pub mean: f64,
    /// The mean goal difference of the search on these.
    pub search: f64,
    /// 100 times the first over the second; none where the search's is 0.
    pub percent: Option<f64>,
    /// The standard deviation of the solver's goal difference in the same unit.
    pub percent_sd: Option<f64>,
}

/// A domain.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DomainSummary {
    /// Its name in records.
    pub domain: &'static str,
    /// Its name in tables.
    pub title: &'static str,
    /// The first horizon of the solvers that take one.
    pub horizon: usize,
    /// How many problems.
    pub problems: u32,
    /// How many documents were drawn and thrown away because their true goal cannot be reached.
    pub redraws: u64,
    /// Each solver.
    pub solvers: Vec<SolverSummary>,
    /// Each measure over the solvers that the paper compares.
    pub anova: Vec<AnovaSummary>,
    /// In Figure 4, what is left of the search's goal difference without one of its bounds.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub relative: Vec<Relative>,
}

/// A run: what `results.json` holds.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Summary {
    /// `fig3` or `fig4`.
    pub experiment: &'static str,
    /// The version of this program.
    pub version: &'static str,
    /// The seed of the first problem of each domain.
    pub seed: u64,
    /// How many problems of each domain.
    pub problems: u32,
    /// What observers believe at first, in Figure 4.
    pub initial_beliefs: InitialBeliefs,
    /// k and j of the search.
    pub bounds: (usize, usize),
    /// Where solvers stopped.
    pub limits: SettingLimits,
    /// Each domain.
    pub domains: Vec<DomainSummary>,
}

/// The records of a solver on a domain, in the order of the problems.
struct Column<'a> {
    configuration: Configuration,
    records: Vec<&'a Record>,
}

impl Column<'_> {
    fn values(&self, measure: Measure) -> Vec<f64> {
        self.records.iter().filter_map(|record| measure.of(record)).collect()
    }

    fn summary(&self) -> SolverSummary {
        let mut statuses = Statuses::default();
        for record in &self.records {
            statuses.count(&record.status);
        }
        let spread = |measure| Spread::of(&self.values(measure));
        SolverSummary {
            solver: self.configuration.name(),
            title: self.configuration.title(),
            statuses,
            goal_difference: spread(Measure::GoalDifference),
            length: spread(Measure::Length),
            seconds: spread(Measure::Seconds),
            configuration: self.configuration,
        }
    }

    /// Relative to the search, on the problems where both have a plan.
    fn relative(&self, search: &Self) -> Option<Relative> {
        let pairs: Vec<(f64, f64)> = self
            .records
            .iter()
            .zip(&search.records)
            .filter_map(|(own, search)| Some((own.goal_difference?, search.goal_difference?)))
            .collect();
        let spread =
            |of: fn(&(f64, f64)) -> f64| Spread::of(&pairs.iter().map(of).collect::<Vec<_>>());
        let (own, search) = (spread(|pair| pair.0)?, spread(|pair| pair.1)?.mean);
        let percent = |value: f64| (search != 0.0).then(|| 100.0 * value / search);
        Some(Relative {
            solver: self.configuration.name(),
            title: self.configuration.title(),
            n: pairs.len(),
            mean: own.mean,
            search,
            percent: percent(own.mean),
            percent_sd: own.sd.and_then(percent),
        })
    }
}

impl Summary {
    /// What all records of a run come to.
    pub fn new(setting: &Setting, entries: &Entries) -> Self {
        let jobs = setting.jobs();
        let column = |domain, configuration| Column {
            configuration,
            records: jobs
                .iter()
                .filter(|job| job.domain == domain && job.configuration == configuration)
                .filter_map(|job| Some(&entries.get(&job.place)?.record))
                .collect(),
        };
        let domains = setting.domains.iter().map(|&domain| {
            let columns: Vec<Column<'_>> =
                setting.configurations().into_iter().map(|e| column(domain, e)).collect();
            let redraws = columns.first().map_or(0, |column| {
                column.records.iter().map(|record| u64::from(record.redraws)).sum()
            });
            DomainSummary {
                domain: domain.domain.name(),
                title: domain.title,
                horizon: domain.horizon,
                problems: setting.problems,
                redraws,
                solvers: columns.iter().map(Column::summary).collect(),
                anova: anova(setting.figure, &columns),
                relative: relative(setting.figure, &columns),
            }
        });
        Self {
            experiment: setting.figure.name(),
            version: env!("CARGO_PKG_VERSION"),
            seed: setting.seed,
            problems: setting.problems,
            initial_beliefs: setting.beliefs,
            bounds: setting.figure.bounds(),
            limits: setting.limits.clone(),
            domains: domains.collect(),
        }
    }
}

impl DomainSummary {
    /// The summary of a solver.
    pub fn of(&self, configuration: Configuration) -> Option<&SolverSummary> {
        self.solvers.iter().find(|solver| solver.configuration == configuration)
    }
}

fn find<'a, 'b>(columns: &'b [Column<'a>], configuration: Configuration) -> Option<&'b Column<'a>> {
    columns.iter().find(|column| column.configuration == configuration)
}

/// For each measure, over the three solvers that the paper compares.
fn anova(figure: Figure, columns: &[Column<'_>]) -> Vec<AnovaSummary> {
    let compared = figure.compared();
    let one = |measure: Measure| {
        let groups = compared.iter().filter_map(|&configuration| find(columns, configuration));
        let values: Vec<Vec<f64>> = groups.map(|column| column.values(measure)).collect();
        let groups: Vec<&[f64]> = values.iter().map(Vec::as_slice).collect();
        AnovaSummary {
            measure: measure.name(),
            groups: compared.map(Configuration::name).to_vec(),
            anova: Anova::of(&groups),
        }
    };
    Measure::ALL.into_iter().map(one).collect()
}

fn relative(figure: Figure, columns: &[Column<'_>]) -> Vec<Relative> {
    let (Figure::Fig4, Some(search)) = (figure, find(columns, Configuration::Search)) else {
        return Vec::new();
    };
    let alone = [Configuration::Obfuscate, Configuration::Legible];
    let found = alone.into_iter().filter_map(|configuration| find(columns, configuration));
    found.filter_map(|column| column.relative(search)).collect()
}
