//! Diagrams against sorted sets, update by update, on documents of every format.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::measure::StateCount;
use super::{Diagrams, SetId, SymbolRelations, reachable};
use crate::common::Dice;
use crate::common::random::{self, MEDIUM, PAIR};
use crate::domain::Document;
use crate::domain::generate::Domain;
use crate::limits::Limits;
use crate::problem::Problem;
use crate::task::{OperatorId, State, StateSpace};

/// The definition of the update, state by state.
fn update(
    problem: &Problem,
    observer: usize,
    belief: &BTreeSet<State>,
    symbol: u32,
) -> BTreeSet<State> {
    let (task, sensor) = (problem.task(), &problem.observers()[observer].sensor);
    let mut next = BTreeSet::new();
    for state in belief {
        let mut applicable = Vec::new();
        task.applicable(state.words(), &mut applicable);
        for operator in applicable {
            let mut words = state.words().to_vec();
            task.apply(operator, &mut words);
            if sensor.read(task, operator, &words).index() == symbol as usize {
                next.insert(State::from_words(words));
            }
        }
    }
    next
}

/// Walks at random and compares each belief with its diagram; the number of updates compared.
fn compare(problem: &Problem, dice: &mut Dice, steps: usize, most: usize) -> usize {
    let task = problem.task();
    let mut compared = 0;
    for (number, observer) in problem.observers().iter().enumerate() {
        let mut diagrams = Diagrams::new(Arc::clone(task), Limits::default());
        let mut relations = SymbolRelations::new(task, &observer.sensor);
        let mut belief: BTreeSet<State> =
            observer.initial_belief.listed().unwrap().iter().cloned().collect();
        let mut set = diagrams.of_states(observer.initial_belief.listed().unwrap()).unwrap();
        let mut actor = task.initial_state().clone();
        for _ in 0..steps {
            let mut applicable: Vec<OperatorId> = Vec::new();
            task.applicable(actor.words(), &mut applicable);
            if applicable.is_empty() || belief.len() > most {
                break;
            }
            let operator = dice.pick(&applicable);
            let mut words = actor.words().to_vec();
            task.apply(operator, &mut words);
            let symbol = observer.sensor.read(task, operator, &words);
            actor = State::from_words(words);
            belief = update(problem, number, &belief, symbol.index() as u32);
            set = relations.update(&mut diagrams, set, symbol).unwrap();
            assert_eq!(diagrams.count(set), StateCount::Exact(belief.len() as u64));
            let listed: Vec<State> = belief.iter().cloned().collect();
            assert_eq!(diagrams.of_states(&listed).unwrap(), set, "equal sets, equal numbers");
            let first: BTreeSet<State> = diagrams.first_states(set, 50).into_iter().collect();
            assert_eq!(first.len(), belief.len().min(50));
            assert!(first.is_subset(&belief));
            facts_agree(problem, &diagrams, set, &listed);
            compared += 1;
        }
    }
    compared
}

fn facts_agree(problem: &Problem, diagrams: &Diagrams, set: SetId, listed: &[State]) {
    let task = problem.task();
    let counts = diagrams.fact_counts(set);
    for fact in task.facts() {
        let holding = listed.iter().filter(|state| task.satisfies(state.words(), &[fact])).count();
        assert_eq!(counts[fact.index()], StateCount::Exact(holding as u64));
    }
    for goal in problem.goals() {
        let holds = |state: &&State| task.satisfies(state.words(), &goal.condition);
        let holding: Vec<State> = listed.iter().filter(holds).cloned().collect();
        assert_eq!(diagrams.satisfies(set, &goal.condition), !holding.is_empty());
        let count = diagrams.count_satisfying(set, &goal.condition);
        assert_eq!(count, StateCount::Exact(holding.len() as u64));
    }
}

#[test]
fn random_explicit_problems_agree() {
    let mut dice = Dice::new(11);
    let mut compared = 0;
    for _ in 0..2000 {
        let table = random::table(&mut dice, MEDIUM, &PAIR);
        compared += compare(&table.problem(), &mut dice, 6, 10_000);
    }
    assert!(compared > 10_000, "{compared}");
}

#[test]
fn drawn_problems_of_every_domain_agree() {
    let mut dice = Dice::new(12);
    for domain in Domain::ALL {
        let mut compared = 0;
        for seed in 1..=6 {
            let problem = domain.draw(seed).unwrap().document.problem().unwrap();
            compared += compare(&problem, &mut dice, 12, 400);
        }
        assert!(compared > 30, "{} {compared}", domain.name());
    }
}

