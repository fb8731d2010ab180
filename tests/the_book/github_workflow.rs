//! Tests the workflow for a class whose students start from `book/reader`. The workflow has to pass
//! if a student's program draws the right picture, and to fail if the picture is committed but the
//! program doesn't draw it. The tests run the commands of the workflow's two jobs as GitHub does,
//! each job in its own folder.

use super::built_book::built_book;
use super::page_items::typed_files;
use super::reader_workspace::{command_in_reader_folder, pages_of_step};
use anyhow::{Result, ensure};
use course::{locked_picture_path, target_folder, workspace};
use std::path::Path;
use std::process::{self, Output};
use std::{env, fs};

const WORKFLOW: &str = include_str!("../../book/reader/.github/workflows/classroom.yml");

/// A command in a job.
struct JobCommand {
    lines: String,
    /// Whether the command runs only if an earlier command has failed.
    is_for_failure: bool,
}

/// The part of the workflow's text that defines a job.
fn job_text(job: &str) -> &'static str {
    let (_, text) =
        WORKFLOW.split_once(&format!("\n  {job}:\n")).expect("the workflow has this job");
    text.split_once("\n\n").map_or(text, |(text, _)| text)
}

/// Returns the commands of a job in order, without the command that updates Rust.
fn job_commands_without_rustup(job: &str) -> Vec<JobCommand> {
    let steps = job_text(job).split("\n      - ").skip(1);
    let command = |step: &str| {
        let (_, command) = step.split_once("run: ")?;
        // The lines of a multi-line command are indented further than the step's keys.
        let is_part = |k: usize, line: &str| k == 0 || line.starts_with("          ");
        let parts = command.lines().enumerate().take_while(|(k, line)| is_part(*k, line));
        let lines: Vec<_> = parts.map(|(_, line)| line).filter(|line| *line != "|").collect();
        let is_for_failure = step.contains("if: failure()");
        Some(JobCommand { lines: lines.join("\n"), is_for_failure })
    };
    let commands = steps.filter_map(command);
    commands.filter(|command| !command.lines.starts_with("rustup")).collect()
}

/// Runs a bash command in `folder`, with these environment variables. Returns what the command
/// prints, or an error if the command fails.
fn run_bash(folder: &Path, command: &str, variables: &[(&str, &str)]) -> Result<String> {
    let manifest = format!("--manifest-path '{}'/", workspace().display());
    let lines = command.replace("--manifest-path course/", &manifest);
    let mut shell = command_in_reader_folder(folder, &["bash", "-eo", "pipefail", "-c", &lines]);
    shell.env("GITHUB_STEP_SUMMARY", folder.join("summary.md"));
    shell.env("GITHUB_OUTPUT", folder.join("output.txt"));
    shell.envs(variables.iter().copied());
    if lines.contains(&manifest) {
        shell.env("CARGO_TARGET_DIR", target_folder());
        shell.env_remove("CARGO_BUILD_BUILD_DIR").env_remove("CARGO_INCREMENTAL");
    } else {
        // The build folder also contains our crates and the crates of other tests, with the same
        // names. None of these crates has this optimisation level, so Cargo won't reuse them here.
        shell.env("CARGO_PROFILE_DEV_OPT_LEVEL", "2");
    }
    let Output { status, stdout, stderr } = shell.output()?;
    let text = String::from_utf8_lossy(&[stdout, stderr].concat()).into_owned();
    ensure!(status.success(), "{command}: {text}");
    Ok(text)
}

const COMMIT: &str = "git add --all && \
    git -c user.name=Ada -c user.email=ada@example.org commit --quiet --message=work";

/// Creates a student's repository in `folder` from the template, with one commit.
fn create_student_repository(folder: &Path) -> Result<()> {
    fs::create_dir_all(folder)?;
    let course = workspace();
    let copy = "cp -R \"$COURSE\"/book/reader/. \"$COURSE\"/Cargo.lock .";
    run_bash(folder, copy, &[("COURSE", course.to_str().expect("the path is UTF-8"))])?;
    run_bash(folder, &format!("git init --quiet && {COMMIT}"), &[])?;
    Ok(())
}

/// Writes the files of step 1 into `folder`, as a reader types them.
fn type_first_step(folder: &Path) -> Result<()> {
    for (path, text) in typed_files(pages_of_step(built_book(), "step01_rays")) {
        fs::create_dir_all(folder.join(path).with_file_name(""))?;
        fs::write(folder.join(path), text)?;
    }
    Ok(())
}

