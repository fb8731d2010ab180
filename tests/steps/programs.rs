//! Tests that the programs of the five steps draw their pictures. The options are tested only in
//! step 1's program, because the five programs share the code for the options.

use course::{
    Step, cargo_command, describe_difference, read_locked_picture, target_folder, workspace,
};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::Once;
use std::{env, fs};

/// Arguments at the limits of what is allowed.
const ALLOWED: [&str; 7] = [
    "--width 8192 --aspect 1e9:1",
    "--width 8192 --aspect 16:9",
    "--width 2 --aspect 1:4 --fov 0.001",
    "--width 2 --samples 16 --fov 179.999",
    "--width 20 --output UPPER.PNG",
    "--width 20 --output .png",
    "--width 20 --output -dash.png",
];

/// Arguments with which a program prints a text instead of drawing. The texts are in a snapshot.
const REFUSED: [&str; 18] = [
    "--help",
    "--width 0",
    "--width -3",
    "--aspect 0:9",
    "--aspect 16",
    "--aspect 1:2:3",
    "--aspect -4:3",
    "--aspect 1\n\n2",
    "--aspect 1:4.1",
    "--aspect nan:1",
    "--width 8192 --aspect 16:9.01",
    "--fov 0",
    "--fov nan",
    "--samples 0",
    "--output old.jpg",
    "--output nowhere/a.png",
    "--output folder.png",
    "--output unwritable.png",
];

#[test]
fn programs_draw_the_locked_pictures() {
    for step in Step::NAMES {
        let (folder, file) = (create_empty_folder(step), format!("{step}.png"));
        fs::write(folder.join(&file), "old").expect("the file can be written");
        let Output { status, stdout, stderr } = run_program(step, &folder, "");
        let text = String::from_utf8_lossy(&stdout);
        let is_line = text.starts_with(&format!("{file}: 640×360 pixels in "));
        assert!(status.success() && stderr.is_empty() && is_line && text.lines().count() == 1);
        assert_eq!(fs::read_dir(&folder).expect("the folder can be read").count(), 1);
        let picture =
            image::open(folder.join(&file)).expect("the program has written a PNG file").to_rgb8();
        let locked = read_locked_picture(step).expect("the locked picture can be read");
        assert_eq!(describe_difference(&locked, &picture), None, "{file}");
    }
}

#[test]
fn program_accepts_the_limits_of_its_options() {
    let folder = create_empty_folder("limits");
    for arguments in ALLOWED {
        let output = run_program("step01_rays", &folder, arguments);
        assert!(output.status.success(), "{arguments}: {output:?}");
    }
}

#[test]
fn program_refuses_what_is_not_allowed_and_leaves_files_alone() {
    let folder = create_empty_folder("refused");
    let old_files = ["step01_rays.png", "old.jpg", "unwritable.png"].map(|file| folder.join(file));
    old_files.iter().for_each(|file| fs::write(file, "old").expect("the file can be written"));
    fs::create_dir(folder.join("folder.png")).expect("the folder can be created");
    // A program first writes its picture to a file `NAME.tmp`, so that the old picture survives if
    // writing fails. Here, writing fails, because `unwritable.tmp` is a folder.
    fs::create_dir(folder.join("unwritable.tmp")).expect("the folder can be created");
    let texts = REFUSED.map(|arguments| {
        let Output { status, stdout, stderr } = run_program("step01_rays", &folder, arguments);
        assert!(
            status.success() || stdout.is_empty(),
            "a program that fails prints nothing to stdout: {arguments}"
        );
        let text = String::from_utf8([stdout, stderr].concat()).expect("the program prints UTF-8");
        let code = status.code().unwrap_or(-1);
        format!("$ step01_rays {}\n{text}--- exit code {code} ---\n\n", arguments.escape_debug())
    });
    // Make the text the same on all systems. On Windows, the program's file name ends in .exe.
    // Every system words its errors differently.
    let text = texts.concat().replace("step01_rays.exe", "step01_rays");
    let lines = text.lines().map(|line| match line.rsplit_once(": ") {
        Some((start, reason)) if reason.ends_with(')') => format!("{start}: REASON\n"),
        _ => format!("{line}\n"),
    });
    insta::assert_snapshot!("program_texts", lines.collect::<String>());
    assert_eq!(fs::read_dir(&folder).expect("the folder can be read").count(), 5);
    assert!(old_files.iter().all(|file| fs::read(file).is_ok_and(|bytes| bytes == b"old")));
}

/// Creates an empty folder for a test.
fn create_empty_folder(test: &str) -> PathBuf {
    let folder = target_folder().join("tests/programs").join(test);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("the folder can be created");
    folder
}

/// Runs a step's program in `folder`. The `arguments` are separated by single spaces.
fn run_program(step: &str, folder: &Path, arguments: &str) -> Output {
    static BUILD: Once = Once::new();
    BUILD.call_once(build_programs);
    let executable = target_folder().join("debug").join(step);
    let mut command = Command::new(executable.with_extension(env::consts::EXE_EXTENSION));
    command.args(arguments.split(' ').filter(|argument| !argument.is_empty()));
    // The help text is wrapped to this width.
    command.current_dir(folder).env("COLUMNS", "100").output().expect("the program can be run")
}

/// Builds the programs, because `cargo test` doesn't build binaries from other packages.
///
/// With `--workspace`, Cargo builds the programs' dependencies with the same features as in other
/// builds of the workspace.
fn build_programs() {
    let mut cargo = cargo_command();
    cargo.args(["build", "--quiet", "--workspace", "--target-dir"]).arg(target_folder());
    cargo.args(Step::NAMES.iter().flat_map(|name| ["--bin", name]));
    let status = cargo.current_dir(workspace()).status();
    assert!(status.is_ok_and(|status| status.success()), "the programs do not compile");
}
