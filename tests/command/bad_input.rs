//! What a user can get wrong: exit code 2 and one message with the place.

use crate::{DELIVERY, EXPLICIT, GRID, mo_copp, with_input};

/// A change to a document, and what the message says.
type Case = (&'static str, &'static str, &'static str);

fn refused(document: &str, (from, to, message): Case) {
    assert!(document.contains(from), "the document holds {from}");
    let ran = mo_copp(&document.replacen(from, to, 1), &["solve", "-", "--json"]);
    assert_eq!(ran.code, 2, "{to}: {}{}", ran.out, ran.err);
    assert_eq!(ran.out, "", "{to}: nothing is half done");
    assert_eq!(message_of(&ran.err), message, "{to}");
}

/// The message behind `mo-copp: -:LINE:COLUMN: `.
fn message_of(printed: &str) -> &str {
    let message = printed.strip_prefix("mo-copp: -:").unwrap().strip_suffix('\n').unwrap();
    let mut parts = message.splitn(3, ':');
    for _ in 0..2 {
        assert!(parts.next().unwrap().parse::<usize>().unwrap() > 0, "{message}");
    }
    parts.next().unwrap().strip_prefix(' ').unwrap()
}

#[test]
fn an_error_begins_with_file_line_and_column() {
    let document = "{\"format\": \"gridworld\",\n \"width\": 0}";
    let ran = mo_copp(document, &["solve", "-"]);
    assert_eq!(ran.err, "mo-copp: -:2:11: width: found 0, expected a whole number from 1 to 256\n");
}

#[test]
fn what_is_no_json_is_said_with_its_place_once() {
    for (document, message) in [
        (
            "{\"format\": \"gridworld\",\n \"width\": 08}",
            "2:12: found “08”, expected a number such as 3 or 0.5",
        ),
        (
            "{\"format\": 1,\n\n  \"format\": 2}",
            "3:10: found the key \"format\" for the second time, expected each key once",
        ),
        ("{}\n}", "2:1: found “}” after the document, expected the end of the text"),
    ] {
        let ran = mo_copp(document, &["solve", "-"]);
        assert_eq!((ran.code, ran.err), (2, format!("mo-copp: -:{message}\n")));
    }
}

#[test]
fn what_is_not_utf_8_is_said_with_its_place() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"));
    let file = folder.join("not-utf-8");
    let name = file.to_str().unwrap();
    for (bytes, place, byte) in [
        (&b"caf\xe9"[..], "1:4", "0xE9"),
        (b"{\"format\":\n \"\xc3\xa9\xff\"}", "2:4", "0xFF"),
        (b"\n\xc3", "2:1", "0xC3"),
    ] {
        std::fs::write(&file, bytes).unwrap();
        for arguments in [&["solve", name][..], &["plan", name, name]] {
            let ran = mo_copp("", arguments);
            let message =
                format!("mo-copp: {name}:{place}: found the byte {byte}, expected UTF-8 text\n");
            assert_eq!((ran.code, ran.err), (2, message), "{arguments:?}");
        }
    }
}

