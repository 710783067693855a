//! What the records of benchmarks come to, for each domain and solver.

use std::collections::{BTreeMap, BTreeSet};

use super::{BenchmarkRecord, Benchmarks};
use crate::experiment::records::Entries;
use crate::experiment::statistics::Spread;
use crate::solver::Solver;

/// What a solver answered on the problems of a domain, or of all.
#[derive(Debug, Clone, PartialEq)]
pub struct BenchmarkLine {
    /// The solver.
    pub solver: Solver,
    /// How many problems, those refused included.
    pub problems: usize,
    /// How many of them could not be read.
    pub refused: usize,
    /// How many times the solver broke down.
    pub failed: usize,
    /// How many plans.
    pub plans: usize,
    /// How many proofs that no plan keeps what was asked.
    pub none: usize,
    /// How many plans leave the enemy k goals at least and the friend j at most.
    pub within_bounds: usize,
    /// How many plans are proved best.
    pub optimal: usize,
    /// The goal differences of the plans.
    pub goal_difference: Option<Spread>,
    /// The gaps of the plans with a proved bound.
    pub gap: Option<Spread>,
    /// The numbers of actions of the plans.
    pub length: Option<Spread>,
    /// Seconds of the answers: the plans, and the proofs that there is none.
    pub seconds: Option<Spread>,
    /// The limits that were met, in words, and how often.
    pub limits: BTreeMap<String, usize>,
}

impl BenchmarkLine {
    /// How many problems have an answer: a plan, or the proof that there is none.
    pub fn answered(&self) -> usize {
        self.plans + self.none
    }

    fn of(solver: Solver, records: &[&BenchmarkRecord]) -> Self {
        let count = |wanted: &dyn Fn(&BenchmarkRecord) -> bool| {
            records.iter().filter(|record| wanted(record)).count()
        };
        let spread = |of: &dyn Fn(&BenchmarkRecord) -> Option<f64>| {
            Spread::of(&records.iter().filter_map(|record| of(record)).collect::<Vec<_>>())
        };
        let mut limits = BTreeMap::new();
        for limit in records.iter().filter_map(|record| record.limit.clone()) {
            *limits.entry(limit).or_default() += 1;
        }
        Self {
            solver,
            problems: records.len(),
            refused: count(&|record| record.status == "refused"),
            failed: count(&|record| record.status == "failed"),
            plans: count(&|record| record.plan.is_some()),
            none: count(&|record| record.status == "infeasible"),
            within_bounds: count(&|record| record.within_bounds == Some(true)),
            optimal: count(&|record| record.status == "optimal"),
            goal_difference: spread(&|record| record.goal_difference),
            gap: spread(&|record| record.gap),
            length: spread(&|record| record.length.map(|length| length as f64)),
            seconds: spread(&|record| record.is_answered().then_some(record.seconds)),
            limits,
        }
    }
}

/// What the records of a run come to.
#[derive(Debug, Clone, PartialEq)]
pub struct BenchmarkSummary {
    /// How many problems there are.
    pub problems: usize,
    /// The domains by name, each with a line for every solver.
    pub domains: Vec<(String, Vec<BenchmarkLine>)>,
    /// The same of all domains together.
    pub total: Vec<BenchmarkLine>,
    /// The problems that were refused, or on which a solver broke down, and why: each message of a problem
    /// once.
    pub refusals: Vec<(String, String)>,
}

impl BenchmarkSummary {
    /// Of all records of a run.
    pub fn new(run: &Benchmarks, entries: &Entries<BenchmarkRecord>) -> Self {
        let records: Vec<&BenchmarkRecord> = entries.values().map(|entry| &entry.record).collect();
        let lines = |domain: Option<&str>| -> Vec<BenchmarkLine> {
            let line = |&solver: &Solver| {
                let of = records.iter().copied().filter(|record| {
                    record.solver == solver.name()
                        && domain.is_none_or(|domain| record.domain == domain)
                });
                BenchmarkLine::of(solver, &of.collect::<Vec<_>>())
            };
            run.solvers.iter().map(line).collect()
        };
        let mut names: Vec<&str> = run.problems.iter().map(|p| p.domain.as_str()).collect();
        names.sort_unstable();
        names.dedup();
        let refusal = |record: &&BenchmarkRecord| {
            record.refusal.clone().map(|why| (record.problem.clone(), why))
        };
        let refusals: BTreeSet<(String, String)> = records.iter().filter_map(refusal).collect();
        Self {
            problems: run.problems.len(),
            domains: names.iter().map(|name| ((*name).to_owned(), lines(Some(name)))).collect(),
            total: lines(None),
            refusals: refusals.into_iter().collect(),
        }
    }
}
