//! Variants by seed: checked answers, as hard as the original, the same everywhere.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use mo_copp::exercise::{Exercise, VariantSample, seed_of};
use mo_copp::plan::Plan;
use mo_copp::trace::trace;

use super::seeds::{EXERCISES, hash};
use super::{exercise, text};

/// A problem of the gallery with a question.
fn asked(problem: &str, block: serde_json::Value) -> String {
    let path = format!("{}/www/problems/{problem}.json", env!("CARGO_MANIFEST_DIR"));
    let mut document: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    document["exercise"] = block;
    document.to_string()
}

/// What a few seeds of an exercise come to, or why it is refused.
fn sampled(text: &str) -> Result<VariantSample, String> {
    let exercise = Exercise::parse(text).map_err(|error| error.to_string())?;
    exercise.sample().map(Option::unwrap).map_err(|error| error.to_string())
}

/// The walk that leads the enemy of `head-fake` astray.
fn head_fake() -> Vec<&'static str> {
    let plan =
        "north west west west west north south east east east east north north east east east";
    plan.split(' ').collect()
}

/// `MO_COPP_WRITE_GOLDEN=1` writes the file anew.
#[test]
fn the_seeds_of_each_kind_are_the_golden_ones() {
    let found: BTreeMap<&str, String> = EXERCISES
        .iter()
        .map(|&(kind, text, seeds)| (kind, format!("{:016x}", hash(text, seeds))))
        .collect();
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/exercises.json");
    if std::env::var_os("MO_COPP_WRITE_GOLDEN").is_some() {
        std::fs::write(path, serde_json::to_string_pretty(&found).unwrap() + "\n").unwrap();
    }
    let known: BTreeMap<String, String> =
        serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    for (kind, hash) in &found {
        assert_eq!(Some(hash), known.get(*kind), "{kind}");
    }
    assert_eq!(found.len(), known.len());
}

#[test]
fn every_exercise_of_the_project_has_a_checked_solution_and_variants_where_it_says_so() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/exercises");
    let mut kinds = BTreeSet::new();
    let mut count = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "json") {
            continue;
        }
        let exercise = Exercise::parse(&std::fs::read_to_string(&path).unwrap())
            .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        kinds.insert(exercise.kind());
        count += 1;
        assert!(exercise.title().is_some() && !exercise.hints().is_empty(), "{}", path.display());
        for seed in 0..30 {
            let variant = exercise.variant(seed).unwrap();
            assert!(variant.check(variant.solution()).right, "{} seed {seed}", path.display());
        }
    }
    assert_eq!((count, kinds.len()), (12, 6));
}

#[test]
fn seeds_differ_and_seed_0_is_the_original() {
    let exercise = exercise("01-possible-goals");
    let told = |seed: u64| {
        let variant = exercise.variant(seed).unwrap();
        variant.document().to_json() + &variant.question()
    };
    let all: BTreeSet<String> = (1..=50).map(told).collect();
    assert_eq!(all.len(), 50);
    assert_eq!(told(0), exercise.original().document().to_json() + &exercise.original().question());
    assert!(!all.contains(&told(0)));
}

#[test]
fn an_answer_of_goals_is_what_the_independent_replay_says() {
    let exercise = exercise("01-possible-goals");
    for seed in 0..100 {
        let variant = exercise.variant(seed).unwrap();
        let problem = Arc::clone(variant.problem());
        let plan = Plan::from_names(problem.task(), variant.plan().unwrap()).unwrap();
        let replay = trace(&problem, &plan).unwrap();
        let observer = problem.observer_named(variant.observer().unwrap()).unwrap();
        let survivors = &replay.steps.last().unwrap().survivors[observer];
        let goals: Vec<u32> = survivors.iter().map(|goal| goal as u32).collect();
        assert_eq!(variant.solution().choices(), goals, "seed {seed}");
    }
}

