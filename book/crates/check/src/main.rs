//! The command-line program `check`: its options, its output and its exit code.

use check::{
    Answer, CheckError, ClassReport, FAILURE_EXIT_CODE, OwnPicturesReport, check_png,
    check_scene_png, compose_characters, escape_for_terminal, format_sheet, read_bounded_file,
    read_names, report_on_class, report_on_own_pictures, run_on_threads, write_sheets,
};
use clap::builder::{NonEmptyStringValueParser, PossibleValuesParser, TypedValueParser};
use clap::{ArgGroup, Parser};
use course::{json, names_of_right_pictures, read_locked_picture};
use image::RgbImage;
use std::error::Error;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

/// Reports whether a picture is right and, if it isn't, what's wrong with it.
///
/// Without a file, looks for the pictures of the course in the current folder
/// and reports which of them are right.
///
/// The exit code is 0 if everything is right, 1 if something is wrong, and 2 if
/// something is missing or unreadable. With --in, the exit code is also 2 if
/// something was not looked at, or if there is a note on a student.
#[derive(Parser)]
#[command(name = "check", after_help = format!("Names: {}", names_of_right_pictures().join(", ")))]
#[command(group = ArgGroup::new("use_of_names").args(["folder", "out"]))]
struct Arguments {
    /// The PNG file to check
    file: Option<PathBuf>,
    /// The expected picture (default: taken from the file name)
    #[arg(value_parser = locked_name_parser(), hide_possible_values = true)]
    name: Option<String>,
    /// The folder of a class, with one folder per student. Subfolders are searched, too
    #[arg(long = "in", value_name = "FOLDER", conflicts_with = "file")]
    folder: Option<PathBuf>,
    /// Prints the sheet for a name: the numbers of that name's scene, and problems to solve on
    /// paper. With a file, checks whether the file is the picture of this scene
    #[arg(long, value_name = "NAME", group = "sheet", conflicts_with_all = ["name", "folder"])]
    #[arg(value_parser = NonEmptyStringValueParser::new().map(|name| compose_characters(&name)))]
    scene: Option<String>,
    /// A file with the names of the students in a class, one per line. With --out, writes a sheet
    /// for each name. With --in, each line is the full name of a student's folder, and the report
    /// says which folders are missing
    #[arg(long, value_name = "FILE", group = "sheet", requires = "use_of_names")]
    #[arg(conflicts_with_all = ["file", "scene"])]
    names: Option<PathBuf>,
    /// The folder to write the sheets to, which must not exist yet. Each sheet is a .md file, and
    /// sheets.html has all of them for printing
    #[arg(long, value_name = "FOLDER", requires = "sheet", conflicts_with_all = ["file", "folder"])]
    out: Option<PathBuf>,
    /// Also writes the answers to the problems, as answers.html
    #[arg(long, requires = "out")]
    answers: bool,
    /// A secret word. Each scene is generated from this word and the name. The word appears on no
    /// sheet
    #[arg(long, value_name = "WORD", requires = "sheet", conflicts_with_all = ["file", "folder"])]
    #[arg(value_parser = NonEmptyStringValueParser::new().map(|word| compose_characters(&word)))]
    secret: Option<String>,
    /// The pictures that are worth a point, separated by commas (default: all that are found)
    #[arg(long, value_name = "NAMES", conflicts_with_all = ["file", "scene", "out"])]
    #[arg(value_delimiter = ',', value_parser = locked_name_parser(), hide_possible_values = true)]
    require: Vec<String>,
    /// Prints the report on a class as CSV, for a spreadsheet
    #[arg(long, requires = "folder", conflicts_with_all = ["json", "scene", "out"])]
    csv: bool,
    /// Prints the answer or the report as JSON
    #[arg(long)]
    json: bool,
}

fn locked_name_parser() -> PossibleValuesParser {
    PossibleValuesParser::new(names_of_right_pictures())
}

/// An error of any kind. The program only prints it.
type AnyError = Box<dyn Error + Send + Sync>;

