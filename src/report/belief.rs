//! What a belief of many states comes to: in how many of them each fact holds, and each goal.

use serde::Serialize;

use crate::problem::{Part, Problem, StateNaming, Value};
use crate::task::{Fact, State};

/// The most facts that a summary tells of.
const MAX_SHARES: usize = 2000;

/// A belief in numbers.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct BeliefReport {
    /// How many states are held possible.
    pub states: usize,
    /// In how many of them a fact holds, for each that holds in one at least, the most telling
    /// first: what is open before what is certain, facts of candidate goals before others, then
    /// those nearest to half of the states.
    pub shares: Vec<Share>,
    /// How many facts more there are than a summary tells of.
    pub left_out: usize,
    /// In how many of them each candidate goal holds, in the problem's order.
    pub goals: Vec<usize>,
}

/// In how many states something holds.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Share {
    /// What holds.
    #[serde(flatten)]
    pub feature: Feature,
    /// In how many states.
    pub states: usize,
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
    /// let report = BeliefReport::new(&problem, &problem.observers()[0].initial_belief);
    /// assert_eq!(report.states, 1);
    /// assert_eq!(report.goals, [0; 5]);
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
                *count += usize::from(task.satisfies(state.words(), &goal.condition));
            }
        }
        let mut found: Vec<(Fact, usize)> = told(problem)
            .map(|fact| (fact, counts[fact.index()]))
            .filter(|&(_, states)| states > 0)
            .collect();
        let in_goals = facts_of_goals(problem);
        found.sort_by_key(|&(fact, states)| {
            let certain = states == belief.len();
            (certain, !in_goals[fact.index()], (2 * states).abs_diff(belief.len()), fact.index())
        });
        let left_out = found.len().saturating_sub(MAX_SHARES);
        found.truncate(MAX_SHARES);
        let share = |(fact, states)| Share { feature: Feature::new(problem, fact), states };
        Self {
            states: belief.len(),
            shares: found.into_iter().map(share).collect(),
            left_out,
            goals,
        }
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
