//! The JavaScript API: thin wrappers, typed for TypeScript, no logic.
//!
//! Meant for a worker: a [`Run`] is advanced in slices, so that the worker can take messages in
//! between.

// The code that #[wasm_bindgen] generates is full of it.
#![allow(unsafe_code)]
// Values cross the boundary owned; what a call throws stands in its description.
#![allow(clippy::needless_pass_by_value, clippy::missing_errors_doc)]

mod error;
mod types;

use std::sync::Arc;

use serde::Serialize;
use wasm_bindgen::prelude::*;

use crate::domain::Document;
use crate::limits::MAX_TEXT_BYTES;
#[cfg(feature = "full")]
use crate::picture::{draw, read_picture_options};
use crate::plan::{Plan, PlanError, next_actions};
use crate::problem;
use crate::report::{
    EliminationReport, NearestReport, NextReport, ProgressReport, Request, Scene, SolveReport,
    TraceReport, read_request,
};
use crate::solver;
use crate::trace::{elimination, nearest, trace};
#[cfg(feature = "full")]
use crate::{bindings::types::AdviceJs, report::AdviceReport, solver::remedy};
use error::thrown;
use types::{
    EliminationJs, NearestJs, NextActionsJs, OutcomeJs, PictureOptionsJs, ProgressJs, SceneJs,
    SolveOptionsJs, TraceJs,
};

/// Shows panics on the console with their message.
#[wasm_bindgen(start)]
pub fn start() {
    console_error_panic_hook::set_once();
}

/// The longest text of a document that is read, in bytes.
#[wasm_bindgen(js_name = maxTextBytes)]
pub fn max_text_bytes() -> usize {
    MAX_TEXT_BYTES
}

/// Plain objects, `null` for nothing.
fn to_js<T: Serialize, R: JsCast>(value: &T) -> Result<R, JsValue> {
    let serializer = serde_wasm_bindgen::Serializer::json_compatible();
    let value = value.serialize(&serializer).map_err(|e| thrown("Error", &e.to_string()))?;
    Ok(value.unchecked_into())
}

/// Milliseconds on the platform's clock.
fn now() -> f64 {
    let performance = js_sys::Reflect::get(&js_sys::global(), &"performance".into());
    performance.map_or(0.0, |found| found.unchecked_into::<web_sys::Performance>().now())
}

/// Makes a document of the files of a goal-recognition problem: `domain.pddl`, `template.pddl`, `hyps.dat`,
/// `real_hyp.dat` and perhaps `obs.dat`; files of other names are passed over. Throws an `ImportError` that names the
/// file and the place in it.
#[cfg(feature = "full")]
#[wasm_bindgen(js_name = importGoalRecognition)]
pub fn import_goal_recognition(
    files: types::ImportFilesJs,
    options: Option<types::ImportOptionsJs>,
) -> Result<types::ImportedJs, JsValue> {
    let text = |value: &JsValue| js_sys::JSON::stringify(value).map(String::from);
    let files = crate::report::read_import_files(&text(&files)?);
    let files = files.map_err(|e| error::options(&e))?;
    let options = match options {
        Some(options) => crate::report::read_import_options(&text(&options)?),
        None => Ok(crate::domain::pddl::import::ImportOptions::default()),
    };
    let options = options.map_err(|e| error::options(&e))?;
    let report = crate::report::ImportReport::new(&files, &options);
    to_js(&report.map_err(|e| error::import(&e))?)
}

/// A problem made of a document.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Problem {
    document: Document,
    problem: Arc<problem::Problem>,
}

#[wasm_bindgen]
impl Problem {
    /// Reads a document of any format. Throws a `DocumentError` that names the place.
    #[wasm_bindgen(constructor)]
    pub fn new(document: &str) -> Result<Problem, JsValue> {
        let text = document;
        let document = Document::parse(text).map_err(|e| error::document(&e, text))?;
        let problem = document.problem().map_err(|e| error::document(&e, text))?;
        Ok(Self { document, problem: Arc::new(problem) })
    }

