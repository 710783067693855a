//! Random domains against an oracle that follows the definitions: it tries every action with all
//! objects in every state and knows nothing of reachability, invariants or packing.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use mo_copp::pddl::{
    ExtraInputs, Grounded, ground, read_condition, read_domain, read_state, read_task,
};
use mo_copp::task::State;

use crate::common::Dice;

/// A predicate and objects, by number.
type Atom = (usize, Vec<usize>);
type Atoms = BTreeSet<Atom>;

#[derive(Debug, Clone, Copy, PartialEq)]
enum Term {
    Parameter(usize),
    Object(usize),
}

/// `predicate` is none for an equality.
#[derive(Debug, Clone)]
struct Literal {
    negated: bool,
    predicate: Option<usize>,
    terms: Vec<Term>,
}

#[derive(Debug)]
struct Action {
    parameters: Vec<usize>,
    precondition: Vec<Literal>,
    effect: Vec<Literal>,
}

/// Types are 0 `object`, 1, 2 below 1, 3.
#[derive(Debug)]
struct World {
    /// The type of each object; the first is a constant.
    objects: Vec<usize>,
    /// The types of the parameters of each predicate.
    predicates: Vec<Vec<usize>>,
    actions: Vec<Action>,
    states: Vec<Atoms>,
    goals: Vec<Vec<Literal>>,
}

const TYPES: [&str; 4] = ["object", "t1", "t2", "t3"];
const ABOVE: [&[usize]; 4] = [&[0], &[0, 1], &[0, 1, 2], &[0, 3]];
const CONSTANTS: usize = 1;
const MOST_STATES: usize = 400;
const WORLDS: usize = 3000;

fn is_a(below: usize, above: usize) -> bool {
    ABOVE[below].contains(&above)
}

impl World {
    fn draw(dice: &mut Dice) -> Self {
        let objects: Vec<usize> = (0..dice.between(2, 4)).map(|_| dice.below(4)).collect();
        let shape = |dice: &mut Dice| {
            (0..dice.pick(&[0, 1, 1, 2, 2])).map(|_| dice.pick(&[0, 0, 1, 2, 3])).collect()
        };
        let predicates: Vec<Vec<usize>> = (0..dice.between(2, 4)).map(|_| shape(dice)).collect();
        let mut world = Self {
            objects,
            predicates,
            actions: Vec::new(),
            states: Vec::new(),
            goals: Vec::new(),
        };
        for _ in 0..dice.between(1, 4) {
            let parameters: Vec<usize> =
                (0..dice.between(0, 3)).map(|_| dice.pick(&[0, 0, 1, 2, 3])).collect();
            let mut precondition = world.literals(dice, &parameters, 0, 4, true, false);
            let mut effect = world.literals(dice, &parameters, 1, 4, false, false);
            // Something moves: what holds before is taken away for something like it.
            let moved = world.literals(dice, &parameters, 2, 2, false, false);
            if let [from, to] = &moved[..]
                && dice.percent(60)
            {
                let (mut from, mut to) = (from.clone(), to.clone());
                if dice.percent(60) {
                    effect.clear();
                }
                (from.negated, to.negated) = (false, false);
                precondition.push(from.clone());
                from.negated = true;
                effect.extend([from, to]);
            }
            world.actions.push(Action { parameters, precondition, effect });
        }
        let all = world.ground_atoms();
        let density = dice.between(5, 60);
        for _ in 0..dice.pick(&[1, 1, 2, 3]) {
            let state = all.iter().filter(|_| dice.percent(density)).cloned().collect();
            world.states.push(state);
        }
        for _ in 0..3 {
            let goal = world.literals(dice, &[], 0, 3, true, true);
            world.goals.push(goal);
        }
        world
    }

