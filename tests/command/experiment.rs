//! `mo-copp experiment`

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::{Ran, command, mo_copp, ran};

/// An empty folder.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("command").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// Figure 3 on so many gridworlds, without the paper's encoding, which takes long.
fn arguments<'a>(problems: &'a str, out: &'a Path, more: &[&'a str]) -> Vec<&'a str> {
    let domain = ["experiment", "fig3", "--domain", "gridworld", "--problems", problems];
    [&domain[..], &["--out", out.to_str().unwrap()], more].concat()
}

fn fig3(problems: &str, out: &Path, more: &[&str]) -> Ran {
    mo_copp("", &[&arguments(problems, out, more)[..], &["--no-paper"]].concat())
}

/// The lines of a file of records without their seconds, which differ from run to run.
fn lines(path: &Path) -> Vec<Value> {
    let text = std::fs::read_to_string(path).unwrap();
    let without = |line| {
        let mut json: Value = serde_json::from_str(line).unwrap();
        json.as_object_mut().unwrap().remove("seconds");
        json
    };
    text.lines().map(without).collect()
}

#[test]
fn a_run_leaves_records_tables_and_figures() {
    let out = folder("experiment");
    let first = fig3("2", &out, &[]);
    assert_eq!(first.code, 0, "{}", first.err);
    assert!(first.out.contains("| Gridworld | integer program | "), "{}", first.out);
    assert_eq!(first.out, std::fs::read_to_string(out.join("tables.md")).unwrap());
    for file in ["results.json", "summary.csv", "anova.csv", "fig3-goal-difference.svg"] {
        assert!(out.join(file).is_file(), "{file}");
    }
    let records = std::fs::read(out.join("records.jsonl")).unwrap();
    assert_eq!(lines(&out.join("records.jsonl")).len(), 1 + 2 * 6);
    // There is nothing left to do.
    let again = fig3("2", &out, &["--jobs", "1"]);
    assert_eq!((again.code, again.out), (0, first.out));
    assert_eq!(std::fs::read(out.join("records.jsonl")).unwrap(), records);
    // Another run does not write into these records.
    let other = fig3("3", &out, &[]);
    assert_eq!(other.code, 2);
    assert!(other.err.contains("line 1: found problems 2, expected problems 3;"), "{}", other.err);
    // Whatever the jobs.
    let alone = folder("experiment-alone");
    assert_eq!(fig3("2", &alone, &["--jobs", "1"]).code, 0);
    assert_eq!(lines(&alone.join("records.jsonl")), lines(&out.join("records.jsonl")));
}

#[test]
fn what_makes_no_sense_is_refused() {
    let out = folder("experiment-refused");
    for (more, message) in [
        (&["--jobs", "0"][..], "jobs: found 0, expected a whole number from 1"),
        (&["--shard", "0/3"], "shard: found 0/3, expected I/N with I from 1 to N, as in 2/8"),
        (&["--shard", "three"], "shard: found three, expected I/N"),
        (&["--domain", "chess"], "domain: found chess, expected one of gridworld"),
        (&["--domain", "gridworld"], "domain: found gridworld for the second time"),
        (&["--memory-limit", "0"], "memory limit: found 0, expected a number of MiB from 1"),
    ] {
        let ran = fig3("2", &out, more);
        assert_eq!(ran.code, 2, "{more:?}");
        assert!(ran.err.contains(message), "{more:?}: {}", ran.err);
    }
    let beliefs = ["experiment", "fig4", "--initial-beliefs", "guessed"];
    let ran = mo_copp("", &beliefs);
    assert_eq!(ran.code, 2);
    assert!(ran.err.contains("found guessed, expected known or drawn"), "{}", ran.err);
    for (problems, message) in [
        ("0", "problems: found 0, expected a whole number from 1 to 10000"),
        ("10001", "problems: found 10001, expected a whole number from 1 to 10000"),
    ] {
        let ran = fig3(problems, &out, &[]);
        assert_eq!(ran.code, 2);
        assert!(ran.err.contains(message), "{}", ran.err);
    }
    let missing = mo_copp("", &["experiment", "merge", "nowhere.jsonl"]);
    assert_eq!(missing.code, 2);
    assert!(missing.err.starts_with("mo-copp: nowhere.jsonl: "), "{}", missing.err);
}

