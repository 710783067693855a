//! The baseline's plans carried out by pyperplan: its own parser and its own operators.
//!
//! `MO_COPP_PYPERPLAN_PYTHON` names a Python with the package pyperplan; `npm test` sets it. The tasks are
//! drawn ones, of those in the folder of [`ipc`](super::ipc) the first few of each domain, and of the
//! goal-recognition problems in the folder that `MO_COPP_GOAL_RECOGNITION` names the first few of each
//! domain that pyperplan reads. For all of the competitions' tasks: `python tests/validate_plans.py --planner target/release/mo-copp FOLDER`.

use std::collections::BTreeSet;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;

use mo_copp::domain::Document;
use mo_copp::domain::generate::Domain;
use mo_copp::domain::pddl::import::{FILES, ImportFile, ImportOptions, import};
use mo_copp::limits::Limits;
use mo_copp::pddl::{ExtraInputs, ground, read_domain, read_task};
use mo_copp::solver::ClassicalRun;
use serde_json::Value;

use super::ipc;

const PYTHON: &str = "MO_COPP_PYPERPLAN_PYTHON";

const RECOGNITION: &str = "MO_COPP_GOAL_RECOGNITION";

/// Instances of each domain, the first ones.
const INSTANCES: usize = 4;

/// Expansions after which a task is left out.
const EXPANSIONS: u64 = 2000;

/// A domain, a task and where the plan goes.
type Files = [PathBuf; 3];

fn folder() -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("pyperplan");
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

fn text(value: &Value) -> String {
    let lines = value.as_array().unwrap().iter();
    lines.map(|line| line.as_str().unwrap().to_owned() + "\n").collect()
}

/// The tasks inside of drawn documents, with the true goal as theirs.
fn drawn() -> Vec<Files> {
    let mut files = Vec::new();
    for generator in ["blocksworld", "logistics", "driverlog"] {
        for seed in 0..3 {
            let drawn = Domain::named(generator).unwrap().draw(seed).unwrap();
            files.push(in_document(&drawn.document, &format!("drawn-{generator}-{seed}")));
        }
    }
    files
}

/// The task inside of a document, with the true goal as its goal.
fn in_document(document: &Document, name: &str) -> Files {
    let document: Value = serde_json::from_str(&document.to_json()).unwrap();
    let goals = document["goals"].as_array().unwrap();
    let goal = goals.iter().find(|goal| goal["name"] == document["true_goal"]).unwrap();
    let task = text(&document["problem"]);
    assert!(!task.contains(":goal"));
    let task = task.trim_end().strip_suffix(')').unwrap().to_owned();
    let goal = format!("\n(:goal {}))\n", goal["condition"].as_str().unwrap());
    let path = |what: &str| folder().join(format!("{name}-{what}"));
    let paths = [path("domain.pddl"), path("task.pddl"), path("plan")];
    std::fs::write(&paths[0], text(&document["domain"])).unwrap();
    std::fs::write(&paths[1], task + &goal).unwrap();
    paths
}

/// The first goal-recognition problems of each domain, by domain; none where their folder is not named.
fn recognition() -> Vec<(String, Files)> {
    let Some(folder) = std::env::var_os(RECOGNITION) else {
        let why = "does not name a folder of problems";
        // Past the harness, as above.
        let mut out = std::io::stderr();
        writeln!(out, "part of the pyperplan test skipped: {RECOGNITION} {why}").unwrap();
        return Vec::new();
    };
    let listed = |folder: &Path| {
        let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        let mut folders: Vec<PathBuf> = entries.filter(|path| path.is_dir()).collect();
        folders.sort();
        folders
    };
    let mut found = Vec::new();
    for domain in listed(Path::new(&folder)) {
        for problem in listed(&domain).iter().take(INSTANCES) {
            let read = |name: &&str| {
                let text = std::fs::read_to_string(problem.join(name)).ok()?;
                Some(ImportFile { name: (*name).to_owned(), text })
            };
            let files: Vec<ImportFile> = FILES.iter().filter_map(read).collect();
            let document = import(&files, &ImportOptions::default()).unwrap().document.into();
            let name = problem.file_name().unwrap().to_string_lossy();
            let of = domain.file_name().unwrap().to_string_lossy().into_owned();
            found.push((of, in_document(&document, &format!("recognition-{name}"))));
        }
    }
    found
}

