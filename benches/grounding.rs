//! Times reading and grounding PDDL: `MO_COPP_IPC=FOLDER cargo bench --bench grounding`.
//!
//! FOLDER holds a folder for each domain with `domain.pddl` and `instance-N.pddl`, as the classic tasks of
//! the International Planning Competitions are handed round. A line for each task whose name holds the
//! first argument (all without one): its size and the median of three times. The last line is the worst.
#![allow(clippy::expect_used, clippy::print_stdout)]

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use mo_copp::pddl::{ExtraInputs, Grounded, ground, read_domain, read_task};

const FOLDER: &str = "MO_COPP_IPC";

/// Name, number, domain and task, in order.
fn tasks(folder: &Path) -> Vec<(String, usize, PathBuf, PathBuf)> {
    let mut tasks = Vec::new();
    for entry in std::fs::read_dir(folder).expect("a folder that can be read") {
        let folder = entry.expect("an entry").path();
        let domain = folder.join("domain.pddl");
        if !domain.is_file() {
            continue;
        }
        let name = folder.file_name().expect("a name").to_string_lossy().into_owned();
        for entry in std::fs::read_dir(&folder).expect("a folder that can be read") {
            let file = entry.expect("an entry").path();
            let stem = file.file_stem().expect("a name").to_string_lossy().into_owned();
            if let Some(number) = stem.strip_prefix("instance-").and_then(|n| n.parse().ok()) {
                tasks.push((name.clone(), number, domain.clone(), file));
            }
        }
    }
    tasks.sort();
    tasks
}

fn grounded(domain: &str, task: &str) -> Grounded {
    let domain = read_domain(domain).expect("a domain");
    let task = read_task(&domain, task).expect("a task");
    ground(&domain, &task, &ExtraInputs::default()).expect("within the limits")
}

fn main() {
    let Some(folder) = std::env::var_os(FOLDER) else {
        println!("grounding: skipped, {FOLDER} does not name a folder");
        return;
    };
    let filter = std::env::args().skip(1).find(|argument| !argument.starts_with('-'));
    let mut worst = (Duration::ZERO, String::new());
    println!(
        "{:16} {:>8} {:>8} {:>6} {:>10} {:>12}",
        "task", "facts", "groups", "words", "operators", "time"
    );
    for (name, number, domain, task) in tasks(Path::new(&folder)) {
        let name = format!("{name} {number}");
        if filter.as_ref().is_some_and(|filter| !name.contains(filter)) {
            continue;
        }
        let text = |path: &Path| std::fs::read_to_string(path).expect("a text");
        let (domain, task) = (text(&domain), text(&task));
        let mut times = Vec::new();
        let mut made = None;
        for _ in 0..3 {
            let begin = Instant::now();
            made = Some(grounded(&domain, &task));
            times.push(begin.elapsed());
        }
        times.sort_unstable();
        let task = made.expect("grounded three times").task;
        println!(
            "{name:16} {:8} {:8} {:6} {:10} {:>9.3} ms",
            task.fact_count(),
            task.exclusive_groups().len(),
            task.initial_state().words().len(),
            task.operators().len(),
            times[1].as_secs_f64() * 1e3
        );
        worst = worst.max((times[1], name));
    }
    println!("worst: {}, {:.3} s", worst.1, worst.0.as_secs_f64());
}
