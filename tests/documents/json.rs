//! What every format has in common.

use super::message;

#[test]
fn texts_that_are_too_long() {
    let message = message(&" ".repeat(33 << 20));
    assert_eq!(message, "document: found 33 MiB of text, expected at most 32 MiB");
}

#[test]
fn texts_that_are_no_documents() {
    let deep = "[".repeat(200);
    let table = [
        ("", "line 1, column 0: EOF while parsing a value"),
        ("gridworld", "line 1, column 1: expected value"),
        ("{\"format\": \"gridworld\",", "line 1, column 23: EOF while parsing a value"),
        ("{\n  \"format\": 'gridworld'\n}", "line 2, column 13: expected value"),
        ("{\"format\": \"gridworld\"} x", "line 1, column 25: trailing characters"),
        ("{\"format\": NaN}", "line 1, column 12: expected value"),
        ("{\"width\": 1e999}", "line 1, column 15: number out of range"),
        ("{\"format\": \"\\ud800\"}", "line 1, column 19: unexpected end of hex escape"),
        ("{\"a\": 1,\n\"a\": 1}", "line 2, column 3: the key \"a\" is given twice"),
        (
            "{\"format\": \"gridworld\", \"observers\": {\"adversarial\": {}, \"adversarial\": {}}}",
            "line 1, column 70: the key \"adversarial\" is given twice",
        ),
        (&deep, "line 1, column 128: recursion limit exceeded"),
        ("[]", "document: found [], expected an object"),
        ("3", "document: found 3, expected an object"),
        ("null", "document: found null, expected an object"),
        (
            "{}",
            "format: found nothing, expected gridworld, box-pushing, recycling-robot, delivery, explicit or pddl",
        ),
        (
            "{\"format\": 3}",
            "format: found 3, expected gridworld, box-pushing, recycling-robot, delivery, explicit or pddl",
        ),
        (
            "{\"format\": null}",
            "format: found null, expected gridworld, box-pushing, recycling-robot, delivery, explicit or pddl",
        ),
        (
            "{\"format\": \"chess\"}",
            "format: found \"chess\", expected gridworld, box-pushing, recycling-robot, delivery, explicit or pddl",
        ),
        (
            "{\"Format\": \"gridworld\"}",
            "format: found nothing, expected gridworld, box-pushing, recycling-robot, delivery, explicit or pddl",
        ),
    ];
    let mut wrong = Vec::new();
    for (text, expected) in table {
        let found = message(text);
        if found != expected {
            wrong.push(format!("found    {found}\nexpected {expected}"));
        }
    }
    assert!(wrong.is_empty(), "\n{}\n", wrong.join("\n"));
}