    /// What there is to draw.
    pub fn scene(&self) -> Result<SceneJs, JsValue> {
        to_js(&Scene::new(&self.document, &self.problem))
    }

    /// Replays a plan. Throws a `PlanError` that names the step.
    pub fn trace(&self, plan: Vec<String>) -> Result<TraceJs, JsValue> {
        let plan = self.plan(&plan)?;
        let trace = trace(&self.problem, &plan).map_err(|e| error::plan(&e))?;
        to_js(&TraceReport::new(&self.problem, &trace))
    }

    /// Replays a plan to be looked at: of each belief at most `most` states, and with them what all
    /// its states have in common. Throws a `PlanError` that names the step.
    pub fn overview(&self, plan: Vec<String>, most: usize) -> Result<TraceJs, JsValue> {
        let plan = self.plan(&plan)?;
        let report = TraceReport::overview(&self.problem, &plan, most);
        to_js(&report.map_err(|e| error::plan(&e))?)
    }

    /// The actions that can be taken after a plan, in the document's order. Throws a `PlanError`
    /// that names the step.
    pub fn next(&self, plan: Vec<String>) -> Result<NextActionsJs, JsValue> {
        let plan = self.plan(&plan)?;
        let label = |words: &[u64]| self.problem.label(words).to_string();
        let next = next_actions(self.problem.task(), &plan, label).map_err(|e| error::plan(&e))?;
        let next: Vec<_> = next.iter().map(|next| NextReport::new(&self.problem, next)).collect();
        to_js(&next)
    }

    /// Why a goal is not possible for an observer after a step of a plan: the last believed states
    /// that were in the goal or one action away from it, and the symbol that ended them; null where
    /// the goal is possible, or no believed state was so near. Throws a `PlanError` that names the
    /// step, and an `OptionsError` where there is no such observer or goal.
    pub fn elimination(
        &self,
        plan: Vec<String>,
        observer: &str,
        goal: &str,
        step: usize,
    ) -> Result<EliminationJs, JsValue> {
        let plan = self.plan(&plan)?;
        let (watching, wanted) = self.watched(observer, goal)?;
        let found = elimination(&self.problem, &plan, watching, wanted, step);
        let found = found.map_err(|e| error::plan(&e))?;
        to_js(&found.map(|found| EliminationReport::new(&self.problem, &found)))
    }

    /// How far a goal is from what an observer believes after a step of a plan: the believed state from which the fewest
    /// actions lead there; null where that takes too many states. Throws as `elimination` does.
    pub fn nearest(
        &self,
        plan: Vec<String>,
        observer: &str,
        goal: &str,
        step: usize,
    ) -> Result<NearestJs, JsValue> {
        let plan = self.plan(&plan)?;
        let (watching, wanted) = self.watched(observer, goal)?;
        let found = match nearest(&self.problem, &plan, watching, wanted, step) {
            Err(PlanError::TooManyStates { .. }) => None,
            found => Some(found.map_err(|e| error::plan(&e))?),
        };
        to_js(&found.map(|found| NearestReport::new(&self.problem, found.as_ref())))
    }

    /// Draws the boards of a step of a plan, or of all its steps, as SVG. Throws a `PlanError` that names the step, and an
    /// `OptionsError` where the options do not fit.
    #[cfg(feature = "full")]
    pub fn picture(&self, plan: Vec<String>, options: PictureOptionsJs) -> Result<String, JsValue> {
        let plan = self.plan(&plan)?;
        let text = js_sys::JSON::stringify(&options).map(String::from)?;
        let options = read_picture_options(&text, &self.problem, plan.len());
        let options = options.map_err(|e| error::options(&e))?;
        draw(&self.document, &self.problem, &plan, &options).map_err(|e| error::picture(&e))
    }

