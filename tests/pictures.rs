//! Pictures: what stands in them, for every document there is and for hostile ones.

use std::sync::Arc;

use mo_copp::domain::{Delivery, Document};
use mo_copp::picture::{Boards, PictureError, PictureOptions, Steps, Theme, draw};
use mo_copp::plan::Plan;
use mo_copp::problem::Problem;
use mo_copp::solver::{Options, Solver};
use roxmltree::{Document as Xml, Node};

use crate::common::check::solve;

fn load(text: &str) -> (Document, Arc<Problem>) {
    let document = Document::parse(text).unwrap();
    let problem = Arc::new(document.problem().unwrap());
    (document, problem)
}

/// The documents of the examples and of the page's gallery.
fn documents() -> Vec<(String, String)> {
    let root = env!("CARGO_MANIFEST_DIR");
    let mut found = Vec::new();
    for folder in ["examples", "www/problems"] {
        for entry in std::fs::read_dir(format!("{root}/{folder}")).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|extension| extension == "json") {
                found.push((path.display().to_string(), std::fs::read_to_string(&path).unwrap()));
            }
        }
    }
    found.sort();
    assert!(found.len() > 20);
    found
}

fn baseline(problem: &Arc<Problem>) -> Plan {
    solve(problem, &Options::new(Solver::Baseline)).plan.unwrap_or_default()
}

/// Nothing in it runs, or refers to anything outside; all numbers are numbers.
fn assert_harmless(svg: &str, name: &str) {
    let xml = Xml::parse(svg).unwrap_or_else(|error| panic!("{name}: {error}"));
    let known =
        ["svg", "title", "desc", "g", "rect", "circle", "path", "polyline", "text", "animate"];
    for node in xml.descendants().filter(Node::is_element) {
        assert!(known.contains(&node.tag_name().name()), "{name}: {:?}", node.tag_name());
        for attribute in node.attributes() {
            let (key, value) = (attribute.name(), attribute.value());
            assert!(!key.starts_with("on") && !key.contains("href"), "{name}: {key}");
            assert!(!value.contains("url(") && !value.contains("NaN"), "{name}: {key}={value}");
            assert!(!value.contains("inf"), "{name}: {key}={value}");
        }
    }
}

fn texts(svg: &str) -> Vec<String> {
    let xml = Xml::parse(svg).unwrap();
    let is_text = |node: &Node<'_, '_>| node.has_tag_name(("http://www.w3.org/2000/svg", "text"));
    xml.descendants().filter(is_text).filter_map(|node| node.text().map(str::to_owned)).collect()
}

#[test]
fn every_step_of_every_document_is_drawn() {
    for (name, text) in documents() {
        let (document, problem) = load(&text);
        let plan = baseline(&problem);
        for step in 0..=plan.len() {
            let svg = draw(&document, &problem, &plan, &PictureOptions::step(step)).unwrap();
            assert_harmless(&svg, &name);
            let texts = texts(&svg).join("\n");
            let heading = match step {
                0 => format!("Start, {} step", plan.len()),
                _ => format!("Step {step} of {}", plan.len()),
            };
            assert!(texts.contains(&heading), "{name}: {texts}");
            for title in ["The agent", "What the enemy believes", "What the friend believes"] {
                assert!(texts.contains(title), "{name}: {title}");
            }
            assert_eq!(texts.contains("Goal difference"), step == plan.len(), "{name} {step}");
        }
    }
}

#[test]
fn an_animation_holds_every_step_once_and_rests_on_the_last() {
    let (document, problem) = load(include_str!("../www/problems/eight-by-eight.json"));
    let plan = baseline(&problem);
    let svg = draw(&document, &problem, &plan, &PictureOptions::animated(500)).unwrap();
    assert_harmless(&svg, "eight by eight");
    let xml = Xml::parse(&svg).unwrap();
    let frames: Vec<_> =
        xml.root_element().children().filter(|node| node.has_attribute("display")).collect();
    assert_eq!(frames.len(), plan.len() + 1);
    for (step, frame) in frames.iter().enumerate() {
        let resting = if step == plan.len() { "inline" } else { "none" };
        assert_eq!(frame.attribute("display"), Some(resting));
        let clock = frame.first_element_child().unwrap();
        let seconds = 0.5 * (plan.len() + 1) as f64;
        assert_eq!(clock.attribute("dur"), Some(&*format!("{seconds}s")));
        let times: Vec<f64> =
            clock.attribute("keyTimes").unwrap().split(';').map(|t| t.parse().unwrap()).collect();
        assert!(times.is_sorted() && times[0] == 0.0);
        let values: Vec<&str> = clock.attribute("values").unwrap().split(';').collect();
        assert_eq!(values.len(), times.len());
        assert_eq!(values.iter().filter(|&&value| value == "inline").count(), 1);
    }
}

#[test]
fn the_picture_says_what_the_trace_says() {
    let document = Document::from(Delivery::figure_1());
    let problem = document.problem().unwrap();
    let plan = ["load a1", "load a2", "deliver"];
    let plan = Plan::from_names(problem.task(), &plan).unwrap();
    let svg = draw(&document, &problem, &plan, &PictureOptions::step(3)).unwrap();
    let xml = Xml::parse(&svg).unwrap();
    let description = xml.descendants().find(|node| node.tag_name().name() == "desc").unwrap();
    let said = description.text().unwrap();
    assert!(said.contains("6 of 6 for the enemy, 1 of 6 for the friend"), "{said}");
    assert!(said.contains("Goal difference 1."), "{said}");
    assert!(said.contains("with the goals a1+a2."), "{said}");
}

