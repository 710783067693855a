//! The set-additive heuristic (Keyder and Geffner 2008, "Heuristics for planning with action costs
//! revisited", doi:10.3233/978-1-58603-891-5-588).
//!
//! Each fact `p` gets a relaxed plan `π(p; s)`, a set of operators: empty where `p` holds in `s`,
//! else `{a} ∪ ⋃ π(q; s)` over the preconditions `q` of the best supporter `a`, the operator that
//! adds `p` with the smallest such set. The value of a goal is the size of the union over its
//! facts. Unlike a sum it counts an operator that serves several facts once.
//!
//! Facts are settled in the order of their values, as in Dijkstra's algorithm, equal values in the
//! order in which they were found. Where an operator has one precondition that does not hold yet
//! its set has one operator more than that one's; where it has several they are united
//! (`supporter_sets`). In very large tasks some sets are not kept: `π` is what can be reached from
//! a fact over best supporters, and is counted by walking them.

use super::UNREACHABLE;
use super::supporter_sets::SupporterSets;
use crate::task::{Action, Fact, Task};

/// The heuristic of one task, with room to work in.
#[derive(Debug, Clone)]
pub struct SetAdditive {
    operators: Operators,
    values: Values,
}

/// What does not change: the task's operators without their delete effects, as numbers.
#[derive(Debug, Clone)]
struct Operators {
    preconditions: Rows,
    add: Rows,
    /// The operators that have each fact as a precondition.
    required_by: Rows,
    without_preconditions: Vec<u32>,
    precondition_counts: Vec<u32>,
}

/// Rows of numbers, one after the other.
#[derive(Debug, Clone)]
struct Rows {
    begins: Vec<u32>,
    items: Vec<u32>,
}

impl Rows {
    fn new(rows: impl Iterator<Item = Vec<u32>>) -> Self {
        let (mut begins, mut items) = (vec![0], Vec::new());
        for row in rows {
            items.extend(row);
            begins.push(items.len() as u32);
        }
        Self { begins, items }
    }

    fn row(&self, number: u32) -> &[u32] {
        let number = number as usize;
        &self.items[self.begins[number] as usize..self.begins[number + 1] as usize]
    }
}

/// What is worked out for one state.
#[derive(Debug, Clone)]
struct Values {
    /// The size of `π` of each fact.
    value: Vec<u32>,
    /// The best supporter of each fact whose value is above 0 and known.
    supporter: Vec<u32>,
    settled: Vec<bool>,
    wanted: Vec<bool>,
    /// How many preconditions of each operator are not settled.
    missing: Vec<u32>,
    /// Facts by value, in the order in which they were found.
    buckets: Vec<Vec<u32>>,
    sets: SupporterSets,
    mark: Vec<u32>,
    marks: u32,
    stack: Vec<u32>,
}

impl SetAdditive {
    /// Prepares a task.
    pub fn new(task: &Task) -> Self {
        let operators = task.operators();
        let numbers = |facts: &[Fact]| facts.iter().map(|fact| fact.index() as u32).collect();
        let mut required_by = vec![Vec::new(); task.fact_count()];
        for (number, operator) in (0..).zip(operators) {
            for fact in &operator.preconditions {
                required_by[fact.index()].push(number);
            }
        }
        let counts: Vec<u32> = operators.iter().map(|op| op.preconditions.len() as u32).collect();
        let free = (0..).zip(&counts).filter(|(_, count)| **count == 0);
        let facts = task.fact_count();
        Self {
            values: Values {
                value: vec![UNREACHABLE; facts],
                supporter: vec![0; facts],
                settled: vec![false; facts],
                wanted: vec![false; facts],
                missing: counts.clone(),
                buckets: vec![Vec::new()],
                sets: SupporterSets::new(operators.len()),
                mark: vec![0; operators.len()],
                marks: 0,
                stack: Vec::new(),
            },
            operators: Operators {
                preconditions: Rows::new(operators.iter().map(|op| numbers(&op.preconditions))),
                add: Rows::new(operators.iter().map(|op| numbers(&op.add))),
                required_by: Rows::new(required_by.into_iter()),
                without_preconditions: free.map(|(number, _)| number).collect(),
                precondition_counts: counts,
            },
        }
    }