    /// Draws nothing: throws a `NeedsFullCore`.
    #[cfg(not(feature = "full"))]
    pub fn picture(
        &self,
        _plan: Vec<String>,
        _options: PictureOptionsJs,
    ) -> Result<String, JsValue> {
        Err(error::needs_full_core("pictures are drawn by the full core"))
    }

    /// Gets a solver ready. Throws an `OptionsError` where the options do not fit.
    pub fn solve(&self, options: SolveOptionsJs) -> Result<Run, JsValue> {
        let Request { options, old_names } = self.request(&options)?;
        let run = solver::Run::new(Arc::clone(&self.problem), options);
        Ok(Run { solving: run.map_err(|e| error::solve(&e))?, old_names, milliseconds: 0.0 })
    }

    /// Gets ready to say why a run with these options found no plan, and which change of one option
    /// would allow one. Throws an `OptionsError` where the options do not fit.
    #[cfg(feature = "full")]
    pub fn remedy(&self, options: SolveOptionsJs) -> Result<RemedyRun, JsValue> {
        let options = self.request(&options)?.options;
        let run = remedy::RemedyRun::new(Arc::clone(&self.problem), options);
        Ok(RemedyRun { run: run.map_err(|e| error::solve(&e))? })
    }

    /// Finds no remedy: throws a `NeedsFullCore`.
    #[cfg(not(feature = "full"))]
    pub fn remedy(&self, _options: SolveOptionsJs) -> Result<(), JsValue> {
        Err(error::needs_full_core("remedies are found by the full core"))
    }
}

impl Problem {
    fn request(&self, options: &SolveOptionsJs) -> Result<Request, JsValue> {
        let text = js_sys::JSON::stringify(options).map(String::from)?;
        read_request(&text, &self.problem).map_err(|e| error::options(&e))
    }

    /// The positions of an observer and a goal.
    fn watched(&self, observer: &str, goal: &str) -> Result<(usize, usize), JsValue> {
        let unknown =
            |kind: &str, name: &str| thrown("OptionsError", &format!("no {kind} {name:?}"));
        let watching = self.problem.observer_named(observer);
        let watching = watching.ok_or_else(|| unknown("observer", observer))?;
        let wanted = self.problem.goal_named(goal).ok_or_else(|| unknown("goal", goal))?;
        Ok((watching, wanted))
    }

    fn plan(&self, names: &[String]) -> Result<Plan, JsValue> {
        Plan::from_names(self.problem.task(), names).map_err(|e| error::plan(&e))
    }
}

/// A solver at work.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Run {
    solving: solver::Run,
    old_names: bool,
    milliseconds: f64,
}

#[wasm_bindgen]
impl Run {
    /// Works for about this many expansions or nodes; true when there is an answer.
    pub fn advance(&mut self, budget: u32) -> Result<bool, JsValue> {
        let begin = now();
        let done = self.solving.advance(budget.into());
        self.milliseconds += now() - begin;
        done.map_err(|e| error::solve(&e))
    }

    /// What is known so far.
    pub fn progress(&self) -> Result<ProgressJs, JsValue> {
        to_js(&ProgressReport::new(self.solving.problem(), &self.solving.progress()))
    }

    /// The answer; of a run that is stopped here, with the best plan found.
    pub fn outcome(&mut self) -> Result<OutcomeJs, JsValue> {
        let outcome = self.solving.outcome().map_err(|e| error::solve(&e))?;
        let mut report = SolveReport::new(self.solving.problem(), &outcome);
        report.stats.seconds = Some(self.milliseconds / 1000.0);
        let report = if self.old_names { report.with_old_names() } else { report };
        to_js(&report)
    }
}

/// The search for remedies at work.
#[cfg(feature = "full")]
#[wasm_bindgen]
#[derive(Debug)]
pub struct RemedyRun {
    run: remedy::RemedyRun,
}

