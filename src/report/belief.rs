//! What a belief of many states comes to: in how many of them each fact holds, and each goal.

use serde::Serialize;

use crate::belief::StateCount;
use crate::problem::{Part, Problem, StateNaming, Value};
use crate::task::{Fact, State};
use crate::trace::TracedBelief;

/// The most facts that a summary tells of.
const MAX_SHARES: usize = 2000;

/// A belief in numbers.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BeliefReport {
    /// How many states are held possible.
    pub states: StateCount,
    /// In how many of them a fact holds, for each that holds in one at least, the most telling
    /// first: what is open before what is certain, facts of candidate goals before others, then
    /// those nearest to half of the states.
    pub shares: Vec<Share>,
    /// How many facts more there are than a summary tells of.
    pub left_out: usize,
    /// In how many of them each candidate goal holds, in the problem's order.
    pub goals: Vec<StateCount>,
}

/// In how many states something holds.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Share {
    /// What holds.
    #[serde(flatten)]
    pub feature: Feature,
    /// In how many states.
    pub states: StateCount,
}

/// Something that can hold in a state, in the words of the document.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(untagged)]
pub enum Feature {
    /// A fact by its name.
    Fact {
        /// The name.
        fact: String,
    },
    /// A part of the state that has a value.
    Part {
        /// What has it.
        part: &'static str,
        /// The value.
        value: Value,
    },
}

impl BeliefReport {
    /// Counts over a belief.
    ///
    /// Linear in the states times the groups of facts that exclude each other and the facts of the
    /// goals' conditions; then the facts found are sorted.
    ///
    /// ```
    /// use mo_copp::domain::Document;
    /// use mo_copp::report::BeliefReport;
    /// let document = Document::parse(&std::fs::read_to_string("examples/blocksworld.json")?)?;
    /// let problem = document.problem()?;
    /// let report = BeliefReport::new(&problem, problem.observers()[0].initial_belief.listed().unwrap_or(&[]));
    /// assert_eq!(report.states.as_f64(), 1.0);
    /// assert!(report.goals.iter().all(|goal| goal.as_f64() == 0.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(problem: &Problem, belief: &[State]) -> Self {
        let task = problem.task();
        let mut counts = vec![0; task.fact_count()];
        let mut goals = vec![0; problem.goals().len()];
        for state in belief {
            for fact in task.facts_of(state.words()) {
                counts[fact.index()] += 1;
            }
            for (count, goal) in goals.iter_mut().zip(problem.goals()) {
                *count += u64::from(task.satisfies(state.words(), &goal.condition));
            }
        }
        let exact = |counts: Vec<u64>| counts.into_iter().map(StateCount::Exact).collect();
        let counts: Vec<StateCount> = exact(counts);
        Self::counted(problem, StateCount::Exact(belief.len() as u64), &counts, exact(goals))
    }

    /// Counts over a belief of a replay, listed or not.
    pub(crate) fn of(problem: &Problem, belief: &TracedBelief) -> Self {
        if let Some(states) = belief.as_list() {
            return Self::new(problem, states);
        }
        let task = problem.task();
        let goals = problem.goals().iter().map(|g| belief.count_satisfying(task, &g.condition));
        Self::counted(problem, belief.count(), &belief.fact_counts(task), goals.collect())
    }

    fn counted(
        problem: &Problem,
        states: StateCount,
        counts: &[StateCount],
        goals: Vec<StateCount>,
    ) -> Self {
        let mut found: Vec<(Fact, StateCount)> = told(problem)
            .map(|fact| (fact, counts[fact.index()]))
            .filter(|&(_, holding)| holding != StateCount::Exact(0))
            .collect();
        let in_goals = facts_of_goals(problem);
        found.sort_by(|&(a, of_a), &(b, of_b)| {
            let key =
                |fact: Fact, holding: StateCount| (holding == states, !in_goals[fact.index()]);
            let from_half = |holding: StateCount| (2.0 * holding.as_f64() - states.as_f64()).abs();
            key(a, of_a)
                .cmp(&key(b, of_b))
                .then(from_half(of_a).total_cmp(&from_half(of_b)))
                .then(a.index().cmp(&b.index()))
        });
        let left_out = found.len().saturating_sub(MAX_SHARES);
        found.truncate(MAX_SHARES);
        let share = |(fact, states)| Share { feature: Feature::new(problem, fact), states };
        Self { states, shares: found.into_iter().map(share).collect(), left_out, goals }
    }
}

/// The facts that the label of a state tells of.
fn told(problem: &Problem) -> Box<dyn Iterator<Item = Fact> + '_> {
    let all = problem.task().fact_count();
    match problem.naming() {
        StateNaming::Parts(parts) => {
            Box::new(parts.iter().flat_map(|part| part.values.iter().map(|&(fact, _)| fact)))
        }
        StateNaming::FirstFacts { count } => Box::new((0..all.min(*count)).map(Fact::new)),
        StateNaming::Facts => Box::new((0..all).map(Fact::new)),
        // Each state is a name of its own: there is nothing that several have in common.
        StateNaming::Names | StateNaming::Cells { .. } => Box::new(std::iter::empty()),
    }
}

fn facts_of_goals(problem: &Problem) -> Vec<bool> {
    let mut found = vec![false; problem.task().fact_count()];
    for fact in problem.goals().iter().flat_map(|goal| &goal.condition) {
        found[fact.index()] = true;
    }
    found
}

impl Feature {
    fn new(problem: &Problem, fact: Fact) -> Self {
        let named = |part: &Part| {
            let value = part.values.iter().find(|&&(known, _)| known == fact)?;
            Some(Self::Part { part: part.key, value: value.1 })
        };
        let part = match problem.naming() {
            StateNaming::Parts(parts) => parts.iter().find_map(named),
            _ => None,
        };
        part.unwrap_or_else(|| Self::Fact { fact: problem.task().fact_name(fact).to_owned() })
    }
}
