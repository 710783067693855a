//! The figures of a run, in the manner of the paper's Figures 3 and 4.

use super::chart::{Bar, Chart, Colour, Group, Scale, Series};
use crate::experiment::{Configuration, ExperimentError, Figure, Measure, Summary};

/// The solvers shown: the paper's three and the optimum; in Figure 3 also the portfolio, which in
/// Figure 4 has the same answers as the search.
fn shown(summary: &Summary) -> Vec<Configuration> {
    if summary.experiment == Figure::Fig3.name() {
        vec![
            Configuration::Baseline,
            Configuration::Ip,
            Configuration::Search,
            Configuration::Satisficing,
            Configuration::ExactAny,
        ]
    } else {
        vec![
            Configuration::Search,
            Configuration::Obfuscate,
            Configuration::Legible,
            Configuration::ExactUpTo,
            Configuration::ExactAny,
        ]
    }
}

/// How a solver is shown, the same in all figures of an experiment.
fn series(configuration: Configuration) -> Series {
    let colour = match configuration {
        Configuration::Baseline | Configuration::IpPaper | Configuration::Legible => Colour::Grey,
        Configuration::Ip | Configuration::Obfuscate => Colour::Blue,
        Configuration::Search => Colour::Orange,
        Configuration::Satisficing | Configuration::Exact | Configuration::ExactUpTo => {
            Colour::Green
        }
        Configuration::ExactAny => Colour::Purple,
    };
    Series { label: configuration.title().to_owned(), colour }
}

/// Name and SVG text of each figure: one for each measure, and in Figure 4 the relative goal
/// difference.
///
/// # Errors
///
/// [`ExperimentError::Figure`].
pub fn figures(summary: &Summary) -> Result<Vec<(String, String)>, ExperimentError> {
    let mut figures = Vec::new();
    for measure in Measure::ALL {
        let name = format!("{}-{}.svg", summary.experiment, measure.name().replace('_', "-"));
        figures.push((name, of_measure(summary, measure)));
    }
    if summary.domains.iter().any(|domain| !domain.relative.is_empty()) {
        let name = format!("{}-relative.svg", summary.experiment);
        figures.push((name, relative(summary)));
    }
    figures
        .into_iter()
        .map(|(name, chart)| match chart.svg() {
            Ok(svg) => Ok((name, svg)),
            Err(reason) => Err(ExperimentError::Figure { name, reason }),
        })
        .collect()
}

fn of_measure(summary: &Summary, measure: Measure) -> Chart {
    let (axis, scale, what) = match measure {
        Measure::GoalDifference => ("goal difference", Scale::Linear, "Goal difference"),
        Measure::Length => ("actions", Scale::Linear, "Plan length"),
        Measure::Seconds => ("seconds (logarithmic)", Scale::Logarithmic, "Run time"),
    };
    let shown = shown(summary);
    let groups = summary.domains.iter().map(|domain| Group {
        label: domain.title.to_owned(),
        bars: shown
            .iter()
            .map(|&configuration| {
                let solver = domain.of(configuration)?;
                // The best plan found before a limit is no optimum to be measured against.
                if configuration.is_exact() && solver.statuses.optimal < domain.problems as usize {
                    return None;
                }
                let spread = solver.spread(measure)?;
                Some(Bar { height: spread.mean, error: spread.sd })
            })
            .collect(),
    });
    Chart {
        title: format!("{what}: mean and standard deviation"),
        axis: axis.to_owned(),
        scale,
        series: shown.iter().map(|&configuration| series(configuration)).collect(),
        groups: groups.collect(),
    }
}

fn relative(summary: &Summary) -> Chart {
    let shown = [Configuration::Obfuscate, Configuration::Legible];
    let groups = summary.domains.iter().map(|domain| Group {
        label: domain.title.to_owned(),
        bars: shown
            .iter()
            .map(|configuration| {
                let line =
                    domain.relative.iter().find(|line| line.solver == configuration.name())?;
                Some(Bar { height: line.percent?, error: line.percent_sd })
            })
            .collect(),
    });
    Chart {
        title: "Goal difference relative to the search's".to_owned(),
        axis: "per cent".to_owned(),
        scale: Scale::Linear,
        series: shown.map(series).to_vec(),
        groups: groups.collect(),
    }
}
