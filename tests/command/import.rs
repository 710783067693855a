//! `mo-copp import`: folders, archives, and what is no problem.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::mo_copp;

pub const FILES: [(&str, &str); 5] = [
    (
        "domain.pddl",
        "(define (domain towers) (:predicates (on ?x ?y) (clear ?x) (table ?x))
 (:action stack :parameters (?x ?y) :precondition (and (clear ?x) (clear ?y) (table ?x))
  :effect (and (on ?x ?y) (not (clear ?y)) (not (table ?x)))))",
    ),
    (
        "template.pddl",
        "(define (problem p) (:domain towers) (:objects a b c)
 (:init (clear a) (clear b) (clear c) (table a) (table b) (table c)) (:goal (and <HYPOTHESIS>)))",
    ),
    ("hyps.dat", "(ON A B), (CLEAR A)\n(ON B C), (ON A B)\n(ON B C), (ON A B)\n"),
    ("real_hyp.dat", "(ON B C), (ON A B)\n"),
    ("obs.dat", "(STACK B C)\n(STACK A B)\n"),
];

/// An empty folder of this test.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("import-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn problem(name: &str) -> PathBuf {
    let folder = folder(name);
    for (file, text) in FILES {
        fs::write(folder.join(file), text).unwrap();
    }
    folder
}

pub fn tarred(names: &[(&str, &[u8])]) -> Vec<u8> {
    let mut archive = tar::Builder::new(Vec::new());
    for (name, bytes) in names {
        let mut header = tar::Header::new_gnu();
        header.as_gnu_mut().unwrap().name[..name.len()].copy_from_slice(name.as_bytes());
        header.set_size(bytes.len() as u64);
        header.set_mode(0o644);
        header.set_entry_type(tar::EntryType::Regular);
        header.set_cksum();
        archive.append(&header, *bytes).unwrap();
    }
    archive.into_inner().unwrap()
}

fn in_folder() -> Vec<(String, &'static [u8])> {
    FILES.iter().map(|(name, text)| (format!("p01/{name}"), text.as_bytes())).collect()
}

fn zipped(names: &[(String, &[u8])]) -> Vec<u8> {
    let mut archive = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    for (name, bytes) in names {
        archive.start_file(name.as_str(), zip::write::SimpleFileOptions::default()).unwrap();
        archive.write_all(bytes).unwrap();
    }
    archive.finish().unwrap().into_inner()
}

fn gzipped(bytes: &[u8]) -> Vec<u8> {
    let mut packer = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
    packer.write_all(bytes).unwrap();
    packer.finish().unwrap()
}

pub fn bzipped(bytes: &[u8]) -> Vec<u8> {
    let mut packer = bzip2::write::BzEncoder::new(Vec::new(), bzip2::Compression::fast());
    packer.write_all(bytes).unwrap();
    packer.finish().unwrap()
}

fn imported(args: &[&str]) -> String {
    let ran = mo_copp("", &[&["import"], args].concat());
    assert_eq!(ran.code, 0, "{}", ran.err);
    ran.out
}

