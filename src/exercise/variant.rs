//! Variants: the same question with other numbers, drawn by a seed and checked.

use std::sync::Arc;

use rand::{Rng, SeedableRng};
use rand_pcg::Pcg32;
use sha2::{Digest as _, Sha256};

use super::answer::{Answer, Form};
use super::block::{Block, Vary};
use super::dice::below;
use super::drawn_cells::{draw_cells, free_cells};
use super::edit::Draft;
use super::kind::{Kind, Solved};
use super::subject::Subject;
use super::verdict::Verdict;
use super::walks::{walk_of, walk_to_goal};
use super::{Difficulty, ExerciseError, Unfit};
use crate::document::{DocumentError, plain_name};
use crate::domain::Document;
use crate::domain::grid::Cell;
use crate::problem::Problem;

/// How many variants are drawn for a seed that an author's check looks at.
pub(super) const MAX_TRIES: u32 = 500;

/// How many are drawn for a student before there is none: where each seed of the check had one, as good as none is without.
const PATIENT_TRIES: u32 = 10 * MAX_TRIES;

/// Seeds of names are below this, so that they can be read out.
const MOST_SEEDS: u64 = 1_000_000;

/// The question of a seed, with a right answer to it.
#[derive(Debug, Clone)]
pub struct Variant {
    seed: u64,
    subject: Subject,
    kind: Kind,
    form: Form,
    solved: Solved,
}

impl Variant {
    /// Asks a question of a problem, and finds a right answer.
    pub(super) fn new(seed: u64, subject: Subject, kind: Kind) -> Result<Self, Unfit> {
        let form = kind.question().form(&subject)?;
        let solved = kind.question().solve(&subject, &form)?;
        // The answer was found by one way, and is checked by another.
        if !kind.question().check(&subject, &solved.answer).right {
            return Err(Unfit::new("the answer that was found does not pass its check"));
        }
        Ok(Self { seed, subject, kind, form, solved })
    }

    /// The seed.
    pub fn seed(&self) -> u64 {
        self.seed
    }

    /// The document of the problem, without the exercise.
    pub fn document(&self) -> &Document {
        &self.subject.document
    }

    /// The problem.
    pub fn problem(&self) -> &Arc<Problem> {
        &self.subject.problem
    }

    /// The document as it is asked about. Where the true goal is to be guessed, the first candidate stands in its place.
    pub fn asked_document(&self) -> Document {
        let document = self.document();
        let Kind::Guess(_) = &self.kind else { return document.clone() };
        let mut draft = Draft::new(document);
        draft.set_true_goal(&self.subject.problem.goals()[0].name);
        // A candidate of the document can always be its true goal.
        draft.finish().unwrap_or_else(|_| document.clone())
    }

    /// The question in words.
    pub fn question(&self) -> String {
        self.kind.question().text(&self.subject)
    }

    /// What an answer is made of.
    pub fn form(&self) -> &Form {
        &self.form
    }

    /// The walk that the question tells; none where the answer is a walk, or the walk is kept back.
    pub fn plan(&self) -> Option<&[String]> {
        match &self.kind {
            Kind::Guess(_) => None,
            kind => kind.watching().map(|watching| &watching.plan[..]),
        }
    }

    /// The walk that the question is about, told or not.
    pub(super) fn walk(&self) -> Option<&[String]> {
        self.kind.watching().map(|watching| &watching.plan[..])
    }

    /// The observer that the question is about.
    pub fn observer(&self) -> Option<&str> {
        self.kind.watching().map(|watching| &watching.observer[..])
    }

    /// What is placed: `camera`, `wall` or `start`.
    pub fn placed(&self) -> Option<&'static str> {
        self.kind.placed()
    }

    /// A right answer.
    pub fn solution(&self) -> &Answer {
        &self.solved.answer
    }

    /// How hard the question is.
    pub fn difficulty(&self) -> Difficulty {
        self.solved.difficulty
    }

    /// What makes the question trivial: of a variant that was drawn, nothing.
    pub fn remarks(&self) -> &[String] {
        &self.solved.remarks
    }

    /// How often the states of the problem are passed, about, until the question has an answer.
    pub(super) fn passes(&self) -> u64 {
        self.kind.question().passes(&self.subject)
    }

    /// What is said of an answer.
    pub fn check(&self, answer: &Answer) -> Verdict {
        self.kind.question().check(&self.subject, answer)
    }
}

/// The seed of a name, for a variant that belongs to a person: the same wherever the name looks the same. How many blanks
/// stand around its words, and whether a letter and its accent are one sign or two, makes no difference; capitals do.
pub fn seed_of(name: &str) -> u64 {
    let bytes = Sha256::digest(plain_name(name).as_bytes());
    let number = bytes.iter().take(8).fold(0_u64, |number, &byte| number << 8 | u64::from(byte));
    1 + number % (MOST_SEEDS - 1)
}

