//! Bad recycling robots, and what the example of the documentation means.

use std::sync::Arc;

use mo_copp::domain::Document;
use mo_copp::plan::Plan;
use mo_copp::trace::trace;

use super::Change::{Drop, Put};
use super::{check, documented};

#[test]
fn every_mistake_has_its_place() {
    let table = [
        (Drop("/charger"), "charger: found nothing, expected a cell"),
        (Put("/charger", "[3, 0]"), "charger: found [3, 0], expected a cell inside the 3 × 2 grid"),
        (Put("/walls", "[[0, 1]]"), "charger: found [0, 1], which is a wall, expected a free cell"),
        (
            Put("/battery_levels", "0"),
            "battery_levels: found 0, expected a whole number from 1 to 32",
        ),
        (Drop("/start"), "start: found nothing, expected an object with robot, battery and can"),
        (
            Put("/start/battery", "4"),
            "start.battery: found 4, expected at most 3, with 4 levels from 0",
        ),
        (
            Put("/start/can", "\"gone\""),
            "start.can: found \"gone\", expected a cell [column, row], or held",
        ),
        (
            Put("/start/can", "[9, 9]"),
            "start.can: found [9, 9], expected a cell inside the 3 × 2 grid",
        ),
        (
            Put("/observers/cooperative/initial_belief", "[]"),
            "observers.cooperative.initial_belief: found 0 states without the start, expected the start {robot [0, 0], battery 3, can [0, 0]} among them",
        ),
        (
            Put("/observers/adversarial/initial_belief/1/battery", "7"),
            "observers.adversarial.initial_belief[1].battery: found 7, expected at most 3, with 4 levels from 0",
        ),
    ];
    check(documented("recycling-robot"), &table);
}

#[test]
fn what_takes_charge_and_what_does_not() {
    let document = Document::parse(documented("recycling-robot")).unwrap();
    let problem = Arc::new(document.problem().unwrap());
    let names =
        ["north", "pick-up", "east", "west", "south", "charge", "stay", "drop", "east", "east"];
    let plan = Plan::from_names(problem.task(), &names).unwrap();
    let traced = trace(&problem, &plan).unwrap();
    let states: Vec<String> =
        traced.steps.iter().map(|s| format!("{:#}", problem.label(s.state.words()))).collect();
    assert_eq!(
        states,
        [
            "{robot [0, 0], battery 3, can [0, 0]}",
            "{robot [0, 0], battery 3, can [0, 0]}",
            "{robot [0, 0], battery 3, can held}",
            "{robot [1, 0], battery 2, can held}",
            "{robot [0, 0], battery 1, can held}",
            "{robot [0, 1], battery 0, can held}",
            "{robot [0, 1], battery 3, can held}",
            "{robot [0, 1], battery 3, can held}",
            "{robot [0, 1], battery 3, can [0, 1]}",
            "{robot [1, 1], battery 2, can [0, 1]}",
            "{robot [2, 1], battery 1, can [0, 1]}",
        ]
    );
    let seen = |observer: usize| {
        traced.steps[1..].iter().map(|s| s.symbols[observer].clone().unwrap()).collect::<Vec<_>>()
    };
    assert_eq!(
        seen(0)[..8],
        [
            "vertical",
            "using-gripper",
            "horizontal",
            "horizontal",
            "vertical",
            "charging",
            "charging",
            "using-gripper",
        ]
    );
    assert_eq!(
        seen(1)[..8],
        [
            "north-east",
            "charging-picking",
            "north-east",
            "south-west",
            "south-west",
            "charging-picking",
            "staying-dropping",
            "staying-dropping",
        ]
    );
}
