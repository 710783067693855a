//! Ctrl-C: the best plan found is kept.
#![cfg(unix)]

use std::io::Write;
use std::process::Command;
use std::time::{Duration, Instant};

use crate::{command, mo_copp, ran};

/// Runs a solver for long on a document and interrupts it.
fn interrupted(document: &str, arguments: &[&str], signals: &[&str]) -> (crate::Ran, Duration) {
    let mut child = command(arguments).spawn().unwrap();
    child.stdin.take().unwrap().write_all(document.as_bytes()).unwrap();
    // Asked again and again, so that it does not matter when the handler is set: until it is, the
    // signal would end the process, so the first one is sent once the work is under way.
    let under_way = Instant::now() + Duration::from_millis(1500);
    while Instant::now() < under_way {
        assert!(child.try_wait().unwrap().is_none(), "the work should take longer than this");
        std::thread::yield_now();
    }
    let begin = Instant::now();
    for signal in signals {
        let kill = Command::new("kill").args([signal, &child.id().to_string()[..]]).status();
        assert!(kill.unwrap().success());
    }
    (ran(child.wait_with_output().unwrap()), begin.elapsed())
}

#[test]
fn the_exact_solver_keeps_its_best_plan() {
    let size = ["--width", "200", "--height", "200", "--goals", "12"];
    let grid = mo_copp("", &[&["generate", "gridworld", "--seed", "1"][..], &size].concat()).out;
    let (ran, took) = interrupted(&grid, &["solve", "-", "--json"], &["-INT"]);
    assert_eq!(ran.json()["limit"], "stopped on request", "{}{}", ran.out, ran.err);
    let status = ran.json()["status"].as_str().unwrap().to_owned();
    assert_eq!(
        (status.as_str(), ran.code),
        if ran.json()["plan"].is_null() { ("limit", 3) } else { ("feasible", 0) }
    );
    assert!(took < Duration::from_secs(30), "{took:?}");
}

#[test]
fn an_integer_program_in_its_root_is_left_behind() {
    let grid = mo_copp("", &["generate", "gridworld", "--seed", "1"]).out;
    let options =
        ["solve", "-", "--json", "--solver", "ip", "--encoding", "paper", "--horizon", "14"];
    let (ran, took) = interrupted(&grid, &options, &["-INT"]);
    assert_eq!(ran.json()["limit"], "stopped on request", "{}{}", ran.out, ran.err);
    // The plan found before the root was begun.
    assert_eq!((ran.code, ran.json()["status"].as_str()), (0, Some("feasible")), "{}", ran.out);
    assert_eq!(ran.json()["horizon"], 14);
    assert!(took < Duration::from_secs(30), "{took:?}");
}

/// The document has not come to its end: the process still waits for it.
#[test]
fn a_document_that_is_still_read_is_left_behind() {
    for (arguments, signal) in [
        (&["solve", "-", "--json"][..], "-INT"),
        (&["solve", "-"][..], "-TERM"),
        (&["trace", "-", "--plan", "north"][..], "-INT"),
        (&["encode", "-", "--horizon", "3"][..], "-INT"),
        (&["plan", "-", "nowhere.pddl", "--json"][..], "-INT"),
    ] {
        let mut child = command(arguments).spawn().unwrap();
        let mut stdin = child.stdin.take().unwrap();
        stdin.write_all(b"{\"format\": \"gridworld\", ").unwrap();
        std::thread::sleep(Duration::from_millis(1500));
        let begin = Instant::now();
        let kill = Command::new("kill").args([signal, &child.id().to_string()[..]]).status();
        assert!(kill.unwrap().success());
        let ran = ran(child.wait_with_output().unwrap());
        assert_eq!(ran.code, 3, "{arguments:?}: {}{}", ran.out, ran.err);
        assert!(begin.elapsed() < Duration::from_secs(30), "{:?}", begin.elapsed());
        assert!((ran.out + &ran.err).contains("stopped on request"), "{arguments:?}");
        drop(stdin);
    }
    let mut child = command(&["solve", "-", "--json", "--solver", "search"]).spawn().unwrap();
    let stdin = child.stdin.take().unwrap();
    std::thread::sleep(Duration::from_millis(1500));
    let kill = Command::new("kill").args(["-INT", &child.id().to_string()[..]]).status();
    assert!(kill.unwrap().success());
    let json = ran(child.wait_with_output().unwrap()).json();
    assert_eq!((&json["status"], &json["solver"]), (&"limit".into(), &"search".into()), "{json}");
    assert!(json["plan"].is_null() && json["goals"].is_null(), "{json}");
    drop(stdin);
}

/// As schedulers do: the process and its group are told, so that it hears the same wish twice.
#[test]
fn two_signals_at_once_are_one_wish() {
    let grid = mo_copp("", &["generate", "gridworld", "--seed", "1"]).out;
    let options =
        ["solve", "-", "--json", "--solver", "ip", "--encoding", "paper", "--horizon", "14"];
    let (ran, _) = interrupted(&grid, &options, &["-TERM", "-TERM"]);
    assert_eq!(ran.json()["limit"], "stopped on request", "{}{}", ran.out, ran.err);
    assert_eq!((ran.code, ran.json()["status"].as_str()), (0, Some("feasible")), "{}", ran.out);
}
