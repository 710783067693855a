//! Bad gridworlds.

use super::Change::{Drop, Put};
use super::{check, message};

/// The example of the documentation.
pub const GRIDWORLD: &str = r#"{"format": "gridworld", "width": 8, "height": 8,
  "walls": [[3, 3]], "start": [0, 7],
  "goals": [{"name": "G1", "cell": [7, 0]}, {"name": "G2", "cell": [7, 7]},
    {"name": "G3", "cell": [0, 0]}],
  "true_goal": "G1", "stay": false,
  "observers": {
    "adversarial": {"initial_belief": [[0, 7]], "cameras": [[2, 2]],
      "sensor": {"north": "vertical", "south": "vertical",
        "east": "horizontal", "west": "horizontal"}},
    "cooperative": {"initial_belief": [[0, 7]],
      "sensor": {"north": "north-east", "east": "north-east",
        "south": "south-west", "west": "south-west"}}}}"#;

const CELL: &str = "expected a cell [column, row] of whole numbers from 0";

#[test]
fn sizes() {
    let side = "expected a whole number from 1 to 256";
    let table = [
        ("0", "0"),
        ("-3", "-3"),
        ("257", "257"),
        ("100000", "100000"),
        ("4294967304", "4294967304"),
        ("18446744073709551616", "1.8446744073709552e19"),
        ("8.0", "8.0"),
        ("1e300", "1e300"),
        ("2.5", "2.5"),
        ("\"8\"", "\"8\""),
        ("null", "null"),
        ("true", "true"),
        ("[8]", "[8]"),
        ("{\"cells\": 8}", "{\"cells\": …}"),
    ];
    for key in ["width", "height"] {
        for (value, found) in table {
            let text = GRIDWORLD.replace(&format!("\"{key}\": 8"), &format!("\"{key}\": {value}"));
            assert_eq!(message(&text), format!("{key}: found {found}, {side}"));
        }
    }
    let huge = GRIDWORLD.replace(": 8", ": 100000");
    assert_eq!(message(&huge), format!("width: found 100000, {side}"));
}

#[test]
fn cells() {
    let cell = |found: &str| format!("start: found {found}, {CELL}");
    let table = [
        ("[1]", cell("[1]")),
        ("[]", cell("[]")),
        ("[1, 2, 3]", cell("[1, 2, 3]")),
        ("[1, -2]", cell("[1, -2]")),
        ("[1, 2.5]", cell("[1, 2.5]")),
        ("[1, 2.0]", cell("[1, 2.0]")),
        ("[\"1\", 2]", cell("[\"1\", 2]")),
        ("\"1,2\"", cell("\"1,2\"")),
        ("{\"column\": 1, \"row\": 2}", cell("{\"column\": …}")),
        ("8", cell("8")),
        ("[8, 0]", "start: found [8, 0], expected a cell inside the 8 × 8 grid".to_owned()),
        ("[0, 8]", "start: found [0, 8], expected a cell inside the 8 × 8 grid".to_owned()),
        ("[3, 3]", "start: found [3, 3], which is a wall, expected a free cell".to_owned()),
    ];
    for (value, expected) in table {
        let text = GRIDWORLD.replace("\"start\": [0, 7]", &format!("\"start\": {value}"));
        assert_eq!(message(&text), expected);
    }
}

#[test]
fn keys_walls_and_goals() {
    let table = [
        (
            Put("/colour", "\"red\""),
            "document: found the unknown key \"colour\", expected only format, width, height, walls, start, goals, true_goal, stay, observers",
        ),
        (Drop("/width"), "width: found nothing, expected a number of cells"),
        (Drop("/height"), "height: found nothing, expected a number of cells"),
        (Drop("/start"), "start: found nothing, expected a cell"),
        (Drop("/goals"), "goals: found nothing, expected a list of goals"),
        (Drop("/true_goal"), "true_goal: found nothing, expected the name of a goal"),
        (
            Drop("/observers"),
            "observers: found nothing, expected an object with adversarial and cooperative",
        ),
        (Put("/walls", "3"), "walls: found 3, expected a list"),
        (Put("/walls", "null"), "walls: found null, expected a list"),
        (
            Put("/walls", "[[1, 1], 3]"),
            "walls[1]: found 3, expected a cell [column, row] of whole numbers from 0",
        ),
        (
            Put("/walls", "[[1, 1], [8, 2]]"),
            "walls[1]: found [8, 2], expected a cell inside the 8 × 8 grid",
        ),
        (Put("/walls", "[[0, 7]]"), "start: found [0, 7], which is a wall, expected a free cell"),
        (Put("/goals", "{}"), "goals: found {}, expected a list"),
        (Put("/goals", "[]"), "goals: found 0 candidate goals, expected 2 to 1024"),
        (
            Put("/goals", "[{\"name\": \"G1\", \"cell\": [7, 0]}]"),
            "goals: found 1 candidate goals, expected 2 to 1024",
        ),
        (Put("/goals/1", "\"G2\""), "goals[1]: found \"G2\", expected an object"),
        (Drop("/goals/1/name"), "goals[1].name: found nothing, expected the goal's name"),
        (
            Put("/goals/1/name", "\"\""),
            "goals[1].name: found \"\", expected a text that is not empty",
        ),
        (Put("/goals/1/name", "2"), "goals[1].name: found 2, expected a text that is not empty"),
        (
            Put("/goals/1/name", "\"G1\""),
            "goals[1].name: found the goal name \"G1\" for the second time, expected a name of its own",
        ),
        (Drop("/goals/2/cell"), "goals[2].cell: found nothing, expected a cell"),
        (
            Put("/goals/2/cell", "[7]"),
            "goals[2].cell: found [7], expected a cell [column, row] of whole numbers from 0",
        ),
        (
            Put("/goals/2/cell", "[7, 8]"),
            "goals[2].cell: found [7, 8], expected a cell inside the 8 × 8 grid",
        ),
        (
            Put("/goals/2/cell", "[3, 3]"),
            "goals[2].cell: found [3, 3], which is a wall, expected a free cell",
        ),
        (
            Put("/goals/2/states", "[]"),
            "goals[2]: found the unknown key \"states\", expected only name, cell",
        ),
        (
            Put("/true_goal", "\"G4\""),
            "true_goal: found \"G4\", expected the name of a candidate goal: G1, G2, G3",
        ),
        (Put("/true_goal", "1"), "true_goal: found 1, expected a text that is not empty"),
        (Put("/stay", "\"yes\""), "stay: found \"yes\", expected true or false"),
        (Put("/stay", "1"), "stay: found 1, expected true or false"),
        (
            Put("/observers/cooperative/sensor/stay", "\"s\""),
            "observers.cooperative.sensor.stay: found \"s\", expected nothing, since the agent may not stay",
        ),
        (
            Put("/stay", "true"),
            "observers.adversarial.sensor.stay: found nothing, expected the symbol the observer sees, since the agent may stay",
        ),
    ];
    check(GRIDWORLD, &table);
}

