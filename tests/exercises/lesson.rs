//! The table of solutions in `docs/lesson.md`: a row for each exercise, and each answer is right.

use super::{exercise, verdict};

#[test]
fn every_solution_of_the_lesson_is_right() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/lesson.md");
    let lesson = std::fs::read_to_string(path).unwrap();
    let mut rows = 0;
    for line in lesson.lines().filter(|line| line.starts_with("| `")) {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let (name, kind) = (cells[1].trim_matches('`'), cells[2].trim_matches('`'));
        let exercise = exercise(name);
        assert_eq!(exercise.kind(), kind);
        let told = cells[4].split(" (").next().unwrap();
        assert!(verdict(exercise.original(), told).right, "{name}: {told}");
        rows += 1;
    }
    assert_eq!(rows, 12);
}
