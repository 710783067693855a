//! `mo-copp solve`: reads a problem, runs a solver, prints the outcome.

use std::fmt::Write;

use mo_copp::goal_difference::written;
use mo_copp::limits::LimitReached;
use mo_copp::problem::{Problem, Role};
use mo_copp::report::{AdviceReport, FrontReport, LengthReport, SolveReport};
use mo_copp::solver::{Horizon, Options, Outcome, Solver, Status};

use super::args::SolveArgs;
use super::error::CliError;
use super::{LIMIT, NO_PLAN, input, interrupt, note, print, progress, remedy, visible};

/// Solves and prints; the exit code.
pub fn run(args: &SolveArgs) -> Result<u8, CliError> {
    let path = args.problem.clone();
    let Some(problem) = interrupt::unless_stopped(move || input::problem(&path))? else {
        return stopped_while_reading(args);
    };
    let problem = problem?;
    let limits = args.limits.search.limits();
    let mut options = Options::new(args.solver)
        .with_encoding(args.encoding)
        .with_horizon(args.horizon.unwrap_or(Horizon::Auto))
        .with_horizon_step(args.horizon_step)
        .with_horizon_limit(args.horizon_limit)
        .with_bounds(input::bounds(&args.bounds, &problem)?)
        .with_pairs(args.pairs || args.pareto)
        .with_limits(limits.with_nodes(args.limits.nodes.unwrap_or(u64::MAX)));
    options.lengths = args.lengths;
    options.cost_limit = args.cost_limit;
    options.check(&problem).map_err(|mut error| {
        // By the name that was given.
        if error.option == "pairs" && args.pareto && !args.pairs {
            error.option = "pareto";
        }
        error
    })?;
    say_unused(args);
    let progress::Solved { outcome, seconds, stop } = progress::solve_watched(&problem, &options)?;
    let advice = remedy::advise(&problem, &options, &outcome, &stop)?;
    if args.json {
        let mut report = SolveReport::new(&problem, &outcome);
        report.stats.seconds = Some(seconds);
        if args.pareto && !args.pairs {
            report = report.with_old_names();
        }
        report.remedy = advice.map(|advice| AdviceReport::new(&problem, &advice));
        // Only texts, numbers and lists: writing them cannot fail.
        print(&(serde_json::to_string(&report).unwrap_or_default() + "\n"))?;
    } else {
        print(&visible(&text(&problem, &options, &outcome, seconds)))?;
        if outcome.status == Status::Infeasible && options.cost_limit.is_some() {
            note("note: what would do is not searched under a cost limit; a greater one may");
        }
        if let Some(advice) = advice {
            eprint!("mo-copp: {}", visible(&remedy::text(&problem, &options, &advice)));
        }
    }
    Ok(match outcome.status {
        Status::Optimal | Status::Solved | Status::Feasible => 0,
        Status::Infeasible => NO_PLAN,
        _ => LIMIT,
    })
}

/// The answer where a signal comes before there is a problem to solve.
fn stopped_while_reading(args: &SolveArgs) -> Result<u8, CliError> {
    if args.json {
        let report = SolveReport::unread(args.solver, LimitReached::Cancelled.to_string());
        // Only texts, numbers and lists: writing them cannot fail.
        print(&(serde_json::to_string(&report).unwrap_or_default() + "\n"))?;
    } else {
        let limit = LimitReached::Cancelled;
        print(&format!("limit: the problem was not read to its end\nstopped: {limit}\n"))?;
    }
    Ok(LIMIT)
}

/// Options that the solver does not heed are no error, so that solvers can be compared under the
/// same ones, but they are not passed over in silence.
fn say_unused(args: &SolveArgs) {
    let goals = !args.bounds.require.is_empty() || !args.bounds.forbid.is_empty();
    let unused: &[(&str, bool)] = match args.solver {
        Solver::Obfuscate => &[("--j", args.bounds.j.is_some())],
        Solver::Legible => &[("--k", args.bounds.k.is_some())],
        Solver::Baseline => &[
            ("--k", args.bounds.k.is_some()),
            ("--j", args.bounds.j.is_some()),
            ("--require and --forbid", goals),
        ],
        // All others heed all bounds.
        _ => &[],
    };
    for (option, given) in unused {
        if *given {
            let solver = args.solver.name();
            note(&format!("note: {option} is not used by the solver {solver}"));
        }
    }
}