    /// Literals whose terms could be of the types wanted. In actions only the constants are known.
    fn literals(
        &self,
        dice: &mut Dice,
        parameters: &[usize],
        least: usize,
        most: usize,
        condition: bool,
        ground: bool,
    ) -> Vec<Literal> {
        let mut literals = Vec::new();
        let constants = 0..if ground { self.objects.len() } else { CONSTANTS };
        let terms: Vec<Term> =
            (0..parameters.len()).map(Term::Parameter).chain(constants.map(Term::Object)).collect();
        for _ in 0..dice.between(least, most) {
            if condition && !terms.is_empty() && dice.percent(15) {
                let terms = vec![dice.pick(&terms), dice.pick(&terms)];
                literals.push(Literal { negated: dice.percent(70), predicate: None, terms });
                continue;
            }
            let predicate = dice.below(self.predicates.len());
            let fitting = |&wanted: &usize| -> Vec<Term> {
                let fits = |term: &&Term| match **term {
                    Term::Object(object) => is_a(self.objects[object], wanted),
                    Term::Parameter(position) => {
                        let found = parameters[position];
                        is_a(found, wanted) || is_a(wanted, found)
                    }
                };
                terms.iter().filter(fits).copied().collect()
            };
            let choices: Vec<Vec<Term>> = self.predicates[predicate].iter().map(fitting).collect();
            if choices.iter().all(|choice| !choice.is_empty()) {
                let terms = choices.iter().map(|choice| dice.pick(choice)).collect();
                let negated = dice.percent(if condition { 30 } else { 45 });
                literals.push(Literal { negated, predicate: Some(predicate), terms });
            }
        }
        literals
    }

    fn ground_atoms(&self) -> Vec<Atom> {
        let mut atoms = Vec::new();
        for (predicate, types) in self.predicates.iter().enumerate() {
            for objects in self.tuples(types) {
                atoms.push((predicate, objects));
            }
        }
        atoms
    }

    /// All tuples of objects of these types.
    fn tuples(&self, types: &[usize]) -> Vec<Vec<usize>> {
        let mut tuples = vec![Vec::new()];
        for &wanted in types {
            let mut longer = Vec::new();
            for tuple in tuples {
                for (object, &found) in self.objects.iter().enumerate() {
                    if is_a(found, wanted) {
                        longer.push([&tuple[..], &[object]].concat());
                    }
                }
            }
            tuples = longer;
        }
        tuples
    }

    fn object(object: usize) -> String {
        if object < CONSTANTS { format!("c{object}") } else { format!("o{object}") }
    }

    fn atom((predicate, objects): &Atom) -> String {
        let mut text = format!("(p{predicate}");
        for &object in objects {
            text += &format!(" {}", Self::object(object));
        }
        text + ")"
    }

    fn literal(literal: &Literal) -> String {
        let mut text =
            literal.predicate.map_or("(=".to_owned(), |predicate| format!("(P{predicate}"));
        for &term in &literal.terms {
            text += &match term {
                Term::Parameter(position) => format!(" ?x{position}"),
                Term::Object(object) => format!(" {}", Self::object(object)),
            };
        }
        text.push(')');
        if literal.negated { format!("(not {text})") } else { text }
    }

    fn conjunction(literals: &[Literal]) -> String {
        let all: Vec<String> = literals.iter().map(Self::literal).collect();
        format!("(and {})", all.join(" "))
    }

    fn state(state: &Atoms) -> String {
        state.iter().map(Self::atom).collect::<Vec<_>>().join(" ")
    }

    fn domain(&self) -> String {
        let typed = |name: String, kind: usize| format!("{name} - {}", TYPES[kind]);
        let mut text =
            "(define (domain d) (:types t1 t3 - object t2 - t1)\n (:constants".to_owned();
        for object in 0..CONSTANTS {
            text += &format!(" {}", typed(Self::object(object), self.objects[object]));
        }
        text += ")\n (:predicates";
        for (number, types) in self.predicates.iter().enumerate() {
            text += &format!(" (p{number}");
            for (position, &kind) in types.iter().enumerate() {
                text += &format!(" {}", typed(format!("?x{position}"), kind));
            }
            text.push(')');
        }
        text.push(')');
        for (number, action) in self.actions.iter().enumerate() {
            text += &format!("\n (:action a{number} :parameters (");
            for (position, &kind) in action.parameters.iter().enumerate() {
                text += &format!(" {}", typed(format!("?x{position}"), kind));
            }
            let (pre, effect) =
                (Self::conjunction(&action.precondition), Self::conjunction(&action.effect));
            text += &format!(")\n  :precondition {pre}\n  :effect {effect})");
        }
        text + ")"
    }

    fn task(&self) -> String {
        let mut text = "(define (problem p) (:domain d) (:objects".to_owned();
        for object in CONSTANTS..self.objects.len() {
            text += &format!(" {} - {}", Self::object(object), TYPES[self.objects[object]]);
        }
        let (init, goal) = (Self::state(&self.states[0]), Self::conjunction(&self.goals[0]));
        text + &format!(")\n (:init {init})\n (:goal {goal}))")
    }

