//! A walk, and the observer that watches it: what several kinds ask about.

use serde::Serialize;

use crate::document::DocumentError;
use crate::document::reader::{Fields, Reader};
use crate::exercise::Unfit;
use crate::exercise::belief_layers::{BeliefLayers, called};
use crate::exercise::subject::Subject;
use crate::plan::{Plan, PlanError};
use crate::problem::Problem;

/// The most steps of a walk in a question.
const MAX_STEPS: usize = 100;

/// A walk and an observer.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub(in crate::exercise) struct Watching {
    /// The name of the observer.
    pub(in crate::exercise) observer: String,
    /// The names of the actions.
    pub(in crate::exercise) plan: Vec<String>,
}

impl Watching {
    /// Reads `observer` and `plan`.
    pub(super) fn read(fields: &Fields<'_>) -> Result<Self, DocumentError> {
        let observer = fields.required("observer", "adversarial or cooperative")?;
        let observer = observer.one_of(&["adversarial", "cooperative"], |name| name)?.to_owned();
        let plan = fields.required("plan", "a list of actions")?;
        let actions = plan.list(|action: &Reader<'_>| action.text().map(str::to_owned))?;
        if actions.len() > MAX_STEPS {
            let found = format!("{} actions", actions.len());
            return Err(DocumentError::invalid(plan.path(), found, format!("at most {MAX_STEPS}")));
        }
        Ok(Self { observer, plan: actions })
    }

    /// The walk must be one of the problem.
    pub(super) fn refer(&self, problem: &Problem) -> Result<(), DocumentError> {
        self.execute(problem).map_err(|error| {
            DocumentError::invalid("exercise.plan", error.to_string(), "a walk of the problem")
        })
    }

    /// Whether the walk can be walked to its end.
    pub(super) fn execute(&self, problem: &Problem) -> Result<(), PlanError> {
        let plan = Plan::from_names(problem.task(), &self.plan)?;
        let label = |words: &[u64]| problem.label(words).to_string();
        crate::plan::execute(problem.task(), &plan, label).map(|_| ())
    }

    /// The observer's position. Documents have both observers.
    pub(super) fn observer(&self, problem: &Problem) -> usize {
        problem.observer_named(&self.observer).unwrap_or_default()
    }

    /// A word for the observer.
    pub(super) fn who(&self, problem: &Problem) -> &'static str {
        called(problem.observers()[self.observer(problem)].role)
    }

    /// What the observer takes for possible along the walk.
    pub(super) fn layers(&self, subject: &Subject) -> Result<BeliefLayers, Unfit> {
        let plan = Plan::from_names(subject.problem.task(), &self.plan)
            .map_err(|error| Unfit::new(format!("the walk fails: {error}")))?;
        BeliefLayers::new(&subject.problem, self.observer(&subject.problem), &plan)
    }

    /// How often the states of the problem are passed at most until the belief at the end is known.
    pub(super) fn passes(&self) -> u64 {
        self.plan.len() as u64 + 1
    }

    /// The walk in words.
    pub(super) fn walk(&self) -> String {
        match self.plan.len() {
            0 => "Before the first step".to_owned(),
            1 => format!("After the step {}", self.plan[0]),
            _ => format!("After the walk {}", self.plan.join(", ")),
        }
    }
}
