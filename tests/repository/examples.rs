//! The examples of the library: each runs and prints what it promises.

use std::collections::BTreeSet;
use std::process::Command;

use crate::{files, root};

/// For each example a line that it prints.
const LINES: &[(&str, &str)] = &[
    ("compare_solvers", "exact       optimal  goal difference     1 "),
    ("own_sensor", "optimal: goal difference 1"),
    ("problem_in_code", "plan: enter, take gold"),
    ("read_pddl", "(land red east)"),
    ("solve_grid", "goal difference 1"),
    ("trace_plan", "   cooperative saw barcode A, believes "),
    ("trade_off", "    3      1  1.00  "),
];

#[test]
fn every_example_runs_and_prints_its_line() {
    let name = |path: &std::path::PathBuf| path.file_stem().unwrap().to_string_lossy().into_owned();
    let there: BTreeSet<String> = files("examples", ".rs").iter().map(name).collect();
    assert_eq!(there, LINES.iter().map(|(name, _)| (*name).to_owned()).collect());
    for (name, line) in LINES {
        // The profile of the tests: what they have built is not built again.
        let arguments = ["run", "--quiet", "--profile", "test", "--example", name];
        let output = Command::new(env!("CARGO")).args(arguments).current_dir(root()).output();
        let output = output.unwrap();
        let (out, err) =
            (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
        assert!(output.status.success(), "{name}: {err}");
        assert!(out.lines().any(|found| found.starts_with(line)), "{name}: {out}");
    }
}
