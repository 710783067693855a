//! PDDL documents: bad ones, and what their sensors and beliefs mean.

use std::collections::BTreeSet;
use std::sync::Arc;

use mo_copp::domain::Document;
use mo_copp::limits::LimitReached;
use mo_copp::plan::Plan;
use mo_copp::problem::{Problem, StateCount};
use mo_copp::solver::{Horizon, Options, Solver, Status};
use mo_copp::trace::{Trace, pass, trace};

use super::Change::{Drop, Put};
use super::{changed, check, documented, message};
use crate::common::check::solve;

/// The example of the documentation.
pub fn example() -> &'static str {
    documented("pddl")
}

fn problem(text: &str) -> Arc<Problem> {
    Arc::new(Document::parse(text).unwrap().problem().unwrap())
}

#[test]
fn texts_keys_and_goals() {
    let table = [
        (
            Put("/width", "8"),
            "document: found the unknown key \"width\", expected only format, domain, problem, goals, true_goal, observers",
        ),
        (Drop("/domain"), "domain: found nothing, expected the domain in PDDL"),
        (Put("/domain", "3"), "domain: found 3, expected a text in PDDL, or the list of its lines"),
        (
            Put("/domain", "[]"),
            "domain: found [], expected a text in PDDL, or the list of its lines",
        ),
        (Put("/domain/2", "3"), "domain[2]: found 3, expected a line of PDDL"),
        (
            Put("/domain/2", "\"(:types room) letter\""),
            "domain, line 3, column 15: found \"letter\", expected a section: :requirements, :types, :constants, :predicates, :functions or :action",
        ),
        (
            Put("/domain/2", "\"(:types room)\""),
            "domain, line 5, column 30: found the undeclared type \"letter\", expected a type of the domain: object, room",
        ),
        (
            Put("/domain", "\"(define (domain courier))\""),
            "problem, line 3, column 35: found the undeclared type \"room\", expected a type of the domain: object",
        ),
        (
            Put("/domain/0", "\"(define (domain rocket)\""),
            "problem: found (:domain courier), expected \"rocket\", which is the domain's name",
        ),
        (Drop("/problem"), "problem: found nothing, expected the problem in PDDL"),
        (
            Put("/problem/3", "\"(:init (at cellar)\""),
            "problem, line 4, column 12: found the undeclared object \"cellar\", expected an object or a constant: hall, office, archive, red, blue",
        ),
        (
            Put("/problem/5", "\"(door hall archive)) (:goal (in blue archive)))\""),
            "problem: found another :goal, expected that of the true goal red, or no :goal at all",
        ),
        (Put("/problem/5", "\"(door hall archive)) (:goal (and (in red archive))))\""), "no error"),
        (Put("/goals", "[]"), "goals: found 0 candidate goals, expected 2 to 1024"),
        (Put("/goals/1", "\"blue\""), "goals[1]: found \"blue\", expected an object"),
        (
            Put("/goals/1/facts", "[]"),
            "goals[1]: found the unknown key \"facts\", expected only name, condition",
        ),
        (
            Put("/goals/1/name", "\"red\""),
            "goals[1].name: found the goal name \"red\" for the second time, expected a name of its own",
        ),
        (
            Put("/goals/1/condition", "\"(in blue cellar)\""),
            "goals[1].condition, line 1, column 10: found the undeclared object \"cellar\", expected an object or a constant: hall, office, archive, red, blue",
        ),
        (
            Put("/goals/1/condition", "\"(or (has red) (had blue))\""),
            "goals[1].condition, line 1, column 16: found the undeclared predicate \"had\", expected a predicate of the domain: at, door, in, has",
        ),
        (
            Put("/goals/1/condition", "\"(in ?x archive)\""),
            "goals[1].condition, line 1, column 5: found \"?x\", expected an object, no variable",
        ),
        (Put("/goals/1/condition", "\"(and (at hall) (at office))\""), "no error"),
        (Put("/goals/1/condition", "\"(door office archive)\""), "no error"),
        (Put("/goals/1/condition", "\"(or (has red) (has blue))\""), "no error"),
        (Put("/goals/1/condition", "\"(exists (?l - letter) (has ?l))\""), "no error"),
        (
            Put("/true_goal", "\"green\""),
            "true_goal: found \"green\", expected the name of a candidate goal: red, blue, both",
        ),
    ];
    check(example(), &table);
}

