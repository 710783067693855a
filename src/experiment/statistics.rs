//! Mean, standard deviation and one-way analysis of variance.

use serde::Serialize;
use statrs::function::beta::checked_beta_reg;

/// What a sample of numbers looks like.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Spread {
    /// How many numbers.
    pub n: usize,
    /// Their mean.
    pub mean: f64,
    /// Their standard deviation, that of a sample (divided by n − 1); none for a single number.
    pub sd: Option<f64>,
    /// Half of them are no greater.
    pub median: f64,
    /// The least.
    pub least: f64,
    /// The greatest.
    pub greatest: f64,
}

impl Spread {
    /// Of these numbers; none of none.
    ///
    /// ```
    /// use mo_copp::experiment::statistics::Spread;
    /// let spread = Spread::of(&[2.0, 4.0, 9.0]).unwrap();
    /// assert_eq!((spread.mean, spread.median), (5.0, 4.0));
    /// assert_eq!(spread.sd, Some(13_f64.sqrt()));
    /// ```
    pub fn of(numbers: &[f64]) -> Option<Self> {
        let mut sorted = numbers.to_vec();
        sorted.sort_unstable_by(f64::total_cmp);
        let n = sorted.len();
        let (least, greatest) = (*sorted.first()?, *sorted.last()?);
        let mean = mean(&sorted);
        let sd = (n > 1).then(|| (squares(&sorted, mean) / (n as f64 - 1.0)).sqrt());
        let median = f64::midpoint(sorted[(n - 1) / 2], sorted[n / 2]);
        Some(Self { n, mean, sd, median, least, greatest })
    }
}

fn mean(numbers: &[f64]) -> f64 {
    numbers.iter().sum::<f64>() / numbers.len() as f64
}

/// The sum of the squared distances from a centre.
fn squares(numbers: &[f64], centre: f64) -> f64 {
    numbers.iter().map(|number| (number - centre).powi(2)).sum()
}

/// A one-way analysis of variance for independent groups (Fisher 1925, "Statistical Methods for
/// Research Workers"): could the groups have been drawn from one population?
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Anova {
    /// Degrees of freedom between the groups: their number less one.
    pub between: usize,
    /// Degrees of freedom within the groups: the number of values less that of groups.
    pub within: usize,
    /// The variance between the groups over the variance within them. Without a bound, and left
    /// out, where the groups differ and no group varies within itself.
    pub f: Option<f64>,
    /// How probable so great an F is for groups of one population.
    pub p: f64,
}

impl Anova {
    /// Of these groups. None where the question has no answer: fewer than two groups, an empty one,
    /// no group with two values, or all values equal.
    ///
    /// ```
    /// use mo_copp::experiment::statistics::Anova;
    /// let anova = Anova::of(&[&[1.0, 2.0, 3.0], &[2.0, 3.0, 4.0]]).unwrap();
    /// assert_eq!((anova.between, anova.within, anova.f), (1, 4, Some(1.5)));
    /// ```
    pub fn of(groups: &[&[f64]]) -> Option<Self> {
        let all: Vec<f64> = groups.iter().copied().flatten().copied().collect();
        if groups.len() < 2 || groups.iter().any(|group| group.is_empty()) {
            return None;
        }
        let (between, within) = (groups.len() - 1, all.len() - groups.len());
        let centre = mean(&all);
        let apart: f64 = groups
            .iter()
            .map(|group| group.len() as f64 * (mean(group) - centre).powi(2))
            .sum::<f64>()
            / between as f64;
        let spread: f64 = groups.iter().map(|group| squares(group, mean(group))).sum();
        let equal = all.iter().all(|value| *value == all[0]);
        if within == 0 || equal {
            return None;
        }
        if groups.iter().all(|group| group.iter().all(|value| *value == group[0])) {
            return Some(Self { between, within, f: None, p: 0.0 });
        }
        let f = apart / (spread / within as f64);
        Some(Self { between, within, f: Some(f), p: upper_tail(f, between, within)? })
    }
}

/// How probable a value of at least `f` is under Fisher's F distribution: the regularised
/// incomplete beta function at d₂ / (d₂ + d₁ f).
fn upper_tail(f: f64, between: usize, within: usize) -> Option<f64> {
    let (d1, d2) = (between as f64, within as f64);
    checked_beta_reg(d2 / 2.0, d1 / 2.0, d2 / (d2 + d1 * f)).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(found: f64, expected: f64) {
        let scale = expected.abs().max(f64::MIN_POSITIVE);
        assert!((found - expected).abs() <= 1e-9 * scale, "{found} {expected}");
    }

    /// `scipy.stats.f.sf(f, d1, d2)` of SciPy 1.17.1.
    #[test]
    fn upper_tails_are_those_of_scipy() {
        for (d1, d2, f, expected) in [
            (2, 87, 0.0, 1.0),
            (2, 87, 3.1, 0.050_060_513_663_821_12),
            (2, 87, 50.0, 3.499_271_217_388_582e-15),
            (2, 87, 1e4, 1.556_974_599_941_937_5e-103),
            (2, 87, 1e8, 1.880_504_857_554_766e-277),
            (1, 1, 161.4, 0.050_007_348_139_564_305),
            (5, 3, 2.5, 0.240_536_033_840_662_36),
            (2, 1000, 500.0, 3.054_936_363_499_605e-151),
        ] {
            near(upper_tail(f, d1, d2).unwrap(), expected);
        }
    }
}