#[cfg(unix)]
#[test]
fn names_of_folders_cannot_steer_the_terminal() {
    let out = folder("experiment-hostile").join("\u{1b}[31mred \u{202e}");
    for more in [&[][..], &["--shard", "1/2"]] {
        let ran = fig3("1", &out, more);
        assert_eq!(ran.code, 0, "{}", ran.err);
        assert!(!ran.err.contains(['\u{1b}', '\u{202e}']), "{:?}", ran.err);
        assert!(ran.err.contains("\\u{1b}[31mred \\u{202e}"), "{}", ran.err);
    }
    assert!(out.join("records.jsonl").is_file());
}

/// No file may grow beyond a few kilobytes, as on a disk that is full.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_said_of_the_right_file_and_nothing_is_left_behind() {
    let out = folder("experiment-full");
    assert_eq!(fig3("30", &out, &[]).code, 0);
    let records = out.join("records.jsonl");
    let before = std::fs::read(&records).unwrap();
    assert!(before.len() > 20 << 10);
    let parts = out.join("merged");
    std::fs::create_dir_all(&parts).unwrap();
    std::fs::write(parts.join("records.jsonl"), "old").unwrap();
    let mut command = Command::new("sh");
    let limited = "trap '' XFSZ; ulimit -f 8; exec \"$0\" experiment merge \"$1\" --out \"$2\"";
    command.args(["-c", limited, env!("CARGO_BIN_EXE_mo-copp")]).args([&records, &parts]);
    let ran = ran(command.output().unwrap());
    assert_eq!((ran.code, ran.out.as_str()), (2, ""), "{}", ran.err);
    let new = parts.join("records.jsonl.new");
    assert!(
        ran.err.starts_with(&format!("mo-copp: {}: File too large", new.display())),
        "{}",
        ran.err
    );
    assert!(!new.exists());
    assert_eq!(std::fs::read(parts.join("records.jsonl")).unwrap(), b"old");
    assert_eq!(std::fs::read(&records).unwrap(), before);
}

/// Each observer's initial belief drawn for itself: the header says so, and the search is not the only
/// one whose friend may be in more doubt.
#[test]
fn figure_4_with_drawn_initial_beliefs() {
    let out = folder("experiment-drawn");
    let drawn = ["experiment", "fig4", "--initial-beliefs", "drawn", "--domain", "blocksworld"];
    let ran =
        mo_copp("", &[&drawn[..], &["--problems", "2", "--out", out.to_str().unwrap()]].concat());
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert!(ran.out.contains(", initial beliefs drawn for each observer by itself"), "{}", ran.out);
    let lines = lines(&out.join("records.jsonl"));
    assert_eq!(lines[0]["initial_beliefs"], "drawn");
    // Problem 1 is the one that generate draws.
    let document = mo_copp("", &["generate", "blocksworld", "--seed", "1", "--belief", "8"]);
    assert!(document.out.contains("\"initial_belief\""), "{}", document.err);
    let best = mo_copp(&document.out, &["solve", "-", "--json"]).json();
    let record = |line: &&Value| line["solver"] == "exact-any" && line["problem"] == 1;
    let record = lines.iter().find(record).unwrap();
    assert_eq!(record["goal_difference"], best["goal_difference"]);
}

#[test]
fn help_shows_examples() {
    let help = mo_copp("", &["experiment", "--help"]);
    assert!(help.out.contains("mo-copp experiment fig3 --shard 2/8"), "{}", help.out);
    let help = mo_copp("", &["experiment", "fig4", "--help"]);
    assert!(help.out.contains("--time-limit") && !help.out.contains("--paper-nodes"));
}

