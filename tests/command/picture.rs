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
    for (name, format) in [("picture.png", "PNG"), ("picture.Pdf", "PDF"), ("picture.gif", "GIF")] {
        let (code, err, text) = drawn(name);
        assert_eq!((code, text), (2, None), "{name}");
        assert!(
            err.contains(&format!("{name}\", expected the name of an SVG file, as \"")),
            "{err}"
        );
        assert!(err.contains(&format!("of which other programs make {format}: ")), "{err}");
    }
}
