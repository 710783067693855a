//! Small problems are explored to their end, so here that is given up at once or soon: the questions
//! asked one by one have to come to the same advice.

use super::*;
use crate::problem::Role;
use crate::solver::common::random::{self, MEDIUM, PAIR};
use crate::solver::common::{Dice, Judge};

/// The advice where no more nodes than these are explored first, and whether it was given up.
fn advise(judge: &Judge, options: &Options, proved: bool, explored: u64) -> (Advice, bool) {
    let problem = Arc::clone(&judge.problem);
    let mut run = RemedyRun::new(problem, options.clone()).unwrap();
    run.proved = proved;
    run.explored.expansions = explored;
    let mut given_up = false;
    for _ in 0..100_000 {
        given_up |= matches!(run.stage, Stage::Question(..) | Stage::NextHorizons(_));
        if run.advance(3).unwrap() {
            return (run.outcome().unwrap(), given_up);
        }
    }
    panic!("no end");
}

#[test]
fn one_question_after_the_other_leads_to_the_same_advice() {
    let mut dice = Dice::new(83);
    let mut one_by_one = 0;
    for round in 0..3_000 {
        let third = [Role::Adversarial, Role::Cooperative, Role::Adversarial];
        let roles = if round % 8 == 0 { &third[..] } else { &PAIR[..] };
        let judge = Judge::built(random::table(&mut dice, MEDIUM, roles), 0);
        let wish = random::wish(&mut dice, &judge.table);
        let asked = dice.percent(70).then(|| dice.below(9));
        let options = Judge::options(Solver::Exact, asked, &wish);
        let (whole, given_up) = advise(&judge, &options, false, u64::MAX);
        assert!(!given_up && whole.complete);
        let proved = whole.reason.is_some() && dice.percent(50);
        let explored = dice.pick(&[0, 0, 1, 4]);
        let (advice, given_up) = advise(&judge, &options, proved, explored);
        one_by_one += usize::from(given_up);
        let told = |advice: &Advice| {
            let remedies = advice.remedies.iter();
            let remedies: Vec<_> =
                remedies.map(|it| (it.change, it.value, it.goal_difference.to_bits())).collect();
            (advice.reason, advice.shortest, advice.complete, remedies)
        };
        assert_eq!(told(&advice), told(&whole), "{explored} {asked:?} {wish:?}");
    }
    assert!(one_by_one > 1_000, "{one_by_one}");
}

/// What was found before a limit is kept, and is right: under the changed option the plan does what it
/// says, and no plan is worth less than the one of the whole advice.
#[test]
fn remedies_found_before_a_limit_are_kept() {
    let mut dice = Dice::new(85);
    let (mut kept, mut limited) = (0, 0);
    for _ in 0..5_000 {
        let judge = Judge::built(random::table(&mut dice, MEDIUM, &PAIR), 0);
        let wish = random::wish(&mut dice, &judge.table);
        let asked = dice.percent(80).then(|| dice.below(9));
        let mut options = Judge::options(Solver::Exact, asked, &wish);
        let (whole, _) = advise(&judge, &options, false, u64::MAX);
        options.limits.expansions = dice.below(60) as u64;
        let (advice, _) = advise(&judge, &options, false, 0);
        if advice.complete {
            continue;
        }
        limited += 1;
        assert!(advice.reason.is_none() || advice.reason == whole.reason);
        for remedy in &advice.remedies {
            kept += 1;
            let same =
                |known: &&Remedy| (known.change, known.value) == (remedy.change, remedy.value);
            let known = whole.remedies.iter().find(same).unwrap();
            assert!(remedy.goal_difference <= known.goal_difference);
        }
    }
    assert!(kept > 100 && limited > 200, "{kept} {limited}");
}

/// Nodes explored first count once, also where the exploration goes on later.
#[test]
fn no_more_nodes_are_expanded_than_allowed() {
    let mut dice = Dice::new(84);
    for _ in 0..1_000 {
        let judge = Judge::built(random::table(&mut dice, MEDIUM, &PAIR), 0);
        let wish = random::wish(&mut dice, &judge.table);
        let asked = dice.percent(80).then(|| dice.below(9));
        let mut options = Judge::options(Solver::Exact, asked, &wish);
        options.limits.expansions = dice.below(60) as u64;
        let mut run = RemedyRun::new(Arc::clone(&judge.problem), options.clone()).unwrap();
        run.explored.expansions = dice.pick(&[0, 1, 4, 16]);
        while !run.advance(1).unwrap() {
            assert!(run.progress().done <= options.limits.expansions);
        }
        assert!(run.progress().done <= options.limits.expansions);
    }
}
