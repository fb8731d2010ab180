use crate::{Answer, Locked, check_png, escape_for_terminal, read_bounded_file};
use std::fs;
use std::path::{Path, PathBuf};

/// Verdict on one picture in a folder.
struct Entry<'a> {
    picture: &'a str,
    verdict: Verdict,
}

enum Verdict {
    Absent,
    Unreadable(String),
    /// With what is to be said of the file.
    Right(String),
    /// With the whole answer.
    Wrong(String),
}

/// Looks for every picture of the course in `folder`, and says of each whether it is right,
/// not right, unreadable or absent; for machines as JSON.
///
/// A folder without a picture, but with folders, is a class: each of these is a student's, who gets
/// one line.
///
/// The exit code is 0 if all pictures that are there are right, 1 if one is not, and 2 if
/// none is there.
pub fn report_on_folder_or_class(
    folder: &Path,
    locked: &[Locked],
    as_json: bool,
) -> Answer {
    let own_entries = check_entries(folder, locked);
    let inner = match own_entries
        .iter()
        .all(|entry| matches!(entry.verdict, Verdict::Absent))
    {
        true => visible_folders_in(folder),
        false => vec![],
    };
    let is_class = !inner.is_empty();
    let all: Vec<_> = match is_class {
        false => vec![(folder.to_owned(), own_entries)],
        true => {
            let own_entries = |folder: PathBuf| {
                let entries = check_entries(&folder, locked);
                (folder, entries)
            };
            inner.into_iter().map(own_entries).collect()
        }
    };
    let lines: Vec<_> = match (as_json, is_class) {
        (true, _) => vec![format_json(&all)],
        (false, false) => {
            all.iter().map(|(_, entries)| format_table(entries)).collect()
        }
        (false, true) => all
            .iter()
            .map(|(folder, own_entries)| format_student_line(folder, own_entries))
            .collect(),
    };
    let verdicts = all.iter().flat_map(|(_, entries)| entries);
    let codes = verdicts.filter_map(|entry| match entry.verdict {
        Verdict::Absent => None,
        Verdict::Right(_) => Some(0),
        _ => Some(1),
    });
    Answer::new(codes.max().unwrap_or(2), lines.join("\n"))
}

/// The folders in a folder, by their names.
fn visible_folders_in(folder: &Path) -> Vec<PathBuf> {
    let all = fs::read_dir(folder).into_iter().flatten().flatten();
    let is_shown = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        path.is_dir() && !name.starts_with('.')
    };
    let mut folders: Vec<_> =
        all.map(|entry| entry.path()).filter(is_shown).collect();
    folders.sort();
    folders
}

fn check_entries<'a>(folder: &Path, locked: &'a [Locked]) -> Vec<Entry<'a>> {
    let entry = |Locked { name, .. }: &'a Locked| {
        let file = format!("{name}.png");
        let path = folder.join(&file);
        let verdict = match path.symlink_metadata() {
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
                Verdict::Absent
            }
            _ => match read_bounded_file(&path) {
                Err(why) => Verdict::Unreadable(why),
                Ok(png) => {
                    let Answer { code, text, .. } =
                        check_png(&png, &file, Some(name), locked);
                    match code {
                        0 => Verdict::Right(join_lines_after_first(&text)),
                        1 => Verdict::Wrong(text),
                        _ => Verdict::Unreadable(
                            first_line_without_prefix(&text).to_owned(),
                        ),
                    }
                }
            },
        };
        Entry { picture: name, verdict }
    };
    locked.iter().map(entry).collect()
}

/// Joins the lines after the first of an answer into one.
fn join_lines_after_first(answer_text: &str) -> String {
    answer_text.lines().skip(1).collect::<Vec<_>>().join(" ")
}

/// The first line of an answer, without what a table says itself.
fn first_line_without_prefix(answer_text: &str) -> &str {
    let line = answer_text.lines().next().unwrap_or_default();
    let starts = ["Not right: ", "Not right yet, ", "error: "];
    starts.iter().find_map(|start| line.strip_prefix(start)).unwrap_or(line)
}

fn is_right(entry: &&Entry) -> bool {
    matches!(entry.verdict, Verdict::Right(_))
}

/// One line for each picture, and how many are right.
fn format_table(entries: &[Entry]) -> String {
    let width =
        entries.iter().map(|entry| entry.picture.len()).max().unwrap_or(0) + 2;
    let line = |Entry { picture, verdict }: &Entry| {
        let verdict_text = match verdict {
            Verdict::Absent => "not there".to_owned(),
            Verdict::Unreadable(why) => format!("unreadable: {why}"),
            Verdict::Right(notes) if notes.is_empty() => "right".to_owned(),
            Verdict::Right(notes) => format!("right; {notes}"),
            Verdict::Wrong(text) => {
                format!("not right: {}", first_line_without_prefix(text))
            }
        };
        format!("{picture:width$}{verdict_text}\n")
    };
    let lines: String = entries.iter().map(line).collect();
    let right = entries.iter().filter(is_right).count();
    format!("{lines}{right} of {} are right.", entries.len())
}

/// One line for a student's folder.
fn format_student_line(folder: &Path, entries: &[Entry]) -> String {
    let names = |is_selected: fn(&Verdict) -> bool| {
        let selected = entries.iter().filter(|entry| is_selected(&entry.verdict));
        selected.map(|entry| entry.picture).collect::<Vec<_>>().join(", ")
    };
    let mut line = format!(
        "{}: {} of {} are right",
        escape_for_terminal(
            &folder.file_name().unwrap_or_default().to_string_lossy()
        ),
        entries.iter().filter(is_right).count(),
        entries.len()
    );
    for (what, names) in [
        ("not right", names(|verdict| matches!(verdict, Verdict::Wrong(_)))),
        ("unreadable", names(|verdict| matches!(verdict, Verdict::Unreadable(_)))),
        (
            "with a note",
            names(
                |verdict| matches!(verdict, Verdict::Right(notes) if !notes.is_empty()),
            ),
        ),
    ] {
        if !names.is_empty() {
            line += &format!("; {what}: {names}");
        }
    }
    line
}

/// A list of folders, each with the verdict on each picture.
fn format_json(folders: &[(PathBuf, Vec<Entry>)]) -> String {
    let entry = |Entry { picture, verdict }: &Entry| {
        let (verdict, text) = match verdict {
            Verdict::Absent => ("absent", ""),
            Verdict::Unreadable(why) => ("unreadable", &why[..]),
            Verdict::Right(notes) => ("right", &notes[..]),
            Verdict::Wrong(text) => ("not right", &text[..]),
        };
        let [picture, verdict, text] = [picture, verdict, text].map(quote_json);
        format!(
            "    {{\"picture\": {picture}, \"verdict\": {verdict}, \"text\": {text}}}"
        )
    };
    let folder = |(folder, entries): &(PathBuf, Vec<Entry>)| {
        let entries: Vec<_> = entries.iter().map(entry).collect();
        let folder = quote_json(&folder.display().to_string());
        let entries = entries.join(",\n");
        format!("  {{\"folder\": {folder}, \"pictures\": [\n{entries}\n  ]}}")
    };
    let folders: Vec<_> = folders.iter().map(folder).collect();
    format!("[\n{}\n]", folders.join(",\n"))
}

fn quote_json(text: &str) -> String {
    let letter = |c: char| match c {
        '"' | '\\' => format!("\\{c}"),
        c if c.is_control() => format!("\\u{:04x}", u32::from(c)),
        c => c.to_string(),
    };
    format!("\"{}\"", text.chars().map(letter).collect::<String>())
}
