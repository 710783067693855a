//! `mo-copp plan`: the baseline on plain PDDL.

use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

use mo_copp::limits::{LimitReached, Limits};
use mo_copp::pddl::{
    Domain, ExtraInputs, GroundError, PddlError, TaskDefinition, ground, read_domain, read_task,
};
use mo_copp::report::{PlanReport, PlanStats};
use mo_copp::solver::{ClassicalRun, SolveError, Stats, Status};

use super::args::PlanArgs;
use super::error::CliError;
use super::{BAD_INPUT, LIMIT, NO_PLAN, input, interrupt, note, print, progress, visible};

/// Expansions between two looks at whether to stop.
const SLICE: u64 = 16;

/// How far the work is.
struct Step {
    stats: PlanStats,
    search: Option<Stats>,
}

/// Reads, grounds, searches and prints; the exit code.
pub fn run(args: &PlanArgs) -> Result<u8, CliError> {
    let (domain_path, task_path) = (args.domain.clone(), args.task.clone());
    let Some(texts) = interrupt::unless_stopped(move || read(&domain_path, &task_path))? else {
        let limit = LimitReached::Cancelled.to_string();
        return answer(args, &stopped(limit, PlanStats::default()));
    };
    let (domain, task) = texts?;
    if task.domain != domain.name {
        note(&format!(
            "note: {} is a task of the domain {}, {} is the domain {}",
            args.task.display(),
            task.domain,
            args.domain.display(),
            domain.name
        ));
    }
    let limits = args.limits.limits();
    let (done, _) = progress::watched(
        move |watcher| plan(&domain, &task, limits, watcher),
        line,
        |last| {
            let stats = last.map_or_else(PlanStats::default, |step| step.stats);
            Ok(stopped(LimitReached::Cancelled.to_string(), stats))
        },
    )?;
    answer(args, &done?)
}

/// The domain and the task.
fn read(domain: &Path, task: &Path) -> Result<(Domain, TaskDefinition), CliError> {
    let (domain_text, task_text) = input::texts(domain, task)?;
    let wrong = |file: &Path| {
        let file = file.display().to_string();
        move |error: PddlError| CliError::Pddl { file, error }
    };
    let read = read_domain(&domain_text).map_err(wrong(domain))?;
    let task = read_task(&read, &task_text).map_err(wrong(task))?;
    Ok((read, task))
}

/// Prints a report; the exit code that goes with it.
fn answer(args: &PlanArgs, (report, code): &(PlanReport, u8)) -> Result<u8, CliError> {
    if args.json {
        // Only texts, numbers and lists: writing them cannot fail.
        print(&(serde_json::to_string(report).unwrap_or_default() + "\n"))?;
    } else {
        let lines: String = report.plan.iter().flatten().map(|step| step.clone() + "\n").collect();
        print(&visible(&lines))?;
        note(&summary(report));
    }
    Ok(*code)
}

/// An answer without a plan and without a proof.
fn stopped(limit: String, stats: PlanStats) -> (PlanReport, u8) {
    (PlanReport::stopped(limit, stats), LIMIT)
}

type Answer = Result<(PlanReport, u8), SolveError>;

fn plan(
    domain: &Domain,
    task: &TaskDefinition,
    limits: Limits,
    watcher: &mut progress::Watcher<Step, Answer>,
) -> Answer {
    let begin = Instant::now();
    let mut stats = PlanStats::default();
    // What is asked of the watcher here is whether somebody wants to stop.
    let _ = watcher.slice(|| Step { stats, search: None });
    let grounded = match ground(domain, task, &ExtraInputs::default()) {
        Ok(grounded) => grounded,
        Err(GroundError::Internal(error)) => return Err(SolveError::Replay(error)),
        Err(limit) => return Ok(stopped(limit.to_string(), stats)),
    };
    let task = Arc::new(grounded.task);
    stats.facts = task.fact_count();
    stats.operators = task.operators().len();
    stats.grounding_seconds = begin.elapsed().as_secs_f64();
    let begin = Instant::now();
    let mut run = ClassicalRun::new(Arc::clone(&task), limits);
    while !run.advance(SLICE) {
        if watcher.slice(|| Step { stats, search: Some(run.stats()) }).is_break() {
            break;
        }
    }
    let outcome = run.outcome()?;
    stats.search_seconds = begin.elapsed().as_secs_f64();
    let code = match outcome.status {
        Status::Infeasible => NO_PLAN,
        _ if outcome.plan.is_some() => 0,
        Status::Limit => LIMIT,
        _ => BAD_INPUT,
    };
    Ok((PlanReport::new(&task, &outcome, stats), code))
}

fn line(step: &Step) -> String {
    match &step.search {
        None => "grounding".to_owned(),
        Some(search) => format!("{} expansions, {} states", search.expansions, search.states),
    }
}

fn summary(report: &PlanReport) -> String {
    let stats = &report.stats;
    let answer = match (&report.plan, &report.limit) {
        (Some(plan), _) => match report.cost {
            Some(cost) => format!("{} actions, cost {cost}", plan.len()),
            None => format!("{} actions", plan.len()),
        },
        (None, Some(limit)) => format!("{limit}; there may be a plan"),
        (None, None) => "there is no plan".to_owned(),
    };
    format!(
        "{}: {answer}; {} facts, {} operators, {} expansions, {} states; grounding {:.3} s, search {:.3} s",
        report.status,
        stats.facts,
        stats.operators,
        stats.expansions,
        stats.states,
        stats.grounding_seconds,
        stats.search_seconds
    )
}