#[test]
fn gridworld_documents() {
    let cases: &[Case] = &[
        ("{\"format\"", "{format", "found “format”, expected a key in double quotes"),
        (
            "\"gridworld\"",
            "\"chess\"",
            "format: found \"chess\", expected gridworld, box-pushing, recycling-robot, delivery, explicit or pddl",
        ),
        (
            "\"stay\"",
            "\"stey\"",
            "document: found the unknown key \"stey\", expected only format, width, height, walls, start, goals, true_goal, stay, observers",
        ),
        ("[7, 0]", "[8, 0]", "goals[0].cell: found [8, 0], expected a cell inside the 8 × 8 grid"),
        ("[7, 0]", "[3, 3]", "goals[0].cell: found [3, 3], which is a wall, expected a free cell"),
        (
            "\"G2\"",
            "\"G1\"",
            "goals[1].name: found the goal name \"G1\" for the second time, expected a name of its own",
        ),
        (
            "\"true_goal\": \"G1\"",
            "\"true_goal\": \"G9\"",
            "true_goal: found \"G9\", expected the name of a candidate goal: G1, G2, G3",
        ),
        (
            ", {\"name\": \"G2\", \"cell\": [7, 7]}, {\"name\": \"G3\", \"cell\": [0, 0]}",
            "",
            "goals: found 1 candidate goals, expected 2 to 1024",
        ),
        (
            "\"initial_belief\": [[0, 7]]",
            "\"initial_belief\": [[1, 7]]",
            "observers.adversarial.initial_belief: found 1 cells without the start, expected the start [0, 7] among them",
        ),
        (
            "\"west\": \"horizontal\"",
            "\"wesp\": \"horizontal\"",
            "observers.adversarial.sensor: found the unknown key \"wesp\", expected only north, south, east, west, stay",
        ),
        (
            ", \"west\": \"horizontal\"",
            "",
            "observers.adversarial.sensor.west: found nothing, expected the symbol the observer sees",
        ),
        (
            "\"stay\": false",
            "\"stay\": true",
            "observers.adversarial.sensor.stay: found nothing, expected the symbol the observer sees, since the agent may stay",
        ),
        ("[[3, 3]]", "[[0, 7]]", "start: found [0, 7], which is a wall, expected a free cell"),
        ("[[3, 3]]", "[[3, 9]]", "walls[0]: found [3, 9], expected a cell inside the 8 × 8 grid"),
        (
            "\"width\": 8, \"height\": 8",
            "\"width\": 100000, \"height\": 100000",
            "width: found 100000, expected a whole number from 1 to 256",
        ),
        ("\"width\": 8", "\"width\": -8", "width: found -8, expected a whole number from 1 to 256"),
        (
            "\"width\": 8",
            "\"width\": 8.5",
            "width: found 8.5, expected a whole number from 1 to 256",
        ),
        (
            "\"width\": 8",
            "\"width\": \"8\"",
            "width: found \"8\", expected a whole number from 1 to 256",
        ),
        (
            "\"width\": 8",
            "\"width\": 8, \"width\": 9",
            "found the key \"width\" for the second time, expected each key once",
        ),
        (
            "\"start\": [0, 7]",
            "\"start\": [0]",
            "start: found [0], expected a cell [column, row] of whole numbers from 0",
        ),
        ("\"start\": [0, 7],", "", "start: found nothing, expected a cell"),
    ];
    for case in cases {
        refused(GRID, *case);
    }
}

#[test]
fn explicit_documents() {
    let cases: &[Case] = &[
        (
            "[\"s0\", \"b\", \"s2\"]",
            "[\"s0\", \"a\", \"s2\"]",
            "transitions[1]: found a second transition of \"a\" in \"s0\", expected at most one successor for each state and action",
        ),
        (
            ", [\"b\", \"s2\", \"moved\"]",
            "",
            "observers.adversarial.sensor: found no symbol for \"b\" resulting in \"s2\", expected a symbol for every action and resulting state that occurs",
        ),
        (
            "[\"b\", \"s2\", \"moved\"]",
            "[\"a\", \"s1\", \"moved\"]",
            "observers.adversarial.sensor[1]: found a second symbol for \"a\" resulting in \"s1\", expected one symbol for each pair",
        ),
        (
            "\"initial_belief\": [\"s0\"]",
            "\"initial_belief\": [\"s1\"]",
            "observers.adversarial.initial_belief: found 1 states without the initial state, expected \"s0\" among them",
        ),
        (
            "[\"s0\", \"b\", \"s2\"]",
            "[\"s0\", \"b\", \"s9\"]",
            "transitions[1][2]: found \"s9\", expected a state of the document: s0, s1, s2",
        ),
        (
            "[\"s0\", \"b\", \"s2\"]",
            "[\"s0\", \"b\"]",
            "transitions[1]: found [\"s0\", \"b\"], expected [state, action, resulting state]",
        ),
        (
            "\"initial_state\": \"s0\"",
            "\"initial_state\": \"\"",
            "initial_state: found \"\", expected a text that is not empty",
        ),
        (
            "[\"s0\", \"s1\", \"s2\"]",
            "[\"s0\", \"s1\", \"s1\"]",
            "states[2]: found the name \"s1\" for the second time, expected a name of its own",
        ),
    ];
    for case in cases {
        refused(EXPLICIT, *case);
    }
}

#[test]
fn delivery_documents() {
    let cases: &[Case] = &[
        (
            "\"deliver\": 2",
            "\"deliver\": 5",
            "deliver: found 5, expected a whole number from 1 to 4",
        ),
        (
            "\"deliver\": 2",
            "\"deliver\": 4",
            "deliver: found 4 of 4 packages, expected between 2 and 1024 possible sets, which are the goals",
        ),
        (
            "\"a1+a2\"",
            "\"a1+c1\"",
            "true_goal: found \"c1+a1\", expected the name of a candidate goal: a1+a2, a1+b1, a1+b2, a2+b1, a2+b2, b1+b2",
        ),
        (
            "\"b2\"",
            "\"a1\"",
            "factories[1].packages[1]: found the name \"a1\" for the second time, expected a name of its own",
        ),
        ("\"b2\"", "\"b+2\"", "factories[1].packages[1]: found \"b+2\", expected a name without +"),
        (
            ", \"B\": \"barcode B\"",
            "",
            "observers.cooperative.sensor.load: found no symbol for b1 (factories[1].packages[0]), expected a symbol for b1 or for B",
        ),
        (
            "\"B\": \"barcode B\"",
            "\"B\": \"barcode B\", \"D\": \"x\"",
            "observers.cooperative.sensor.load: found \"D\", expected a factory or a package: A, B, a1, a2, b1, b2",
        ),
    ];
    for case in cases {
        refused(DELIVERY, *case);
    }
}

