//! Tells whether a picture is right and, if it is not, what happened.

use check::{
    Answer, Locked, check_named_scene, check_png, escape_for_terminal, read_bounded_file,
    report_on_folder_or_class,
};
use clap::Parser;
use course::locked_names;
use image::RgbImage;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::{env, process::ExitCode};

/// Tells whether a picture is right and, if it is not, what happened.
///
/// Without a file, it looks for every picture of the course, and says of each whether it
/// is right.
///
/// The exit code is 0 if all is right, 1 if not, 2 if there is nothing to look at.
#[derive(Parser)]
#[command(name = "check", after_help = format!("Names: {}", locked_names().join(", ")))]
struct Arguments {
    /// The picture to look at, a PNG file
    file: Option<PathBuf>,
    /// The picture that it should be, by default as the file is called, or the nearest
    name: Option<String>,
    /// Where to look for every picture of the course; or a folder with one of them for
    /// each student, who gets one line
    #[arg(long = "in", value_name = "FOLDER", default_value = ".")]
    #[arg(conflicts_with = "file")]
    folder: PathBuf,
    /// Prints the program of the scene that belongs to a name; with a file, tells
    /// whether it is what the program draws
    #[arg(long, value_name = "NAME", conflicts_with_all = ["name", "folder", "json"])]
    #[arg(value_parser = parse_scene_name)]
    scene: Option<String>,
    /// Tells all of a folder as JSON
    #[arg(long, conflicts_with = "file")]
    json: bool,
}

/// The name, if it is more than blanks.
fn parse_scene_name(text: &str) -> Result<String, &'static str> {
    match text.trim() {
        "" => Err("a name is more than blanks"),
        _ => Ok(text.to_owned()),
    }
}

fn main() -> ExitCode {
    let Arguments { file, name, folder, scene, json } = Arguments::parse();
    let result = match (scene, file) {
        (Some(scene), Some(file)) => check_named_scene(&scene, &file),
        (Some(scene), None) => {
            let (program, _) = course::draw_named_scene(&scene);
            Ok(Answer::new(0, program))
        }
        (None, None) => {
            Locked::read_verified().and_then(|locked| check_folder(&folder, &locked, json))
        }
        (None, Some(file)) => {
            Locked::read_verified().and_then(|locked| check_file(&file, name.as_deref(), &locked))
        }
    };
    let Answer { code, text, .. } =
        result.unwrap_or_else(|what| Answer::new(2, format!("error: {what}")));
    // Write errors are ignored: the output may be a closed pipe.
    let _ = match code {
        2 if !json => writeln!(io::stderr(), "{text}"),
        _ => writeln!(io::stdout(), "{text}"),
    };
    ExitCode::from(code)
}

/// Looks at every picture of the course in a folder.
fn check_folder(folder: &Path, locked: &[Locked], json: bool) -> Result<Answer, String> {
    if !folder.is_dir() {
        let printable_path = escape_for_terminal(&folder.display().to_string());
        return Err(format!("{printable_path} is not a folder"));
    }
    Ok(report_on_folder_or_class(folder, locked, json))
}

/// Looks at one picture, and saves the difference.
fn check_file(file: &Path, name: Option<&str>, locked: &[Locked]) -> Result<Answer, String> {
    let png = read_bounded_file(file)?;
    let mut answer = check_png(&png, &file.display().to_string(), name, locked);
    if let Some(difference) = &answer.difference {
        answer.text += &format!("\n{}", save_difference(difference, file));
    }
    Ok(answer)
}

/// Writes the picture of a difference into the target folder, from which this program
/// runs, under the name of the reader's, and tells where it is.
fn save_difference(difference: &RgbImage, file: &Path) -> String {
    let program = env::current_exe().unwrap_or_default();
    let folder = program.ancestors().nth(2).unwrap_or(Path::new("target"));
    let path = folder.join("check").join(file.file_name().unwrap_or_default());
    let path = path.with_extension("difference.png");
    let result = fs::create_dir_all(folder.join("check"))
        .map_err(Into::into)
        .and_then(|()| difference.save(&path));
    let path = escape_for_terminal(&path.display().to_string());
    match result {
        Ok(()) => format!(
            "Yours, ours and the difference (orange where yours is brighter, else \
             blue), side by side: {path}"
        ),
        Err(error) => format!("{path} can't be written: {error}"),
    }
}
