//! What every format has in common.

use mo_copp::limits::MAX_VALUES;

use super::message;

#[test]
fn texts_that_are_too_long() {
    let message = message(&" ".repeat((32 << 20) + 1));
    let expected =
        "document: found 33,554,433 bytes of text, expected at most 32 MiB (33,554,432 bytes)";
    assert_eq!(message, expected);
}

#[test]
fn texts_of_too_many_values() {
    let lists = |count: usize| format!("[\n{}[]]", "[0],".repeat(count));
    // Two values a list, and the outer list and its last item.
    let most = (MAX_VALUES - 2) / 2;
    assert!(message(&lists(most)).starts_with("document: found [[0], "), "as many as are allowed");
    let column = 4 * most + 1;
    assert_eq!(
        message(&lists(most + 1)),
        format!(
            "line 2, column {column}: found more than {MAX_VALUES} values, expected at most that"
        )
    );
}

/// Holds each text's message against the one expected.
fn check(table: &[(&str, &str)]) {
    let mut wrong = Vec::new();
    for (text, expected) in table {
        let found = message(text);
        if found != *expected {
            wrong.push(format!("found    {found}\nexpected {expected}"));
        }
    }
    assert!(wrong.is_empty(), "\n{}\n", wrong.join("\n"));
}

#[test]
fn texts_that_end_too_soon() {
    check(&[
        (
            "",
            "line 1, column 1: found the end of the text, expected a value: a text in double quotes, a number, a list, an object, true, false or null",
        ),
        (
            "\n \n",
            "line 3, column 1: found the end of the text, expected a value: a text in double quotes, a number, a list, an object, true, false or null",
        ),
        (
            "{\"format\": \"gridworld\",",
            "line 1, column 24: found the end of the text, expected another entry after the comma",
        ),
        (
            "{\"format\": \"gridworld\"",
            "line 1, column 23: found the end of the text, expected a comma or “}”",
        ),
        (
            "{\"format\": \"grid",
            "line 1, column 17: found the end of the text, expected a double quote that ends the text begun before",
        ),
        (
            "{\"walls\": [1, 2",
            "line 1, column 16: found the end of the text, expected a comma or “]”",
        ),
    ]);
}

#[test]
fn texts_that_are_not_json() {
    let deep = "[".repeat(200);
    check(&[
        (
            "gridworld",
            "line 1, column 1: found “gridworld”, expected a value: a text in double quotes, a number, a list, an object, true, false or null",
        ),
        (
            "{\n  \"format\": 'gridworld'\n}",
            "line 2, column 13: found “'gridworld'”, expected a value: a text in double quotes, a number, a list, an object, true, false or null",
        ),
        (
            "{\"format\": \"gridworld\"} x",
            "line 1, column 25: found “x” after the document, expected the end of the text",
        ),
        (
            "{\"format\": NaN}",
            "line 1, column 12: found “NaN”, expected a value: a text in double quotes, a number, a list, an object, true, false or null",
        ),
        (
            "{\"stay\": True}",
            "line 1, column 10: found “True”, expected a value: a text in double quotes, a number, a list, an object, true, false or null",
        ),
        (
            "{\"stay\": truth}",
            "line 1, column 13: found “truth”, expected a value: a text in double quotes, a number, a list, an object, true, false or null",
        ),
        ("{format: 3}", "line 1, column 2: found “format”, expected a key in double quotes"),
        ("{\"format\" 3}", "line 1, column 11: found “3”, expected a colon between key and value"),
        ("{\"walls\": [1 2]}", "line 1, column 14: found “2”, expected a comma or “]”"),
        (
            "{\"ü\": 1,\n \"ä\": \"ö\" \"b\": 2}",
            "line 2, column 11: found “\"b\"”, expected a comma or “}”",
        ),
        (
            "{\"format\": 3,}",
            "line 1, column 14: found “}” after a comma, expected another entry, or no comma",
        ),
        ("[1,]", "line 1, column 4: found “]” after a comma, expected another entry, or no comma"),
        ("{\"width\": 8.}", "line 1, column 13: found “}”, expected a number such as 3 or 0.5"),
        ("{\"width\": 08}", "line 1, column 12: found “08”, expected a number such as 3 or 0.5"),
        (
            "{\"width\": 1e999}",
            "line 1, column 15: found a number that is too large, expected one below 10 to the 308th",
        ),
        (
            "{\"format\": \"grid\nworld\"}",
            "line 1, column 17: found a line break or a tab inside of a text in double quotes, expected the double quote that ends it, or \\n and \\t",
        ),
        (
            "{\"format\": \"\\q\"}",
            "line 1, column 14: found a backslash that means nothing here, expected one of \\\" \\\\ \\/ \\b \\f \\n \\r \\t or \\u with four digits",
        ),
        (
            "{\"format\": \"\\ud800\"}",
            "line 1, column 19: found half of a character, written with \\u, expected a whole character",
        ),
        (
            "{\"a\": 1,\n\"a\": 1}",
            "line 2, column 3: found the key \"a\" for the second time, expected each key once",
        ),
        (
            "{\"format\": \"gridworld\", \"observers\": {\"adversarial\": {}, \"adversarial\": {}}}",
            "line 1, column 70: found the key \"adversarial\" for the second time, expected each key once",
        ),
        (
            &deep,
            "line 1, column 128: found lists and objects too deep inside of each other, expected at most 127 levels",
        ),
    ]);
}

#[test]
fn texts_that_are_no_documents() {
    check(&[
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
    ]);
}
