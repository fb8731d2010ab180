//! Reads regular files up to a maximum size.

use crate::png_file::MAX_FILE_BYTES;
use course::is_terminal_control;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Read};
use std::path::Path;
use thiserror::Error;

/// Why a file can't be read. The paths are escaped for a terminal.
#[derive(Debug, Error)]
pub enum ReadFileError {
    /// The file doesn't exist.
    #[error("there is no file {path}")]
    NotFound {
        /// The path of the file.
        path: String,
    },
    /// The path is a folder, a device or a pipe.
    #[error("{path} is not a file")]
    NotAFile {
        /// The path.
        path: String,
    },
    /// The file is larger than the limit.
    #[error("{path} is too large: the limit is {} MB", MAX_FILE_BYTES >> 20)]
    TooLarge {
        /// The path of the file.
        path: String,
    },
    /// The system couldn't read the file.
    #[error("can't read {path}: {source}")]
    Io {
        /// The path of the file.
        path: String,
        /// The system's error.
        source: io::Error,
    },
}

/// Reads a file unless it is larger than the limit. Never opens a folder, a device or a pipe.
pub fn read_bounded_file(file: &Path) -> Result<Vec<u8>, ReadFileError> {
    let path = escape_for_terminal(&file.display().to_string());
    match read_at_most(file, MAX_FILE_BYTES) {
        Ok(FileContents::Bytes(bytes)) => Ok(bytes),
        Ok(FileContents::NotAFile) => Err(ReadFileError::NotAFile { path }),
        Ok(FileContents::TooLarge) => Err(ReadFileError::TooLarge { path }),
        Err(error) if error.kind() == ErrorKind::NotFound => Err(ReadFileError::NotFound { path }),
        Err(source) => Err(ReadFileError::Io { path, source }),
    }
}

/// The result of reading the file at a path.
#[derive(Debug, PartialEq)]
enum FileContents {
    Bytes(Vec<u8>),
    NotAFile,
    TooLarge,
}

fn read_at_most(path: &Path, max_bytes: u64) -> io::Result<FileContents> {
    if !fs::metadata(path)?.is_file() {
        return Ok(FileContents::NotAFile);
    }
    let mut bytes = vec![];
    File::open(path)?.take(max_bytes + 1).read_to_end(&mut bytes)?;
    let is_small = bytes.len() as u64 <= max_bytes;
    Ok(if is_small { FileContents::Bytes(bytes) } else { FileContents::TooLarge })
}

/// Escapes all characters that a terminal interprets, or that change the direction of writing.
pub fn escape_for_terminal(text: &str) -> String {
    let escape = |c: char| match is_terminal_control(c) {
        true => c.escape_default().to_string(),
        false => c.to_string(),
    };
    text.chars().map(escape).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_file_within_the_limit_is_read() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml");
        let length = fs::metadata(&file).expect("the file exists").len();
        let read =
            |path: &Path, max_bytes| read_at_most(path, max_bytes).expect("the path can be read");
        assert!(
            matches!(read(&file, length), FileContents::Bytes(bytes) if bytes.len() as u64 == length)
        );
        assert_eq!(read(&file, length - 1), FileContents::TooLarge);
        assert_eq!(
            read(file.parent().expect("the file is in a folder"), length),
            FileContents::NotAFile
        );
    }

    #[test]
    fn characters_that_a_terminal_interprets_are_escaped() {
        assert_eq!(escape_for_terminal("Zoë/a b.png"), "Zoë/a b.png");
        assert_eq!(escape_for_terminal("\u{1b}[2J\u{202e}\n"), "\\u{1b}[2J\\u{202e}\\n");
    }
}
