//! Tables for people.

use std::fmt::Write;

use crate::experiment::statistics::{Anova, Spread};
use crate::experiment::{DomainSummary, Figure, InitialBeliefs, Summary};

/// Smaller probabilities are not told apart: the paper's bound.
const LEAST_P: f64 = 0.00001;

/// All tables of a run.
pub fn markdown(summary: &Summary) -> String {
    let mut text = String::new();
    // Writing to a text cannot fail.
    let _ = writeln!(
        text,
        "Mean ± standard deviation; {} problems of each domain, seeds from {}{}.\n",
        summary.problems,
        summary.seed,
        match summary.initial_beliefs {
            InitialBeliefs::Known => "",
            InitialBeliefs::Drawn => ", initial beliefs drawn for each observer by itself",
        }
    );
    text += "| domain | solver | goal difference | plan length | run time | answers |\n";
    text += "|---|---|---|---|---|---|\n";
    for domain in &summary.domains {
        solvers(&mut text, domain);
    }
    text += "\nOne-way analysis of variance over ";
    let groups = summary.domains.iter().flat_map(|domain| &domain.anova).next();
    let groups = groups.map(|line| line.groups.join(", ")).unwrap_or_default();
    let _ = writeln!(text, "{groups}.\n");
    text += "| domain | measure | F | p |\n|---|---|---|---|\n";
    for domain in &summary.domains {
        for line in &domain.anova {
            let (f, p) = match line.anova {
                Some(Anova { between, within, f, p }) => {
                    let f = f.map_or("∞".to_owned(), |f| format!("{f:.2}"));
                    (format!("F({between}, {within}) = {f}"), probability(p))
                }
                None => ("–".to_owned(), "–".to_owned()),
            };
            let measure = line.measure.replace('_', " ");
            let _ = writeln!(text, "| {} | {measure} | {f} | {p} |", domain.title);
        }
    }
    if summary.experiment == Figure::Fig4.name() {
        relative(&mut text, summary);
    }
    text
}

fn solvers(text: &mut String, domain: &DomainSummary) {
    for solver in &domain.solvers {
        let statuses = solver.statuses.named();
        let proved = |status| match status {
            "optimal" | "infeasible" => " (proved)",
            _ => "",
        };
        let statuses: Vec<String> =
            statuses.iter().map(|&(s, n)| format!("{n} {s}{}", proved(s))).collect();
        let digits = solver.seconds.map_or(0, |seconds| digits_of_seconds(seconds.mean));
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} |",
            domain.title,
            solver.title,
            spread(solver.goal_difference, 2, ""),
            spread(solver.length, 1, ""),
            spread(solver.seconds, digits, " s"),
            statuses.join(", ")
        );
    }
}

fn relative(text: &mut String, summary: &Summary) {
    *text +=
        "\nGoal difference relative to the search's, on the problems where both have a plan.\n\n";
    *text += "| domain | solver | problems | mean | search's mean | relative |\n";
    *text += "|---|---|---|---|---|---|\n";
    for domain in &summary.domains {
        for line in &domain.relative {
            let percent =
                line.percent.map_or("–".to_owned(), |percent| format!("{percent:.0} %"));
            let _ = writeln!(
                text,
                "| {} | {} | {} | {:.2} | {:.2} | {percent} |",
                domain.title, line.title, line.n, line.mean, line.search
            );
        }
    }
}

/// Mean and standard deviation.
fn spread(spread: Option<Spread>, digits: usize, unit: &str) -> String {
    match spread {
        None => "–".to_owned(),
        Some(Spread { mean, sd: None, .. }) => format!("{mean:.digits$}{unit}"),
        Some(Spread { mean, sd: Some(sd), .. }) => format!("{mean:.digits$} ± {sd:.digits$}{unit}"),
    }
}

/// How many digits behind the point a time needs to show two that count, microseconds at most.
pub(in crate::experiment) fn digits_of_seconds(seconds: f64) -> usize {
    let mut digits = 0;
    while digits < 6 && seconds * 10_f64.powi(digits) < 10.0 {
        digits += 1;
    }
    digits as usize
}

fn probability(p: f64) -> String {
    if p < LEAST_P { "< 0.00001".to_owned() } else { format!("{p:.5}") }
}