fn refused(path: &Path) -> String {
    let ran = mo_copp("", &["import", path.to_str().unwrap()]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    ran.err
}

#[test]
fn a_folder_and_every_archive_give_the_same_document() {
    let folder = problem("archives");
    let document = imported(&[folder.to_str().unwrap()]);
    let read: Value = serde_json::from_str(&document).unwrap();
    assert_eq!(read["true_goal"], "G2");
    assert_eq!(read["observers"]["cooperative"]["sensor"], "{name} {1}");
    let solved = mo_copp(&document, &["solve", "-", "--solver", "exact", "--json"]);
    assert_eq!(solved.code, 0, "{}", solved.err);
    let entries = in_folder();
    let entries: Vec<(&str, &[u8])> =
        entries.iter().map(|(name, bytes)| (name.as_str(), *bytes)).collect();
    let tar = tarred(&entries);
    let archives = [
        ("p.tar", tar.clone()),
        ("p.tar.gz", gzipped(&tar)),
        ("p.tar.bz2", bzipped(&tar)),
        ("p.zip", zipped(&in_folder())),
    ];
    for (name, bytes) in archives {
        let path = folder.join(name);
        fs::write(&path, bytes).unwrap();
        assert_eq!(imported(&[path.to_str().unwrap()]), document, "{name}");
    }
}

#[test]
fn observations_become_a_plan_where_they_are_one() {
    let folder = problem("plan");
    let (document, plan) = (folder.join("p.json"), folder.join("plan.txt"));
    let [source, document, plan] =
        [&folder, &document, &plan].map(|path| path.to_str().unwrap().to_owned());
    let args = ["import", &source, "--out", &document, "--plan-out", &plan];
    let ran = mo_copp("", &args);
    assert_eq!((ran.code, ran.out.as_str()), (0, ""));
    assert!(
        ran.err.contains("hyps.dat:3: the hypothesis of line 2 for a second time"),
        "{}",
        ran.err
    );
    let traced = mo_copp("", &["trace", &document, "--plan-file", &plan, "--json"]);
    let traced: Value = serde_json::from_str(&traced.out).unwrap();
    assert_eq!(traced["valid"], true);
    for (text, why) in
        [("(stack b c)\n", "do not reach the true goal"), ("(fly b)\n", "no whole plan")]
    {
        fs::remove_file(&plan).unwrap_or_default();
        fs::write(folder.join("obs.dat"), text).unwrap();
        let ran = mo_copp("", &args);
        assert_eq!(ran.code, 0);
        assert!(ran.err.contains(why), "{}", ran.err);
        assert!(!Path::new(&plan).exists());
    }
}

#[test]
fn a_document_for_each_hypothesis() {
    let folder = problem("all");
    let source = folder.to_str().unwrap();
    let lines = imported(&[source, "--all"]);
    let goals =
        |text: &str| -> Value { serde_json::from_str::<Value>(text).unwrap()["true_goal"].clone() };
    assert_eq!(lines.lines().map(goals).collect::<Vec<_>>(), ["G1", "G2"]);
    let out = folder.join("documents");
    imported(&[source, "--all", "--out", out.to_str().unwrap()]);
    let text = fs::read_to_string(out.join("G1.json")).unwrap();
    assert_eq!(goals(&text), "G1");
    assert!(!out.join("G3.json").exists());
    assert_eq!(goals(&imported(&[source, "--true-goal", "1"])), "G1");
}

#[test]
fn what_is_no_problem_is_refused() {
    let folder = problem("bad");
    fs::write(folder.join("hyps.dat"), "(ON A B)\n(ON A\n").unwrap();
    let error = refused(&folder);
    assert!(error.contains("hyps.dat:2:6: found the end of the line"), "{error}");
    let archive = folder.join("archive");
    let check = |bytes: Vec<u8>, expected: &str| {
        fs::write(&archive, bytes).unwrap();
        let error = refused(&archive);
        assert!(error.contains(expected), "{error}");
    };
    check(b"no archive".to_vec(), "expected .tar, .tar.gz, .tar.bz2 or .zip");
    check(zipped(&[("../domain.pddl".to_owned(), b"")]), "found the file \"../domain.pddl\"");
    check(tarred(&[("../domain.pddl", b"")]), "expected names inside of the archive");
    check(tarred(&[("/etc/domain.pddl", b"")]), "expected names inside of the archive");
    check(tarred(&[("domain.pddl", &[0xff])]), "domain.pddl: found bytes that are no text");
    check(gzipped(&tarred(&[])), "domain.pddl: found no such file");
    // 300 MiB that pack to little.
    let large = vec![0_u8; 300 << 20];
    check(gzipped(&tarred(&[("filler", &large)])), "it unpacks to more than 256 MiB");
    check(
        gzipped(&tarred(&[("hyps.dat", &large[..33 << 20])])),
        "hyps.dat: found more than 32 MiB",
    );
    let good = gzipped(&tarred(&[("domain.pddl", b"(define (domain d))")]));
    check(good[..good.len() / 2].to_vec(), "found no archive that can be read");
    let many: Vec<(String, &[u8])> =
        (0..10_001).map(|n| (format!("f{n}"), b"".as_slice())).collect();
    check(zipped(&many), "found more than 10000 files");
}
