//! README, CHANGELOG and licences.

use std::collections::BTreeSet;
use std::path::Path;

use crate::{read, root};

#[test]
fn the_readme_begins_with_the_two_commands() {
    let readme = read("README.md");
    let place = |text: &str| readme.find(text).unwrap_or_else(|| panic!("no {text}"));
    assert!(place("\nnpm start") < place("\n## "), "npm start stands before the first chapter");
    assert!(place("\nnpm test") < place("\n## "), "npm test stands before the first chapter");
}

#[test]
fn every_option_of_the_command_is_in_the_readme_or_its_help() {
    let readme = read("README.md");
    for command in ["solve", "trace", "encode", "generate", "experiment"] {
        assert!(readme.contains(&format!("mo-copp {command}")), "no word of {command}");
    }
    for solver in mo_copp::solver::Solver::ALL {
        assert!(readme.contains(solver.name()), "no word of {}", solver.name());
    }
}

#[test]
fn pictures_that_documents_of_the_crate_show_are_in_it() {
    let cargo = std::process::Command::new(env!("CARGO"))
        .args(["package", "--list", "--allow-dirty", "--offline"])
        .current_dir(root())
        .output()
        .unwrap();
    assert!(cargo.status.success(), "{}", String::from_utf8_lossy(&cargo.stderr));
    let list = String::from_utf8(cargo.stdout).unwrap();
    let files: BTreeSet<&Path> = list.lines().map(Path::new).collect();
    let mut seen = 0;
    for document in
        files.iter().filter(|file| file.extension().is_some_and(|ending| ending == "md"))
    {
        let text = read(document);
        for picture in
            text.split("![").skip(1).filter_map(|text| text.split_once("](")?.1.split(')').next())
        {
            let path = document.parent().unwrap().join(picture);
            assert!(files.contains(path.as_path()), "{} shows {picture}", document.display());
            seen += 1;
        }
    }
    assert!(seen > 1, "{seen} pictures");
}

#[test]
fn versions_agree() {
    let version = env!("CARGO_PKG_VERSION");
    assert!(read("CHANGELOG.md").contains(&format!("## [{version}]")), "{version} in CHANGELOG.md");
    assert!(read("package.json").contains(&format!("\"version\": \"{version}\"")), "package.json");
    let names = "www/src/worker/names.ts";
    assert!(read(names).contains(&format!("VERSION = \"{version}\"")), "{names}");
}

#[test]
fn both_licences_are_there() {
    assert!(read("LICENSE-MIT").contains("Permission is hereby granted, free of charge"));
    assert!(read("LICENSE-APACHE").contains("Apache License"));
}

/// `npm run experiments` and `npm run benchmarks` write the tables; nobody edits a number by hand.
#[test]
fn the_tables_of_the_experiments_are_those_of_their_results() {
    let documents = [
        ("docs/experiments.md", "fig3"),
        ("docs/experiments.md", "fig4"),
        ("docs/benchmarks.md", "benchmarks"),
    ];
    for (document, figure) in documents {
        let document = read(document);
        let tables = read(format!("docs/results/{figure}/tables.md"));
        let begin = format!("<!-- tables of {figure} -->\n\n");
        let end = format!("\n<!-- end of tables of {figure} -->");
        let after = document.split_once(&begin).unwrap_or_else(|| panic!("no {begin}")).1;
        let shown = after.split_once(&end).unwrap_or_else(|| panic!("no {end}")).0;
        assert_eq!(shown, tables, "tables of {figure}");
    }
}