/// The task that the program's arguments ask for.
enum Task {
    /// `check FILE`: checks one picture.
    CheckFile { file: PathBuf, expected: ExpectedPicture },
    /// `check`: checks the reader's own pictures in the current folder. Also reports which of the
    /// `required` pictures are missing.
    CheckFolder { required: Vec<&'static str> },
    /// `check --in FOLDER`: checks the pictures of a class. If the students' names are given, also
    /// says whose folder is missing.
    ReportOnClass { folder: PathBuf, students: Option<Vec<String>>, required: Vec<&'static str> },
    /// `check --scene NAME`: prints the sheet for one name.
    PrintSheet { name: String, secret: Option<String> },
    /// `check --names FILE --out FOLDER`: writes a sheet for each name into a new folder. If
    /// `answers` is true, also writes the answers to the sheets' problems. With `--scene NAME`
    /// instead of `--names FILE`, there is only one name.
    WriteSheets { names: Vec<String>, secret: Option<String>, answers: bool, folder: PathBuf },
}

/// The picture that a file should contain.
enum ExpectedPicture {
    /// The locked picture with this name. If the name is None, `check_png` works out the name.
    Locked(Option<String>),
    /// The picture of the scene that is generated from this name.
    SceneFromName(String),
}

impl Task {
    /// Returns the task that the arguments describe. With `--names`, also reads the file with the
    /// names.
    ///
    /// The arguments that select a task (a file, `--in`, `--out`) exclude each other, and clap has
    /// rejected every option that doesn't belong to the task.
    fn from_arguments(arguments: Arguments) -> Result<Self, AnyError> {
        let Arguments { file, name, folder, scene, names, out, answers, secret, require, .. } =
            arguments;
        let names = names.as_deref().map(read_names).transpose()?;
        let required = required_names_in_order(&require);
        Ok(match (file, folder, out, scene) {
            (Some(file), _, _, Some(name)) => {
                Self::CheckFile { file, expected: ExpectedPicture::SceneFromName(name) }
            }
            (Some(file), _, _, None) => {
                Self::CheckFile { file, expected: ExpectedPicture::Locked(name) }
            }
            (None, Some(folder), _, _) => Self::ReportOnClass { folder, students: names, required },
            (None, None, Some(folder), scene) => {
                let names = names.into_iter().flatten().chain(scene).collect();
                Self::WriteSheets { names, secret, answers, folder }
            }
            (None, None, None, Some(name)) => Self::PrintSheet { name, secret },
            (None, None, None, None) => Self::CheckFolder { required },
        })
    }
}

/// The program's output if its task succeeds.
enum Output {
    /// The answer about one picture.
    Answer(Answer),
    /// The report on a class.
    ClassReport(ClassReport),
    /// The report on a reader's own pictures.
    OwnPicturesReport(OwnPicturesReport),
    /// A sheet, or a list of the files that were written.
    Text(String),
}

/// The format of the output.
#[derive(Clone, Copy)]
enum OutputFormat {
    /// Text for a terminal.
    Plain,
    Csv,
    Json,
}

impl Output {
    /// Formats the output. Only the report on a class has a CSV format.
    fn format(&self, format: OutputFormat) -> String {
        match (self, format) {
            (Self::Answer(answer), OutputFormat::Json) => answer.to_json(),
            (Self::Answer(answer), _) => answer.to_string(),
            (Self::ClassReport(report), OutputFormat::Json) => report.to_json(),
            (Self::ClassReport(report), OutputFormat::Csv) => report.to_csv(),
            (Self::ClassReport(report), OutputFormat::Plain) => report.to_table(),
            (Self::OwnPicturesReport(report), OutputFormat::Json) => report.to_json(),
            (Self::OwnPicturesReport(report), _) => report.to_table(),
            (Self::Text(text), OutputFormat::Json) => json::object([("text", json::quote(text))]),
            (Self::Text(text), _) => text.clone(),
        }
    }

    fn exit_code(&self) -> u8 {
        match self {
            Self::Answer(answer) => answer.verdict.exit_code(),
            Self::ClassReport(report) => report.exit_code(),
            Self::OwnPicturesReport(report) => report.exit_code(),
            Self::Text(_) => 0,
        }
    }
}

fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) if error.use_stderr() => return print_usage_error(&error),
        Err(error) => error.exit(),
    };
    let format = match &arguments {
        Arguments { json: true, .. } => OutputFormat::Json,
        Arguments { csv: true, .. } => OutputFormat::Csv,
        _ => OutputFormat::Plain,
    };
    // Ignore write errors: whatever reads our output may have closed the pipe.
    match run_on_threads(|| Task::from_arguments(arguments).and_then(run)) {
        Ok(output) => {
            let _ = writeln!(io::stdout(), "{}", output.format(format).trim_end());
            output.exit_code().into()
        }
        Err(error) => {
            let _ = match format {
                OutputFormat::Json => {
                    writeln!(io::stdout(), "{}", error_to_json(&error.to_string()))
                }
                OutputFormat::Plain | OutputFormat::Csv => writeln!(io::stderr(), "error: {error}"),
            };
            FAILURE_EXIT_CODE.into()
        }
    }
}

