//! Holds `ARCHITECTURE.md` true: modules use only what their arrows allow.

use std::collections::{BTreeMap, BTreeSet};

use crate::{files, read, root};

/// For each module under `src/`, the modules it may use. `ARCHITECTURE.md` says why.
const ALLOWED: &[(&str, &[&str])] = &[
    ("task", &[]),
    ("limits", &[]),
    ("pddl", &["task"]),
    ("plan", &["task"]),
    ("sensor", &["task"]),
    ("belief", &["limits", "sensor", "task"]),
    ("goal_difference", &["belief", "task"]),
    ("problem", &["belief", "goal_difference", "limits", "sensor", "task"]),
    ("trace", &["goal_difference", "plan", "problem", "task"]),
    ("document", &[]),
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
        "report",
        &["document", "domain", "goal_difference", "plan", "problem", "solver", "task", "trace"],
    ),
    (
        "experiment",
        &["document", "domain", "goal_difference", "limits", "plan", "problem", "solver"],
    ),
    ("bindings", &["document", "domain", "plan", "problem", "report", "solver", "trace"]),
    (
        "cli",
        &[
            "document",
            "domain",
            "experiment",
            "limits",
            "pddl",
            "plan",
            "problem",
            "report",
            "solver",
            "trace",
        ],
    ),
];

/// The module of a file: the first name below `src/`.
fn module(path: &std::path::Path) -> Option<String> {
    let below = path.strip_prefix(root().join("src")).unwrap();
    let first = below.iter().next().unwrap().to_string_lossy();
    let name = first.trim_end_matches(".rs").to_owned();
    (!matches!(name.as_str(), "lib" | "main")).then_some(name)
}

/// What stands behind `crate::` or `mo_copp::` in code, documentation left out.
fn uses(text: &str) -> BTreeSet<String> {
    let mut used = BTreeSet::new();
    let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    let code = code.collect::<Vec<_>>().join("\n");
    // Tests in a file may use anything.
    let code = code.split("#[cfg(test)]").next().unwrap();
    for root in ["crate::", "mo_copp::"] {
        for rest in code.split(root).skip(1) {
            let name: String =
                rest.chars().take_while(|c| c.is_ascii_lowercase() || *c == '_').collect();
            if !name.is_empty() {
                used.insert(name);
            }
        }
    }
    used
}

#[test]
fn modules_use_only_what_their_arrows_allow() {
    let allowed: BTreeMap<&str, &[&str]> = ALLOWED.iter().copied().collect();
    let mut seen = BTreeSet::new();
    for path in files("src", ".rs") {
        let Some(module) = module(&path) else { continue };
        let permitted = allowed
            .get(module.as_str())
            .unwrap_or_else(|| panic!("{module} is no module that ARCHITECTURE.md knows"));
        for used in uses(&std::fs::read_to_string(&path).unwrap()) {
            assert!(
                used == module || permitted.contains(&used.as_str()),
                "{} uses {used}, which {module} may not",
                path.display()
            );
            seen.insert((module.clone(), used));
        }
        seen.insert((module.clone(), module));
    }
    for (module, permitted) in ALLOWED {
        for used in *permitted {
            let edge = ((*module).to_owned(), (*used).to_owned());
            assert!(seen.contains(&edge), "{module} may use {used} but does not: drop the arrow");
        }
    }
}

#[test]
fn the_arrows_have_one_direction() {
    // Modules in an order in which each uses only earlier ones, as far as there is one.
    let mut placed: BTreeSet<&str> = BTreeSet::new();
    while placed.len() < ALLOWED.len() {
        let next = ALLOWED.iter().find(|(module, uses)| {
            !placed.contains(module) && uses.iter().all(|used| placed.contains(used))
        });
        let (module, _) = next.expect("there is a circle of arrows");
        placed.insert(module);
    }
}

#[test]
fn the_architecture_page_knows_every_file() {
    let page = read("ARCHITECTURE.md");
    for (module, uses) in ALLOWED {
        assert!(page.contains(&format!("`{module}`")), "no word of {module}");
        for used in *uses {
            let line = page.lines().find(|line| line.starts_with(&format!("| `{module}` |")));
            let line = line.unwrap_or_else(|| panic!("no line for {module}"));
            assert!(line.contains(&format!("`{used}`")), "{module} → {used} is missing");
        }
    }
    for path in files("src", ".rs") {
        let below = path.strip_prefix(root()).unwrap().to_string_lossy().into_owned();
        assert!(page.contains(&format!("`{below}`")), "no word of {below}");
    }
}
