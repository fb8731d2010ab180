use crate::step_program::StepProgram;
use course::{Step, describe_difference};
use std::fs;
use tests::read_snapshot;

/// Arguments with which a program draws nothing: what it prints is locked.
const ARGUMENTS: [&str; 14] = [
    "--help",
    "--width 0",
    "--width -3",
    "--aspect 0:9",
    "--aspect 16",
    "--aspect -4:3",
    "--aspect 1\n\n2",
    "--aspect 1:4.1",
    "--fov 0",
    "--fov nan",
    "--samples 0",
    "--output old.jpg",
    "--output nowhere/a.png",
    "--output folder.png",
];

#[test]
fn programs_draw_the_locked_pictures_and_reject_invalid_arguments() {
    Step::NAMES.into_iter().for_each(assert_program_works);
}

/// Fails unless the program of `step` writes the locked picture over an old file and nothing
/// else, and prints what all five print for `ARGUMENTS`, leaving every file as it was.
fn assert_program_works(step: &'static str) {
    let (program, file) = (StepProgram::new(step, "draws"), format!("{step}.png"));
    fs::write(program.folder.join(&file), "old").expect("a file");
    let output = program.run("");
    let text = String::from_utf8_lossy(&output.stdout);
    let is_line = text.starts_with(&format!("{file}: 640×360 pixels in ")) && text.ends_with("s\n");
    assert!(output.status.success() && output.stderr.is_empty() && is_line, "{output:?}");
    assert_eq!(program.file_names(), [&file[..]]);
    let picture = image::open(program.folder.join(&file)).expect("a PNG").to_rgb8();
    assert_eq!(describe_difference(&read_snapshot(step), &picture), None, "{file}");

    for file in [&file, "old.jpg"] {
        fs::write(program.folder.join(file), "old").expect("a file");
    }
    fs::create_dir(program.folder.join("folder.png")).expect("a folder");
    let texts = ARGUMENTS.map(|arguments| format_output(&program, arguments));
    insta::assert_snapshot!("program_texts", texts.concat());
    assert_eq!(program.file_names(), ["folder.png", "old.jpg", &file]);
    for file in [&file, "old.jpg"] {
        assert_eq!(fs::read(program.folder.join(file)).expect("a file"), b"old", "{file}");
    }
}

/// Runs a program: its exit code and what it prints, but for its name and the system's words.
fn format_output(program: &StepProgram, arguments: &str) -> String {
    let output = program.run(arguments);
    let texts = [("stdout", output.stdout), ("stderr", output.stderr)].map(|(stream, bytes)| {
        let text = String::from_utf8(bytes).expect("UTF-8").replace(program.step, "PROGRAM");
        let lines = text.lines().map(|line| match line.rsplit_once(": ") {
            Some((start, reason)) if reason.ends_with(')') && start.starts_with("error") => {
                format!("{start}: REASON\n")
            }
            _ => format!("{line}\n"),
        });
        let text: String = lines.collect();
        if text.is_empty() { text } else { format!("--- {stream} ---\n{text}") }
    });
    let exit_code = output.status.code().unwrap_or(-1);
    let text = texts.concat().replace("PROGRAM.exe", "PROGRAM");
    format!("$ PROGRAM {}\n{text}--- exit code {exit_code} ---\n\n", arguments.escape_debug())
}
