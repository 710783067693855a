//! Bad deliveries.

use super::Change::{Drop, Put};
use super::{check, message};

/// Figure 1 of the paper.
pub const DELIVERY: &str = r#"{"format": "delivery",
  "factories": [{"name": "A", "packages": ["a1", "a2"]}, {"name": "B", "packages": ["b1", "b2"]}],
  "deliver": 2, "true_goal": "a1+a2",
  "observers": {
    "adversarial": {"sensor": {"load": "package", "deliver": "delivery"}},
    "cooperative": {"sensor": {"load": {"A": "barcode A", "B": "barcode B"},
      "deliver": "delivery"}}}}"#;

#[test]
fn every_message() {
    let table = [
        (
            Put("/start", "[0, 0]"),
            "document: found the unknown key \"start\", expected only format, factories, deliver, true_goal, observers",
        ),
        (Drop("/factories"), "factories: found nothing, expected a list of factories"),
        (Put("/factories", "{}"), "factories: found {}, expected a list"),
        (Put("/factories/0", "\"A\""), "factories[0]: found \"A\", expected an object"),
        (
            Drop("/factories/0/name"),
            "factories[0].name: found nothing, expected the factory's name",
        ),
        (
            Put("/factories/1/name", "\"A\""),
            "factories[1].name: found the name \"A\" for the second time, expected a name of its own",
        ),
        (
            Drop("/factories/0/packages"),
            "factories[0].packages: found nothing, expected a list of package names",
        ),
        (
            Put("/factories/0/stock", "2"),
            "factories[0]: found the unknown key \"stock\", expected only name, packages",
        ),
        (
            Put("/factories/1/packages/1", "\"a1\""),
            "factories[1].packages[1]: found the name \"a1\" for the second time, expected a name of its own",
        ),
        (
            Put("/factories/1/packages/1", "\"A\""),
            "factories[1].packages[1]: found the name \"A\" for the second time, expected a name of its own",
        ),
        (
            Put("/factories/1/packages/1", "\"b+2\""),
            "factories[1].packages[1]: found \"b+2\", expected a name without +",
        ),
        (
            Put("/factories/1/packages/1", "2"),
            "factories[1].packages[1]: found 2, expected a text that is not empty",
        ),
        (Drop("/deliver"), "deliver: found nothing, expected how many packages to deliver"),
        (Put("/deliver", "0"), "deliver: found 0, expected a whole number from 1 to 64"),
        (Put("/deliver", "-1"), "deliver: found -1, expected a whole number from 1 to 64"),
        (Put("/deliver", "1.5"), "deliver: found 1.5, expected a whole number from 1 to 64"),
        (Put("/deliver", "5"), "deliver: found 5, expected a whole number from 1 to 4"),
        (
            Put("/deliver", "4"),
            "deliver: found 4 of 4 packages, expected between 2 and 1024 possible sets, which are the goals",
        ),
        (
            Put("/true_goal", "\"a1\""),
            "true_goal: found \"a1\", expected the name of a candidate goal: a1+a2, a1+b1, a1+b2, a2+b1, a2+b2, b1+b2",
        ),
        (
            Put("/true_goal", "\"a1+a1\""),
            "true_goal: found \"a1+a1\", expected the name of a candidate goal: a1+a2, a1+b1, a1+b2, a2+b1, a2+b2, b1+b2",
        ),
        (
            Drop("/true_goal"),
            "true_goal: found nothing, expected packages joined by +, as in a1+a2",
        ),
        (
            Put("/observers/adversarial/initial_belief", "[]"),
            "observers.adversarial: found the unknown key \"initial_belief\", expected only sensor",
        ),
        (
            Drop("/observers/adversarial/sensor"),
            "observers.adversarial.sensor: found nothing, expected an object with load and deliver",
        ),
        (
            Drop("/observers/adversarial/sensor/deliver"),
            "observers.adversarial.sensor.deliver: found nothing, expected the symbol the observer sees",
        ),
        (
            Drop("/observers/adversarial/sensor/load"),
            "observers.adversarial.sensor.load: found nothing, expected a symbol, or an object with a symbol for each factory",
        ),
        (
            Put("/observers/adversarial/sensor/load", "1"),
            "observers.adversarial.sensor.load: found 1, expected a symbol, or an object with a symbol for each factory",
        ),
        (
            Put("/observers/adversarial/sensor/drive", "\"truck\""),
            "observers.adversarial.sensor: found the unknown key \"drive\", expected only load, deliver",
        ),
        (
            Drop("/observers/cooperative/sensor/load/B"),
            "observers.cooperative.sensor.load: found no symbol for b1 (factories[1].packages[0]), expected a symbol for b1 or for B",
        ),
        (
            Put("/observers/cooperative/sensor/load/B", "2"),
            "observers.cooperative.sensor.load.B: found 2, expected a text that is not empty",
        ),
        (
            Put("/observers/cooperative/sensor/load/C", "\"barcode C\""),
            "observers.cooperative.sensor.load: found \"C\", expected a factory or a package: A, B, a1, a2, b1, b2",
        ),
    ];
    check(DELIVERY, &table);
}

/// One factory with packages p1, p2, ….
fn of(packages: usize, deliver: usize) -> String {
    let names: Vec<String> = (1..=packages).map(|number| format!("\"p{number}\"")).collect();
    let goal: Vec<String> = (1..=deliver).map(|number| format!("p{number}")).collect();
    let sensor = "{\"sensor\": {\"load\": \"l\", \"deliver\": \"d\"}}";
    format!(
        "{{\"format\": \"delivery\", \"factories\": [{{\"name\": \"A\", \"packages\": [{}]}}],
        \"deliver\": {deliver}, \"true_goal\": \"{}\",
        \"observers\": {{\"adversarial\": {sensor}, \"cooperative\": {sensor}}}}}",
        names.join(","),
        goal.join("+")
    )
}

/// C(packages, deliver) sets are the goals: 2 to 1024 of them, of at most 64 packages.
#[test]
fn the_number_of_sets() {
    for (packages, deliver, sets) in [
        (2, 1, 2),
        (46, 2, 1035),
        (45, 2, 990),
        (64, 1, 64),
        (64, 63, 64),
        (20, 19, 20),
        (13, 10, 286),
    ] {
        let found = message(&of(packages, deliver));
        if sets <= 1024 {
            assert_eq!(found, "no error", "{deliver} of {packages}");
        } else {
            let expected = "expected between 2 and 1024 possible sets, which are the goals";
            assert_eq!(
                found,
                format!("deliver: found {deliver} of {packages} packages, {expected}")
            );
        }
    }
    assert_eq!(message(&of(65, 1)), "factories: found 65 packages, expected at most 64");
}
