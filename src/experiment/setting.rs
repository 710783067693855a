//! What a run of an experiment is about: everything that decides its records, and its jobs.

use std::str::FromStr;

use serde::{Deserialize, Serialize};

use super::configuration::Lengths;
use super::series::{Series, SeriesJob};
use super::{Configuration, ExperimentError, Figure, Header, Record, TestDomain, validity};

/// The most problems of a domain.
pub const MAX_PROBLEMS: u32 = 10_000;

/// The most memory that can be asked for: a million GiB.
const MAX_MEMORY_MIB: u64 = 1 << 30;

/// Where the solvers of a run stop. All but the last count work, so that every run stops at the
/// same place.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SettingLimits {
    /// MiB of states, beliefs and nodes of one solver, counted by contents.
    pub memory_mib: u64,
    /// Expansions of the exact solver where it looks at plans of many lengths.
    pub exact_expansions: u64,
    /// Expansions of Algorithm 1, with both bounds or one.
    pub search_expansions: u64,
    /// Branch-and-bound nodes of the paper's encoding; none leaves that encoding out.
    pub paper_nodes: Option<u64>,
    /// Nonzero coefficients of the paper's encoding.
    pub paper_nonzeros: u64,
    /// Seconds of one solver, as a safety: where it is met, the answer depends on the machine.
    pub seconds: Option<u64>,
}

impl Default for SettingLimits {
    fn default() -> Self {
        Self {
            memory_mib: 640,
            exact_expansions: 1_000_000,
            search_expansions: 50_000,
            paper_nodes: Some(1),
            paper_nonzeros: 200_000,
            seconds: None,
        }
    }
}

/// What the observers of Figure 4 believe before the first step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum InitialBeliefs {
    /// Both know the initial state. The friend's symbols refine the enemy's, so the friend is never
    /// in more doubt and no goal difference is negative.
    #[default]
    Known,
    /// From 1 to 8 states, drawn for each observer by itself: the friend may begin in more doubt
    /// than the enemy.
    Drawn,
}

/// The most states in a belief that is drawn.
const DRAWN_STATES: u32 = 8;

impl InitialBeliefs {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Known, Self::Drawn];

    /// The name on the command line and in records.
    pub fn name(self) -> &'static str {
        match self {
            Self::Known => "known",
            Self::Drawn => "drawn",
        }
    }

    /// The most states in an initial belief.
    pub fn most(self) -> u32 {
        match self {
            Self::Known => 1,
            Self::Drawn => DRAWN_STATES,
        }
    }
}

/// What a run is about.
///
/// ```
/// use mo_copp::experiment::{Figure, Setting};
/// let setting = Setting { problems: 2, ..Setting::new(Figure::Fig3) };
/// let jobs = setting.jobs();
/// assert_eq!(jobs.len() % 2, 0);
/// assert_eq!((jobs[0].problem, jobs[jobs.len() - 1].problem), (1, 2));
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Setting {
    /// Which experiment.
    pub figure: Figure,
    /// The seed of the first problem of each domain; the others have the seeds that follow.
    pub seed: u64,
    /// How many problems of each domain.
    pub problems: u32,
    /// The domains.
    pub domains: Vec<TestDomain>,
    /// What observers believe at first, in Figure 4.
    pub beliefs: InitialBeliefs,
    /// Where solvers stop.
    pub limits: SettingLimits,
}

/// One problem for one solver.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Job {
    /// Its place in the records of a whole run.
    pub place: usize,
    /// The domain.
    pub domain: TestDomain,
    /// The number of the problem, from 1.
    pub problem: u32,
    /// The solver.
    pub configuration: Configuration,
    /// Its place in an order in which the problems of a domain and a solver stand together.
    column_first: usize,
}

impl Job {
    /// The first horizon of the solver, where it takes one.
    pub(super) fn first_horizon(&self) -> Option<usize> {
        match self.configuration.lengths() {
            Lengths::Any => None,
            Lengths::Exactly | Lengths::UpTo => Some(self.domain.horizon),
        }
    }
}

impl SeriesJob for Job {
    fn place(&self) -> usize {
        self.place
    }

    fn deal(&self) -> usize {
        self.column_first
    }

    fn name(&self) -> String {
        let Self { domain, problem, configuration, .. } = self;
        format!("{} {problem} {}", domain.domain.name(), configuration.name())
    }
}

impl Series for Setting {
    type Job = Job;
    type Header = Header;
    type Record = Record;

    fn jobs(&self) -> Vec<Job> {
        self.jobs()
    }

    fn header(&self, shard: Shard) -> Header {
        Header::new(self, shard)
    }

    fn of_header(header: &Header) -> Result<Self, (String, String)> {
        header.setting()
    }

