//! `mo-copp generate`

use crate::mo_copp;

#[test]
fn the_same_seed_gives_the_same_document_and_it_can_be_solved() {
    for domain in ["gridworld", "delivery"] {
        let first = mo_copp("", &["generate", domain, "--seed", "7"]);
        let again = mo_copp("", &["generate", domain, "--seed", "7"]);
        let other = mo_copp("", &["generate", domain, "--seed", "8"]);
        assert_eq!(first.code, 0, "{}", first.err);
        assert_eq!(first.out, again.out);
        assert_ne!(first.out, other.out);
        let solved = mo_copp(&first.out, &["solve", "-", "--json"]);
        assert_eq!(solved.json()["status"], "optimal");
    }
}

#[test]
fn domains_in_pddl_are_drawn_and_solved() {
    for domain in ["blocksworld", "logistics", "driverlog"] {
        let first = mo_copp("", &["generate", domain, "--seed", "13"]);
        assert_eq!(first.code, 0, "{}", first.err);
        assert_eq!(first.out, mo_copp("", &["generate", domain, "--seed", "13"]).out);
        let bounds = ["--k", "3", "--j", "3", "--json"];
        let solve = [&["solve", "-", "--solver", "search"], &bounds[..]].concat();
        assert_eq!(mo_copp(&first.out, &solve).json()["status"], "solved");
    }
    let ran =
        mo_copp("", &["generate", "blocksworld", "--seed", "1", "--blocks", "4", "--goals", "3"]);
    let json: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!(json["goals"].as_array().unwrap().len(), 3);
    assert!(json["problem"].to_string().contains("a b c d - block"));
    let ran = mo_copp("", &["generate", "driverlog", "--seed", "1", "--packages", "3"]);
    assert!(ran.out.contains("p1 p2 p3 - package"));
    for (arguments, message) in [
        (["blocksworld", "--blocks", "2"], "blocks: found 2, expected a whole number from 3 to 26"),
        (["blocksworld", "--width", "2"], "width: found 2, expected nothing, since blocksworld"),
        (["logistics", "--blocks", "4"], "blocks: found 4, expected nothing, since logistics"),
        (["logistics", "--packages", "0"], "packages: found 0, expected a whole number from 1"),
        (["driverlog", "--deliver", "1"], "deliver: found 1, expected nothing"),
        (["gridworld", "--blocks", "4"], "blocks: found 4, expected nothing"),
    ] {
        let ran = mo_copp("", &[&["generate"], &arguments[..], &["--seed", "1"]].concat());
        assert_eq!(ran.code, 2, "{arguments:?}");
        assert!(ran.err.contains(message), "{arguments:?}: {}", ran.err);
    }
}

#[test]
fn sizes_are_heeded_and_bad_ones_refused() {
    let sizes = ["--width", "5", "--height", "4", "--goals", "2", "--walls", "3", "--belief", "2"];
    let ran = mo_copp("", &[&["generate", "gridworld", "--seed", "1"][..], &sizes].concat());
    let json: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!((json["width"].as_u64(), json["height"].as_u64()), (Some(5), Some(4)));
    assert_eq!(json["walls"].as_array().unwrap().len(), 3);
    assert_eq!(json["goals"].as_array().unwrap().len(), 2);
    for (arguments, message) in [
        (&["gridworld", "--width", "0"][..], "width: found 0, expected a whole number from 1"),
        (&["gridworld", "--walls", "63"], "walls: found 63, expected a whole number from 0 to 60"),
        (&["gridworld", "--packages", "3"], "packages: found 3, expected nothing"),
        (&["delivery", "--goals", "3"], "goals: found 3, expected nothing"),
        (
            &["gridworld", "--width", "1", "--height", "2"],
            "cells: found 2, expected a whole number from 3 to 65536",
        ),
        (
            &["delivery", "--packages", "0"],
            "packages: found 0, expected a whole number from 2 to 64",
        ),
        (
            &["delivery", "--packages", "64", "--deliver", "32"],
            "deliver: found 32 of 64 packages, expected between 2 and 1024 possible sets",
        ),
        (&["delivery", "--deliver", "6"], "deliver: found 6, expected a whole number from 1 to 5"),
    ] {
        let ran = mo_copp("", &[&["generate"], arguments, &["--seed", "1"]].concat());
        assert_eq!(ran.code, 2, "{arguments:?}");
        assert!(ran.err.contains(message), "{arguments:?}: {}", ran.err);
    }
}

/// Far more states than can be gone through, and as many goals as a problem may have.
#[test]
fn large_worlds_with_many_goals_are_drawn_soon() {
    let size = ["--width", "32", "--height", "32", "--seed", "3"];
    let begin = std::time::Instant::now();
    for (domain, more, goals) in [
        ("recycling-robot", &["--battery-levels", "32", "--goals", "1000"][..], 1000),
        ("recycling-robot", &["--battery-levels", "2", "--goals", "2"][..], 2),
        ("box-pushing", &["--goals", "32", "--walls", "20"][..], 32),
    ] {
        let ran = mo_copp("", &[&["generate", domain], more, &size].concat());
        if ran.code == 0 {
            let json: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
            assert_eq!(json["goals"].as_array().unwrap().len(), goals);
        } else {
            // A battery that is nearly empty reaches next to nothing.
            assert!(more.contains(&"2") && ran.err.contains("no solvable problem"), "{}", ran.err);
        }
    }
    assert!(begin.elapsed().as_secs() < 60, "{:?}", begin.elapsed());
}

#[test]
fn problems_drawn_before_are_counted() {
    let notes = [
        (["gridworld", "3"], "1 problem without a plan was"),
        (["gridworld", "8"], "3 problems without a plan were"),
    ];
    for ([domain, seed], note) in notes {
        let ran = mo_copp("", &["generate", domain, "--seed", seed]);
        assert_eq!(ran.err, format!("mo-copp: note: {note} drawn before this one\n"));
    }
}
