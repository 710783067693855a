//! What the walks find is held against the definitions by enumeration: plans and witnesses alike.

use std::collections::BTreeSet;

use super::*;
use crate::domain::generate::Domain;
use crate::solver::Solver;
use crate::solver::common::random::{self, MEDIUM, PAIR};
use crate::solver::common::{Dice, Judge};
use crate::trace::{validate, validate_within};

/// Runs the walks to their end: the plan and the witnesses, where they find one.
fn run(problem: &Arc<Problem>, options: &Options, budget: u64) -> Option<(Plan, Vec<Witness>)> {
    let mut walks = ParallelWalks::new(problem, options);
    for _ in 0..1_000_000 {
        match walks.advance(budget) {
            Ok(Advance::Working) => {}
            Ok(Advance::Finished(finding)) => return finding.plan.map(|p| (p, finding.witnesses)),
            Err(_) => return None,
        }
    }
    panic!("no end");
}

#[test]
fn plans_keep_the_bounds_and_witnesses_hold_on_random_problems() {
    let mut dice = Dice::new(90);
    let (mut found, mut possible) = (0, 0);
    for round in 0..4_000 {
        let third = [Role::Adversarial, Role::Adversarial, Role::Cooperative];
        let roles = if round % 8 == 0 { &third[..] } else { &PAIR[..] };
        let judge = Judge::built(random::table(&mut dice, MEDIUM, roles), 0);
        let wish = random::wish(&mut dice, &judge.table);
        let options = Judge::options(Solver::Satisficing, None, &wish);
        if !suits(&judge.problem, &options.heeded_bounds(), None) {
            continue;
        }
        possible +=
            usize::from(judge.endings().keys().any(|ending| wish.allows(&judge.table, ending)));
        let plan = run(&judge.problem, &options, 1);
        assert_eq!(plan, run(&judge.problem, &options, 100), "slices change nothing");
        let Some((plan, witnesses)) = plan else { continue };
        found += 1;
        assert!(wish.allows(&judge.table, &judge.ending(&plan)));
        let full = validate(&judge.problem, &plan).unwrap();
        let within = validate_within(&judge.problem, &plan, &witnesses, options.limits).unwrap();
        assert_eq!(within, full);
        for witness in witnesses {
            assert!(full.survivors[witness.observer].contains(witness.goal));
        }
    }
    assert!(found > 100 && 4 * found > possible, "{found} of {possible}");
}

#[test]
fn walks_beside_any_plan_hold_and_show_what_survives() {
    let mut dice = Dice::new(91);
    let (mut found, mut alive) = (0, 0);
    for _ in 0..2_000 {
        let judge = Judge::built(random::table(&mut dice, MEDIUM, &PAIR), 0);
        let options = Options::new(Solver::Baseline);
        let solve = crate::solver::solve(Arc::clone(&judge.problem), options, |_| {
            std::ops::ControlFlow::Continue(())
        });
        let Some(plan) = solve.unwrap().plan else { continue };
        let full = validate(&judge.problem, &plan).unwrap();
        let witnesses = beside(&judge.problem, &plan, Vec::new(), Limits::default());
        let seen = crate::trace::symbols(&judge.problem, &plan).unwrap();
        for witness in &witnesses {
            assert!(witness.holds(&judge.problem, &seen[witness.observer]));
            assert!(full.survivors[witness.observer].contains(witness.goal));
        }
        found += witnesses.len();
        alive += full.survivors[0].len() - 1;
        assert_eq!(crate::trace::validate_quickly(&judge.problem, &plan).unwrap(), full);
    }
    assert!(found > 500 && found == alive, "{found} of {alive}");
}

#[test]
fn drawn_logistics_and_driverlog_mostly_have_walks() {
    for domain in [Domain::Logistics, Domain::Driverlog] {
        let mut found = 0;
        for seed in 1..=10 {
            let problem = Arc::new(domain.draw(seed).unwrap().document.problem().unwrap());
            let mut options = Options::new(Solver::Satisficing);
            let middle = problem.goals().len().div_ceil(2).max(2);
            options.bounds.at_least = Some(middle);
            options.bounds.at_most = Some(middle);
            let Some((plan, witnesses)) = run(&problem, &options, 1) else { continue };
            found += 1;
            let full = validate(&problem, &plan).unwrap();
            assert!(full.counts.adversarial >= middle && full.counts.cooperative <= middle);
            // With no room for beliefs, what is settled is true, and the rest is what the actor does not want.
            let limits = options.limits.with_bytes(0);
            let within = validate_within(&problem, &plan, &witnesses, limits).unwrap();
            for (place, observer) in problem.observers().iter().enumerate() {
                let (all, some) = (&full.survivors[place], &within.survivors[place]);
                for goal in 0..problem.goals().len() {
                    let settled = !within.unsettled[place].contains(goal);
                    assert!(!settled || all.contains(goal) == some.contains(goal));
                    assert!(settled || some.contains(goal) == (observer.role == Role::Cooperative));
                }
            }
        }
        assert!(found >= 5, "{} {found}", domain.name());
    }
}

