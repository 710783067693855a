//! The set-additive heuristic (Keyder and Geffner 2008): a table of tasks with values worked out by
//! hand, and its place between the optimal relaxed plan and the sum.

use mo_copp::heuristic::{SetAdditive, UNREACHABLE};
use mo_copp::task::{Fact, Task, TaskBuilder};

use crate::common::Dice;
use crate::common::random::PAIR;
use crate::common::strips::{Facts, Strips};

/// Facts are letters; an operator is `pre -> add` or `pre -> add - del`.
fn task(start: &str, operators: &[&str]) -> Task {
    let mut task = TaskBuilder::default();
    let letters: Vec<Fact> = ('a'..='z').map(|letter| task.fact(letter)).collect();
    let of = |text: &str| -> Vec<Fact> {
        let letter = |byte: u8| letters[usize::from(byte - b'a')];
        text.bytes().filter(u8::is_ascii_lowercase).map(letter).collect()
    };
    for (number, text) in operators.iter().enumerate() {
        let (pre, effects) = text.split_once("->").unwrap();
        let (add, del) = effects.split_once('-').unwrap_or((effects, ""));
        task.operator(&format!("op{number}"), &of(pre), &of(add), &of(del));
    }
    task.build(&of(start), &[]).unwrap()
}

/// The values of goals in the initial state.
fn values(task: &Task, goals: &[&str]) -> Vec<Option<u32>> {
    let fact = |letter: char| task.facts().find(|&f| task.fact_name(f) == letter.to_string());
    let goals: Vec<Vec<Fact>> = goals
        .iter()
        .map(|goal| goal.chars().map(|letter| fact(letter).unwrap()).collect())
        .collect();
    let goals: Vec<&[Fact]> = goals.iter().map(Vec::as_slice).collect();
    let mut values = vec![0; goals.len()];
    let words = task.initial_state().words();
    SetAdditive::new(task).evaluate(task, words, &goals, &mut values);
    values.into_iter().map(|value| (value != UNREACHABLE).then_some(value)).collect()
}

fn h(start: &str, operators: &[&str], goal: &str) -> Option<u32> {
    values(&task(start, operators), &[goal])[0]
}

#[test]
fn a_goal_that_holds_is_worth_nothing() {
    // π is empty for each fact of the state, and so is the union; the empty goal holds anywhere.
    assert_eq!(h("ab", &["a -> b"], "ab"), Some(0));
    assert_eq!(h("", &["a -> b"], ""), Some(0));
}

#[test]
fn a_chain() {
    // π(b) = {0}, π(c) = {0, 1}, π(d) = {0, 1, 2}.
    assert_eq!(h("a", &["a -> b", "b -> c", "c -> d"], "d"), Some(3));
}

#[test]
fn unreachable_facts() {
    // Nothing adds z; op1 needs it; d needs what op1 would add, beside b that is there.
    let operators = ["a -> b", "z -> c", "bc -> d"];
    assert_eq!(h("a", &operators, "c"), None);
    assert_eq!(h("a", &operators, "d"), None);
    assert_eq!(h("a", &operators, "bz"), None);
    // Two facts that only support each other: c needs d, d needs c.
    assert_eq!(h("a", &["c -> d", "d -> c"], "c"), None);
}

#[test]
fn a_shared_supporter_counts_once() {
    // π(c) = {0, 1} and π(d) = {0, 2} share op0: {0, 1, 2}. The sum would be 4.
    assert_eq!(h("a", &["a -> b", "b -> c", "b -> d"], "cd"), Some(3));
}

#[test]
fn one_operator_for_several_goal_facts() {
    // π(b) = π(c) = π(d) = {0}. The sum would be 3.
    assert_eq!(h("a", &["a -> bcd"], "bcd"), Some(1));
}

