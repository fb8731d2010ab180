use crate::StepProgram;
use std::fs;

/// Invalid arguments; the exit code; parts of the message on standard error.
const INVALID_ARGUMENTS: &[(&str, i32, &[&str])] = &[
    ("--width 0", 2, &["--width", "'0'", "2..=8192"]),
    ("--width -3", 2, &["--width", "'-3'", "2..=8192"]),
    ("--aspect 0:9", 2, &["--aspect", "'0:9'", "above 0"]),
    ("--aspect 16", 2, &["--aspect", "'16'", "W:H"]),
    ("--aspect -4:3", 2, &["--aspect", "'-4:3'", "above 0"]),
    ("--aspect 1\n\n2", 2, &["--aspect", "'1\n\n2'", "W:H"]),
    ("--aspect 1:4.1", 2, &["--aspect", "'1:4.1'", "down to 1:4"]),
    ("--fov 0", 2, &["--fov", "'0'", "above 0 and below 180"]),
    ("--fov nan", 2, &["--fov", "'nan'", "above 0 and below 180"]),
    ("--samples 0", 2, &["--samples", "'0'", "1..=16"]),
    ("--output old.jpg", 2, &["--output", "'old.jpg'", ".png"]),
    ("--output nowhere/a.png", 1, &["'nowhere/a.png'", "can't write"]),
    ("--output folder.png", 1, &["can't write 'folder.png'"]),
];

/// Fails unless `program` rejects the arguments of the table, says why, and leaves every
/// file as it was.
///
/// The programs differ only in their picture: two rows are enough after step 1.
pub fn assert_rejects_invalid_arguments(program: &StepProgram) {
    let is_first = program.step == "step01_rays";
    let row_count = if is_first { INVALID_ARGUMENTS.len() } else { 2 };
    let default_output = format!("{}.png", program.step);
    let old_files = [default_output.as_str(), "old.jpg"];
    for file in old_files {
        fs::write(program.folder.join(file), "old").expect("a file");
    }
    for folder in ["folder", "folder.png"] {
        fs::create_dir(program.folder.join(folder)).expect("a folder");
    }
    let old_names = program.file_names();
    for &(arguments, exit_code, message_parts) in &INVALID_ARGUMENTS[..row_count] {
        let output = program.run(arguments);
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(exit_code), "{arguments}: {message}");
        assert!(output.stdout.is_empty(), "{arguments}");
        assert!(message.starts_with("error: "), "{arguments}: {message}");
        for part in message_parts {
            assert!(message.contains(part), "{arguments}: no {part:?}: {message}");
        }
        assert_eq!(program.file_names(), old_names, "{arguments}");
        for file in old_files {
            let content = fs::read(program.folder.join(file)).expect("a file");
            assert_eq!(content, b"old", "{arguments} changed {file}");
        }
    }
}