#[test]
fn groups() {
    let table = [
        (
            Put("/observers/adversarial/eyes", "2"),
            "observers.adversarial: found the unknown key \"eyes\", expected only initial_belief, groups, sensor",
        ),
        (
            Put("/observers/adversarial/groups", "[[\"red\", \"blue\"]]"),
            "observers.adversarial.groups: found [[\"red\", \"blue\"]], expected an object",
        ),
        (
            Put("/observers/adversarial/groups/envelope/1", "\"green\""),
            "observers.adversarial.groups.envelope[1]: found \"green\", expected an object of the problem: hall, office, archive, red, blue",
        ),
        (
            Put("/observers/adversarial/groups/envelope/1", "\"RED\""),
            "observers.adversarial.groups.envelope[1]: found \"RED\" for the second time, expected each object in one group at most",
        ),
        (
            Put("/observers/adversarial/groups/paper", "[\"red\"]"),
            "observers.adversarial.groups.paper[0]: found \"red\" for the second time, expected each object in one group at most",
        ),
        (
            Put("/observers/adversarial/groups/paper", "[]"),
            "observers.adversarial.groups.paper: found no objects, expected objects that look alike",
        ),
        (
            Put("/observers/adversarial/groups/Letter", "[\"hall\"]"),
            "observers.adversarial.groups.Letter: found \"Letter\", which is the name of a type, expected a name of its own",
        ),
        (
            Put("/observers/adversarial/groups/office", "[\"hall\"]"),
            "observers.adversarial.groups.office: found \"office\", which is the name of an object, expected a name of its own",
        ),
        (
            Put("/observers/adversarial/groups/Envelope", "[\"hall\"]"),
            "observers.adversarial.groups.envelope: found \"envelope\", which is the name of another group, expected a name of its own",
        ),
    ];
    check(example(), &table);
}

