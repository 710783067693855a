//! Validity of a record: what its fields must have in common, whatever program wrote it.

use super::record::{Asked, Record, Survivors};
use super::{Configuration, Job, Setting};
use crate::goal_difference::goal_difference;
use crate::problem::MAX_GOALS;

/// The most seconds that a solver can have taken: some thirty years. Their sums stay finite.
const MAX_SECONDS: f64 = 1e9;

/// How far a goal difference read from a file may be from the one that follows from its goals:
/// digits can be lost on the way through a text.
pub(super) const ROUNDING: f64 = 1e-9;

/// Checks the record of a job.
///
/// # Errors
///
/// What is expected in its place.
pub(super) fn check(record: &Record, setting: &Setting, job: &Job) -> Result<(), String> {
    plan(record)?;
    status(record, job.configuration)?;
    seconds(record.seconds)?;
    if !(2..=MAX_GOALS).contains(&record.candidates) {
        return Err(format!("2 to {MAX_GOALS} candidate goals, not {}", record.candidates));
    }
    let asked = Asked::of(setting, job);
    if record.options != asked {
        // Only numbers and names: writing them cannot fail.
        let written = |asked| serde_json::to_string(asked).unwrap_or_default();
        return Err(format!("the options {}, not {}", written(&asked), written(&record.options)));
    }
    if let (Some(bound), Some(found)) = (record.bound, record.goal_difference)
        && !(found - ROUNDING..=1.0).contains(&bound)
    {
        return Err(format!("a bound from the goal difference {found} to 1, not {bound:e}"));
    }
    match (&record.goals, record.goal_difference) {
        (Some(goals), Some(found)) => survivors(record, goals, found),
        _ => Ok(()),
    }
}

/// Seconds that a solver can have taken.
pub(super) fn seconds(seconds: f64) -> Result<(), String> {
    if (0.0..=MAX_SECONDS).contains(&seconds) {
        return Ok(());
    }
    Err(format!("seconds from 0 to {MAX_SECONDS}, not {seconds:e}"))
}

/// A plan, and what follows from it, must be there where the status says so.
fn plan(record: &Record) -> Result<(), String> {
    let expected = match record.status.as_str() {
        "optimal" | "solved" | "feasible" => true,
        "infeasible" | "limit" => false,
        _ => return Err("a status of optimal, solved, feasible, infeasible or limit".to_owned()),
    };
    let there = [
        record.plan.is_some(),
        record.goals.is_some(),
        record.goal_difference.is_some(),
        record.length.is_some(),
    ];
    if there != [expected; 4] || record.length != record.plan.as_ref().map(Vec::len) {
        let with = if expected { "with" } else { "without" };
        return Err(format!("status {} {with} a plan", record.status));
    }
    Ok(())
}

/// The status must be one that the solver gives, and a limit stand beside those that need one.
fn status(record: &Record, configuration: Configuration) -> Result<(), String> {
    let proves = configuration.is_exact()
        || matches!(configuration, Configuration::Ip | Configuration::IpPaper);
    let status = record.status.as_str();
    if status == if proves { "solved" } else { "optimal" } {
        return Err(format!("a status that this solver gives, not {status}"));
    }
    match (status, &record.limit) {
        ("feasible" | "limit", None) => Err(format!("status {status} with the limit that was met")),
        ("infeasible" | "solved", Some(_)) => Err(format!("status {status} without a limit")),
        _ => Ok(()),
    }
}

/// The true goal survives for both observers, the bounds asked for are kept, and the goal
/// difference is the one of the goals that survive.
fn survivors(record: &Record, goals: &Survivors, found: f64) -> Result<(), String> {
    let Survivors { adversarial, cooperative } = goals;
    let (candidates, asked) = (record.candidates, &record.options);
    sets(candidates, goals)?;
    if asked.k.is_some_and(|k| adversarial.len() < k.min(candidates))
        || asked.j.is_some_and(|j| cooperative.len() > j)
    {
        return Err("surviving goals that keep k and j".to_owned());
    }
    difference(candidates, goals, found)
}

/// Each goal survives once for an observer, and one of them, the true one, for both.
pub(super) fn sets(candidates: usize, goals: &Survivors) -> Result<(), String> {
    let Survivors { adversarial, cooperative } = goals;
    for side in [adversarial, cooperative] {
        let mut names: Vec<&String> = side.iter().collect();
        names.sort_unstable();
        names.dedup();
        if names.len() != side.len() || side.len() > candidates {
            return Err(format!("each surviving goal once, of {candidates}"));
        }
    }
    if !adversarial.iter().any(|goal| cooperative.contains(goal)) {
        return Err("a true goal that survives for both observers".to_owned());
    }
    Ok(())
}

/// The goal difference is the one of the goals that survive.
pub(super) fn difference(candidates: usize, goals: &Survivors, found: f64) -> Result<(), String> {
    let (enemy, friend) = (goals.adversarial.len(), goals.cooperative.len());
    let expected = goal_difference(enemy, friend, candidates);
    // Written so that no number at all is no match either.
    if (found - expected).abs() <= ROUNDING {
        return Ok(());
    }
    Err(format!("the goal difference {expected} of the goals that survive, not {found:e}"))
}
