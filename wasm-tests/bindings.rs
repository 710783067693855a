//! The JavaScript API as JavaScript sees it.

use js_sys::{Array, JSON, Reflect};
use mo_copp::bindings::{Exercise, Problem, Run, seed_of};
use mo_copp::domain::{Delivery, Document};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

fn delivery() -> Problem {
    Problem::new(&Document::Delivery(Delivery::figure_1()).to_json()).unwrap()
}

/// A property, by a path such as `goals.adversarial.0`.
fn get(value: &JsValue, path: &str) -> JsValue {
    path.split('.').fold(value.clone(), |value, key| Reflect::get(&value, &key.into()).unwrap())
}

fn text(value: &JsValue, path: &str) -> String {
    get(value, path).as_string().unwrap()
}

fn length(value: &JsValue, path: &str) -> u32 {
    get(value, path).unchecked_into::<Array>().length()
}

fn solve(problem: &Problem, options: &str) -> Result<Run, JsValue> {
    problem.solve(JSON::parse(options).unwrap().unchecked_into())
}

#[wasm_bindgen_test]
fn a_bad_document_throws_its_place() {
    let error = Problem::new(r#"{"format": "chess"}"#).unwrap_err();
    assert!(error.is_instance_of::<js_sys::Error>());
    assert_eq!(text(&error, "name"), "DocumentError");
    assert_eq!(text(&error, "path"), "format");
    assert_eq!(text(&error, "found"), "\"chess\"");
    let message = text(&error, "message");
    assert_eq!(message, format!("format: found \"chess\", expected {}", text(&error, "expected")));
    let error = Problem::new("{\n  \"format\": ?}").unwrap_err();
    assert_eq!(text(&error, "name"), "DocumentError");
    assert_eq!(get(&error, "line").as_f64(), Some(2.0));
    assert_eq!(get(&error, "column").as_f64(), Some(13.0));
    assert!(get(&error, "path").is_undefined());
}

#[wasm_bindgen_test]
fn every_solver_works_in_slices() {
    let problem = delivery();
    for (options, status) in [
        (r#"{"solver": "exact"}"#, "optimal"),
        (r#"{"solver": "exact", "horizon": 3, "pareto": true}"#, "optimal"),
        (r#"{"solver": "exact", "horizon": 3, "pairs": true}"#, "optimal"),
        (r#"{"solver": "ip"}"#, "optimal"),
        (r#"{"solver": "ip", "encoding": "paper", "horizon": 3}"#, "optimal"),
        (r#"{"solver": "search", "k": 6, "j": 1}"#, "solved"),
        (r#"{"solver": "satisficing", "k": 6, "j": 1}"#, "solved"),
        (r#"{"solver": "baseline"}"#, "solved"),
        (r#"{"solver": "obfuscate", "k": 2}"#, "solved"),
        (r#"{"solver": "legible", "j": 1}"#, "solved"),
        (r#"{"solver": "exact", "horizon": 2}"#, "infeasible"),
    ] {
        let mut run = solve(&problem, options).unwrap();
        while !run.advance(1).unwrap() {
            let progress: JsValue = run.progress().unwrap().into();
            assert!(get(&progress, "done").as_f64().is_some());
            let unit = text(&progress, "unit");
            assert!(unit == "nodes" || unit == "expansions");
        }
        let outcome: JsValue = run.outcome().unwrap().into();
        assert_eq!(text(&outcome, "status"), status, "{options}");
        assert!(get(&outcome, "stats.seconds").as_f64().is_some_and(|seconds| seconds >= 0.0));
        if status == "infeasible" {
            // Null, not undefined: what goes over a message channel keeps its shape.
            assert!(get(&outcome, "plan").is_null() && get(&outcome, "goals").is_null());
            assert!(get(&outcome, "goal_difference").is_null());
            continue;
        }
        assert_eq!(get(&outcome, "goal_difference").as_f64(), Some(1.0));
        assert_eq!(get(&outcome, "horizon").as_f64(), Some(3.0));
        assert_eq!(length(&outcome, "goals.adversarial"), 6);
        assert_eq!(text(&outcome, "goals.cooperative.0"), "a1+a2");
        assert_eq!(length(&outcome, "plan"), 3);
        let pareto = get(&outcome, "pareto");
        assert_eq!(pareto.is_undefined(), !options.contains("pareto"));
        for key in ["pairs", "front"] {
            assert_eq!(get(&outcome, key).is_undefined(), !options.contains("pairs"));
        }
        if !pareto.is_undefined() {
            assert_eq!(get(&outcome, "pareto.0.adversarial").as_f64(), Some(6.0));
        }
    }
}

#[wasm_bindgen_test]
fn the_best_of_each_length() {
    let problem = Problem::new(include_str!("../tests/golden/grid.json")).unwrap();
    let mut run = solve(&problem, r#"{"solver": "exact", "lengths": 9}"#).unwrap();
    while !run.advance(1).unwrap() {}
    let outcome: JsValue = run.outcome().unwrap().into();
    assert_eq!(text(&outcome, "status"), "optimal");
    assert_eq!(length(&outcome, "lengths"), 10);
    let mut best = f64::NEG_INFINITY;
    for steps in 0..10 {
        let options = format!(r#"{{"solver": "exact", "horizon": {steps}}}"#);
        let mut run = solve(&problem, &options).unwrap();
        while !run.advance(64).unwrap() {}
        let alone: JsValue = run.outcome().unwrap().into();
        let point = get(&outcome, &format!("lengths.{steps}"));
        assert_eq!(get(&point, "length").as_f64(), Some(f64::from(steps)));
        let difference = get(&point, "goal_difference");
        assert_eq!(difference, get(&alone, "goal_difference"));
        if difference.is_null() {
            assert!(get(&point, "plan").is_null() && get(&point, "adversarial").is_null());
        } else {
            assert_eq!(length(&point, "plan"), steps);
            best = best.max(difference.as_f64().unwrap());
        }
    }
    assert_eq!(get(&outcome, "goal_difference").as_f64(), Some(best));
    // Of a run that is stopped, the lengths that are proved.
    let mut run = solve(&problem, r#"{"solver": "exact", "lengths": 9}"#).unwrap();
    assert!(!run.advance(3).unwrap());
    let outcome: JsValue = run.outcome().unwrap().into();
    assert!((1..10).contains(&length(&outcome, "lengths")));
    assert_eq!(text(&outcome, "limit"), "stopped on request");
}

#[wasm_bindgen_test]
fn why_there_is_no_plan_and_what_would_do() {
    let options = r#"{"solver": "exact", "k": 6, "j": 1, "horizon": 4}"#;
    let mut run = delivery().remedy(JSON::parse(options).unwrap().unchecked_into()).unwrap();
    while !run.advance(1).unwrap() {
        let progress: JsValue = run.progress().unwrap().into();
        assert!(get(&progress, "done").as_f64().is_some());
        assert_eq!(text(&progress, "unit"), "expansions");
    }
    let advice: JsValue = run.outcome().unwrap().into();
    assert_eq!(text(&advice, "reason"), "length");
    assert_eq!(get(&advice, "shortest").as_f64(), Some(3.0));
    assert_eq!(get(&advice, "complete").as_bool(), Some(true));
    assert_eq!(length(&advice, "remedies"), 1);
    assert_eq!(text(&advice, "remedies.0.change"), "horizon");
    assert_eq!(get(&advice, "remedies.0.value").as_f64(), Some(3.0));
    assert_eq!(get(&advice, "remedies.0.goal_difference").as_f64(), Some(1.0));
    assert_eq!(length(&advice, "remedies.0.plan"), 3);
    let options = r#"{"solver": "exact", "lengths": 4}"#;
    let error = delivery().remedy(JSON::parse(options).unwrap().unchecked_into()).unwrap_err();
    assert_eq!(text(&error, "name"), "OptionsError");
    let mut run =
        delivery().remedy(JSON::parse("{\"solver\": \"ip\"}").unwrap().unchecked_into()).unwrap();
    let advice: JsValue = run.outcome().unwrap().into();
    assert!(get(&advice, "reason").is_null() && get(&advice, "shortest").is_null());
    assert_eq!(get(&advice, "complete").as_bool(), Some(false));
}

#[wasm_bindgen_test]
fn a_stopped_run_says_so() {
    let mut run = solve(&delivery(), r#"{"solver": "search"}"#).unwrap();
    let outcome: JsValue = run.outcome().unwrap().into();
    assert_eq!(text(&outcome, "status"), "limit");
    assert_eq!(text(&outcome, "limit"), "stopped on request");
    assert!(get(&outcome, "plan").is_null());
}

#[wasm_bindgen_test]
fn options_that_do_not_fit_throw() {
    let problem = delivery();
    for (options, message) in [
        (r#"{"solver": "exact", "k": 7}"#, "k: found 7, expected a whole number from 1 to 6"),
        (
            r#"{"solver": "exact", "width": 7}"#,
            "options: found the unknown key \"width\", expected only solver, encoding, horizon, horizon_step, horizon_limit, k, j, require, forbid, pairs, pareto, lengths, cost_limit",
        ),
        (
            r#"{"solver": "ip", "horizon": "any"}"#,
            "horizon: found any, expected a number of steps for the integer program; the exact solver takes any",
        ),
        (
            r#"{"solver": "chess"}"#,
            "solver: found \"chess\", expected one of exact, ip, search, satisficing, baseline, obfuscate, legible",
        ),
    ] {
        let error = solve(&problem, options).unwrap_err();
        assert_eq!(text(&error, "name"), "OptionsError");
        assert_eq!(text(&error, "message"), message);
    }
}

#[wasm_bindgen_test]
fn a_plan_is_traced() {
    let problem = delivery();
    let plan = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect();
    let trace: JsValue = problem.trace(plan(&["load a1", "load b2", "deliver"])).unwrap().into();
    assert_eq!(get(&trace, "valid").as_bool(), Some(false));
    assert_eq!(length(&trace, "steps"), 4);
    assert!(get(&trace, "steps.0.action").is_null());
    assert!(get(&trace, "steps.0.symbols.adversarial").is_null());
    assert_eq!(text(&trace, "steps.2.action"), "load b2");
    assert_eq!(text(&trace, "steps.2.symbols.adversarial"), "package");
    assert_eq!(text(&trace, "steps.2.symbols.cooperative"), "barcode B");
    assert_eq!(length(&trace, "steps.3.beliefs.adversarial"), 6);
    assert_eq!(length(&trace, "steps.3.beliefs.cooperative"), 4);
    assert_eq!(get(&trace, "goal_difference").as_f64(), Some(0.4));
    let error = problem.trace(plan(&["load a1", "load a1"])).map(|_| ()).unwrap_err();
    assert_eq!(text(&error, "name"), "PlanError");
    assert!(text(&error, "message").starts_with("step 2: "));
}

#[wasm_bindgen_test]
fn what_can_be_done_next_is_offered() {
    let problem = Problem::new(include_str!("../tests/golden/grid.json")).unwrap();
    let next: JsValue = problem.next(Vec::new()).unwrap().into();
    let count = next.unchecked_ref::<Array>().length();
    assert!(count > 1);
    for index in 0..count {
        let action = text(&next, &format!("{index}.action"));
        let trace: JsValue = problem.trace(vec![action]).unwrap().into();
        for part in ["0", "1"] {
            let state = get(&next, &format!("{index}.state.{part}"));
            assert_eq!(state, get(&trace, &format!("steps.1.state.{part}")));
        }
        assert_eq!(get(&next, &format!("{index}.goal")), get(&trace, "valid"));
    }
    let error = problem.next(vec!["fly".to_owned()]).map(|_| ()).unwrap_err();
    assert_eq!(text(&error, "name"), "PlanError");
    assert!(text(&error, "message").starts_with("step 1: "));
}

#[wasm_bindgen_test]
fn states_and_scenes_have_the_shape_of_their_format() {
    let grid = include_str!("../tests/golden/grid.json");
    let problem = Problem::new(grid).unwrap();
    let scene: JsValue = problem.scene().unwrap().into();
    assert_eq!(text(&scene, "format"), "gridworld");
    assert_eq!(get(&scene, "width").as_f64(), Some(4.0));
    assert_eq!(get(&scene, "goals.0.cell.0").as_f64(), Some(3.0));
    assert_eq!(text(&scene, "true_goal"), "east");
    assert_eq!(text(&scene, "observers.0.role"), "adversarial");
    let trace: JsValue = problem.trace(vec!["north".to_owned()]).unwrap().into();
    assert_eq!(get(&trace, "steps.1.state.0").as_f64(), Some(0.0));
    assert_eq!(get(&trace, "steps.1.state.1").as_f64(), Some(1.0));
    let scene: JsValue = delivery().scene().unwrap().into();
    assert_eq!(text(&scene, "format"), "delivery");
    assert_eq!(length(&scene, "factories"), 2);
    let problem = Problem::new(include_str!("../examples/logistics.json")).unwrap();
    let scene: JsValue = problem.scene().unwrap().into();
    assert_eq!(text(&scene, "format"), "pddl");
    assert_eq!(text(&scene, "domain"), "logistics");
    assert_eq!(text(&scene, "objects.0.name"), "airport1");
    let types = JSON::stringify(&get(&scene, "objects.0.types")).unwrap();
    assert_eq!(String::from(types), r#"["object","place","airport"]"#);
    assert_eq!(text(&scene, "predicates.2.name"), "road");
    assert_eq!(get(&scene, "predicates.2.changes").as_bool(), Some(false));
    assert_eq!(get(&scene, "predicates.0.changes").as_bool(), Some(true));
    assert_eq!(get(&scene, "predicates.0.arguments").as_f64(), Some(2.0));
    assert_eq!(text(&scene, "initial.0"), "(at truck1 airport1)");
    assert!(text(&scene, "goals.0.condition").starts_with("(and (at p1"));
}

#[wasm_bindgen_test]
fn bad_pddl_throws_its_line_and_column() {
    let document =
        include_str!("../examples/logistics.json").replace("(at p6 airport1)", "(at p7 airport1)");
    let error = Problem::new(&document).unwrap_err();
    assert_eq!(text(&error, "name"), "DocumentError");
    assert_eq!(text(&error, "path"), "problem");
    assert!(text(&error, "message").starts_with("problem, line 22, column 9: found "));
    assert_eq!(get(&error, "line").as_f64(), Some(22.0));
    assert_eq!(get(&error, "column").as_f64(), Some(9.0));
}

/// The text that the command writes: `tests/pictures.rs` holds the native one against the same file.
#[wasm_bindgen_test]
fn a_picture_is_the_same_text_as_natively() {
    let problem = Problem::new(include_str!("../www/problems/eight-by-eight.json")).unwrap();
    let plan = || ["north", "north", "east"].map(str::to_owned).to_vec();
    let options = |text: &str| JSON::parse(text).unwrap().unchecked_into();
    let svg = problem.picture(plan(), options(r#"{"step": 2}"#)).unwrap();
    assert_eq!(svg, include_str!("../tests/golden/picture.svg"));
    let error = problem.picture(plan(), options(r#"{"step": 4}"#)).unwrap_err();
    assert_eq!(text(&error, "name"), "OptionsError");
    assert_eq!(text(&error, "message"), "step: found 4, expected a whole number from 0 to 3");
    let error = problem.picture(vec!["west".to_owned()], options("{}")).unwrap_err();
    assert_eq!(text(&error, "name"), "PlanError");
}

#[wasm_bindgen_test]
fn the_seed_of_a_name_is_that_of_the_command() {
    for name in ["Zo\u{eb}", "Zoe\u{308}", " \u{ff3a}o\u{eb}\u{200b}\u{3000}"] {
        assert_eq!(seed_of(name), 395_343.0, "{name:?}");
    }
    assert_eq!(seed_of("Ada\u{a0} Lovelace"), seed_of("Ada Lovelace"));
}

#[wasm_bindgen_test]
fn an_author_hears_of_the_variants_of_an_exercise() {
    let goals = include_str!("../examples/exercises/01-possible-goals.json");
    let sample = Exercise::new(goals, 0.0).unwrap().sample(goals).unwrap().into();
    assert_eq!((get(&sample, "seeds"), get(&sample, "different")), (20.into(), 20.into()));
    assert_eq!(length(&sample, "remarks"), 0);
    let vary = r#""vary": ["start", "goals", "walls", "plan"]"#;
    assert!(goals.contains(vary));
    let fixed = goals.replace(vary, r#""vary": []"#);
    assert!(Exercise::new(&fixed, 0.0).unwrap().sample(&fixed).unwrap().is_null());
    let true_goal = goals.replace(vary, r#""vary": ["true_goal"]"#);
    assert_eq!(text(&Exercise::new(&true_goal, 0.0).unwrap_err(), "path"), "exercise.vary");
}
