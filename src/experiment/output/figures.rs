//! The figures of a run, in the manner of the paper's Figures 3 and 4.

use super::chart::{Bar, Chart, Group, Scale};
use crate::experiment::{Entrant, ExperimentError, Figure, Measure, Summary};

/// The solvers shown, with the colour of each: the paper's three and the optimum.
fn shown(summary: &Summary) -> Vec<Entrant> {
    if summary.experiment == Figure::Fig3.name() {
        vec![Entrant::Baseline, Entrant::Ip, Entrant::Search, Entrant::ExactAny]
    } else {
        vec![
            Entrant::Search,
            Entrant::Obfuscate,
            Entrant::Legible,
            Entrant::ExactUpTo,
            Entrant::ExactAny,
        ]
    }
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
    let series = shown(summary);
    let groups = summary.domains.iter().map(|domain| Group {
        label: domain.title.to_owned(),
        bars: series
            .iter()
            .map(|&entrant| {
                let spread = domain.of(entrant)?.spread(measure)?;
                Some(Bar { height: spread.mean, error: spread.sd })
            })
            .collect(),
    });
    Chart {
        title: format!("{what}: mean and standard deviation"),
        axis: axis.to_owned(),
        scale,
        series: series.iter().map(|entrant| entrant.title().to_owned()).collect(),
        groups: groups.collect(),
    }
}

fn relative(summary: &Summary) -> Chart {
    let series = [Entrant::Obfuscate, Entrant::Legible];
    let groups = summary.domains.iter().map(|domain| Group {
        label: domain.title.to_owned(),
        bars: series
            .iter()
            .map(|entrant| {
                let line = domain.relative.iter().find(|line| line.solver == entrant.name())?;
                Some(Bar { height: line.percent?, error: None })
            })
            .collect(),
    });
    Chart {
        title: "Goal difference relative to the search's".to_owned(),
        axis: "per cent".to_owned(),
        scale: Scale::Linear,
        series: series.iter().map(|entrant| entrant.title().to_owned()).collect(),
        groups: groups.collect(),
    }
}
