//! `mo-copp picture`: the file that it writes.

use std::fs;
use std::path::Path;

use crate::mo_copp;

pub fn corridor() -> String {
    fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/www/problems/corridor.json")).unwrap()
}

#[test]
fn a_file_is_what_its_name_says() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let drawn = |name: &str| {
        let path = folder.join(name);
        let _ = fs::remove_file(&path);
        let ran = mo_copp(&corridor(), &["picture", "-", "-o", path.to_str().unwrap()]);
        (ran.code, ran.err, fs::read_to_string(path).ok())
    };
    let printed = mo_copp(&corridor(), &["picture", "-"]).out;
    assert_eq!(mo_copp(&corridor(), &["picture", "-", "-o", "-"]).out, printed);
    for name in ["picture.svg", "picture.SVG", "picture-without-end", ".picture"] {
        let (code, err, text) = drawn(name);
        assert_eq!((code, err.as_str(), text.as_deref()), (0, "", Some(&*printed)), "{name}");
    }
    for (name, words) in [
        ("picture.Pdf", "; of an SVG other programs make PDF: rsvg-convert -f pdf, or inkscape"),
        ("picture.webp", "; of a PNG other programs make WEBP, as ImageMagick"),
        ("picture.tiff", "; of a PNG other programs make TIFF, as ImageMagick"),
        ("picture.html", "picture.png\": no other format is written"),
        ("picture.svgz", "picture.png\": no other format is written"),
        ("picture.v2", "picture.png\": no other format is written"),
    ] {
        let (code, err, text) = drawn(name);
        assert_eq!((code, text), (2, None), "{name}");
        let expected = format!("{name}\", expected the name of an SVG or PNG file, as \"");
        assert!(err.contains(&expected) && err.contains(words), "{err}");
    }
    for (name, words) in [
        ("picture.gif", "which moves in a browser with --animate; this program makes no GIF"),
        ("picture.mp4", "which moves in a browser with --animate; this program makes no MP4"),
        ("picture.WebM", "which moves in a browser with --animate; this program makes no WEBM"),
    ] {
        let (code, err, text) = drawn(name);
        assert_eq!((code, text), (2, None), "{name}");
        let expected = format!("{name}\", expected the name of an SVG file, as \"");
        assert!(err.contains(&expected) && err.contains(words), "{err}");
    }
}

#[test]
fn an_animation_goes_by_the_name_of_its_file_as_well() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    for (name, code) in [("walk.svg", 0), ("walk", 0), ("walk.mp4", 2), ("walk.png", 2)] {
        let path = folder.join(name);
        let _ = fs::remove_file(&path);
        let args = ["picture", "-", "--plan", "east", "--animate", "-o", path.to_str().unwrap()];
        let ran = mo_copp(&corridor(), &args);
        assert_eq!((ran.code, path.exists()), (code, code == 0), "{name}: {}", ran.err);
    }
}

#[test]
fn a_step_beyond_the_last_is_refused() {
    let ran = mo_copp(&corridor(), &["picture", "-", "--plan", "east", "--step", "2"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    assert!(ran.err.contains("step: found 2, expected a whole number from 0 to 1"), "{}", ran.err);
}

#[test]
fn what_an_argument_should_have_been_is_said() {
    let said = |args: &[&str]| {
        let ran = mo_copp(&corridor(), &[&["picture", "-"], args].concat());
        assert_eq!((ran.code, ran.out.as_str()), (2, ""), "{args:?}");
        ran.err
    };
    for step in ["--step=-1", "--step=x", "--step=", "--step=1.5", "--milliseconds=x"] {
        let animated: &[&str] = if step.starts_with("--m") { &["--animate"] } else { &[] };
        let err = said(&[&[step], animated].concat());
        let (name, value) = step.split_once('=').unwrap();
        assert!(err.contains(&format!("'{value}' for '{name} <")), "{err}");
        assert!(err.contains("expected a whole number from 0"), "{err}");
    }
    let err = said(&["--step", "99999999999999999999999"]);
    assert!(err.contains("for '--step <N>': expected a smaller number"), "{err}");
    let err = said(&["--board", "nope"]);
    let expected = "found \"nope\", expected one of all, actor, adversarial, cooperative";
    assert!(err.contains(expected), "{err}");
}