    /// The values of several goals in a packed state, written to `values`;
    /// [`UNREACHABLE`] where a goal cannot be reached even when deletes are ignored.
    ///
    /// At most the sum over all operators of the size of their relaxed plans.
    pub fn evaluate(&mut self, task: &Task, words: &[u64], goals: &[&[Fact]], values: &mut [u32]) {
        let (operators, known) = (&self.operators, &mut self.values);
        known.settle(operators, task, words, goals);
        for (goal, value) in goals.iter().zip(values) {
            let facts = goal.iter().map(|fact| fact.index() as u32);
            let unreachable = |fact| known.value[fact as usize] == UNREACHABLE;
            *value = if facts.clone().any(unreachable) {
                UNREACHABLE
            } else {
                known.union_size(operators, facts)
            };
        }
    }
}

impl SetAdditive {
    /// The actions of the relaxed plan of a goal that can be taken at once, sorted: preferred operators (Helmert 2006,
    /// doi:10.1613/jair.1705). Of the state that was evaluated last, with this goal among others; none where it
    /// cannot be reached.
    ///
    /// Linear in the operators of the relaxed plan with their preconditions.
    pub(crate) fn preferred(&mut self, task: &Task, goal: &[Fact], actions: &mut Vec<Action>) {
        actions.clear();
        let (operators, known) = (&self.operators, &mut self.values);
        let facts = || goal.iter().map(|fact| fact.index() as u32);
        if facts().any(|fact| known.value[fact as usize] == UNREACHABLE) {
            return;
        }
        known.visit(operators, facts(), |operator, value| {
            let mut preconditions = operators.preconditions.row(operator).iter();
            if preconditions.all(|&fact| value[fact as usize] == 0) {
                actions.push(task.operators()[operator as usize].action);
            }
        });
        actions.sort_unstable();
        actions.dedup();
    }
}

/// The supporters of those of some settled facts that do not hold in the state.
fn supporters(
    value: &[u32],
    supporter: &[u32],
    facts: impl Iterator<Item = u32>,
) -> impl Iterator<Item = u32> {
    facts.filter(|&fact| value[fact as usize] > 0).map(|fact| supporter[fact as usize])
}

impl Values {
    /// The size of the union of `π` over some settled facts.
    fn union_size(
        &mut self,
        operators: &Operators,
        facts: impl Iterator<Item = u32> + Clone,
    ) -> u32 {
        let supporters = supporters(&self.value, &self.supporter, facts.clone());
        self.sets.size_of_all(supporters).unwrap_or_else(|| self.walk(operators, facts))
    }

    /// The same by walking over best supporters.
    fn walk(&mut self, operators: &Operators, facts: impl Iterator<Item = u32>) -> u32 {
        let mut size = 0;
        self.visit(operators, facts, |_, _| size += 1);
        size
    }

    /// Goes through the union of `π` over some settled facts, with the value of each fact at hand.
    fn visit(
        &mut self,
        operators: &Operators,
        facts: impl Iterator<Item = u32>,
        mut visit: impl FnMut(u32, &[u32]),
    ) {
        self.marks += 1;
        self.stack.clear();
        self.stack.extend(facts);
        while let Some(fact) = self.stack.pop() {
            let supporter = self.supporter[fact as usize];
            if self.value[fact as usize] > 0 && self.mark[supporter as usize] != self.marks {
                self.mark[supporter as usize] = self.marks;
                visit(supporter, &self.value);
                self.stack.extend_from_slice(operators.preconditions.row(supporter));
            }
        }
    }

    /// The size of `π(a; s)` of an operator whose preconditions are settled.
    fn plan_size(&mut self, operators: &Operators, operator: u32) -> u32 {
        let preconditions = operators.preconditions.row(operator);
        let mut open = preconditions.iter().filter(|&&fact| self.value[fact as usize] > 0);
        let supporter = |fact: u32| self.supporter[fact as usize];
        match (open.next(), open.next(), open.next()) {
            (None, ..) => 1,
            (Some(&only), None, _) => self.value[only as usize] + 1,
            (Some(&one), Some(&other), None) => {
                let size = self.sets.size_of_two(supporter(one), supporter(other));
                size.unwrap_or_else(|| self.walk(operators, preconditions.iter().copied())) + 1
            }
            _ => self.union_size(operators, preconditions.iter().copied()) + 1,
        }
    }

