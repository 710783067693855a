//! The tables of `docs/lesson.md`: a row for each exercise, whose kind is right, and each solution is right.

use super::{exercise, verdict};

/// The cells of each row that begins like this.
fn rows(lesson: &str, begin: &str) -> Vec<Vec<String>> {
    let cells = |line: &str| line.split('|').map(|cell| cell.trim().to_owned()).collect();
    lesson.lines().filter(|line| line.starts_with(begin)).map(cells).collect()
}

#[test]
fn every_exercise_and_solution_of_the_lesson_is_right() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/lesson.md");
    let lesson = std::fs::read_to_string(path).unwrap();
    let mut names = Vec::new();
    for cells in rows(&lesson, "| [`") {
        let (name, kind) = (cells[1].split('`').nth(1).unwrap(), cells[2].trim_matches('`'));
        assert_eq!(cells[1], format!("[`{name}`](../examples/exercises/{name}.json)"));
        assert_eq!(exercise(name).kind(), kind, "{name}");
        names.push(name.to_owned());
    }
    assert_eq!(names.len(), 12);
    let solutions = rows(&lesson, "| `");
    let solved: Vec<&str> = solutions.iter().map(|cells| cells[1].trim_matches('`')).collect();
    assert_eq!(solved, names);
    for (name, cells) in names.iter().zip(&solutions) {
        let told = cells[2].split(" (").next().unwrap();
        assert!(verdict(exercise(name).original(), told).right, "{name}: {told}");
    }
}
