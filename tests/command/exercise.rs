//! `mo-copp exercise` and `mo-copp grade`.

use std::fs;
use std::path::PathBuf;

use serde_json::Value;

use crate::{EXPLICIT, Ran, mo_copp};

fn text(name: &str) -> String {
    let path = format!("{}/examples/exercises/{name}.json", env!("CARGO_MANIFEST_DIR"));
    fs::read_to_string(path).unwrap()
}

const GOALS: &str = "01-possible-goals";

#[test]
fn show_prints_the_question_and_the_solution_only_where_it_is_asked_for() {
    let shown = mo_copp(&text(GOALS), &["exercise", "show", "-"]);
    assert_eq!(shown.code, 0, "{}", shown.err);
    assert_eq!(
        shown.out,
        "Two axes\n\
         The enemy is told whether a step is vertical or horizontal, and not which way it goes.\n\
         After the walk west, west, north, north: which goals are possible for the enemy?\n\
         kind: possible-goals, seed: 0\n"
    );
    let solved = mo_copp(&text(GOALS), &["exercise", "show", "-", "--solution"]);
    assert!(
        solved.out.ends_with("solution: G1, G2\ndifficulty: size 2, steps 4\n"),
        "{}",
        solved.out
    );
    let json = mo_copp(&text(GOALS), &["exercise", "show", "-", "--json"]).json();
    assert!(json.get("solution").is_none());
    assert_eq!(json["form"]["choices"].as_array().unwrap().len(), 4);
    assert!(json["document"].get("exercise").is_none());
    let json =
        mo_copp(&text(GOALS), &["exercise", "show", "-", "--json", "--solution", "--seed", "7"])
            .json();
    assert_eq!(json["seed"], 7);
    assert!(json["solution"]["answer"].is_array());
}

#[test]
fn a_variant_of_a_name_is_an_exercise_that_can_be_solved() {
    let variant = mo_copp(&text(GOALS), &["exercise", "variant", "-", "--student", "Ada"]);
    assert_eq!(variant.code, 0, "{}", variant.err);
    let document: Value = serde_json::from_str(&variant.out).unwrap();
    assert!(document["exercise"].get("vary").is_none());
    let again = mo_copp(&text(GOALS), &["exercise", "variant", "-", "--student", "Ada"]);
    assert_eq!(again.out, variant.out);
    let other = mo_copp(&text(GOALS), &["exercise", "variant", "-", "--student", "Alan"]);
    assert_ne!(other.out, variant.out);
    let shown = mo_copp(&variant.out, &["exercise", "show", "-", "--solution", "--json"]).json();
    let answer = shown["solution"]["answer"].to_string();
    let checked = mo_copp(&variant.out, &["exercise", "check", "-", "--answer", &answer]);
    assert_eq!((checked.code, checked.out.lines().next()), (0, Some("right")));
    // The problem of a document with an exercise is solved as any other.
    assert_eq!(mo_copp(&variant.out, &["solve", "-"]).code, 0);
}

#[test]
fn a_wrong_answer_ends_with_1_and_a_walk_that_shows_it() {
    let wrong = mo_copp(&text(GOALS), &["exercise", "check", "-", "--answer", "G1"]);
    assert_eq!(wrong.code, 1);
    assert!(
        wrong
            .out
            .starts_with("wrong\nG2 is possible for the enemy: the walk east, east, north, north")
    );
    let json = mo_copp(&text(GOALS), &["exercise", "check", "-", "--answer", "G1", "--json"]);
    assert_eq!(json.code, 1);
    let json = json.json();
    assert_eq!((&json["score"], &json["right"]), (&0.into(), &false.into()));
    let shown = &json["findings"][0]["counterexample"];
    assert_eq!(
        shown["symbols"],
        serde_json::json!(["horizontal", "horizontal", "vertical", "vertical"])
    );
    let refused = mo_copp(&text(GOALS), &["exercise", "check", "-", "--answer", "G9"]);
    assert_eq!(refused.code, 2);
    assert_eq!(
        refused.err,
        "mo-copp: --answer: answer[0]: found \"G9\", expected a goal of G1, G2, G3, G4\n"
    );
}

