//! Import of goal-recognition problems: files as they occur, and broken ones.

use mo_copp::domain::Document;
use mo_copp::domain::pddl::import::{ImportFile, ImportOptions, Imported, import};
use mo_copp::domain::pddl::{Pddl, PddlSensor};

use crate::common::Dice;

const DOMAIN: &str = "(define (domain Towers) (:requirements :strips)\n (:predicates (on ?x ?y) (clear ?x) (table ?x))
 (:action stack :parameters (?x ?y) :precondition (and (clear ?x) (clear ?y) (table ?x))
  :effect (and (on ?x ?y) (not (clear ?y)) (not (table ?x))))
 (:action wait :effect (and)))";
const TEMPLATE: &str = "(define (problem p) (:domain towers)\n (:objects a b c)\n (:init (clear a) (clear b) (clear c) (table a) (table b) (table c))\n (:goal (and\n<HYPOTHESIS>\n)))";
const HYPS: &str = "(ON A B),(CLEAR A)\n(on b c), (on a b)\n(on c a)\n";
const REAL: &str = "(on a b), (on b c)\n";
const OBS: &str = "(STACK B C)\n(STACK A B)\n";

fn files() -> Vec<ImportFile> {
    [
        ("p01/domain.pddl", DOMAIN),
        ("p01/template.pddl", TEMPLATE),
        ("p01/hyps.dat", HYPS),
        ("p01/real_hyp.dat", REAL),
        ("p01/obs.dat", OBS),
    ]
    .map(|(name, text)| ImportFile { name: name.to_owned(), text: text.to_owned() })
    .into()
}

/// The files with another text in one of them.
fn with(name: &str, text: &str) -> Vec<ImportFile> {
    let mut files = files();
    let changed = files.iter_mut().find(|file| file.name.ends_with(name)).unwrap();
    text.clone_into(&mut changed.text);
    files
}

fn without(name: &str) -> Vec<ImportFile> {
    files().into_iter().filter(|file| !file.name.ends_with(name)).collect()
}