#[cfg(feature = "full")]
#[wasm_bindgen]
impl RemedyRun {
    /// Works for about this many expansions; true when there is an answer.
    pub fn advance(&mut self, budget: u32) -> Result<bool, JsValue> {
        self.run.advance(budget.into()).map_err(|e| error::solve(&e))
    }

    /// How far the work is.
    pub fn progress(&self) -> Result<ProgressJs, JsValue> {
        to_js(&ProgressReport::new(self.run.problem(), &self.run.progress()))
    }

    /// The answer; of a run that is stopped here, with the remedies found.
    pub fn outcome(&mut self) -> Result<AdviceJs, JsValue> {
        let advice = self.run.outcome().map_err(|e| error::solve(&e))?;
        to_js(&AdviceReport::new(self.run.problem(), &advice))
    }
}

/// The seed that belongs to a name.
#[cfg(feature = "full")]
#[wasm_bindgen(js_name = seedOf)]
pub fn seed_of(name: &str) -> f64 {
    // Below a million.
    crate::exercise::seed_of(name) as f64
}

/// The question of a seed of an exercise.
#[cfg(feature = "full")]
#[wasm_bindgen]
#[derive(Debug)]
pub struct Exercise {
    exercise: crate::exercise::Exercise,
    variant: crate::exercise::Variant,
}

#[cfg(feature = "full")]
#[wasm_bindgen]
impl Exercise {
    /// Reads a document with an exercise. Throws a `DocumentError` that names the place, and an `OptionsError` where the
    /// seed is no whole number or has no variant.
    #[wasm_bindgen(constructor)]
    pub fn new(document: &str, seed: f64) -> Result<Exercise, JsValue> {
        let exercise = crate::exercise::Exercise::parse(document);
        let exercise = exercise.map_err(|e| error::document(&e, document))?;
        let whole = (0.0..=9_007_199_254_740_991.0).contains(&seed) && seed % 1.0 == 0.0;
        if !whole {
            return Err(thrown(
                "OptionsError",
                &format!("seed: found {seed}, expected a whole number from 0"),
            ));
        }
        let variant = exercise.variant(seed as u64).map_err(|e| error::options(&e))?;
        Ok(Self { exercise, variant })
    }

    /// The question, without a solution.
    pub fn question(&self) -> Result<types::QuestionJs, JsValue> {
        to_js(&crate::report::ExerciseReport::new(&self.exercise, &self.variant))
    }

    /// The question with a right answer, for the author of the exercise.
    pub fn solution(&self) -> Result<types::QuestionJs, JsValue> {
        let report = crate::report::ExerciseReport::new(&self.exercise, &self.variant);
        to_js(&report.with_solution(&self.variant))
    }

    /// Draws the variants of a few seeds, for the author of the exercise: whether students will have questions, and
    /// questions of their own; null where nothing varies. `text` is the document that was read. Throws a `DocumentError` at
    /// `exercise.vary` where most of the seeds have no variant.
    pub fn sample(&self, text: &str) -> Result<types::VariantSampleJs, JsValue> {
        let sample = self.exercise.sample().map_err(|e| error::document(&e, text))?;
        to_js(&sample.as_ref().map(crate::report::SampleReport::new))
    }

    /// Checks an answer, by the positions of its choices. Throws an `OptionsError` where they do not fit the question.
    pub fn check(
        &self,
        choices: Vec<u32>,
        attempts: u32,
        hints: u32,
    ) -> Result<types::VerdictJs, JsValue> {
        let answer = self.variant.form().answer(choices);
        let answer =
            answer.ok_or_else(|| thrown("OptionsError", "the choices do not fit the question"))?;
        let tally = crate::exercise::Tally { attempts, hints };
        to_js(&crate::report::VerdictReport::new(&self.exercise, &self.variant, &answer, tally))
    }

    /// The document of this variant as JSON text: its problem, and its question as an exercise that does not vary. `text`
    /// is the document that was read.
    pub fn document(&self, text: &str) -> String {
        self.exercise.written(&self.variant, text).to_string()
    }
}