    /// Settles facts until those of all goals are, or no more can be.
    fn settle(&mut self, operators: &Operators, task: &Task, words: &[u64], goals: &[&[Fact]]) {
        self.wanted.fill(false);
        let mut open = 0;
        for fact in goals.iter().copied().flatten() {
            let wanted = &mut self.wanted[fact.index()];
            open += usize::from(!*wanted);
            *wanted = true;
        }
        self.value.fill(UNREACHABLE);
        self.settled.fill(false);
        self.sets.clear();
        self.missing.copy_from_slice(&operators.precondition_counts);
        for fact in task.facts_of(words) {
            self.value[fact.index()] = 0;
            self.buckets[0].push(fact.index() as u32);
        }
        for &operator in &operators.without_preconditions {
            self.reach(operators, operator, 0);
        }
        let mut value = 0;
        while value < self.buckets.len() {
            let mut position = 0;
            while position < self.buckets[value].len() && open > 0 {
                let fact = self.buckets[value][position];
                position += 1;
                if self.settled[fact as usize] {
                    continue;
                }
                self.settled[fact as usize] = true;
                open -= usize::from(self.wanted[fact as usize]);
                if value > 0 {
                    self.keep_set(operators, self.supporter[fact as usize]);
                }
                for &operator in operators.required_by.row(fact) {
                    self.missing[operator as usize] -= 1;
                    if self.missing[operator as usize] == 0 {
                        self.reach(operators, operator, value as u32);
                    }
                }
            }
            self.buckets[value].clear();
            value += 1;
        }
    }

    fn keep_set(&mut self, operators: &Operators, operator: u32) {
        let preconditions = operators.preconditions.row(operator).iter().copied();
        self.sets.keep(operator, supporters(&self.value, &self.supporter, preconditions));
    }

    /// Offers an operator as supporter of what it adds. Its last precondition was settled with
    /// `value`, so that its set has at least one operator more.
    fn reach(&mut self, operators: &Operators, operator: u32, value: u32) {
        let add = operators.add.row(operator);
        if add.iter().all(|&fact| self.value[fact as usize] <= value + 1) {
            return;
        }
        let size = self.plan_size(operators, operator);
        for &fact in add {
            if size < self.value[fact as usize] {
                self.value[fact as usize] = size;
                self.supporter[fact as usize] = operator;
                if self.buckets.len() <= size as usize {
                    self.buckets.resize_with(size as usize + 1, Vec::new);
                }
                self.buckets[size as usize].push(fact);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;
    use crate::task::TaskBuilder;

    /// A package goes from here to there by a truck that is elsewhere; a door can be opened meanwhile.
    #[test]
    fn preferred_actions_are_those_of_the_relaxed_plan_that_can_be_taken_at_once() {
        let mut builder = TaskBuilder::default();
        let fact = |builder: &mut TaskBuilder, name: &str| builder.fact(name);
        let names = ["truck away", "truck here", "truck there", "here", "loaded", "there", "open"];
        let facts = names.map(|name| fact(&mut builder, name));
        let [away, near, far, here, loaded, there, open] = facts;
        builder.operator("come", &[away], &[near], &[away]);
        builder.operator("go", &[near], &[far], &[near]);
        builder.operator("load", &[near, here], &[loaded], &[here]);
        builder.operator("unload", &[far, loaded], &[there], &[loaded]);
        builder.operator("open", &[], &[open], &[]);
        builder.operator("close", &[open], &[], &[open]);
        let task = builder.build(&[away, here], &[there]).unwrap();
        let mut heuristic = SetAdditive::new(&task);
        let mut preferred = |state: &[Fact], goal: &[Fact]| {
            let mut value = [0];
            let mut actions = vec![Action::new(0)];
            let state = task.state(state).unwrap();
            heuristic.evaluate(&task, state.words(), &[goal], &mut value);
            heuristic.preferred(&task, goal, &mut actions);
            let names: Vec<&str> = actions.iter().map(|&action| task.action_name(action)).collect();
            (value[0], names.join(" "))
        };
        assert_eq!(preferred(&[away, here], &[there]), (4, "come".to_owned()));
        assert_eq!(preferred(&[near, here], &[there]), (3, "go load".to_owned()));
        assert_eq!(preferred(&[near, here], &[there, open]), (4, "go load open".to_owned()));
        assert_eq!(preferred(&[far, loaded], &[there]), (1, "unload".to_owned()));
        assert_eq!(preferred(&[near, there], &[there]), (0, String::new()));
        assert_eq!(preferred(&[here], &[there]), (UNREACHABLE, String::new()));
    }
}
