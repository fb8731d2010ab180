//! Tells whether a picture is right and, if it is not, what happened.

use gallery::{Answer, check, names};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, io, io::Write};

fn main() -> ExitCode {
    let arguments: Vec<_> = env::args_os().skip(1).collect();
    let words: Vec<_> =
        arguments.iter().map(|word| word.to_string_lossy()).collect();
    let words: Vec<&str> = words.iter().map(AsRef::as_ref).collect();
    let Answer { code, text } = match words[..] {
        ["-h" | "--help"] => Answer { code: 0, text: help() },
        _ if words.iter().any(|word| word.starts_with('-')) => refused(),
        [_] => check(Path::new(&arguments[0]), None, &folder()),
        [_, name] => check(Path::new(&arguments[0]), Some(name), &folder()),
        _ => refused(),
    };
    // Where nobody listens any more, there is nobody to tell.
    let _ = match code {
        2 => writeln!(io::stderr(), "{text}"),
        _ => writeln!(io::stdout(), "{text}"),
    };
    ExitCode::from(code)
}

fn help() -> String {
    format!(
        "Tells whether a picture is right and, if it is not, what happened.\n\n\
         Usage: cargo run --bin check -- FILE.png [NAME]\n\n\
         FILE.png  the picture to look at\n\
         NAME      the picture that it should be, by default the nearest: {}\n\n\
         The exit code is 0 if it is right, 1 if it is not, 2 if it can't be looked at.",
        names().join(", ")
    )
}

fn refused() -> Answer {
    let text = "error: allowed are one PNG file and one name, or the file alone; see --help";
    Answer { code: 2, text: text.to_owned() }
}

/// The folder for pictures of differences: this program runs from target/PROFILE.
fn folder() -> PathBuf {
    let program = env::current_exe().unwrap_or_default();
    program.ancestors().nth(2).unwrap_or(Path::new("target")).join("check")
}
