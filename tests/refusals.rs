use crate::Program;
use std::fs;

/// Bad arguments; the exit code; what the message on standard error must hold.
const BAD: &[(&str, i32, &[&str])] = &[
    ("--width 0", 2, &["--width", "'0'", "2..=8192"]),
    ("--width -3", 2, &["--width", "'-3'", "2..=8192"]),
    ("--width abc", 2, &["--width", "'abc'", "digit"]),
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
    ("--colour red", 2, &["--colour", "--help"]),
    ("picture.png", 2, &["picture.png", "--help"]),
];

/// Fails unless `program` refuses the lines of the table, says why, and leaves every file
/// as it was. All programs are the same but for their picture: two lines are enough for
/// those after the first.
pub fn assert_refuses(program: &Program) {
    let count = if program.name == "step01_rays" { BAD.len() } else { 2 };
    let own = format!("{}.png", program.name);
    let old = [own.as_str(), "old.jpg"];
    for file in old {
        fs::write(program.folder.join(file), "old").expect("a file");
    }
    for folder in ["folder", "folder.png"] {
        fs::create_dir(program.folder.join(folder)).expect("a folder");
    }
    let before = program.files();
    for &(line, code, words) in &BAD[..count] {
        let output = program.run(line);
        let text = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{line}: {text}");
        assert!(output.stdout.is_empty(), "{line}");
        assert!(text.starts_with("error: "), "{line}: {text}");
        for word in words {
            assert!(text.contains(word), "{line}: no {word:?} in: {text}");
        }
        assert_eq!(program.files(), before, "{line}");
        for file in old {
            let content = fs::read(program.folder.join(file)).expect("a file");
            assert_eq!(content, b"old", "{line} changed {file}");
        }
    }
}
