//! The list of edits: it tells what stands in the steps, as they are now.

#[allow(dead_code)] // what only the program needs
#[path = "../src/bin/edits/edit.rs"]
mod edit;
#[allow(dead_code)]
#[path = "../src/bin/edits/project.rs"]
mod project;
#[allow(dead_code)]
#[path = "../src/bin/edits/view.rs"]
mod view;

use edit::edits;
use gallery::workspace;
use project::Project;
use std::collections::HashSet;
use std::fs;
use std::process::Command;

#[test]
fn every_edit_stands_once_in_its_file() {
    let (mut titles, mut faults) = (HashSet::new(), vec![]);
    let edits = edits().expect("a list of edits");
    for edit in &edits {
        assert!(titles.insert(&edit.title), "twice: {}", edit.title);
        assert_eq!(edit.changes.len(), edit.faults.len(), "{}", edit.title);
        for change in &edit.changes {
            assert_ne!(change.old, change.new, "{}", edit.title);
            let text = fs::read_to_string(workspace().join(change.path()))
                .expect("a file");
            faults.extend(change.applied(&text).err());
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(400 < edits.len(), "{}", edits.len());
}

#[test]
fn cargo_reads_the_copy_of_the_steps_that_is_edited() {
    Project::new(false).expect("a copy");
    let [ours, copy] = ["Cargo.toml", "target/edits/Cargo.toml"].map(|file| {
        fs::read_to_string(workspace().join(file)).expect("a manifest")
    });
    let rest = |text: &str| text.split_once("]\n\n").map(|(_, rest)| rest.len());
    assert_eq!(rest(ours.trim_end()), rest(&copy), "all but the members");
    let mut cargo = Command::new(env!("CARGO"));
    // What only benchmarks need may not be there.
    cargo.args(["tree", "--offline", "--edges", "no-dev"]);
    cargo.current_dir(workspace().join("target/edits"));
    let output = cargo.output().expect("Cargo runs");
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{told}");
}
