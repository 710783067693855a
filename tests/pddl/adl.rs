//! Random ADL domains against a naive evaluator, which expands quantifiers and looks at conditions anew in each state.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use mo_copp::pddl::{ExtraInputs, ground, read_condition, read_domain, read_task};
use mo_copp::task::{State, Task};

use crate::common::Dice;

type Atom = (usize, Vec<usize>);
type Atoms = BTreeSet<Atom>;

/// A variable by its depth, or an object.
#[derive(Debug, Clone, Copy)]
enum Term {
    Variable(usize),
    Object(usize),
}

#[derive(Debug, Clone)]
enum Formula {
    Atom(usize, Vec<Term>),
    Equal(Term, Term),
    Not(Box<Formula>),
    And(Vec<Formula>),
    Or(Vec<Formula>),
    Imply(Box<Formula>, Box<Formula>),
    /// Whether for all, the type of the variable, which is the next one.
    Quantified(bool, usize, Box<Formula>),
}

#[derive(Debug, Clone)]
enum Effect {
    Literal(bool, usize, Vec<Term>),
    And(Vec<Effect>),
    When(Formula, Box<Effect>),
    Forall(usize, Box<Effect>),
}

#[derive(Debug)]
struct Action {
    parameters: Vec<usize>,
    precondition: Formula,
    effect: Effect,
    /// A number, or the toll of the first parameter.
    cost: Option<u64>,
}

#[derive(Debug)]
struct World {
    /// The types of the objects: 0 `object`, 1 `thing`; the first object is a constant.
    objects: Vec<usize>,
    tolls: Vec<u64>,
    arities: Vec<usize>,
    actions: Vec<Action>,
    initial: Atoms,
    goals: Vec<Formula>,
}

const TYPES: [&str; 2] = ["object", "thing"];
const MOST_STATES: usize = 150;
const WORLDS: usize = 1500;

fn terms(dice: &mut Dice, count: usize, variables: usize, objects: usize) -> Vec<Term> {
    let term = |dice: &mut Dice| {
        if variables > 0 && dice.percent(80) {
            Term::Variable(dice.below(variables))
        } else {
            Term::Object(dice.below(objects))
        }
    };
    (0..count).map(|_| term(dice)).collect()
}

impl World {
    fn draw(dice: &mut Dice) -> Self {
        let objects: Vec<usize> = (0..dice.between(2, 3)).map(|_| dice.below(2)).collect();
        let mut world = Self {
            tolls: objects.iter().map(|_| dice.below(5) as u64).collect(),
            arities: (0..dice.between(2, 4)).map(|_| dice.pick(&[0, 1, 1, 1, 2])).collect(),
            objects,
            actions: Vec::new(),
            initial: Atoms::new(),
            goals: Vec::new(),
        };
        for _ in 0..dice.between(1, 3) {
            let parameters: Vec<usize> = (0..dice.between(0, 2)).map(|_| dice.below(2)).collect();
            let count = parameters.len();
            let toll = count > 0 && dice.percent(40);
            let depth = dice.below(4);
            world.actions.push(Action {
                precondition: if dice.percent(40) {
                    Formula::And(Vec::new())
                } else {
                    world.formula(dice, count, 1, depth)
                },
                effect: Effect::And(
                    (0..dice.between(1, 4)).map(|_| world.effect(dice, count, 1, 3)).collect(),
                ),
                cost: (!toll).then(|| dice.below(7) as u64),
                parameters,
            });
        }
        let density = dice.between(10, 60);
        world.initial =
            world.ground_atoms().into_iter().filter(|_| dice.percent(density)).collect();
        for _ in 0..3 {
            let goal = world.formula(dice, 0, world.objects.len(), 3);
            world.goals.push(goal);
        }
        world
    }

    fn ground_atoms(&self) -> Vec<Atom> {
        let mut all = Vec::new();
        for (predicate, &arity) in self.arities.iter().enumerate() {
            for number in 0..self.objects.len().pow(arity as u32) {
                let mut rest = number;
                let mut objects = Vec::new();
                for _ in 0..arity {
                    objects.push(rest % self.objects.len());
                    rest /= self.objects.len();
                }
                all.push((predicate, objects));
            }
        }
        all
    }

    fn atom(&self, dice: &mut Dice, variables: usize, objects: usize) -> (usize, Vec<Term>) {
        let predicate = dice.below(self.arities.len());
        (predicate, terms(dice, self.arities[predicate], variables, objects))
    }

