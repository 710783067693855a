//! Bad explicit problems.

use super::Change::{Drop, Put};
use super::check;

/// The example of the documentation.
pub const EXPLICIT: &str = r#"{"format": "explicit", "states": ["s0", "s1", "s2"],
  "actions": ["a", "b"], "transitions": [["s0", "a", "s1"], ["s0", "b", "s2"]],
  "initial_state": "s0",
  "goals": [{"name": "G1", "states": ["s1"]}, {"name": "G2", "states": ["s2"]}],
  "true_goal": "G1",
  "observers": {
    "adversarial": {"initial_belief": ["s0"],
      "sensor": [["a", "s1", "moved"], ["b", "s2", "moved"]]},
    "cooperative": {"initial_belief": ["s0"], "sensor": [["a", "s1", "a"], ["b", "s2", "b"]]}}}"#;

#[test]
fn states_transitions_and_goals() {
    let table = [
        (
            Put("/width", "8"),
            "document: found the unknown key \"width\", expected only format, states, actions, transitions, initial_state, goals, true_goal, observers",
        ),
        (Drop("/states"), "states: found nothing, expected a list of state names"),
        (Put("/states", "3"), "states: found 3, expected a list"),
        (Put("/states/1", "1"), "states[1]: found 1, expected a text that is not empty"),
        (Put("/states/1", "\"\""), "states[1]: found \"\", expected a text that is not empty"),
        (
            Put("/states/2", "\"s0\""),
            "states[2]: found the name \"s0\" for the second time, expected a name of its own",
        ),
        (Drop("/actions"), "actions: found nothing, expected a list of action names"),
        (
            Put("/actions/1", "\"a\""),
            "actions[1]: found the name \"a\" for the second time, expected a name of its own",
        ),
        (
            Drop("/transitions"),
            "transitions: found nothing, expected a list of [state, action, state]",
        ),
        (
            Put("/transitions/1", "[\"s0\", \"b\"]"),
            "transitions[1]: found [\"s0\", \"b\"], expected [state, action, resulting state]",
        ),
        (
            Put("/transitions/1", "[\"s0\", \"b\", 2]"),
            "transitions[1]: found [\"s0\", \"b\", 2], expected [state, action, resulting state]",
        ),
        (
            Put("/transitions/1", "\"s0 b s2\""),
            "transitions[1]: found \"s0 b s2\", expected [state, action, resulting state]",
        ),
        (
            Put("/transitions/1/0", "\"s7\""),
            "transitions[1][0]: found \"s7\", expected a state of the document: s0, s1, s2",
        ),
        (
            Put("/transitions/1/1", "\"c\""),
            "transitions[1][1]: found \"c\", expected an action of the document: a, b",
        ),
        (
            Put("/transitions/1/2", "\"s7\""),
            "transitions[1][2]: found \"s7\", expected a state of the document: s0, s1, s2",
        ),
        (
            Put("/transitions/1/1", "\"a\""),
            "transitions[1]: found a second transition of \"a\" in \"s0\", expected at most one successor for each state and action",
        ),
        (
            Put("/initial_state", "\"start\""),
            "initial_state: found \"start\", expected a state of the document: s0, s1, s2",
        ),
        (Drop("/initial_state"), "initial_state: found nothing, expected a state"),
        (
            Put("/goals/1/states/0", "\"s7\""),
            "goals[1].states[0]: found \"s7\", expected a state of the document: s0, s1, s2",
        ),
        (Drop("/goals/1/states"), "goals[1].states: found nothing, expected a list of states"),
        (
            Put("/goals/1/cell", "[1, 1]"),
            "goals[1]: found the unknown key \"cell\", expected only name, states",
        ),
        (
            Put("/goals/1/name", "\"G1\""),
            "goals[1].name: found the goal name \"G1\" for the second time, expected a name of its own",
        ),
        (
            Put("/goals", "[{\"name\": \"G1\", \"states\": [\"s1\"]}]"),
            "goals: found 1 candidate goals, expected 2 to 1024",
        ),
        (
            Put("/true_goal", "\"s1\""),
            "true_goal: found \"s1\", expected the name of a candidate goal: G1, G2",
        ),
        (
            Put("/states", "[]"),
            "goals[0].states[0]: found \"s1\", expected a state of the document: (none)",
        ),
    ];
    check(EXPLICIT, &table);
}

#[test]
fn observers() {
    let table = [
        (
            Put("/observers/adversarial/initial_belief", "[\"s1\", \"s2\"]"),
            "observers.adversarial.initial_belief: found 2 states without the initial state, expected \"s0\" among them",
        ),
        (
            Put("/observers/adversarial/initial_belief", "[\"s0\", \"s7\"]"),
            "observers.adversarial.initial_belief[1]: found \"s7\", expected a state of the document: s0, s1, s2",
        ),
        (
            Put("/observers/adversarial/initial_belief", "\"s0\""),
            "observers.adversarial.initial_belief: found \"s0\", expected a list",
        ),
        (
            Drop("/observers/adversarial/sensor"),
            "observers.adversarial.sensor: found nothing, expected a list of [action, resulting state, symbol]",
        ),
        (
            Put("/observers/adversarial/sensor", "[[\"a\", \"s1\", \"moved\"]]"),
            "observers.adversarial.sensor: found no symbol for \"b\" resulting in \"s2\", expected a symbol for every action and resulting state that occurs",
        ),
        (
            Put("/observers/cooperative/sensor/1", "[\"a\", \"s1\", \"moved\"]"),
            "observers.cooperative.sensor[1]: found a second symbol for \"a\" resulting in \"s1\", expected one symbol for each pair",
        ),
        (
            Put("/observers/cooperative/sensor/1/0", "\"c\""),
            "observers.cooperative.sensor[1][0]: found \"c\", expected an action of the document: a, b",
        ),
        (
            Put("/observers/cooperative/sensor/1/1", "\"s7\""),
            "observers.cooperative.sensor[1][1]: found \"s7\", expected a state of the document: s0, s1, s2",
        ),
        (
            Put("/observers/cooperative/sensor/1/2", "\"\""),
            "observers.cooperative.sensor[1]: found [\"b\", \"s2\", \"\"], expected [action, resulting state, symbol]",
        ),
        (
            Put("/observers/cooperative/sensor/1/2", "3"),
            "observers.cooperative.sensor[1]: found [\"b\", \"s2\", 3], expected [action, resulting state, symbol]",
        ),
        (
            Put("/observers/cooperative/cameras", "[]"),
            "observers.cooperative: found the unknown key \"cameras\", expected only initial_belief, sensor",
        ),
    ];
    check(EXPLICIT, &table);
}

/// Symbols for what never happens do no harm, and a goal may have no states.
#[test]
fn what_is_allowed() {
    let base = EXPLICIT
        .replace("[\"b\", \"s2\", \"b\"]", "[\"b\", \"s2\", \"b\"], [\"b\", \"s0\", \"b\"]");
    check(&base.replace("[\"s2\"]}]", "[]}]"), &[]);
}
