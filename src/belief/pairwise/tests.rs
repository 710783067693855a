//! Pairwise beliefs against sorted sets, update by update.

use std::collections::BTreeSet;

use super::*;
use crate::common::Dice;
use crate::common::random::{self, MEDIUM, PAIR};
use crate::domain::Document;
use crate::domain::generate::Domain;
use crate::problem::Problem;
use crate::task::OperatorId;

/// The definition of the update, state by state.
fn update(
    task: &Task,
    sensor: &Sensor,
    belief: &BTreeSet<State>,
    symbol: Symbol,
) -> BTreeSet<State> {
    let (mut next, mut applicable) = (BTreeSet::new(), Vec::new());
    for state in belief {
        task.applicable(state.words(), &mut applicable);
        for &operator in &applicable {
            let mut words = state.words().to_vec();
            task.apply(operator, &mut words);
            if sensor.read(task, operator, &words) == symbol {
                next.insert(State::from_words(words));
            }
        }
    }
    next
}

/// What was compared on a walk.
#[derive(Default)]
struct Compared {
    updates: usize,
    dead: usize,
    dead_by_pairs: usize,
}

/// Walks at random; every pair of a belief is in its pairwise belief, and with `exact` nothing else is.
fn compare(problem: &Problem, dice: &mut Dice, steps: usize, exact: bool, compared: &mut Compared) {
    compare_from(problem, dice, steps, exact, compared, InitialBelief::clone);
}

/// The same with another form of what is believed at first.
fn compare_from(
    problem: &Problem,
    dice: &mut Dice,
    steps: usize,
    exact: bool,
    compared: &mut Compared,
    form: impl Fn(&InitialBelief) -> InitialBelief,
) {
    let task = problem.task();
    for observer in problem.observers() {
        let updates = PairwiseUpdates::new(task, &observer.sensor).unwrap();
        let mut belief: BTreeSet<State> =
            observer.initial_belief.listed().unwrap().iter().cloned().collect();
        let mut pairs = updates.initial(task, &form(&observer.initial_belief));
        let mut actor = task.initial_state().clone();
        for _ in 0..steps {
            let mut applicable: Vec<OperatorId> = Vec::new();
            task.applicable(actor.words(), &mut applicable);
            if applicable.is_empty() || belief.len() > 1_000 {
                break;
            }
            let operator = dice.pick(&applicable);
            let mut words = actor.words().to_vec();
            task.apply(operator, &mut words);
            let symbol = observer.sensor.read(task, operator, &words);
            actor = State::from_words(words);
            belief = update(task, &observer.sensor, &belief, symbol);
            pairs = updates.update(&pairs, symbol);
            let listed: Vec<State> = belief.iter().cloned().collect();
            let least = updates.of_states(task, &listed);
            for value in ones(&least.0[..updates.width]) {
                let row = updates.row(&pairs, value).expect("a value of the belief is missing");
                let wanted = updates.row(&least, value).unwrap();
                assert!(row.iter().zip(wanted).all(|(row, wanted)| wanted & !row == 0));
            }
            if exact {
                assert_eq!(pairs, least);
            }
            for goal in problem.goals() {
                let alive = listed.iter().any(|s| task.satisfies(s.words(), &goal.condition));
                let may = updates.may_satisfy(task, &pairs, &goal.condition);
                assert!(may || !alive);
                compared.dead += usize::from(!alive);
                compared.dead_by_pairs += usize::from(!may);
            }
            compared.updates += 1;
        }
    }
}

#[test]
fn of_one_group_the_pairs_are_the_belief() {
    let (mut dice, mut compared) = (Dice::new(21), Compared::default());
    for _ in 0..2_000 {
        let table = random::table(&mut dice, MEDIUM, &PAIR);
        compare(&table.problem(), &mut dice, 6, true, &mut compared);
    }
    assert!(compared.updates > 10_000, "{}", compared.updates);
    assert_eq!(compared.dead, compared.dead_by_pairs);
}

#[test]
fn of_states_that_are_not_listed_no_pair_is_missing() {
    let mut dice = Dice::new(23);
    for domain in Domain::ALL {
        let mut compared = Compared::default();
        for seed in 1..=4 {
            let problem = domain.draw(seed).unwrap().document.problem().unwrap();
            let form = |believed: &InitialBelief| believed.unlisted(problem.task());
            compare_from(&problem, &mut dice, 8, false, &mut compared, form);
        }
        assert!(compared.updates > 20, "{} {}", domain.name(), compared.updates);
    }
}

#[test]
fn in_drawn_problems_of_every_domain_no_pair_is_missing() {
    let mut dice = Dice::new(22);
    for domain in Domain::ALL {
        let mut compared = Compared::default();
        for seed in 1..=6 {
            let problem = domain.draw(seed).unwrap().document.problem().unwrap();
            compare(&problem, &mut dice, 12, false, &mut compared);
        }
        assert!(compared.updates > 30, "{} {}", domain.name(), compared.updates);
        // Mostly the pairs tell.
        let (by_pairs, dead) = (compared.dead_by_pairs, compared.dead);
        assert!(2 * by_pairs > dead, "{} {by_pairs} {dead}", domain.name());
    }
}

#[test]
fn sensors_that_look_at_the_state_lose_no_pair() {
    let (mut dice, mut compared) = (Dice::new(23), Compared::default());
    for text in [
        include_str!("../../../www/problems/camera-zone.json"),
        include_str!("../../../www/problems/goal-in-sight.json"),
        include_str!("../../../www/problems/blocks-unseen.json"),
        include_str!("../../../www/problems/city.json"),
    ] {
        let problem = Document::parse(text).unwrap().problem().unwrap();
        for _ in 0..20 {
            compare(&problem, &mut dice, 10, false, &mut compared);
        }
    }
    assert!(compared.updates > 300, "{}", compared.updates);
}

#[test]
fn too_many_values_are_none() {
    let wide =
        crate::domain::gridworld::GridworldShape { width: 256, height: 256, ..Default::default() };
    let problem = wide.generate(1).unwrap().document.problem().unwrap();
    assert!(PairwiseUpdates::new(problem.task(), &problem.observers()[0].sensor).is_none());
}