/// The goals that can be reached from the initial state, by exhaustion.
fn reachable_goals(joint: &mut JointSpace) -> Vec<bool> {
    let problem = Arc::clone(joint.problem());
    let mut reached = vec![false; problem.goals().len()];
    let mut met = BTreeSet::new();
    let mut open = vec![joint.initial().state];
    while let Some(state) = open.pop() {
        if !met.insert(state) {
            continue;
        }
        for (goal, reached) in problem.goals().iter().zip(&mut reached) {
            *reached |= problem.task().satisfies(joint.states().words(state), &goal.condition);
        }
        joint.states_mut().expand(state);
        open.extend(joint.states().edges(state).iter().map(|edge| edge.target));
    }
    reached
}

#[test]
fn a_leg_is_found_exactly_where_there_is_one_a_state_at_a_time() {
    let mut dice = Dice::new(92);
    let (mut found, mut missing) = (0, 0);
    for _ in 0..1_000 {
        let judge = Judge::built(random::table(&mut dice, MEDIUM, &PAIR), 0);
        let mut joint = JointSpace::new(Arc::clone(&judge.problem), Limits::default());
        let reached = reachable_goals(&mut joint);
        let mut estimates = GoalEstimates::new(&joint);
        let from = joint.initial().state;
        let ways = [Evaluation::Deferred, Evaluation::Blind, Evaluation::Eager];
        let searches = reached.into_iter().enumerate().flat_map(|goal| ways.map(|way| (goal, way)));
        for ((goal, reached), way) in searches {
            let mut search = LegSearch::new(goal, way, Effort::Most);
            let edges = loop {
                let before = estimates.worked_out;
                let step = search.step(&mut joint, &mut estimates, from);
                let most = if way == Evaluation::Eager { judge.table.actions.len() + 1 } else { 1 };
                assert!(estimates.worked_out <= before + most as u64, "a step is one state");
                if let LegStep::Over(edges) = step {
                    break edges;
                }
            };
            assert_eq!(edges.is_some(), reached);
            let Some(edges) = edges else {
                missing += 1;
                continue;
            };
            found += 1;
            let mut at = from;
            for edge in edges {
                assert!(joint.states().edge_range(at).contains(&edge));
                at = joint.states().all_edges()[edge].target;
            }
            let condition = &judge.problem.goals()[goal].condition;
            assert!(judge.problem.task().satisfies(joint.states().words(at), condition));
        }
    }
    assert!(found > 1_000 && missing > 50, "{found} {missing}");
}

/// A corridor of five places with a door before the last one, which opens once. The nearest plan ends right behind the door, and
/// a walk that opens it too has no time for the way to the other end.
const CORRIDOR: &str = r#"{
 "format": "pddl",
 "domain": "(define (domain corridor) (:predicates (at ?x) (next ?x ?y) (free ?x) (locked ?x)) (:action move :parameters (?x ?y) :precondition (and (at ?x) (next ?x ?y) (free ?y)) :effect (and (at ?y) (not (at ?x)))) (:action open :parameters (?x ?y) :precondition (and (at ?x) (next ?x ?y) (locked ?y)) :effect (and (free ?y) (not (locked ?y)))))",
 "problem": "(define (problem door) (:domain corridor) (:objects a b c d e) (:init (at d) (next a b) (next b a) (next b c) (next c b) (next c d) (next d c) (next d e) (next e d) (free a) (free b) (free c) (free d) (locked e)))",
 "goals": [{"name": "G1", "condition": "(at e)"}, {"name": "G2", "condition": "(at a)"}],
 "true_goal": "G1",
 "observers": {"adversarial": {"sensor": "{name}"}, "cooperative": {"sensor": "{name} {1}"}}
}"#;

#[test]
fn a_round_trip_gives_a_walk_the_time_for_its_way_back_from_what_is_done_once() {
    let document = crate::domain::Document::parse(CORRIDOR).unwrap();
    let problem = Arc::new(document.problem().unwrap());
    let mut options = Options::new(Solver::Satisficing);
    options.bounds.at_least = Some(2);
    let (plan, witnesses) = run(&problem, &options, 1).unwrap();
    assert_eq!(validate(&problem, &plan).unwrap().counts.adversarial, 2);
    assert_eq!(witnesses.len(), 1);
    assert_eq!(plan.len(), 10, "to the goal, to the other one and back");
}