/// Merges the parts below a folder and holds them against a whole run.
fn merged(out: &Path, problems: &str) {
    let part = |number| out.join(format!("records-{number}-of-3.jsonl"));
    let parts: Vec<PathBuf> = (1..=3).map(part).collect();
    let files: Vec<&str> = parts.iter().map(|path| path.to_str().unwrap()).collect();
    let options = ["--out", out.to_str().unwrap()];
    let merged = mo_copp("", &[&["experiment", "merge"], &files[..], &options].concat());
    assert_eq!(merged.code, 0, "{}", merged.err);
    let whole = out.join("whole");
    let ran = fig3(problems, &whole, &[]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert_eq!(lines(&out.join("records.jsonl")), lines(&whole.join("records.jsonl")));
    assert!(out.join("results.json").is_file());
}

#[test]
fn shards_merged_are_the_whole() {
    let out = folder("experiment-shards");
    for shard in ["3/3", "1/3", "2/3"] {
        let ran = fig3("2", &out, &["--shard", shard, "--jobs", "1"]);
        assert_eq!((ran.code, ran.out.as_str()), (0, ""), "{}", ran.err);
    }
    merged(&out, "2");
}

/// `npm test` installs GNU parallel where it can.
#[test]
fn gnu_parallel_runs_the_shards() {
    let version = Command::new("parallel").arg("--version").output();
    if !version.is_ok_and(|output| output.stdout.starts_with(b"GNU parallel")) {
        // Past the harness, which shows what a test prints only where it fails.
        use std::io::Write;
        writeln!(std::io::stderr(), "test with GNU parallel skipped: it is not there").unwrap();
        return;
    }
    let out = folder("experiment-parallel");
    let program = env!("CARGO_BIN_EXE_mo-copp");
    let run = [&arguments("3", &out, &["--no-paper"])[..], &["--jobs", "1"]].concat();
    let output = Command::new("parallel")
        .args(["--will-cite", "--halt", "now,fail=1", program])
        .args(run)
        .args(["--shard", "{}/3", ":::", "1", "2", "3"])
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    merged(&out, "3");
}

/// Starts a run, waits until it has written so many lines, and sends a signal.
#[cfg(unix)]
fn stopped(arguments: &[&str], records: &Path, least: usize, signal: &str) -> (Ran, Duration) {
    let mut child = command(arguments).spawn().unwrap();
    let written = || std::fs::read_to_string(records).map_or(0, |text| text.lines().count());
    while written() < least {
        assert!(child.try_wait().unwrap().is_none(), "the run should take longer than this");
        std::thread::sleep(Duration::from_millis(1));
    }
    let begin = Instant::now();
    let kill = Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap();
    assert!(kill.success());
    (ran(child.wait_with_output().unwrap()), begin.elapsed())
}

#[cfg(unix)]
#[test]
fn a_stopped_run_goes_on_where_it_stopped() {
    let whole = folder("experiment-whole");
    assert_eq!(fig3("30", &whole, &[]).code, 0);
    let out = folder("experiment-stopped");
    let records = out.join("records.jsonl");
    let run = arguments("30", &out, &["--no-paper", "--jobs", "1"]);
    let mut before = 0;
    for (least, signal, code) in [(4, "-KILL", -1), (30, "-INT", 3), (60, "-TERM", 3)] {
        let (ran, _) = stopped(&run, &records, least, signal);
        assert_eq!(ran.code, code, "{}", ran.err);
        let text = std::fs::read_to_string(&records).unwrap();
        assert!(text.lines().count() > before, "nothing that was recorded is lost");
        before = text.lines().count();
        if code == 3 {
            let all = 30 * 6;
            let message = format!("stopped with {} of {all} records in ", before - 1);
            assert!(ran.err.contains(&message), "{}", ran.err);
            assert!(ran.err.contains("the same command goes on from there"), "{}", ran.err);
        }
    }
    assert_eq!(mo_copp("", &run).code, 0);
    assert_eq!(lines(&records), lines(&whole.join("records.jsonl")));
}

/// The first linear program of the paper's encoding takes seconds and cannot be cut.
#[cfg(unix)]
#[test]
fn a_step_that_cannot_be_cut_is_left_behind() {
    let out = folder("experiment-left");
    let records = out.join("records.jsonl");
    let run = arguments("1", &out, &["--paper-nodes", "1000000", "--paper-nonzeros", "10000000"]);
    // The paper's encoding is the last of the six.
    let (ran, took) = stopped(&run, &records, 6, "-INT");
    assert_eq!(ran.code, 3, "{}", ran.err);
    assert!(ran.err.contains("the same command goes on from there"), "{}", ran.err);
    assert!(took < Duration::from_secs(30), "{took:?}");
    assert_eq!(lines(&records).len(), 6);
}
