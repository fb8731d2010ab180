//! A class that starts from `book/reader` locks its pictures, and the workflow there is green
//! for a picture that is drawn, but not for one that lies there.

use super::built_book::built_book;
use super::page_items::typed_files;
use super::reader_workspace::{folder_command, pages_of_step};
use anyhow::{Result, ensure};
use course::{locked_picture_path, target_folder, workspace};
use std::path::Path;
use std::process::{self, Output};
use std::{env, fs};

const WORKFLOW: &str = include_str!("../../book/reader/.github/workflows/classroom.yml");

/// The commands of the workflow that run Cargo, in their order; one may have several lines.
fn workflow_commands() -> Vec<String> {
    let steps = WORKFLOW.split("\n      - ").filter_map(|one| one.strip_prefix("run: "));
    let commands = steps.map(|step| {
        let lines = step.trim_start_matches("|\n").lines();
        let lines = lines.filter(|line| !line.starts_with("        if:"));
        lines.collect::<Vec<_>>().join("\n")
    });
    commands.filter(|command| command.contains("cargo")).collect()
}

/// Runs a command of bash in a folder, and gives what it prints; fails where the command does.
fn run(folder: &Path, command: &str) -> Result<String> {
    let course = format!("\"{}\"/", workspace().display());
    let lines = command.replace("course/", &course);
    let mut shell = folder_command(folder, &["bash", "-eo", "pipefail", "-c", &lines]);
    shell.env("REQUIRE", "step01_rays").env("GITHUB_STEP_SUMMARY", folder.join("summary.md"));
    // As the template has it.
    shell.env_remove("INSTA_WORKSPACE_ROOT");
    if command.contains("course/") {
        shell.env("CARGO_TARGET_DIR", target_folder());
        shell.env_remove("CARGO_BUILD_BUILD_DIR").env_remove("CARGO_INCREMENTAL");
    } else {
        // As nowhere else, so that Cargo takes none of the crates of another folder.
        shell.env("CARGO_PROFILE_DEV_OPT_LEVEL", "2");
    }
    let Output { status, stdout, stderr } = shell.output()?;
    let text = String::from_utf8_lossy(&[stdout, stderr].concat()).into_owned();
    ensure!(status.success(), "{command}: {text}");
    Ok(text)
}

const COMMIT: &str = "git add --all && \
    git -c user.name=Ada -c user.email=ada@example.org commit --quiet --message=work";

/// Makes a folder from the template, and types step 1 in it.
fn type_first_step(folder: &Path) -> Result<()> {
    fs::create_dir_all(folder)?;
    run(folder, "cp -R course/book/reader/. course/Cargo.lock .")?;
    let book = built_book();
    for (path, text) in typed_files(pages_of_step(book, "step01_rays")) {
        fs::create_dir_all(folder.join(path).with_file_name(""))?;
        fs::write(folder.join(path), text)?;
    }
    Ok(())
}

/// Runs all commands of the workflow on a clone of what is committed; fails where it is red.
fn run_workflow(folder: &Path) -> Result<String> {
    let job = folder.with_file_name("job");
    let _ = fs::remove_dir_all(&job);
    fs::create_dir_all(&job).expect("a folder");
    run(&job, "git clone --quiet ../ada student").expect("a clone");
    let commands = workflow_commands();
    assert_eq!(commands.len(), 3);
    let results: Vec<_> = commands.iter().map(|command| run(&job, command)).collect();
    results.into_iter().collect()
}

#[test]
#[ignore = "takes a minute: cargo test -- --include-ignored"]
fn workflow_is_green_for_a_picture_that_is_drawn() -> Result<()> {
    let class = env::temp_dir().join(format!("class-{}", process::id()));
    let folder = class.join("ada");
    type_first_step(&folder)?;
    run(&folder, "INSTA_UPDATE=always cargo test -p locked")?;
    run(&folder, &format!("git init --quiet && {COMMIT}"))?;
    let text = run_workflow(&folder)?;
    assert!(text.contains("::Points 1/1\n"), "{text}");
    run(&class.join("job/student"), "cargo test -p locked")?;
    // Nothing draws the picture, but it is there: committed, copied by a setting of Cargo, in a
    // folder of the name that the workflow draws in, and beside code that can't be compiled.
    fs::copy(locked_picture_path("step01_rays"), folder.join("step01_rays.png"))?;
    let attacks = [
        "echo 'fn main() {}' > steps/step01_rays/src/main.rs",
        r#"echo '[target."cfg(all())"]' >> .cargo/config.toml
           echo 'runner = ["sh", "-c", "cp ../student/step01_rays.png ."]' >> .cargo/config.toml"#,
        "mkdir drawn && cp step01_rays.png drawn",
        "echo 'half a line' > steps/step01_rays/src/ray.rs",
    ];
    for attack in attacks {
        run(&folder, &format!("{attack}\ngit add --force *.png && {COMMIT}"))?;
        assert!(run_workflow(&folder).is_err(), "{attack}");
    }
    Ok(fs::remove_dir_all(class)?)
}
