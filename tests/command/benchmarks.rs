//! `mo-copp experiment benchmarks`: what is found below a folder, what is recorded, going on and shards.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::import::{FILES, bzipped, tarred};
use crate::{DELIVERY, EXPLICIT, GRID, Ran, mo_copp};

/// An empty folder.
fn empty(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("benchmarks").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn layout(folder: &Path, left_out: &str) {
    fs::create_dir_all(folder).unwrap();
    for (name, text) in FILES.iter().filter(|(name, _)| *name != left_out) {
        fs::write(folder.join(name), text).unwrap();
    }
}

/// A folder with problems of every kind, some of which cannot be read.
fn problems(name: &str) -> PathBuf {
    let folder = empty(name).join("problems");
    layout(&folder.join("towers/full/p1"), "");
    layout(&folder.join("towers/part/broken"), "hyps.dat");
    layout(&folder.join(".hidden/p1"), "");
    let files = FILES.map(|(name, text)| (name, text.as_bytes()));
    fs::write(folder.join("towers/p2.tar.bz2"), bzipped(&tarred(&files))).unwrap();
    fs::write(folder.join("towers/torn.zip"), "PK no more").unwrap();
    for (path, text) in [
        ("ours/grid.json", GRID),
        ("ours/delivery.json", DELIVERY),
        ("ours/wrong.json", "{\"format\": \"gridworld\"}"),
        ("explicit.json", EXPLICIT),
        // No problems.
        ("ours/notes.txt", "nothing"),
        ("domains/only/domain.pddl", "(define (domain d))"),
    ] {
        let path = folder.join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    folder
}

fn run(folder: &Path, out: &Path, more: &[&str]) -> Ran {
    let begin = ["experiment", "benchmarks", folder.to_str().unwrap()];
    mo_copp("", &[&begin[..], &["--out", out.to_str().unwrap()], more].concat())
}

/// Header and records without their seconds.
fn lines(path: &Path) -> Vec<Value> {
    let without = |line: &str| {
        let mut json: Value = serde_json::from_str(line).unwrap();
        for key in ["seconds", "reading_seconds"] {
            json.as_object_mut().unwrap().remove(key);
        }
        json
    };
    fs::read_to_string(path).unwrap().lines().map(without).collect()
}

fn record<'a>(lines: &'a [Value], problem: &str, solver: &str) -> &'a Value {
    let wanted = |line: &&Value| line["problem"] == problem && line["solver"] == solver;
    lines.iter().find(wanted).unwrap()
}

