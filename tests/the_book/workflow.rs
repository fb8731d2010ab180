//! The workflow that a teacher copies does, in a reader's workspace, what its page says.

use super::typed_book::typed_workspace;
use compare::{target_folder, workspace};
use std::fs;
use std::process::Command;

/// The text of the workflow.
fn workflow_text() -> String {
    let path = "book/reader/.github/workflows/pictures.yml";
    fs::read_to_string(workspace().join(path)).expect("a file of the course")
}

/// What stands behind a key such as `run`, in the order of the steps.
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

#[test]
#[ignore = "takes a minute: cargo test -- --include-ignored"]
fn workflow_draws_and_checks_five_pictures() {
    let (text, reader) = (workflow_text(), typed_workspace());
    for path in reader.picture_paths().expect("a folder") {
        fs::remove_file(path).expect("a picture can be removed");
    }
    let course = format!("\"{}\"/", workspace().display());
    let mut outputs = vec![];
    for command in values_of_key(&text, "run") {
        let mut bash = Command::new("bash");
        bash.args(["-e", "-c", &command.replace("course/", &course)]);
        bash.current_dir(&reader.folder);
        if command.starts_with("rustup") {
            continue;
        } else if command.contains("course/") {
            bash.env("CARGO_TARGET_DIR", target_folder());
        } else {
            let cargo = reader.cargo(&[]);
            bash.envs(
                cargo.get_envs().filter_map(|(name, text)| Some((name, text?))),
            );
            bash.env("CARGO_TARGET_DIR", "target");
        }
        let output = bash.output().expect("bash runs");
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{command}: {errors}");
        outputs.push(String::from_utf8_lossy(&output.stdout).into_owned());
    }
    let [_, report] = &outputs[..] else { panic!("{outputs:?}") };
    assert_eq!(report.matches(" right\n").count(), 5, "{report}");
    assert!(report.contains("5 of "), "{report}");
}
