//! What PDDL has and this reader does not.

use super::error::PddlError;
use super::expression::{Expression, Expressions};

/// What is read, for errors.
const READ: &str = "what docs/pddl.md lists: STRIPS, :adl, :typing, :action-costs";

/// The requirements that are met, and one that the STRIPS tasks of PSR (IPC 2004) declare without a
/// `:derived`, which is refused where it stands.
const MET: [&str; 13] = [
    ":strips",
    ":typing",
    ":negation",
    ":equality",
    ":negative-preconditions",
    ":disjunctive-preconditions",
    ":existential-preconditions",
    ":universal-preconditions",
    ":quantified-preconditions",
    ":conditional-effects",
    ":adl",
    ":action-costs",
    ":derived-predicates",
];

/// Names the feature that a word of PDDL belongs to.
const FEATURES: &[(&str, &str)] = &[
    ("preference", ":preferences"),
    ("oneof", ":non-deterministic"),
    ("probabilistic", ":probabilistic-effects"),
    ("increase", ":action-costs in an effect"),
    ("decrease", ":numeric-fluents"),
    ("assign", ":numeric-fluents"),
    ("scale-up", ":numeric-fluents"),
    ("scale-down", ":numeric-fluents"),
    ("<", ":numeric-fluents"),
    (">", ":numeric-fluents"),
    ("<=", ":numeric-fluents"),
    (">=", ":numeric-fluents"),
    ("at", ":timed-initial-literals"),
    (":derived", ":derived-predicates"),
    (":axiom", ":derived-predicates"),
    (":constraints", ":constraints"),
    (":durative-action", ":durative-actions"),
    (":process", ":time"),
    (":event", ":time"),
    (":timeless", ":timeless of an older PDDL"),
    (":vars", ":vars of an older PDDL"),
    (":duration", ":durative-actions"),
    (":condition", ":durative-actions"),
    (":cost", ":action-costs"),
];

/// The error for a word that belongs to a feature not read; none for another word.
pub(super) fn unsupported(place: Expression<'_>, word: Expression<'_>) -> Option<PddlError> {
    let (_, feature) = FEATURES.iter().find(|(known, _)| word.is(known))?;
    Some(place.wrong(format!("{}, which needs {feature}", place.shown()), READ))
}

/// Checks a `:requirements` section.
pub(super) fn check_requirements(items: Expressions<'_>) -> Result<(), PddlError> {
    for item in items {
        match item.symbol() {
            Some(_) if MET.iter().any(|met| item.is(met)) => {}
            Some(symbol) if symbol.starts_with(':') => {
                let found = format!("the unsupported requirement {}", item.shown());
                return Err(item.wrong(found, READ));
            }
            _ => return Err(item.expected("a requirement, as in :strips")),
        }
    }
    Ok(())
}
