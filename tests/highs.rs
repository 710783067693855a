//! The LP text of both encodings, read and solved by HiGHS, has the optimum that exact search finds.
//!
//! `MO_COPP_HIGHS_PYTHON` names a Python with the package highspy; `npm test` sets it.

use std::io::Write;
use std::path::PathBuf;
use std::process::Command;
use std::sync::Arc;

use mo_copp::domain::gridworld::GridworldShape;
use mo_copp::domain::{Delivery, Gridworld};
use mo_copp::problem::Role::{self, Adversarial, Cooperative};
use mo_copp::solver::{Encoding, Solver, lp_format};

use crate::common::random::{self, MEDIUM};
use crate::common::table::{Table, Watcher, set};
use crate::common::{Dice, Judge, Wish, delivery, gridworld, oracle};

const PYTHON: &str = "MO_COPP_HIGHS_PYTHON";

/// A problem at a horizon with bounds.
struct Case {
    judge: Judge,
    horizon: usize,
    wish: Wish,
}

fn grid(grid: &Gridworld, horizon: usize, wish: Wish) -> Case {
    let judge = Judge::of(gridworld::table(grid), Arc::new(grid.problem().unwrap()));
    Case { judge, horizon, wish }
}

/// The enemy keeps G2 after `a1 b1` and `a2 b2` alone, and so does the friend. With k = 2 and j = 1
/// there is no plan, but every step is of use to each of them, so that it takes an integer program
/// to say so.
fn crossed(roles: &[Role]) -> Case {
    // 0 start, 1, 2 true goal; 3 start of the others, 4 after a1, 5 after a2, 6 their goal.
    let mut next = vec![vec![None; 4]; 7];
    next[0] = vec![Some(1), Some(1), None, None];
    next[1] = vec![None, None, Some(2), Some(2)];
    next[3] = vec![Some(4), Some(5), None, None];
    next[4] = vec![None, None, Some(6), None];
    next[5] = vec![None, None, None, Some(6)];
    let names = ["a1", "a2", "b1", "b2"].map(str::to_owned).to_vec();
    let watcher = |&role: &Role| Watcher {
        role,
        belief: set(&[0, 3]),
        symbols: names.clone(),
        sensor: (0..4).map(|action| vec![action; 7]).collect(),
    };
    let table = Table {
        states: (0..7).map(|state| format!("s{state}")).collect(),
        actions: names.clone(),
        next,
        start: 0,
        goals: vec![set(&[2]), set(&[6])],
        goal_names: vec!["G1".to_owned(), "G2".to_owned()],
        true_goal: 0,
        watchers: roles.iter().map(watcher).collect(),
    };
    let wish = Wish { k: Some(2), j: Some(1), ..Wish::default() };
    Case { judge: Judge::built(table, 0), horizon: 2, wish }
}

fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    let figure = Delivery::figure_1();
    let judge = Judge::of(delivery::table(&figure), Arc::new(figure.problem().unwrap()));
    cases.push(Case { judge, horizon: 3, wish: Wish::default() });
    let shape = GridworldShape { width: 3, height: 3, goals: 3, walls: 1, belief: 3 };
    for seed in 0..4 {
        let document = shape.generate(seed).unwrap().document;
        cases.push(grid(&document, 4, Wish::default()));
        // The parity of a step more makes it infeasible.
        cases.push(grid(&document, 5, Wish::default()));
        cases.push(grid(&document, 4, Wish { k: Some(2), j: Some(2), ..Wish::default() }));
    }
    // Bounds of every kind, three observers, the empty plan.
    let mut dice = Dice::new(50);
    let roles = [Adversarial, Cooperative, Adversarial, Cooperative];
    cases.extend([crossed(&roles[..2]), crossed(&roles[..3])]);
    for number in 0..60 {
        let table = random::table(&mut dice, MEDIUM, &roles[..2 + number % 3]);
        let judge = Judge::built(table, 0);
        let wish = random::wish(&mut dice, &judge.table);
        let horizon = if number % 10 == 0 { 0 } else { dice.between(1, 3) };
        cases.push(Case { judge, horizon, wish });
    }
    cases
}

#[test]
fn highs_finds_the_optimum_of_exact_search() {
    let Some(python) = std::env::var_os(PYTHON) else {
        // Past the harness, which shows what a test prints only where it fails.
        let why = "does not name a Python with the package highspy";
        writeln!(std::io::stderr(), "HiGHS test skipped: {PYTHON} {why}").unwrap();
        return;
    };
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("highs");
    std::fs::create_dir_all(&folder).unwrap();
    let (mut files, mut expected) = (Vec::new(), Vec::new());
    let mut optimal = [0, 0];
    let mut infeasible = [0, 0];
    for (number, Case { judge, horizon, wish }) in cases().iter().enumerate() {
        let options = Judge::options(Solver::Exact, Some(*horizon), wish);
        let outcome = judge.solve(&options);
        let ending = judge.check(&options, &outcome, wish);
        for (column, encoding) in Encoding::ALL.into_iter().enumerate() {
            let mut options = Judge::options(Solver::Ip, Some(*horizon), wish);
            options.encoding = encoding;
            // Nothing to print where the encoding itself shows that there is no plan.
            let program = lp_format(Arc::clone(&judge.problem), &options, *horizon).unwrap();
            if !program.may_be_solved {
                assert_eq!(ending, None);
                continue;
            }
            let file = folder.join(format!("{number}-{}.lp", encoding.name()));
            std::fs::write(&file, program.text).unwrap();
            files.push(file);
            expected.push(match &ending {
                Some(ending) => {
                    optimal[column] += 1;
                    format!("optimal {}", oracle::difference(&judge.table, ending))
                }
                None => {
                    infeasible[column] += 1;
                    "infeasible".to_owned()
                }
            });
        }
    }
    println!("{optimal:?} optimal, {infeasible:?} infeasible, by encoding");
    assert!(optimal.iter().all(|&count| count >= 20) && infeasible.iter().all(|&count| count > 0));
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/highs.py");
    let output = Command::new(python).arg(script).args(&files).output().unwrap();
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{errors}");
    let answers = String::from_utf8(output.stdout).unwrap();
    let answers: Vec<&str> = answers.lines().collect();
    for ((file, answer), expected) in files.iter().zip(&answers).zip(&expected) {
        assert_eq!(answer, expected, "{}", file.display());
    }
    assert_eq!(answers.len(), files.len());
}
