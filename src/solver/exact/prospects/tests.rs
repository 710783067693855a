//! Small problems never get so far that prospects are asked, so here they are asked first.

use super::*;
use crate::solver::Solver;
use crate::solver::common::random::{self, MEDIUM, PAIR};
use crate::solver::common::{Dice, Judge, Wish};

/// What prospects say.
enum Said {
    Plan(Option<Plan>),
    NotForThem,
}

fn ask(judge: &Judge, wish: &Wish, best: bool) -> Said {
    let solver = if best { Solver::Exact } else { Solver::Search };
    let options = Judge::options(solver, None, wish);
    let Some(mut prospects) = Prospects::new(&judge.problem, &options, best).unwrap() else {
        return Said::NotForThem;
    };
    loop {
        match prospects.advance(3).unwrap() {
            Verdict::Working => {}
            Verdict::Plan(plan) => return Said::Plan(Some(plan)),
            Verdict::Infeasible => return Said::Plan(None),
            Verdict::Unknown => panic!("nothing is that large"),
        }
    }
}

fn agrees(judge: &Judge, wish: &Wish) -> bool {
    let (Said::Plan(best), Said::Plan(some)) = (ask(judge, wish, true), ask(judge, wish, false))
    else {
        return false;
    };
    let table = &judge.table;
    let difference = |ending: &crate::solver::common::oracle::Ending| {
        let (adversarial, cooperative) = table.counts(ending);
        adversarial as i64 - cooperative as i64
    };
    let allowed = judge.endings().iter().filter(|(ending, _)| wish.allows(table, ending));
    let expected = allowed.map(|(ending, &length)| (-difference(ending), length)).min();
    let found = best.as_ref().map(|plan| {
        let ending = judge.ending(plan);
        assert!(wish.allows(table, &ending));
        (-difference(&ending), plan.actions.len())
    });
    assert_eq!(found, expected, "{wish:?}");
    assert_eq!(some.is_some(), expected.is_some());
    assert!(some.is_none_or(|plan| wish.allows(table, &judge.ending(&plan))));
    true
}

#[test]
fn the_best_plan_is_a_shortest_one_of_all_there_are() {
    let mut dice = Dice::new(77);
    let mut asked = 0;
    for _ in 0..6_000 {
        let judge = Judge::new(random::table(&mut dice, MEDIUM, &PAIR));
        let wish = random::wish(&mut dice, &judge.table);
        asked += usize::from(agrees(&judge, &wish));
        agrees(&judge, &Wish::default());
    }
    assert!(asked > 4_000, "asked {asked} times");
}

#[test]
fn small_gridworlds_agree_with_going_through_all_there_is() {
    let mut dice = Dice::new(78);
    for _ in 0..150 {
        let grid = crate::solver::common::gridworld::random(&mut dice, 4);
        let judge = Judge::of(
            crate::solver::common::gridworld::table(&grid),
            Arc::new(grid.problem().unwrap()),
        );
        let wish = random::wish(&mut dice, &judge.table);
        agrees(&judge, &wish);
        agrees(&judge, &Wish::default());
    }
}

#[test]
fn what_is_not_for_them_is_left_to_others() {
    let mut dice = Dice::new(79);
    let roles = [Role::Adversarial, Role::Cooperative, Role::Cooperative];
    let judge = Judge::built(random::table(&mut dice, MEDIUM, &roles), 0);
    assert!(matches!(ask(&judge, &Wish::default(), true), Said::NotForThem));
}