    fn formula(&self, dice: &mut Dice, variables: usize, objects: usize, depth: usize) -> Formula {
        let inner = |dice: &mut Dice, variables| {
            Box::new(self.formula(dice, variables, objects, depth.saturating_sub(1)))
        };
        let several = |dice: &mut Dice| {
            (0..dice.between(0, 3)).map(|_| *inner(dice, variables)).collect::<Vec<_>>()
        };
        match if depth == 0 { dice.below(3) } else { dice.below(12) } {
            0 if variables > 0 => {
                let pair = terms(dice, 2, variables, objects);
                Formula::Equal(pair[0], pair[1])
            }
            3..=5 => Formula::And(several(dice)),
            6 | 7 => Formula::Or(several(dice)),
            8 => Formula::Imply(inner(dice, variables), inner(dice, variables)),
            9 => Formula::Not(inner(dice, variables)),
            10 | 11 => {
                Formula::Quantified(dice.percent(50), dice.below(2), inner(dice, variables + 1))
            }
            _ => {
                let (predicate, terms) = self.atom(dice, variables, objects);
                Formula::Atom(predicate, terms)
            }
        }
    }

    fn effect(&self, dice: &mut Dice, variables: usize, objects: usize, depth: usize) -> Effect {
        let inner = |dice: &mut Dice, variables| {
            Box::new(self.effect(dice, variables, objects, depth.saturating_sub(1)))
        };
        match if depth == 0 { 0 } else { dice.below(8) } {
            3 | 4 => {
                Effect::And((0..dice.between(0, 3)).map(|_| *inner(dice, variables)).collect())
            }
            5 | 6 => {
                let condition = self.formula(dice, variables, objects, 2);
                Effect::When(condition, inner(dice, variables))
            }
            7 => Effect::Forall(dice.below(2), inner(dice, variables + 1)),
            _ => {
                let (predicate, terms) = self.atom(dice, variables, objects);
                Effect::Literal(dice.percent(60), predicate, terms)
            }
        }
    }