    fn holds(
        literals: &[Literal],
        objects: &[usize],
        mut atom_holds: impl FnMut(&Literal, &Atom) -> bool,
    ) -> bool {
        literals.iter().all(|literal| {
            let terms = ground_terms(literal, objects);
            match literal.predicate {
                None => (terms[0] == terms[1]) != literal.negated,
                Some(predicate) => atom_holds(literal, &(predicate, terms)),
            }
        })
    }

    /// Every action with every choice of objects: its name, its number, the objects.
    fn instances(&self) -> Vec<(String, usize, Vec<usize>)> {
        let mut instances = Vec::new();
        for (number, action) in self.actions.iter().enumerate() {
            for objects in self.tuples(&action.parameters) {
                let mut name = format!("(a{number}");
                for &object in &objects {
                    name += &format!(" {}", Self::object(object));
                }
                instances.push((name + ")", number, objects));
            }
        }
        instances
    }

    fn satisfies(state: &Atoms, literals: &[Literal], objects: &[usize]) -> bool {
        Self::holds(literals, objects, |literal, atom| state.contains(atom) != literal.negated)
    }

    fn effects(&self, action: usize, objects: &[usize]) -> (Atoms, Atoms) {
        let mut parts = (Atoms::new(), Atoms::new());
        for literal in &self.actions[action].effect {
            let part = if literal.negated { &mut parts.1 } else { &mut parts.0 };
            part.insert((literal.predicate.unwrap(), ground_terms(literal, objects)));
        }
        parts.1 = &parts.1 - &parts.0;
        parts
    }

    fn successors(&self, state: &Atoms) -> BTreeMap<String, Atoms> {
        let mut successors = BTreeMap::new();
        for (name, action, objects) in self.instances() {
            if Self::satisfies(state, &self.actions[action].precondition, &objects) {
                let (add, delete) = self.effects(action, &objects);
                successors.insert(name, &(state - &delete) | &add);
            }
        }
        successors
    }

    /// The names of actions that can apply when what has held may hold again and what has been
    /// false may be false again.
    fn relaxed(&self) -> BTreeSet<String> {
        let mut hold = Atoms::new();
        let mut always = self.states[0].clone();
        for state in &self.states {
            hold = &hold | state;
            always = &always & state;
        }
        let mut names = BTreeSet::new();
        loop {
            let known = names.len();
            for (name, action, objects) in self.instances() {
                let possible =
                    Self::holds(&self.actions[action].precondition, &objects, |literal, atom| {
                        if literal.negated { !always.contains(atom) } else { hold.contains(atom) }
                    });
                if possible {
                    let (add, delete) = self.effects(action, &objects);
                    hold = &hold | &add;
                    always = &always - &delete;
                    names.insert(name);
                }
            }
            if names.len() == known {
                return names;
            }
        }
    }
}

fn ground_terms(literal: &Literal, objects: &[usize]) -> Vec<usize> {
    let object = |&term: &Term| match term {
        Term::Parameter(position) => objects[position],
        Term::Object(object) => object,
    };
    literal.terms.iter().map(object).collect()
}

/// Every fact means what its name says, and every condition what it says.
fn check_state(world: &World, grounded: &Grounded, state: &Atoms, packed: &State) {
    let task = &grounded.task;
    let atoms: BTreeSet<String> = state.iter().map(World::atom).collect();
    for fact in task.facts() {
        let name = task.fact_name(fact);
        if grounded.never == Some(fact) {
            assert_eq!(grounded.atom(fact), None);
            assert!(!task.satisfies(packed.words(), &[fact]), "{name}");
            continue;
        }
        let (_, negated) = grounded.atom(fact).unwrap();
        let bare = name.strip_prefix("(not ").map(|rest| rest.strip_suffix(')').unwrap());
        assert_eq!(bare.is_some(), negated);
        let holds = atoms.contains(bare.unwrap_or(name)) != negated;
        assert_eq!(task.satisfies(packed.words(), &[fact]), holds, "{name}");
    }
    let meanings = std::iter::once(&grounded.goal).chain(&grounded.conditions);
    for (literals, facts) in world.goals.iter().zip(meanings) {
        let holds = World::satisfies(state, literals, &[]);
        let found = facts.as_ref().is_some_and(|facts| task.satisfies(packed.words(), facts));
        assert_eq!(found, holds, "{}", World::conjunction(literals));
    }
    assert_eq!(
        task.satisfies(packed.words(), task.goal()),
        World::satisfies(state, &world.goals[0], &[])
    );
}

