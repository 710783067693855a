//! Goals that may still come: relaxed reachability of the candidate goals from a belief.
//!
//! Which goals some continuation can make hold is a planning question for each goal. Here the
//! delete relaxation answers it (Bonet and Geffner 2001, "Planning as heuristic search",
//! doi:10.1016/S0004-3702(01)00108-4): the facts of all believed states together, no operator
//! deletes anything. What is out of reach then is out of reach from every state of the belief, so
//! no goal that may still come is ruled out. The other way round it may err: a goal that is out of
//! reach can be taken for one that may come.

use rustc_hash::FxHashMap;

use fixedbitset::FixedBitSet;

use crate::goal_difference::GoalSet;
use crate::problem::Problem;
use crate::task::{Fact, State, Task};

/// The operators by the facts that they need, made once for a problem.
#[derive(Debug)]
pub struct ReachableGoals<'a> {
    problem: &'a Problem,
    /// For each fact the operators that need it, each as often as it stands in a precondition.
    needing: Vec<Vec<u32>>,
    /// How many preconditions each operator has.
    missing: Vec<u32>,
    /// Answers for the sets of facts that were asked about.
    known: FxHashMap<FixedBitSet, GoalSet>,
}

impl<'a> ReachableGoals<'a> {
    /// Linear in the preconditions of all operators.
    pub fn new(problem: &'a Problem) -> Self {
        let task = problem.task();
        let mut needing = vec![Vec::new(); task.fact_count()];
        for (number, operator) in (0..).zip(task.operators()) {
            for fact in &operator.preconditions {
                needing[fact.index()].push(number);
            }
        }
        let missing = task.operators().iter().map(|o| o.preconditions.len() as u32).collect();
        Self { problem, needing, missing, known: FxHashMap::default() }
    }

    /// The candidate goals that hold in the relaxation, now or later. A goal that is not among them
    /// holds in no state that any sequence of actions leads to from any state of the belief.
    ///
    /// Linear in the facts of the belief's states, and in the preconditions and effects of all
    /// operators; a set of facts that was asked about before costs one look-up.
    ///
    /// ```
    /// use mo_copp::{domain::Delivery, trace::ReachableGoals};
    /// let problem = Delivery::figure_1().problem()?;
    /// let start = problem.task().initial_state().clone();
    /// // No package is delivered yet, and every pair may still be.
    /// assert_eq!(ReachableGoals::new(&problem).from(&[start]).len(), 6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from(&mut self, belief: &[State]) -> GoalSet {
        let task = self.problem.task();
        let mut facts = FixedBitSet::with_capacity(task.fact_count());
        for state in belief {
            for fact in task.facts_of(state.words()) {
                facts.insert(fact.index());
            }
        }
        self.from_facts(facts)
    }

    /// The same for all facts that hold in some believed state.
    pub fn from_facts(&mut self, facts: FixedBitSet) -> GoalSet {
        if let Some(known) = self.known.get(&facts) {
            return known.clone();
        }
        let found = self.explored(facts.clone());
        self.known.insert(facts, found.clone());
        found
    }

    fn explored(&self, mut facts: FixedBitSet) -> GoalSet {
        let task: &Task = self.problem.task();
        let goals = self.problem.goals();
        let mut found = GoalSet::none(goals.len());
        let mut missing = self.missing.clone();
        let mut queue: Vec<usize> = facts.ones().collect();
        let add = |number: usize, facts: &mut FixedBitSet, queue: &mut Vec<usize>| {
            for fact in &task.operators()[number].add {
                if !facts.put(fact.index()) {
                    queue.push(fact.index());
                }
            }
        };
        for number in (0..missing.len()).filter(|&number| missing[number] == 0) {
            add(number, &mut facts, &mut queue);
        }
        let mut at = 0;
        while let Some(&fact) = queue.get(at) {
            at += 1;
            for &number in &self.needing[fact] {
                let left = &mut missing[number as usize];
                *left -= 1;
                if *left == 0 {
                    add(number as usize, &mut facts, &mut queue);
                }
            }
        }
        for (index, goal) in goals.iter().enumerate() {
            if goal.condition.iter().all(|fact: &Fact| facts.contains(fact.index())) {
                found.insert(index);
            }
        }
        found
    }
}
