//! Exercises: questions about a problem, with variants by seed, checked answers and codes of answers.
//!
//! A document may hold a block `exercise` beside its problem: a question of one of six kinds, and how it is to be asked.
//!
//! | kind | asks for | an answer is |
//! |---|---|---|
//! | `possible-goals` | the goals that survive in an observer's belief after a walk | a set of goals |
//! | `belief` | the states of that belief | a set of states |
//! | `walk` | a walk to the true goal with a goal difference of at least x, or of at most n steps | actions |
//! | `best` | a walk with the best goal difference | actions |
//! | `placement` | a camera, a wall or a start with which a goal is possible after a walk, or not | a cell |
//! | `guess` | the true goal, from what an observer is told of a walk | a goal |
//!
//! A [`Variant`] is the question of a seed, the same everywhere; seed 0 is the document's own. An answer is checked by the
//! definitions alone, and what is wrong with it is shown by a walk ([`Verdict`]). An answer code ([`code`](mod@code)) holds
//! seed and answer, and nothing in it is trusted but those: grading checks the answer again.

mod answer;
mod belief_layers;
mod block;
pub mod code;
mod dice;
mod drawn_cells;
mod edit;
mod initial_belief;
mod kind;
#[cfg(not(target_arch = "wasm32"))]
pub mod schema;
mod subject;
mod variant;
mod variant_sample;
mod verdict;
mod walks;
mod words;

use std::collections::BTreeMap;
use std::sync::Arc;

use thiserror::Error;

pub use answer::{Answer, Arity, Form, MAX_ANSWER, MAX_CHOICES};
pub use block::{Hidden, Lock, Vary};
pub use code::{CodeError, Tally};
pub use variant::{Variant, seed_of};
pub use variant_sample::VariantSample;
pub use verdict::{Counterexample, Finding, Verdict};

use crate::document::DocumentError;
use crate::domain::{Document, EXERCISE};
use block::Block;
use kind::Kind;
use subject::Subject;

/// How many variants are kept while codes are graded: those of a course, in bounded memory.
const MOST_DRAWN: usize = 256;

/// Why there is no exercise, or no variant of it.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ExerciseError {
    /// The document is wrong, or its exercise is.
    #[error("{0}")]
    Document(#[from] DocumentError),
    /// Nothing that was drawn for a seed is as hard as the original and no more trivial.
    #[error(
        "seed {seed}: none of {tries} variants drawn has an answer and the difficulty of the original; another seed may have one"
    )]
    NoVariant {
        /// The seed.
        seed: u64,
        /// How many were drawn.
        tries: u32,
    },
}

/// Why a question cannot be asked of a problem.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{0}")]
struct Unfit(String);

impl Unfit {
    fn new(reason: impl Into<String>) -> Self {
        Self(reason.into())
    }

    fn too_large() -> Self {
        Self::new("the problem is too large for an exercise")
    }
}

/// How hard a question is, by two numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct Difficulty {
    /// `possible-goals`, `belief`: the size of the answer. `walk`, `best`: how many steps more than a shortest walk the
    /// shortest right answer has. `placement`: how many cells are right. `guess`: how many other goals are in reach.
    pub size: usize,
    /// The steps of the walk that is asked about or for.
    pub steps: usize,
}

impl Difficulty {
    /// Whether another question is about as hard: its size within 1 or a half, its steps within 2.
    fn is_near(self, other: Self) -> bool {
        self.size.abs_diff(other.size) <= (self.size / 2).max(1)
            && self.steps.abs_diff(other.steps) <= 2
    }
}

/// An exercise: a document with a question.
#[derive(Debug, Clone)]
pub struct Exercise {
    block: Block,
    original: Variant,
    digest: code::Digest,
}