#[test]
fn a_belief_is_what_the_independent_replay_says() {
    let exercise = exercise("02-belief");
    for seed in 0..100 {
        let variant = exercise.variant(seed).unwrap();
        let problem = Arc::clone(variant.problem());
        let plan = Plan::from_names(problem.task(), variant.plan().unwrap()).unwrap();
        let replay = trace(&problem, &plan).unwrap();
        let observer = problem.observer_named(variant.observer().unwrap()).unwrap();
        let states = &replay.steps.last().unwrap().beliefs[observer];
        let expected: Vec<String> =
            states.iter().map(|state| problem.label(state.words()).to_string()).collect();
        let labels = variant.form().labels(variant.solution());
        let found: Vec<String> = labels.iter().map(ToString::to_string).collect();
        assert_eq!(
            found.iter().collect::<BTreeSet<_>>(),
            expected.iter().collect::<BTreeSet<_>>(),
            "seed {seed}"
        );
    }
}

#[test]
fn what_is_too_easy_has_no_variants() {
    let trivial = text("01-possible-goals").replace(r#""cell": [4, 2]"#, r#""cell": [4, 4]"#);
    let plan = r#""plan": ["west", "west", "north", "north"]"#;
    assert!(trivial.contains(plan));
    let trivial = trivial.replace(plan, r#""plan": ["north"]"#);
    let error = Exercise::parse(&trivial).unwrap_err().to_string();
    assert_eq!(
        error,
        "exercise.vary: found a question of which no goal is possible, \
         expected a question that is not trivial, since variants are to be like it"
    );
}

#[test]
fn the_seed_of_a_name_is_the_same_everywhere() {
    assert_eq!(seed_of("Ada Lovelace"), seed_of(" Ada Lovelace "));
    for written in
        ["Ada  Lovelace", "Ada\u{a0}Lovelace", "\u{feff}Ada \t Lovelace\n", "Ada\u{200b} Lovelace"]
    {
        assert_eq!(seed_of(written), seed_of("Ada Lovelace"), "{written:?}");
    }
    assert_eq!(seed_of("Zo\u{eb}"), 395_343);
    assert_eq!(seed_of("Zoe\u{308}"), 395_343);
    assert_eq!(seed_of("\u{ff21}\u{ff44}\u{ff41} Lovelace"), seed_of("Ada Lovelace"));
    assert_ne!(seed_of("Zoe"), 395_343);
    assert_ne!(seed_of("ada lovelace"), seed_of("Ada Lovelace"));
    assert_ne!(seed_of("Ada Lovelace"), seed_of("Alan Turing"));
    assert!((1..1_000_000).contains(&seed_of("")));
}

#[test]
fn a_written_variant_is_an_exercise_of_its_own() {
    for name in ["01-possible-goals", "03-guess", "07-wall", "12-best"] {
        let whole = text(name);
        let exercise = exercise(name);
        let variant = exercise.variant(5).unwrap();
        let written = exercise.written(&variant, &whole).to_string();
        let again = Exercise::parse(&written).unwrap();
        assert!(again.vary().is_empty());
        assert_eq!(again.original().question(), variant.question());
        assert_eq!(again.original().solution(), variant.solution());
        assert_eq!(again.title(), exercise.title());
    }
}

#[test]
fn a_sample_of_each_exercise_of_the_project_has_nothing_to_remark() {
    for name in ["01-possible-goals", "03-guess", "08-delivery", "11-head-fake"] {
        let sample = exercise(name).sample().unwrap().unwrap();
        assert_eq!((sample.seeds, sample.found), (20, 20), "{name}");
        assert_eq!(sample.remarks(), [""; 0], "{name}");
        assert_eq!(exercise(name).sample().unwrap(), Some(sample), "{name}");
    }
    let fixed = text("01-possible-goals").replace("\"vary\"", "\"hide\": [], \"vary\"");
    let fixed = fixed.replace(r#"["start", "goals", "walls", "plan"]"#, "[]");
    assert_eq!(Exercise::parse(&fixed).unwrap().sample().unwrap(), None);
}

#[test]
fn an_exercise_of_which_no_seed_has_a_variant_is_refused_before_it_is_handed_out() {
    let block = serde_json::json!({"kind": "guess", "observer": "cooperative", "plan": head_fake(),
        "vary": ["plan"]});
    let text = asked("head-fake", block);
    assert!(Exercise::parse(&text).unwrap().variant(562_061).is_err());
    assert_eq!(
        sampled(&text).unwrap_err(),
        "exercise.vary: found plan, where none of 4 seeds drawn has a variant, expected something to vary that gives each \
         seed a question about as hard as the original, with an answer"
    );
}

#[test]
fn variants_that_are_all_the_same_are_remarked() {
    let best = asked("eight-by-eight", serde_json::json!({"kind": "best", "vary": ["true_goal"]}));
    let sample = sampled(&best).unwrap();
    assert_eq!((sample.found, sample.different), (20, 1));
    assert_eq!(sample.remarks(), ["all 20 variants drawn ask the same question"]);
}

/// The walk goes from one corner of the floor to the other, so that no other cell can be its start.
#[test]
fn a_start_that_the_walk_ties_down_is_remarked() {
    let text = serde_json::json!({
        "format": "gridworld", "width": 4, "height": 4, "start": [0, 3],
        "goals": [
            {"name": "A", "cell": [3, 0]}, {"name": "B", "cell": [2, 1]},
            {"name": "C", "cell": [0, 0]}, {"name": "D", "cell": [1, 2]}
        ],
        "true_goal": "A",
        "observers": {
            "adversarial": {"sensor": {"north": "moved", "south": "moved", "east": "moved", "west": "moved"}},
            "cooperative": {"sensor": {"north": "up", "south": "down", "east": "right", "west": "left"}}
        },
        "exercise": {
            "kind": "possible-goals", "observer": "adversarial",
            "plan": ["north", "east", "north", "east", "north", "east"], "vary": ["start", "goals"]
        }
    });
    let sample = sampled(&text.to_string()).unwrap();
    assert_eq!(
        sample.remarks(),
        ["start is the same in all 20 variants drawn: the rest of the question leaves no other"]
    );
}

/// A goal of the recycling robot takes a can that is picked up and dropped: few walks at random come to one.
#[test]
fn walks_that_are_drawn_come_to_goals_that_take_some_doing() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/recycling-robot.json");
    let mut document: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    for (observer, vary) in
        [("adversarial", vec!["start", "plan"]), ("cooperative", vec!["start", "goals", "plan"])]
    {
        document["exercise"] = serde_json::json!({
            "kind": "possible-goals", "observer": observer,
            "plan": ["west", "pick-up", "south", "west", "drop"], "vary": vary
        });
        let sample = sampled(&document.to_string()).unwrap();
        assert!(sample.seeds > 5 && sample.found == sample.seeds, "{sample:?}");
        assert!(sample.different > 5, "{sample:?}");
    }
}

#[test]
fn where_only_the_true_goal_varies_a_question_must_depend_on_it() {
    let guess = |vary: serde_json::Value| {
        sampled(&asked(
            "head-fake",
            serde_json::json!({"kind": "guess", "observer": "cooperative", "plan": head_fake(), "vary": vary}),
        ))
    };
    let refused = "exercise.vary: found true_goal in an exercise of the kind guess, \
                   expected plan too, since the walk of a guess ends in the true goal";
    assert_eq!(guess(serde_json::json!(["true_goal"])).unwrap_err(), refused);
    assert_eq!(guess(serde_json::json!(["walls", "true_goal"])).unwrap_err(), refused);
    assert!(guess(serde_json::json!(["true_goal", "plan"])).is_ok());
    let vary = r#""vary": ["start", "goals", "walls", "plan"]"#;
    let goals = text("01-possible-goals").replace(vary, r#""vary": ["true_goal"]"#);
    assert_eq!(
        Exercise::parse(&goals).unwrap_err().to_string(),
        "exercise.vary: found true_goal in an exercise of the kind possible-goals, \
         expected something else too, since the answer does not depend on it"
    );
}