#[test]
fn rules() {
    let table = [
        (
            Drop("/observers/adversarial/sensor"),
            "observers.adversarial.sensor: found nothing, expected a template of symbols, or a list of rules",
        ),
        (
            Put("/observers/adversarial/sensor", "{}"),
            "observers.adversarial.sensor.table: found nothing, expected a list of operators with their symbols",
        ),
        (
            Put("/observers/adversarial/sensor", "7"),
            "observers.adversarial.sensor: found 7, expected a template of symbols, or a list of rules",
        ),
        (
            Put("/observers/adversarial/sensor", "[]"),
            "observers.adversarial.sensor: found no symbol for (walk hall office), expected a rule that matches it",
        ),
        (
            Put("/observers/adversarial/sensor/3", "{\"operator\": \"leave\", \"symbol\": \"x\"}"),
            "no error",
        ),
        (
            Put("/observers/adversarial/sensor/2", "{\"operator\": \"take\", \"symbol\": \"x\"}"),
            "no error",
        ),
        (
            Put("/observers/adversarial/sensor/3/operator", "\"(leave red ?room)\""),
            "observers.adversarial.sensor: found no symbol for (leave blue hall), expected a rule that matches it",
        ),
        (Put("/observers/adversarial/sensor/1/result", "\"(not (at hall))\""), "no error"),
        (
            Put("/observers/adversarial/sensor/3/result", "\"(at archive)\""),
            "observers.adversarial.sensor: found no symbol for (leave red hall) in every resulting state, expected rules whose results leave none out, or a last one without a result",
        ),
        (
            Put("/observers/adversarial/sensor/0/when", "\"(at hall)\""),
            "observers.adversarial.sensor[0]: found the unknown key \"when\", expected only operator, result, symbol",
        ),
        (
            Drop("/observers/adversarial/sensor/0/symbol"),
            "observers.adversarial.sensor[0].symbol: found nothing, expected a template of the symbol",
        ),
        (
            Put("/observers/adversarial/sensor/0/operator", "\"run\""),
            "observers.adversarial.sensor[0].operator, line 1, column 1: found the undeclared action \"run\", expected an action of the domain: walk, take, leave",
        ),
        (
            Put("/observers/adversarial/sensor/0/operator", "\"(walk ?x)\""),
            "observers.adversarial.sensor[0].operator, line 1, column 1: found walk with 1 argument, expected 2 arguments",
        ),
        (
            Put("/observers/adversarial/sensor/0/operator", "\"(walk ?x red)\""),
            "observers.adversarial.sensor[0].operator, line 1, column 10: found \"red\", expected room",
        ),
        (
            Put("/observers/adversarial/sensor/0/operator", "\"(walk ?x cellar)\""),
            "observers.adversarial.sensor[0].operator, line 1, column 10: found the undeclared object \"cellar\", expected an object or a constant: hall, office, archive, red, blue",
        ),
        (
            Put("/observers/adversarial/sensor/0/operator", "\"(walk ?x ?y - letter)\""),
            "observers.adversarial.sensor[0].operator, line 1, column 15: found \"letter\", expected room",
        ),
        (
            Put("/observers/adversarial/sensor/0/operator", "\"(walk ?x ?y - envelope)\""),
            "observers.adversarial.sensor[0].operator, line 1, column 15: found \"envelope\", expected a group with a room",
        ),
        (
            Put("/observers/adversarial/sensor/0/operator", "\"(walk ?x ?y - chamber)\""),
            "observers.adversarial.sensor[0].operator, line 1, column 15: found the undeclared type \"chamber\", expected a type of the domain: object, room, letter; or a group: envelope",
        ),
        (
            Put(
                "/observers/adversarial/sensor/0/operator",
                "\"(walk ?x ?y - (either envelope letter))\"",
            ),
            "observers.adversarial.sensor[0].operator, line 1, column 15: found \"(either …)\", expected a group with a room",
        ),
        (
            Put(
                "/observers/adversarial/sensor/0/operator",
                "\"(walk ?x ?y - (either envelope chamber))\"",
            ),
            "observers.adversarial.sensor[0].operator, line 1, column 32: found the undeclared type \"chamber\", expected a type of the domain: object, room, letter; or a group: envelope",
        ),
        (
            Put("/observers/adversarial/sensor/0/operator", "\"(walk ?x - room ?x - room)\""),
            "observers.adversarial.sensor[0].operator, line 1, column 22: found a type behind \"?x\" for the second time, expected none there",
        ),
        (
            Put("/observers/adversarial/sensor/0/operator", "\"(walk ?x ?y\""),
            "observers.adversarial.sensor[0].operator, line 1, column 12: found the end of the text, expected \")\" for the \"(\" of line 1, column 1",
        ),
    ];
    check(example(), &table);
}

