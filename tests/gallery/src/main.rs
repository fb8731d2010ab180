//! Tells whether a picture is right and, if it is not, what happened.

use gallery::{Answer, check, names};
use image::RgbImage;
use std::path::Path;
use std::process::ExitCode;
use std::{env, fs, io, io::Write};

fn main() -> ExitCode {
    let arguments: Vec<_> = env::args_os().skip(1).collect();
    let words: Vec<_> =
        arguments.iter().map(|word| word.to_string_lossy()).collect();
    let words: Vec<&str> = words.iter().map(AsRef::as_ref).collect();
    let Answer { code, mut text, difference } = match words[..] {
        ["-h" | "--help"] => Answer::new(0, help()),
        _ if words.iter().any(|word| word.starts_with('-')) => refused(),
        [_] => check(Path::new(&arguments[0]), None),
        [_, name] => check(Path::new(&arguments[0]), Some(name)),
        _ => refused(),
    };
    if let Some(difference) = difference {
        text += &format!("\n{}", saved(&difference, Path::new(&arguments[0])));
    }
    // Where nobody listens any more, there is nobody to tell.
    let _ = match code {
        2 => writeln!(io::stderr(), "{text}"),
        _ => writeln!(io::stdout(), "{text}"),
    };
    ExitCode::from(code)
}

/// Writes the picture of a difference into the target folder, from which this program
/// runs, under the name of the reader's, and tells where it is.
fn saved(difference: &RgbImage, file: &Path) -> String {
    let program = env::current_exe().unwrap_or_default();
    let folder = program.ancestors().nth(2).unwrap_or(Path::new("target"));
    let path = folder.join("check").join(file.file_name().unwrap_or_default());
    let path = path.with_extension("difference.png");
    let saved = fs::create_dir_all(folder.join("check"))
        .map_err(Into::into)
        .and_then(|()| difference.save(&path));
    let path = path.display();
    match saved {
        Ok(()) => format!("Yours, ours and the difference side by side: {path}"),
        Err(error) => format!("{path} can't be written: {error}"),
    }
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
    Answer::new(2, text.to_owned())
}