#[test]
fn observers() {
    let table = [
        (Put("/observers", "[]"), "observers: found [], expected an object"),
        (
            Put("/observers/neutral", "{}"),
            "observers: found the unknown key \"neutral\", expected only adversarial, cooperative",
        ),
        (
            Drop("/observers/cooperative"),
            "observers.cooperative: found nothing, expected an observer",
        ),
        (
            Drop("/observers/adversarial"),
            "observers.adversarial: found nothing, expected an observer",
        ),
        (
            Put("/observers/adversarial", "\"X\""),
            "observers.adversarial: found \"X\", expected an object",
        ),
        (
            Put("/observers/adversarial/belief", "[]"),
            "observers.adversarial: found the unknown key \"belief\", expected only initial_belief, cameras, sensor",
        ),
        (
            Put("/observers/cooperative/initial_belief", "[[1, 7], [2, 7]]"),
            "observers.cooperative.initial_belief: found 2 cells without the start, expected the start [0, 7] among them",
        ),
        (
            Put("/observers/cooperative/initial_belief", "[]"),
            "observers.cooperative.initial_belief: found 0 cells without the start, expected the start [0, 7] among them",
        ),
        (
            Put("/observers/cooperative/initial_belief", "[[0, 7], [3, 3]]"),
            "observers.cooperative.initial_belief[1]: found [3, 3], which is a wall, expected a free cell",
        ),
        (
            Put("/observers/cooperative/initial_belief", "[[0, 7], [0, 9]]"),
            "observers.cooperative.initial_belief[1]: found [0, 9], expected a cell inside the 8 × 8 grid",
        ),
        (
            Put("/observers/cooperative/initial_belief", "\"start\""),
            "observers.cooperative.initial_belief: found \"start\", expected a list",
        ),
        (
            Put("/observers/adversarial/cameras", "[[1, 1], [1, 8]]"),
            "observers.adversarial.cameras[1]: found [1, 8], expected a cell inside the 8 × 8 grid",
        ),
        (
            Put("/observers/adversarial/cameras", "{}"),
            "observers.adversarial.cameras: found {}, expected a list",
        ),
        (
            Drop("/observers/adversarial/sensor"),
            "observers.adversarial.sensor: found nothing, expected an object with a symbol for each action",
        ),
        (
            Drop("/observers/adversarial/sensor/west"),
            "observers.adversarial.sensor.west: found nothing, expected the symbol the observer sees",
        ),
        (
            Put("/observers/adversarial/sensor/west", "\"\""),
            "observers.adversarial.sensor.west: found \"\", expected a text that is not empty",
        ),
        (
            Put("/observers/adversarial/sensor/west", "7"),
            "observers.adversarial.sensor.west: found 7, expected a text that is not empty",
        ),
        (
            Put("/observers/adversarial/sensor/up", "\"vertical\""),
            "observers.adversarial.sensor: found the unknown key \"up\", expected only north, south, east, west, stay",
        ),
        (
            Put("/observers/adversarial/sensor", "\"axis\""),
            "observers.adversarial.sensor: found \"axis\", expected an object",
        ),
    ];
    check(GRIDWORLD, &table);
}

#[test]
fn too_many_goals() {
    let goal = |number| format!("{{\"name\": \"G{number}\", \"cell\": [7, 0]}}");
    let goals: Vec<String> = (1..=1025).map(goal).collect();
    let old = GRIDWORLD.find("\"goals\": [").unwrap()..GRIDWORLD.find("\"true_goal\"").unwrap();
    let with = |goals: &[String]| {
        let mut text = GRIDWORLD.to_owned();
        text.replace_range(old.clone(), &format!("\"goals\": [{}],", goals.join(",")));
        message(&text)
    };
    assert_eq!(with(&goals), "goals: found 1025 candidate goals, expected 2 to 1024");
    assert_eq!(with(&goals[..1024]), "no error");
}