#[test]
fn results_and_templates() {
    let table = [
        (
            Put("/observers/adversarial/sensor/2/operator", "\"walk\""),
            "observers.adversarial.sensor[2].operator: found \"walk\", all of which rule 2 takes, expected a rule that some operator is left for",
        ),
        (
            Put("/observers/adversarial/sensor/0/result", "\"(at ?to)\""),
            "observers.adversarial.sensor[0].result, line 1, column 5: found the undeclared variable \"?to\", expected a parameter: there is none",
        ),
        (
            Put("/observers/adversarial/sensor/2/result", "\"(has ?paper)\""),
            "observers.adversarial.sensor[2].result, line 1, column 6: found the undeclared variable \"?paper\", expected a parameter: ?letter, ?room",
        ),
        (
            Put("/observers/adversarial/sensor/2/result", "\"(at ?letter)\""),
            "observers.adversarial.sensor[2].result, line 1, column 5: found \"?letter\" of the type letter, expected room as argument 1 of at",
        ),
        (
            Put("/observers/adversarial/sensor/2/symbol", "\"takes {?paper}\""),
            "observers.adversarial.sensor[2].symbol: found the placeholder {?paper}, expected a variable of the pattern: ?letter, ?room",
        ),
        (
            Put("/observers/adversarial/sensor/2/symbol", "\"takes {3}\""),
            "observers.adversarial.sensor[2].symbol: found the placeholder {3}, expected a placeholder from 1 to the number of arguments of take, which is 2",
        ),
        (
            Put("/observers/adversarial/sensor/2/symbol", "\"takes {letter}\""),
            "observers.adversarial.sensor[2].symbol: found the placeholder {letter}, expected {name}, {arguments}, {1}, {2}, … or {?variable}",
        ),
        (
            Put("/observers/adversarial/sensor/2/symbol", "\"takes {1\""),
            "observers.adversarial.sensor[2].symbol: found a lone {, expected braces in pairs; {{ and }} stand for braces themselves",
        ),
        (
            Put("/observers/cooperative/sensor", "\"{3}\""),
            "observers.cooperative.sensor: found the placeholder {3}, expected a placeholder from 1 to the number of arguments of walk, which is 2",
        ),
        (
            Put("/observers/cooperative/sensor", "\"\""),
            "observers.cooperative.sensor: found \"\", expected a text that is not empty",
        ),
    ];
    check(example(), &table);
}

#[test]
fn initial_beliefs() {
    let table = [
        (
            Put("/observers/cooperative/initial_belief", "3"),
            "observers.cooperative.initial_belief: found 3, expected a list of states, or an object with reachable",
        ),
        (
            Put("/observers/cooperative/initial_belief", "{\"states\": []}"),
            "observers.cooperative.initial_belief: found the unknown key \"states\", expected only reachable",
        ),
        (
            Put("/observers/cooperative/initial_belief", "[]"),
            "observers.cooperative.initial_belief: found 0 states without the initial state, expected the initial state among them, as in {}",
        ),
        (
            Put("/observers/cooperative/initial_belief/0", "{\"add\": [\"(has red)\"]}"),
            "observers.cooperative.initial_belief: found 2 states without the initial state, expected the initial state among them, as in {}",
        ),
        (
            Put(
                "/observers/cooperative/initial_belief/0",
                "[\"(at hall)\", \"(in red office)\", \"(in blue office)\"]",
            ),
            "no error",
        ),
        (
            Put(
                "/observers/cooperative/initial_belief/0",
                "[\"(at HALL) (in red office)\", \"(in blue office) (door hall office)\"]",
            ),
            "no error",
        ),
        (
            Put(
                "/observers/cooperative/initial_belief/0",
                "[\"(at hall)\", \"(door office archive)\"]",
            ),
            "observers.cooperative.initial_belief[0][1]: found an atom of a predicate that no action changes, expected only those that are in the :init",
        ),
        (
            Put("/observers/cooperative/initial_belief/0", "\"(at hall)\""),
            "observers.cooperative.initial_belief[0]: found \"(at hall)\", expected a list of atoms, or an object with add and delete",
        ),
        (
            Put("/observers/cooperative/initial_belief/1/add/0", "\"(in blue)\""),
            "observers.cooperative.initial_belief[1].add[0], line 1, column 1: found \"(in …)\" with 1 argument, expected 2 arguments for in",
        ),
        (
            Put("/observers/cooperative/initial_belief/1/add/0", "\"(in blue office)\""),
            "observers.cooperative.initial_belief[1].add[0]: found an atom that holds in the initial state already, expected an atom that makes a difference",
        ),
        (
            Put("/observers/cooperative/initial_belief/1/delete/0", "\"(in blue hall)\""),
            "observers.cooperative.initial_belief[1].delete[0]: found an atom that does not hold in the initial state, expected an atom that makes a difference",
        ),
        (
            Put("/observers/cooperative/initial_belief/1/delete/0", "\"(door hall office)\""),
            "observers.cooperative.initial_belief[1].delete[0]: found an atom of a predicate that no action changes, expected an atom that makes a difference",
        ),
        (
            Put("/observers/cooperative/initial_belief/1/remove", "[]"),
            "observers.cooperative.initial_belief[1]: found the unknown key \"remove\", expected only add, delete",
        ),
        (
            Put("/observers/adversarial/initial_belief/reachable", "\"(at office)\""),
            "observers.adversarial.initial_belief.reachable: found a condition that the initial state does not satisfy, expected a condition that it does, since the actor is there",
        ),
        (
            Put("/observers/adversarial/initial_belief/reachable", "\"(not (at hall))\""),
            "observers.adversarial.initial_belief.reachable: found a condition that the initial state does not satisfy, expected a condition that it does, since the actor is there",
        ),
        (
            Put("/observers/adversarial/initial_belief/reachable", "\"(at hell)\""),
            "observers.adversarial.initial_belief.reachable, line 1, column 5: found the undeclared object \"hell\", expected an object or a constant: hall, office, archive, red, blue",
        ),
    ];
    check(example(), &table);
}