/// Clones the student's repository, which is in `folder`, and runs both jobs on the clone.
/// Uncommitted changes aren't in the clone. `required` lists the pictures that the class requires.
/// Returns what the jobs print, or an error if the workflow fails.
fn run_workflow(folder: &Path, required: &str) -> Result<String> {
    let jobs = folder.with_file_name("jobs");
    let _ = fs::remove_dir_all(&jobs);
    let (draw, grade) = (jobs.join("draw"), jobs.join("grade"));
    fs::create_dir_all(draw.join("course")).expect("the folder can be created");
    fs::create_dir_all(grade.join("class/drawn")).expect("the folder can be created");
    let repository = folder.to_str().expect("the path is UTF-8");
    run_bash(&draw, "git clone --quiet \"$REPOSITORY\" student", &[("REPOSITORY", repository)])
        .expect("the repository can be cloned");
    // Give the job its own copy of the course's steps. A student's program could overwrite the
    // files in the job's folder `course`, and the real steps must stay as they are.
    let course = workspace();
    let copy = "cp -R \"$COURSE\"/steps course";
    run_bash(&draw, copy, &[("COURSE", course.to_str().expect("the path is UTF-8"))])
        .expect("the steps can be copied");
    let mut text = String::new();
    let mut steps = String::new();
    for command in job_commands_without_rustup("draw") {
        text += &run_bash(&draw, &command.lines, &[("STEPS", &steps)])
            .expect("the job \"draw\" succeeds");
        let output =
            fs::read_to_string(draw.join("output.txt")).expect("the job writes its output");
        steps =
            output.trim().strip_prefix("steps=").expect("the output lists the steps").to_owned();
    }
    for picture in fs::read_dir(draw.join("drawn")).expect("the folder can be read").flatten() {
        let name = picture.file_name();
        if name.to_string_lossy().starts_with("step0") {
            fs::copy(picture.path(), grade.join("class/drawn").join(name))
                .expect("the picture can be copied");
        }
    }
    let mut result = Ok(());
    for command in job_commands_without_rustup("grade") {
        if command.is_for_failure == result.is_err() {
            let variables = [("STEPS", &*steps), ("REQUIRE", required)];
            match run_bash(&grade, &command.lines, &variables) {
                Ok(output) => text += &output,
                Err(error) => result = Err(error),
            }
        }
    }
    result.map(|()| text)
}

/// Renames a folder in which the crate `locked` has been compiled, runs that crate's tests, and
/// renames the folder back.
fn test_locked_crate_in_renamed_folder(folder: &Path) -> Result<()> {
    let renamed = folder.with_file_name("renamed");
    fs::rename(folder, &renamed)?;
    run_bash(&renamed, "cargo test -p locked", &[])?;
    ensure!(!folder.exists(), "testing the renamed folder has created the old folder again");
    Ok(fs::rename(renamed, folder)?)
}

#[test]
fn grade_job_gets_only_pictures_from_the_student() {
    let grade = job_text("grade");
    for word in ["path: student", "cache@", "github.event", "by_hand"] {
        assert!(!grade.contains(word), "the job \"grade\" contains {word}");
    }
    assert!(grade.contains("pattern: pictures"));
    assert_eq!(job_commands_without_rustup("draw").len(), 3);
    assert_eq!(job_commands_without_rustup("grade").len(), 2);
}

#[test]
#[cfg(unix)]
#[ignore = "takes minutes: cargo test -- --include-ignored"]
fn workflow_passes_only_if_a_program_draws_the_picture() -> Result<()> {
    let class = env::temp_dir().join(format!("class-{}", process::id()));
    let folder = class.join("ada");
    create_student_repository(&folder)?;
    let text = run_workflow(&folder, "step01_rays,step02_sphere")?;
    assert!(text.contains("No step is there yet"), "{text}");
    type_first_step(&folder)?;
    run_bash(&folder, "INSTA_UPDATE=always cargo test -p locked", &[])?;
    run_bash(&folder, COMMIT, &[])?;
    test_locked_crate_in_renamed_folder(&folder)?;
    let text = run_workflow(&folder, "step01_rays")?;
    assert!(text.contains("::Points 1/1\n"), "{text}");
    assert!(text.contains("test result: ok"), "{text}");
    assert!(run_workflow(&folder, "")?.contains("Nothing is required"));
    assert!(run_workflow(&folder, "step01_rays, step02_sphere").is_err());
    run_bash(&class.join("jobs/draw/student"), "cargo test -p locked", &[])?;
    // In each of these attacks, the correct picture is committed, but the student's program doesn't
    // draw it:
    //
    // - The program does nothing.
    // - A Cargo setting makes `cargo run` copy the committed picture.
    // - The picture is committed in a folder with the same name as the folder in which the workflow
    //   draws.
    // - The program draws a wrong picture, and overwrites the locked picture in the course's folder
    //   with this wrong picture.
    // - The code doesn't compile.
    fs::copy(locked_picture_path("step01_rays"), folder.join("step01_rays.png"))?;
    fs::copy(locked_picture_path("step02_sphere"), folder.join("wrong.png"))?;
    let attacks = [
        "echo 'fn main() {}' > steps/step01_rays/src/main.rs",
        r#"mkdir .cargo && echo '[target."cfg(all())"]' > .cargo/config.toml
           echo 'runner = ["sh", "-c", "cp ../student/step01_rays.png ."]' >> .cargo/config.toml"#,
        "mkdir drawn && cp step01_rays.png drawn",
        r#"{ echo 'fn main() {'
             echo 'std::fs::copy("../student/wrong.png", "step01_rays.png").unwrap();'
             echo 'std::fs::create_dir_all("../course/tests/snapshots").unwrap();'
             echo 'let locked = "../course/tests/snapshots/step01_rays.snap.png";'
             echo 'std::fs::copy("../student/wrong.png", locked).unwrap();'
             echo '}'; } > steps/step01_rays/src/main.rs"#,
        "echo 'half a line' > steps/step01_rays/src/ray.rs",
    ];
    for attack in attacks {
        run_bash(&folder, &format!("{attack}\ngit add --force *.png && {COMMIT}"), &[])?;
        assert!(run_workflow(&folder, "step01_rays").is_err(), "{attack}");
    }
    Ok(fs::remove_dir_all(class)?)
}
