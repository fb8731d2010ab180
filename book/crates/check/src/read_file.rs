use crate::png_file::{FILE_BYTES, too_large_clause};
use course::is_obeyed_by_terminals;
use std::fs::{self, File};
use std::io::{ErrorKind, Read};
use std::path::Path;

/// The bytes of a picture's file, or why they can't be read.
pub fn read_bounded_file(path: &Path) -> Result<Vec<u8>, String> {
    read_file_of_at_most(path, FILE_BYTES)
}

/// The bytes of a file, or why they can't be read. What is not a file, such as a folder, a
/// device or a pipe, is not opened, and no more than these bytes is read.
pub(crate) fn read_file_of_at_most(path: &Path, most_bytes: u64) -> Result<Vec<u8>, String> {
    let printable_path = escape_for_terminal(&path.display().to_string());
    let unread = |error: std::io::Error| match error.kind() {
        ErrorKind::NotFound => format!("there is no file {printable_path}"),
        _ => format!("can't read {printable_path}: {error}"),
    };
    if !fs::metadata(path).map_err(unread)?.is_file() {
        return Err(format!("{printable_path} is not a file"));
    }
    let mut bytes = vec![];
    let file = File::open(path).map_err(unread)?;
    file.take(most_bytes + 1).read_to_end(&mut bytes).map_err(unread)?;
    if most_bytes < bytes.len() as u64 {
        return Err(format!("{printable_path} {}", too_large_clause(most_bytes)));
    }
    Ok(bytes)
}

/// A name, with escapes for what a terminal would obey and for what turns letters around.
pub fn escape_for_terminal(name: &str) -> String {
    let letter = |c: char| match is_obeyed_by_terminals(c) {
        true => c.escape_default().to_string(),
        false => c.to_string(),
    };
    name.chars().map(letter).collect()
}