fn traced(problem: &Problem, plan: &[&str]) -> Trace {
    trace(problem, &Plan::from_names(problem.task(), plan).unwrap()).unwrap()
}

fn labels(problem: &Problem, states: &[mo_copp::task::State]) -> BTreeSet<String> {
    states.iter().map(|state| problem.label(state.words()).to_string()).collect()
}

/// The plan takes the red letter to the archive.
#[test]
fn sensors_and_beliefs_are_those_worked_out_by_hand() {
    let problem = problem(example());
    let plan =
        ["(walk hall office)", "(take red office)", "(walk office hall)", "(walk hall archive)"];
    let plan = [plan.as_slice(), &["(leave red archive)"]].concat();
    let trace = traced(&problem, &plan);
    let symbols = |observer: usize| {
        trace.steps[1..].iter().map(|s| s.symbols[observer].clone().unwrap()).collect::<Vec<_>>()
    };
    let enemy = ["steps", "takes an envelope", "in the hall", "steps", "leave envelope"];
    assert_eq!(symbols(0), enemy);
    assert_eq!(symbols(1), ["walk hall", "take red", "walk office", "walk hall", "leave red"]);
    // At first each letter is in any of three rooms; after steps the actor is in one of two rooms.
    let sizes: Vec<usize> = trace.steps.iter().map(|step| step.beliefs[0].len()).collect();
    // Either letter was taken in either room, and the other one is in any of three. In the hall it no
    // longer matters where that was. In the end there are five ways for each room: one letter is
    // there and the other in any of three, which counts both in the room twice.
    assert_eq!(sizes, [3 * 3, 2 * 9, 2 * 2 * 3, 2 * 3, 2 * 2 * 3, 2 * (3 + 3 - 1)]);
    let friend: Vec<usize> = trace.steps.iter().map(|step| step.beliefs[1].len()).collect();
    // The blue letter is in the office or in the hall; red is taken in the office.
    assert_eq!(friend, [2, 4, 2, 2, 4, 4]);
    let last = trace.steps.last().unwrap();
    let expected = [
        "{(at office), (in red office), (in blue hall)}",
        "{(at office), (in red office), (in blue office)}",
        "{(at archive), (in red archive), (in blue hall)}",
        "{(at archive), (in red archive), (in blue office)}",
    ];
    let found = labels(&problem, &last.beliefs[1]);
    assert_eq!(found, expected.into_iter().map(str::to_owned).collect());
    let survivors: Vec<Vec<usize>> = last.survivors.iter().map(|s| s.iter().collect()).collect();
    assert_eq!(survivors, [vec![0, 1, 2], vec![0]]);
    assert_eq!(trace.goal_difference(&problem), 1.0);
}