#[test]
fn what_is_no_exercise_is_refused_with_its_place() {
    let none = mo_copp(EXPLICIT, &["exercise", "show", "-"]);
    assert_eq!(none.code, 2);
    assert!(
        none.err.contains("exercise: found nothing, expected an exercise, an object with a kind"),
        "{}",
        none.err
    );
    let broken = text(GOALS).replace("\"attempts\": 3", "\"attempts\": 300");
    let refused = mo_copp(&broken, &["exercise", "show", "-"]);
    assert_eq!(refused.code, 2);
    let line = broken.lines().position(|line| line.contains("attempts")).unwrap() + 1;
    assert!(refused.err.starts_with(&format!("mo-copp: -:{line}:")), "{}", refused.err);
}

#[test]
fn show_says_what_is_wrong_with_the_variants_of_an_exercise() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/www/problems/eight-by-eight.json");
    let mut document: Value = serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap();
    document["exercise"] = serde_json::json!({"kind": "best", "vary": ["true_goal"]});
    let shown = mo_copp(&document.to_string(), &["exercise", "show", "-", "--json"]);
    assert_eq!(shown.code, 0, "{}", shown.err);
    assert_eq!(shown.err, "mo-copp: note: all 20 variants drawn ask the same question\n");
    let sample = &shown.json()["sample"];
    assert_eq!((&sample["seeds"], &sample["different"]), (&20.into(), &1.into()));
    // Not of a variant, which is what a student has.
    let variant =
        mo_copp(&document.to_string(), &["exercise", "show", "-", "--seed", "7", "--json"]);
    assert_eq!((variant.code, &variant.err[..]), (0, ""));
    assert!(variant.json().get("sample").is_none());
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/www/problems/head-fake.json");
    let mut document: Value = serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap();
    let plan =
        "north west west west west north south east east east east north north east east east";
    let plan: Vec<&str> = plan.split(' ').collect();
    document["exercise"] = serde_json::json!({"kind": "guess", "observer": "cooperative", "plan": plan,
        "vary": ["plan"]});
    let refused = mo_copp(&format!("{document:#}"), &["exercise", "show", "-"]);
    assert_eq!((refused.code, &refused.out[..]), (2, ""));
    let found = "exercise.vary: found plan, where none of 4 seeds drawn has a variant, expected ";
    assert!(
        refused.err.starts_with("mo-copp: -:") && refused.err.contains(found),
        "{}",
        refused.err
    );
}

/// Files of a test in a folder of its own.
fn file(name: &str, contents: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::write(&path, contents).unwrap();
    path
}

/// The code of an answer; of a right one where none is given.
fn code(seed: &str, answer: Option<&str>) -> String {
    let show = ["exercise", "show", "-", "--seed", seed, "--solution", "--json"];
    let solution = mo_copp(&text(GOALS), &show).json()["solution"]["answer"].to_string();
    let answer = answer.unwrap_or(&solution);
    let check = ["exercise", "check", "-", "--seed", seed, "--answer", answer, "--json"];
    mo_copp(&text(GOALS), &check).json()["code"].as_str().unwrap().to_owned()
}

fn graded(name: &str, codes: &str, more: &[&str]) -> Ran {
    let exercise = file(&format!("{name}.json"), &text(GOALS));
    let arguments = [&["grade", exercise.to_str().unwrap(), "-"], more].concat();
    mo_copp(codes, &arguments)
}

/// The rows of a table, by the names of its columns.
fn rows(table: &str) -> Vec<std::collections::HashMap<String, String>> {
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    reader.deserialize().map(Result::unwrap).collect()
}

