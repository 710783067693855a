//! The gallery of the page: each of its documents runs in the command as well.

use std::path::PathBuf;

use crate::mo_copp;

#[test]
fn every_problem_of_the_gallery_is_solved_by_the_command() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("www/problems");
    let mut files: Vec<PathBuf> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    assert!(files.len() >= 10, "{} problems", files.len());
    for file in files {
        let name = file.display().to_string();
        let ran = mo_copp("", &["solve", &name, "--json"]);
        assert_eq!(ran.code, 0, "{name}: {}", ran.err);
        let outcome = ran.json();
        assert_eq!(outcome["status"], "optimal", "{name}");
        let plan: Vec<&str> = outcome["plan"]
            .as_array()
            .unwrap()
            .iter()
            .map(|action| action.as_str().unwrap())
            .collect();
        let traced = mo_copp("", &["trace", &name, "--plan", &plan.join(","), "--json"]).json();
        assert_eq!(traced["valid"], true, "{name}");
        assert_eq!(traced["goal_difference"], outcome["goal_difference"], "{name}");
    }
}
