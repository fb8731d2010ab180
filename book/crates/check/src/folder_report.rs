use crate::{Answer, Locked, check_named_scene, check_png, escape_for_terminal, read_bounded_file};
use course::Step;
use course::{NAMED_SCENE_EXAMPLE, json};
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

const MISSING: &str = "missing";
const UNREADABLE: &str = "unreadable";
const RIGHT: &str = "right";
const WRONG: &str = "not right";

/// The extensions of files that may have been meant as a picture, or hold some.
const PICTURE_EXTENSIONS: [&str; 7] = ["png", "jpg", "jpeg", "webp", "gif", "bmp", "zip"];

/// The most names that a line tells.
const NAMES: usize = 8;

/// Verdict on one picture in a folder: one of the four above, with what is to be said of it.
struct Entry<'a> {
    picture: &'a str,
    verdict: &'static str,
    text: String,
}

/// A folder with the verdicts on its pictures, and what is in it under another name.
struct Report<'a> {
    folder: String,
    entries: Vec<Entry<'a>>,
    unchecked: Vec<String>,
}

impl Report<'_> {
    /// The entries of pictures that are there.
    fn present(&self) -> impl Iterator<Item = &Entry<'_>> {
        self.entries.iter().filter(|entry| entry.verdict != MISSING)
    }

    fn count_right(&self) -> usize {
        self.entries.iter().filter(|entry| entry.verdict == RIGHT).count()
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
pub fn report_on_folder_or_class(folder: &Path, locked: &[Locked], as_json: bool) -> Answer {
    let whole = report_on_folder(folder, locked, false);
    let students = match folder.join("Cargo.toml").exists() {
        true => vec![],
        false => visible_folders_in(folder),
    };
    let students = students.iter().map(|one| report_on_folder(one, locked, true));
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
    let present = reports.iter().flat_map(Report::present);
    let codes = present.map(|entry| u8::from(entry.verdict != RIGHT));
    Answer::new(codes.max().unwrap_or(2), text)
}

/// The verdicts on the pictures of the course in a folder and, if it is a student's, on the
/// scene of its name.
fn report_on_folder<'a>(path: &Path, locked: &'a [Locked], is_students: bool) -> Report<'a> {
    let full_path = path.canonicalize().unwrap_or_else(|_| path.to_owned());
    let folder = name_of_path(&full_path);
    let entry = |Locked { name, .. }: &'a Locked| {
        let (verdict, text) = check_entry(path, name, locked);
        Entry { picture: name, verdict, text }
    };
    let mut entries: Vec<_> = locked.iter().map(entry).collect();
    if is_students {
        let (verdict, text) = check_scene_entry(path, &folder);
        entries.push(Entry { picture: NAMED_SCENE_EXAMPLE, verdict, text });
    }
    // Where no picture is, each folder may hold some, however deep.
    let is_empty = entries.iter().all(|entry| entry.verdict == MISSING);
    let folders = visible_folders_in(path);
    let folders = folders
        .iter()
        .filter(|inner| is_students && is_empty || !visible_pictures_in(inner).is_empty())
        .map(|inner| format!("{}/", name_of_path(inner)));
    let is_checked = |file: &String| {
        let name = file.strip_suffix(".png").unwrap_or_default();
        entries.iter().any(|entry| entry.picture == name)
    };
    let pictures = visible_pictures_in(path).into_iter();
    let unchecked = pictures.filter(|file| !is_checked(file)).chain(folders).collect();
    Report { folder, entries, unchecked }
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

/// The verdict on the picture of the scene that belongs to a student's name.
fn check_scene_entry(folder: &Path, student: &str) -> (&'static str, String) {
    let path = folder.join(format!("{NAMED_SCENE_EXAMPLE}.png"));
    if is_missing(&path) {
        return (MISSING, String::new());
    }
    match check_named_scene(student, &path) {
        Err(why) => (UNREADABLE, why),
        Ok(Answer { code: 0, .. }) => (RIGHT, String::new()),
        Ok(Answer { text, .. }) => (WRONG, text),
    }
}

fn is_missing(path: &Path) -> bool {
    let metadata = path.symlink_metadata();
    metadata.is_err_and(|error| error.kind() == ErrorKind::NotFound)
}