    fn objects_of(&self, kind: usize) -> impl Iterator<Item = usize> + '_ {
        (0..self.objects.len()).filter(move |&object| kind == 0 || self.objects[object] == kind)
    }

    fn holds(&self, formula: &Formula, values: &mut Vec<usize>, state: &Atoms) -> bool {
        match formula {
            Formula::Atom(predicate, terms) => {
                state.contains(&(*predicate, objects(terms, values)))
            }
            Formula::Equal(one, other) => object(*one, values) == object(*other, values),
            Formula::Not(inner) => !self.holds(inner, values, state),
            Formula::And(parts) => parts.iter().all(|part| self.holds(part, values, state)),
            Formula::Or(parts) => parts.iter().any(|part| self.holds(part, values, state)),
            Formula::Imply(one, other) => {
                !self.holds(one, values, state) || self.holds(other, values, state)
            }
            Formula::Quantified(all, kind, inner) => {
                let mut holds = *all;
                for object in self.objects_of(*kind) {
                    values.push(object);
                    let one = self.holds(inner, values, state);
                    values.pop();
                    holds = if *all { holds && one } else { holds || one };
                }
                holds
            }
        }
    }

    fn change(
        &self,
        effect: &Effect,
        values: &mut Vec<usize>,
        state: &Atoms,
        changes: &mut [Atoms; 2],
    ) {
        match effect {
            Effect::Literal(add, predicate, terms) => {
                changes[usize::from(*add)].insert((*predicate, objects(terms, values)));
            }
            Effect::And(parts) => {
                for part in parts {
                    self.change(part, values, state, changes);
                }
            }
            Effect::When(condition, inner) => {
                if self.holds(condition, values, state) {
                    self.change(inner, values, state, changes);
                }
            }
            Effect::Forall(kind, inner) => {
                for object in self.objects_of(*kind).collect::<Vec<_>>() {
                    values.push(object);
                    self.change(inner, values, state, changes);
                    values.pop();
                }
            }
        }
    }

    /// The name of each applicable action, what it leads to and what it costs.
    fn successors(&self, state: &Atoms) -> BTreeMap<String, (Atoms, u64)> {
        let mut all = BTreeMap::new();
        for (number, action) in self.actions.iter().enumerate() {
            let mut arguments: Vec<Vec<usize>> = vec![Vec::new()];
            for &kind in &action.parameters {
                let with = |before: &Vec<usize>| {
                    let before = before.clone();
                    self.objects_of(kind).map(move |object| [before.as_slice(), &[object]].concat())
                };
                arguments = arguments.iter().flat_map(with).collect();
            }
            for mut values in arguments {
                if !self.holds(&action.precondition, &mut values, state) {
                    continue;
                }
                let mut changes = [Atoms::new(), Atoms::new()];
                self.change(&action.effect, &mut values, state, &mut changes);
                let [delete, add] = changes;
                let next = state.difference(&delete).chain(&add).cloned().collect();
                let words: String = values.iter().map(|object| format!(" o{object}")).collect();
                let cost = action.cost.unwrap_or_else(|| self.tolls[values[0]]);
                all.insert(format!("(a{number}{words})"), (next, cost));
            }
        }
        all
    }

    fn domain(&self) -> String {
        let mut text =
            "(define (domain d) (:requirements :adl :action-costs)\n(:types thing)\n".to_owned();
        text += &format!("(:constants o0 - {})\n(:predicates", TYPES[self.objects[0]]);
        for (number, &arity) in self.arities.iter().enumerate() {
            let variables: String = (0..arity).map(|place| format!(" ?v{place}")).collect();
            text += &format!(" (p{number}{variables})");
        }
        text += ")\n(:functions (total-cost) (toll ?o) - number)\n";
        for (number, action) in self.actions.iter().enumerate() {
            let parameters: String = (0..)
                .zip(&action.parameters)
                .map(|(place, &kind)| format!("?v{place} - {} ", TYPES[kind]))
                .collect();
            let count = action.parameters.len();
            let cost = action.cost.map_or("(toll ?v0)".to_owned(), |cost| cost.to_string());
            text += &format!(
                "(:action a{number} :parameters ({parameters})\n  :precondition {}\n  :effect (and {} (increase (total-cost) {cost})))\n",
                written(&action.precondition, count),
                written_effect(&action.effect, count)
            );
        }
        text + ")"
    }

    fn task(&self) -> String {
        let others = |(number, kind): (usize, &usize)| format!("o{number} - {} ", TYPES[*kind]);
        let objects: String = self.objects.iter().enumerate().skip(1).map(others).collect();
        let atoms: String = self.initial.iter().map(|atom| shown(atom) + " ").collect();
        let toll = |(number, toll)| format!("(= (toll o{number}) {toll}) ");
        let tolls: String = self.tolls.iter().enumerate().map(toll).collect();
        let goal = written(&self.goals[0], 0);
        format!(
            "(define (problem t) (:domain d) (:objects {objects})\n(:init {atoms}{tolls}(= (total-cost) 0))\n(:goal {goal})\n(:metric minimize (total-cost)))"
        )
    }
}

fn object(term: Term, values: &[usize]) -> usize {
    match term {
        Term::Variable(depth) => values[depth],
        Term::Object(object) => object,
    }
}

fn objects(terms: &[Term], values: &[usize]) -> Vec<usize> {
    terms.iter().map(|&term| object(term, values)).collect()
}

fn shown((predicate, objects): &Atom) -> String {
    let words: String = objects.iter().map(|object| format!(" o{object}")).collect();
    format!("(p{predicate}{words})")
}

fn word(term: Term) -> String {
    match term {
        Term::Variable(depth) => format!("?v{depth}"),
        Term::Object(object) => format!("o{object}"),
    }
}

fn written_atom(predicate: usize, terms: &[Term]) -> String {
    let words: String = terms.iter().map(|&term| format!(" {}", word(term))).collect();
    format!("(p{predicate}{words})")
}

fn written(formula: &Formula, depth: usize) -> String {
    let all = |parts: &[Formula]| -> String {
        parts.iter().map(|part| format!(" {}", written(part, depth))).collect()
    };
    match formula {
        Formula::Atom(predicate, terms) => written_atom(*predicate, terms),
        Formula::Equal(one, other) => format!("(= {} {})", word(*one), word(*other)),
        Formula::Not(inner) => format!("(not {})", written(inner, depth)),
        Formula::And(parts) => format!("(and{})", all(parts)),
        Formula::Or(parts) => format!("(or{})", all(parts)),
        Formula::Imply(one, other) => {
            format!("(imply {} {})", written(one, depth), written(other, depth))
        }
        Formula::Quantified(for_all, kind, inner) => {
            let word = if *for_all { "forall" } else { "exists" };
            format!("({word} (?v{depth} - {}) {})", TYPES[*kind], written(inner, depth + 1))
        }
    }
}