#[test]
fn arguments() {
    for (arguments, message) in [
        (
            &["--horizon", "1000000000"][..],
            "found 1000000000, expected a whole number from 0 to 10000, or any",
        ),
        (&["--horizon=-1"], "found -1, expected a whole number from 0 to 10000, or any"),
        (&["--horizon", "1.5"], "found 1.5, expected"),
        (&["--k", "4"], "k: found 4, expected a whole number from 1 to 3, the number of goals"),
        (&["--k", "0"], "k: found 0, expected a whole number from 1 to 3"),
        (&["--j", "4"], "j: found 4, expected a whole number from 1 to 3"),
        (&["--j", "0"], "j: found 0, expected a whole number from 1 to 3"),
        (&["--j=-1"], "--j"),
        (
            &["--solver", "magic"],
            "found magic, expected one of exact, ip, search, satisficing, baseline, obfuscate, legible",
        ),
        (&["--encoding", "magic"], "found magic, expected one of paper, belief-flow"),
        (&["--solver", "ip", "--horizon", "any"], "horizon: found any, expected a number of steps"),
        (&["--solver", "ip", "--pareto"], "pareto: found the solver ip, expected the solver exact"),
        (&["--solver", "ip", "--pairs"], "pairs: found the solver ip, expected the solver exact"),
        (&["--require", "adversarial"], "require: found \"adversarial\", expected ROLE:GOAL"),
        (
            &["--require", "spy:G1"],
            "require: found \"spy:G1\", expected a role of adversarial, cooperative",
        ),
        (
            &["--forbid", "cooperative:G9"],
            "forbid: found \"cooperative:G9\", expected a candidate goal",
        ),
        (
            &["--horizon-step", "1000000000"],
            "horizon step: found 1000000000, expected a whole number from 0 to 10000",
        ),
        (&["--nonsense"], "--nonsense"),
    ] {
        let ran = mo_copp(GRID, &[&["solve", "-"], arguments].concat());
        assert_eq!(ran.code, 2, "{arguments:?}: {}{}", ran.out, ran.err);
        assert!(ran.err.contains(message), "{arguments:?}: {}", ran.err);
        assert_eq!(ran.out, "", "{arguments:?}");
    }
}

#[test]
fn plans_and_files() {
    for (arguments, message) in [
        (
            &["trace", "-", "--plan", "north,west"][..],
            "mo-copp: the plan fails: step 2: found west, which is not applicable in column 0, row 6: it leads nowhere from there\n",
        ),
        (
            &["trace", "-", "--plan", "north,fly"],
            "mo-copp: the plan fails: step 2: found \"fly\", expected an action of this problem: north, south, east, west\n",
        ),
        (
            &["solve", "no-such-file.json"],
            "mo-copp: no-such-file.json: No such file or directory (os error 2)\n",
        ),
    ] {
        let ran = mo_copp(GRID, arguments);
        assert_eq!((ran.code, ran.out.as_str()), (2, ""), "{arguments:?}");
        assert_eq!(ran.err, message);
    }
    let ran = mo_copp(DELIVERY, &["trace", "-", "--plan", "load a1,load a1"]);
    assert_eq!(ran.code, 2);
    assert!(ran.err.contains("step 2: found load a1, which is not applicable in {"), "{}", ran.err);
    let ran = mo_copp(GRID, &["trace", "-"]);
    assert_eq!(ran.code, 2, "a plan is required");
}

#[test]
fn negative_numbers_name_their_option() {
    for option in ["--horizon", "--k", "--j", "--horizon-step", "--node-limit"] {
        let ran = mo_copp(GRID, &["solve", "-", option, "-1"]);
        assert_eq!((ran.code, ran.out.as_str()), (2, ""), "{option}");
        assert!(ran.err.contains(&format!("'{option}")), "{option}: {}", ran.err);
        assert!(ran.err.contains("-1"), "{option}: {}", ran.err);
    }
}

