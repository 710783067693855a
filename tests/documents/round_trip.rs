//! A document written and read again is the same, and drawing is deterministic.

use mo_copp::domain::delivery::DeliveryShape;
use mo_copp::domain::generate::Domain;
use mo_copp::domain::gridworld::GridworldShape;
use mo_copp::domain::pddl::generate::{BlocksworldShape, DriverlogShape, LogisticsShape};
use mo_copp::domain::{Delivery, Document};

use super::delivery::DELIVERY;
use super::explicit::EXPLICIT;
use super::gridworld::GRIDWORLD;
use super::{documented, pddl};
use crate::common::random::{self, MEDIUM, PAIR};
use crate::common::{Dice, box_pushing, delivery, gridworld, recycling_robot};

fn returns(document: &Document) {
    let text = document.to_json();
    assert_eq!(&Document::parse(&text).unwrap(), document);
    // And the text that it is written as stays.
    assert_eq!(Document::parse(&text).unwrap().to_json(), text);
}

#[test]
fn every_kind_of_document_returns() {
    let mut dice = Dice::new(60);
    for text in [
        GRIDWORLD,
        EXPLICIT,
        DELIVERY,
        pddl::example(),
        documented("box-pushing"),
        documented("recycling-robot"),
    ] {
        returns(&Document::parse(text).unwrap());
    }
    assert_eq!(Document::parse(DELIVERY).unwrap(), Document::Delivery(Delivery::figure_1()));
    for seed in 0..300 {
        returns(&Document::Gridworld(gridworld::random(&mut dice, 5)));
        returns(&Document::Delivery(delivery::random(&mut dice)));
        returns(&Document::BoxPushing(box_pushing::random(&mut dice)));
        returns(&Document::RecyclingRobot(recycling_robot::random(&mut dice)));
        let table = random::table(&mut dice, MEDIUM, &PAIR);
        returns(&Document::parse(&table.document()).unwrap());
        let shape = GridworldShape { walls: 5, ..GridworldShape::default() };
        returns(&Document::Gridworld(shape.generate(seed).unwrap().document));
        returns(&Document::Delivery(DeliveryShape::default().generate(seed).unwrap().document));
    }
}

#[test]
fn names_of_any_letters_return() {
    let odd = "\u{0}\"\\\n\u{301}\u{1F600} ü+";
    let text = EXPLICIT.replace("\"s0\"", &serde_json::to_string(odd).unwrap());
    let document = Document::parse(&text).unwrap();
    returns(&document);
    let problem = document.problem().unwrap();
    assert_eq!(problem.label(problem.task().initial_state().words()).to_string(), odd);
}

#[test]
fn the_same_seed_draws_the_same_document() {
    let mut different = 0;
    for seed in 0..200 {
        let shape = GridworldShape { width: 5, height: 4, goals: 3, walls: 6, belief: 4 };
        let drawn = shape.generate(seed).unwrap();
        assert_eq!(shape.generate(seed).unwrap(), drawn);
        different += usize::from(shape.generate(seed + 1).unwrap().document != drawn.document);
        let shape = DeliveryShape::default();
        assert_eq!(shape.generate(seed).unwrap(), shape.generate(seed).unwrap());
    }
    assert!(different > 190);
}

#[test]
fn shapes_that_make_no_sense() {
    let error = |shape: GridworldShape| shape.generate(1).unwrap_err().to_string();
    let shape = GridworldShape::default();
    let side = "expected a whole number from 1 to 256";
    assert_eq!(error(GridworldShape { width: 0, ..shape }), format!("width: found 0, {side}"));
    let huge = GridworldShape { height: 100_000, ..shape };
    assert_eq!(error(huge), format!("height: found 100000, {side}"));
    let found = error(GridworldShape { goals: 1, ..shape });
    assert_eq!(found, "goals: found 1, expected a whole number from 2 to 63");
    let found = error(GridworldShape { walls: 61, ..shape });
    assert_eq!(found, "walls: found 61, expected a whole number from 0 to 60");
    let found = error(GridworldShape { walls: 60, belief: 5, ..shape });
    assert_eq!(found, "belief: found 5, expected a whole number from 1 to 4");
    let error = |shape: DeliveryShape| shape.generate(1).unwrap_err().to_string();
    let shape = DeliveryShape::default();
    let found = error(DeliveryShape { factories: 27, ..shape });
    assert_eq!(found, "factories: found 27, expected a whole number from 1 to 26");
    let found = error(DeliveryShape { packages: 2, ..shape });
    assert_eq!(found, "packages: found 2, expected a whole number from 3 to 64");
    let found = error(DeliveryShape { deliver: 6, ..shape });
    assert_eq!(found, "deliver: found 6, expected a whole number from 1 to 5");
}