/// The verdict on one picture, and what is to be said of it.
fn check_entry(folder: &Path, name: &str, locked: &[Locked]) -> (&'static str, String) {
    let file = format!("{name}.png");
    let path = folder.join(&file);
    if is_missing(&path) {
        return (MISSING, String::new());
    }
    let png = match read_bounded_file(&path) {
        Err(why) => return (UNREADABLE, why),
        Ok(png) => png,
    };
    let Answer { code, text, .. } = check_png(&png, &file, Some(name), locked);
    match code {
        0 => (RIGHT, text.lines().skip(1).collect::<Vec<_>>().join(" ")),
        1 => (WRONG, text),
        _ => (UNREADABLE, first_line_without_prefix(&text).to_owned()),
    }
}

/// The first line of an answer, without what a table says itself.
fn first_line_without_prefix(answer_text: &str) -> &str {
    let line = answer_text.lines().next().unwrap_or_default();
    let starts = ["Not right: ", "Not right yet, ", "error: "];
    starts.iter().find_map(|start| line.strip_prefix(start)).unwrap_or(line)
}

/// One line for each picture, and how many are right.
fn format_table(report: &Report) -> String {
    let entries = &report.entries;
    let width = entries.iter().map(|entry| entry.picture.len()).max().unwrap_or(0);
    let line = |Entry { picture, verdict, text }: &Entry| {
        let words = match first_line_without_prefix(text) {
            "" => (*verdict).to_owned(),
            text => format!("{verdict}: {text}"),
        };
        format!("{picture:width$}  {words}\n")
    };
    let lines: String = entries.iter().map(line).collect();
    let count = format!("{} of {} are right.", report.count_right(), entries.len());
    format!("{lines}{count}{}", format_unchecked(report.unchecked.clone()))
}

/// One line for each student's folder: how many pictures are right, the verdict on each
/// step and on the named scene, where anybody has it, and how many of the others are right.
/// The first line names them; a last one has what was not looked at.
fn format_class(students: &[Report], stray: Vec<String>) -> String {
    let column = |title: &str, word: &dyn Fn(&Report) -> String| {
        let words = students.iter().map(word);
        [title.to_owned()].into_iter().chain(words).collect::<Vec<_>>()
    };
    let mut columns = vec![
        column("", &|student| escape_for_terminal(&student.folder)),
        column(RIGHT, &|student| student.count_right().to_string()),
    ];
    let steps = Step::ALL.map(Step::name);
    let is_other =
        |entry: &&Entry| entry.picture != NAMED_SCENE_EXAMPLE && !steps.contains(&entry.picture);
    let is_present = |name: &str| {
        let mut entries = students.iter().flat_map(Report::present);
        entries.any(|entry| entry.picture == name)
    };
    for name in steps.into_iter().chain([NAMED_SCENE_EXAMPLE]) {
        if is_present(name) {
            columns.push(column(name, &|student| {
                let entry = student.present().find(|entry| entry.picture == name);
                entry.map_or(MISSING, |entry| entry.verdict).to_owned()
            }));
        }
    }
    if students.iter().flat_map(Report::present).any(|entry| is_other(&entry)) {
        columns.push(column("others", &|student| {
            let others: Vec<_> = student.present().filter(is_other).collect();
            let right = others.iter().filter(|entry| entry.verdict == RIGHT);
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
    let lines: Vec<_> = (0..=students.len()).map(line).collect();
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

/// A list of folders, each with the verdict on each picture.
fn format_json(reports: &[Report]) -> String {
    let entry = |Entry { picture, verdict, text }: &Entry| {
        let [picture, verdict, text] = [picture, verdict, &text[..]].map(json::quote);
        format!("    {{\"picture\": {picture}, \"verdict\": {verdict}, \"text\": {text}}}")
    };
    let report = |Report { folder, entries, unchecked }: &Report| {
        let entries: Vec<_> = entries.iter().map(entry).collect();
        let unchecked: Vec<_> = unchecked.iter().map(|name| json::quote(name)).collect();
        format!(
            "  {{\"folder\": {}, \"pictures\": [\n{}\n  ], \"not_looked_at\": [{}]}}",
            json::quote(folder),
            entries.join(",\n"),
            unchecked.join(", ")
        )
    };
    let reports: Vec<_> = reports.iter().map(report).collect();
    format!("[\n{}\n]", reports.join(",\n"))
}
