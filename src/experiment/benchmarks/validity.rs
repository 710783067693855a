//! Validity of a record of benchmarks: what its fields must have in common, whatever program wrote it.

use super::{BenchmarkJob, BenchmarkRecord, Benchmarks};
use crate::experiment::validity::{ROUNDING, difference, seconds, sets};
use crate::problem::MAX_GOALS;
use crate::solver::Options;

/// Checks the record of a job; what is expected in its place, where it cannot be.
pub(super) fn check(
    record: &BenchmarkRecord,
    run: &Benchmarks,
    job: &BenchmarkJob,
) -> Result<(), String> {
    if record.domain != job.problem.domain {
        return Err(format!("the domain {}, not {}", job.problem.domain, record.domain));
    }
    seconds(record.seconds)?;
    seconds(record.reading_seconds)?;
    let status = record.status.as_str();
    let plan = match status {
        "optimal" | "solved" | "feasible" => true,
        "infeasible" | "limit" => false,
        "refused" | "failed" => return refused(record),
        _ => {
            let known = "optimal, solved, feasible, infeasible, limit, refused or failed";
            return Err(format!("a status of {known}"));
        }
    };
    let there = [
        record.plan.is_some(),
        record.goals.is_some(),
        record.goal_difference.is_some(),
        record.length.is_some(),
        record.within_bounds.is_some(),
    ];
    if there != [plan; 5] || record.length != record.plan.as_ref().map(Vec::len) {
        let with = if plan { "with" } else { "without" };
        return Err(format!("status {status} {with} a plan"));
    }
    match (status, &record.limit) {
        ("feasible" | "limit", None) => {
            return Err(format!("status {status} with the limit that was met"));
        }
        ("infeasible" | "solved", Some(_)) => {
            return Err(format!("status {status} without a limit"));
        }
        _ => {}
    }
    if record.refusal.is_some() {
        return Err(format!("status {status} without a refusal"));
    }
    // A solver that was ended from outside tells nothing of its problem.
    if status == "limit" && (record.candidates, record.k, record.j) == (None, None, None) {
        return Ok(());
    }
    let Some(candidates) = record.candidates.filter(|count| (2..=MAX_GOALS).contains(count)) else {
        return Err(format!("2 to {MAX_GOALS} candidate goals"));
    };
    let bounds = run.bounds(candidates);
    if (record.k, record.j) != (bounds.at_least, bounds.at_most) {
        return Err("k and j of the run".to_owned());
    }
    let (Some(goals), Some(found)) = (&record.goals, record.goal_difference) else { return Ok(()) };
    sets(candidates, goals)?;
    difference(candidates, goals, found)?;
    let counts = (Some(goals.adversarial.len()), Some(goals.cooperative.len()));
    let within = counts.0 >= bounds.at_least && counts.1 <= bounds.at_most;
    if record.within_bounds != Some(within) {
        return Err(format!("within_bounds {within} of the goals that survive"));
    }
    let mut options = Options::new(job.solver);
    options.bounds = run.asked(job.solver, candidates);
    let asked = options.heeded_bounds();
    if asked.at_least.is_some_and(|k| counts.0 < Some(k))
        || asked.at_most.is_some_and(|j| counts.1 > Some(j))
    {
        return Err("surviving goals that keep k and j".to_owned());
    }
    if let Some(bound) = record.bound
        && !(found - ROUNDING..=1.0).contains(&bound)
    {
        return Err(format!("a bound from the goal difference {found} to 1, not {bound:e}"));
    }
    Ok(())
}

/// A record without an answer says why, and nothing else.
fn refused(record: &BenchmarkRecord) -> Result<(), String> {
    let empty = record.plan.is_none()
        && record.goals.is_none()
        && record.goal_difference.is_none()
        && record.length.is_none();
    if record.refusal.is_none() || !empty {
        return Err(format!("status {} with a refusal and without a plan", record.status));
    }
    Ok(())
}