/// What the friend of the example is told in a plan, by rules over groups.
fn friends_symbols(rules: &str, groups: &'static str, plan: &[&str]) -> Vec<String> {
    let text = changed(example(), &Put("/observers/cooperative/groups", groups));
    let mut document: serde_json::Value = serde_json::from_str(&text).unwrap();
    document["observers"]["cooperative"]["sensor"] = serde_json::from_str(rules).unwrap();
    let trace = traced(&problem(&document.to_string()), plan);
    trace.steps[1..].iter().map(|step| step.symbols[1].clone().unwrap()).collect()
}

#[test]
fn a_pattern_with_objects_variables_and_groups() {
    let rules = r#"[
        {"operator": "(walk hall ?to)", "symbol": "from the hall to {?to}"},
        {"operator": "(walk ?x - public hall)", "symbol": "back"},
        {"operator": "(take ?l - (either letter room) ?room)", "result": "(and (at ?room) (not (has red)))",
         "symbol": "{name} {2}, red is here"},
        {"operator": "(LEAVE blue ?ROOM - room)", "symbol": "{{{?room}}}"},
        {"operator": "*", "symbol": "{arguments}"}]"#;
    let groups = r#"{"public": ["office"], "paper": ["blue"]}"#;
    let plan = [
        "(walk hall office)",
        "(take blue office)",
        "(take red office)",
        "(walk office hall)",
        "(leave blue hall)",
        "(walk hall archive)",
        "(walk archive hall)",
        "(leave red hall)",
    ];
    let expected = [
        "from the hall to public",
        "take public, red is here",
        "red public",
        "back",
        "{hall}",
        "from the hall to archive",
        "archive hall",
        "red hall",
    ];
    assert_eq!(friends_symbols(rules, groups, &plan), expected);
}

#[test]
fn a_pattern_with_either_of_groups_and_types() {
    let rules = r#"[
        {"operator": "(take ?l - (either paper crate) ?room)", "symbol": "a thing"},
        {"operator": "(leave ?l - (either PAPER room) ?room)", "symbol": "blue"},
        {"operator": "(walk ?x ?to - (either paper room))", "symbol": "steps"},
        {"operator": "*", "symbol": "{name}"}]"#;
    let groups = r#"{"crate": ["red"], "paper": ["blue"]}"#;
    let plan = [
        "(walk hall office)",
        "(take blue office)",
        "(take red office)",
        "(leave blue office)",
        "(leave red office)",
    ];
    let expected = ["steps", "a thing", "a thing", "blue", "leave"];
    assert_eq!(friends_symbols(rules, groups, &plan), expected);
}

