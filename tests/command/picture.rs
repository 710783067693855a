//! `mo-copp picture`: the file that it writes.

use std::fs;
use std::path::Path;

use crate::mo_copp;

fn corridor() -> String {
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
    for name in ["picture.svg", "picture.SVG", "picture-without-end", "picture.v2"] {
        let (code, err, text) = drawn(name);
        assert_eq!((code, err.as_str(), text.as_deref()), (0, "", Some(&*printed)), "{name}");
    }
    for (name, words) in [
        ("picture.png", "of which other programs make PNG: rsvg-convert"),
        ("picture.Pdf", "of which other programs make PDF: rsvg-convert"),
        ("picture.webp", "of which other programs make WEBP: ImageMagick"),
        ("picture.gif", "which moves in a browser with --animate; this program makes no GIF"),
    ] {
        let (code, err, text) = drawn(name);
        assert_eq!((code, text), (2, None), "{name}");
        assert!(
            err.contains(&format!("{name}\", expected the name of an SVG file, as \"")),
            "{err}"
        );
        assert!(err.contains(words), "{err}");
    }
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
