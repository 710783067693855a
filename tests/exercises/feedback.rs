//! Answers and what is said of them: a walk that shows what is wrong.

use mo_copp::exercise::{Counterexample, Exercise};
use mo_copp::plan::Plan;
use mo_copp::problem::Problem;

use super::{exercise, verdict};

/// The symbols that an observer sees of a walk, by replay; none where the walk begins elsewhere than the agent.
fn replayed(problem: &Problem, shown: &Counterexample) -> Option<(Vec<String>, String)> {
    let start = problem.label(problem.task().initial_state().words()).to_string();
    if shown.start.to_string() != start {
        return None;
    }
    let plan = Plan::from_names(problem.task(), &shown.actions).unwrap();
    let replay = mo_copp::trace::trace(problem, &plan).unwrap();
    let observer = problem.observer_named(&shown.observer).unwrap();
    let symbols = replay.steps.iter().filter_map(|step| step.symbols[observer].clone()).collect();
    let end = problem.label(replay.steps.last().unwrap().state.words()).to_string();
    Some((symbols, end))
}

#[test]
fn a_missing_goal_is_shown_by_a_walk_with_the_same_symbols() {
    let exercise = exercise("01-possible-goals");
    let variant = exercise.original();
    assert_eq!(variant.form().to_json(variant.solution()).to_string(), r#"["G1","G2"]"#);
    let said = verdict(variant, "G1");
    assert!(!said.right);
    assert_eq!(
        said.reason(),
        "G2 is possible for the enemy: the walk east, east, north, north from column 2, row 4 shows it the same \
         symbols and ends at column 4, row 2."
    );
}

#[test]
fn a_goal_too_many_is_shown_by_the_walk_that_agrees_longest() {
    let exercise = exercise("01-possible-goals");
    let variant = exercise.original();
    let said = verdict(variant, "G1,G2,G4");
    let shown = said.findings[0].counterexample.clone().unwrap();
    assert!(
        said.reason()
            .starts_with("G4 is not possible for the enemy: of all walks that end there, "),
        "{}",
        said.reason()
    );
    assert!(said.reason().contains(", where the enemy was told \""), "{}", said.reason());
    let differs = shown.differs.unwrap();
    let seen = ["horizontal", "horizontal", "vertical", "vertical"];
    assert_eq!(shown.symbols[..differs - 1], seen[..differs - 1]);
    assert_ne!(shown.symbols[differs - 1], seen[differs - 1]);
}

#[test]
fn every_counterexample_of_every_seed_holds_by_replay() {
    let mut replays = 0;
    for name in ["01-possible-goals", "02-belief", "03-guess"] {
        let exercise = exercise(name);
        for seed in 0..60 {
            let variant = exercise.variant(seed).unwrap();
            let right = variant.solution().choices().to_vec();
            for choice in 0..variant.form().choices.len() as u32 {
                // One choice more or less than right, or another one.
                let mut other = right.clone();
                match other.iter().position(|&known| known == choice) {
                    Some(place) if other.len() > 1 => drop(other.remove(place)),
                    Some(_) => continue,
                    None if name == "03-guess" => other = vec![choice],
                    None => other.push(choice),
                }
                let answer = variant.form().answer(other).unwrap();
                let said = variant.check(&answer);
                assert!(!said.right && !said.reason().is_empty(), "{name} seed {seed}");
                let Some(shown) = &said.findings[0].counterexample else { continue };
                let Some((symbols, end)) = replayed(variant.problem(), shown) else { continue };
                assert_eq!((&symbols, &end), (&shown.symbols, &shown.end.to_string()));
                replays += 1;
            }
        }
    }
    assert!(replays > 500, "{replays}");
}

#[test]
fn a_walk_is_told_where_it_fails_and_what_it_lacks() {
    let exercise = exercise("11-head-fake");
    let variant = exercise.original();
    let says = |answer: &str| verdict(variant, answer).reason().to_owned();
    assert_eq!(
        says("south"),
        "The walk can't be carried out: step 1: found south, which is not applicable in column 5, row 5: it leads nowhere from there."
    );
    assert_eq!(
        says("north"),
        "The walk ends at column 5, row 4, which is not in the true goal G1."
    );
    let said = verdict(variant, "north,north,north,east,east,east");
    assert!(said.reason().starts_with("The walk has goal difference "), "{}", said.reason());
    assert!(said.reason().ends_with("; there is a better one."));
    assert!(
        said.findings.iter().any(|finding| finding.text.contains("is not possible for the enemy"))
    );
    let solution = variant.form().to_json(variant.solution()).to_string();
    assert!(verdict(variant, &solution).right);
}

#[test]
fn a_state_is_believed_and_a_goal_is_possible() {
    let exercise = exercise("02-belief");
    let variant = exercise.original();
    let reason = |answer: Vec<u32>| {
        variant.check(&variant.form().answer(answer).unwrap()).reason().to_owned()
    };
    let right = variant.solution().choices().to_vec();
    let missing = reason(right[1..].to_vec());
    assert!(missing.contains(" is believed by the "), "{missing}");
    let other = (0..1000).find(|choice| !right.contains(choice)).unwrap();
    let too_many = reason([&right[..], &[other]].concat());
    assert!(too_many.contains(" is not believed by the "), "{too_many}");
}

#[test]
fn too_many_steps_are_counted() {
    let exercise = exercise("04-walk-length");
    let variant = exercise.original();
    let right: Vec<u32> = variant.solution().choices().to_vec();
    assert!(right.len() <= 10);
    // There and back again, until it is too long.
    let names: Vec<String> =
        variant.form().labels(variant.solution()).iter().map(ToString::to_string).collect();
    let back = match &names[0][..] {
        "north" => "south",
        "south" => "north",
        "east" => "west",
        _ => "east",
    };
    let mut long = Vec::new();
    for _ in 0..4 {
        long.extend([names[0].clone(), back.to_owned()]);
    }
    long.extend(names);
    let said = verdict(variant, &long.join(","));
    assert_eq!(
        said.reason(),
        format!("The walk has {} steps; at most 10 are asked for.", long.len())
    );
}

#[test]
fn a_placement_says_why_it_does_not_do() {
    let exercise = exercise("07-wall");
    let variant = exercise.original();
    let says = |cell: &str| verdict(variant, cell).reason().to_owned();
    assert_eq!(says("[3, 4]"), "The wall can't be placed in column 3, row 4: the start is there.");
    assert!(says("[3, 3]").starts_with(
        "The wall can't be placed in column 3, row 3: the walk could not go on at step 1, north,"
    ));
    let idle = says("[0, 0]");
    assert!(
        idle.starts_with(
            "With the wall in column 0, row 0, G2 is possible for the enemy: the walk "
        ),
        "{idle}"
    );
}

/// Box pushing on so large a floor that 30 steps lead to more states than are looked through: what is not looked through is
/// not denied. A walk into G2 is there: 18 steps at rest, and the 12 of `around`.
#[test]
fn walks_that_are_too_many_to_look_through_are_not_denied() {
    let sensor =
        serde_json::json!({"move-forward": "f", "stay": "s", "turn-left": "l", "turn-right": "r"});
    let plan = [vec!["move-forward"; 5], vec!["stay"; 25]].concat();
    let document = serde_json::json!({
        "format": "box-pushing", "width": 10, "height": 10,
        "start": {"robot": [5, 6], "facing": "north", "box": [5, 5]},
        "goals": [
            {"name": "G1", "cell": [5, 0]}, {"name": "G2", "cell": [5, 9]}, {"name": "G3", "cell": [0, 1]}
        ],
        "true_goal": "G1",
        "observers": {"adversarial": {"sensor": sensor}, "cooperative": {"sensor": sensor}},
        "exercise": {"kind": "possible-goals", "observer": "adversarial", "plan": plan}
    });
    let exercise = Exercise::parse(&document.to_string()).unwrap();
    let (f, l, r) = ("move-forward", "turn-left", "turn-right");
    let around = [vec!["stay"; 18], vec![l, f, r, f, f, r, f, r, f, f, f, f]].concat();
    let problem = exercise.original().problem();
    let replay =
        mo_copp::trace::trace(problem, &Plan::from_names(problem.task(), &around).unwrap());
    let end = replay.unwrap().steps.last().unwrap().state.clone();
    assert!(problem.task().satisfies(end.words(), &problem.goals()[1].condition));
    assert_eq!(
        verdict(exercise.original(), "G1,G2").reason(),
        "G2 is not possible for the enemy: no walk that shows it the symbols it was told ends there."
    );
}

/// A wall on a wall and a camera on a camera change nothing, whatever the question.
#[test]
fn nothing_is_placed_where_something_of_its_kind_is() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/www/problems/parity.json");
    let parity = std::fs::read_to_string(path).unwrap();
    let place = |place: &str| {
        let mut document: serde_json::Value = serde_json::from_str(&parity).unwrap();
        document["exercise"] = serde_json::json!({
            "kind": "placement", "observer": "adversarial", "plan": ["south", "south"],
            "place": place, "goal": "G2", "possible": false
        });
        document.to_string()
    };
    let said = |text: &str, answer: &str| {
        verdict(Exercise::parse(text).unwrap().original(), answer).reason().to_owned()
    };
    assert_eq!(
        said(&place("wall"), "column 2, row 1"),
        "The wall can't be placed in column 2, row 1: a wall is there."
    );
    assert_eq!(
        said(&place("camera"), "column 2, row 1"),
        "The camera can't be placed in column 2, row 1: a wall is there."
    );
    let mut watched: serde_json::Value = serde_json::from_str(&place("camera")).unwrap();
    watched["observers"]["adversarial"]["cameras"] = serde_json::json!([[6, 0]]);
    assert_eq!(
        said(&watched.to_string(), "column 6, row 0"),
        "The camera can't be placed in column 6, row 0: a camera is there."
    );
    assert_eq!(
        said(&place("wall"), "column 3, row 3"),
        "The wall can't be placed in column 3, row 3: the walk could not go on at step 1, south, from column 3, row 2: \
         it leads nowhere from there."
    );
}

