//! Answer codes: round trips, and changed codes, none of which is accepted.

use mo_copp::exercise::{CodeError, Exercise, Tally};
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg32;

use super::{exercise, text};

/// Exercises of every kind.
const NAMES: [&str; 6] =
    ["01-possible-goals", "02-belief", "03-guess", "06-camera", "10-walk-both", "12-best"];

fn below(random: &mut impl Rng, count: usize) -> usize {
    random.random_range(0..count as u32) as usize
}

#[test]
fn codes_come_back_with_answer_seed_and_tally() {
    for name in NAMES {
        let exercise = exercise(name);
        for seed in [0, 1, 7, 99] {
            let variant = exercise.variant(seed).unwrap();
            let tally = Tally { attempts: 3, hints: 1 };
            let code = exercise.code(&variant, variant.solution(), tally);
            assert!(code.len() <= 80, "{code}");
            for written in
                [code.clone(), code.to_lowercase(), code.replace('-', " "), format!(" {code}\n")]
            {
                let graded = exercise.grade(&written, Some(seed)).unwrap();
                assert!(graded.verdict.right);
                assert_eq!(graded.verdict.score(), 1);
                assert_eq!((graded.variant.seed(), graded.tally), (seed, tally));
                assert_eq!(&graded.answer, variant.solution());
            }
        }
    }
}

#[test]
fn a_wrong_answer_comes_back_as_wrong_with_its_reason() {
    let exercise = exercise("01-possible-goals");
    let variant = exercise.original();
    let answer = variant.form().read("G4").unwrap();
    let code = exercise.code(variant, &answer, Tally { attempts: 1, hints: 0 });
    let graded = exercise.grade(&code, None).unwrap();
    assert_eq!(graded.verdict.score(), 0);
    assert!(
        graded.verdict.reason().contains("is possible for the enemy"),
        "{}",
        graded.verdict.reason()
    );
}

#[test]
fn ten_thousand_changed_codes_are_all_found() {
    let mut random = Pcg32::seed_from_u64(14);
    let signs: Vec<char> = "0123456789ABCDEFGHJKMNPQRSTVWXYZ".chars().collect();
    let mut changed = 0;
    let exercises: Vec<Exercise> = NAMES.iter().map(|name| exercise(name)).collect();
    let mut codes = Vec::new();
    for exercise in &exercises {
        for seed in 0..5 {
            let variant = exercise.variant(seed).unwrap();
            let tally = Tally { attempts: 1, hints: 0 };
            let code = exercise.code(&variant, variant.solution(), tally).replace('-', "");
            codes.push((exercise, code));
        }
    }
    while changed < 10_000 {
        let (exercise, code) = &codes[below(&mut random, codes.len())];
        let mut other: Vec<char> = code.chars().collect();
        for _ in 0..=below(&mut random, 3) {
            let place = below(&mut random, other.len());
            match below(&mut random, 4) {
                0 => other[place] = signs[below(&mut random, signs.len())],
                1 => other.insert(place, signs[below(&mut random, signs.len())]),
                2 => drop(other.remove(place)),
                _ => {
                    let second = below(&mut random, other.len());
                    other.swap(place, second);
                }
            }
        }
        let other: String = other.into_iter().collect();
        if other == *code {
            continue;
        }
        changed += 1;
        let found = exercise.grade(&other, None);
        assert!(
            matches!(found, Err(CodeError::Edited | CodeError::NoCode)),
            "{code} as {other}: {found:?}"
        );
    }
}

#[test]
fn codes_of_other_exercises_and_seeds_are_found() {
    let (one, other) = (exercise("01-possible-goals"), exercise("06-camera"));
    let variant = one.variant(7).unwrap();
    let code = one.code(&variant, variant.solution(), Tally::default());
    assert_eq!(other.grade(&code, None).unwrap_err(), CodeError::OtherExercise);
    assert_eq!(
        one.grade(&code, Some(8)).unwrap_err(),
        CodeError::OtherSeed { found: 7, expected: 8 }
    );
    // The same exercise with another word around it is the same; with another wall it is not.
    let whole = text("01-possible-goals");
    let retold = Exercise::parse(&whole.replace("Two axes", "Axes")).unwrap();
    assert!(retold.grade(&code, None).unwrap().verdict.right);
    let rebuilt = Exercise::parse(&whole.replace("[[2, 2]]", "[[2, 1]]")).unwrap();
    assert_eq!(rebuilt.grade(&code, None).unwrap_err(), CodeError::OtherExercise);
}

#[test]
fn what_is_no_code_is_refused_without_harm() {
    let exercise = exercise("03-guess");
    for text in
        ["", "-", "hello", "0", "ZZZZZ-ZZZZZ-ZZZZZ", "G1", &"0".repeat(100_000), "ü", "U2U2U"]
    {
        let found = exercise.grade(text, None);
        assert!(matches!(found, Err(CodeError::NoCode | CodeError::Edited)), "{text}: {found:?}");
    }
}
