use crate::{Answer, Locked, check};
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

/// The page to tick off: every picture of the course that there may be in `folder`,
/// and whether it is right, not right, or not there.
///
/// The exit code is 0 if those that are there are right, 1 if one is not, and 2 if none
/// is there.
pub fn table(folder: &Path, locked: &[Locked]) -> Answer {
    let rows: Vec<_> = locked.iter().map(|one| row(folder, one, locked)).collect();
    let code = match rows.iter().filter_map(|(_, code, _)| *code).max() {
        None => 2,
        Some(code) => code.min(1),
    };
    let width = rows.iter().map(|(name, ..)| name.len()).max().unwrap_or(0) + 2;
    let lines = rows.iter().map(|(name, _, told)| format!("{name:width$}{told}"));
    let right = rows.iter().filter(|(_, code, _)| *code == Some(0)).count();
    let mut text = lines.collect::<Vec<_>>().join("\n");
    text += &format!("\n{right} of {} are right.", rows.len());
    Answer::new(code, text)
}

/// The name of a picture, its exit code if it is there, and what is said of it.
fn row<'a>(
    folder: &Path,
    one: &'a Locked,
    locked: &[Locked],
) -> (&'a str, Option<u8>, String) {
    let name = one.name.as_str();
    let file = format!("{name}.png");
    let Ok(png) = File::open(folder.join(&file)) else {
        return (name, None, "not there".to_owned());
    };
    let Answer { code, text, .. } =
        check(BufReader::new(png), &file, Some(name), locked);
    let told = match code {
        0 => "right".to_owned(),
        _ => format!("not right: {}", why(&text)),
    };
    (name, Some(code), told)
}

/// One line of an answer: the first, without what the table says itself.
fn why(text: &str) -> &str {
    let line = text.lines().next().unwrap_or_default();
    let starts = ["Not right yet: ", "error: "];
    starts.iter().find_map(|start| line.strip_prefix(start)).unwrap_or(line)
}
