//! Tables for other programs.

use csv::Writer;

use crate::experiment::records::Entries;
use crate::experiment::{Measure, Summary};

/// Rows as CSV text.
pub(in crate::experiment) fn table(
    header: &[&str],
    rows: impl IntoIterator<Item = Vec<String>>,
) -> String {
    let mut writer = Writer::from_writer(Vec::new());
    // Writing into memory cannot fail, and every row is as long as the header.
    let _ = writer.write_record(header);
    for row in rows {
        let _ = writer.write_record(row);
    }
    String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default()
}

pub(in crate::experiment) fn number(number: Option<impl ToString>) -> String {
    number.map_or_else(String::new, |number| number.to_string())
}

/// One line for each domain and solver.
pub fn summary_csv(summary: &Summary) -> String {
    const FIRST: [&str; 8] =
        ["domain", "solver", "problems", "optimal", "solved", "feasible", "infeasible", "limit"];
    const SPREAD: [&str; 6] = ["n", "mean", "sd", "median", "least", "greatest"];
    let mut header: Vec<String> = FIRST.map(str::to_owned).to_vec();
    for measure in Measure::ALL {
        header.extend(SPREAD.map(|what| format!("{}_{what}", measure.name())));
    }
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    let mut rows = Vec::new();
    for domain in &summary.domains {
        for solver in &domain.solvers {
            let statuses = solver.statuses;
            let mut row = vec![domain.domain.to_owned(), solver.solver.to_owned()];
            row.push(domain.problems.to_string());
            let counts = [
                statuses.optimal,
                statuses.solved,
                statuses.feasible,
                statuses.infeasible,
                statuses.limit,
            ];
            row.extend(counts.map(|count| count.to_string()));
            for measure in Measure::ALL {
                match solver.spread(measure) {
                    Some(s) => row.extend([
                        s.n.to_string(),
                        s.mean.to_string(),
                        number(s.sd),
                        s.median.to_string(),
                        s.least.to_string(),
                        s.greatest.to_string(),
                    ]),
                    None => {
                        row.push("0".to_owned());
                        row.extend([const { String::new() }; 5]);
                    }
                }
            }
            rows.push(row);
        }
    }
    table(&header, rows)
}

/// One line for each domain and measure.
pub fn anova_csv(summary: &Summary) -> String {
    let header = ["domain", "measure", "groups", "between", "within", "f", "p"];
    let rows = summary.domains.iter().flat_map(|domain| {
        domain.anova.iter().map(|line| {
            let anova = line.anova;
            vec![
                domain.domain.to_owned(),
                line.measure.to_owned(),
                line.groups.join(" "),
                number(anova.map(|anova| anova.between)),
                number(anova.map(|anova| anova.within)),
                number(anova.and_then(|anova| anova.f)),
                number(anova.map(|anova| anova.p)),
            ]
        })
    });
    table(&header, rows)
}

/// One line for each domain and solver that is held against the search.
pub fn relative_csv(summary: &Summary) -> String {
    let header = ["domain", "solver", "n", "mean", "search_mean", "percent", "percent_sd"];
    let rows = summary.domains.iter().flat_map(|domain| {
        domain.relative.iter().map(|line| {
            vec![
                domain.domain.to_owned(),
                line.solver.to_owned(),
                line.n.to_string(),
                line.mean.to_string(),
                line.search.to_string(),
                number(line.percent),
                number(line.percent_sd),
            ]
        })
    });
    table(&header, rows)
}

/// One line for each record, without plans.
pub fn records_csv(entries: &Entries) -> String {
    let header = [
        "domain",
        "problem",
        "seed",
        "redraws",
        "solver",
        "status",
        "horizon",
        "length",
        "goal_difference",
        "adversarial_goals",
        "cooperative_goals",
        "candidates",
        "expansions",
        "nodes",
        "seconds",
    ];
    let rows = entries.values().map(|entry| {
        let record = &entry.record;
        let goals = record.goals.as_ref();
        vec![
            record.domain.clone(),
            record.problem.to_string(),
            record.seed.to_string(),
            record.redraws.to_string(),
            record.solver.clone(),
            record.status.clone(),
            number(record.horizon),
            number(record.length),
            number(record.goal_difference),
            number(goals.map(|goals| goals.adversarial.len())),
            number(goals.map(|goals| goals.cooperative.len())),
            record.candidates.to_string(),
            record.work.expansions.to_string(),
            record.work.nodes.to_string(),
            record.seconds.to_string(),
        ]
    });
    table(&header, rows)
}
