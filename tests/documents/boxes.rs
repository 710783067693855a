//! Bad box pushing, and what the example of the documentation means.

use std::sync::Arc;

use mo_copp::domain::Document;
use mo_copp::plan::Plan;
use mo_copp::trace::trace;

use super::Change::{Drop, Put};
use super::{check, documented};

#[test]
fn every_mistake_has_its_place() {
    let table = [
        (
            Put("/charger", "[0, 0]"),
            "document: found the unknown key \"charger\", expected only format, width, height, walls, start, goals, true_goal, observers",
        ),
        (Put("/width", "33"), "width: found 33, expected a whole number from 1 to 32"),
        (Drop("/start"), "start: found nothing, expected an object with robot, facing and box"),
        (Drop("/start/box"), "start.box: found nothing, expected a cell"),
        (Drop("/start/facing"), "start.facing: found nothing, expected north, south, east or west"),
        (
            Put("/start/facing", "\"up\""),
            "start.facing: found \"up\", expected north, south, east or west",
        ),
        (
            Put("/start/box", "[3, 0]"),
            "start.box: found [3, 0], expected a cell inside the 3 × 3 grid",
        ),
        (
            Put("/start/box", "[1, 2]"),
            "start.box: found [1, 2], where the robot is, expected a cell of its own",
        ),
        (
            Put("/walls", "[[1, 1]]"),
            "start.box: found [1, 1], which is a wall, expected a free cell",
        ),
        (
            Put("/observers/adversarial/initial_belief", "[]"),
            "observers.adversarial.initial_belief: found 0 states without the start, expected the start {robot [1, 2], facing north, box [1, 1]} among them",
        ),
        (
            Put("/observers/adversarial/initial_belief/1/robot", "[1, 1]"),
            "observers.adversarial.initial_belief[1].box: found [1, 1], where the robot is, expected a cell of its own",
        ),
        (
            Put("/true_goal", "\"G9\""),
            "true_goal: found \"G9\", expected the name of a candidate goal: G1, G2",
        ),
    ];
    check(documented("box-pushing"), &table);
}

#[test]
fn what_is_pushed_and_what_is_in_the_way() {
    let document = Document::parse(documented("box-pushing")).unwrap();
    let problem = Arc::new(document.problem().unwrap());
    let names = ["move-forward", "move-forward", "turn-left", "stay", "turn-right"];
    let plan = Plan::from_names(problem.task(), &names).unwrap();
    let traced = trace(&problem, &plan).unwrap();
    let states: Vec<String> =
        traced.steps.iter().map(|s| format!("{:#}", problem.label(s.state.words()))).collect();
    assert_eq!(
        states,
        [
            "{robot [1, 2], facing north, box [1, 1]}",
            "{robot [1, 1], facing north, box [1, 0]}",
            "{robot [1, 1], facing north, box [1, 0]}",
            "{robot [1, 1], facing west, box [1, 0]}",
            "{robot [1, 1], facing west, box [1, 0]}",
            "{robot [1, 1], facing north, box [1, 0]}",
        ]
    );
    let seen = |observer: usize| {
        traced.steps[1..].iter().map(|s| s.symbols[observer].clone().unwrap()).collect::<Vec<_>>()
    };
    assert_eq!(seen(0), ["move", "move", "turn", "move", "turn"]);
    assert_eq!(seen(1), ["move-right", "move-right", "leftwards", "leftwards", "move-right"]);
    assert!(traced.reaches_goal);
}
