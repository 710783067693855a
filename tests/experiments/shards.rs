//! Parts of a run, and how they are put together.

use std::path::PathBuf;

use mo_copp::experiment::records::write_sorted;
use mo_copp::experiment::{Header, Setting, Shard, merge};

use super::{blocks, fig3, folder, jobs, records, work};

/// Works on every part of a run; their files.
fn parts(name: &str, setting: &Setting, of: u32) -> Vec<PathBuf> {
    let folder = folder(name);
    let part = |number| {
        let path = folder.join(format!("records-{number}-of-{of}.jsonl"));
        work(&path, setting, Shard { number, of }, 1);
        path
    };
    (1..=of).map(part).collect()
}

#[test]
fn three_parts_merged_are_the_whole() {
    for setting in [fig3(4), blocks(2)] {
        let name = format!("three-{}", setting.figure.name());
        let files = parts(&name, &setting, 3);
        let whole = folder("whole").join("records.jsonl");
        work(&whole, &setting, Shard::WHOLE, 2);
        let (merged, entries) = merge::<Setting>(&files).unwrap();
        assert_eq!(merged, setting);
        let path = files[0].with_file_name("records.jsonl");
        write_sorted(&path, &Header::new(&merged, Shard::WHOLE), &entries).unwrap();
        assert_eq!(records(&path, &setting, Shard::WHOLE), records(&whole, &setting, Shard::WHOLE));
        // What is merged can be merged again, and gone on with.
        assert_eq!(merge::<Setting>(std::slice::from_ref(&path)).unwrap().1.len(), entries.len());
        assert_eq!(work(&path, &setting, Shard::WHOLE, 1), 0);
    }
}

#[test]
fn every_job_is_in_one_part_and_parts_are_alike() {
    let setting = fig3(30);
    let all = setting.jobs();
    for of in [1, 2, 3, 5, 7, 30, 149, 150, 400] {
        let sizes: Vec<usize> =
            (1..=of).map(|number| jobs(&setting, Shard { number, of }).len()).collect();
        assert_eq!(sizes.iter().sum::<usize>(), all.len());
        let (least, most) = (sizes.iter().min().unwrap(), sizes.iter().max().unwrap());
        assert!(most - least <= 1, "{of} parts: {sizes:?}");
        // Each part has about as many of the slow solver.
        let slow = |number| {
            let jobs = jobs(&setting, Shard { number, of });
            jobs.iter().filter(|job| job.configuration.name() == "ip").count()
        };
        let slow: Vec<usize> = (1..=of).map(slow).collect();
        assert!(slow.iter().max().unwrap() - slow.iter().min().unwrap() <= 1, "{slow:?}");
    }
}

/// What merging says, with the folder left out.
fn refused(files: &[PathBuf]) -> String {
    let folder = format!("{}/", files[0].parent().unwrap().display());
    merge::<Setting>(files).unwrap_err().to_string().replace(&folder, "")
}

#[test]
fn what_does_not_fit_together_is_refused() {
    let setting = fig3(2);
    let files = parts("refused-parts", &setting, 3);
    assert!(merge::<Setting>(&files).is_ok());
    assert_eq!(
        refused(&files[..2]),
        "4 of 12 records are missing, the first of them: gridworld 1 ip of shard 3/3; run what \
         is missing, then merge again"
    );
    let twice = [files.clone(), vec![files[1].clone()]].concat();
    assert_eq!(
        refused(&twice),
        "records-2-of-3.jsonl, line 1: found shard 2/3 for the second time, expected each part once"
    );
    let good = std::fs::read_to_string(&files[2]).unwrap();
    let change = |from: &str, to: &str| {
        assert!(good.contains(from), "{from}");
        std::fs::write(&files[2], good.replacen(from, to, 1)).unwrap();
        refused(&files)
    };
    for (from, to, message) in [
        ("\"seed\":1", "\"seed\":2", "found seed 2, expected seed 1, as in records-1-of-3.jsonl"),
        ("3/3", "3/4", "found shard 3/4, expected shard 3/3, as in records-1-of-3.jsonl"),
        ("3/3", "2/3", "found shard 2/3 for the second time, expected each part once"),
        ("[\"gridworld\"]", "[]", "found domains , expected domains gridworld, as in"),
    ] {
        let said = change(from, to);
        assert_eq!(said.split_once(", line 1: ").unwrap().0, "records-3-of-3.jsonl");
        assert!(said.contains(message), "{said}");
    }
    // A record of another part.
    let other = std::fs::read_to_string(&files[0]).unwrap();
    let stray = other.lines().nth(1).unwrap();
    std::fs::write(&files[2], format!("{good}{stray}\n")).unwrap();
    let said = refused(&files);
    assert!(said.starts_with("records-3-of-3.jsonl, line "), "{said}");
    assert!(said.ends_with("expected a record of this part"), "{said}");
    // A torn line is no record.
    std::fs::write(&files[2], &good[..good.len() - 1]).unwrap();
    assert!(refused(&files).starts_with("1 of 12 records are missing"));
    std::fs::write(&files[2], "").unwrap();
    let said = refused(&files);
    assert!(said.ends_with("found no whole line, expected the header of a file of records"));
    assert!(merge::<Setting>(&[]).is_err());
}

#[test]
fn a_header_of_no_known_run_is_refused() {
    let setting = fig3(1);
    let path = folder("unknown").join("records.jsonl");
    work(&path, &setting, Shard::WHOLE, 1);
    let good = std::fs::read_to_string(&path).unwrap();
    for (from, to, message) in [
        ("fig3", "fig5", "found experiment fig5, expected fig3 or fig4"),
        ("[\"gridworld\"]", "[\"chess\"]", "found domain chess, expected gridworld"),
        ("[\"gridworld\"]", "[]", "found domain none, expected at least one"),
        ("\"problems\":1", "\"problems\":0", "found problems 0, expected a whole number from 1"),
        ("\"version\":\"", "\"version\":\"9.", "found version 9.0"),
    ] {
        std::fs::write(&path, good.replacen(from, to, 1)).unwrap();
        let said = merge::<Setting>(std::slice::from_ref(&path)).unwrap_err().to_string();
        assert!(said.contains(message), "{said}");
    }
}
