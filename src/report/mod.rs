//! What other programs read: the JSON of the command line and the objects of the JavaScript API.

mod advice;
mod belief;
mod by_observer;
mod classical;
mod elimination;
#[cfg(feature = "full")]
mod exercise;
#[cfg(feature = "full")]
mod import;
mod request;
mod scene;
mod solve;
mod trace;

pub use advice::{AdviceReport, RemedyReport};
pub use belief::{BeliefReport, Feature, Share};
pub use by_observer::ByObserver;
pub use classical::{PlanReport, PlanStats};
pub use elimination::{EliminationReport, MissedReport, NearestReport};
#[cfg(feature = "full")]
pub use exercise::{ExerciseReport, FindingReport, SampleReport, SolutionReport, VerdictReport};
#[cfg(feature = "full")]
pub use import::{ImportReport, read_import_files, read_import_options};
pub use request::{Request, read_request};
pub use scene::{Scene, SceneGoal, SceneObserver, Setting};
pub use solve::{FrontReport, LengthReport, PairReport, ProgressReport, SolveReport, StatsReport};
pub use trace::{NextReport, StepReport, TraceReport};