#[test]
fn a_board_alone_is_smaller_and_a_dark_one_has_other_colours() {
    let (document, problem) = load(include_str!("../www/problems/camera-zone.json"));
    let plan = baseline(&problem);
    let all = PictureOptions::step(1);
    let mut one = all.clone();
    one.boards = Boards::Observer(0);
    one.captions = false;
    let (all, alone) = (
        draw(&document, &problem, &plan, &all).unwrap(),
        draw(&document, &problem, &plan, &one).unwrap(),
    );
    let width = |svg: &str| -> f64 {
        Xml::parse(svg).unwrap().root_element().attribute("width").unwrap().parse().unwrap()
    };
    assert!(width(&alone) < width(&all) / 2.0);
    assert!(!texts(&alone).iter().any(|text| text.contains("Step")));
    one.theme = Theme::Dark;
    let dark = draw(&document, &problem, &plan, &one).unwrap();
    assert!(dark.contains("#14171c") && !alone.contains("#14171c"));
}

#[test]
fn a_plan_that_may_go_on_rules_nothing_out_and_claims_no_difference() {
    let text = include_str!("../examples/gridworld.json");
    let (document, problem) = load(text);
    let plan = baseline(&problem);
    let mut options = PictureOptions::step(plan.len());
    let ended = draw(&document, &problem, &plan, &options).unwrap();
    options.ended = false;
    let open = draw(&document, &problem, &plan, &options).unwrap();
    assert!(ended.contains("line-through") && ended.contains("Goal difference"));
    assert!(!open.contains("line-through") && !open.contains("Goal difference"), "{open}");
}

#[test]
fn names_are_text_and_never_markup() {
    let name = "</text><script>alert(1)</script>";
    let text = include_str!("../www/problems/eight-by-eight.json");
    let mut value: serde_json::Value = serde_json::from_str(text).unwrap();
    value["goals"][0]["name"] = name.into();
    value["true_goal"] = name.into();
    value["observers"]["adversarial"]["sensor"]["north"] = "<image href='x' onerror='y'>".into();
    let (document, problem) = load(&value.to_string());
    let plan = Plan::from_names(problem.task(), &["north"]).unwrap();
    let svg = draw(&document, &problem, &plan, &PictureOptions::step(1)).unwrap();
    assert_harmless(&svg, "hostile");
    assert!(texts(&svg).iter().any(|text| text.contains("<image")));
}

#[test]
fn what_is_not_there_is_said() {
    let (document, problem) = load(include_str!("../www/problems/eight-by-eight.json"));
    let plan = Plan::from_names(problem.task(), &["north"]).unwrap();
    let error = draw(&document, &problem, &plan, &PictureOptions::step(2)).unwrap_err();
    assert_eq!(error, PictureError::Step { found: 2, last: 1 });
    let mut options = PictureOptions::step(0);
    options.boards = Boards::Observer(2);
    let error = draw(&document, &problem, &plan, &options).unwrap_err();
    assert_eq!(error, PictureError::Observer { found: 2, last: 1 });
    let mut options = PictureOptions::animated(99);
    let error = draw(&document, &problem, &plan, &options).unwrap_err();
    assert_eq!(error, PictureError::Milliseconds { found: 99 });
    options.steps = Steps::One(1);
    let south = Plan::from_names(problem.task(), &["south"]).unwrap();
    let error = draw(&document, &problem, &south, &options).unwrap_err();
    assert!(matches!(error, PictureError::Plan(_)), "{error}");
}

/// The same text in wasm: `wasm-tests/` draws it again.
#[test]
fn the_golden_picture_is_drawn_again() {
    let (document, problem) = load(include_str!("../www/problems/eight-by-eight.json"));
    let plan = Plan::from_names(problem.task(), &["north", "north", "east"]).unwrap();
    let svg = draw(&document, &problem, &plan, &PictureOptions::step(2)).unwrap();
    let golden = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/picture.svg");
    assert_eq!(svg, std::fs::read_to_string(golden).unwrap(), "{golden}");
}

#[test]
fn where_the_box_began_is_marked_once_it_is_elsewhere() {
    let text = include_str!("../examples/box-pushing.json");
    let (document, problem) = load(text);
    let plan = ["move-forward", "move-forward", "turn-left"];
    let plan = Plan::from_names(problem.task(), &plan).unwrap();
    let outlines = |step: usize| {
        let mut options = PictureOptions::step(step);
        options.boards = Boards::Actor;
        let svg = draw(&document, &problem, &plan, &options).unwrap();
        let xml = Xml::parse(&svg).unwrap();
        let is_outline = |node: &Node<'_, '_>| {
            let has = |key: &str, value: &str| node.attribute(key) == Some(value);
            node.has_tag_name(("http://www.w3.org/2000/svg", "rect"))
                && has("fill", "none")
                && has("rx", "2")
        };
        xml.descendants().filter(is_outline).count()
    };
    // The first step leads to the box, the second pushes it.
    assert_eq!([0, 1, 2, 3].map(outlines), [0, 0, 1, 1]);
}