/// A rule without a result is not asked for where the results leave nothing out.
#[test]
fn results_that_cover_every_state() {
    let with = |rules: &str| {
        let mut document: serde_json::Value = serde_json::from_str(example()).unwrap();
        document["observers"]["cooperative"]["sensor"] =
            serde_json::from_str(&format!("[{rules}]")).unwrap();
        document.to_string()
    };
    let other = r#"{"operator": "take", "symbol": "t"}, {"operator": "leave", "symbol": "l"}"#;
    let rule = |result: &str, symbol: &str| {
        format!(r#"{{"operator": "(walk ?a ?b)", "result": "{result}", "symbol": "{symbol}"}}"#)
    };
    let rules = |all: &[(&str, &str)]| {
        let mut rules: Vec<String> =
            all.iter().map(|(result, symbol)| rule(result, symbol)).collect();
        rules.push(other.to_owned());
        with(&rules.join(", "))
    };
    let seen = |text: &str| {
        let problem = problem(text);
        let plan = ["(walk hall office)", "(take red office)", "(walk office hall)"];
        let trace = traced(&problem, &plan);
        trace.steps[1..].iter().map(|step| step.symbols[1].clone().unwrap()).collect::<Vec<_>>()
    };
    // A literal and its negation.
    let text = rules(&[("(has red)", "red"), ("(not (has red))", "nothing")]);
    assert_eq!(seen(&text), ["nothing", "t", "red"]);
    // What the walk itself makes true.
    let text =
        rules(&[("(at hall)", "hall"), ("(at office)", "office"), ("(at archive)", "archive")]);
    assert_eq!(seen(&text), ["office", "t", "hall"]);
    assert_eq!(seen(&rules(&[("(not (at ?a))", "gone")])), ["gone", "t", "gone"]);
    // All four ways of two literals, in any order.
    let four = [
        ("(and (has red) (has blue))", "both"),
        ("(and (not (has red)) (has blue))", "blue"),
        ("(and (has red) (not (has blue)))", "red"),
        ("(not (has red))", "none"),
    ];
    assert_eq!(seen(&rules(&four)), ["none", "t", "red"]);
    let refused = |all: &[(&str, &str)]| {
        assert_eq!(
            message(&rules(all)),
            "observers.cooperative.sensor: found no symbol for (walk hall office) in every resulting state, expected rules whose results leave none out, or a last one without a result"
        );
    };
    refused(&[four[0], four[1], four[3]]);
    refused(&[("(at hall)", "hall"), ("(at archive)", "archive")]);
    refused(&[("(and (has red) (= ?a ?b))", "never"), ("(not (has red))", "none")]);
    refused(&[("(at ?a)", "still there")]);
}

#[test]
fn every_solver_solves_the_example() {
    let problem = problem(example());
    for solver in Solver::ALL {
        let outcome = solve(&problem, &Options::new(solver));
        let status = match solver {
            Solver::Exact | Solver::Ip => Status::Optimal,
            _ => Status::Solved,
        };
        assert_eq!(outcome.status, status, "{}", solver.name());
    }
    let best = solve(&problem, &Options::new(Solver::Exact));
    assert_eq!((best.goal_difference, best.horizon), (Some(1.0), Some(5)));
}

#[test]
fn the_examples_of_the_three_domains_are_solved() {
    for text in [
        include_str!("../../examples/blocksworld.json"),
        include_str!("../../examples/logistics.json"),
        include_str!("../../examples/driverlog.json"),
    ] {
        let problem = problem(text);
        assert_eq!(problem.goals().len(), 5);
        for solver in [Solver::Search, Solver::Satisficing] {
            let mut options = Options::new(solver);
            options.bounds.at_least = Some(3);
            options.bounds.at_most = Some(3);
            let outcome = solve(&problem, &options);
            assert_eq!(outcome.status, Status::Solved);
            assert!(outcome.goal_difference >= Some(0.0));
        }
    }
}

#[test]
fn every_document_of_the_documentation_is_solved() {
    let page = include_str!("../../docs/documents.md");
    let examples = page.split("```json\n").skip(1);
    let mut solved = 0;
    for text in examples.map(|rest| rest.split("```").next().unwrap()) {
        let outcome = solve(&problem(text), &Options::new(Solver::Exact));
        assert_eq!(outcome.status, Status::Optimal);
        solved += 1;
    }
    assert!(solved >= 5, "{solved}");
}

/// A goal that can never hold never survives; negations hold where the atom does not.
#[test]
fn goals_that_never_hold_and_goals_with_negations() {
    let text =
        changed(example(), &Put("/goals/2/condition", "\"(and (at hall) (door office archive))\""));
    let text = changed(
        &text,
        &Put("/goals/1/condition", "\"(and (not (in red office)) (not (has red)))\""),
    );
    let problem = problem(&text);
    let plan =
        ["(walk hall office)", "(take red office)", "(walk office hall)", "(leave red hall)"];
    let trace = traced(&problem, &plan);
    let alive = |step: usize| trace.steps[step].survivors[1].iter().collect::<Vec<_>>();
    // The friend knows where the red letter is.
    assert!([0, 1, 2, 3].into_iter().all(|step| alive(step).is_empty()));
    assert_eq!(alive(4), [1]);
    // What only says that something does not hold is not shown.
    let start = problem.label(problem.task().initial_state().words()).to_string();
    assert_eq!(start, "{(at hall), (in red office), (in blue office)}");
    let text = changed(&text, &Put("/true_goal", "\"both\""));
    let problem = Arc::new(Document::parse(&text).unwrap().problem().unwrap());
    assert_eq!(solve(&problem, &Options::new(Solver::Exact)).status, Status::Infeasible);
}

#[test]
fn more_than_the_loader_takes() {
    let rule = r#"{"operator": "(walk hall office)", "symbol": "x"}"#;
    let rules = format!("[{}]", vec![rule; 1001].join(","));
    let mut document: serde_json::Value = serde_json::from_str(example()).unwrap();
    document["observers"]["adversarial"]["sensor"] = serde_json::from_str(&rules).unwrap();
    assert_eq!(
        message(&document.to_string()),
        "observers.adversarial.sensor: found 1001 rules, expected at most 1000"
    );
    // More groups of facts than a diagram has levels, and more states than are gone through one by one.
    let found = message(&lamps(1100));
    assert_eq!(
        found,
        "observers.adversarial.initial_belief.reachable: found a condition over too many states \
         (memory limit reached: 512 MiB of states, beliefs and nodes), expected a task with fewer reachable states, or a list of states"
    );
}

/// Lamps that can be lit, each by an action; the enemy knows of one that is out.
fn lamps(count: usize) -> String {
    let lamps: Vec<String> = (0..count).map(|lamp| format!("l{lamp}")).collect();
    let text = serde_json::json!({
        "format": "pddl",
        "domain": "(define (domain lamps) (:predicates (lit ?x) (out ?x))
            (:action light :parameters (?x) :precondition (out ?x) :effect (and (lit ?x) (not (out ?x)))))",
        "problem": format!("(define (problem many) (:domain lamps) (:objects {0}) (:init (out {1})))",
            lamps.join(" "), lamps.join(") (out ")),
        "goals": [{"name": "a", "condition": "(lit l0)"}, {"name": "b", "condition": "(lit l1)"}],
        "true_goal": "a",
        "observers": {
            "adversarial": {"initial_belief": {"reachable": "(out l2)"}, "sensor": "{name}"},
            "cooperative": {"sensor": "{arguments}"}},
    });
    text.to_string()
}

