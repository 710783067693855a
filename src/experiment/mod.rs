//! The paper's experiments (section "Empirical Evaluation", Figures 3 and 4), natively only.
//!
//! - [`Setting`] says what a run is about and lists its [`Job`]s, one for each domain, problem and
//!   solver ([`Configuration`]); [`Figure::domains`] is the table of domains,
//! - [`run`](run()) does them on several threads; each leaves a [`Record`] in a [`RecordFile`],
//! - a run can be cut into [`Shard`]s, and [`merge`](merge()) puts them together,
//! - [`Summary`] is what the records come to, and [`output`] writes it down: `results.json`, tables
//!   and figures.
//!
//! [`benchmarks`] are solvers on other people's problems; what they share with the paper's experiments is
//! a [`Series`](series::Series).
//!
//! Records are the same for the same setting, but for seconds, whatever the threads and shards.

mod attempt;
pub mod benchmarks;
mod configuration;
mod domains;
mod error;
mod figure;
mod merge;
pub mod output;
mod record;
pub mod records;
mod run;
pub mod series;
mod setting;
pub mod statistics;
mod summary;
mod validity;

pub use configuration::{Configuration, HORIZON_STEP, Lengths};
pub use domains::TestDomain;
pub use error::ExperimentError;
pub use figure::Figure;
pub use merge::merge;
pub use record::{Asked, Header, Record, Survivors, Work};
pub use records::RecordFile;
pub use run::{Event, run};
pub use setting::{InitialBeliefs, Job, MAX_PROBLEMS, Setting, SettingLimits, Shard};
pub use summary::{
    AnovaSummary, DomainSummary, Measure, Relative, SolverSummary, Statuses, Summary,
};