/// What varies must be there to vary.
pub(super) fn check_vary(block: &Block, document: &Document) -> Result<(), DocumentError> {
    let draft = Draft::new(document);
    for (index, vary) in block.vary.iter().enumerate() {
        let there = match vary {
            Vary::Start => draft.start().is_some(),
            Vary::Goals => !draft.goals().is_empty(),
            Vary::Walls => !draft.walls().is_empty(),
            Vary::TrueGoal => true,
            Vary::Plan => block.kind.watching().is_some(),
        };
        if !there {
            let found = format!("{} in an exercise of the kind {}", vary.name(), block.kind.name());
            let expected =
                format!("something that a {} document has and the question needs", draft.format());
            return Err(DocumentError::invalid(format!("exercise.vary[{index}]"), found, expected));
        }
        let is_other = |cell: &Cell| draft.start() != Some(*cell);
        let varies = |vary: Vary| block.vary.contains(&vary);
        if *vary == Vary::Start && !free_cells(&draft, &varies).iter().any(is_other) {
            let path = format!("exercise.vary[{index}]");
            let found = "start, where no other cell is free";
            let expected =
                "a cell without a wall, a goal, a box, a can or a charger for another start";
            return Err(DocumentError::invalid(path, found, expected));
        }
    }
    check_answers_vary(block)
}

/// The true goal alone makes no other question where the question does not depend on it, or its walk ends where it did.
fn check_answers_vary(block: &Block) -> Result<(), DocumentError> {
    let varies = |vary: Vary| block.vary.contains(&vary);
    let (only, missing) = match block.kind {
        Kind::Walk(_) | Kind::Best(_) => return Ok(()),
        Kind::Guess(_) => {
            let moved = varies(Vary::Plan) || varies(Vary::Start) || varies(Vary::Goals);
            (!moved, "plan too, since the walk of a guess ends in the true goal")
        }
        _ => (block.vary.len() == 1, "something else too, since the answer does not depend on it"),
    };
    if !only || !varies(Vary::TrueGoal) {
        return Ok(());
    }
    let found = format!("true_goal in an exercise of the kind {}", block.kind.name());
    Err(DocumentError::invalid("exercise.vary", found, missing))
}

/// Draws the variant of a seed.
pub(super) fn draw(block: &Block, original: &Variant, seed: u64) -> Result<Variant, ExerciseError> {
    if seed == 0 || block.vary.is_empty() {
        return Ok(Variant { seed, ..original.clone() });
    }
    let (variant, tries) = draw_within(block, original, seed, PATIENT_TRIES);
    variant.ok_or(ExerciseError::NoVariant { seed, tries })
}

/// Draws the variant of a seed from its first draws, and says how many it took.
pub(super) fn draw_within(
    block: &Block,
    original: &Variant,
    seed: u64,
    tries: u32,
) -> (Option<Variant>, u32) {
    let mut random = Pcg32::seed_from_u64(seed);
    for drawn_before in 0..tries {
        let Some((subject, kind)) = drawn(block, original, &mut random) else { continue };
        let Ok(variant) = Variant::new(seed, subject, kind) else { continue };
        if variant.solved.remarks.is_empty()
            && original.difficulty().is_near(variant.solved.difficulty)
        {
            return (Some(variant), drawn_before + 1);
        }
    }
    (None, tries)
}

/// A question with other numbers; none where they make no problem.
fn drawn(block: &Block, original: &Variant, random: &mut impl Rng) -> Option<(Subject, Kind)> {
    let varies = |vary: Vary| block.vary.contains(&vary);
    let mut draft = Draft::new(&original.subject.document);
    if varies(Vary::Start) || varies(Vary::Goals) || varies(Vary::Walls) {
        draw_cells(&mut draft, &varies, random)?;
    }
    if varies(Vary::TrueGoal) {
        let names: Vec<&str> = original.subject.goal_names().collect();
        draft.set_true_goal(names[below(random, names.len())?]);
    }
    let document = draft.finish().ok()?;
    let problem = Arc::new(document.problem().ok()?);
    let kind = match block.kind.watching() {
        None => block.kind.clone(),
        Some(watching) => {
            let plan = if !varies(Vary::Plan) {
                watching.plan.clone()
            } else if matches!(block.kind, Kind::Guess(_)) {
                walk_to_goal(&problem, random)?
            } else {
                walk_of(&problem, watching.plan.len(), random)?
            };
            block.kind.with_plan(plan)
        }
    };
    Some((Subject { document, problem }, kind))
}
