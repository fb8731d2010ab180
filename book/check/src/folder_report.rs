use crate::{Answer, Locked, check_png, escape_for_terminal, read_bounded_file};
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

const ABSENT: &str = "absent";
const UNREADABLE: &str = "unreadable";
const RIGHT: &str = "right";
const WRONG: &str = "not right";

/// Verdict on one picture in a folder: one of the four above, with what is to be said of it.
struct Entry<'a> {
    picture: &'a str,
    verdict: &'static str,
    text: String,
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
    let own = vec![(folder.to_owned(), check_entries(folder, locked))];
    let students = match own[0].1.iter().all(|entry| entry.verdict == ABSENT) {
        true => visible_folders_in(folder),
        false => vec![],
    };
    let is_class = !students.is_empty();
    let all: Vec<_> = match is_class {
        false => own,
        true => {
            let entries = |one: PathBuf| (one.clone(), check_entries(&one, locked));
            students.into_iter().map(entries).collect()
        }
    };
    let text = match is_class {
        _ if as_json => format_json(&all),
        true => format_class(&all, locked),
        false => format_table(&all[0].1),
    };
    let verdicts = all.iter().flat_map(|(_, entries)| entries);
    let there = verdicts.filter(|entry| entry.verdict != ABSENT);
    let codes = there.map(|entry| u8::from(entry.verdict != RIGHT));
    Answer::new(codes.max().unwrap_or(2), text)
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
        let (verdict, text) = check_entry(folder, name, locked);
        Entry { picture: name, verdict, text }
    };
    locked.iter().map(entry).collect()
}

/// The verdict on one picture, and what is to be said of it.
fn check_entry(
    folder: &Path,
    name: &str,
    locked: &[Locked],
) -> (&'static str, String) {
    let file = format!("{name}.png");
    let path = folder.join(&file);
    let metadata = path.symlink_metadata();
    if metadata.is_err_and(|error| error.kind() == ErrorKind::NotFound) {
        return (ABSENT, String::new());
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

fn count_right(entries: &[Entry]) -> usize {
    entries.iter().filter(|entry| entry.verdict == RIGHT).count()
}

/// One line for each picture, and how many are right.
fn format_table(entries: &[Entry]) -> String {
    let width = entries.iter().map(|entry| entry.picture.len()).max().unwrap_or(0);
    let line = |Entry { picture, verdict, text }: &Entry| {
        let verdict = if *verdict == ABSENT { "not there" } else { verdict };
        let words = match first_line_without_prefix(text) {
            "" => verdict.to_owned(),
            text => format!("{verdict}: {text}"),
        };
        format!("{picture:width$}  {words}\n")
    };
    let lines: String = entries.iter().map(line).collect();
    format!("{lines}{} of {} are right.", count_right(entries), entries.len())
}

/// One line for each student's folder: how many pictures are right, and the verdict on each
/// that anybody has. The first line names them.
fn format_class(students: &[(PathBuf, Vec<Entry>)], locked: &[Locked]) -> String {
    let mut names = vec![String::new()];
    names.extend(students.iter().map(|(folder, _)| {
        let name = folder.file_name().unwrap_or_default().to_string_lossy();
        escape_for_terminal(&name)
    }));
    let mut counts = vec![RIGHT.to_owned()];
    counts.extend(students.iter().map(|(_, all)| count_right(all).to_string()));
    let mut columns = vec![names, counts];
    for (k, Locked { name, .. }) in locked.iter().enumerate() {
        let verdicts = students.iter().map(|(_, entries)| entries[k].verdict);
        if verdicts.clone().any(|verdict| verdict != ABSENT) {
            let words = verdicts.map(|verdict| match verdict {
                ABSENT => "missing",
                verdict => verdict,
            });
            columns.push(
                [&name[..]].into_iter().chain(words).map(Into::into).collect(),
            );
        }
    }
    let widths = columns.iter().map(|column| {
        column.iter().map(|word| word.chars().count()).max().unwrap_or(0)
    });
    let widths: Vec<_> = widths.collect();
    let line = |k: usize| {
        let words = columns.iter().zip(&widths);
        let words = words.map(|(column, width)| format!("{:width$}", column[k]));
        words.collect::<Vec<_>>().join("  ").trim_end().to_owned()
    };
    (0..=students.len()).map(line).collect::<Vec<_>>().join("\n")
}

/// A list of folders, each with the verdict on each picture.
fn format_json(folders: &[(PathBuf, Vec<Entry>)]) -> String {
    let entry = |Entry { picture, verdict, text }: &Entry| {
        let [picture, verdict, text] =
            [picture, verdict, &text[..]].map(quote_json);
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