impl Exercise {
    /// Reads a document with a block `exercise`, and finds a right answer to its question.
    ///
    /// # Errors
    ///
    /// [`DocumentError`] with the place, where the document is wrong, has no exercise, or one that cannot be asked of its
    /// problem: without an answer, too large for one, or with variants though it is trivial itself.
    ///
    /// ```
    /// use mo_copp::exercise::Exercise;
    /// let text = std::fs::read_to_string("examples/exercises/01-possible-goals.json")?;
    /// let exercise = Exercise::parse(&text)?;
    /// let variant = exercise.variant(7)?;
    /// assert!(variant.check(variant.solution()).right);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn parse(text: &str) -> Result<Self, DocumentError> {
        let document = Document::parse(text)?;
        let problem = Arc::new(document.problem()?);
        let missing =
            || DocumentError::invalid("exercise", "nothing", "an exercise, an object with a kind");
        let block = Block::read(text)?.ok_or_else(missing)?;
        block.kind.refer(&problem)?;
        variant::check_vary(&block, &document)?;
        let open = matches!(block.kind, Kind::Guess(_)) || block.vary.contains(&Vary::TrueGoal);
        if open && matches!(&document, Document::Pddl(pddl) if pddl.tells_goal()) {
            let expected = "no :goal, where the true goal is to be guessed or varies";
            return Err(DocumentError::invalid("problem", "the :goal of the true goal", expected));
        }
        let digest = code::Digest::new(&document, &block);
        let unfit = |reason: String| {
            DocumentError::invalid("exercise", reason, "a question with an answer")
        };
        let subject = Subject { document, problem };
        let original = Variant::new(0, subject, block.kind.clone())
            .map_err(|error| unfit(error.to_string()))?;
        if let (Some(remark), false) = (original.remarks().first(), block.vary.is_empty()) {
            let expected = "a question that is not trivial, since variants are to be like it";
            return Err(DocumentError::invalid(
                "exercise.vary",
                format!("a question of which {remark}"),
                expected,
            ));
        }
        Ok(Self { block, original, digest })
    }

    /// Whether the text of a document has a block `exercise`, right or wrong.
    pub fn is_in(text: &str) -> bool {
        !matches!(Block::read(text), Ok(None))
    }

    /// The name of the kind.
    pub fn kind(&self) -> &'static str {
        self.block.kind.name()
    }

    /// The name of the exercise, where it has one.
    pub fn title(&self) -> Option<&str> {
        self.block.title.as_deref()
    }

    /// What the author says before the question.
    pub fn introduction(&self) -> Option<&str> {
        self.block.introduction.as_deref()
    }

    /// Hints, one after another.
    pub fn hints(&self) -> &[String] {
        &self.block.hints
    }

    /// How many answers may be tried; any number where nothing is said.
    pub fn attempts(&self) -> Option<u32> {
        self.block.attempts
    }

    /// What is not shown.
    pub fn hidden(&self) -> Vec<Hidden> {
        self.block.hidden()
    }

    /// What of the problem stays as it is.
    pub fn lock(&self) -> &Lock {
        &self.block.lock
    }

    /// What differs from variant to variant.
    pub fn vary(&self) -> &[Vary] {
        &self.block.vary
    }

    /// The question of the document itself.
    pub fn original(&self) -> &Variant {
        &self.original
    }

    /// The question of a seed: the original of seed 0, and of every seed where nothing varies.
    ///
    /// # Errors
    ///
    /// [`ExerciseError::NoVariant`].
    pub fn variant(&self, seed: u64) -> Result<Variant, ExerciseError> {
        variant::draw(&self.block, &self.original, seed)
    }

    /// Draws a few variants, for an author: whether students will have questions, and questions of their own. None where
    /// nothing varies. It takes a second or two at most for problems that a person can survey; to read an exercise and to
    /// draw one variant need none of it.
    ///
    /// # Errors
    ///
    /// [`DocumentError`] at `exercise.vary`, where a seed that was drawn has no variant.
    pub fn sample(&self) -> Result<Option<VariantSample>, DocumentError> {
        if self.block.vary.is_empty() {
            return Ok(None);
        }
        let sample = VariantSample::new(&self.block, &self.original);
        sample.check(&self.block.vary)?;
        Ok(Some(sample))
    }

    /// The document of a variant: its problem, and its question as an exercise that does not vary. `text` is the
    /// document that the exercise was read from, for the words around the question.
    pub fn written(&self, variant: &Variant, text: &str) -> serde_json::Value {
        let mut block = match serde_json::from_str(text) {
            Ok(serde_json::Value::Object(mut keys)) => keys.remove(EXERCISE).unwrap_or_default(),
            _ => serde_json::Value::default(),
        };
        if let Some(keys) = block.as_object_mut() {
            keys.remove("vary");
            if let Some(plan) = variant.walk() {
                keys.insert("plan".to_owned(), plan.into());
            }
        }
        // Only texts, numbers and lists: writing them cannot fail.
        let mut document = serde_json::to_value(variant.document()).unwrap_or_default();
        document[EXERCISE] = block;
        document
    }

    /// The code of an answer to a variant.
    pub fn code(&self, variant: &Variant, answer: &Answer, tally: Tally) -> String {
        code::write(&self.digest, variant.seed(), answer, tally)
    }

    /// Reads the code of an answer, and checks the answer. `seed` is the seed that it must have, where that is known and
    /// something varies.
    ///
    /// # Errors
    ///
    /// [`CodeError`] where the code is none, was edited, or is of another exercise or seed.
    pub fn grade(&self, code: &str, seed: Option<u64>) -> Result<Graded, CodeError> {
        self.grade_with(code, seed, &mut BTreeMap::new())
    }

    /// The same, where variants that were drawn for other codes need not be drawn again: the first 256 of them are kept.
    ///
    /// # Errors
    ///
    /// As [`grade`](Self::grade).
    pub fn grade_with(
        &self,
        code: &str,
        seed: Option<u64>,
        drawn: &mut BTreeMap<u64, Variant>,
    ) -> Result<Graded, CodeError> {
        let seed = seed.filter(|_| !self.block.vary.is_empty());
        let read = code::read(&self.digest, code, seed)?;
        let none = |_| CodeError::NoVariant { seed: read.seed };
        let variant = match drawn.get(&read.seed) {
            Some(known) => known.clone(),
            None => self.variant(read.seed).map_err(none)?,
        };
        if drawn.len() < MOST_DRAWN {
            drawn.entry(read.seed).or_insert_with(|| variant.clone());
        }
        let answer = variant.form().answer(read.choices).ok_or(CodeError::Answer)?;
        let verdict = variant.check(&answer);
        Ok(Graded { variant, answer, verdict, tally: read.tally })
    }
}

/// What grading a code comes to.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Graded {
    /// The question.
    pub variant: Variant,
    /// The answer.
    pub answer: Answer,
    /// What is said of it, by a check made now.
    pub verdict: Verdict,
    /// What the code says of attempts and hints. Nothing proves it.
    pub tally: Tally,
}
