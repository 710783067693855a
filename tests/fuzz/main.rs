//! Fuzz targets: documents, PDDL and plans, with inputs that keep the structure of what they are made from.
//!
//! A binary of our own in place of cargo-fuzz, which takes a nightly compiler and a C++ one: it runs with stable Rust
//! wherever the tests do, and the same seed tries the same inputs. What guides it is not coverage but behaviour: an
//! input that is answered as none was before is kept, and further ones are made from it.
//!
//! `npm test` runs it for a minute; longer, or one input again:
//!
//! ```sh
//! npm run fuzz -- --seconds 3600 --seed 7
//! npm run fuzz -- --target pddl --replay target/fuzz/pddl.input
//! ```
#![cfg(not(target_arch = "wasm32"))]
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic)]

// The integration tests use all of it.
#[allow(dead_code)]
#[path = "../common/dice.rs"]
mod dice;
mod documents;
mod guard;
mod json;
mod lists;
mod pddl;
mod plans;

use std::collections::BTreeSet;
use std::time::{Duration, Instant};

use dice::Dice;
use guard::Guard;

/// What is tried: inputs to begin with, a way to change them, and what reads them.
trait Target {
    fn name(&self) -> &'static str;
    fn seeds(&self) -> Vec<String>;
    /// Another input, made from one and parts of a second.
    fn changed(&self, dice: &mut Dice, input: &str, other: &str) -> String;
    /// Reads the input and works with it; says what came of it, without names and numbers.
    fn behaviour(&self, input: &str) -> String;
}

/// Longer inputs are not kept: the work is in their structure.
const LONGEST: usize = 16_384;

/// Inputs that are kept beside the seeds; the latest replace the oldest.
const MOST_KEPT: usize = 4_096;

struct Arguments {
    seconds: f64,
    seed: u64,
    target: Option<String>,
    replay: Option<String>,
}

fn arguments() -> Arguments {
    // A short run by default: this is also one of the binaries of `cargo test`.
    let mut found = Arguments { seconds: 3.0, seed: 1, target: None, replay: None };
    let mut rest = std::env::args().skip(1);
    while let Some(name) = rest.next() {
        let mut value = || rest.next().unwrap_or_else(|| panic!("{name} needs a value"));
        match name.as_str() {
            "--seconds" => found.seconds = value().parse().expect("--seconds takes a number"),
            "--seed" => found.seed = value().parse().expect("--seed takes a whole number"),
            "--target" => found.target = Some(value()),
            "--replay" => found.replay = Some(value()),
            // Those of the usual test harness.
            _ => {}
        }
    }
    found
}

fn main() {
    let Arguments { seconds, seed, target, replay } = arguments();
    let targets: [&dyn Target; 3] = [&documents::Documents, &pddl::Pddl, &plans::Plans::new()];
    let chosen: Vec<_> = targets
        .into_iter()
        .filter(|one| target.as_deref().is_none_or(|name| name == one.name()))
        .collect();
    assert!(!chosen.is_empty(), "the targets are documents, pddl and plans");
    let guard = Guard::start();
    for one in &chosen {
        if let Some(file) = &replay {
            let input = std::fs::read_to_string(file).expect("the file of --replay");
            println!(
                "{}: {}",
                one.name(),
                guard.watched(one.name(), &input, || one.behaviour(&input))
            );
            continue;
        }
        let time = Duration::from_secs_f64(seconds / chosen.len() as f64);
        fuzz(*one, &guard, seed, time);
    }
}

fn fuzz(target: &dyn Target, guard: &Guard, seed: u64, time: Duration) {
    let mut dice = Dice::new(seed);
    let seeds = target.seeds();
    let mut kept: Vec<String> = Vec::new();
    let mut met = BTreeSet::new();
    let mut next = 0;
    let mut tried = 0_u64;
    for input in &seeds {
        met.insert(guard.watched(target.name(), input, || target.behaviour(input)));
    }
    let begun = Instant::now();
    while begun.elapsed() < time {
        let pick = |dice: &mut Dice| -> String {
            let at = dice.below(seeds.len() + kept.len());
            seeds.get(at).unwrap_or_else(|| &kept[at - seeds.len()]).clone()
        };
        let (mut input, other) = (pick(&mut dice), pick(&mut dice));
        for _ in 0..=dice.below(3) {
            input = target.changed(&mut dice, &input, &other);
        }
        tried += 1;
        let behaviour = guard.watched(target.name(), &input, || target.behaviour(&input));
        if met.insert(behaviour) && input.len() <= LONGEST {
            if kept.len() < MOST_KEPT {
                kept.push(input);
            } else {
                kept[next % MOST_KEPT] = input;
                next += 1;
            }
        }
    }
    println!(
        "fuzz {}: {tried} inputs from seed {seed}, {} kinds of answer, none did harm",
        target.name(),
        met.len()
    );
    // A slow machine tries few in a short time.
    assert!(tried < 1_000 || met.len() > seeds.len() + 10, "the inputs reach next to nothing");
}

/// A message without what only this input has in it: numbers and quoted texts.
fn shape(message: &str) -> String {
    let mut shape = String::new();
    let mut quoted = false;
    for character in message.chars() {
        match character {
            '"' => quoted = !quoted,
            _ if quoted => {}
            _ if character.is_ascii_digit() => {
                if !shape.ends_with('0') {
                    shape.push('0');
                }
            }
            _ => shape.push(character),
        }
    }
    shape
}

/// The problem documents of the repository.
fn repository_documents() -> Vec<String> {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut found = Vec::new();
    for folder in ["www/problems", "examples"] {
        for entry in std::fs::read_dir(root.join(folder)).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|extension| extension == "json") {
                found.push(path);
            }
        }
    }
    // The order of a folder is not the same everywhere.
    found.sort();
    found.iter().map(|path| std::fs::read_to_string(path).unwrap()).collect()
}