fn text(problem: &Problem, options: &Options, outcome: &Outcome, seconds: f64) -> String {
    let report = SolveReport::new(problem, outcome);
    let mut text = String::new();
    // Writing to a text cannot fail.
    let _ = writeln!(text, "{}: {}", outcome.status.name(), meaning(options, outcome));
    if let Some(limit) = outcome.limit {
        let _ = writeln!(text, "stopped: {limit}");
    }
    if let (Some(plan), Some(difference)) = (&report.plan, outcome.goal_difference) {
        let shorter = match outcome.length_proved {
            Some(false) => " (a shorter one of this goal difference may exist)",
            _ => "",
        };
        let cost = report.cost.map_or_else(String::new, |cost| format!(", cost {cost}"));
        let _ = writeln!(text, "plan: {} actions{cost}{shorter}", plan.len());
        if !plan.is_empty() {
            let _ = writeln!(text, "  {}", plan.join(", "));
        }
        let value = |number| written(number, problem.goals().len());
        let _ = writeln!(text, "goal difference: {}", value(difference));
        if let (Some(bound), Some(gap)) = (outcome.bound, outcome.gap())
            && gap > 0.0
        {
            let (bound, gap) = (value(bound), value(gap));
            let _ = writeln!(text, "at most {bound} is possible: a gap of {gap}");
        }
    }
    for (observer, set) in problem.observers().iter().zip(outcome.survivors.iter().flatten()) {
        let who = match observer.role {
            Role::Adversarial => "enemy",
            Role::Cooperative => "friend",
        };
        let names: Vec<&str> = set.iter().map(|goal| problem.goals()[goal].name.as_str()).collect();
        let of = problem.goals().len();
        let _ = writeln!(
            text,
            "  the {who} ({}) holds {} of {of} goals possible: {}",
            observer.name,
            set.len(),
            names.join(", ")
        );
    }
    for (observer, set) in problem.observers().iter().zip(outcome.unsettled.iter().flatten()) {
        if !set.is_empty() {
            let names: Vec<&str> =
                set.iter().map(|goal| problem.goals()[goal].name.as_str()).collect();
            let names = names.join(", ");
            let _ = writeln!(
                text,
                "  not known for {}, whose beliefs are too large: {names}",
                observer.name
            );
        }
    }
    if let Some(points) = &report.pairs {
        let which = match report.pairs_complete {
            Some(false) => "pairs found so far, not all",
            _ => "reachable pairs",
        };
        let _ = writeln!(
            text,
            "{which} (goals possible for the enemy, for the friend; * for those on the Pareto front):"
        );
        for point in points {
            let plan = point.plan.join(", ");
            let (adversarial, cooperative) = (point.adversarial, point.cooperative);
            let on_front = FrontReport { adversarial, cooperative };
            let front = report.front.as_ref().is_some_and(|front| front.contains(&on_front));
            let mark = if front { "*" } else { " " };
            let pair = format!("({adversarial}, {cooperative})");
            let _ = writeln!(text, " {mark}{pair:8} {:3} actions: {plan}", point.plan.len());
        }
    }
    if let Some(points) = &report.lengths {
        write_lengths(&mut text, points, problem.goals().len());
    }
    let stats = &report.stats;
    let counts = [
        ("expansions", stats.expansions),
        ("branch-and-bound nodes", stats.nodes),
        ("variables", stats.variables),
        ("rows", stats.rows),
        ("states", Some(stats.states)),
        ("beliefs", Some(stats.beliefs)),
    ];
    let shown: Vec<String> =
        counts.iter().filter_map(|(what, n)| n.map(|n| format!("{n} {what}"))).collect();
    let _ = writeln!(text, "work: {}, {seconds:.3} s", shown.join(", "));
    text
}

/// The best of each length.
fn write_lengths(text: &mut String, points: &[LengthReport], goals: usize) {
    let _ = writeln!(
        text,
        "best goal difference of each length (goals possible for the enemy, for the friend):"
    );
    for point in points {
        let _ = match (point.adversarial, point.cooperative, point.goal_difference) {
            (Some(adversarial), Some(cooperative), Some(difference)) => writeln!(
                text,
                "  {:4} actions: {:>6} ({adversarial}, {cooperative}): {}",
                point.length,
                written(difference, goals),
                point.plan.as_deref().unwrap_or_default().join(", ")
            ),
            _ => writeln!(text, "  {:4} actions: no plan", point.length),
        };
    }
}

/// What the status says of this problem.
fn meaning(options: &Options, outcome: &Outcome) -> String {
    let cost =
        options.cost_limit.map_or_else(String::new, |limit| format!(" that costs at most {limit}"));
    let length = match (options.horizon, outcome.horizon) {
        _ if options.lengths.is_some() => {
            format!("of at most {} actions", options.lengths.unwrap_or_default())
        }
        (Horizon::Steps(_), Some(steps)) | (Horizon::Steps(steps), None) => {
            format!("of {steps} actions")
        }
        (Horizon::Auto, Some(steps)) if options.solver == Solver::Ip => {
            format!("of {steps} actions")
        }
        _ => "of any length".to_owned(),
    } + &cost;
    match outcome.status {
        Status::Optimal => format!("no plan {length} has a greater goal difference"),
        Status::Solved => "a plan that keeps the bounds".to_owned(),
        Status::Feasible => format!("the best plan {length} found before the work stopped"),
        Status::Infeasible if options.horizon_step > 0 => {
            format!("there is no such plan {length} or at a shorter horizon tried")
        }
        Status::Infeasible => format!("there is no such plan {length}"),
        _ => "no plan was found before the work stopped; there may be one".to_owned(),
    }
}
