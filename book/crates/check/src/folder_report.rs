use crate::{Answer, LockedPictures, Verdict, check_png, check_scene_png};
use crate::{escape_for_terminal, read_bounded_file};
use course::{NAMED_SCENE_EXAMPLE, Step, json, locked_names};
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// The extensions of files that may have been meant as a picture, or hold some.
const PICTURE_EXTENSIONS: [&str; 7] = ["png", "jpg", "jpeg", "webp", "gif", "bmp", "zip"];

/// The most names that a line tells.
const NAMES: usize = 8;

/// A folder with the answers about its pictures, and what is in it under another name.
struct Report {
    folder: String,
    /// Why nothing in it can be read.
    refusal: Option<String>,
    /// The answer about each picture of the course, by its name.
    answers: Vec<(&'static str, Answer)>,
    unchecked: Vec<String>,
}

impl Report {
    /// The answers about pictures that are there.
    fn present(&self) -> impl Iterator<Item = &(&'static str, Answer)> {
        self.answers.iter().filter(|(_, answer)| answer.verdict != Verdict::Missing)
    }

    fn count_right(&self) -> usize {
        self.answers.iter().filter(|(_, answer)| answer.verdict == Verdict::Right).count()
    }
}

/// Looks for every picture of the course in `folder`, and says of each whether it is right,
/// not right, unreadable or missing; for machines as JSON.
///
/// A folder with folders is a class, if one of these has a picture of the course, or it has
/// none itself; a workspace of Cargo is never one. Each folder in it is a student's, who gets
/// one line, and may have a picture of the scene that belongs to the folder's name.
///
/// The exit code is 0 if all pictures that are there are right, 1 if one is not, and 2 if
/// none is there.
pub fn report_on_folder_or_class(folder: &Path, locked: &LockedPictures, as_json: bool) -> Answer {
    if let Err(error) = fs::read_dir(folder) {
        let path = escape_for_terminal(&folder.display().to_string());
        return Answer::error(match error.kind() {
            ErrorKind::PermissionDenied => format!("{path} can't be read: no permission"),
            _ => format!("{path} is not a folder"),
        });
    }
    let whole = report_on_folder(folder, &[], locked, false);
    let students = match folder.join("Cargo.toml").exists() {
        true => vec![],
        false => visible_folders_in(folder),
    };
    let names: Vec<_> = students.iter().map(|student| name_of_path(student)).collect();
    let students = students.iter().map(|student| report_on_folder(student, &names, locked, true));
    let students: Vec<_> = students.collect();
    let has_pictures = |report: &Report| report.present().next().is_some();
    let is_class =
        !students.is_empty() && (!has_pictures(&whole) || students.iter().any(has_pictures));
    let stray = if is_class { visible_pictures_in(folder) } else { vec![] };
    let reports = if is_class { students } else { vec![whole] };
    let text = match is_class {
        _ if as_json => format_json(&reports),
        true => format_class(&reports, stray),
        false => format_table(&reports[0]),
    };
    let verdicts = reports.iter().flat_map(Report::present).map(|(_, answer)| answer.verdict);
    let verdict = match verdicts.map(|verdict| verdict == Verdict::Right).min() {
        Some(true) => Verdict::Right,
        Some(false) => Verdict::NotRight,
        None => Verdict::Missing,
    };
    Answer::new(verdict, text)
}

/// The answers about the pictures of the course in a folder and, if it is a student's, about
/// the scene of its name; `names` are those of the class.
fn report_on_folder(
    path: &Path,
    names: &[String],
    locked: &LockedPictures,
    is_students: bool,
) -> Report {
    let folder = match path.file_name() {
        Some(_) => name_of_path(path),
        None => name_of_path(&path.canonicalize().unwrap_or_default()),
    };
    let refusal = fs::read_dir(path).err().map(|error| match error.kind() {
        ErrorKind::PermissionDenied => "can't be read: no permission".to_owned(),
        _ => format!("can't be read: {error}"),
    });
    let mut answers: Vec<(_, Answer)> = vec![];
    if refusal.is_none() {
        answers.extend(locked_names().into_iter().map(|name| {
            let check = |png: &[u8], file: &str| check_png(png, file, Some(name), locked);
            (name, check_entry(path, name, check))
        }));
        if is_students {
            let name = NAMED_SCENE_EXAMPLE;
            let check = |png: &[u8], file: &str| check_scene_png(png, file, &folder, names, locked);
            answers.push((name, check_entry(path, name, check)));
        }
    }
    // Where no picture is, each folder may hold some, however deep.
    let is_empty = answers.iter().all(|(_, answer)| answer.verdict == Verdict::Missing);
    let folders = visible_folders_in(path);
    let folders = folders
        .iter()
        .filter(|inner| is_students && is_empty || !visible_pictures_in(inner).is_empty())
        .map(|inner| format!("{}/", name_of_path(inner)));
    let is_checked = |file: &String| {
        let name = file.strip_suffix(".png").unwrap_or_default();
        answers.iter().any(|(picture, _)| *picture == name)
    };
    let pictures = visible_pictures_in(path).into_iter();
    let unchecked = pictures.filter(|file| !is_checked(file)).chain(folders).collect();
    Report { folder, refusal, answers, unchecked }
}

fn name_of_path(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// The paths in a folder that are not hidden, by name.
fn visible_paths_in(folder: &Path) -> Vec<PathBuf> {
    let all = fs::read_dir(folder).into_iter().flatten().flatten();
    let paths = all.map(|entry| entry.path());
    let mut paths: Vec<_> = paths.filter(|path| !name_of_path(path).starts_with('.')).collect();
    paths.sort();
    paths
}

/// The folders in a folder, by their names.
fn visible_folders_in(folder: &Path) -> Vec<PathBuf> {
    let mut folders = visible_paths_in(folder);
    folders.retain(|path| path.is_dir());
    folders
}

/// The names of the files in a folder that may have been meant as pictures.
fn visible_pictures_in(folder: &Path) -> Vec<String> {
    let is_picture = |path: &PathBuf| {
        let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
        !path.is_dir() && PICTURE_EXTENSIONS.iter().any(|one| extension == *one)
    };
    let paths = visible_paths_in(folder).into_iter().filter(is_picture);
    paths.map(|path| name_of_path(&path)).collect()
}

/// The answer about one picture in a folder, by a function of its bytes and its name.
fn check_entry(folder: &Path, name: &str, check: impl Fn(&[u8], &str) -> Answer) -> Answer {
    let file = format!("{name}.png");
    let path = folder.join(&file);
    let metadata = path.symlink_metadata();
    if metadata.is_err_and(|error| error.kind() == ErrorKind::NotFound) {
        return Answer::new(Verdict::Missing, "");
    }
    match read_bounded_file(&path) {
        Err(why) => Answer::error(why),
        Ok(png) => check(&png, &file),
    }
}

/// What a table says of an answer beside its verdict: its first line, of a right picture what
/// is noted.
fn short_text(answer: &Answer) -> String {
    let mut lines = answer.text.lines();
    let first = lines.next().unwrap_or_default();
    if answer.verdict == Verdict::Right {
        return lines.collect::<Vec<_>>().join(" ");
    }
    let starts = ["Not right. ", "Right, but with other options: ", "error: "];
    starts.iter().find_map(|start| first.strip_prefix(start)).unwrap_or(first).to_owned()
}

/// One line for each picture, and how many are right.
fn format_table(report: &Report) -> String {
    let answers = &report.answers;
    let width = answers.iter().map(|(picture, _)| picture.len()).max().unwrap_or(0);
    let line = |(picture, answer): &(&str, Answer)| {
        let words = match (answer.verdict.words(), short_text(answer)) {
            (verdict, text) if text.is_empty() => verdict.to_owned(),
            (verdict, text) => format!("{verdict}: {text}"),
        };
        format!("{picture:width$}  {words}\n")
    };
    let lines: String = answers.iter().map(line).collect();
    let count = format!("{} of {} are right.", report.count_right(), answers.len());
    format!("{lines}{count}{}", format_unchecked(report.unchecked.clone()))
}

/// One line for each student's folder: how many pictures are right, the verdict on each
/// step and on the named scene, where anybody has it, and how many of the others are right.
/// The first line names them; then come notes on right pictures, and what was not looked at.
fn format_class(students: &[Report], stray: Vec<String>) -> String {
    let column = |title: &str, word: &dyn Fn(&Report) -> String| {
        let words = students.iter().map(word);
        [title.to_owned()].into_iter().chain(words).collect::<Vec<_>>()
    };
    let mut columns = vec![
        column("", &|student| escape_for_terminal(&student.folder)),
        column("right", &|student| match &student.refusal {
            Some(refusal) => refusal.clone(),
            None => student.count_right().to_string(),
        }),
    ];
    let is_other = |(name, _): &&(&str, Answer)| {
        *name != NAMED_SCENE_EXAMPLE && Step::from_name(name).is_none()
    };
    for name in Step::NAMES.into_iter().chain([NAMED_SCENE_EXAMPLE]) {
        if students.iter().flat_map(Report::present).any(|(picture, _)| *picture == name) {
            columns.push(column(name, &|student| {
                let answer = student.answers.iter().find(|(picture, _)| *picture == name);
                answer.map_or("", |(_, answer)| answer.verdict.words()).to_owned()
            }));
        }
    }
    if students.iter().flat_map(Report::present).any(|entry| is_other(&entry)) {
        columns.push(column("others", &|student| {
            let others: Vec<_> = student.present().filter(is_other).collect();
            let right = others.iter().filter(|(_, answer)| answer.verdict == Verdict::Right);
            format!("{} of {}", right.count(), others.len())
        }));
    }
    let widths = columns
        .iter()
        .map(|column| column.iter().map(|word| word.chars().count()).max().unwrap_or(0));
    let widths: Vec<_> = widths.collect();
    let line = |k: usize| {
        let words = columns.iter().zip(&widths);
        let words = words.map(|(column, width)| format!("{:width$}", column[k]));
        words.collect::<Vec<_>>().join("  ").trim_end().to_owned()
    };
    let mut lines: Vec<_> = (0..=students.len()).map(line).collect();
    for student in students {
        let right = student.present().filter(|(_, answer)| answer.verdict == Verdict::Right);
        let noted = right.map(|(name, answer)| (name, short_text(answer)));
        lines.extend(noted.filter(|(_, note)| !note.is_empty()).map(|(name, note)| {
            format!("{}/{name}.png: {note}", escape_for_terminal(&student.folder))
        }));
    }
    let mut unchecked = stray;
    for Report { folder, unchecked: names, .. } in students {
        unchecked.extend(names.iter().map(|name| format!("{folder}/{name}")));
    }
    format!("{}{}", lines.join("\n"), format_unchecked(unchecked))
}

/// A line with the names of what was not looked at; nothing where there is nothing.
fn format_unchecked(mut names: Vec<String>) -> String {
    if names.is_empty() {
        return String::new();
    }
    let more = names.len().saturating_sub(NAMES);
    names.truncate(NAMES);
    let names = names.iter().map(|name| escape_for_terminal(name));
    let names = names.collect::<Vec<_>>().join(", ");
    let more = if more == 0 { String::new() } else { format!(" and {more} more") };
    format!("\nNot looked at: {names}{more}.")
}

/// A list of folders, each with the answer about each picture.
fn format_json(reports: &[Report]) -> String {
    let report = |report: &Report| {
        let pictures = report.answers.iter().map(|(picture, answer)| {
            let fields = [("picture", json::quote(picture))];
            format!("\n  {}", json::object(fields.into_iter().chain(answer.json_fields())))
        });
        let unchecked = report.unchecked.iter().map(|name| json::quote(name));
        let mut fields = vec![("folder", json::quote(&report.folder))];
        fields.extend(report.refusal.iter().map(|refusal| ("error", json::quote(refusal))));
        fields.push(("pictures", json::list(pictures)));
        fields.push(("not_looked_at", json::list(unchecked)));
        json::object(fields)
    };
    json::list(reports.iter().map(|one| format!("\n {}", report(one)))) + "\n"
}