/// Prints a usage error, as JSON if `--json` is among the arguments.
fn print_usage_error(error: &clap::Error) -> ExitCode {
    let lines: Vec<_> = error.to_string().trim_end().lines().map(escape_for_terminal).collect();
    let text = lines.join("\n");
    let is_json = env::args_os().any(|argument| argument == "--json");
    let _ = match is_json {
        true => writeln!(io::stdout(), "{}", error_to_json(&text)),
        false => writeln!(io::stderr(), "{text}"),
    };
    FAILURE_EXIT_CODE.into()
}

fn error_to_json(message: &str) -> String {
    json::object([("error", json::quote(message))])
}

/// Carries out the task.
fn run(task: Task) -> Result<Output, AnyError> {
    Ok(match task {
        Task::CheckFile { file, expected } => {
            Output::Answer(check_file_and_save_difference(&file, &expected)?)
        }
        Task::CheckFolder { required } => {
            Output::OwnPicturesReport(report_on_own_pictures(Path::new("."), &required)?)
        }
        Task::ReportOnClass { folder, students, required } => {
            Output::ClassReport(report_on_class(&folder, students.as_deref(), &required)?)
        }
        Task::PrintSheet { name, secret } => Output::Text(format_sheet(&name, secret.as_deref())),
        Task::WriteSheets { names, secret, answers, folder } => {
            Output::Text(write_sheets(&names, secret.as_deref(), answers, &folder)?)
        }
    })
}

/// Returns the names given with `--require`, in the order of `names_of_right_pictures`.
fn required_names_in_order(require: &[String]) -> Vec<&'static str> {
    names_of_right_pictures()
        .into_iter()
        .filter(|name| require.iter().any(|required| required == name))
        .collect()
}

/// Checks one picture. If the answer contains two pictures to compare, also saves a picture of the
/// difference.
fn check_file_and_save_difference(
    file: &Path,
    expected: &ExpectedPicture,
) -> Result<Answer, CheckError> {
    let (png, file_name) = (read_bounded_file(file)?, file.display().to_string());
    let mut answer = match expected {
        ExpectedPicture::Locked(name) => {
            check_png(&png, &file_name, name.as_deref(), read_locked_picture)?
        }
        ExpectedPicture::SceneFromName(name) => check_scene_png(&png, &file_name, name)?,
    };
    if let Some(difference) = answer.draw_comparison() {
        answer.details.push(save_difference(&difference, file));
    }
    Ok(answer)
}

/// Saves the picture of the difference in Cargo's target folder. Returns a line to add to the
/// answer. The line says where the picture is, or why it can't be written.
fn save_difference(difference: &RgbImage, file: &Path) -> String {
    let folder = course::target_folder().join("check");
    let path = folder.join(file.with_extension("difference.png").file_name().unwrap_or_default());
    let result = fs::create_dir_all(folder)
        .and_then(|()| course::replace_file(&path, &course::encode_png(difference)));
    let printable_path = escape_for_terminal(&path.display().to_string());
    match result {
        Ok(()) => format!("Yours, ours and the difference, side by side: {printable_path}"),
        Err(error) => format!("{printable_path} can't be written: {error}"),
    }
}