/// What the worlds had in them.
#[derive(Debug, Default)]
struct Seen {
    states: usize,
    negated: usize,
    groups: usize,
    unreachable: usize,
    left_out: usize,
    large: usize,
}

fn check(world: &World, seen: &mut Seen) {
    let domain = read_domain(&world.domain()).unwrap();
    let task = read_task(&domain, &world.task()).unwrap();
    let condition =
        |goal: &Vec<Literal>| read_condition(&domain, &task, &World::conjunction(goal)).unwrap();
    let state = |state: &Atoms| read_state(&domain, &task, &World::state(state)).unwrap();
    let more = ExtraInputs {
        states: world.states[1..].iter().map(state).collect(),
        conditions: world.goals[1..].iter().map(condition).collect(),
    };
    let grounded = ground(&domain, &task, &more).unwrap();
    let ground_task = &grounded.task;
    let relaxed = world.relaxed();
    for number in 0..ground_task.operators().len() {
        let operator = &ground_task.operators()[number];
        let name = ground_task.action_name(operator.action);
        assert!(relaxed.contains(name), "{name} can never apply");
        // The number of an operator is that of its action.
        assert_eq!(operator.action.index(), number);
        let mut told = format!("({}", domain.schemas[grounded.schema(operator.action)].name);
        for &object in grounded.arguments(operator.action) {
            told += &format!(" {}", task.objects.name(object));
        }
        assert_eq!(told + ")", name);
    }
    seen.left_out += usize::from(ground_task.operators().len() < world.instances().len());
    seen.negated +=
        usize::from(ground_task.facts().any(|f| ground_task.fact_name(f).starts_with("(not")));
    seen.groups += usize::from(ground_task.exclusive_groups().len() < ground_task.fact_count());
    seen.unreachable += usize::from(grounded.goal.is_none());
    let never = std::iter::once(&grounded.goal).chain(&grounded.conditions).any(Option::is_none);
    assert_eq!(grounded.never.is_some(), never);
    let mut packed: BTreeMap<Atoms, State> = BTreeMap::new();
    let mut open = VecDeque::new();
    let starts = std::iter::once(ground_task.initial_state()).chain(&grounded.states);
    for (state, start) in world.states.iter().zip(starts) {
        if packed.insert(state.clone(), start.clone()).is_none() {
            open.push_back(state.clone());
        }
    }
    let mut found = Vec::new();
    while let Some(state) = open.pop_front() {
        if packed.len() > MOST_STATES {
            seen.large += 1;
            break;
        }
        let here = packed[&state].clone();
        check_state(world, &grounded, &state, &here);
        let successors = world.successors(&state);
        ground_task.applicable(here.words(), &mut found);
        let names: BTreeSet<&str> = found
            .iter()
            .map(|&id| ground_task.action_name(ground_task.operator(id).action))
            .collect();
        let expected: BTreeSet<&str> = successors.keys().map(String::as_str).collect();
        assert_eq!(names, expected, "in {}", World::state(&state));
        for &id in &found {
            let next = &successors[ground_task.action_name(ground_task.operator(id).action)];
            let mut words = here.words().to_vec();
            ground_task.apply(id, &mut words);
            let holding = ground_task.facts_of(&words);
            let there = ground_task.state(&holding).unwrap();
            assert_eq!(there.words(), words);
            match packed.get(next) {
                Some(known) => assert_eq!(known, &there),
                None => {
                    packed.insert(next.clone(), there);
                    open.push_back(next.clone());
                }
            }
        }
    }
    let different: BTreeSet<&State> = packed.values().collect();
    assert_eq!(different.len(), packed.len(), "two states are packed the same");
    seen.states += packed.len();
}

#[test]
fn grounding_agrees_with_trying_everything() {
    let mut dice = Dice::new(11);
    let mut seen = Seen::default();
    for number in 0..WORLDS {
        let world = World::draw(&mut dice);
        let told = format!("world {number}:\n{}\n{}\n", world.domain(), world.task());
        let checked =
            std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| check(&world, &mut seen)));
        if let Err(panic) = checked {
            eprintln!("{told}");
            std::panic::resume_unwind(panic);
        }
    }
    println!("{seen:?}");
    for (what, count) in
        [("negated", seen.negated), ("unreachable", seen.unreachable), ("left out", seen.left_out)]
    {
        assert!(count > 100, "{what}: {count}");
    }
    assert!(seen.groups > 100, "{seen:?}");
    assert!(seen.large < WORLDS / 4 && seen.states > 5 * WORLDS, "{seen:?}");
}
