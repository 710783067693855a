//! The words of questions and verdicts: those of the board and of the format.

use mo_copp::exercise::Exercise;

use super::verdict;

/// An example of the project with a question.
fn example(name: &str, block: serde_json::Value) -> Exercise {
    let path = format!("{}/examples/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let mut document: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    document["exercise"] = block;
    Exercise::parse(&document.to_string()).unwrap()
}

#[test]
fn what_can_t_be_placed_is_said_in_the_terms_of_the_board() {
    let placed = |example: &str, observer: &str, place: &str, plan: &[&str]| {
        // Whichever of both has an answer.
        let block = |possible: bool| {
            serde_json::json!({"kind": "placement", "observer": observer, "plan": plan, "place": place,
                "goal": "G1", "possible": possible})
        };
        let path = format!("{}/examples/{example}.json", env!("CARGO_MANIFEST_DIR"));
        let mut document: serde_json::Value =
            serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
        [true, false]
            .into_iter()
            .find_map(|possible| {
                document["exercise"] = block(possible);
                Exercise::parse(&document.to_string()).ok()
            })
            .unwrap()
    };
    let says =
        |exercise: &Exercise, cell: &str| verdict(exercise.original(), cell).reason().to_owned();
    let walls = placed("box-pushing", "cooperative", "wall", &["move-forward", "turn-left"]);
    assert_eq!(
        says(&walls, "[2, 1]"),
        "The wall can't be placed in column 2, row 1: the box begins there."
    );
    assert_eq!(
        says(&walls, "[2, 3]"),
        "The wall can't be placed in column 2, row 3: the start is there."
    );
    assert_eq!(
        says(&walls, "[3, 0]"),
        "The wall can't be placed in column 3, row 0: the goal G1 is there."
    );
    let starts = placed("box-pushing", "cooperative", "start", &["turn-left"]);
    assert_eq!(
        says(&starts, "[2, 1]"),
        "The start can't be placed in column 2, row 1: the box begins there."
    );
    let robot = placed("recycling-robot", "adversarial", "wall", &["west"]);
    assert_eq!(
        says(&robot, "[1, 0]"),
        "The wall can't be placed in column 1, row 0: the can begins there."
    );
    assert_eq!(
        says(&robot, "[2, 3]"),
        "The wall can't be placed in column 2, row 3: the charger is there."
    );
    assert_eq!(
        says(&robot, "[3, 1]"),
        "The wall can't be placed in column 3, row 1: the enemy holds it possible at first."
    );
    // Wherever it is placed, no path of the document is told.
    for exercise in [&walls, &starts, &robot] {
        let variant = exercise.original();
        for choice in 0..variant.form().choices.len() as u32 {
            let said = variant.check(&variant.form().answer([choice]).unwrap());
            assert!(!said.reason().contains("found ["), "{}", said.reason());
        }
    }
}

#[test]
fn questions_have_the_words_of_their_format() {
    let plan = ["move-forward", "move-forward", "turn-left"];
    let block = serde_json::json!({"kind": "belief", "observer": "cooperative", "plan": plan});
    assert_eq!(
        example("box-pushing", block).original().question(),
        "After the walk move-forward, move-forward, turn-left: which states are possible for all that the friend knows?"
    );
    let block =
        serde_json::json!({"kind": "belief", "observer": "adversarial", "plan": ["load a1"]});
    assert_eq!(
        example("delivery", block).original().question(),
        "After the step load a1: which states are possible for all that the enemy knows?"
    );
    let plan = ["load a1", "load b1", "deliver"];
    let each = |symbol: &str| serde_json::json!({"sensor": {"load": symbol, "deliver": "d"}});
    let document = serde_json::json!({
        "format": "delivery", "deliver": 2, "true_goal": "a1+b1",
        "factories": [{"name": "A", "packages": ["a1"]}, {"name": "B", "packages": ["b1", "b2"]}],
        "observers": {"adversarial": each("p"), "cooperative": {"sensor": {"load": {"a1": "1", "b1": "2", "b2": "3"}, "deliver": "d"}}},
        "exercise": {"kind": "guess", "observer": "cooperative", "plan": plan}
    });
    assert_eq!(
        Exercise::parse(&document.to_string()).unwrap().original().question(),
        "At the end of the agent's walk its goal holds. Of the walk the friend is told: 1, 2, d. Which goal is it?"
    );
}