#[test]
fn grade_checks_every_answer_again_and_gives_reasons() {
    let (right, wrong) = (code("7", None), code("7", Some("")));
    let mut edited: Vec<char> = right.chars().collect();
    edited[8] = if edited[8] == 'A' { 'B' } else { 'A' };
    let edited: String = edited.into_iter().collect();
    let check = ["exercise", "check", "-", "--answer", "[0, 0]", "--json"];
    let other = mo_copp(&text("06-camera"), &check).json()["code"].as_str().unwrap().to_owned();
    let table = format!(
        "name,code,seed,score\nAda,{right},7,100\nAlan,{wrong},7,1\nBob,{edited},7,1\nCleo,{other},,1\nDan,{right},8,1\n\
         Eve,,7,1\nFay,hello,,1\nGil,{},,1\n",
        right.to_lowercase().replace('-', "").replace('0', "o").replace('1', "l")
    );
    let ran = graded("grade", &table, &[]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let lines: Vec<&str> = ran.out.lines().collect();
    assert_eq!(
        lines[0],
        "name,code,seed,score,graded score,reason,graded seed,answer,attempts,hints"
    );
    let fields = |line: usize| -> Vec<String> {
        let mut reader =
            csv::ReaderBuilder::new().has_headers(false).from_reader(lines[line].as_bytes());
        reader.records().next().unwrap().unwrap().iter().skip(4).map(str::to_owned).collect()
    };
    assert_eq!(fields(1)[..3], ["1", "", "7"]);
    // What the table itself said of a score plays no part.
    assert_eq!(fields(2)[0], "0");
    assert!(fields(2)[1].contains("is possible for the enemy"), "{:?}", fields(2));
    assert_eq!(fields(2)[3], "");
    assert_eq!(fields(3)[..2], ["0", "the code was edited or is not complete"]);
    assert_eq!(fields(4)[..2], ["0", "the code is of another exercise"]);
    assert_eq!(
        fields(5)[..3],
        ["0", "the code is of seed 7, expected 8; the same code as in line 2", "7"]
    );
    assert_eq!(fields(6)[..2], ["0", "no answer"]);
    assert_eq!(fields(7)[..2], ["0", "no answer code"]);
    assert_eq!(fields(8)[..2], ["1", "the same code as in line 2"]);
}

#[test]
fn the_seed_may_belong_to_the_name_in_a_column() {
    let check = |name: &str| {
        let show = ["exercise", "show", "-", "--student", name, "--solution", "--json"];
        let answer = mo_copp(&text(GOALS), &show).json()["solution"]["answer"].to_string();
        let check = ["exercise", "check", "-", "--student", name, "--answer", &answer, "--json"];
        mo_copp(&text(GOALS), &check).json()["code"].as_str().unwrap().to_owned()
    };
    let table = format!("Code,Name\n{},Ada\n{},Alan\n", check("Ada"), check("Ada"));
    let ran = graded("student", &table, &["--student", "name"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let rows = rows(&ran.out);
    assert_eq!((&rows[0]["score"][..], &rows[1]["score"][..]), ("1", "0"));
    assert!(rows[1]["reason"].starts_with("the code is of seed "), "{}", rows[1]["reason"]);
}

#[test]
fn where_nothing_varies_the_seed_of_a_code_and_equal_codes_say_nothing() {
    let fixed =
        text(GOALS).replace(r#""vary": ["start", "goals", "walls", "plan"]"#, r#""vary": []"#);
    let check = ["exercise", "check", "-", "--answer", "G1,G2", "--json"];
    let code = mo_copp(&fixed, &check).json()["code"].as_str().unwrap().to_owned();
    let named = [&check[..], &["--student", "Cleo"]].concat();
    let other = mo_copp(&fixed, &named).json()["code"].as_str().unwrap().to_owned();
    assert_ne!(code, other);
    let exercise = file("fixed.json", &fixed);
    let table = format!("name,code,seed\nAda,{code},7\nBob,{code},\nCleo,{other},none\n");
    for more in [&[][..], &["--student", "name"]] {
        let ran = mo_copp(&table, &[&["grade", exercise.to_str().unwrap(), "-"], more].concat());
        assert_eq!(ran.code, 0, "{}", ran.err);
        let mut reader = csv::Reader::from_reader(ran.out.as_bytes());
        for row in reader.records().map(Result::unwrap) {
            assert_eq!((&row[3], &row[4]), ("1", ""), "{row:?}");
        }
    }
}

#[test]
fn a_table_without_codes_is_refused_with_its_line() {
    let ran = graded("without", "name,answer\nAda,G1\n", &[]);
    assert_eq!(
        (ran.code, &ran.err[..]),
        (
            2,
            "mo-copp: -:1:1: found \"name,answer\", expected a column code, or its name after --code\n"
        )
    );
    let ran = graded("column", "code,seed\nX,7\n", &["--student", "name"]);
    assert_eq!(ran.code, 2);
    assert!(ran.err.contains("expected a column name"), "{}", ran.err);
}

#[test]
fn one_broken_row_leaves_the_others_their_marks() {
    let right = code("7", None);
    let dashes = right.replace('-', "\u{2013}\u{200b}");
    let mut end = right.clone();
    let last = end.pop().unwrap();
    end.push(if last == 'Z' { 'Y' } else { 'Z' });
    let table = format!(
        "name;code;seed\nAda;{right};7\nMüller;{right};seven\nBob\nCleo;Anna;{right};7\n\nDan;{dashes};7\nEve;{end};7\n"
    );
    let exercise = file("broken-rows.json", &text(GOALS));
    // Latin 1 has no dashes but one.
    let latin = table.replace('\u{2013}', "-").replace('\u{200b}', "");
    let latin = latin.chars().map(|sign| u8::try_from(u32::from(sign)).unwrap()).collect();
    for bytes in [table.into_bytes(), latin] {
        let codes = exercise.with_file_name("broken-rows.csv");
        std::fs::write(&codes, bytes).unwrap();
        let ran = mo_copp("", &["grade", exercise.to_str().unwrap(), codes.to_str().unwrap()]);
        assert_eq!(ran.code, 0, "{}", ran.err);
        let mut reader = csv::ReaderBuilder::new().delimiter(b';').from_reader(ran.out.as_bytes());
        let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
        let said: Vec<(&str, &str, &str)> =
            rows.iter().map(|row| (&row[0], &row[3], &row[4])).collect();
        assert_eq!(
            said,
            [
                ("Ada", "1", ""),
                (
                    "Müller",
                    "0",
                    "found the seed \"seven\", expected a whole number or nothing; the same code as in line 2"
                ),
                ("Bob", "0", "the row has 1 field, expected 3"),
                ("Cleo", "0", "the row has 4 fields, expected 3"),
                ("Dan", "1", "the same code as in line 2"),
                ("Eve", "0", "the code was edited or is not complete"),
            ]
        );
    }
}

#[test]
fn a_quotation_mark_that_is_not_closed_takes_no_marks_from_the_rows_after_it() {
    let right = code("7", None);
    let table = format!("name,code,seed\n\"Ada,{right},7\nBob,{right},7\nCleo,{right},7\n");
    let ran = graded("quotation", &table, &[]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let mut reader = csv::Reader::from_reader(ran.out.as_bytes());
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let said: Vec<(&str, &str, &str)> =
        rows.iter().map(|row| (&row[0], &row[3], &row[4])).collect();
    assert_eq!(
        said,
        [
            ("\"Ada", "0", "a quotation mark in line 2 is not closed"),
            ("Bob", "1", ""),
            ("Cleo", "1", "the same code as in line 3"),
        ]
    );
}

#[test]
fn columns_that_are_added_have_names_of_their_own() {
    let (right, wrong) = (code("7", None), code("7", Some("G4,G2")));
    let table = format!("Score ,code,SEED,graded score,Hints\n5,{right},7,4,3\n5,{wrong},7,4,3\n");
    let ran = graded("names", &table, &[]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert_eq!(
        ran.out.lines().next().unwrap(),
        "Score ,code,SEED,graded score,Hints,graded score 2,reason,graded seed,answer,attempts,graded hints"
    );
    let rows_of = |table: &str| rows(table);
    let read = rows_of(&ran.out);
    assert_eq!((&read[0]["graded score 2"][..], &read[0]["graded seed"][..]), ("1", "7"));
    assert_eq!(read[1]["answer"], "G2, G4");
    // What was graded can be graded once more.
    let again = graded("names", &ran.out, &[]);
    let head: Vec<&str> = again.out.lines().next().unwrap().split(',').collect();
    let mut distinct: Vec<String> = head.iter().map(|name| name.trim().to_lowercase()).collect();
    distinct.sort_unstable();
    distinct.dedup();
    assert_eq!(distinct.len(), head.len(), "{head:?}");
    assert_eq!(rows_of(&again.out)[0]["graded score 3"], "1");
}

#[test]
fn of_two_columns_with_one_name_none_is_chosen() {
    for (head, more) in [
        ("code,Code", &[][..]),
        ("code,seed,seed", &[]),
        ("code,name,Name ", &["--student", "name"]),
    ] {
        let ran = graded("twice", &format!("{head}\nX,Y,Z\n"), more);
        assert_eq!(ran.code, 2, "{head}");
        assert!(ran.err.starts_with("mo-copp: -:1:1: found 2 columns "), "{}", ran.err);
    }
}

#[test]
fn two_stray_quotation_marks_swallow_no_row() {
    let right = code("7", None);
    let said = |table: &str| -> Vec<(String, String, String)> {
        let ran = graded("stray", table, &[]);
        assert_eq!(ran.code, 0, "{}", ran.err);
        let mut reader = csv::Reader::from_reader(ran.out.as_bytes());
        let head = reader.headers().unwrap().clone();
        let [name, score, reason] = ["name", "score", "reason"]
            .map(|wanted| head.iter().position(|name| name == wanted).unwrap());
        let rows = reader.records().map(Result::unwrap);
        rows.map(|row| (row[name].to_owned(), row[score].to_owned(), row[reason].to_owned()))
            .collect()
    };
    let row = |name: &str, score: &str, reason: &str| {
        (name.to_owned(), score.to_owned(), reason.to_owned())
    };
    let open = row("\"Ada", "0", "a quotation mark in line 2 is not closed");
    let table = format!("name,code\n\"Ada,{right}\nBob,{right}\nCleo\",{right}\nDan,{right}\n");
    let rest = [
        row("Bob", "1", ""),
        row("Cleo\"", "1", "the same code as in line 3"),
        row("Dan", "1", "the same code as in line 3"),
    ];
    assert_eq!(said(&table), [&[open.clone()][..], &rest].concat());
    // Rows without an answer are rows as well.
    let table = format!("name,code\n\"Ada,{right}\nBob,\nCleo,\"\nDan,{right}\n");
    assert_eq!(said(&table)[1], row("Bob", "0", "no answer"));
    assert_eq!(said(&table).len(), 4);
    // The code may stand before the field in which the mark is.
    let table = format!("code,name\n{right},\"Ada\n{right},Bob\n{right},Cleo\"\n");
    assert_eq!(said(&table).len(), 3);
    let table = format!("code,name\n{right},\"Ada\n{right},Cleo\"\n");
    assert_eq!(said(&table).len(), 2);
    // A field of several lines is one, whatever commas are in it, and whether the code comes before or after.
    for table in [
        format!("name,text,code\nAda,\"first, one\nsecond\nand, so, on\",{right}\n"),
        format!("name,code,text\nAda,{right},\"first\nsecond, third\"\n"),
        format!("name,code,text\nAda,\"{right}\n\",\"first\"\n"),
    ] {
        let read = said(&table);
        assert_eq!((read.len(), &read[0].1[..]), (1, "1"), "{table}");
    }
    // What cannot be told apart keeps its mark and is named.
    let table = format!("name,code\n\"Ada,hm\nBob,dunno\nCleo\",{right}\n");
    let read = said(&table);
    assert_eq!((read.len(), &read[0].1[..]), (1, "1"));
    assert_eq!(
        read[0].2,
        "a quotation mark in line 2 is closed in line 4; if these lines are rows, it is a stray one"
    );
}

#[test]
fn codes_are_read_out_of_what_forms_and_spreadsheets_put_around_them() {
    let right = code("7", None);
    let wide: Vec<u8> =
        format!("name,code\nAda,{right}\n").encode_utf16().flat_map(u16::to_be_bytes).collect();
    for (name, table) in [
        ("formula", format!("name;code\r\nAda;=\"{right}\"\r\n").into_bytes()),
        ("quoted formula", format!("name;code\r\nAda;\"=\"\"{right}\"\"\"\r\n").into_bytes()),
        ("named separator", format!("sep=;\r\nname;code\r\nAda;{right}\r\n").into_bytes()),
        ("markup", format!("name,code\nAda,<p>{right}</p>\n").into_bytes()),
        ("blank", format!("name,code\nAda,{right}&nbsp;\n").into_bytes()),
        ("words", format!("name,code\nAda,code: {right}.\n").into_bytes()),
        ("apostrophe", format!("name,code\nAda,'{right}\n").into_bytes()),
        ("UTF-16 without a mark", wide),
        ("zeros", format!("name,code\nA\0da,{right}\n").into_bytes()),
    ] {
        let exercise = file("wrapped.json", &text(GOALS));
        let codes = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("wrapped.csv");
        fs::write(&codes, table).unwrap();
        let ran = mo_copp("", &["grade", exercise.to_str().unwrap(), codes.to_str().unwrap()]);
        assert_eq!(ran.code, 0, "{name}: {}", ran.err);
        let line = ran.out.lines().last().unwrap();
        assert!(line.contains(",1,,7,") || line.contains(";1;;7;"), "{name}: {}", ran.out);
        assert!(!ran.out.contains('\0'), "{name}");
    }
}

#[test]
fn what_is_no_code_is_not_called_the_same_and_more_attempts_than_there_are_are_remarked() {
    let right = code("7", None);
    let other = code("8", None);
    let table =
        format!("code\n-\n-\nn/a\n\u{2013}\ndone\ndone\n{right} {other}\n{right}\n{right}\n");
    let ran = graded("nothing", &table, &[]);
    let reasons: Vec<String> = rows(&ran.out).iter().map(|row| row["reason"].clone()).collect();
    assert_eq!(
        reasons,
        [
            "no answer",
            "no answer",
            "no answer",
            "no answer",
            "no answer code",
            "no answer code",
            "more than one code, of which none is chosen",
            "",
            "the same code as in line 9"
        ]
    );
    // The exercise has three attempts; the code was made where it had more.
    let one = text(GOALS).replace("\"attempts\": 3", "\"attempts\": 1");
    assert_ne!(one, text(GOALS));
    let exercise = file("attempts.json", &one);
    let document = mo_copp::exercise::Exercise::parse(&text(GOALS)).unwrap();
    let variant = document.variant(7).unwrap();
    let tally = mo_copp::exercise::Tally { attempts: 2, hints: 0 };
    let table = format!("code\n{}\n", document.code(&variant, variant.solution(), tally));
    let ran = mo_copp(&table, &["grade", exercise.to_str().unwrap(), "-"]);
    let row = &rows(&ran.out)[0];
    assert_eq!((&row["score"][..], &row["attempts"][..]), ("1", "2"));
    assert_eq!(row["reason"], "the code tells of 2 attempts, the exercise has 1");
    // An exercise without hints shows none.
    let mut without: serde_json::Value = serde_json::from_str(&text(GOALS)).unwrap();
    without["exercise"]["hints"] = serde_json::json!([]);
    let exercise = file("hints.json", &without.to_string());
    let tally = mo_copp::exercise::Tally { attempts: 1, hints: 1 };
    let table = format!("code\n{}\n", document.code(&variant, variant.solution(), tally));
    let ran = mo_copp(&table, &["grade", exercise.to_str().unwrap(), "-"]);
    assert_eq!(rows(&ran.out)[0]["reason"], "the code tells of 1 hint, the exercise has 0");
}

/// As Moodle exports the answers of a quiz: no column is called code, and one has them.
#[test]
fn codes_are_found_in_the_only_column_that_has_any_or_in_the_one_that_is_named() {
    let exercise = mo_copp::exercise::Exercise::parse(&text(GOALS)).unwrap();
    let code = |seed| {
        let variant = exercise.variant(seed).unwrap();
        exercise.code(&variant, variant.solution(), mo_copp::exercise::Tally::default())
    };
    let document = file("moodle.json", &text(GOALS));
    let document = document.to_str().unwrap();
    let table = format!(
        "Surname,\"First name\",Status,\"Response 1\"\nLovelace,Ada,Finished,{}\nTuring,Alan,Finished,-\n",
        code(3)
    );
    let ran = mo_copp(&table, &["grade", document, "-"]);
    let reasons: Vec<_> = rows(&ran.out).iter().map(|row| row["reason"].clone()).collect();
    assert_eq!(reasons, ["", "no answer"], "{}", ran.err);
    // Two columns have codes: which of them is meant, nothing says.
    let both = format!("first,second\n{},{}\n", code(3), code(4));
    let ran = mo_copp(&both, &["grade", document, "-"]);
    assert_eq!(ran.code, 2);
    let refused = "found codes in 2 columns, first and second, expected a column code, or its name after --code";
    assert!(ran.err.contains(refused), "{}", ran.err);
    assert_eq!(ran.out, "");
    // One code a row, now here and now there.
    let scattered = format!("name,Answer,Old\nAda,{},-\nAlan,-,{}\n", code(3), code(4));
    let ran = mo_copp(&scattered, &["grade", document, "-"]);
    assert!(ran.err.contains("2 columns, Answer and Old"), "{}", ran.err);
    let ran = mo_copp(&both, &["grade", document, "-", "--code", "second"]);
    assert_eq!(rows(&ran.out)[0]["seed"], "4");
    let ran = mo_copp(&both, &["grade", document, "-", "--code", "third"]);
    assert!(ran.err.contains("found \"first,second\", expected a column third"), "{}", ran.err);
}
