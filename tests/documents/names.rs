//! Names that cannot be told apart by eye, in every format: refused with the sign as U+XXXX.

use super::Change::Put;
use super::{DELIVERY, EXPLICIT, GRIDWORLD, check, message, pddl};

#[test]
fn hidden_signs_in_goal_names() {
    for (name, sign) in [
        ("\u{200b}", "U+200B"),
        ("G1\u{200b}", "U+200B"),
        ("G\u{200d}1", "U+200D"),
        ("\u{202e}1G", "U+202E"),
        ("G\u{2066}1\u{2069}", "U+2066"),
        ("\u{feff}G1", "U+FEFF"),
        ("G\u{ad}1", "U+00AD"),
        ("G1\u{fe0f}", "U+FE0F"),
        ("G1\u{e0041}", "U+E0041"),
        ("\u{3164}", "U+3164"),
        ("G\u{2028}1", "U+2028"),
        ("\u{e000}", "U+E000"),
    ] {
        let text = GRIDWORLD.replace("\"name\": \"G2\"", &format!("\"name\": \"{name}\""));
        let found = format!("found {name:?} with the hidden sign {sign}");
        let expected = format!("goals[1].name: {found}, expected signs that can be seen");
        assert_eq!(message(&text), expected);
    }
}

#[test]
fn names_that_are_blank() {
    for (name, signs) in [
        (" ", "U+0020"),
        ("\u{a0}\u{2003}", "U+00A0 U+2003"),
        ("\\u0000\\u001b", "U+0000 U+001B"),
        ("          ", "U+0020 U+0020 U+0020 U+0020"),
    ] {
        let text = GRIDWORLD.replace("\"name\": \"G2\"", &format!("\"name\": \"{name}\""));
        assert_eq!(
            message(&text),
            format!(
                "goals[1].name: found a text that is blank when shown ({signs}), expected a sign that can be seen"
            )
        );
    }
}

#[test]
fn names_that_look_alike() {
    let named = |one: &str, other: &str| {
        let text = GRIDWORLD.replace("\"G1\"", &format!("\"{one}\""));
        message(&text.replace("\"G2\"", &format!("\"{other}\"")))
    };
    for (one, other, shown, difference) in [
        (
            "Café",
            "Cafe\u{301}",
            "\"Cafe\\u{301}\", which looks like \"Café\"",
            "U+0065 in place of U+00E9",
        ),
        ("G 1", "G\u{a0}1", "\"G\\u{a0}1\", which looks like \"G 1\"", "U+00A0 in place of U+0020"),
        ("G 1", "G  1", "\"G  1\", which looks like \"G 1\"", "U+0020 in place of U+0031"),
        ("G1", "G1 ", "\"G1 \", which looks like \"G1\"", "U+0020 at its end"),
        ("G1\\n", "G1", "\"G1\", which looks like \"G1\\n\"", "no U+000A at its end"),
        ("C1", "С1", "\"С1\", which looks like \"C1\"", "U+0421 in place of U+0043"),
        ("Αa", "Aа", "\"Aа\", which looks like \"Αa\"", "U+0041 in place of U+0391"),
        ("A\\u001b", "A", "\"A\", which looks like \"A\\u{1b}\"", "no U+001B at its end"),
        ("x‐y", "x-y", "\"x-y\", which looks like \"x‐y\"", "U+002D in place of U+2010"),
        (
            "خا\u{200c}ن",
            "خان",
            "\"خان\", which looks like \"خا\\u{200c}ن\"",
            "U+0646 in place of U+200C",
        ),
    ] {
        assert_eq!(
            named(one, other),
            format!(
                "goals[1].name: found {shown} ({difference}), expected a name that can be told apart by eye"
            )
        );
    }
    // What differs to the eye stays.
    for (one, other) in
        [("x²", "x2"), ("a", "A"), ("Ｇ", "G"), ("目标一", "目标二"), ("👩\u{200d}🚀", "👩")]
    {
        assert_eq!(named(one, other), "no error", "{one} {other}");
    }
}