#[test]
fn cameras_and_rules_over_resulting_states_agree() {
    let mut dice = Dice::new(13);
    for text in [
        include_str!("../../../www/problems/camera-zone.json"),
        include_str!("../../../www/problems/goal-in-sight.json"),
        include_str!("../../../www/problems/blocks-unseen.json"),
        include_str!("../../../www/problems/city.json"),
    ] {
        let problem = Document::parse(text).unwrap().problem().unwrap();
        for _ in 0..20 {
            assert!(compare(&problem, &mut dice, 10, 600) > 0);
        }
    }
}

/// The reachable states of a task, with and without a condition, against those gone through one by one; how many there
/// are, none where they are more than `most`.
fn reachable_states_agree(problem: &Problem, most: usize) -> Option<usize> {
    let task = problem.task();
    let mut space = StateSpace::new(Arc::clone(task));
    let mut next = Some(space.intern(task.initial_state()));
    let mut listed = Vec::new();
    while let Some(state) = next {
        listed.push(space.state(state));
        space.expand(state);
        next = space.after(state);
        if space.len() > most {
            return None;
        }
    }
    let (mut diagrams, all) = reachable(task, Limits::default()).unwrap();
    assert_eq!(diagrams.of_states(&listed).unwrap(), all);
    assert_eq!(diagrams.count(all), StateCount::Exact(listed.len() as u64));
    let facts = task.facts().map(|fact| vec![fact]);
    for condition in problem.goals().iter().map(|goal| goal.condition.clone()).chain(facts) {
        let satisfying = diagrams.satisfying(all, &condition).unwrap();
        let holds = |state: &&State| task.satisfies(state.words(), &condition);
        let holding: Vec<State> = listed.iter().filter(holds).cloned().collect();
        assert_eq!(diagrams.of_states(&holding).unwrap(), satisfying);
        for state in &listed {
            assert_eq!(diagrams.contains(satisfying, state), holds(&state));
        }
        let values = diagrams.values(satisfying);
        for (group, values) in values.iter().enumerate() {
            let of = |state: &State| task.layout().group_value(state.words(), group) as u32;
            let met: BTreeSet<u32> = holding.iter().map(of).collect();
            assert!(met.iter().eq(values), "group {group}");
        }
    }
    Some(listed.len())
}

#[test]
fn reachable_states_are_those_gone_through_one_by_one() {
    let mut dice = Dice::new(15);
    let mut states = 0;
    for _ in 0..1000 {
        let table = random::table(&mut dice, MEDIUM, &PAIR);
        states += reachable_states_agree(&table.problem(), 1000).unwrap();
        let strips = random::strips(&mut dice);
        states += reachable_states_agree(&strips.judge().problem, 1000).unwrap();
    }
    assert!(states > 5_000, "{states}");
    for domain in Domain::ALL {
        let drawn = (1..=12).filter_map(|seed| {
            let problem = domain.draw(seed).unwrap().document.problem().unwrap();
            reachable_states_agree(&problem, 5_000)
        });
        let large = matches!(domain, Domain::Logistics | Domain::Driverlog);
        assert!(drawn.count() > 0 || large, "{}", domain.name());
    }
}

#[test]
fn groups_as_large_as_a_wide_grid_are_not_for_diagrams() {
    for domain in Domain::ALL {
        let problem = domain.draw(1).unwrap().document.problem().unwrap();
        assert!(super::suits(problem.task()), "{}", domain.name());
    }
    let wide =
        crate::domain::gridworld::GridworldShape { width: 256, height: 256, ..Default::default() };
    let problem = wide.generate(1).unwrap().document.problem().unwrap();
    assert!(!super::suits(problem.task()));
}

#[test]
fn memory_is_bounded() {
    let problem = Domain::Logistics.draw(1).unwrap().document.problem().unwrap();
    let observer = &problem.observers()[0];
    let limits = Limits { bytes: 40_000, ..Limits::default() };
    let mut diagrams = Diagrams::new(Arc::clone(problem.task()), limits);
    let mut relations = SymbolRelations::new(problem.task(), &observer.sensor);
    let mut dice = Dice::new(14);
    let mut set = diagrams.of_states(observer.initial_belief.listed().unwrap()).unwrap();
    let mut actor = problem.task().initial_state().clone();
    for _ in 0..200 {
        let mut applicable = Vec::new();
        problem.task().applicable(actor.words(), &mut applicable);
        let operator = dice.pick(&applicable);
        let mut words = actor.words().to_vec();
        problem.task().apply(operator, &mut words);
        let symbol = observer.sensor.read(problem.task(), operator, &words);
        actor = State::from_words(words);
        match relations.update(&mut diagrams, set, symbol) {
            Ok(next) => set = next,
            Err(_) => return,
        }
    }
    panic!("the limit was never met");
}
