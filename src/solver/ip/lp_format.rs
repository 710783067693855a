//! Prints a model in the LP file format that CPLEX, Gurobi, HiGHS, SCIP and others read.

use std::fmt::Write;

use super::model::{Comparison, Kind, Model, VariableData};

/// Lines are broken after this many terms; some readers limit their length.
const TERMS_A_LINE: usize = 8;

fn terms<'a>(text: &mut String, terms: impl Iterator<Item = (&'a VariableData, f64)>) {
    let mut empty = true;
    for (index, (variable, coefficient)) in terms.enumerate() {
        empty = false;
        if index > 0 && index % TERMS_A_LINE == 0 {
            text.push_str("\n   ");
        }
        let sign = if coefficient < 0.0 { '-' } else { '+' };
        // Writing to a text cannot fail.
        let _ = if coefficient.abs() == 1.0 {
            write!(text, " {sign} {}", variable.name)
        } else {
            write!(text, " {sign} {} {}", coefficient.abs(), variable.name)
        };
    }
    if empty {
        text.push_str(" 0");
    }
}

/// A program without a solution, for problems that need none to be called infeasible.
pub(super) fn infeasible(why: &str) -> String {
    format!(
        "\\ infeasible: {why}\nMaximize\n difference: none\nSubject To\n never: none >= 1\n\
         Bounds\n none = 0\nEnd\n"
    )
}

/// The model as LP text. Linear in its size.
pub(super) fn to_lp(model: &Model) -> String {
    let mut text = String::new();
    for note in model.notes() {
        let _ = writeln!(text, "\\ {note}");
    }
    text.push_str("Maximize\n difference:");
    let gains = model.variables().iter().filter(|variable| variable.objective != 0.0);
    terms(&mut text, gains.map(|variable| (variable, variable.objective)));
    text.push_str("\nSubject To\n");
    for row in model.rows() {
        let _ = write!(text, " {}:", row.name);
        let of_row = row.terms.iter();
        terms(&mut text, of_row.map(|&(v, factor)| (&model.variables()[v.index()], factor)));
        let sign = match row.comparison {
            Comparison::AtMost => "<=",
            Comparison::Equal => "=",
            Comparison::AtLeast => ">=",
        };
        let _ = writeln!(text, " {sign} {}", row.right);
    }
    text.push_str("Bounds\n");
    for variable in model.variables() {
        let VariableData { name, kind, lower, upper, .. } = variable;
        if lower == upper {
            let _ = writeln!(text, " {name} = {lower}");
        } else if *kind == Kind::Continuous {
            let _ = writeln!(text, " {lower} <= {name} <= {upper}");
        }
    }
    text.push_str("Binaries\n");
    for variable in model.variables() {
        if variable.kind == Kind::Binary && variable.lower != variable.upper {
            let _ = writeln!(text, " {}", variable.name);
        }
    }
    text.push_str("End\n");
    text
}
