//! A sample of variants: of a few seeds, how many have a variant, and how many of these variants differ.

use std::collections::BTreeSet;

use super::block::{Block, Vary};
use super::edit::Draft;
use super::variant::{MAX_TRIES, Variant, draw_within};
use super::walks::explored;
use crate::document::DocumentError;

/// How many seeds are drawn, where that is quick.
const SEEDS: u32 = 20;

/// How many questions are drawn at most: those of four seeds without a variant.
const MOST_DRAWS: u64 = 4 * MAX_TRIES as u64;

/// What the draws may cost, in states that are passed: a second or two in a browser.
const MOST_EFFORT: u64 = 8_000_000;

/// By how much more they may cost while no variant has been found.
const PATIENCE: u64 = 5;

/// Fewer different questions are few.
const FEW: u32 = 5;

/// What a few seeds of an exercise come to.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct VariantSample {
    /// How many seeds were drawn: 20, or fewer where drawing takes long.
    pub seeds: u32,
    /// How many of them have a variant.
    pub found: u32,
    /// How many different questions those variants ask, as a student sees them.
    pub different: u32,
    /// How many different answers were found to them.
    pub answers: u32,
    /// How many questions were drawn for all that.
    pub draws: u32,
    /// What was to vary and is the same in all those variants, of which there are two at least: the rest of the question
    /// ties it down.
    pub tied: Vec<Vary>,
}

impl VariantSample {
    /// Draws the variants of the first seeds.
    pub(super) fn new(block: &Block, original: &Variant) -> Self {
        let most = |effort| most_draws(original, effort);
        Self::within(block, original, most(MOST_EFFORT), most(PATIENCE * MOST_EFFORT))
    }

    /// With at most `most` draws, or `patient` ones while no variant has been found.
    fn within(block: &Block, original: &Variant, most: u32, patient: u32) -> Self {
        let mut sample =
            Self { seeds: 0, found: 0, different: 0, answers: 0, draws: 0, tied: vec![] };
        let (mut questions, mut answers) = (BTreeSet::new(), BTreeSet::new());
        let mut values: Vec<BTreeSet<String>> = vec![BTreeSet::new(); block.vary.len()];
        for seed in 1..=u64::from(SEEDS) {
            let most = if sample.found == 0 { patient } else { most };
            let tries = MAX_TRIES.min(most.saturating_sub(sample.draws));
            let (variant, drawn) = draw_within(block, original, seed, tries);
            sample.draws += drawn;
            match variant {
                Some(variant) => {
                    sample.found += 1;
                    questions.insert(asked(&variant));
                    answers.insert(variant.form().to_json(variant.solution()).to_string());
                    for (values, vary) in values.iter_mut().zip(&block.vary) {
                        values.insert(value(&variant, *vary));
                    }
                }
                // Nothing is known of a seed that was not drawn to its end.
                None if drawn < MAX_TRIES => break,
                None => {}
            }
            sample.seeds += 1;
        }
        (sample.different, sample.answers) = (questions.len() as u32, answers.len() as u32);
        if sample.found > 1 {
            let tied = block.vary.iter().zip(&values).filter(|(_, values)| values.len() == 1);
            sample.tied = tied.map(|(vary, _)| *vary).collect();
        }
        sample
    }

    /// What an author should know before the exercise is handed out; nothing where each seed has a question of its own.
    pub fn remarks(&self) -> Vec<String> {
        let Self { seeds, found, different, answers, draws, ref tied } = *self;
        let mut remarks = Vec::new();
        if seeds == 0 {
            remarks.push(format!(
                "no variant was found in {draws} draws, and a seed has {MAX_TRIES}: some seeds may have none"
            ));
        }
        if found > 1 && different == 1 {
            remarks.push(format!("all {found} variants drawn ask the same question"));
        } else if different < FEW.min(found) {
            remarks.push(format!(
                "the {found} variants drawn ask only {different} different questions"
            ));
        }
        if different > 1 && answers == 1 {
            remarks.push(format!("all {found} variants drawn have the same answer"));
        }
        // Where all are one question, that says it.
        for vary in tied.iter().filter(|_| different > 1) {
            remarks.push(format!(
                "{} is the same in all {found} variants drawn: the rest of the question leaves no other",
                vary.name()
            ));
        }
        remarks
    }