#[test]
fn every_name_and_symbol_is_held_to_it() {
    let hidden = |path: &str| {
        format!(
            "{path}: found \"x\\u{{200b}}\" with the hidden sign U+200B, expected signs that can be seen"
        )
    };
    let at = |base: &str, place: &'static str, path: &str| {
        check(base, &[(Put(place, "\"x\\u200b\""), &hidden(path))]);
    };
    at(GRIDWORLD, "/observers/adversarial/sensor/north", "observers.adversarial.sensor.north");
    at(EXPLICIT, "/states/1", "states[1]");
    at(EXPLICIT, "/actions/0", "actions[0]");
    at(EXPLICIT, "/goals/0/name", "goals[0].name");
    at(EXPLICIT, "/observers/cooperative/sensor/0/2", "observers.cooperative.sensor[0][2]");
    at(DELIVERY, "/factories/0/name", "factories[0].name");
    at(DELIVERY, "/factories/1/packages/0", "factories[1].packages[0]");
    at(DELIVERY, "/observers/adversarial/sensor/load", "observers.adversarial.sensor.load");
    at(DELIVERY, "/observers/adversarial/sensor/deliver", "observers.adversarial.sensor.deliver");
    at(pddl::example(), "/goals/0/name", "goals[0].name");
    at(pddl::example(), "/observers/cooperative/sensor", "observers.cooperative.sensor");
    check(
        pddl::example(),
        &[(
            Put(
                "/observers/cooperative/sensor",
                "{\"table\": [[\"(walk hall office)\", \"x\\u200b\"]], \"otherwise\": \"{name}\"}",
            ),
            &hidden("observers.cooperative.sensor.table[0][1]"),
        )],
    );
    check(
        pddl::example(),
        &[(
            Put("/observers/cooperative/groups", "{\"x\\u200b\": []}"),
            &hidden("observers.cooperative.groups"),
        )],
    );
}

#[test]
fn names_of_other_things_that_look_alike() {
    let told_apart = "expected a name that can be told apart by eye";
    let alike = format!("found \"s1 \", which looks like \"s1\" (U+0020 at its end), {told_apart}");
    let at = |path: &str| format!("{path}: {alike}");
    check(EXPLICIT, &[(Put("/states", "[\"s0\", \"s1\", \"s2\", \"s1 \"]"), &at("states[3]"))]);
    // Of an action, blanks inside; those at the ends are written in plans.
    let inside = format!(
        "actions[3]: found \"s  1\", which looks like \"s 1\" (U+0020 in place of U+0031), {told_apart}"
    );
    check(
        EXPLICIT,
        &[
            (Put("/actions", "[\"a\", \"b\", \"s 1\", \"s  1\"]"), &inside),
            (Put("/actions", "[\"a\", \"b\", \" a\", \"a \"]"), "no error"),
        ],
    );
    check(
        DELIVERY,
        &[(
            Put("/factories/0", "{\"name\": \"s1\", \"packages\": [\"a1\", \"s1 \"]}"),
            &at("factories[0].packages[1]"),
        )],
    );
    check(
        EXPLICIT,
        &[(
            Put(
                "/observers/cooperative/sensor",
                "[[\"a\", \"s1\", \"s1\"], [\"b\", \"s2\", \"s1 \"]]",
            ),
            &at("observers.cooperative.sensor[1][2]"),
        )],
    );
    check(
        GRIDWORLD,
        &[(
            Put(
                "/observers/cooperative/sensor",
                "{\"north\": \"s1\", \"east\": \"s1 \", \"south\": \"x\", \"west\": \"x\"}",
            ),
            &at("observers.cooperative.sensor.east"),
        )],
    );
    check(
        DELIVERY,
        &[(
            Put(
                "/observers/cooperative/sensor",
                "{\"load\": {\"A\": \"s1\", \"B\": \"x\"}, \"deliver\": \"s1 \"}",
            ),
            &at("observers.cooperative.sensor.deliver"),
        )],
    );
}