/// 2⁵⁹ states are believed at first, and none of them is listed.
#[test]
fn more_reachable_states_than_any_list_holds() {
    let problem = Arc::new(Document::parse(&lamps(60)).unwrap().problem().unwrap());
    let believed = &problem.observers()[0].initial_belief;
    assert_eq!(believed.listed(), None);
    assert_eq!(believed.count(), StateCount::Exact(1 << 59));
    assert!(believed.contains(problem.task().initial_state()));
    let plan = Plan::from_names(problem.task(), &["(light l0)"]).unwrap();
    let mut told = Vec::new();
    pass(&problem, &plan, |step| {
        told.push((step.beliefs[0].count(), step.survivors[0].len()));
        Ok(())
    })
    .unwrap();
    // A lamp is lit, perhaps l2.
    assert_eq!(told[1], (StateCount::Exact((1 << 60) - 1), 2));
    for solver in [Solver::Exact, Solver::Search, Solver::Satisficing] {
        let outcome = solve(&problem, &Options::new(solver));
        assert_eq!(outcome.goal_difference, Some(1.0), "{}", solver.name());
    }
    let mut options = Options::new(Solver::Ip);
    options.horizon = Horizon::Steps(1);
    let outcome = solve(&problem, &options);
    assert!(matches!(outcome.limit, Some(LimitReached::Memory { .. })), "{outcome:?}");
}
