//! Holds the floors inside of `src/solver`: dispatch on top, engines below it, none of which uses
//! another, and at the bottom the ground that they share.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use crate::uses::paths;
use crate::{files, root};

/// The names of a module and of those it may use.
type Arrows = (&'static str, &'static [&'static str]);

/// What is asked, what is answered, and what an engine is.
const CONTRACTS: &[Arrows] = &[
    ("options", &[]),
    ("setters", &["options"]),
    ("implications", &["options"]),
    ("outcome", &["options"]),
    ("engine", &["outcome"]),
    ("error", &["options"]),
];

/// What engines share.
const GROUND: &[Arrows] = &[("ground", &["engine", "options", "outcome"])];

const ENGINES: &[Arrows] = &[
    ("algorithm1", &["engine", "ground", "options", "outcome"]),
    ("baseline", &["engine", "ground", "outcome"]),
    ("explorer", &["engine", "ground", "options", "outcome"]),
    ("ip", &["engine", "ground", "options", "outcome"]),
    ("optimiser", &["engine", "ground", "options", "outcome"]),
    ("parallel_walks", &["engine", "ground", "options", "outcome"]),
];

/// What is made of several engines, or helps itself to one.
const COMPOSITIONS: &[Arrows] = &[
    ("conclude", &["engine", "error", "options", "outcome", "parallel_walks"]),
    ("cost_limited", &["engine", "explorer", "ground", "optimiser", "options", "outcome"]),
    (
        "portfolio",
        &[
            "algorithm1",
            "engine",
            "explorer",
            "ground",
            "optimiser",
            "options",
            "outcome",
            "parallel_walks",
        ],
    ),
    (
        "remedy",
        &["baseline", "engine", "error", "explorer", "ground", "optimiser", "options", "outcome"],
    ),
];

const DISPATCH: &[Arrows] = &[
    (
        "run",
        &[
            "algorithm1",
            "baseline",
            "conclude",
            "cost_limited",
            "engine",
            "error",
            "explorer",
            "ground",
            "ip",
            "optimiser",
            "options",
            "outcome",
            "portfolio",
        ],
    ),
    ("classical", &["baseline", "engine", "error", "outcome"]),
];

/// From the bottom to the top.
const FLOORS: [&[Arrows]; 5] = [CONTRACTS, GROUND, ENGINES, COMPOSITIONS, DISPATCH];

/// The parts of a path between `src/solver/` and the file's end, without `mod`.
fn parts(path: &Path) -> Vec<String> {
    let below = path.strip_prefix(root().join("src/solver")).unwrap().with_extension("");
    let parts = below.iter().map(|part| part.to_string_lossy().into_owned());
    parts.filter(|part| part != "mod").collect()
}

/// The code of a file without comments.
fn code(path: &Path) -> String {
    let text = std::fs::read_to_string(path).unwrap();
    let lines = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    lines.collect::<Vec<_>>().join("\n")
}

/// The first names of the items of a path's end: `a` of `a::b`, and `a` and `c` of `{a::b, c}`.
fn first_names(rest: &str) -> Vec<String> {
    let name = |text: &str| -> String {
        text.trim_start().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
    };
    let Some(list) = rest.strip_prefix('{') else { return vec![name(rest)] };
    let (mut items, mut depth) = (vec![String::new()], 0);
    for letter in list.chars() {
        match letter {
            '}' if depth == 0 => break,
            ',' if depth == 0 => items.push(String::new()),
            _ => items.last_mut().unwrap().push(letter),
        }
        depth += i32::from(letter == '{') - i32::from(letter == '}');
    }
    items.iter().map(|item| name(item)).filter(|name| !name.is_empty()).collect()
}

/// The modules directly below `solver` that a file uses; a name that `solver` exports counts for the
/// module it comes from, and all names at once for a module of the name `*`, which there is not.
fn uses(path: &Path, parts: &[String], exported: &BTreeMap<String, String>) -> BTreeSet<String> {
    let module: Vec<String> = [&["solver".to_owned()], parts].concat();
    let paths = paths(&std::fs::read_to_string(path).unwrap(), &module);
    let below = paths.into_iter().filter(|path| path.len() > 1 && path[0] == "solver");
    below.map(|path| exported.get(&path[1]).unwrap_or(&path[1]).clone()).collect()
}

/// Which module each name comes from that `solver` exports.
fn exported() -> BTreeMap<String, String> {
    let code = code(&root().join("src/solver/mod.rs"));
    let mut exported = BTreeMap::new();
    for statement in code.split("pub use ").skip(1) {
        let (path, _) = statement.split_once(';').unwrap();
        let (module, _) = path.split_once("::").unwrap();
        let names = path.find('{').unwrap_or_else(|| path.rfind("::").unwrap() + 2);
        for name in first_names(&path[names..]) {
            exported.insert(name, module.to_owned());
        }
    }
    assert!(exported.len() > 10, "{exported:?}");
    exported
}

#[test]
fn modules_of_the_solvers_use_only_lower_floors() {
    let all: Vec<Arrows> = FLOORS.concat();
    let allowed: BTreeMap<&str, &[&str]> = all.iter().copied().collect();
    let exported = exported();
    let mut seen = BTreeSet::new();
    for path in files("src/solver", ".rs") {
        let parts = parts(&path);
        let Some(module) = parts.first() else { continue };
        if parts.last().unwrap() == "tests" {
            continue;
        }
        let permitted = allowed
            .get(module.as_str())
            .unwrap_or_else(|| panic!("{module} is on no floor of src/solver"));
        for used in uses(&path, &parts, &exported) {
            let known = used == *module || permitted.contains(&used.as_str());
            assert!(known, "{} uses {used}, which {module} may not", path.display());
            seen.insert((module.clone(), used));
        }
    }
    for (module, permitted) in &all {
        for used in *permitted {
            let edge = ((*module).to_owned(), (*used).to_owned());
            assert!(seen.contains(&edge), "{module} may use {used} but does not: drop the arrow");
        }
    }
}

#[test]
fn arrows_between_floors_point_down() {
    let mut below: BTreeSet<&str> = BTreeSet::new();
    for floor in FLOORS {
        // Within a floor in the order of the table.
        for (module, uses) in floor {
            for used in *uses {
                assert!(below.contains(used), "{module} uses {used}, which stands above it");
                let engines = |name: &str| ENGINES.iter().any(|(engine, _)| *engine == name);
                assert!(!engines(module) || !engines(used), "the engine {module} uses {used}");
            }
            below.insert(module);
        }
    }
}