/// PDDL minds no capitals, and the page shows its actions without parentheses.
#[test]
fn actions_of_pddl_are_read_as_people_write_them() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/blocksworld.json");
    let mut document: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    document["exercise"] = serde_json::json!({"kind": "walk", "at_most": 30});
    let exercise = Exercise::parse(&document.to_string()).unwrap();
    let form = exercise.original().form();
    let answer = form.read("(unstack d e), (put-down d)").unwrap();
    assert_eq!(form.read("unstack d e,put-down d").unwrap(), answer);
    assert_eq!(form.read("(UNSTACK D E), Put-Down d").unwrap(), answer);
    let wrong = form.read("(unstack d z)").unwrap_err().to_string();
    assert!(wrong.contains("expected an action of"), "{wrong}");
}

#[test]
fn a_guess_is_answered_by_a_walk_that_shows_something_else() {
    let exercise = exercise("03-guess");
    let variant = exercise.original();
    assert!(verdict(variant, "G1").right);
    assert!(variant.plan().is_none(), "the walk is not told");
    assert!(!variant.question().contains("north, west"), "{}", variant.question());
    for goal in ["G2", "G3", "G4"] {
        let said = verdict(variant, goal);
        assert!(said.reason().contains("is not possible for the enemy"), "{}", said.reason());
    }
}