#[test]
fn every_problem_below_the_folder_has_a_record_of_each_solver() {
    let folder = problems("whole");
    let out = folder.with_file_name("out");
    let ran = run(&folder, &out, &[]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let records = lines(&out.join("records.jsonl"));
    let found: Vec<(&str, &str)> = records[0]["problems"]
        .as_array()
        .unwrap()
        .iter()
        .map(|problem| (problem["path"].as_str().unwrap(), problem["domain"].as_str().unwrap()))
        .collect();
    let expected = [
        ("explicit.json", "problems"),
        ("ours/delivery.json", "ours"),
        ("ours/grid.json", "ours"),
        ("ours/wrong.json", "ours"),
        ("towers/full/p1", "towers"),
        ("towers/p2.tar.bz2", "towers"),
        ("towers/part/broken", "towers"),
        ("towers/torn.zip", "towers"),
    ];
    assert_eq!(found, expected);
    assert_eq!(records.len(), 1 + 4 * expected.len());

    // Six goals: k = j = 3, and the best of all plans is the one of Figure 1.
    let delivery = record(&records, "ours/delivery.json", "exact");
    assert_eq!((&delivery["k"], &delivery["j"]), (&json!(3), &json!(3)));
    assert_eq!((&delivery["status"], &delivery["candidates"]), (&json!("optimal"), &json!(6)));
    assert_eq!((&delivery["goal_difference"], &delivery["bound"]), (&json!(1.0), &json!(1.0)));
    assert_eq!((&delivery["gap"], &delivery["within_bounds"]), (&json!(0.0), &json!(true)));
    assert_eq!((&delivery["length"], &delivery["limit"]), (&json!(3), &Value::Null));
    for solver in ["satisficing", "search"] {
        let found = record(&records, "ours/delivery.json", solver);
        assert_eq!((&found["status"], &found["within_bounds"]), (&json!("solved"), &json!(true)));
        assert_eq!(found["plan"].as_array().unwrap().len(), 3);
        // The proof that there is no plan is an answer too.
        let none = record(&records, "ours/grid.json", solver);
        assert_eq!((&none["status"], &none["within_bounds"]), (&json!("infeasible"), &Value::Null));
        assert_eq!((&none["k"], &none["j"]), (&json!(2), &json!(2)));
    }
    // The same problem in a folder and in an archive, with the sensors of the paper.
    for solver in ["satisficing", "search", "exact", "baseline"] {
        let mut one = record(&records, "towers/full/p1", solver).clone();
        one["problem"] = json!("towers/p2.tar.bz2");
        assert_eq!(&one, record(&records, "towers/p2.tar.bz2", solver));
        // What the command finds of the same problem by itself.
        let imported = mo_copp("", &["import", folder.join("towers/full/p1").to_str().unwrap()]);
        let bounds: &[&str] = if solver == "exact" { &[] } else { &["--k", "2", "--j", "2"] };
        let solve = [&["solve", "-", "--solver", solver, "--json"], bounds].concat();
        let alone = mo_copp(&imported.out, &solve).json();
        for key in ["status", "plan", "goal_difference"] {
            assert_eq!(alone[key], one[key], "{solver} {key}");
        }
    }
    // What cannot be read is a record like any other, with the reader's message.
    for (problem, why) in [
        ("ours/wrong.json", "ours/wrong.json:1:"),
        ("towers/part/broken", "hyps.dat: found no such file"),
        ("towers/torn.zip", "towers/torn.zip: found no archive that can be read"),
    ] {
        for solver in ["satisficing", "search", "exact", "baseline"] {
            let refused = record(&records, problem, solver);
            assert_eq!(refused["status"], "refused");
            let said = refused["refusal"].as_str().unwrap();
            assert!(said.starts_with(why), "{said}");
            assert_eq!((&refused["plan"], &refused["candidates"]), (&Value::Null, &Value::Null));
        }
    }
    let tables = fs::read_to_string(out.join("tables.md")).unwrap();
    assert_eq!(tables, ran.out);
    for row in [
        "| ours | exact | 2 of 3 | 2 | 0 |",
        "| ours | search | 2 of 3 | 1 | 1 |",
        "| **all** | baseline | 5 of 8 | 5 | 0 |",
    ] {
        assert!(tables.contains(row), "{row}\n{tables}");
    }
    assert!(tables.contains("| baseline | problem refused | 3 |"), "{tables}");
    assert!(tables.contains("| towers/torn.zip | "), "{tables}");
    let csv = fs::read_to_string(out.join("records.csv")).unwrap();
    assert_eq!(csv.lines().count(), records.len());
}

#[test]
fn a_run_goes_on_where_it_stopped_and_keeps_to_its_problems() {
    let folder = problems("resumed");
    let (whole, out) = (folder.with_file_name("whole"), folder.with_file_name("out"));
    assert_eq!(run(&folder, &whole, &[]).code, 0);
    let text = fs::read_to_string(whole.join("records.jsonl")).unwrap();
    // Stopped in the middle of a line.
    fs::create_dir_all(&out).unwrap();
    fs::write(out.join("records.jsonl"), &text[..text.len() * 2 / 3]).unwrap();
    let ran = run(&folder, &out, &["--jobs", "2"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert_eq!(lines(&out.join("records.jsonl")), lines(&whole.join("records.jsonl")));
    let kept = fs::read_to_string(out.join("records.jsonl")).unwrap();
    let first = text.lines().nth(1);
    assert_eq!(kept.lines().nth(1), first, "what is there is not done again");
    // Another question, and other problems.
    for (more, message) in [
        (&["--time-limit", "7"][..], "found time limit 20, expected time limit 7;"),
        (&["--k", "1"], "found k half, expected k 1;"),
        (&["--solver", "exact"], "found solvers satisficing, search, exact, baseline, expected"),
    ] {
        let ran = run(&folder, &out, more);
        assert_eq!(ran.code, 2);
        assert!(ran.err.contains(message), "{}", ran.err);
    }
    fs::write(folder.join("explicit.json"), EXPLICIT.to_owned() + " ").unwrap();
    let ran = run(&folder, &out, &[]);
    assert_eq!(ran.code, 2);
    let message = "found problem explicit.json of problems (digest ";
    assert!(ran.err.contains(message), "{}", ran.err);
    assert_eq!(fs::read_to_string(out.join("records.jsonl")).unwrap(), kept);
}

#[test]
fn shards_of_benchmarks_merged_are_the_whole() {
    let folder = problems("shards");
    let (whole, out) = (folder.with_file_name("whole"), folder.with_file_name("out"));
    assert_eq!(run(&folder, &whole, &[]).code, 0);
    let mut files = Vec::new();
    for shard in ["2/3", "1/3", "3/3"] {
        let ran = run(&folder, &out, &["--shard", shard]);
        assert_eq!((ran.code, ran.out.as_str()), (0, ""), "{}", ran.err);
        files.push(out.join(format!("records-{}.jsonl", shard.replace('/', "-of-"))));
    }
    let files: Vec<&str> = files.iter().map(|path| path.to_str().unwrap()).collect();
    let options = ["--out", out.to_str().unwrap()];
    let merged = mo_copp("", &[&["experiment", "merge"], &files[..], &options].concat());
    assert_eq!(merged.code, 0, "{}", merged.err);
    assert_eq!(lines(&out.join("records.jsonl")), lines(&whole.join("records.jsonl")));
    let part = mo_copp("", &[&["experiment", "merge"], &files[1..], &options].concat());
    assert_eq!(part.code, 2);
    assert!(part.err.contains("records are missing"), "{}", part.err);
    // A record that cannot be.
    let text = fs::read_to_string(files[0]).unwrap();
    for (from, to, message) in [
        ("\"within_bounds\":true", "\"within_bounds\":false", "expected within_bounds true"),
        ("\"refused\",\"limit\"", "\"solved\",\"limit\"", "expected status solved with a plan"),
        ("\"k\":2", "\"k\":3", "expected k and j of the run"),
        ("\"domain\":\"towers\",\"solver\"", "\"domain\":\"x\",\"solver\"", "the domain towers"),
    ] {
        assert!(text.contains(from), "{from}");
        fs::write(files[0], text.replacen(from, to, 1)).unwrap();
        let merged = mo_copp("", &[&["experiment", "merge"], &files[..], &options].concat());
        assert!(merged.err.contains(message), "{}", merged.err);
    }
}

#[test]
fn limits_are_recorded_as_what_they_are() {
    let folder = problems("limits");
    let one = ["--solver", "satisficing", "--solver", "exact"];
    for (more, limit) in [
        (&["--time-limit", "0"][..], "time limit reached: 0 s"),
        (&["--expansions", "1", "--time-limit", "none"], "expansion limit reached: 1"),
    ] {
        let out = folder.with_file_name(more[0].trim_start_matches('-'));
        let ran = run(&folder, &out, &[&one[..], more].concat());
        assert_eq!(ran.code, 0, "{}", ran.err);
        let records = lines(&out.join("records.jsonl"));
        let met = records.iter().filter(|record| record["limit"] == limit).count();
        assert!(met > 0, "{more:?}");
        assert!(ran.out.contains(&format!("| {limit} | ")), "{}", ran.out);
    }
    // More goals than there are.
    let out = folder.with_file_name("bounds");
    assert_eq!(run(&folder, &out, &["--k", "5", "--solver", "search"]).code, 0);
    let records = lines(&out.join("records.jsonl"));
    let refused = record(&records, "ours/grid.json", "search");
    let expected = "k: found 5, expected a whole number from 1 to 3, the number of goals";
    assert_eq!((&refused["status"], &refused["refusal"]), (&json!("refused"), &json!(expected)));
    assert_eq!(record(&records, "ours/delivery.json", "search")["k"], 5);
}

#[test]
fn what_makes_no_sense_is_refused() {
    let folder = problems("refused");
    let out = folder.with_file_name("out");
    for (more, message) in [
        (&["--jobs", "0"][..], "jobs: found 0, expected a whole number from 1"),
        (&["--k", "0"], "k: found 0, expected a whole number from 1"),
        (&["--solver", "exact", "--solver", "exact"], "solver: found exact for the second time"),
        (&["--memory-limit", "0"], "memory limit: found 0"),
        (&["--time-limit", "soon"], "found soon, expected a whole number of seconds, or none"),
    ] {
        let ran = run(&folder, &out, more);
        assert_eq!(ran.code, 2, "{more:?}");
        assert!(ran.err.contains(message), "{more:?}: {}", ran.err);
    }
    let nothing = run(&folder.join("domains"), &out, &[]);
    assert_eq!(nothing.code, 2);
    assert!(nothing.err.contains("domains: found no problem below it"), "{}", nothing.err);
    let missing = run(&folder.join("nowhere"), &out, &[]);
    assert_eq!(missing.code, 2);
    assert!(missing.err.contains("nowhere: "), "{}", missing.err);
}

/// A folder that is a problem itself, and links that lead in circles.
#[cfg(unix)]
#[test]
fn links_to_folders_are_not_followed() {
    let folder = problems("links");
    let problem = folder.join("towers/full/p1");
    std::os::unix::fs::symlink(&folder, problem.join("around")).unwrap();
    let out = folder.with_file_name("out");
    let ran = run(&problem, &out, &["--solver", "baseline"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let records = lines(&out.join("records.jsonl"));
    assert_eq!(records.len(), 2);
    assert_eq!((&records[1]["problem"], &records[1]["domain"]), (&json!("."), &json!("p1")));
    assert_eq!(records[1]["status"], "solved");
}

/// The processes that a process has started.
#[cfg(target_os = "linux")]
fn children(process: u32) -> Vec<u32> {
    let Ok(threads) = fs::read_dir(format!("/proc/{process}/task")) else { return Vec::new() };
    let of = |thread: fs::DirEntry| fs::read_to_string(thread.path().join("children")).ok();
    let texts: Vec<String> = threads.flatten().filter_map(of).collect();
    texts.iter().flat_map(|text| text.split_whitespace()).map(|id| id.parse().unwrap()).collect()
}

/// Starts a run of one job that takes very long; the run and the process of the job.
#[cfg(target_os = "linux")]
fn long_run(name: &str) -> (std::process::Child, u32, PathBuf) {
    let folder = empty(name).join("problems");
    fs::create_dir_all(&folder).unwrap();
    // No plan keeps these bounds, and Algorithm 1 takes very long to find that out.
    let drawn = mo_copp("", &["generate", "logistics", "--seed", "1"]);
    fs::write(folder.join("long.json"), drawn.out).unwrap();
    let out = folder.with_file_name("out");
    let asked = ["--solver", "search", "--k", "5", "--j", "1", "--time-limit", "none"];
    let places = [folder.to_str().unwrap(), "--out", out.to_str().unwrap()];
    let begin = ["experiment", "benchmarks"];
    let run = crate::command(&[&begin[..], &places, &asked].concat()).spawn().unwrap();
    let job = loop {
        if let Some(job) = children(run.id()).first() {
            break *job;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    };
    (run, job, out)
}

#[cfg(target_os = "linux")]
fn signal(name: &str, process: u32) {
    let kill = std::process::Command::new("kill").args([name, &process.to_string()]).status();
    assert!(kill.unwrap().success());
}

#[cfg(target_os = "linux")]
#[test]
fn a_solver_that_breaks_down_leaves_a_record() {
    let (run, job, out) = long_run("broken");
    signal("-KILL", job);
    let ran = crate::ran(run.wait_with_output().unwrap());
    assert_eq!(ran.code, 0, "{}", ran.err);
    let records = lines(&out.join("records.jsonl"));
    let failed = record(&records, "long.json", "search");
    assert_eq!((&failed["status"], &failed["plan"]), (&json!("failed"), &Value::Null));
    assert!(failed["refusal"].as_str().unwrap().contains("signal: 9"), "{failed}");
    assert!(ran.out.contains("| search | solver failed | 1 |"), "{}", ran.out);
}

#[cfg(target_os = "linux")]
#[test]
fn a_stopped_run_ends_its_jobs_and_records_nothing_of_them() {
    for name in ["-INT", "-TERM"] {
        let (run, job, out) = long_run("stopped");
        signal(name, run.id());
        let ran = crate::ran(run.wait_with_output().unwrap());
        assert_eq!(ran.code, 3, "{}", ran.err);
        assert!(ran.err.contains("the same command goes on from there"), "{}", ran.err);
        assert!(!Path::new(&format!("/proc/{job}")).exists(), "the job goes on");
        assert_eq!(lines(&out.join("records.jsonl")).len(), 1);
    }
}
