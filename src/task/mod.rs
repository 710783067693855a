//! The planning task: grounded STRIPS.
//!
//! A task `P = ⟨F, Op, I, G_A⟩` (Definition 1 of Kulkarni, Srivastava and Kambhampati) has facts,
//! operators with preconditions, add effects and delete effects, an initial state and a goal. Its
//! transition function is `Γ(s, a) = (s \ delete(a)) ∪ add(a)` where `s ⊨ pre(a)`, else undefined.
//!
//! - `fact` numbers the facts and packs them into machine words,
//! - `state` is a packed set of facts,
//! - `operator` is one grounded operator; operators that share an *action* name are one action to
//!   the plan, the sensors and the integer programs (moving north is one action, with one operator
//!   for each cell),
//! - `builder` checks a task once and makes it,
//! - `successors` finds the applicable operators of a state,
//! - `space` numbers states as they are met and remembers their successors.

mod builder;
mod fact;
mod group_order;
mod operator;
mod space;
mod state;
mod successors;

use std::sync::{Arc, OnceLock};

pub use builder::{TaskBuilder, TaskError};
pub use fact::Fact;
pub use operator::{Action, Operator, OperatorId};
#[cfg(feature = "full")]
pub(crate) use space::Edge;
pub(crate) use space::{StateId, StateSpace};
pub use state::State;

use fact::Layout;
use group_order::GroupOrder;
use successors::SuccessorGenerator;

/// A grounded STRIPS task, checked by [`TaskBuilder`].
#[derive(Debug, Clone)]
pub struct Task {
    fact_names: Vec<Arc<str>>,
    layout: Layout,
    action_names: Vec<String>,
    operators: Vec<Operator>,
    /// Whether two operators of one action do the same, so that both may be applicable.
    alike: bool,
    initial_state: State,
    goal: Vec<Fact>,
    costs: Option<Box<[u64]>>,
    successors: SuccessorGenerator,
    /// Made when it is asked for.
    group_order: OnceLock<GroupOrder>,
}

impl Task {
    /// How many facts the task has; they are numbered from 0.
    pub fn fact_count(&self) -> usize {
        self.fact_names.len()
    }

    /// The facts, in order.
    pub fn facts(&self) -> impl Iterator<Item = Fact> + '_ {
        (0..self.fact_names.len()).map(Fact::new)
    }

    /// The name of a fact.
    pub fn fact_name(&self, fact: Fact) -> &str {
        &self.fact_names[fact.index()]
    }

    /// The name of a fact, shared with the task: labels of millions of states repeat few names.
    pub(crate) fn shared_fact_name(&self, fact: Fact) -> Arc<str> {
        Arc::clone(&self.fact_names[fact.index()])
    }

    /// How many actions (operator names) there are; they are numbered from 0.
    pub fn action_count(&self) -> usize {
        self.action_names.len()
    }

    /// The name of an action, as plans print it.
    pub fn action_name(&self, action: Action) -> &str {
        &self.action_names[action.index()]
    }

    /// The action of this name. Linear in the number of actions.
    pub fn action_named(&self, name: &str) -> Option<Action> {
        self.action_names.iter().position(|known| known == name).map(Action::new)
    }

    /// All grounded operators; an [`OperatorId`] is an index into them.
    pub fn operators(&self) -> &[Operator] {
        &self.operators
    }

    /// All grounded operators with their ids.
    pub fn operator_ids(&self) -> impl Iterator<Item = (OperatorId, &Operator)> {
        self.operators
            .iter()
            .enumerate()
            .map(|(index, operator)| (OperatorId::new(index), operator))
    }

    /// One operator.
    pub fn operator(&self, id: OperatorId) -> &Operator {
        &self.operators[id.index()]
    }

    /// The initial state `I`.
    pub fn initial_state(&self) -> &State {
        &self.initial_state
    }

    /// The goal `G_A`, a conjunction of facts.
    pub fn goal(&self) -> &[Fact] {
        &self.goal
    }

    /// Whether its actions have costs; where they have none, only the length of a plan counts.
    pub fn has_costs(&self) -> bool {
        self.costs.is_some()
    }

    /// What an action costs; 0 where the task has no costs.
    pub fn cost(&self, action: Action) -> u64 {
        self.costs.as_ref().map_or(0, |costs| costs[action.index()])
    }

    /// What an action counts under a cost limit: its cost, or 1 where the task has none.
    pub fn step_cost(&self, action: Action) -> u64 {
        self.costs.as_ref().map_or(1, |costs| costs[action.index()])
    }

    /// How facts are packed into the words of a state.
    pub(crate) fn layout(&self) -> &Layout {
        &self.layout
    }

    /// An order of the groups in which those that operators touch together are near. Worked out once.
    pub(crate) fn group_order(&self) -> &GroupOrder {
        self.group_order.get_or_init(|| GroupOrder::new(&self.layout, &self.operators))
    }

    /// The groups of facts of which at most one holds in any state (see [`TaskBuilder::exclusive`]), each
    /// in the order of its facts; a fact that excludes no other is a group of its own.
    pub fn exclusive_groups(&self) -> Vec<Vec<Fact>> {
        let mut groups = vec![Vec::new(); self.layout.group_count()];
        for fact in self.facts() {
            groups[self.layout.group(fact)].push(fact);
        }
        groups
    }

    /// Packs a set of facts into a state.
    ///
    /// # Errors
    ///
    /// Two of the facts that exclude each other (they share a group, see
    /// [`TaskBuilder::exclusive`]).
    pub fn state(&self, facts: &[Fact]) -> Result<State, (Fact, Fact)> {
        self.layout.pack(facts)
    }

    /// Whether a packed state satisfies a conjunction of facts.
    pub fn satisfies(&self, words: &[u64], condition: &[Fact]) -> bool {
        condition.iter().all(|&fact| self.layout.holds(words, fact))
    }

    /// The facts that hold in a packed state, in order. Linear in the number of groups of facts
    /// that exclude each other.
    pub fn facts_of(&self, words: &[u64]) -> Vec<Fact> {
        self.layout.holding(words)
    }

    /// Writes every operator applicable in a packed state into `found`, in the order of their ids; of several of one
    /// action, which do the same then, the first.
    pub fn applicable(&self, words: &[u64], found: &mut Vec<OperatorId>) {
        self.successors.applicable(&self.layout, words, found);
        if self.alike {
            let mut kept = 0;
            for place in 0..found.len() {
                let action = self.operator(found[place]).action;
                if found[..kept].iter().all(|&other| self.operator(other).action != action) {
                    found[kept] = found[place];
                    kept += 1;
                }
            }
            found.truncate(kept);
        }
    }

    /// Writes `(s \ delete) ∪ add` over the packed state in `words`.
    pub fn apply(&self, operator: OperatorId, words: &mut [u64]) {
        let operator = self.operator(operator);
        for &fact in &operator.delete {
            self.layout.remove(words, fact);
        }
        for &fact in &operator.add {
            self.layout.insert(words, fact);
        }
    }
}
