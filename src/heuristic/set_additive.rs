//! The set-additive heuristic (Keyder and Geffner 2008, "Heuristics for planning with action costs
//! revisited", doi:10.3233/978-1-58603-891-5-588).
//!
//! Each fact `p` gets a relaxed plan `π(p; s)`, a set of operators: empty where `p` holds in `s`,
//! else `{a} ∪ ⋃ π(q; s)` over the preconditions `q` of the best supporter `a`, the operator that
//! adds `p` with the smallest such set. The value of a goal is the size of the union over its
//! facts. Unlike a sum it counts an operator that serves several facts once.
//!
//! Facts are settled in the order of their values, as in Dijkstra's algorithm, equal values in the
//! order in which they were found. No set is stored: `π` is what can be reached from a fact over
//! best supporters, so its size is counted by walking them, and where an operator has one
//! precondition that does not hold yet it is the size there plus one.

use super::UNREACHABLE;
use crate::task::{Fact, Task};

/// No supporter.
const NONE: u32 = u32::MAX;

/// The heuristic of one task, with room to work in.
#[derive(Debug, Clone)]
pub struct SetAdditive {
    preconditions: Vec<Vec<u32>>,
    add: Vec<Vec<u32>>,
    required_by: Vec<Vec<u32>>,
    without_preconditions: Vec<u32>,
    value: Vec<u32>,
    supporter: Vec<u32>,
    settled: Vec<bool>,
    wanted: Vec<bool>,
    missing: Vec<u32>,
    buckets: Vec<Vec<u32>>,
    mark: Vec<u32>,
    marks: u32,
    stack: Vec<u32>,
}

impl SetAdditive {
    /// Prepares a task.
    pub fn new(task: &Task) -> Self {
        let numbers = |facts: &[Fact]| facts.iter().map(|fact| fact.index() as u32).collect();
        let mut preconditions: Vec<Vec<u32>> = Vec::new();
        let mut add: Vec<Vec<u32>> = Vec::new();
        let mut required_by = vec![Vec::new(); task.fact_count()];
        let mut without_preconditions = Vec::new();
        for (index, operator) in (0..).zip(task.operators()) {
            for fact in &operator.preconditions {
                required_by[fact.index()].push(index);
            }
            if operator.preconditions.is_empty() {
                without_preconditions.push(index);
            }
            preconditions.push(numbers(&operator.preconditions));
            add.push(numbers(&operator.add));
        }
        Self {
            value: vec![UNREACHABLE; task.fact_count()],
            supporter: vec![NONE; task.fact_count()],
            settled: vec![false; task.fact_count()],
            wanted: vec![false; task.fact_count()],
            missing: vec![0; task.operators().len()],
            buckets: Vec::new(),
            mark: vec![0; task.operators().len()],
            marks: 0,
            stack: Vec::new(),
            preconditions,
            add,
            required_by,
            without_preconditions,
        }
    }

    /// The values of several goals in a packed state, written to `values`;
    /// [`UNREACHABLE`] where a goal cannot be reached even when deletes are ignored.
    ///
    /// At most the sum over all operators of the size of their relaxed plans.
    pub fn evaluate(&mut self, task: &Task, words: &[u64], goals: &[&[Fact]], values: &mut [u32]) {
        self.settle(task, words, goals);
        for (goal, value) in goals.iter().zip(values) {
            self.marks += 1;
            self.stack.clear();
            *value = 0;
            for fact in *goal {
                if self.value[fact.index()] == UNREACHABLE {
                    *value = UNREACHABLE;
                    break;
                }
                self.stack.push(fact.index() as u32);
            }
            if *value == 0 {
                *value = self.count_marked();
            }
        }
    }

    /// Counts the operators reached over best supporters from the facts on the stack, those
    /// marked already left out.
    fn count_marked(&mut self) -> u32 {
        let mut count = 0;
        while let Some(fact) = self.stack.pop() {
            let supporter = self.supporter[fact as usize];
            if supporter != NONE && self.mark[supporter as usize] != self.marks {
                self.mark[supporter as usize] = self.marks;
                count += 1;
                self.stack.extend_from_slice(&self.preconditions[supporter as usize]);
            }
        }
        count
    }

    /// The size of `π(a; s)` of an operator whose preconditions are settled.
    fn plan_size(&mut self, operator: u32) -> u32 {
        let preconditions = &self.preconditions[operator as usize];
        let mut open = preconditions.iter().filter(|&&fact| self.value[fact as usize] > 0);
        match (open.next(), open.next()) {
            (None, _) => 1,
            (Some(&only), None) => self.value[only as usize] + 1,
            _ => {
                self.marks += 1;
                self.stack.clear();
                self.stack.extend_from_slice(preconditions);
                self.count_marked() + 1
            }
        }
    }

    /// Settles facts until those of all goals are, or no more can be.
    fn settle(&mut self, task: &Task, words: &[u64], goals: &[&[Fact]]) {
        self.wanted.fill(false);
        let mut open = 0;
        for fact in goals.iter().copied().flatten() {
            let wanted = &mut self.wanted[fact.index()];
            open += usize::from(!*wanted);
            *wanted = true;
        }
        self.value.fill(UNREACHABLE);
        self.supporter.fill(NONE);
        self.settled.fill(false);
        for (missing, preconditions) in self.missing.iter_mut().zip(&self.preconditions) {
            *missing = preconditions.len() as u32;
        }
        if self.buckets.is_empty() {
            self.buckets.push(Vec::new());
        }
        for fact in task.facts_of(words) {
            self.value[fact.index()] = 0;
            self.buckets[0].push(fact.index() as u32);
        }
        for index in 0..self.without_preconditions.len() {
            self.reach(self.without_preconditions[index]);
        }
        let mut value = 0;
        while value < self.buckets.len() {
            let mut position = 0;
            while position < self.buckets[value].len() && open > 0 {
                let fact = self.buckets[value][position] as usize;
                position += 1;
                if self.settled[fact] {
                    continue;
                }
                self.settled[fact] = true;
                open -= usize::from(self.wanted[fact]);
                for index in 0..self.required_by[fact].len() {
                    let operator = self.required_by[fact][index];
                    self.missing[operator as usize] -= 1;
                    if self.missing[operator as usize] == 0 {
                        self.reach(operator);
                    }
                }
            }
            self.buckets[value].clear();
            value += 1;
        }
    }

    /// Offers an operator as supporter of what it adds.
    fn reach(&mut self, operator: u32) {
        let adds_something_new = self.add[operator as usize]
            .iter()
            .any(|&fact| !self.settled[fact as usize] && self.value[fact as usize] > 1);
        if !adds_something_new {
            return;
        }
        let size = self.plan_size(operator);
        for &fact in &self.add[operator as usize] {
            let fact = fact as usize;
            if size < self.value[fact] {
                self.value[fact] = size;
                self.supporter[fact] = operator;
                if self.buckets.len() <= size as usize {
                    self.buckets.resize_with(size as usize + 1, Vec::new);
                }
                self.buckets[size as usize].push(fact as u32);
            }
        }
    }
}