#[test]
fn several_preconditions() {
    // π(b) = {0}, π(c) = {1}, π(d) = {2} ∪ π(b) ∪ π(c) = {0, 1, 2}.
    assert_eq!(h("a", &["a -> b", "a -> c", "bc -> d"], "d"), Some(3));
}

#[test]
fn a_diamond() {
    // π(c) = {0, 1}, π(d) = {0, 2}, π(e) = {3} ∪ {0, 1, 2}. The sum would be 5.
    assert_eq!(h("a", &["a -> b", "b -> c", "b -> d", "cd -> e"], "e"), Some(4));
}

#[test]
fn diamonds_one_after_the_other() {
    // π(e) = {0, 1, 2, 3} as above; π(f) = {4} ∪ π(e), π(g) = {5} ∪ π(e), and
    // π(h) = {6} ∪ {4, 5} ∪ π(e): 7. The sum would be 1 + 2 · (1 + 5) = 13.
    let operators = ["a -> b", "b -> c", "b -> d", "cd -> e", "e -> f", "e -> g", "fg -> h"];
    assert_eq!(h("a", &operators, "h"), Some(7));
}

#[test]
fn delete_effects_are_ignored() {
    // Really no plan can have both b and c; relaxed π = {0, 1}.
    assert_eq!(h("a", &["a -> b - a", "a -> c - a"], "bc"), Some(2));
    // op1 deletes what op0 adds: π(b) = {0}, π(c) = {0, 1}, the union is {0, 1}.
    assert_eq!(h("a", &["a -> b", "b -> c - b"], "bc"), Some(2));
}

#[test]
fn operators_without_preconditions() {
    // In the empty state: π(b) = {0}, π(c) = {0, 1}, π(d) = {2}.
    let operators = ["-> b", "b -> c", "-> d"];
    assert_eq!(h("", &operators, "b"), Some(1));
    assert_eq!(h("", &operators, "c"), Some(2));
    assert_eq!(h("", &operators, "cd"), Some(3));
}

#[test]
fn the_smaller_set_supports_even_where_the_sum_is_larger() {
    // By op4, π(z) = {0, 1, 2, 3, 4}: 5, as a sum 1 + 2 + 2 + 2 = 7. Along the chain
    // op5 to op10, 6. The set is smaller, so z is worth 5 (by sums it would be 6).
    let operators = [
        "a -> b", "b -> c", "b -> d", "b -> e", "cde -> z", "a -> f", "f -> g", "g -> h", "h -> i",
        "i -> j", "j -> z",
    ];
    assert_eq!(h("a", &operators, "z"), Some(5));
}

#[test]
fn of_equal_supporters_the_first_found_counts() {
    // b can be had from op0 or op1, c from op1 alone. Supported by op0, {0} ∪ {1} is 2; were op1
    // the first, b and c would both be its work: 1.
    assert_eq!(h("a", &["a -> b", "a -> bc"], "bc"), Some(2));
    assert_eq!(h("a", &["a -> bc", "a -> b"], "bc"), Some(1));
}

#[test]
fn each_fact_takes_its_own_best_supporter() {
    // op0 to op2 add c, d and e one by one, at 1 each. op4 adds all three, but after op3, at 2:
    // three supporters are taken where the best relaxed plan has two operators.
    let operators = ["a -> c", "a -> d", "a -> e", "a -> b", "b -> cde"];
    assert_eq!(h("a", &operators, "cde"), Some(3));
}

#[test]
fn a_supporter_found_later_does_not_replace_a_smaller_one() {
    // c is there after op0, size 1; op2 would add it after op1, size 2. d needs c: {0, 3}.
    assert_eq!(h("a", &["a -> c", "a -> b", "b -> c", "c -> d"], "d"), Some(2));
}

#[test]
fn preconditions_that_hold_cost_nothing() {
    // op1 needs a and c, which hold, and b: π(d) = {0, 1}.
    assert_eq!(h("ac", &["a -> b", "abc -> d"], "d"), Some(2));
}

