//! Candidates for invariants: sets of atoms of which at most one may hold.
//!
//! After Helmert 2009 (doi:10.1016/j.artint.2008.10.013), simplified. A candidate such as
//! "of `at(p, ·)` and `in(p, ·)` at most one holds, for each p" has a part for each predicate, with
//! the places of its *key* (here p) and at most one place that is counted over. It passes when each
//! action that adds an atom of it also requires and deletes one with the same key. Where an action
//! does not, what it requires and deletes besides is tried as a further part.
//!
//! Passing here is a good sign only: parameters may coincide, and initial states are not looked at.
//! `exclusive` proves each set atom by atom.

use std::collections::VecDeque;

use rustc_hash::FxHashSet;

use super::atom::{LiftedAtom, Term};
use super::domain::Domain;
use super::predicate::PredicateId;
use super::rule::Rule;

/// Candidates that are looked at, at most.
const MAX_CANDIDATES: usize = 500;

/// One predicate of a candidate.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Part {
    pub predicate: PredicateId,
    /// The places of the key, in the order that all parts share.
    pub key: Vec<u32>,
}

/// The parts, by predicate, of which each is there once at most.
pub(super) type Candidate = Vec<Part>;

/// What an action does to a candidate.
enum Verdict {
    Keeps,
    Breaks,
    /// It adds an atom and nothing makes up for it; each of these parts would.
    Lacks(Vec<Part>),
}

/// The candidates that pass, in the order in which they are found.
pub(super) fn candidates(domain: &Domain, rules: &[Rule<'_>]) -> Vec<Candidate> {
    let guesses: Vec<Rule<'_>> = rules.iter().flat_map(Rule::guesses).collect();
    let rules: Vec<&Rule<'_>> = rules.iter().chain(&guesses).collect();
    let mut changes = vec![false; domain.predicates.len()];
    for atom in rules.iter().flat_map(|rule| &rule.add) {
        changes[atom.predicate.index()] = true;
    }
    let mut open: VecDeque<Candidate> = VecDeque::new();
    for index in (0..changes.len()).filter(|&index| changes[index]) {
        let predicate = PredicateId::new(index);
        let arity = domain.predicates.parameters(predicate).len() as u32;
        // All places but one, and all.
        for left_out in 0..=arity {
            let key = (0..arity).filter(|&place| place != left_out).collect();
            open.push_back(vec![Part { predicate, key }]);
        }
    }
    let mut seen: FxHashSet<Candidate> = open.iter().cloned().collect();
    let mut passed = Vec::new();
    let mut looked_at = 0;
    while let Some(candidate) = open.pop_front() {
        looked_at += 1;
        if looked_at > MAX_CANDIDATES {
            break;
        }
        let verdict = rules.iter().map(|rule| judge(&candidate, rule));
        match verdict.into_iter().find(|verdict| !matches!(verdict, Verdict::Keeps)) {
            None | Some(Verdict::Keeps) => passed.push(candidate),
            Some(Verdict::Breaks) => {}
            Some(Verdict::Lacks(parts)) => {
                for part in parts {
                    let mut larger = candidate.clone();
                    larger.push(part);
                    larger.sort_unstable();
                    if seen.insert(larger.clone()) {
                        open.push_back(larger);
                    }
                }
            }
        }
    }
    passed
}

/// The key of an atom, where its predicate is part of the candidate.
fn key(candidate: &Candidate, atom: &LiftedAtom) -> Option<Vec<Term>> {
    let part = candidate.iter().find(|part| part.predicate == atom.predicate)?;
    Some(part.key.iter().map(|&place| atom.terms[place as usize]).collect())
}

fn judge(candidate: &Candidate, rule: &Rule<'_>) -> Verdict {
    let added: Vec<(Vec<Term>, &LiftedAtom)> =
        rule.add.iter().filter_map(|atom| Some((key(candidate, atom)?, atom))).collect();
    for (number, (wanted, atom)) in added.iter().enumerate() {
        if added[..number].iter().any(|(other, _)| other == wanted) {
            return Verdict::Breaks;
        }
        let goes = |before: &&LiftedAtom| before == atom || rule.delete.contains(before);
        let mut before = rule.positive.iter().filter(goes);
        if before.clone().any(|before| key(candidate, before).as_ref() == Some(wanted)) {
            continue;
        }
        let fresh = before.by_ref().filter_map(|before| {
            let known = candidate.iter().any(|part| part.predicate == before.predicate);
            if known { None } else { part_with_key(before, wanted) }
        });
        return Verdict::Lacks(fresh.collect());
    }
    Verdict::Keeps
}

/// The part by which an atom has the key, with at most one place besides.
fn part_with_key(atom: &LiftedAtom, wanted: &[Term]) -> Option<Part> {
    if atom.terms.len() > wanted.len() + 1 {
        return None;
    }
    let mut key: Vec<u32> = Vec::with_capacity(wanted.len());
    for term in wanted {
        let place = (0..).zip(&atom.terms).find(|(place, at)| *at == term && !key.contains(place));
        key.push(place?.0);
    }
    Some(Part { predicate: atom.predicate, key })
}
