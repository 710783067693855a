//! `mo-copp solve`

use serde_json::{Value, json};

use crate::{DELIVERY, EXPLICIT, GRID, mo_copp};

#[test]
fn json_has_the_fields_of_the_contract() {
    let ran = mo_copp(EXPLICIT, &["solve", "-", "--solver", "exact", "--horizon", "1", "--json"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let json = ran.json();
    assert_eq!(json["status"], "optimal");
    assert_eq!(json["solver"], "exact");
    assert_eq!(json["horizon"], 1);
    assert_eq!(json["plan"], json!(["a"]));
    assert_eq!(json["goals"], json!({"adversarial": ["G1", "G2"], "cooperative": ["G1"]}));
    assert_eq!(json["goal_difference"], 1.0);
    assert!(json["stats"]["expansions"].as_u64().is_some());
    assert!(json["stats"]["seconds"].as_f64().unwrap() >= 0.0);
    assert!(json.get("pareto").is_none());
}

#[test]
fn every_solver_answers_the_delivery() {
    let all: &[&[&str]] = &[
        &["--solver", "exact"],
        &["--solver", "exact", "--horizon", "3"],
        &["--solver", "exact", "--horizon", "any", "--pareto"],
        &["--solver", "ip"],
        &["--solver", "ip", "--encoding", "paper", "--horizon", "3"],
        &["--solver", "ip", "--encoding", "belief-flow", "--horizon", "3"],
        &["--solver", "search", "--k", "2", "--j", "2"],
        &["--solver", "satisficing", "--k", "2", "--j", "2"],
        &["--solver", "satisficing", "--k", "2", "--j", "2", "--horizon", "3"],
        &["--solver", "baseline"],
        &["--solver", "obfuscate", "--k", "3"],
        &["--solver", "legible", "--j", "3"],
    ];
    for options in all {
        let ran = mo_copp(DELIVERY, &[&["solve", "-", "--json"], *options].concat());
        assert_eq!(ran.code, 0, "{options:?}: {}", ran.err);
        let json = ran.json();
        let expected = if matches!(options[1], "exact" | "ip") { "optimal" } else { "solved" };
        assert_eq!(json["status"], expected, "{options:?}");
        assert_eq!(json["goal_difference"], 1.0, "{options:?}");
        assert_eq!(json["goals"]["cooperative"], json!(["a1+a2"]), "{options:?}");
        assert_eq!(json["horizon"], 3, "{options:?}");
    }
}

#[test]
fn one_package_from_each_factory_is_worth_two_fifths() {
    let mixed = DELIVERY.replace("\"a1+a2\"", "\"b1+a1\"");
    let ran = mo_copp(&mixed, &["solve", "-", "--json"]);
    assert_eq!(ran.json()["goal_difference"], 0.4);
    assert_eq!(ran.json()["goals"]["adversarial"].as_array().unwrap().len(), 6);
}

#[test]
fn pareto_lists_the_pairs_sorted() {
    let grid = mo_copp("", &["generate", "gridworld", "--seed", "3"]).out;
    let json = mo_copp(&grid, &["solve", "-", "--pareto", "--json"]).json();
    let pairs: Vec<(u64, u64)> = json["pareto"]
        .as_array()
        .unwrap()
        .iter()
        .map(|p| (p["adversarial"].as_u64().unwrap(), p["cooperative"].as_u64().unwrap()))
        .collect();
    assert!(pairs.len() > 1, "{pairs:?}");
    assert!(pairs.windows(2).all(|pair| pair[0] < pair[1]), "{pairs:?}");
    let best = pairs.iter().map(|&(x, c)| (x as f64 - c as f64) / 2.0).fold(-1.0, f64::max);
    assert_eq!(json["goal_difference"].as_f64().unwrap(), best);
}

#[test]
fn pairs_have_their_front_and_their_old_name() {
    let grid = mo_copp("", &["generate", "gridworld", "--seed", "3"]).out;
    let json = mo_copp(&grid, &["solve", "-", "--pairs", "--json"]).json();
    let old = mo_copp(&grid, &["solve", "-", "--pareto", "--json"]).json();
    assert_eq!(json["pairs"], old["pareto"]);
    for key in ["pareto", "pareto_complete", "pairs_complete"] {
        assert!(json.get(key).is_none(), "{key}");
    }
    for key in ["pairs", "front", "pairs_complete", "pareto_complete"] {
        assert!(old.get(key).is_none(), "{key}");
    }
    let front = json["front"].as_array().unwrap();
    let counts = |pair: &Value| {
        (pair["adversarial"].as_u64().unwrap(), pair["cooperative"].as_u64().unwrap())
    };
    // More goals for the enemy only at the price of more for the friend.
    let front: Vec<(u64, u64)> = front.iter().map(counts).collect();
    assert!(!front.is_empty() && front.windows(2).all(|two| two[0].0 < two[1].0));
    assert!(front.windows(2).all(|two| two[0].1 < two[1].1), "{front:?}");
    let text = mo_copp(&grid, &["solve", "-", "--pairs"]).out;
    assert_eq!(text.matches("\n *(").count(), front.len(), "{text}");
    let all = json["pairs"].as_array().unwrap().len();
    assert_eq!(text.matches("\n  (").count(), all - front.len(), "{text}");
}

#[test]
fn pairs_found_before_a_limit_are_kept() {
    let boxes = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/box-pushing.json");
    let options = ["solve", boxes, "--pareto", "--expansion-limit", "20000"];
    let ran = mo_copp("", &[&options[..], &["--json"]].concat());
    assert_eq!(ran.code, 0, "{}", ran.err);
    let json = ran.json();
    // No plan can have a greater difference, however many are left.
    assert_eq!((&json["status"], &json["goal_difference"]), (&json!("optimal"), &json!(1.0)));
    assert_eq!(json["limit"], "expansion limit reached: 20000");
    let pairs = json["pareto"].as_array().unwrap();
    assert_eq!(pairs.len(), 2, "{pairs:?}");
    assert_eq!(pairs[1]["plan"], json["plan"]);
    assert_eq!(json["pareto_complete"], false);
    let text = mo_copp("", &options).out;
    assert!(text.starts_with(
        "optimal: no plan of any length has a greater goal difference\nstopped: expansion limit"
    ));
    assert!(text.contains("\npairs found so far, not all (goals possible for"), "{text}");
    let few = mo_copp(GRID, &["solve", "-", "--pareto", "--expansion-limit", "3", "--json"]).json();
    assert_eq!((&few["status"], &few["pareto_complete"]), (&json!("feasible"), &json!(false)));
    assert_eq!(few["pareto"].as_array().unwrap().len(), 1, "{few}");
    let none = mo_copp(GRID, &["solve", "-", "--pareto", "--memory-limit", "0", "--json"]).json();
    assert_eq!((&none["pareto"], &none["pareto_complete"]), (&json!([]), &json!(false)));
    let whole = mo_copp(EXPLICIT, &["solve", "-", "--pareto", "--json"]).json();
    assert!(whole["pareto"].is_array() && whole.get("pareto_complete").is_none());
}

#[test]
fn no_plan_is_exit_code_1_and_null() {
    for options in [
        &["--horizon", "0"][..],
        &["--solver", "ip", "--horizon", "0"],
        &["--solver", "ip", "--encoding", "paper", "--horizon", "13"],
        &["--solver", "search", "--horizon", "13", "--k", "1"],
        &["--solver", "baseline", "--horizon", "13"],
        &["--forbid", "adversarial:G1"],
    ] {
        let ran = mo_copp(GRID, &[&["solve", "-", "--json"], options].concat());
        assert_eq!(ran.code, 1, "{options:?}: {}", ran.err);
        let json = ran.json();
        assert_eq!(json["status"], "infeasible", "{options:?}");
        for key in ["plan", "goals", "goal_difference"] {
            assert!(json[key].is_null(), "{options:?}: {key}");
        }
        let ran = mo_copp(GRID, &[&["solve", "-"], options].concat());
        assert!(ran.out.starts_with("infeasible: there is no such plan"), "{}", ran.out);
    }
}

#[test]
fn a_horizon_without_a_plan_is_raised() {
    let options = ["solve", "-", "--json", "--horizon", "12", "--horizon-step", "1"];
    let ran = mo_copp(GRID, &[&options[..], &["--solver", "ip"]].concat());
    assert_eq!(ran.json()["horizon"], 14);
    let ran = mo_copp(GRID, &[&options[..], &["--solver", "exact"]].concat());
    assert_eq!(ran.json()["horizon"], 14);
    let ran = mo_copp(GRID, &[&options[..], &["--horizon-limit", "13"]].concat());
    assert_eq!((ran.code, ran.json()["status"].as_str()), (3, Some("limit")), "{}", ran.out);
}

#[test]
fn bounds_and_named_goals_are_kept() {
    let bounds = ["--require", "adversarial:G2", "--forbid", "cooperative:G2"];
    let ran = mo_copp(EXPLICIT, &[&["solve", "-", "--json"][..], &bounds].concat());
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert_eq!(ran.json()["goals"]["adversarial"], json!(["G1", "G2"]));
    assert_eq!(ran.json()["goals"]["cooperative"], json!(["G1"]));
    for bounds in [["--forbid", "adversarial:G2"], ["--require", "cooperative:G2"]] {
        let ran = mo_copp(EXPLICIT, &[&["solve", "-", "--json"][..], &bounds].concat());
        assert_eq!(ran.code, 1, "{bounds:?}: {}", ran.out);
    }
}

#[test]
fn limits_are_named_and_exit_with_3() {
    let ran = mo_copp(GRID, &["solve", "-", "--json", "--memory-limit", "0"]);
    assert_eq!(ran.code, 3, "{}", ran.out);
    assert_eq!(ran.json()["status"], "limit");
    assert!(ran.json()["limit"].as_str().unwrap().starts_with("memory limit reached: 0 MiB"));
    let ran = mo_copp(
        GRID,
        &["solve", "-", "--solver", "search", "--k", "3", "--j", "1", "--expansion-limit", "2"],
    );
    assert_eq!(ran.code, 3, "{}", ran.out);
    assert!(ran.out.contains("expansion limit reached: 2"), "{}", ran.out);
}

#[test]
fn options_that_are_not_used_are_said() {
    let ran = mo_copp(GRID, &["solve", "-", "--solver", "baseline", "--k", "2"]);
    assert_eq!(ran.code, 0);
    assert_eq!(ran.err, "mo-copp: note: --k is not used by the solver baseline\n");
}

#[test]
fn the_text_says_what_was_proved_and_who_believes_what() {
    let ran = mo_copp(DELIVERY, &["solve", "-"]);
    let expected = "\
optimal: no plan of any length has a greater goal difference
plan: 3 actions
  load a1, load a2, deliver
goal difference: 1
  the enemy (adversarial) holds 6 of 6 goals possible: a1+a2, a1+b1, a1+b2, a2+b1, a2+b2, b1+b2
  the friend (cooperative) holds 1 of 6 goals possible: a1+a2
work: ";
    assert!(ran.out.starts_with(expected), "{}", ran.out);
}

#[test]
fn the_exit_code_is_the_answer_even_when_nobody_reads_it() {
    use std::io::Write;
    let mut child = crate::command(&["solve", "-", "--horizon", "0", "--json"]).spawn().unwrap();
    drop(child.stdout.take());
    child.stdin.take().unwrap().write_all(GRID.as_bytes()).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(1));
}

#[test]
fn a_node_limit_of_0_allows_the_root_alone() {
    let grid =
        mo_copp("", &["generate", "gridworld", "--seed", "1", "--width", "4", "--height", "4"]).out;
    let program =
        ["--solver", "ip", "--encoding", "paper", "--horizon-step", "1", "--horizon", "6"];
    let ran =
        mo_copp(&grid, &[&["solve", "-", "--json", "--node-limit", "0"][..], &program].concat());
    assert_eq!(ran.json()["stats"]["nodes"], 0, "{}", ran.out);
    assert_eq!(ran.json()["limit"], "node limit reached: 0 branch-and-bound nodes", "{}", ran.out);
    assert_eq!((ran.code, ran.json()["status"].as_str()), (0, Some("feasible")), "{}", ran.out);
}

#[test]
fn a_mark_of_the_encoding_is_no_part_of_a_document() {
    let ran = mo_copp(&format!("\u{feff}{EXPLICIT}"), &["solve", "-", "--json"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
}

#[test]
fn the_best_of_each_length_is_shown() {
    let ran = mo_copp(GRID, &["solve", "-", "--solver", "exact", "--lengths", "16", "--json"]);
    assert_eq!((ran.code, ran.err.as_str()), (0, ""));
    let answer = ran.json();
    let points = answer["lengths"].as_array().unwrap();
    assert_eq!(points.len(), 17);
    let none = serde_json::json!({
        "length": 13, "adversarial": null, "cooperative": null, "goal_difference": null,
        "plan": null,
    });
    assert_eq!(points[13], none);
    for length in [14, 16] {
        let text = length.to_string();
        let alone = mo_copp(GRID, &["solve", "-", "--horizon", &text, "--json"]).json();
        assert_eq!(points[length]["goal_difference"], alone["goal_difference"]);
        assert_eq!(points[length]["plan"].as_array().unwrap().len(), length);
        for role in ["adversarial", "cooperative"] {
            let count = alone["goals"][role].as_array().unwrap().len();
            assert_eq!(points[length][role], count);
        }
    }
    assert_eq!(answer["horizon"], 14);
    let ran = mo_copp(GRID, &["solve", "-", "--lengths", "14"]);
    let lines: Vec<&str> = ran.out.lines().collect();
    assert_eq!(lines[0], "optimal: no plan of at most 14 actions has a greater goal difference");
    let place = lines.iter().position(|line| line.starts_with("best goal difference of each"));
    let table = &lines[place.unwrap() + 1..][..15];
    assert_eq!(table[13], "    13 actions: no plan");
    assert!(table[14].starts_with("    14 actions:      0 (1, 1): "), "{}", table[14]);
    let ran = mo_copp(GRID, &["solve", "-", "--lengths", "13", "--json"]);
    assert_eq!((ran.code, ran.json()["status"].as_str()), (1, Some("infeasible")));
    let ran = mo_copp(GRID, &["solve", "-", "--lengths", "13", "--horizon", "13"]);
    assert_eq!(ran.code, 2);
}

#[test]
fn why_there_is_no_plan_and_what_would_do() {
    let ran = mo_copp(GRID, &["solve", "-", "--horizon", "15"]);
    assert_eq!(ran.code, 1);
    let first = "mo-copp: G1 can be reached in 14 actions, but not in exactly 15\n  with --horizon 16 there is";
    assert!(ran.err.starts_with(first), "{}", ran.err);
    assert!(ran.err.contains("\n  with --horizon 14 there is a plan (goal difference "));
    assert_eq!(ran.err.lines().count(), 3, "{}", ran.err);
    for solver in ["exact", "ip", "search", "satisficing", "baseline"] {
        let ran = mo_copp(GRID, &["solve", "-", "--horizon", "9", "--solver", solver, "--json"]);
        assert_eq!((ran.code, ran.err.as_str()), (1, ""));
        let remedy = &ran.json()["remedy"];
        assert_eq!(remedy["reason"], "length");
        assert_eq!(remedy["shortest"], 14);
        assert_eq!(remedy["complete"], true);
        let remedies = remedy["remedies"].as_array().unwrap();
        assert_eq!(remedies.len(), 1);
        assert_eq!(
            (&remedies[0]["change"], &remedies[0]["value"]),
            (&"horizon".into(), &14.into())
        );
        let alone = mo_copp(GRID, &["solve", "-", "--horizon", "14", "--json"]).json();
        assert_eq!(remedies[0]["goal_difference"], alone["goal_difference"]);
    }
    // All the enemy has to go by is how long it took, and the friend sees the loading.
    let ran =
        mo_copp(DELIVERY, &["solve", "-", "--k", "6", "--j", "1", "--forbid", "adversarial:b1+b2"]);
    assert_eq!(
        ran.err,
        "mo-copp: plans reach a1+a2, but none keeps the bounds\n  no change of a single number would help\n"
    );
    let island = GRID.replace("\"walls\": [[3, 3]]", "\"walls\": [[6, 0], [7, 1]]");
    let ran = mo_copp(&island, &["solve", "-"]);
    assert_eq!((ran.code, ran.err.as_str()), (1, "mo-copp: the true goal G1 cannot be reached\n"));
    assert!(mo_copp(GRID, &["solve", "-", "--json"]).json().get("remedy").is_none());
}

/// Roads that cost and slides that do not: the limit, what is said of it, and plans beyond it.
#[test]
fn a_cost_limit_holds_for_every_solver_and_for_traces() {
    let costs = include_str!("../golden/costs.json");
    let solve = |more: &[&str]| mo_copp(costs, &[&["solve", "-"], more].concat());
    for solver in ["exact", "ip", "search", "satisficing", "baseline"] {
        let found = solve(&["--solver", solver, "--cost-limit", "2", "--json"]).json();
        assert!(found["cost"].as_u64().unwrap() <= 2, "{found}");
        assert_eq!(found["cost_limit"], 2);
    }
    // A walk to the mill (2), and a slide from there; or a slide to the pond and a walk (1).
    let none = solve(&["--cost-limit", "0", "--json"]);
    assert_eq!((none.code, &none.json()["status"]), (1, &"infeasible".into()));
    assert!(none.json().get("remedy").is_none());
    let said = solve(&["--cost-limit", "0"]);
    assert!(said.out.contains("no such plan of any length that costs at most 0"), "{}", said.out);
    assert!(said.err.contains("not searched under a cost limit"), "{}", said.err);
    let trace = |limit: &str, more: &[&str]| {
        let plan = ["trace", "-", "--plan", "(walk hill mill),(glide mill shop)"];
        mo_copp(costs, &[&plan[..], &["--cost-limit", limit], more].concat())
    };
    assert_eq!((trace("2", &[]).code, trace("1", &[]).code), (0, 1));
    assert_eq!(trace("2", &["--json"]).json()["valid"], true);
    assert_eq!(trace("1", &["--json"]).json()["valid"], false);
    assert!(trace("1", &[]).out.contains("the plan costs 2, more than the limit of 1"));
    let encoded = |encoding: &str, more: &[&str]| {
        let command = ["encode", "-", "--horizon", "2", "--encoding", encoding];
        mo_copp(costs, &[&command[..], more].concat()).out
    };
    for encoding in ["paper", "belief-flow"] {
        assert!(encoded(encoding, &["--cost-limit", "2"]).contains(" cost: "), "{encoding}");
        assert!(!encoded(encoding, &[]).contains(" cost: "), "{encoding}");
    }
    let wrong = solve(&["--cost-limit", "-1"]);
    assert_eq!(wrong.code, 2);
}
