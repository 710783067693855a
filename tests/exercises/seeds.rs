//! What up to a thousand seeds of an exercise come to, as a number: the same natively and in wasm.

use mo_copp::exercise::Exercise;

/// Exercises of each kind, and the number of their seeds: fewer where many draws are looked at for each.
pub const EXERCISES: [(&str, &str, u64); 9] = [
    ("possible-goals", include_str!("../../examples/exercises/01-possible-goals.json"), 1000),
    ("belief", include_str!("../../examples/exercises/02-belief.json"), 1000),
    ("guess", include_str!("../../examples/exercises/03-guess.json"), 1000),
    ("placement", include_str!("../../examples/exercises/06-camera.json"), 1000),
    ("placement of a wall", include_str!("../../examples/exercises/07-wall.json"), 50),
    ("placement of a start", include_str!("../../examples/exercises/05-start.json"), 1000),
    ("walk", include_str!("../../examples/exercises/09-walk-difference.json"), 1000),
    ("walk of few steps", include_str!("../../examples/exercises/04-walk-length.json"), 1000),
    ("best", include_str!("../../examples/exercises/12-best.json"), 1000),
];

/// Draws the seeds from 1 to `most` and checks the answer of each; a hash (FNV-1a) of all documents, questions and answers.
pub fn hash(text: &str, most: u64) -> u64 {
    let exercise = Exercise::parse(text).unwrap();
    let base = exercise.original().difficulty();
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    for seed in 1..=most {
        let variant = exercise.variant(seed).unwrap();
        assert_eq!(variant.seed(), seed);
        assert!(variant.remarks().is_empty(), "seed {seed}: {:?}", variant.remarks());
        assert!(variant.check(variant.solution()).right, "seed {seed}");
        let found = variant.difficulty();
        assert!(base.size.abs_diff(found.size) <= (base.size / 2).max(1), "seed {seed}: {found:?}");
        assert!(base.steps.abs_diff(found.steps) <= 2, "seed {seed}: {found:?}");
        let answer = variant.form().to_json(variant.solution());
        let told = format!("{}{}{answer}", variant.document().to_json(), variant.question());
        for byte in told.bytes() {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
    hash
}
