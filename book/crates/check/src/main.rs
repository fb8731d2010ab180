//! Tells whether a picture is right and, if it is not, what happened.

use check::{
    Answer, Verdict, check_png, check_scene_png, escape_for_terminal, format_sheet, normalize_name,
    read_bounded_file, read_names, report_on_folder, report_on_workspaces, run_on_threads,
    write_sheets,
};
use clap::Parser;
use clap::builder::{NonEmptyStringValueParser, PossibleValuesParser, TypedValueParser};
use course::{NAMED_SCENE_EXAMPLE, locked_names, read_locked_picture};
use image::RgbImage;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::{env, process::ExitCode};

/// Tells whether a picture is right and, if it is not, what happened.
///
/// Without a file, it looks for the pictures of the course, and says which are
/// right.
///
/// The exit code is 0 if all is right, 1 if not, 2 if there is nothing to look at.
#[derive(Parser)]
#[command(name = "check", after_help = format!("Names: {}", locked_names().join(", ")))]
struct Arguments {
    /// The picture to look at, a PNG file
    file: Option<PathBuf>,
    /// The expected picture (default: the one that the file name tells)
    #[arg(value_parser = PossibleValuesParser::new(locked_names()), hide_possible_values = true)]
    name: Option<String>,
    /// The folder to look in for pictures of the course; or what a class has handed in, as
    /// Moodle, Canvas or GitHub gives it, unpacked or a ZIP archive
    #[arg(long = "in", value_name = "FOLDER", conflicts_with = "file")]
    folder: Option<PathBuf>,
    /// Prints the sheet of a name: the numbers of the scene that belongs to it, and problems on
    /// paper. With a file, tells whether it is this scene. With --in, draws the scene with the
    /// five crates of each workspace in the folder and compares it: what is in these crates runs
    /// as you, so do that in a container
    #[arg(long, value_name = "NAME", group = "sheet", conflicts_with = "name")]
    #[arg(value_parser = NonEmptyStringValueParser::new().map(|name| normalize_name(&name)))]
    scene: Option<String>,
    /// A class's list of names, one a line. With --out, writes the sheet of each; with --in,
    /// gives those who handed in nothing a row, and each name as Canvas joins it its scene
    #[arg(long, value_name = "FILE", group = "sheet", conflicts_with = "file")]
    names: Option<PathBuf>,
    /// The folder to write sheets into, in UTF-8, each as its name and .md
    #[arg(long, value_name = "FOLDER", requires = "sheet", conflicts_with_all = ["file", "folder"])]
    out: Option<PathBuf>,
    /// Writes the answers to the problems as well
    #[arg(long, requires = "out")]
    answers: bool,
    /// The pictures that are asked for, with commas between them; `scene` is the scene of the
    /// student's name
    #[arg(long, value_name = "NAMES", conflicts_with_all = ["file", "scene"])]
    #[arg(value_delimiter = ',', value_parser = parse_picture_name)]
    require: Vec<&'static str>,
    /// Prints the rows of the report as CSV, for a spreadsheet
    #[arg(long, requires = "folder", conflicts_with_all = ["file", "json"])]
    csv: bool,
    /// Prints JSON
    #[arg(long)]
    json: bool,
}

fn parse_picture_name(text: &str) -> Result<&'static str, String> {
    let name = if text == "scene" { NAMED_SCENE_EXAMPLE } else { text };
    let picture = locked_names().into_iter().chain([NAMED_SCENE_EXAMPLE]).find(|one| *one == name);
    picture.ok_or_else(|| "allowed are scene and the names below `check --help`".to_owned())
}

fn main() -> ExitCode {
    let is_json = env::args_os().any(|argument| argument == "--json");
    let arguments = match Arguments::try_parse() {
        Err(error) if is_json && error.use_stderr() => {
            let text = error.to_string();
            return print(&Answer::error(text.trim_start_matches("error: ").trim_end()), true);
        }
        arguments => arguments.unwrap_or_else(|error| error.exit()),
    };
    let as_json = arguments.json;
    let answer = run_on_threads(|| answer(arguments).unwrap_or_else(Answer::error));
    print(&answer, as_json)
}

fn answer(arguments: Arguments) -> Result<Answer, String> {
    let mut names = arguments.names.as_deref().map_or(Ok(vec![]), read_names)?;
    match arguments {
        Arguments { file: Some(file), name, scene, .. } => {
            check_file(&file, name.as_deref(), scene.as_deref())
        }
        Arguments { scene, out: Some(folder), answers, .. } => {
            names.extend(scene);
            write_sheets(&names, answers, &folder).map(sheet_answer)
        }
        Arguments { scene: Some(scene), folder: Some(folder), csv, .. } => {
            report_on_workspaces(&folder, &scene, csv)
        }
        Arguments { scene: Some(scene), .. } => Ok(sheet_answer(format_sheet(&scene, false))),
        Arguments { folder, require, csv, .. } => {
            let folder = folder.unwrap_or_else(|| ".".into());
            report_on_folder(&folder, &names, &require, csv)
        }
    }
}

fn sheet_answer(text: String) -> Answer {
    Answer::new(Verdict::Right, text)
}

/// Prints an answer, as JSON where that is asked for; gives its exit code.
fn print(answer: &Answer, as_json: bool) -> ExitCode {
    // Write errors are ignored: the output may be a closed pipe.
    let _ = match answer.verdict {
        _ if as_json => writeln!(io::stdout(), "{}", answer.to_json()),
        Verdict::Unreadable => writeln!(io::stderr(), "error: {}", answer.text),
        _ => writeln!(io::stdout(), "{}", answer.text.trim_end()),
    };
    ExitCode::from(answer.verdict.exit_code())
}

/// Looks at one picture, and saves the difference.
fn check_file(file: &Path, name: Option<&str>, scene: Option<&str>) -> Result<Answer, String> {
    let (png, file_name) = (read_bounded_file(file)?, file.display().to_string());
    let mut answer = match scene {
        Some(scene) => check_scene_png(&png, &file_name, scene, &[]),
        None => check_png(&png, &file_name, name, read_locked_picture),
    };
    if let Some(difference) = answer.draw_difference() {
        answer.text += &format!("\n{}", save_difference(&difference, file));
    }
    Ok(answer)
}

/// Writes the picture of a difference into the target folder, and tells where it is.
fn save_difference(difference: &RgbImage, file: &Path) -> String {
    let folder = course::target_folder().join("check");
    let path = folder.join(file.with_extension("difference.png").file_name().unwrap_or_default());
    let result = fs::create_dir_all(folder)
        .and_then(|()| course::replace_file(&path, &course::encode_png(difference)));
    let path = escape_for_terminal(&path.display().to_string());
    match result {
        Ok(()) => format!("Yours, ours and the difference, side by side: {path}"),
        Err(error) => format!("{path} can't be written: {error}"),
    }
}
