//! `mo-copp picture -o step.png`: the pixels of the file.

use std::fs;
use std::path::PathBuf;

use resvg::tiny_skia::Pixmap;
use roxmltree::{Document as Xml, Node};

use crate::picture::corridor;
use crate::{Ran, mo_copp};

/// A path for a new file.
fn path(name: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_file(&path);
    path
}

fn written(document: &str, name: &str, args: &[&str]) -> (Ran, Option<Vec<u8>>) {
    let path = path(name);
    let ran = mo_copp(document, &[&["picture", "-", "-o", path.to_str().unwrap()], args].concat());
    (ran, fs::read(path).ok())
}

fn drawn(name: &str, args: &[&str]) -> Pixmap {
    let (ran, bytes) = written(&corridor(), name, args);
    assert_eq!((ran.code, &*ran.out, &*ran.err), (0, "", ""), "{args:?}");
    Pixmap::decode_png(&bytes.unwrap()).unwrap()
}

fn colour(pixmap: &Pixmap, [x, y]: [f64; 2]) -> String {
    let pixel = pixmap.pixel(x as u32, y as u32).unwrap();
    assert_eq!(pixel.alpha(), 255);
    format!("#{:02x}{:02x}{:02x}", pixel.red(), pixel.green(), pixel.blue())
}

#[test]
fn a_png_is_twice_as_large_as_the_svg_or_as_the_scale_says() {
    let svg = mo_copp(&corridor(), &["picture", "-"]).out;
    let root = Xml::parse(&svg).unwrap();
    let size = ["width", "height"].map(|name| number(root.root_element(), name));
    for (name, args, scale) in [
        ("twice.png", &[][..], 2.0),
        ("twice.PNG", &[], 2.0),
        ("half.png", &["--scale", "0.5"], 0.5),
        ("thrice.png", &["--scale=3"], 3.0),
    ] {
        let pixmap = drawn(name, args);
        let found = [pixmap.width(), pixmap.height()].map(f64::from);
        assert_eq!(found, size.map(|side| (side * scale).round()), "{name}");
    }
}

fn number(node: Node<'_, '_>, name: &str) -> f64 {
    node.attribute(name).unwrap().parse().unwrap()
}

/// The badges of goals in a picture of one board: the name of the goal, its colour, and a place left of its letters.
fn badges(svg: &str) -> Vec<(String, String, [f64; 2])> {
    const MARGIN: f64 = 24.0;
    let xml = Xml::parse(svg).unwrap();
    let groups = xml.root_element().descendants().filter(|node| node.has_tag_name((SVG, "g")));
    let badge = |group: Node<'_, '_>| {
        let child = |name| group.children().find(|child| child.has_tag_name((SVG, name)));
        let (title, frame) = (child("title")?.text()?, child("rect")?);
        let [x, y, width, height] = ["x", "y", "width", "height"].map(|name| number(frame, name));
        let left = [MARGIN + x + width * 0.1, MARGIN + y + height * 0.5];
        Some((title.to_owned(), frame.attribute("fill")?.to_owned(), left))
    };
    groups.filter_map(badge).collect()
}

const SVG: &str = "http://www.w3.org/2000/svg";

#[test]
fn badges_have_the_colours_of_the_svg() {
    let mut seen = Vec::new();
    for (board, theme) in [("adversarial", "light"), ("cooperative", "dark")] {
        let args = ["--plan", "east,north", "--board", board, "--theme", theme, "--no-captions"];
        // In this one both sides rule goals out, and others survive.
        let text = corridor().replace("[4, 1]", "[5, 1]");
        let svg = mo_copp(&text, &[&["picture", "-"], &args[..]].concat()).out;
        let (ran, bytes) = written(&text, &format!("{board}.png"), &args);
        assert_eq!((ran.code, &*ran.err), (0, ""));
        let pixmap = Pixmap::decode_png(&bytes.unwrap()).unwrap();
        let badges = badges(&svg);
        assert_eq!(badges.len(), 4);
        for (goal, fill, place) in badges {
            assert_eq!(colour(&pixmap, place.map(|side| 2.0 * side)), fill, "{goal}, {board}");
            seen.push(fill);
        }
    }
    // Survivors of enemy and friend, and the cards of those that are ruled out.
    for fill in ["#b3401a", "#74bdf2", "#1c2027"] {
        assert!(seen.iter().any(|seen| seen == fill), "{fill}: {seen:?}");
    }
}

#[test]
fn the_same_picture_is_the_same_file() {
    let made = |name| written(&corridor(), name, &["--plan", "east", "--numbers"]).1.unwrap();
    assert_eq!(made("first.png"), made("second.png"));
}

#[test]
fn a_walk_is_no_png() {
    let (ran, file) = written(&corridor(), "walk.png", &["--plan", "east", "--animate"]);
    assert_eq!((ran.code, file), (2, None));
    let expected =
        "walk.svg\", which moves in a browser: a PNG does not move, and shows one --step";
    assert!(ran.err.contains(expected), "{}", ran.err);
}

#[test]
fn a_scale_has_bounds_and_is_of_a_png() {
    for scale in ["0.4", "8.1", "-1", "0", "x", "", "NaN", "inf"] {
        let (ran, file) = written(&corridor(), "scale.png", &["--scale", scale]);
        assert_eq!((ran.code, file), (2, None), "{scale}");
        let expected = "for '--scale <N>': expected a number from 0.5 to 8";
        assert!(ran.err.contains(expected), "{}", ran.err);
    }
    let (ran, file) = written(&corridor(), "large.png", &["--scale", "8"]);
    assert_eq!((ran.code, file), (2, None));
    let expected =
        "scale: found 8, expected at most 7.1: the picture would have 9472 by 5328 pixels";
    assert!(ran.err.contains(expected), "{}", ran.err);
    for name in ["scale.svg", "scale"] {
        let (ran, file) = written(&corridor(), name, &["--scale", "2"]);
        assert_eq!((ran.code, file), (2, None), "{name}");
        let expected = "scale: found 2, expected a PNG, as with -o step.png";
        assert!(ran.err.contains(expected), "{}", ran.err);
    }
}

#[test]
fn characters_without_a_form_are_named() {
    // Not assigned: no font has them.
    let text = corridor().replace("\"D1\"", "\"\u{378}x\u{379}\"");
    let (ran, file) = written(&text, "boxes.png", &[]);
    assert_eq!((ran.code, file.is_some()), (0, true));
    let expected = "mo-copp: no font has \u{378} \u{379}: a box stands in the place of each\n";
    assert_eq!(ran.err, expected);
}

#[test]
fn what_cannot_be_written_leaves_nothing_behind() {
    let (ran, file) = written(&corridor(), "no-such-folder/step.png", &[]);
    assert_eq!((ran.code, file), (2, None));
    assert!(ran.err.contains("step.png: cannot be written: "), "{}", ran.err);
}

/// A disk that is full is played by a limit on the size of files.
#[cfg(unix)]
#[test]
fn half_a_file_is_not_left_behind() {
    let path = path("half-written.png");
    fs::write(&path, "an older one").unwrap();
    let mut command = std::process::Command::new("sh");
    let limited = r#"trap '' XFSZ; ulimit -f 1; exec "$0" picture - -o "$1""#;
    command.args(["-c", limited, env!("CARGO_BIN_EXE_mo-copp")]).arg(&path);
    let ran = crate::with_input(command, &corridor());
    assert_eq!((ran.code, path.exists()), (2, false), "{}", ran.err);
    assert!(ran.err.contains("half-written.png: cannot be written: "), "{}", ran.err);
}
