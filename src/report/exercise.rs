//! Exercises for other programs: the question of a seed, and what is said of an answer.

use serde::Serialize;
use serde_json::Value;

use crate::domain::Document;
use crate::exercise::{
    Answer, Counterexample, Difficulty, Exercise, Finding, Form, Hidden, Lock, Tally, Variant,
    VariantSample, Verdict,
};

/// The question of a seed: `exercise show --json`.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ExerciseReport {
    /// The name of the kind.
    pub kind: &'static str,
    /// The name of the exercise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// What the author says before the question.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub introduction: Option<String>,
    /// The question in words.
    pub question: String,
    /// The seed.
    pub seed: u64,
    /// Whether other seeds have other questions.
    pub varies: bool,
    /// What an answer is made of.
    pub form: Form,
    /// The observer that the question is about.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub observer: Option<String>,
    /// The walk that the question tells.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub plan: Option<Vec<String>>,
    /// What is placed: `camera`, `wall` or `start`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub place: Option<&'static str>,
    /// Hints, one after another.
    pub hints: Vec<String>,
    /// How many answers may be tried.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub attempts: Option<u32>,
    /// What is not shown.
    pub hide: Vec<Hidden>,
    /// Whether the problem stays as it is while the question stands.
    pub lock: Lock,
    /// The document of the problem, without the exercise; of a `guess` without a solution its true goal is the first candidate,
    /// whichever it is.
    pub document: Document,
    /// A right answer, where it is asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub solution: Option<SolutionReport>,
    /// What a few seeds come to, where that is asked for and something varies.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sample: Option<SampleReport>,
}

/// What a few seeds of an exercise come to: how many have a variant, and how many of these variants differ.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct SampleReport {
    /// How many seeds were drawn.
    pub seeds: u32,
    /// How many of them have a variant.
    pub found: u32,
    /// How many different questions those ask.
    pub different: u32,
    /// How many different answers were found to them.
    pub answers: u32,
    /// What an author should know before the exercise is handed out.
    pub remarks: Vec<String>,
}

/// A right answer, and how hard the question is.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct SolutionReport {
    /// The answer.
    pub answer: Value,
    /// What its size counts stands at [`Difficulty::size`].
    pub size: usize,
    /// The steps of the walk.
    pub steps: usize,
    /// What makes the question trivial.
    pub remarks: Vec<String>,
}

/// What is said of an answer: `exercise check --json`.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct VerdictReport {
    /// Whether the answer is right.
    pub right: bool,
    /// 1 or 0.
    pub score: u8,
    /// What is wrong with it, the first thing first.
    pub findings: Vec<FindingReport>,
    /// The code of the answer.
    pub code: String,
}

/// Something that is wrong with an answer.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct FindingReport {
    /// What it is.
    pub text: String,
    /// A walk that shows it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub counterexample: Option<Counterexample>,
}

impl ExerciseReport {
    /// The report of a variant, without a solution.
    pub fn new(exercise: &Exercise, variant: &Variant) -> Self {
        Self {
            kind: exercise.kind(),
            title: exercise.title().map(str::to_owned),
            introduction: exercise.introduction().map(str::to_owned),
            question: variant.question(),
            seed: variant.seed(),
            varies: !exercise.vary().is_empty(),
            form: variant.form().clone(),
            observer: variant.observer().map(str::to_owned),
            plan: variant.plan().map(<[String]>::to_vec),
            place: variant.placed(),
            hints: exercise.hints().to_vec(),
            attempts: exercise.attempts(),
            hide: exercise.hidden(),
            lock: exercise.lock().clone(),
            document: variant.asked_document(),
            solution: None,
            sample: None,
        }
    }

    /// The same with what a few seeds come to.
    #[must_use]
    pub fn with_sample(mut self, sample: Option<&VariantSample>) -> Self {
        self.sample = sample.map(SampleReport::new);
        self
    }

    /// The same with a right answer.
    #[must_use]
    pub fn with_solution(mut self, variant: &Variant) -> Self {
        let Difficulty { size, steps, .. } = variant.difficulty();
        self.document = variant.document().clone();
        self.solution = Some(SolutionReport {
            answer: variant.form().to_json(variant.solution()),
            size,
            steps,
            remarks: variant.remarks().to_vec(),
        });
        self
    }
}

impl SampleReport {
    /// The report of a sample.
    pub fn new(sample: &VariantSample) -> Self {
        let VariantSample { seeds, found, different, answers, .. } = *sample;
        Self { seeds, found, different, answers, remarks: sample.remarks() }
    }
}

impl VerdictReport {
    /// Checks an answer and makes its code.
    pub fn new(exercise: &Exercise, variant: &Variant, answer: &Answer, tally: Tally) -> Self {
        let verdict: Verdict = variant.check(answer);
        let finding = |Finding { text, counterexample, .. }: &Finding| FindingReport {
            text: text.clone(),
            counterexample: counterexample.clone(),
        };
        Self {
            right: verdict.right,
            score: verdict.score(),
            findings: verdict.findings.iter().map(finding).collect(),
            code: exercise.code(variant, answer, tally),
        }
    }
}