    fn check(&self, record: &Record, job: &Job) -> Result<(), (String, String)> {
        let seed = self.seed_of(job.problem);
        if record.seed != seed {
            return Err((format!(" of seed {}", record.seed), format!("seed {seed}")));
        }
        validity::check(record, self, job).map_err(|expected| (String::new(), expected))
    }
}

impl Setting {
    /// The paper's: 30 problems of each domain.
    pub fn new(figure: Figure) -> Self {
        Self {
            figure,
            seed: 1,
            problems: 30,
            domains: figure.domains().to_vec(),
            beliefs: InitialBeliefs::Known,
            limits: SettingLimits::default(),
        }
    }

    /// Checks the numbers.
    ///
    /// # Errors
    ///
    /// [`ExperimentError::Choice`] with the option, what it is and what would do.
    pub fn check(&self) -> Result<(), ExperimentError> {
        if !(1..=MAX_PROBLEMS).contains(&self.problems) {
            let expected = format!("a whole number from 1 to {MAX_PROBLEMS}");
            return Err(ExperimentError::choice("problems", self.problems.to_string(), expected));
        }
        if !(1..=MAX_MEMORY_MIB).contains(&self.limits.memory_mib) {
            let expected = format!("a number of MiB from 1 to {MAX_MEMORY_MIB}");
            return Err(ExperimentError::choice(
                "memory limit",
                self.limits.memory_mib.to_string(),
                expected,
            ));
        }
        for (index, domain) in self.domains.iter().enumerate() {
            if self.domains[..index].contains(domain) {
                let found = format!("{} for the second time", domain.domain.name());
                return Err(ExperimentError::choice("domain", found, "each domain once"));
            }
        }
        if self.domains.is_empty() {
            return Err(ExperimentError::choice("domain", "none", "at least one"));
        }
        Ok(())
    }

    /// The solvers of each domain.
    pub fn configurations(&self) -> Vec<Configuration> {
        let all = self.figure.configurations().iter().copied();
        all.filter(|configuration| configuration.takes_part(&self.limits)).collect()
    }

    /// The seed of a problem (counted from 1), as `mo-copp generate DOMAIN --seed` takes it.
    pub fn seed_of(&self, problem: u32) -> u64 {
        self.seed.wrapping_add(u64::from(problem) - 1)
    }

    /// All jobs: problem by problem, so that the work left can be told from the work done.
    pub fn jobs(&self) -> Vec<Job> {
        let columns: Vec<(TestDomain, Configuration)> = self
            .domains
            .iter()
            .flat_map(|domain| {
                self.configurations().into_iter().map(|configuration| (*domain, configuration))
            })
            .collect();
        let mut jobs = Vec::new();
        for problem in 1..=self.problems {
            for (column, &(domain, configuration)) in columns.iter().enumerate() {
                let column_first = column * self.problems as usize + problem as usize - 1;
                jobs.push(Job { place: jobs.len(), domain, problem, configuration, column_first });
            }
        }
        jobs
    }
}

/// One of `of` parts of a run, counted from 1.
///
/// ```
/// use mo_copp::experiment::Shard;
/// assert_eq!("2/5".parse::<Shard>().unwrap(), Shard { number: 2, of: 5 });
/// assert!("6/5".parse::<Shard>().is_err());
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(into = "String", try_from = "String")]
pub struct Shard {
    /// Which part.
    pub number: u32,
    /// How many parts.
    pub of: u32,
}

impl Shard {
    /// The whole run.
    pub const WHOLE: Self = Self { number: 1, of: 1 };

    /// Whether a job belongs to this part. The problems of a domain and a solver are dealt out one
    /// by one, so that the parts take about as long as each other.
    pub fn holds(self, job: &impl SeriesJob) -> bool {
        job.deal() % self.of as usize + 1 == self.number as usize
    }
}

impl std::fmt::Display for Shard {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}/{}", self.number, self.of)
    }
}

impl From<Shard> for String {
    fn from(shard: Shard) -> Self {
        shard.to_string()
    }
}

impl TryFrom<String> for Shard {
    type Error = ExperimentError;

    fn try_from(text: String) -> Result<Self, ExperimentError> {
        text.parse()
    }
}

impl FromStr for Shard {
    type Err = ExperimentError;

    fn from_str(text: &str) -> Result<Self, ExperimentError> {
        let number = |text: &str| text.parse::<u32>().ok();
        let parts = text.split_once('/').and_then(|(i, n)| Some((number(i)?, number(n)?)));
        match parts {
            Some((number, of)) if (1..=of).contains(&number) => Ok(Self { number, of }),
            _ => Err(ExperimentError::choice("shard", text, "I/N with I from 1 to N, as in 2/8")),
        }
    }
}