fn imported(files: &[ImportFile]) -> Imported {
    import(files, &ImportOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

fn error(files: &[ImportFile]) -> String {
    import(files, &ImportOptions::default()).unwrap_err().to_string()
}

fn conditions(document: &Pddl) -> Vec<&str> {
    document.goals.iter().map(|goal| goal.condition.as_str()).collect()
}

/// The document is one that is read again, and makes a problem.
fn loads(document: Pddl) {
    let document = Document::from(document);
    assert_eq!(Document::parse(&document.to_json()).unwrap(), document);
    document.problem().unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn a_problem_as_it_should_be() {
    let found = imported(&files());
    let document = found.document;
    let goals = ["(and (on a b) (clear a))", "(and (on b c) (on a b))", "(on c a)"];
    assert_eq!(conditions(&document), goals);
    assert_eq!(document.true_goal, "G2");
    assert_eq!(document.observers.adversarial.sensor, PddlSensor::names());
    // One action has no argument for the friend to see.
    let PddlSensor::Rules(rules) = &document.observers.cooperative.sensor else { panic!() };
    let symbols: Vec<&str> = rules.iter().map(|rule| rule.symbol.as_str()).collect();
    assert_eq!(symbols, ["{name} {1}", "{name}"]);
    assert_eq!(found.observations.unwrap(), ["(stack b c)", "(stack a b)"]);
    assert!(found.notes.is_empty());
    loads(document);
}

#[test]
fn sloppy_files_are_read() {
    let hyps = [
        // Blank lines, line ends of another system, a mark of the encoding, comments.
        "\u{feff}\r\n(ON A B),(CLEAR A)\r\n\r\n(on b c), (on a b)\r\n; none\n(on c a)",
        // Without commas, with `and`, with commas inside of it and a comma at the end.
        "(on a b) (clear a)\n(and (on b c) (on a b))\n(AND (on c, a)),\n",
        // Without parentheses.
        "on a b, clear a\n on  b c ,ON A B,\non c a\n",
        "((on a b))",
    ];
    for text in &hyps[..3] {
        let found = imported(&with("hyps.dat", text));
        let goals = ["(and (on a b) (clear a))", "(and (on b c) (on a b))", "(on c a)"];
        assert_eq!(conditions(&found.document), goals, "{text:?}");
        assert_eq!(found.document.true_goal, "G2");
        loads(found.document);
    }
    assert!(
        error(&with("hyps.dat", hyps[3])).starts_with("p01/hyps.dat:1:1: found"),
        "{}",
        error(&with("hyps.dat", hyps[3]))
    );
    // The same hypothesis twice: names keep the numbers of the file.
    let twice = "(on c a)\n(on b c), (on c a)\n(on c a)\n(on a b),(on b c)";
    let found = imported(&with("hyps.dat", twice));
    let names: Vec<&str> = found.document.goals.iter().map(|goal| goal.name.as_str()).collect();
    assert_eq!(names, ["G1", "G2", "G4"]);
    assert_eq!(
        found.notes,
        ["p01/hyps.dat:3: the hypothesis of line 1 for a second time is left out"]
    );
    // A goal with more in it, files in other folders and letters, line ends in the domain.
    let more = TEMPLATE.replace("<HYPOTHESIS>", "(clear c) <hypothesis>");
    let found = imported(&with("template.pddl", &more));
    assert_eq!(conditions(&found.document)[2], "(and (clear c) (on c a) )");
    loads(found.document);
    let mut files = with("domain.pddl", &DOMAIN.replace('\n', "\r\n"));
    files[0].name = "DOMAIN.PDDL".to_owned();
    loads(imported(&files).document);
    let found = imported(&without("obs.dat"));
    assert_eq!(found.observations, None);
}

#[test]
fn options_choose_what_the_files_leave_open() {
    let options = ImportOptions {
        true_goal: Some(3),
        cooperative_sensor: "{2} under {1}".to_owned(),
        adversarial_groups: vec![("block".to_owned(), vec!["a".to_owned(), "b".to_owned()])],
        ..ImportOptions::default()
    };
    // The real hypothesis is not needed then.
    let found = import(&without("real_hyp.dat"), &options).unwrap();
    assert_eq!(found.document.true_goal, "G3");
    let PddlSensor::Rules(rules) = &found.document.observers.cooperative.sensor else { panic!() };
    assert_eq!(rules[1].symbol, "under");
    loads(found.document);
    let wrong = |options: &ImportOptions| import(&files(), options).unwrap_err().to_string();
    assert_eq!(
        wrong(&ImportOptions { true_goal: Some(4), ..options.clone() }),
        "true-goal: found 4, expected a number from 1 to 3, which is how many hypotheses there are"
    );
    assert_eq!(
        wrong(&ImportOptions { adversarial_sensor: "{?x}".to_owned(), ..options }),
        "adversarial-sensor: found the placeholder {?x}, expected {name}, {arguments}, {1}, {2}, …, since no pattern names arguments here"
    );
}

#[test]
fn what_cannot_be_read_has_its_place() {
    let table = [
        (
            with("domain.pddl", "(define (domain d) (:derived (x) (y)))"),
            "p01/domain.pddl:1:20: found",
        ),
        (
            with("template.pddl", &TEMPLATE.replace("(clear c)", "(clear d)")),
            "p01/template.pddl:3:36: found the undeclared object \"d\"",
        ),
        // Behind the goal places are those of the file as well.
        (
            with("template.pddl", &TEMPLATE.replace(")))", ")) (:gaol))")),
            "p01/template.pddl:6:3: found \":gaol\"",
        ),
        (
            with("template.pddl", &TEMPLATE.replace("<HYPOTHESIS>", "(on a b)")),
            "p01/template.pddl:4:3: found a goal without <HYPOTHESIS>, expected (:goal (and <HYPOTHESIS>))",
        ),
        (
            with("template.pddl", "(define (problem p) (:domain towers))"),
            "p01/template.pddl:1:38: found no goal",
        ),
        (
            with("template.pddl", &TEMPLATE.replace("<HYPOTHESIS>", "<HYPOTHESIS> <HYPOTHESIS>")),
            "p01/template.pddl:5:14: found <HYPOTHESIS> for the second time, expected one",
        ),
        (
            with("hyps.dat", "(on a b)\n(on a\n"),
            "p01/hyps.dat:2:6: found the end of the line, expected \")\" for each \"(\" of the line",
        ),
        (with("hyps.dat", "(on a b)\n(on b a)), (on c a)\n"), "p01/hyps.dat:2:9: found \")\""),
        (
            with("hyps.dat", "(on a b)\n(on b a), on c a\n"),
            "p01/hyps.dat:2:11: found 'o' between atoms, expected atoms in parentheses",
        ),
        (
            with("hyps.dat", "(on a b)\n(on b a),  (on c d)\n"),
            "p01/hyps.dat:2:18: found the undeclared object \"d\"",
        ),
        (
            with("hyps.dat", "(on a b)\non b a,  on c d\n"),
            "p01/hyps.dat:2:15: found the undeclared object \"d\"",
        ),
        (
            with("hyps.dat", "(on a b)\n(in b a)\n"),
            "p01/hyps.dat:2:2: found the undeclared predicate \"in\"",
        ),
        (
            with("hyps.dat", "\n"),
            "p01/real_hyp.dat:1:1: found (and (on a b) (on b c)), expected one of the 0 hypotheses",
        ),
        (
            with("hyps.dat", "(on a b),(on b c)\n(on b c),(on a b)"),
            "p01/hyps.dat: found 1 different hypotheses, expected 2 at least",
        ),
        (
            with("real_hyp.dat", "\n(on b a)\n"),
            "p01/real_hyp.dat:2:1: found (on b a), expected one of the 3 hypotheses of hyps.dat",
        ),
        (
            with("real_hyp.dat", "(on c a)\n(on b a)\n"),
            "p01/real_hyp.dat:2:1: found a second real hypothesis, expected one",
        ),
        (
            with("real_hyp.dat", ""),
            "p01/real_hyp.dat: found nothing in it, expected the real hypothesis, or the option true-goal",
        ),
        (without("real_hyp.dat"), "real_hyp.dat: found no such file, expected the real hypothesis"),
        (
            without("hyps.dat"),
            "hyps.dat: found no such file, expected the files of a goal-recognition problem",
        ),
    ];
    for (files, expected) in table {
        let found = error(&files);
        assert!(found.starts_with(expected), "found    {found}\nexpected {expected}");
    }
    let mut two = files();
    two.push(ImportFile { name: "p02/hyps.dat".to_owned(), text: HYPS.to_owned() });
    assert_eq!(
        error(&two),
        "p02/hyps.dat: found a second hyps.dat beside p01/hyps.dat, expected the files of one problem"
    );
}

/// Whatever is cut out, put in or turned around: no panic, and what is imported is a document.
#[test]
fn broken_files_do_no_harm() {
    let mut dice = Dice::new(5);
    let pieces = [
        "(",
        ")",
        ",",
        "\n",
        "\r\n",
        ";",
        "?",
        "<HYPOTHESIS>",
        "(and",
        ":goal",
        "é",
        "\u{feff}",
        "not",
        "(:goal",
        "\t",
    ];
    let mut fine = 0;
    for _ in 0..3000 {
        let mut files = files();
        for _ in 0..dice.between(1, 3) {
            let number = dice.below(files.len());
            let mut characters: Vec<char> = files[number].text.chars().collect();
            let at = dice.below(characters.len() + 1);
            match dice.below(4) {
                0 => {
                    let end = (at + dice.below(20)).min(characters.len());
                    characters.drain(at..end);
                }
                1 => {
                    characters.splice(at..at, dice.pick(&pieces).chars());
                }
                2 => {
                    let other = dice.below(characters.len().max(1));
                    if at < characters.len() && other < characters.len() {
                        characters.swap(at, other);
                    }
                }
                _ => characters.truncate(at),
            }
            files[number].text = characters.into_iter().collect();
        }
        if let Ok(found) = import(&files, &ImportOptions::default()) {
            fine += 1;
            let document = Document::from(found.document);
            assert_eq!(Document::parse(&document.to_json()).unwrap(), document);
        }
    }
    assert!(fine > 100, "{fine}");
}

/// Every problem of a collection, where the environment names its folder.
#[test]
fn every_problem_of_a_collection_loads() {
    let Some(folder) = std::env::var_os("MO_COPP_GOAL_RECOGNITION") else {
        println!("passed over: MO_COPP_GOAL_RECOGNITION names no folder of problems");
        return;
    };
    let mut loaded = 0;
    let mut open = vec![std::path::PathBuf::from(folder)];
    while let Some(folder) = open.pop() {
        let paths: Vec<_> =
            std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()).collect();
        open.extend(paths.iter().filter(|path| path.is_dir()).cloned());
        if !folder.join("template.pddl").is_file() {
            continue;
        }
        let file = |path: &std::path::PathBuf| ImportFile {
            name: path.display().to_string(),
            text: std::fs::read_to_string(path).unwrap(),
        };
        let files: Vec<_> = paths.iter().filter(|path| path.is_file()).map(file).collect();
        loads(imported(&files).document);
        loaded += 1;
    }
    assert!(loaded > 0);
    println!("{loaded} problems");
}
