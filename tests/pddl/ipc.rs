//! The classic tasks of the International Planning Competitions, where they are at hand: the folder
//! that `MO_COPP_IPC` names holds a folder for each domain with `domain.pddl` and `instance-N.pddl`.
//! How long grounding takes is a line of `cargo bench`.

use std::io::Write;
use std::path::{Path, PathBuf};

use mo_copp::pddl::{ExtraInputs, Grounded, ground, read_domain, read_task};

const FOLDER: &str = "MO_COPP_IPC";

/// All tasks: the name of the domain, the number of the instance, the two files.
pub fn tasks(why: &str) -> Vec<(String, usize, PathBuf, PathBuf)> {
    let Some(folder) = std::env::var_os(FOLDER) else {
        // Past the harness, which shows what a test prints only where it fails.
        let _ = writeln!(std::io::stderr(), "{why} skipped: {FOLDER} does not name a folder");
        return Vec::new();
    };
    let mut tasks = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let folder = entry.unwrap().path();
        let domain = folder.join("domain.pddl");
        if !domain.is_file() {
            continue;
        }
        let name = folder.file_name().unwrap().to_string_lossy().into_owned();
        for entry in std::fs::read_dir(&folder).unwrap() {
            let file = entry.unwrap().path();
            let stem = file.file_stem().unwrap().to_string_lossy().into_owned();
            if let Some(number) = stem.strip_prefix("instance-") {
                tasks.push((name.clone(), number.parse().unwrap(), domain.clone(), file));
            }
        }
    }
    tasks.sort();
    assert!(tasks.len() >= 100, "{} tasks in {FOLDER}", tasks.len());
    tasks
}

fn grounded(domain: &Path, task: &Path) -> Grounded {
    let text = |path: &Path| std::fs::read_to_string(path).unwrap();
    let shown = |path: &Path| path.display().to_string();
    let read = read_domain(&text(domain)).unwrap_or_else(|e| panic!("{}: {e}", shown(domain)));
    let task_read =
        read_task(&read, &text(task)).unwrap_or_else(|e| panic!("{}: {e}", shown(task)));
    ground(&read, &task_read, &ExtraInputs::default())
        .unwrap_or_else(|e| panic!("{}: {e}", shown(task)))
}

#[test]
fn every_task_is_read_and_grounded() {
    for (domain, number, domain_file, task_file) in tasks("IPC test") {
        let grounded = grounded(&domain_file, &task_file);
        // One is without any aeroplane, so that a package cannot leave its city.
        let solvable = (domain.as_str(), number) != ("logistics", 19);
        assert_eq!(grounded.goal.is_some(), solvable, "{domain} {number}");
        assert!(!grounded.task.operators().is_empty(), "{domain} {number}");
    }
}