#[test]
fn several_goals_at_once_do_not_mix() {
    // As one by one: a 0; b 1; c 2; d 2; cd 3; z never; bd 2.
    let task = task("a", &["a -> b", "b -> c", "b -> d"]);
    let goals = ["a", "b", "c", "d", "cd", "z", "bd"];
    let expected = [Some(0), Some(1), Some(2), Some(2), Some(3), None, Some(2)];
    assert_eq!(values(&task, &goals), expected);
    let backwards: Vec<&str> = goals.into_iter().rev().collect();
    let expected: Vec<_> = expected.into_iter().rev().collect();
    assert_eq!(values(&task, &backwards), expected);
}

/// The size of a smallest set of operators that reaches a goal without deletes.
fn optimal_relaxed(problem: &Strips, state: Facts, goal: Facts) -> Option<u32> {
    let reaches = |set: &u32| {
        let mut facts = state;
        // Each round brings a fact, or was the last.
        for _ in 0..=problem.facts {
            for (number, op) in problem.ops.iter().enumerate() {
                if set >> number & 1 == 1 && facts & op.pre == op.pre {
                    facts |= op.add;
                }
            }
        }
        facts & goal == goal
    };
    (0_u32..1 << problem.ops.len()).filter(reaches).map(u32::count_ones).min()
}

/// The additive value: costs by repeated relaxation until nothing changes.
fn additive(problem: &Strips, state: Facts, goal: Facts) -> Option<u32> {
    const FAR: u32 = 1 << 20;
    let mut cost: Vec<u32> =
        (0..problem.facts).map(|fact| if state >> fact & 1 == 1 { 0 } else { FAR }).collect();
    let sum = |cost: &[u32], facts: Facts| -> u32 {
        (0..cost.len()).filter(|fact| facts >> fact & 1 == 1).map(|fact| cost[fact]).sum()
    };
    for _ in 0..=problem.facts {
        for op in &problem.ops {
            let reached = sum(&cost, op.pre) + 1;
            for fact in (0..problem.facts).filter(|fact| op.add >> fact & 1 == 1) {
                cost[fact] = reached.min(cost[fact]);
            }
        }
    }
    let value = sum(&cost, goal);
    (value < FAR).then_some(value)
}

#[test]
fn lies_between_the_optimal_relaxed_plan_and_the_sum() {
    let mut dice = Dice::new(8);
    let mut below_the_sum = 0;
    for _ in 0..2000 {
        let problem = Strips::random(&mut dice, 6, 8, &PAIR);
        let task = problem.task();
        let facts: Vec<Fact> = task.facts().collect();
        let of = |set: Facts| -> Vec<Fact> {
            facts.iter().copied().filter(|fact| set >> fact.index() & 1 == 1).collect()
        };
        let goals: Vec<Vec<Fact>> = problem.goals.iter().map(|&goal| of(goal)).collect();
        let goals: Vec<&[Fact]> = goals.iter().map(Vec::as_slice).collect();
        let mut heuristic = SetAdditive::new(&task);
        // One heuristic for all states, as in a search: nothing may be left over from the last.
        for &state in problem.states().iter().take(8) {
            let mut values = vec![0; goals.len()];
            let packed = task.state(&of(state)).unwrap();
            heuristic.evaluate(&task, packed.words(), &goals, &mut values);
            for (&value, &goal) in values.iter().zip(&problem.goals) {
                let least = optimal_relaxed(&problem, state, goal);
                let most = additive(&problem, state, goal);
                match (least, most) {
                    (Some(least), Some(most)) => {
                        assert!((least..=most).contains(&value), "{least} {value} {most}");
                        assert_eq!(value == 0, state & goal == goal);
                        below_the_sum += usize::from(value < most);
                    }
                    _ => assert_eq!((value, least, most), (UNREACHABLE, None, None)),
                }
            }
        }
    }
    assert!(below_the_sum > 100, "{below_the_sum}");
}
