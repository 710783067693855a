//! Exercises: blocks of documents, answers and feedback, variants, codes.

mod blocks;
mod codes;
mod feedback;
mod lesson;
pub mod seeds;
mod variants;
mod variants_with_beliefs;
mod words;

use mo_copp::exercise::{Exercise, Variant, Verdict};

/// The text of an exercise of the project.
pub fn text(name: &str) -> String {
    let path = format!("{}/examples/exercises/{name}.json", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(path).unwrap()
}

/// An exercise of the project.
pub fn exercise(name: &str) -> Exercise {
    Exercise::parse(&text(name)).unwrap()
}

/// What is said of an answer.
pub fn verdict(variant: &Variant, answer: &str) -> Verdict {
    variant.check(&variant.form().read(answer).unwrap())
}
