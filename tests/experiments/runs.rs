//! What runs record.

use std::sync::atomic::{AtomicBool, Ordering};

use mo_copp::domain::Document;
use mo_copp::domain::generate::Domain;
use mo_copp::experiment::output::markdown;
use mo_copp::experiment::{Event, InitialBeliefs, Setting, Shard, Summary, run};
use serde_json::Value;

use super::{blocks, fig3, fig4, folder, jobs, open, records, work};

const WHOLE: Shard = Shard::WHOLE;

/// The record of a solver on a problem.
fn of<'a>(records: &'a [Value], problem: u32, solver: &str) -> &'a Value {
    let found = records.iter().find(|r| r["problem"] == problem && r["solver"] == solver);
    found.unwrap_or_else(|| panic!("{solver} on {problem}"))
}

#[test]
fn the_same_seed_gives_the_same_records_whatever_the_jobs() {
    let folder = folder("jobs");
    for setting in [fig3(3), fig4(3)] {
        let one = folder.join(format!("{}-1.jsonl", setting.figure.name()));
        let three = folder.join(format!("{}-3.jsonl", setting.figure.name()));
        work(&one, &setting, WHOLE, 1);
        work(&three, &setting, WHOLE, 3);
        let found = records(&one, &setting, WHOLE);
        assert_eq!(found, records(&three, &setting, WHOLE));
        assert!(found.len() >= 12);
    }
}

#[test]
fn the_integer_program_and_the_exact_solver_agree_and_nothing_beats_the_optimum() {
    let setting = fig3(6);
    let path = folder("agree").join("records.jsonl");
    work(&path, &setting, WHOLE, 2);
    let found = records(&path, &setting, WHOLE);
    for problem in 1..=6 {
        let difference = |solver| of(&found, problem, solver)["goal_difference"].as_f64();
        assert_eq!(difference("ip"), difference("exact"));
        for solver in ["baseline", "ip", "search", "satisficing"] {
            assert!(difference(solver) <= difference("exact-any"), "{solver} {problem}");
        }
        for solver in ["ip", "exact", "exact-any"] {
            assert_eq!(of(&found, problem, solver)["status"], "optimal");
        }
        for solver in ["ip", "exact"] {
            let length = of(&found, problem, solver)["length"].as_u64().unwrap();
            assert!(length >= 12 && length.is_multiple_of(2), "horizon 12, raised by 2: {length}");
        }
        let search = of(&found, problem, "search");
        assert_eq!(search["options"], serde_json::json!({"k": 2, "j": 2, "expansions": 50_000}));
        assert!(search["goals"]["adversarial"].as_array().unwrap().len() >= 2);
        assert!(search["goals"]["cooperative"].as_array().unwrap().len() <= 2);
        assert_eq!(search["seed"], problem);
    }
}

#[test]
fn the_exact_solver_up_to_a_horizon_takes_the_best_of_all_lengths() {
    let setting = fig4(4);
    let path = folder("up-to").join("records.jsonl");
    work(&path, &setting, WHOLE, 2);
    let found = records(&path, &setting, WHOLE);
    for problem in 1..=4 {
        let document = Domain::Delivery.draw(u64::from(problem)).unwrap().document;
        let best = best(&document);
        let exact = of(&found, problem, "exact-up-to");
        // Every plan of a delivery has three actions.
        assert_eq!((&exact["status"], &exact["length"]), (&"optimal".into(), &3.into()));
        assert_eq!(exact["goal_difference"].as_f64(), best);
        assert_eq!(exact["options"]["horizon"], 3);
        for solver in ["search", "satisficing", "obfuscate", "legible"] {
            let record = of(&found, problem, solver);
            assert!(record["goal_difference"].as_f64() <= best, "{solver}");
            let bounds = (&record["options"]["k"], &record["options"]["j"]);
            let three = &Value::from(3);
            let expected = match solver {
                "search" | "satisficing" => (three, three),
                "obfuscate" => (three, &Value::Null),
                _ => (&Value::Null, three),
            };
            assert_eq!(bounds, expected);
        }
    }
}

fn best(document: &Document) -> Option<f64> {
    use mo_copp::solver::{Options, Solver, solve};
    use std::ops::ControlFlow;
    let problem = std::sync::Arc::new(document.problem().unwrap());
    let outcome = solve(problem, Options::new(Solver::Exact), |_| ControlFlow::Continue(()));
    outcome.unwrap().goal_difference
}

#[test]
fn a_horizon_without_a_plan_is_raised_by_two_and_the_lengths_between_are_tried() {
    let mut setting = fig4(2);
    setting.domains[0].horizon = 0;
    let path = folder("raised").join("records.jsonl");
    work(&path, &setting, WHOLE, 1);
    let found = records(&path, &setting, WHOLE);
    let exact = of(&found, 1, "exact-up-to");
    // 0, 2 and then 4, below which there is a plan of 3 actions.
    assert_eq!((&exact["status"], &exact["length"]), (&"optimal".into(), &3.into()));
    assert_eq!(exact["options"]["horizon"], 0);
}

