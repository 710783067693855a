//! Classical planning: the baseline on a task without observers.

use std::sync::Arc;

use super::engine::{Advance, Engine, Finding};
use super::outcome::{Stats, Status};
use super::{SolveError, baseline};
use crate::limits::{LimitReached, Limits};
use crate::plan::{Plan, execute};
use crate::task::Task;

/// The baseline at work on a task.
///
/// ```
/// use std::sync::Arc;
/// use mo_copp::{limits::Limits, solver::{ClassicalRun, Status}, task::TaskBuilder};
/// let mut task = TaskBuilder::default();
/// let (here, there) = (task.fact("here"), task.fact("there"));
/// task.operator("go", &[here], &[there], &[here]);
/// let task = Arc::new(task.build(&[here], &[there])?);
/// let mut run = ClassicalRun::new(Arc::clone(&task), Limits::default());
/// while !run.advance(100) {}
/// let outcome = run.outcome()?;
/// assert_eq!(outcome.status, Status::Solved);
/// assert_eq!(outcome.plan.map(|plan| plan.names(&task)), Some(vec!["go".to_owned()]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct ClassicalRun {
    task: Arc<Task>,
    engine: Box<dyn Engine>,
    finding: Option<Finding>,
}

/// Shown without the engine.
impl std::fmt::Debug for ClassicalRun {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("ClassicalRun").finish_non_exhaustive()
    }
}

/// The answer.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct ClassicalOutcome {
    /// Solved, infeasible or limit.
    pub status: Status,
    /// The plan.
    pub plan: Option<Plan>,
    /// The limit that was met.
    pub limit: Option<LimitReached>,
    /// What the work took.
    pub stats: Stats,
}

impl ClassicalRun {
    /// Gets ready.
    pub fn new(task: Arc<Task>, limits: Limits) -> Self {
        let engine = Box::new(baseline::engine(&task, limits, None, None));
        Self { task, engine, finding: None }
    }

    /// Works for about `budget` expansions; true when there is an answer.
    pub fn advance(&mut self, budget: u64) -> bool {
        if self.finding.is_none() {
            self.finding = match self.engine.advance(budget) {
                Ok(Advance::Working) => None,
                Ok(Advance::Finished(finding)) => Some(finding),
                Err(limit) => Some(self.engine.stop(limit)),
            };
        }
        self.finding.is_some()
    }

    /// What the work took so far.
    pub fn stats(&self) -> Stats {
        self.engine.stats()
    }

    /// The answer; a run stopped before its end has none but that. The plan is replayed before it
    /// is given out.
    ///
    /// # Errors
    ///
    /// [`SolveError::Replay`] when the plan does not reach the goal.
    pub fn outcome(mut self) -> Result<ClassicalOutcome, SolveError> {
        let stats = self.engine.stats();
        let finding = match self.finding.take() {
            Some(finding) => finding,
            None => self.engine.stop(LimitReached::Cancelled),
        };
        if let Some(plan) = &finding.plan {
            let task = &self.task;
            let (_, states) = execute(task, plan, |_| "a state of the plan".to_owned())
                .map_err(|error| SolveError::Replay(error.to_string()))?;
            if !states.last().is_some_and(|end| task.satisfies(end.words(), task.goal())) {
                return Err(SolveError::Replay("it does not reach the goal".to_owned()));
            }
        }
        let Finding { status, plan, limit, .. } = finding;
        Ok(ClassicalOutcome { status, plan, limit, stats })
    }
}
