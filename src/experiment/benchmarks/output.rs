//! What a run of benchmarks leaves in its folder: `records.csv` and `tables.md`.

use std::fmt::Write;
use std::path::Path;

use super::{Benchmark, BenchmarkLine, BenchmarkRecord, BenchmarkSummary, Benchmarks};
use crate::domain::pddl::import::CandidateOptions;
use crate::experiment::ExperimentError;
use crate::experiment::output::csv::{number, table};
use crate::experiment::output::markdown::digits_of_seconds;
use crate::experiment::output::replace;
use crate::experiment::records::Entries;

/// Writes everything that follows from the records of a whole run into a folder.
///
/// # Errors
///
/// The folder cannot be written.
pub fn write(
    folder: &Path,
    run: &Benchmarks,
    entries: &Entries<BenchmarkRecord>,
) -> Result<(), ExperimentError> {
    let summary = BenchmarkSummary::new(run, entries);
    replace(&folder.join("records.csv"), &records_csv(entries))?;
    replace(&folder.join("tables.md"), &tables(run, &summary))
}

/// One line for each record, without plans and goals.
pub fn records_csv(entries: &Entries<BenchmarkRecord>) -> String {
    let header = [
        "problem",
        "domain",
        "solver",
        "candidates",
        "k",
        "j",
        "status",
        "limit",
        "refusal",
        "length",
        "cost",
        "goal_difference",
        "adversarial_goals",
        "cooperative_goals",
        "within_bounds",
        "bound",
        "gap",
        "expansions",
        "reading_seconds",
        "seconds",
    ];
    let rows = entries.values().map(|entry| {
        let record = &entry.record;
        let goals = record.goals.as_ref();
        vec![
            record.problem.clone(),
            record.domain.clone(),
            record.solver.clone(),
            number(record.candidates),
            number(record.k),
            number(record.j),
            record.status.clone(),
            number(record.limit.as_ref()),
            number(record.refusal.as_ref()),
            number(record.length),
            number(record.cost),
            number(record.goal_difference),
            number(goals.map(|goals| goals.adversarial.len())),
            number(goals.map(|goals| goals.cooperative.len())),
            number(record.within_bounds),
            number(record.bound),
            number(record.gap),
            record.work.expansions.to_string(),
            record.reading_seconds.to_string(),
            record.seconds.to_string(),
        ]
    });
    table(&header, rows)
}

/// The tables for people: what was asked, a line for each domain and solver, what was refused.
pub fn tables(run: &Benchmarks, summary: &BenchmarkSummary) -> String {
    let mut text = String::new();
    // Writing to a text cannot fail.
    let _ = writeln!(text, "{}\n", asked(run));
    text += "| domain | solver | answered | plans | no plan (proved) | plans within k and j | \
             proved best | goal difference (mean) | gap (mean) | plan length (median) | \
             time (median) |\n|---|---|---|---|---|---|---|---|---|---|---|\n";
    for (domain, lines) in &summary.domains {
        for line in lines {
            row(&mut text, &cell(domain), line);
        }
    }
    if summary.domains.len() > 1 {
        for line in &summary.total {
            row(&mut text, "**all**", line);
        }
    }
    text += "\nWhat stopped the others:\n\n| solver | limit | problems |\n|---|---|---|\n";
    for line in &summary.total {
        let solver = line.solver.name();
        let others = [("problem refused", line.refused), ("solver failed", line.failed)];
        let others = others.iter().filter(|(_, count)| *count > 0);
        let limits = line.limits.iter().map(|(limit, count)| (limit.as_str(), *count));
        for (limit, count) in limits.chain(others.copied()) {
            let _ = writeln!(text, "| {solver} | {} | {count} |", cell(limit));
        }
    }
    if !summary.refusals.is_empty() {
        text +=
            "\nProblems without an answer of a solver, and why:\n\n| problem | why |\n|---|---|\n";
        for (problem, why) in &summary.refusals {
            let _ = writeln!(text, "| {} | {} |", cell(problem), cell(why));
        }
    }
    text
}

/// What was asked of the solvers, in a sentence.
fn asked(run: &Benchmarks) -> String {
    let half = || "max(2, ⌈n/2⌉) of the n candidate goals".to_owned();
    let bound = |bound: Option<usize>| bound.map_or_else(half, |bound| bound.to_string());
    let (k, j) = (bound(run.k), bound(run.j));
    let bounds = if k == j { format!("k = j = {k}") } else { format!("k = {k}, j = {j}") };
    let limits = &run.limits;
    let mut stops = Vec::new();
    stops.extend(limits.seconds.map(|seconds| format!("{seconds} s on the clock")));
    stops.push(format!("{} MiB of contents", limits.memory_mib));
    stops.extend(limits.expansions.map(|expansions| format!("{expansions} expansions")));
    let is_task = |problem: &Benchmark| problem.path.to_ascii_lowercase().ends_with(".pddl");
    let tasks = if run.problems.iter().any(is_task) {
        let CandidateOptions { candidates, seed } = run.tasks;
        format!("; {candidates} candidate goals for each competition task (seed {seed})")
    } else {
        String::new()
    };
    format!(
        "{} problems; {bounds}; sensors of imported problems “{}” and “{}”{tasks}. Each solver stops at {}.",
        run.problems.len(),
        cell(&run.adversarial_sensor),
        cell(&run.cooperative_sensor),
        stops.join(" or ")
    )
}

fn row(text: &mut String, domain: &str, line: &BenchmarkLine) {
    let shown = |number: Option<f64>, digits: usize, unit: &str| {
        number.map_or_else(|| "–".to_owned(), |number| format!("{number:.digits$}{unit}"))
    };
    let time = line.seconds.map(|seconds| seconds.median);
    let _ = writeln!(
        text,
        "| {domain} | {} | {} of {} | {} | {} | {} | {} | {} | {} | {} | {} |",
        line.solver.name(),
        line.answered(),
        line.problems,
        line.plans,
        line.none,
        line.within_bounds,
        line.optimal,
        shown(line.goal_difference.map(|difference| difference.mean), 2, ""),
        shown(line.gap.map(|gap| gap.mean), 2, ""),
        shown(line.length.map(|length| length.median), 1, ""),
        shown(time, time.map_or(0, digits_of_seconds), " s"),
    );
}

/// A text in a cell: on one line, and no sign of it ends the cell.
fn cell(text: &str) -> String {
    let mut cell = String::new();
    for letter in text.chars() {
        match letter {
            '|' | '\\' | '`' | '<' | '*' | '_' | '[' => cell.extend(['\\', letter]),
            letter if letter.is_control() => cell.extend(letter.escape_unicode()),
            letter => cell.push(letter),
        }
    }
    cell
}
