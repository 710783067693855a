//! Holds `ARCHITECTURE.md` true: modules of the crate and folders of the page use only what their arrows allow.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Component, Path, PathBuf};

use crate::uses::paths;
use crate::{files, read, root};

/// What each part may use.
type Table = &'static [(&'static str, &'static [&'static str])];

/// For each module under `src/`, the modules it may use. `ARCHITECTURE.md` says why.
const MODULES: Table = &[
    ("task", &[]),
    ("limits", &[]),
    ("pddl", &["limits", "task"]),
    ("plan", &["task"]),
    ("sensor", &["task"]),
    ("belief", &["limits", "sensor", "task"]),
    ("goal_difference", &["belief", "task"]),
    ("problem", &["belief", "goal_difference", "limits", "sensor", "task"]),
    ("trace", &["belief", "goal_difference", "limits", "plan", "problem", "sensor", "task"]),
    ("document", &["limits"]),
    ("domain", &["document", "pddl", "problem", "sensor", "task"]),
    ("heuristic", &["problem", "task"]),
    (
        "solver",
        &[
            "belief",
            "goal_difference",
            "heuristic",
            "limits",
            "plan",
            "problem",
            "sensor",
            "task",
            "trace",
        ],
    ),
    (
        "exercise",
        &[
            "document",
            "domain",
            "goal_difference",
            "limits",
            "plan",
            "problem",
            "sensor",
            "solver",
            "task",
            "trace",
        ],
    ),
    (
        "report",
        &[
            "belief",
            "document",
            "domain",
            "exercise",
            "goal_difference",
            "plan",
            "problem",
            "solver",
            "task",
            "trace",
        ],
    ),
    ("picture", &["belief", "document", "domain", "goal_difference", "plan", "problem", "report"]),
    (
        "experiment",
        &["document", "domain", "goal_difference", "limits", "plan", "problem", "solver"],
    ),
    (
        "bindings",
        &[
            "document", "domain", "exercise", "limits", "picture", "plan", "problem", "report",
            "solver", "trace",
        ],
    ),
    (
        "cli",
        &[
            "document",
            "domain",
            "exercise",
            "experiment",
            "goal_difference",
            "limits",
            "pddl",
            "picture",
            "plan",
            "problem",
            "report",
            "solver",
            "trace",
        ],
    ),
];

/// For each folder under `www/src/`, the folders it may import from; `core` is `core.ts`, `entry` what pages load.
const FOLDERS: Table = &[
    ("core", &[]),
    ("problem", &[]),
    ("view", &["problem"]),
    ("worker", &["core"]),
    ("state", &["core", "problem", "view", "worker"]),
    ("gesture", &["problem", "state", "view"]),
    ("play", &["core", "state", "view"]),
    ("edit", &["gesture", "problem", "state", "view"]),
    ("exercise", &["core", "problem", "state", "view"]),
    ("help", &["gesture", "view"]),
    ("gallery", &["help", "problem", "state", "view"]),
    ("solve", &["core", "gallery", "help", "state", "view"]),
    ("stage", &["core", "gesture", "help", "play", "problem", "state", "view"]),
    ("share", &["gallery", "problem", "state", "view", "worker"]),
    ("steps", &["core", "gallery", "help", "stage", "state", "view"]),
    ("text", &["core", "problem", "share", "state", "worker"]),
    ("playground", &["gallery", "state", "text", "view"]),
    ("author", &["problem", "share", "state", "view"]),
    ("workbench", &["author", "edit", "play", "solve", "state", "steps", "text"]),
    (
        "element",
        &[
            "core",
            "edit",
            "exercise",
            "gallery",
            "gesture",
            "help",
            "playground",
            "problem",
            "share",
            "stage",
            "state",
            "steps",
            "view",
            "workbench",
            "worker",
        ],
    ),
    ("frame", &["element"]),
    ("learn", &["element"]),
    ("entry", &["element", "frame", "learn", "stage"]),
];

/// The module of a file: the first name below `src/`.
fn module(path: &Path) -> Option<String> {
    let below = path.strip_prefix(root().join("src")).unwrap();
    let first = below.iter().next().unwrap().to_string_lossy();
    let name = first.trim_end_matches(".rs").to_owned();
    (!matches!(name.as_str(), "lib" | "main")).then_some(name)
}

/// The modules that a file uses; tests in it may use anything.
fn uses(path: &Path) -> BTreeSet<String> {
    let below = path.strip_prefix(root().join("src")).unwrap().with_extension("");
    let parts = below.iter().map(|part| part.to_string_lossy().into_owned());
    let module: Vec<String> =
        parts.filter(|part| !matches!(part.as_str(), "mod" | "lib" | "main")).collect();
    let paths = paths(&std::fs::read_to_string(path).unwrap(), &module);
    // Constants and types of the crate's root are none.
    let is_module = |name: &String| {
        name.starts_with(|letter: char| letter.is_ascii_lowercase() || letter == '*')
    };
    paths.into_iter().filter_map(|path| path.into_iter().next()).filter(is_module).collect()
}