#[test]
fn a_limit_is_recorded_as_what_it_is() {
    let mut setting = fig3(2);
    setting.limits.exact_expansions = 3;
    setting.limits.paper_nodes = Some(1);
    setting.limits.paper_nonzeros = 100;
    let path = folder("limits").join("records.jsonl");
    work(&path, &setting, WHOLE, 2);
    let found = records(&path, &setting, WHOLE);
    for problem in 1..=2 {
        let exact = of(&found, problem, "exact-any");
        assert_eq!(exact["limit"], "expansion limit reached: 3");
        let paper = of(&found, problem, "ip-paper");
        assert_eq!(paper["status"], "limit");
        assert_eq!(paper["plan"], Value::Null);
        let limit = paper["limit"].as_str().unwrap();
        assert!(limit.starts_with("model limit reached"), "{limit}");
    }
}

/// A job that needs more than its share of the memory is done again with a greater one, so its
/// record does not depend on how many jobs there are at a time.
#[test]
fn the_memory_limit_does_not_depend_on_the_jobs() {
    let mut setting = fig3(2);
    setting.limits.memory_mib = 1;
    let folder = folder("memory");
    let (alone, many) = (folder.join("1.jsonl"), folder.join("500.jsonl"));
    work(&alone, &setting, WHOLE, 1);
    // With 500 at a time each has 2 kB.
    let mut file = open(&many, &setting, WHOLE).unwrap();
    let put_off = AtomicBool::new(false);
    let report = |event: Event<'_>| {
        if matches!(event, Event::PutOff(_)) {
            put_off.store(true, Ordering::SeqCst);
        }
    };
    let stop = AtomicBool::new(false);
    assert!(run(&setting, &jobs(&setting, WHOLE), 500, &mut file, &stop, &report).unwrap());
    drop(file);
    assert!(put_off.load(Ordering::SeqCst), "the test should meet the limit");
    assert_eq!(records(&alone, &setting, WHOLE), records(&many, &setting, WHOLE));
}

#[test]
fn a_stopped_run_keeps_its_records_and_goes_on() {
    let setting = fig3(4);
    let folder = folder("stopped");
    let (whole, path) = (folder.join("whole.jsonl"), folder.join("records.jsonl"));
    work(&whole, &setting, WHOLE, 1);
    let jobs = jobs(&setting, WHOLE);
    let mut file = open(&path, &setting, WHOLE).unwrap();
    let stop = AtomicBool::new(false);
    let report = |event: Event<'_>| {
        if let Event::Recorded(job) = event {
            stop.store(job.place >= 6, Ordering::SeqCst);
        }
    };
    assert!(!run(&setting, &jobs, 1, &mut file, &stop, &report).unwrap());
    assert_eq!(file.entries().len(), 7);
    drop(file);
    assert_eq!(work(&path, &setting, WHOLE, 2), jobs.len() - 7);
    assert_eq!(records(&path, &setting, WHOLE), records(&whole, &setting, WHOLE));
}

#[test]
fn a_time_limit_is_recorded_as_one() {
    let mut setting = fig3(1);
    setting.limits.seconds = Some(0);
    let path = folder("time").join("records.jsonl");
    work(&path, &setting, WHOLE, 1);
    let found = records(&path, &setting, WHOLE);
    let met = found.iter().filter(|record| record["limit"] == "time limit reached: 0 s");
    assert!(met.count() >= 1);
}

/// Observers with beliefs of their own: the file says so, and is no part of a run without.
#[test]
fn initial_beliefs_that_are_drawn_are_another_run() {
    let known = blocks(2);
    let drawn = Setting { beliefs: InitialBeliefs::Drawn, ..known.clone() };
    let folder = folder("beliefs");
    let path = folder.join("records.jsonl");
    work(&path, &drawn, WHOLE, 2);
    let found = records(&path, &drawn, WHOLE);
    assert_eq!(found.len(), 2 * drawn.configurations().len());
    let header = std::fs::read_to_string(&path).unwrap();
    assert!(header.lines().next().unwrap().contains("\"initial_beliefs\":\"drawn\""));
    let error = open(&path, &known, WHOLE).unwrap_err().to_string();
    assert!(error.contains("initial beliefs drawn"), "{error}");
    let summary = Summary::new(&drawn, open(&path, &drawn, WHOLE).unwrap().entries());
    assert!(markdown(&summary).starts_with(
        "Mean ± standard deviation; 2 problems of each domain, seeds from 1, initial beliefs drawn \
         for each observer by itself."
    ));
}
