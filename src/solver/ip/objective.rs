//! What both encodings maximise: `|G_X| − |G_C|`, the numerator of the goal difference.

use super::model::{Comparison, Kind, Model, Name, Variable};
use crate::problem::{Problem, Role};

/// Adds the objective, given for each observer the linear expression of how many goals survive for
/// it. Of several enemies the one in least doubt counts, of several friends the one in most: a
/// variable `z` bounded by each of them stands for the side.
pub(super) fn maximise_difference(
    model: &mut Model,
    problem: &Problem,
    counts: &[Vec<(Variable, f64)>],
) {
    for (role, sign) in [(Role::Adversarial, 1.0), (Role::Cooperative, -1.0)] {
        let side = problem.observers().iter().zip(counts).enumerate();
        let side: Vec<_> = side.filter(|(_, (observer, _))| observer.role == role).collect();
        if let [(_, (_, only))] = side.as_slice() {
            for &(variable, goals) in *only {
                model.maximise(variable, sign * goals);
            }
            continue;
        }
        let letter = if role == Role::Adversarial { "zX" } else { "zC" };
        let z = model.add(Name::new(letter, []), Kind::Continuous);
        model.bound(z, 0.0, problem.goals().len() as f64);
        model.maximise(z, sign);
        for (index, (_, count)) in side {
            let terms = count.iter().map(|&(v, goals)| (v, -goals)).chain([(z, 1.0)]).collect();
            let comparison = if sign > 0.0 { Comparison::AtMost } else { Comparison::AtLeast };
            model.row(Name::new("side", [index]), terms, comparison, 0.0);
        }
    }
}