/// The files of the page, each with the files that it imports: types count, and so does what is loaded later.
fn imports() -> BTreeMap<PathBuf, BTreeSet<PathBuf>> {
    let paths: BTreeSet<PathBuf> = files("www/src", ".ts").into_iter().collect();
    let imported = |path: &PathBuf| {
        let text = std::fs::read_to_string(path).unwrap();
        let parts: Vec<&str> = text
            .lines()
            .filter(|line| !line.trim_start().starts_with("//"))
            .flat_map(|line| line.split('"'))
            .collect();
        parts
            .windows(2)
            .filter(|pair| {
                ["from ", "import ", "import("].iter().any(|word| pair[0].ends_with(word))
            })
            .filter(|pair| pair[1].starts_with('.'))
            .map(|pair| resolved(path, pair[1]))
            .filter(|target| paths.contains(target))
            .collect()
    };
    paths.iter().map(|path| (path.clone(), imported(path))).collect()
}

/// The file that a relative address in another means.
fn resolved(from: &Path, address: &str) -> PathBuf {
    let mut target = from.parent().unwrap().to_owned();
    for part in Path::new(address).components() {
        match part {
            Component::ParentDir => assert!(target.pop()),
            Component::Normal(name) => target.push(name),
            _ => {}
        }
    }
    target.with_extension("ts")
}

/// The folder of a file of the page: the first name below `www/src/`.
fn folder(path: &Path) -> String {
    let below = path.strip_prefix(root().join("www/src")).unwrap();
    let mut names = below.iter().map(|name| name.to_string_lossy());
    let first = names.next().unwrap();
    match (first.as_ref(), names.next()) {
        (_, Some(_)) => first.into_owned(),
        ("core.ts", None) => "core".to_owned(),
        (_, None) => "entry".to_owned(),
    }
}

/// Checks each arrow that was seen, of a file and from one part to another, and that every arrow of the table is needed.
fn assert_arrows(table: Table, seen: &[(&Path, String, String)]) {
    let allowed: BTreeMap<&str, &[&str]> = table.iter().copied().collect();
    for (path, from, to) in seen {
        let permitted = allowed
            .get(from.as_str())
            .unwrap_or_else(|| panic!("{from} is no part that ARCHITECTURE.md knows"));
        assert!(
            from == to || permitted.contains(&to.as_str()),
            "{} uses {to}, which {from} may not",
            path.display()
        );
    }
    for (from, permitted) in table {
        for to in *permitted {
            let needed = seen.iter().any(|(_, one, other)| one == from && other == to);
            assert!(needed, "{from} may use {to} but does not: drop the arrow");
        }
    }
}

#[test]
fn modules_use_only_what_their_arrows_allow() {
    let paths = files("src", ".rs");
    let mut seen = Vec::new();
    for path in &paths {
        let Some(from) = module(path) else { continue };
        // Tests may use anything, in a file of their own as well.
        if path.ends_with("tests.rs") {
            continue;
        }
        let used = uses(path);
        seen.extend(used.into_iter().map(|to| (path.as_path(), from.clone(), to)));
        seen.push((path, from.clone(), from));
    }
    assert_arrows(MODULES, &seen);
}

#[test]
fn folders_of_the_page_import_only_what_their_arrows_allow() {
    let imports = imports();
    let mut seen = Vec::new();
    for (path, imported) in &imports {
        let from = folder(path);
        seen.extend(imported.iter().map(|to| (path.as_path(), from.clone(), folder(to))));
        seen.push((path, from.clone(), from));
    }
    assert_arrows(FOLDERS, &seen);
}

#[test]
fn no_file_of_the_page_imports_itself_by_way_of_others() {
    let mut open = imports();
    // Files that import no other that is left cannot be part of a circle.
    while let Some(path) = open.iter().find(|(_, to)| to.is_empty()).map(|(path, _)| path.clone()) {
        open.remove(&path);
        for imported in open.values_mut() {
            imported.remove(&path);
        }
    }
    assert!(
        open.is_empty(),
        "these files are in circles of imports, or use some that are: {:#?}",
        open.keys()
    );
}

#[test]
fn the_arrows_have_one_direction() {
    for table in [MODULES, FOLDERS] {
        // Parts in an order in which each uses only earlier ones, as far as there is one.
        let mut placed: BTreeSet<&str> = BTreeSet::new();
        while placed.len() < table.len() {
            let next = table.iter().find(|(part, uses)| {
                !placed.contains(part) && uses.iter().all(|used| placed.contains(used))
            });
            let (part, _) = next.expect("there is a circle of arrows");
            placed.insert(part);
        }
    }
}

#[test]
fn the_architecture_page_knows_every_file() {
    let page = read("ARCHITECTURE.md");
    for (prefix, table) in [("", MODULES), ("www/src/", FOLDERS)] {
        for (part, uses) in table {
            let start = format!("| `{prefix}{part}` |");
            let line = page.lines().find(|line| line.starts_with(&start));
            let line = line.unwrap_or_else(|| panic!("no line for {prefix}{part}"));
            for used in *uses {
                assert!(line.contains(&format!("`{used}`")), "{part} → {used} is missing");
            }
        }
    }
    for path in files("src", ".rs") {
        let below = path.strip_prefix(root()).unwrap().to_string_lossy().into_owned();
        assert!(page.contains(&format!("`{below}`")), "no word of {below}");
    }
}