#[test]
fn what_is_too_large_is_refused_before_memory_runs_out() {
    let long = format!("{{\"format\": \"explicit\", \"states\": [{}0]}}", "0,".repeat(17 << 20));
    let ran = mo_copp(&long, &["solve", "-"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    assert_eq!(ran.err, "mo-copp: -: found more than 32 MiB, expected at most that\n");
    let plan = "north,south,".repeat(5999) + "north,south";
    let ran = mo_copp(GRID, &["trace", "-", "--plan", &plan]);
    assert_eq!(ran.code, 2);
    assert_eq!(
        ran.err,
        "mo-copp: the plan fails: the plan: found 12000 actions, expected at most 10000\n"
    );
    let blind = GRID
        .replace("\"width\": 8, \"height\": 8", "\"width\": 99, \"height\": 99")
        .replace("horizontal", "vertical");
    let plan = "north,south,".repeat(1199) + "north,south";
    // Text needs the present beliefs alone, JSON those of all steps.
    assert_eq!(mo_copp(&blind, &["trace", "-", "--plan", &plan]).code, 1);
    let ran = mo_copp(&blind, &["trace", "-", "--plan", &plan, "--json"]);
    assert_eq!((ran.code, ran.out.len()), (3, 0), "{}", ran.err);
    assert!(ran.err.starts_with("mo-copp: trace limit reached at step "), "{}", ran.err);
}

/// Documents that are small as text and large as values, in a process that may have little memory.
#[cfg(target_os = "linux")]
#[test]
fn small_texts_of_many_values_are_refused_in_bounded_memory() {
    let lists = format!("[{}[0]]", "[0],".repeat((8 << 20) - 2));
    let empty = PDDL.replace("BELIEF", &format!("[{}{{}}]", "[],".repeat(5_000_000)));
    let goals =
        format!("{{\"format\": \"explicit\", \"states\": [{}\"s\"]}}", "\"s\",".repeat(3_900_000));
    for (document, message) in [
        (lists, "found more than 4000000 values, expected at most that"),
        (empty, "found more than 4000000 values, expected at most that"),
        (goals, "actions: found nothing, expected a list of action names"),
    ] {
        let mut command = std::process::Command::new("sh");
        let limited = "ulimit -v 800000; exec \"$0\" solve -";
        command.args(["-c", limited, env!("CARGO_BIN_EXE_mo-copp")]);
        let ran = with_input(command, &document);
        assert_eq!((ran.code, ran.out.as_str()), (2, ""), "{}", ran.err);
        assert!(ran.err.contains(message), "{}", ran.err);
    }
}

/// A document in PDDL, in which BELIEF stands for what the enemy believes.
const PDDL: &str = r#"{"format": "pddl", "domain": "(define (domain d) (:predicates (p) (q)) (:action a :effect (p)) (:action b :effect (q)))",
 "problem": "(define (problem t) (:domain d) (:init))", "true_goal": "p",
 "goals": [{"name": "p", "condition": "(p)"}, {"name": "q", "condition": "(q)"}],
 "observers": {"adversarial": {"initial_belief": BELIEF, "sensor": "{name}"}, "cooperative": {"sensor": "{name}"}}}"#;

/// As many beliefs as are read are worked with.
#[cfg(target_os = "linux")]
#[test]
fn a_belief_of_millions_of_equal_states_takes_bounded_memory() {
    let states = PDDL.replace("BELIEF", &format!("[{}{{}}]", "[],".repeat(3_500_000)));
    let mut command = std::process::Command::new("sh");
    let limited = "ulimit -v 800000; exec \"$0\" solve - --json";
    command.args(["-c", limited, env!("CARGO_BIN_EXE_mo-copp")]);
    let ran = with_input(command, &states);
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert_eq!(ran.json()["status"], "optimal");
}

#[test]
fn names_cannot_steer_the_terminal() {
    let hostile = EXPLICIT.replace("\"G2\"", "\"\\u001b[31mred\"");
    for arguments in [&["solve", "-"][..], &["trace", "-", "--plan", "a"]] {
        let ran = mo_copp(&hostile, arguments);
        assert_eq!(ran.code, 0, "{}", ran.err);
        assert!(!ran.out.contains('\u{1b}') && ran.out.contains("\\u{1b}[31mred"), "{}", ran.out);
    }
    let ran = mo_copp(
        &hostile.replace("\"true_goal\": \"G1\"", "\"true_goal\": \"G9\""),
        &["solve", "-"],
    );
    assert!(ran.code == 2 && !ran.err.contains('\u{1b}'), "{}", ran.err);
}