#[test]
fn shapes_of_domains_in_pddl_that_make_no_sense() {
    let blocks = BlocksworldShape::default();
    let error = |shape: BlocksworldShape| shape.generate(1).unwrap_err().to_string();
    let found = error(BlocksworldShape { blocks: 2, ..blocks });
    assert_eq!(found, "blocks: found 2, expected a whole number from 3 to 26");
    let found = error(BlocksworldShape { blocks: 3, goals: 6, ..blocks });
    assert_eq!(found, "goals: found 6, expected a whole number from 2 to 5");
    let found = error(BlocksworldShape { belief: 0, ..blocks });
    assert_eq!(found, "belief: found 0, expected a whole number from 1 to 10000");
    let cities = LogisticsShape::default();
    let error = |shape: LogisticsShape| shape.generate(1).unwrap_err().to_string();
    let found = error(LogisticsShape { facts: 7, ..cities });
    assert_eq!(found, "facts: found 7, expected a whole number from 1 to 6");
    let found = error(LogisticsShape { packages: 2, facts: 1, goals: 7, ..cities });
    assert_eq!(found, "goals: found 7, expected a whole number from 2 to 6");
    let drivers = DriverlogShape::default();
    let error = |shape: DriverlogShape| shape.generate(1).unwrap_err().to_string();
    let found = error(DriverlogShape { places: 1, ..drivers });
    assert_eq!(found, "places: found 1, expected a whole number from 2 to 64");
    let found = error(DriverlogShape { drivers: 0, ..drivers });
    assert_eq!(found, "drivers: found 0, expected a whole number from 1 to 64");
    // As many goals as there are at all can be drawn, and the largest sizes.
    let all = LogisticsShape { cities: 1, packages: 2, facts: 1, goals: 2, ..cities };
    assert!(all.generate(3).is_ok());
    assert!(BlocksworldShape { blocks: 3, goals: 5, ..blocks }.generate(3).is_ok());
    assert!(DriverlogShape { places: 2, goals: 6, ..drivers }.generate(3).is_ok());
    assert!(BlocksworldShape { blocks: 26, goals: 100, ..blocks }.generate(3).is_ok());
}

#[test]
fn every_domain_is_drawn_by_its_name() {
    for domain in Domain::ALL {
        assert_eq!(Domain::named(domain.name()), Some(domain));
        let mut different = 0;
        for seed in 0..20 {
            let drawn = domain.draw(seed).unwrap();
            assert_eq!(drawn, domain.draw(seed).unwrap());
            different += usize::from(drawn.document != domain.draw(seed + 1).unwrap().document);
            returns(&drawn.document);
            let json: serde_json::Value = serde_json::from_str(&drawn.document.to_json()).unwrap();
            let pddl = [Domain::Blocksworld, Domain::Logistics, Domain::Driverlog];
            let format = if pddl.contains(&domain) { "pddl" } else { domain.name() };
            assert_eq!(json["format"], format);
        }
        assert!(different > 15, "{} {different}", domain.name());
    }
    assert_eq!(Domain::named("chess"), None);
}

/// An even number of moves, so that the paper's horizons have plans; every second draw is thrown
/// away for that.
#[test]
fn gridworlds_have_plans_at_even_horizons() {
    let mut redraws = 0;
    for seed in 0..200 {
        let shape = GridworldShape { walls: 12, ..GridworldShape::default() };
        for shape in [GridworldShape::default(), shape] {
            let drawn = shape.generate(seed).unwrap();
            let ([column, row], goal) = (drawn.document.start, drawn.document.goals[0].cell);
            assert_eq!((column.abs_diff(goal[0]) + row.abs_diff(goal[1])) % 2, 0);
            redraws += drawn.redraws;
        }
    }
    assert!((250..800).contains(&redraws), "{redraws}");
}
