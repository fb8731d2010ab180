//! The program `check`: its options, what it prints, and its exit code.

use check::{
    Answer, Verdict, check_png, check_scene_png, escape_for_terminal, format_sheet, normalize_name,
    read_bounded_file, read_names, report_on_class, report_on_own_pictures, run_on_threads,
    write_sheets,
};
use clap::builder::{NonEmptyStringValueParser, PossibleValuesParser, TypedValueParser};
use clap::{ArgGroup, Parser};
use course::{json, locked_names, read_locked_picture};
use image::RgbImage;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

/// Tells whether a picture is right and, if it is not, what happened.
///
/// Without a file, it looks for the pictures of the course in the current folder,
/// and says which are right.
///
/// The exit code is 0 if all is right, 1 if something is wrong, and 2 if something
/// is missing, unreadable or, in the folder of a class, not looked at.
#[derive(Parser)]
#[command(name = "check", after_help = format!("Names: {}", locked_names().join(", ")))]
#[command(group = ArgGroup::new("use_of_names").args(["folder", "out"]))]
struct Arguments {
    /// The picture to look at, a PNG file
    file: Option<PathBuf>,
    /// The expected picture (default: the one that the file name tells)
    #[arg(value_parser = locked_name_parser(), hide_possible_values = true)]
    name: Option<String>,
    /// What a class has handed in: each folder in this one is a student's, with whatever is in
    /// it and below
    #[arg(long = "in", value_name = "FOLDER", conflicts_with = "file")]
    folder: Option<PathBuf>,
    /// Prints the sheet of a name: the numbers of the scene that belongs to it, and problems on
    /// paper. With a file, tells whether it is this scene
    #[arg(long, value_name = "NAME", group = "sheet", conflicts_with_all = ["name", "folder"])]
    #[arg(value_parser = NonEmptyStringValueParser::new().map(|name| normalize_name(&name)))]
    scene: Option<String>,
    /// A class's list of names, one a line. With --out, writes the sheet of each. With --in, a
    /// line is the whole name of a student's folder, and the report says which folders are
    /// missing
    #[arg(long, value_name = "FILE", group = "sheet", requires = "use_of_names")]
    #[arg(conflicts_with_all = ["file", "scene"])]
    names: Option<PathBuf>,
    /// The folder to write sheets into, which doesn't exist yet: each as its name and .md, and
    /// all as sheets.html, to be printed
    #[arg(long, value_name = "FOLDER", requires = "sheet", conflicts_with_all = ["file", "folder"])]
    out: Option<PathBuf>,
    /// Writes the answers to the problems as well, as answers.html
    #[arg(long, requires = "out")]
    answers: bool,
    /// A word that chooses another scene for each name, and that no sheet shows
    #[arg(long, value_name = "WORD", requires = "sheet", conflicts_with_all = ["file", "folder"])]
    #[arg(value_parser = NonEmptyStringValueParser::new().map(|word| normalize_name(&word)))]
    secret: Option<String>,
    /// The pictures that count, with commas between them (default: all that are there)
    #[arg(long, value_name = "NAMES", conflicts_with_all = ["file", "scene", "out"])]
    #[arg(value_delimiter = ',', value_parser = locked_name_parser(), hide_possible_values = true)]
    require: Vec<String>,
    /// Prints the report on a class as CSV, for a spreadsheet
    #[arg(long, requires = "folder", conflicts_with_all = ["json", "scene", "out"])]
    csv: bool,
    /// Prints JSON
    #[arg(long)]
    json: bool,
}

fn locked_name_parser() -> PossibleValuesParser {
    PossibleValuesParser::new(locked_names())
}

/// What is printed if all goes well, and the exit code.
struct Output {
    text: String,
    /// The same as JSON.
    json: String,
    exit_code: u8,
}

fn main() -> ExitCode {
    let is_json = env::args_os().any(|argument| argument == "--json");
    let arguments = match Arguments::try_parse() {
        Err(error) if error.use_stderr() => {
            let text = error.to_string();
            let lines: Vec<_> = text.trim_end().lines().map(escape_for_terminal).collect();
            if is_json {
                return print(Err(lines.join("\n")), true);
            }
            let _ = writeln!(io::stderr(), "{}", lines.join("\n"));
            return ExitCode::from(2);
        }
        arguments => arguments.unwrap_or_else(|error| error.exit()),
    };
    let as_json = arguments.json;
    print(run_on_threads(|| run(arguments)), as_json)
}

fn run(arguments: Arguments) -> Result<Output, String> {
    let names = arguments.names.as_deref().map(read_names).transpose()?;
    let Arguments { file, name, folder, scene, out, answers, secret, require, csv, .. } = arguments;
    let required = required_names(&require);
    let secret = secret.as_deref();
    if let Some(file) = file {
        let answer = check_file(&file, name.as_deref(), scene.as_deref())?;
        let (json, exit_code) = (answer.to_json(), answer.verdict.exit_code());
        Ok(Output { text: answer.text, json, exit_code })
    } else if let Some(folder) = out {
        let names = names.or(scene.map(|scene| vec![scene])).unwrap_or_default();
        write_sheets(&names, secret, answers, &folder).map(plain_output)
    } else if let Some(scene) = scene {
        Ok(plain_output(format_sheet(&scene, secret)))
    } else if let Some(folder) = folder {
        let report = report_on_class(&folder, names.as_deref(), &required)?;
        let text = if csv { report.to_csv() } else { report.to_table() };
        Ok(Output { text, json: report.to_json(), exit_code: report.exit_code() })
    } else {
        let report = report_on_own_pictures(Path::new("."), &required)?;
        let exit_code = report.exit_code();
        Ok(Output { text: report.to_table(), json: report.to_json(), exit_code })
    }
}

/// The names of locked pictures that the option `--require` has.
fn required_names(require: &[String]) -> Vec<&'static str> {
    locked_names().into_iter().filter(|name| require.iter().any(|one| one == name)).collect()
}

/// The output of what prints a text and compares nothing.
fn plain_output(text: String) -> Output {
    let json = json::object([("text", json::quote(&text))]);
    Output { text, json, exit_code: 0 }
}

/// Prints an output or an error, as JSON if that is asked for. Returns the exit code.
fn print(output: Result<Output, String>, as_json: bool) -> ExitCode {
    // Write errors are ignored: the output may be a closed pipe.
    let (_, exit_code) = match output {
        Ok(output) if as_json => (writeln!(io::stdout(), "{}", output.json), output.exit_code),
        Ok(output) => (writeln!(io::stdout(), "{}", output.text.trim_end()), output.exit_code),
        Err(why) if as_json => (writeln!(io::stdout(), "{}", Answer::error(why).to_json()), 2),
        Err(why) => (writeln!(io::stderr(), "error: {why}"), 2),
    };
    ExitCode::from(exit_code)
}

/// Looks at one picture, and saves the difference.
fn check_file(file: &Path, name: Option<&str>, scene: Option<&str>) -> Result<Answer, String> {
    let (png, file_name) = (read_bounded_file(file)?, file.display().to_string());
    let mut answer = match scene {
        Some(scene) => check_scene_png(&png, &file_name, scene),
        None => check_png(&png, &file_name, name, read_locked_picture),
    };
    if answer.verdict == Verdict::Unreadable {
        return Err(answer.text);
    }
    if let Some(difference) = answer.draw_difference() {
        answer.text += &format!("\n{}", save_difference(&difference, file));
    }
    Ok(answer)
}

/// Saves the picture of a difference in the target folder. Returns a line that says where.
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
