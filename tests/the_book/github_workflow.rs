//! The workflow that a teacher copies does, in a reader's workspace, what its page says.

use super::support::reader_workspace::ReaderWorkspace;
use super::typed_book::typed_workspace;
use course::{target_folder, workspace};
use std::fs;
use std::process::Command;

/// The text of the workflow.
fn workflow_text() -> String {
    let path = "book/reader/.github/workflows/pictures.yml";
    fs::read_to_string(workspace().join(path)).expect("a file of the course")
}

/// The values of a key such as `run`, in the order of the workflow.
fn values_of_key<'a>(text: &'a str, key: &str) -> Vec<&'a str> {
    let start = format!("- {key}: ");
    text.lines().filter_map(|line| line.trim().strip_prefix(&*start)).collect()
}

#[test]
fn actions_are_those_of_the_course() {
    let ours = fs::read_to_string(workspace().join(".github/workflows/ci.yml"));
    let ours = ours.expect("a file of the course");
    let ours = values_of_key(&ours, "uses");
    let text = workflow_text();
    let actions = values_of_key(&text, "uses");
    assert_eq!(actions.len(), 2);
    assert!(actions.iter().all(|action| ours.contains(action)), "{actions:?}");
}

/// The commands of the workflow, in their order; one may have several lines.
fn workflow_commands() -> Vec<String> {
    let text = workflow_text();
    let steps = text.split("\n      - ").filter_map(|one| one.strip_prefix("run: "));
    let command = |step: &str| match step.strip_prefix("|\n") {
        Some(lines) => lines.to_owned(),
        None => step.lines().next().unwrap_or_default().to_owned(),
    };
    steps.map(command).collect()
}

/// Runs a command of the workflow in a reader's workspace; whether it succeeds, and what
/// it prints.
fn run_command(reader: &ReaderWorkspace, command: &str) -> (bool, String) {
    let mut bash = Command::new("bash");
    let course = format!("\"{}\"/", workspace().display());
    bash.args(["-e", "-c", &command.replace("course/", &course)]);
    bash.current_dir(&reader.folder);
    if command.contains("course/") {
        bash.env("CARGO_TARGET_DIR", target_folder());
    } else {
        let cargo = reader.cargo(&[]);
        bash.envs(cargo.get_envs().filter_map(|(name, text)| Some((name, text?))));
        bash.env("CARGO_TARGET_DIR", "target");
    }
    let output = bash.output().expect("bash runs");
    let text = [output.stdout, output.stderr].concat();
    (output.status.success(), String::from_utf8_lossy(&text).into_owned())
}

#[test]
#[ignore = "takes a minute: cargo test -- --include-ignored"]
fn workflow_draws_and_checks_five_pictures() {
    let (commands, reader) = (workflow_commands(), typed_workspace());
    let [_, draw, check] = &commands[..] else { panic!("{commands:?}") };
    // A picture that nobody draws, and is right.
    let glass = workspace().join("tests/snapshots/glass.snap.png");
    fs::copy(glass, reader.folder.join("glass.png")).expect("a copy");
    let (is_drawn, text) = run_command(&reader, draw);
    assert!(is_drawn, "{text}");
    let (is_right, report) = run_command(&reader, check);
    assert!(is_right && report.matches(" right\n").count() == 5, "{report}");
    // A step that does not compile, and those before it.
    let path = "steps/step05_phong/src/picture.rs";
    reader.write_if_changed(path, "half a line").expect("a file");
    let (is_drawn, text) = run_command(&reader, draw);
    assert!(!is_drawn, "{text}");
    assert!(workflow_text().contains(&format!("{check}\n        if: always()\n")));
    let (is_right, report) = run_command(&reader, check);
    assert!(is_right && report.matches(" right\n").count() == 4, "{report}");
}