fn written_effect(effect: &Effect, depth: usize) -> String {
    match effect {
        Effect::Literal(true, predicate, terms) => written_atom(*predicate, terms),
        Effect::Literal(false, predicate, terms) => {
            format!("(not {})", written_atom(*predicate, terms))
        }
        Effect::And(parts) => {
            let all: String =
                parts.iter().map(|part| format!(" {}", written_effect(part, depth))).collect();
            format!("(and{all})")
        }
        Effect::When(condition, inner) => {
            format!("(when {} {})", written(condition, depth), written_effect(inner, depth))
        }
        Effect::Forall(kind, inner) => {
            format!("(forall (?v{depth} - {}) {})", TYPES[*kind], written_effect(inner, depth + 1))
        }
    }
}

/// The actions that can be taken, what each leads to and costs.
fn successors(task: &Task, state: &State) -> BTreeMap<String, (State, u64)> {
    let mut found = Vec::new();
    task.applicable(state.words(), &mut found);
    let mut all = BTreeMap::new();
    for id in found {
        let mut words = state.words().to_vec();
        task.apply(id, &mut words);
        let action = task.operator(id).action;
        let next = task.state(&task.facts_of(&words)).unwrap();
        let twice = all.insert(task.action_name(action).to_owned(), (next, task.cost(action)));
        assert!(twice.is_none(), "an action has two successors in one state");
    }
    all
}

/// How many worlds had operators that came from one action, how many states were compared.
pub fn compare(worlds: usize) -> (usize, usize) {
    let mut dice = Dice::new(77);
    let (mut several, mut compared) = (0, 0);
    for number in 0..worlds {
        let world = World::draw(&mut dice);
        let (domain_text, task_text) = (world.domain(), world.task());
        let place = || format!("world {number}\n{domain_text}\n{task_text}");
        let domain =
            read_domain(&domain_text).unwrap_or_else(|error| panic!("{error}\n{}", place()));
        let task =
            read_task(&domain, &task_text).unwrap_or_else(|error| panic!("{error}\n{}", place()));
        let conditions = world.goals.iter().map(|goal| {
            read_condition(&domain, &task, &written(goal, 0))
                .unwrap_or_else(|error| panic!("{error}\n{}", place()))
        });
        let more = ExtraInputs { states: Vec::new(), conditions: conditions.collect() };
        let grounded =
            ground(&domain, &task, &more).unwrap_or_else(|error| panic!("{error}\n{}", place()));
        several += usize::from(grounded.task.operators().len() > grounded.task.action_count());
        let mut known: BTreeMap<Atoms, State> = BTreeMap::new();
        let mut back: BTreeMap<State, Atoms> = BTreeMap::new();
        let mut open =
            VecDeque::from([(world.initial.clone(), grounded.task.initial_state().clone())]);
        while let Some((atoms, state)) = open.pop_front() {
            if let Some(before) = known.get(&atoms) {
                assert_eq!(*before, state, "one state has two forms: {}", place());
                continue;
            }
            let other = back.insert(state.clone(), atoms.clone());
            assert_eq!(other, None, "two states have one form: {}", place());
            known.insert(atoms.clone(), state.clone());
            if known.len() > MOST_STATES {
                break;
            }
            compared += 1;
            for (goal, condition) in world.goals.iter().zip(&grounded.conditions) {
                let expected = world.holds(goal, &mut Vec::new(), &atoms);
                let found = condition
                    .as_ref()
                    .is_some_and(|facts| grounded.task.satisfies(state.words(), facts));
                assert_eq!(found, expected, "{atoms:?}, {}: {}", written(goal, 0), place());
            }
            let expected = world.successors(&atoms);
            let found = successors(&grounded.task, &state);
            let names = |all: Vec<&String>| all.into_iter().cloned().collect::<Vec<_>>();
            assert_eq!(
                names(found.keys().collect()),
                names(expected.keys().collect()),
                "{atoms:?}: {}",
                place()
            );
            for ((name, (next, cost)), (state, found)) in
                expected.into_iter().zip(found.into_values())
            {
                assert_eq!(found, cost, "{name}: {}", place());
                open.push_back((next, state));
            }
        }
    }
    (several, compared)
}

#[test]
fn grounded_adl_agrees_with_a_naive_evaluator() {
    let (several, compared) = compare(WORLDS);
    assert!(several > WORLDS / 10 && compared > 5 * WORLDS, "{several} {compared}");
}