    /// Refuses an exercise of which a seed has no variant: some student would get no question.
    pub(super) fn check(&self, vary: &[Vary]) -> Result<(), DocumentError> {
        let Self { seeds, found, .. } = *self;
        if found == seeds {
            return Ok(());
        }
        let names: Vec<&str> = vary.iter().map(|vary| vary.name()).collect();
        let names = names.join(", ");
        let found = match found {
            0 if seeds == 1 => format!("{names}, where the one seed drawn has no variant"),
            0 => format!("{names}, where none of {seeds} seeds drawn has a variant"),
            1 => format!("{names}, where 1 of {seeds} seeds drawn has a variant"),
            _ => format!("{names}, where {found} of {seeds} seeds drawn have a variant"),
        };
        let expected = "something to vary that gives each seed a question about as hard as the original, with an answer";
        Err(DocumentError::invalid("exercise.vary", found, expected))
    }
}

/// How many questions are drawn, by what each costs. Time is not measured: a sample is the same everywhere.
fn most_draws(original: &Variant, effort: u64) -> u32 {
    let states = explored(original.problem()).map_or(u64::MAX, |space| space.len() as u64);
    let each = states.saturating_mul(original.passes()).max(1);
    MOST_DRAWS.min(effort / each).max(1) as u32
}

/// What a variant has of something that varies.
fn value(variant: &Variant, vary: Vary) -> String {
    let draft = Draft::new(variant.document());
    match vary {
        Vary::Start => draft.start_state().to_string(),
        Vary::Goals => format!("{:?}", draft.goals()),
        Vary::Walls => format!("{:?}", BTreeSet::from_iter(draft.walls())),
        Vary::TrueGoal => variant.problem().goals()[variant.problem().true_goal()].name.clone(),
        Vary::Plan => variant.walk().unwrap_or_default().join(", "),
    }
}

/// What a student sees: the problem and the question. Where the true goal belongs to the question, its text names it.
fn asked(variant: &Variant) -> String {
    // Only texts, numbers and lists: writing them cannot fail.
    let mut document = serde_json::to_value(variant.document()).unwrap_or_default();
    if let Some(keys) = document.as_object_mut() {
        keys.remove("true_goal");
    }
    format!("{document} {}", variant.question())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(seeds: u32, found: u32, different: u32, answers: u32) -> VariantSample {
        VariantSample { seeds, found, different, answers, draws: 100, tied: Vec::new() }
    }

    #[test]
    fn what_an_author_should_know_is_said() {
        let said = |seeds, found, different, answers| {
            sample(seeds, found, different, answers).remarks().join("; ")
        };
        assert_eq!(said(20, 20, 20, 6), "");
        assert_eq!(said(20, 20, 5, 5), "");
        assert_eq!(said(20, 20, 1, 1), "all 20 variants drawn ask the same question");
        assert_eq!(said(20, 20, 3, 2), "the 20 variants drawn ask only 3 different questions");
        assert_eq!(said(20, 20, 20, 1), "all 20 variants drawn have the same answer");
        let tied = VariantSample { tied: vec![Vary::Start], ..sample(20, 20, 20, 6) };
        assert_eq!(
            tied.remarks(),
            [
                "start is the same in all 20 variants drawn: the rest of the question leaves no other"
            ]
        );
        assert_eq!(said(3, 3, 3, 3), "");
        assert_eq!(said(1, 1, 1, 1), "");
        assert_eq!(
            said(0, 0, 0, 0),
            "no variant was found in 100 draws, and a seed has 500: some seeds may have none"
        );
    }

    #[test]
    fn an_exercise_of_which_a_seed_has_no_variant_is_refused() {
        let vary = [Vary::Start, Vary::Plan];
        let said = |seeds, found| {
            let refused = sample(seeds, found, found, found).check(&vary);
            refused.err().map(|error| error.to_string()).unwrap_or_default()
        };
        assert_eq!(said(20, 20), "");
        assert_eq!(said(0, 0), "");
        assert_eq!(said(1, 1), "");
        assert_eq!(
            said(20, 19),
            "exercise.vary: found start, plan, where 19 of 20 seeds drawn have a variant, \
             expected something to vary that gives each seed a question about as hard as the original, with an answer"
        );
        assert!(said(4, 0).contains("start, plan, where none of 4 seeds drawn has a variant,"));
        assert!(said(1, 0).contains("where the one seed drawn has no variant,"));
        assert!(said(4, 1).contains("where 1 of 4 seeds drawn has a variant,"));
    }
}
