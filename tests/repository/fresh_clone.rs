//! A fresh clone has no npm packages: what the commands load before set-up needs Node alone.

use std::collections::BTreeSet;
use std::path::PathBuf;

use crate::{read, root};

/// What a script imports as it is loaded. An `import(…)` inside of a function comes later and does not count.
fn imported(text: &str) -> Vec<&str> {
    let from = text.split('\n').filter(|line| !line.trim_start().starts_with("//"));
    from.filter(|line| line.starts_with("import ") || line.starts_with("} from "))
        .filter_map(|line| line.split('"').nth(1))
        .collect()
}

#[test]
fn commands_load_nothing_from_npm_before_set_up() {
    let mut open: Vec<PathBuf> = ["test", "start", "setup", "build", "dev", "release", "format"]
        .map(|name| PathBuf::from(format!("scripts/{name}.mjs")))
        .to_vec();
    let mut seen = BTreeSet::new();
    while let Some(script) = open.pop() {
        if !seen.insert(script.clone()) {
            continue;
        }
        for name in imported(&read(&script)) {
            if name.starts_with("node:") {
                continue;
            }
            assert!(name.starts_with('.'), "{} imports {name}", script.display());
            let next = script.parent().unwrap().join(name);
            let next = next.components().fold(PathBuf::new(), |mut path, part| {
                match part.as_os_str().to_str() {
                    Some("..") => {
                        path.pop();
                    }
                    Some(".") | None => {}
                    Some(part) => path.push(part),
                }
                path
            });
            assert!(root().join(&next).exists(), "{}", next.display());
            open.push(next);
        }
    }
    assert!(seen.len() > 20, "{}", seen.len());
}