/// The plan of a task; none where it takes too long.
fn plan(domain: &Path, task: &Path) -> Option<Vec<String>> {
    let text = |path: &Path| std::fs::read_to_string(path).unwrap();
    let domain = read_domain(&text(domain)).unwrap();
    let task = read_task(&domain, &text(task)).unwrap();
    let task = Arc::new(ground(&domain, &task, &ExtraInputs::default()).unwrap().task);
    let limits = Limits::default().with_expansions(EXPANSIONS);
    let mut run = ClassicalRun::new(Arc::clone(&task), limits);
    while !run.advance(100) {}
    run.outcome().unwrap().plan.map(|plan| plan.names(&task))
}

/// What pyperplan says of each plan.
fn verdicts(python: &std::ffi::OsStr, files: &[Files]) -> Vec<String> {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/validate_plans.py");
    let output = Command::new(python).arg(script).args(files.iter().flatten()).output().unwrap();
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{errors}");
    String::from_utf8(output.stdout).unwrap().lines().map(str::to_owned).collect()
}

#[test]
fn pyperplan_carries_the_plans_out() {
    let Some(python) = std::env::var_os(PYTHON) else {
        // Past the harness, which shows what a test prints only where it fails.
        let why = "does not name a Python with the package pyperplan";
        writeln!(std::io::stderr(), "pyperplan test skipped: {PYTHON} {why}").unwrap();
        return;
    };
    let mut tasks = drawn();
    let own = tasks.len();
    for (name, number, domain, task) in ipc::tasks("IPC part of the pyperplan test") {
        if number <= INSTANCES {
            tasks.push([domain, task, folder().join(format!("{name}-{number}-plan"))]);
        }
    }
    let mut files = Vec::new();
    let mut lengths = Vec::new();
    for paths in &tasks {
        if let Some(steps) = plan(&paths[0], &paths[1]) {
            std::fs::write(&paths[2], steps.join("\n")).unwrap();
            lengths.push(steps.len());
            files.push(paths.clone());
        }
    }
    assert!(files.len() >= own && files.len() * 10 >= tasks.len() * 8, "{} solved", files.len());
    let found = verdicts(&python, &files);
    assert_eq!(found.len(), files.len());
    for ((verdict, length), paths) in found.iter().zip(&lengths).zip(&files) {
        assert_eq!(*verdict, format!("valid {length}"), "{}", paths[1].display());
    }
    recognised(&python);
    // A plan without its last step, or with its first one twice, is found out.
    let [domain, task, file] = files[0].clone();
    let steps: Vec<String> =
        std::fs::read_to_string(file).unwrap().lines().map(str::to_owned).collect();
    let shorter = folder().join("shorter");
    std::fs::write(&shorter, steps[..steps.len() - 1].join("\n")).unwrap();
    let doubled = folder().join("doubled");
    std::fs::write(&doubled, format!("{}\n{}", steps[0], steps.join("\n"))).unwrap();
    let wrong = [[domain.clone(), task.clone(), shorter], [domain, task, doubled]];
    let said = verdicts(&python, &wrong);
    assert!(said[0].starts_with("the goal lacks ("), "{said:?}");
    assert!(said[1].starts_with("step 2: "), "{said:?}");
}

/// The plans for goal-recognition problems are valid wherever pyperplan reads the domain.
fn recognised(python: &std::ffi::OsStr) {
    let mut files = Vec::new();
    let mut known = Vec::new();
    for (domain, paths) in recognition() {
        if let Some(steps) = plan(&paths[0], &paths[1]) {
            std::fs::write(&paths[2], steps.join("\n")).unwrap();
            files.push(paths);
            known.push((domain, steps.len()));
        }
    }
    if files.is_empty() {
        return;
    }
    let mut read = BTreeSet::new();
    for ((verdict, paths), (domain, length)) in
        verdicts(python, &files).iter().zip(&files).zip(&known)
    {
        // What it cannot read says nothing of the plan.
        if !verdict.starts_with("pyperplan cannot read the task: ") {
            assert_eq!(*verdict, format!("valid {length}"), "{}", paths[1].display());
            read.insert(domain);
        }
    }
    assert!(read.len() >= 3, "pyperplan reads {read:?} alone");
}