/// A document of the article with a question.
fn asked(figure: &str, block: serde_json::Value) -> String {
    let path = format!("{}/www/learn/figures/{figure}.json", env!("CARGO_MANIFEST_DIR"));
    let mut document: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    document["exercise"] = block;
    document.to_string()
}

#[test]
fn a_goal_difference_of_two_thirds_may_be_asked_for_in_three_decimals() {
    let block = serde_json::json!({"kind": "walk", "goal_difference": 0.667});
    let exercise = Exercise::parse(&asked("three-more", block)).unwrap();
    let variant = exercise.original();
    assert_eq!(variant.question(), "Give a walk to A with a goal difference of at least 2/3.");
    let right = verdict(variant, "north, west, west, east, east, west");
    assert!(right.right, "{}", right.reason());
    let wrong = verdict(variant, "north, west");
    assert_eq!(wrong.reason(), "The walk has goal difference 1/3; at least 2/3 is asked for.");
}

#[test]
fn of_seven_goals_every_goal_difference_that_is_asked_for_in_three_decimals_can_be_met() {
    let mut document: serde_json::Value =
        serde_json::from_str(&asked("three-more", serde_json::Value::Null)).unwrap();
    for (name, cell) in [("E", [0, 0]), ("F", [6, 5]), ("G", [2, 2])] {
        let goal = serde_json::json!({"name": name, "cell": cell});
        document["goals"].as_array_mut().unwrap().push(goal);
    }
    let mut met = Vec::new();
    for numerator in 1..=6 {
        let exact = f64::from(numerator) / 6.0;
        let rounded: f64 = format!("{exact:.3}").parse().unwrap();
        document["exercise"] = serde_json::json!({"kind": "walk", "goal_difference": rounded});
        let Ok(exercise) = Exercise::parse(&document.to_string()) else { continue };
        let variant = exercise.original();
        assert!(variant.check(variant.solution()).right);
        let problem = variant.problem();
        let names: Vec<String> =
            variant.form().labels(variant.solution()).iter().map(ToString::to_string).collect();
        let plan = Plan::from_names(problem.task(), &names).unwrap();
        let found = mo_copp::trace::trace(problem, &plan).unwrap().goal_difference(problem);
        assert!(found > exact - 1e-9, "{found} for {rounded}");
        if found < exact + 1e-9 {
            met.push(numerator);
        }
    }
    assert!(met.len() >= 3, "{met:?}");
}
